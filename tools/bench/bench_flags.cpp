#include "tools/bench/bench_flags.h"

#include <algorithm>
#include <array>
#include <optional>

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "tools/flags/engine_flags.h"
#include "tools/flags/flag_lists.h"
#include "tools/words/flag_checks.h"

namespace isoloop {
namespace {

constexpr const char* few_shapes = "torus,trefoil,plate,lattice,gyroid";
constexpr const char* of_a_file = "Of a file";
constexpr const char* of_all = "Of every run";
constexpr int most_threads = 1024;  // as of --threads elsewhere

std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

/// The flags of a group that were given, as they were given.
std::vector<std::string> given(const CLI::App& command, std::string_view group) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options())
    if (option->get_group() == group && option->count() > 0)
      for (const std::string& value : option->results())
        words.push_back(option->get_name() + "=" + value);
  return words;
}

void append(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

std::vector<std::int64_t> parse_sizes(const std::string& text) {
  const std::string complaint = "--sizes wants whole numbers, as 64,128,256, not '" + text + "'";
  std::vector<std::int64_t> sizes = parse_list<std::int64_t>(text, ",", complaint);
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  if (sizes.front() < 1) throw InvalidArgument(complaint);
  return sizes;
}

/// Each shape once, at each size.
std::vector<BenchCase> shape_cases(const BenchFlags& flags, const std::vector<std::string>& words) {
  std::vector<BenchCase> cases;
  std::vector<std::string> before;
  for (const std::string& shape : words_in(flags.shapes.empty() ? few_shapes : flags.shapes)) {
    parse_shape(shape);  // an unknown one is refused before anything runs
    if (std::find(before.begin(), before.end(), shape) != before.end()) continue;
    before.push_back(shape);
    for (const std::int64_t size : parse_sizes(flags.sizes)) {
      cases.push_back({shape, size, {"measure", "--shape=" + shape}});
      append(cases.back().arguments, {"--size=" + std::to_string(size)});
      append(cases.back().arguments, words);
    }
  }
  return cases;
}

}  // namespace

void add_measured_flags(CLI::App& command, LoopsInput& input) {
  const std::vector<const CLI::Option*> before = std::as_const(command).get_options();
  add_named_volume_flags(command, input.volume);
  add_level_flags(command, input.level);
  for (CLI::Option* option : command.get_options())
    if (std::find(before.begin(), before.end(), option) == before.end()) option->group(of_a_file);
  add_geodesic_flag(command, input.geodesic);
  add_method_flags(command, input.engine);
  for (const char* flag : {"--geodesic", "--engine", "--refine", "--tighten", "--complex",
                           "--grading", "--max-memory"})
    command.get_option(flag)->group(of_all);
}

void add_bench_flags(CLI::App& command, BenchFlags& flags) {
  want_text(command
                .add_option("--shapes", flags.shapes,
                            "built-in shapes, as of `generate`: lattice:7 has 7 cells along each "
                            "axis, plate:12 has 12 holes (default " +
                                std::string(few_shapes) + ", but none with --file)")
                ->type_name("NAME[:N],..."));
  want_text(command.add_option("--sizes", flags.sizes, "voxels along the longest axis of a shape")
                ->type_name("N,...")
                ->capture_default_str());
  want_text(
      command
          .add_option("--threads", flags.threads,
                      "numbers of threads, each of which every case is run on; all is one for "
                      "each core")
          ->type_name("N,...")
          ->capture_default_str());
  want_whole_number(
      command.add_option("--repeat", flags.repeat, "runs of each, of which medians are reported")
          ->type_name("N")
          ->capture_default_str(),
      1, 1000);
  want_positive_number(
      command
          .add_option("--max-seconds", flags.max_seconds,
                      "end a run that takes longer, which is then reported as not done")
          ->type_name("SECONDS"));
  add_measured_flags(command, flags.input);
}

NamedShape parse_shape(std::string_view text) {
  const std::size_t colon = text.find(':');
  NamedShape shape{.name = std::string(text.substr(0, colon))};
  if (colon != std::string_view::npos) {
    const std::optional<int> number = parse_number<int>(text.substr(colon + 1));
    if (!number || (shape.name != "lattice" && shape.name != "plate"))
      throw InvalidArgument("'" + std::string(text) +
                            "' is no shape: a number goes with lattice (its cells) and plate (its "
                            "holes) alone, as in lattice:7");
    (shape.name == "lattice" ? shape.options.cells : shape.options.holes) = *number;
  }
  minimum_shape_size(shape.name, shape.options);  // throws for what is no shape
  return shape;
}

std::vector<int> parse_threads(std::string_view text, int cores) {
  std::vector<int> threads;
  for (const std::string& word : words_in(text)) {
    const std::optional<int> number = word == "all" ? cores : parse_number<int>(word);
    if (!number || *number < 1 || *number > most_threads)
      throw InvalidArgument(
          "--threads wants whole numbers from 1 to 1024 or all, as 1,2,all, not '" +
          std::string(text) + "'");
    threads.push_back(*number);
  }
  std::sort(threads.begin(), threads.end());
  threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
  return threads;
}

BenchPlan plan_of(const BenchFlags& flags, const CLI::App& command, int cores) {
  check_engine_flags(flags.input);
  BenchPlan plan{.threads = parse_threads(flags.threads, cores),
                 .repeat = flags.repeat,
                 .max_seconds = flags.max_seconds};
  const std::vector<std::string> file_words = given(command, of_a_file);
  const std::vector<std::string> words = given(command, of_all);
  const bool has_file = !flags.input.volume.file.empty();
  if (!has_file && !file_words.empty()) {
    const std::string& word = file_words.front();
    throw InvalidArgument(word.substr(0, word.find('=')) + " means nothing without --file");
  }
  if (has_file && flags.shapes.empty() && command.get_option("--sizes")->count() > 0)
    throw InvalidArgument("--sizes is of shapes (--shapes): a file is measured as it is");
  if (!flags.shapes.empty() || !has_file) plan.cases = shape_cases(flags, words);
  if (has_file) {
    plan.cases.push_back({flags.input.volume.file, 0, {"measure"}});
    append(plan.cases.back().arguments, file_words);
    append(plan.cases.back().arguments, words);
  }
  return plan;
}

}  // namespace isoloop
