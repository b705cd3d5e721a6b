#include "volume/slices/slice_folder.h"

#include <algorithm>
#include <map>
#include <vector>

#include "core/base/errors.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/slices/slice_file.h"
#include "volume/slices/slice_log.h"
#include "volume/slices/slice_names.h"
#include "volume/slices/tiff.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

using Paths = std::vector<std::filesystem::path>;

Paths entries_of(const std::filesystem::path& folder) {
  Paths entries;
  std::error_code error;
  std::filesystem::directory_iterator at(folder, error);
  for (; !error && at != std::filesystem::directory_iterator(); at.increment(error)) {
    entries.push_back(at->path());
  }
  if (error) refuse(folder.string(), "cannot be read: " + error.message(), Fault::unreadable);
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return name_less(a.filename().string(), b.filename().string());
  });
  return entries;
}

bool is_folder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

/// The kinds of these files and folders, each with how many there are.
std::string kinds_text(const Paths& paths) {
  std::map<std::string, Paths> kinds;
  for (const auto& path : paths) {
    const std::string extension = lower_case(path.extension().string());
    kinds[is_folder(path)     ? "/"
          : extension.empty() ? path.filename().string()
                              : extension]
        .push_back(path);
  }
  constexpr std::size_t most = 8;
  std::string text;
  std::size_t told = 0;
  for (const auto& [kind, members] : kinds) {
    const std::string count = std::to_string(members.size());
    const bool one = members.size() == 1;
    text += text.empty() ? "" : ", ";
    if (told++ == most) return text + "and more";
    text += kind == "/" ? count + (one ? " folder" : " folders")
            : one       ? members.front().filename().string()
                        : count + " " + kind + " files";
  }
  return text;
}

/// What a folder of slices holds.
struct Folder {
  Paths slices{};  // in order
  Paths logs{};
  Paths others{};
};

/// Scanners put a picture of their settings beside the slices, NAME_spr.bmp.
bool is_preview(const std::filesystem::path& path) {
  return lower_case(path.stem().string()).ends_with("_spr");
}

/// The slices, all of one format. Throws InvalidInput.
Paths of_one_format(const Paths& candidates, const std::string& what) {
  const auto first = slice_kind(candidates.front());
  const bool alike = std::all_of(candidates.begin(), candidates.end(),
                                 [&](const auto& path) { return slice_kind(path) == first; });
  if (alike) return candidates;
  refuse(what,
         "holds slices of several formats (" + kinds_text(candidates) +
             "); put those of one volume in a folder of their own",
         Fault::unsupported);
}

Folder sorted_folder(const std::filesystem::path& path) {
  Folder folder;
  Paths previews;
  for (const auto& entry : entries_of(path)) {
    if (is_folder(entry)) {
      folder.others.push_back(entry);
    } else if (slice_kind(entry)) {
      (is_preview(entry) ? previews : folder.slices).push_back(entry);
    } else if (lower_case(entry.extension().string()) == ".log") {
      folder.logs.push_back(entry);
    } else {
      folder.others.push_back(entry);
    }
  }
  const bool are_slices = folder.slices.empty();
  Paths& place = are_slices ? folder.slices : folder.others;
  place.insert(place.end(), previews.begin(), previews.end());
  if (folder.slices.empty()) refuse(path.string(), "holds no .tif, .tiff, .png or .bmp files");
  folder.slices = of_one_format(folder.slices, path.string());
  return folder;
}

/// The image that all slices share, told before any is decoded.
SliceImage common_image(const Paths& slices) {
  const SliceImage first = slice_image(slices.front());
  for (const auto& slice : slices) {
    const SliceImage image = slice_image(slice);
    if (image == first) continue;
    refuse(slice.string(), "is " + slice_text(image) + ", but " +
                               slices.front().filename().string() + " is " + slice_text(first) +
                               "; slices of one volume are alike: move away what does not belong");
  }
  return first;
}

void refuse_choice(const std::optional<std::int64_t>& chosen, Option option,
                   const std::string& what) {
  if (!chosen || *chosen == 0) return;
  throw InvalidArgument(
      {.file = what,
       .about = option,
       .text = "can be 0 alone for a folder of single slices: it counts volumes within one file"});
}

/// The log that is used leaves the folder's list.
void place_by_log(Volume& volume, Folder& folder, const FormatOptions& options,
                  const std::string& what) {
  std::optional<Finding> warning;
  const auto log = options.spacing ? std::nullopt : read_slice_logs(folder.logs, warning);
  if (warning) volume.warnings.push_back(*warning);
  Placement placement;
  if (log) placement.columns = columns_of(log->spacing, what);
  place(volume, placement, options.spacing, what);
  if (log) {
    volume.unit = "µm";
    std::erase(folder.logs, log->file);
    volume.notes.push_back({.text = "spacing as " + log->file.filename().string() + " states"});
  } else if (!options.spacing) {
    volume.notes.push_back({.text = "the slices do not state a spacing: 1 is taken",
                            .advice = {Advice::override_spacing}});
  }
}

void note_names(Volume& volume, const Folder& folder, const std::string& what) {
  std::vector<std::string> names;
  names.reserve(folder.slices.size());
  for (const auto& slice : folder.slices) names.push_back(slice.filename().string());
  if (const auto warning = odd_names(names, what)) volume.warnings.push_back({.text = *warning});
  volume.notes.push_back({.text = std::to_string(names.size()) + " slices, from " + names.front() +
                                  " to " + names.back()});
  Paths others = folder.others;
  others.insert(others.end(), folder.logs.begin(), folder.logs.end());
  if (others.empty()) return;
  volume.warnings.push_back(
      {.file = what, .text = "what is no slice is passed over: " + kinds_text(others)});
}

}  // namespace

Volume read_slice_folder(const std::filesystem::path& path, const FormatOptions& options,
                         const VoxelLimits& limits) {
  const std::string what = path.string();
  Folder folder = sorted_folder(path);
  if (folder.slices.size() == 1 && slice_kind(folder.slices.front()) == FileKind::tiff) {
    return read_tiff(folder.slices.front(), options, limits);
  }
  refuse_choice(options.frame, Option::frame, what);
  refuse_choice(options.channel, Option::channel, what);
  Volume volume;
  const SliceImage image = common_image(folder.slices);
  const std::uint64_t bytes = slice_bytes(image, what);
  volume.dims = {image.width, image.height, static_cast<std::int64_t>(folder.slices.size())};
  check_voxel_memory(volume.dims, bytes_per_voxel(image.type), limits, what);
  place_by_log(volume, folder, options, what);
  note_names(volume, folder, what);
  volume.values =
      zero_voxels(image.type, static_cast<std::size_t>(checked_voxel_count(volume.dims, what)));
  std::visit(
      [&](auto& voxels) {
        const auto all = std::as_writable_bytes(std::span(voxels));
        for (std::size_t z = 0; z < folder.slices.size(); ++z) {
          read_slice(folder.slices[z], limits, all.subspan(z * bytes, bytes));
        }
      },
      volume.values);
  return volume;
}

bool holds_slices(const std::filesystem::path& folder) {
  const Paths entries = entries_of(folder);
  return std::any_of(entries.begin(), entries.end(), [](const auto& entry) {
    return slice_kind(entry).has_value() && !is_folder(entry);
  });
}

std::string folder_contents(const std::filesystem::path& folder) {
  const Paths entries = entries_of(folder);
  return entries.empty() ? "nothing" : kinds_text(entries);
}

}  // namespace isoloop
