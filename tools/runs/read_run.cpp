#include "tools/runs/read_run.h"

#include <algorithm>
#include <chrono>
#include <iostream>

#include "core/base/stage.h"
#include "tools/flags/flag_kinds.h"
#include "tools/flags/length_flag.h"
#include "tools/runs/auto_iso.h"
#include "tools/runs/frowns.h"
#include "tools/runs/memory_cap.h"
#include "tools/words/sentence.h"
#include "tools/words/value_hints.h"
#include "volume/base/memory_limit.h"
#include "volume/mesh/mesh.h"
#include "volume/voxels/value_range.h"

namespace isoloop {

namespace {

/// What the flags say; with --iso auto what the voxels suggest, and `run` says so.
IsoLevel level_of(LevelFlags flags, RunInput& run) {
  if (flags.iso != "auto") return iso_level(flags, run.volume, run.range);
  flags.iso.clear();
  flags.iso_is_open = true;
  run.level = iso_level(flags, run.volume, run.range);
  const ChosenIso chosen = choose_iso(run);
  run.iso_choice = chosen.how;
  run.level.iso = chosen.iso;
  return run.level;
}

/// That which --spacing states.
void take_unit(const VolumeFlags& flags, Volume& volume) {
  if (const std::string unit = split_unit("--spacing", flags.spacing).unit; !unit.empty())
    volume.unit = unit;
}

}  // namespace

Volume read_named(const VolumeFlags& flags, const ReadOptions& options, const StagedFile& staged) {
  if (!staged) return read_volume(flags.file, options);
  const auto named = [&](Finding finding) {
    if (finding.file == staged->string()) finding.file = flags.file;
    return finding;
  };
  try {
    return read_volume(*staged, options);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(named(error.finding), error.option);
  } catch (const InvalidInput& error) {
    throw InvalidInput(named(error.finding), error.fault);
  } catch (const LimitExceeded& error) {
    throw LimitExceeded(named(error.finding), error.excess);
  }
}

void settle_level(RunInput& run, const LevelFlags& flags, bool is_mask_of_labels) {
  run.range = value_range(voxels_of(run));
  run.level = level_of(flags, run);
  if (is_mask(run.range) && !run.volume.level_set && !is_mask_of_labels &&
      flags.connectivity.empty()) {
    run.hint = mask_hint(run.range);
  }
}

Volume read_flagged(const VolumeFlags& flags, VdbMargin margin) {
  check_flags_fit_file(flags);
  ReadOptions options = read_options(flags);
  options.margin = margin;
  Volume volume = about_file(flags.file, [&] {
    return in_stage("read", [&] { return read_volume(flags.file, options); });
  });
  take_unit(flags, volume);
  return volume;
}

RunInput read_input(const VolumeFlags& flags, VdbMargin margin) {
  const auto start = std::chrono::steady_clock::now();
  RunInput run;
  run.file = flags.file;
  run.nan_as = flags.nan_as;
  check_flags_fit_file(flags);
  ReadOptions options = read_options(flags);
  options.margin = margin;
  run.staged = staged_input(flags);
  const std::uint64_t available = default_voxel_limit();
  if (options.max_bytes > 0) cap_memory(options.max_bytes);
  run.volume = about_file(run.file, [&] {
    return in_stage("read", [&] { return read_named(flags, options, run.staged); });
  });
  const std::uint64_t limit = options.max_bytes > 0 ? options.max_bytes : available;
  run.cost.max_bytes = limit - std::min(limit, resident_bytes());
  take_unit(flags, run.volume);
  run.cost.read_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

RunInput read_run(const VolumeFlags& volume_flags, const LevelFlags& level_flags) {
  const auto start = std::chrono::steady_clock::now();
  check_flags_agree(volume_flags, level_flags);
  // A layer of background would close the surface that is to end there.
  RunInput run =
      read_input(volume_flags, level_flags.open_boundary ? VdbMargin::none : VdbMargin::background);
  settle_level(run, level_flags, !volume_flags.label.empty());
  if (volume_flags.label.empty()) {
    const std::string labels =
        label_warning(run, !level_flags.iso.empty() && run.iso_choice.empty());
    if (!labels.empty()) add_warning(run, labels);
  }
  tell_warnings(std::cerr, run);
  run.cost.read_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

LimitExceeded advised_for(const std::string& file, const LimitExceeded& error) {
  if (!is_mesh(file)) return error;
  Finding finding = error.finding;
  std::replace(finding.advice.begin(), finding.advice.end(), Advice::take_part,
               Advice::take_larger_voxels);
  std::erase(finding.advice, Advice::halve_resolution);
  return LimitExceeded(finding, error.excess);
}

}  // namespace isoloop
