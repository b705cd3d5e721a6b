#include "tools/bench/report_bench.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/words/json_text.h"
#include "tools/words/number_text.h"
#include "tools/words/text_rows.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;
using Figure = std::function<std::string(const BenchRow&, const StageCost&)>;

constexpr double mebibyte = 1024.0 * 1024.0;
constexpr double least_seconds = 1e-3;      // of wall clock, for a rate
constexpr std::int64_t enough_loops = 100;  // that a hundredth of them means something

bool is_measured(const BenchRow& row) { return row.failure.empty(); }

std::string optional_text(const std::optional<double>& value, int decimals) {
  return value ? fixed_text(*value, decimals) : "-";
}

double bytes_per_voxel(const BenchRow& row, const StageCost& stage) {
  return static_cast<double>(stage.peak_bytes) / static_cast<double>(voxels_of(row.median));
}

std::optional<double> triangles_per_second(const BenchRow& row, const StageCost& stage) {
  if (stage.wall_seconds < least_seconds) return std::nullopt;
  return static_cast<double>(row.median.triangles) / stage.wall_seconds;
}

std::vector<MeasuredRun> measured(const BenchRun& run) {
  std::vector<MeasuredRun> runs;
  for (const BenchRow& row : run.rows)
    if (is_measured(row)) runs.push_back({row.volume, row.size, row.threads, &row.median});
  return runs;
}

// What the slowest hundredth of the loops has of the processor time of their stage.
std::string slowest_text(const Measurement& median) {
  const std::optional<StageCost> loops = stage_of(median, "loops");
  if (median.loops < enough_loops || !loops || loops->cpu_seconds <= 0.0) return "-";
  return fixed_text(100.0 * median.slowest_loops_seconds / loops->cpu_seconds, 0) + " %";
}

Words row_words(const BenchRow& row) {
  const std::string size = row.size > 0 ? std::to_string(row.size) : "-";
  Words words{row.volume, size, std::to_string(row.threads)};
  if (!is_measured(row)) {
    words.resize(11);
    words.push_back(row.failure);
    return words;
  }
  const Measurement& median = row.median;
  const StageCost& whole = median.whole;
  for (const std::string& word :
       {std::to_string(voxels_of(median)), std::to_string(median.triangles),
        std::to_string(median.genus), fixed_text(whole.cpu_seconds, 2),
        fixed_text(whole.wall_seconds, 2),
        fixed_text(static_cast<double>(whole.peak_bytes) / mebibyte, 0),
        fixed_text(bytes_per_voxel(row, whole), 1), slowest_text(median), std::string()})
    words.push_back(word);
  return words;
}

void write_runs(std::ostream& out, const BenchRun& run) {
  std::vector<Words> rows{{"volume", "size", "threads", "voxels", "triangles", "genus", "CPU s",
                           "wall s", "peak MiB", "bytes/voxel", "slowest 1 %", ""}};
  for (const BenchRow& row : run.rows) rows.push_back(row_words(row));
  std::vector<bool> flush_left(rows.front().size());
  flush_left.front() = flush_left.back() = true;
  write_rows(out, rows, flush_left);
  out << "slowest 1 %: what the slowest hundredth of the loops has of the CPU time of the stage "
         "loops\n";
}

// One row for each case, a column for each stage.
void write_stages(std::ostream& out, const BenchRun& run, const char* title, const Figure& figure) {
  const Words names = stage_names(measured(run));
  std::vector<Words> rows{{"volume", "size", "threads"}};
  rows.front().insert(rows.front().end(), names.begin(), names.end());
  for (const BenchRow& row : run.rows) {
    if (!is_measured(row)) continue;
    rows.push_back({row.volume, std::to_string(row.size), std::to_string(row.threads)});
    for (const std::string& name : names) {
      const std::optional<StageCost> stage = stage_of(row.median, name);
      rows.back().push_back(stage ? figure(row, *stage) : "-");
    }
  }
  std::vector<bool> flush_left(rows.front().size());
  flush_left.front() = true;
  out << '\n' << title << '\n';
  write_rows(out, rows, flush_left);
}

void append_stages(Words& words, const Words& names, const ByStage& figures) {
  for (const std::string& name : names) {
    const auto place = std::find_if(figures.begin(), figures.end(),
                                    [&name](const auto& one) { return one.first == name; });
    words.push_back(place == figures.end() ? "-" : optional_text(place->second, 2));
  }
}

void write_growth(std::ostream& out, const BenchRun& run) {
  if (run.growth.empty()) return;
  const Words names = stage_names(measured(run));
  std::vector<Words> rows{{"volume", "sizes", "threads"}};
  rows.front().insert(rows.front().end(), names.begin(), names.end());
  rows.front().insert(rows.front().end(), {"wall clock", "memory"});
  for (const Growth& growth : run.growth) {
    rows.push_back(
        {growth.volume,
         std::to_string(growth.least_size) + " to " + std::to_string(growth.largest_size),
         std::to_string(growth.threads)});
    append_stages(rows.back(), names, growth.cpu);
    rows.back().push_back(optional_text(growth.wall, 2));
    rows.back().push_back(optional_text(growth.peak, 2));
  }
  std::vector<bool> flush_left(rows.front().size());
  flush_left.front() = true;
  out << "\ngrowth: the exponent of CPU time, wall clock and memory over voxels (1: twice the "
         "voxels, twice the cost)\n";
  write_rows(out, rows, flush_left);
}

void write_efficiency(std::ostream& out, const BenchRun& run) {
  if (run.efficiency.empty()) return;
  const Words names = stage_names(measured(run));
  std::vector<Words> rows{{"volume", "size", "threads", "beside", "speedup"}};
  rows.front().insert(rows.front().end(), names.begin(), names.end());
  for (const Efficiency& one : run.efficiency) {
    rows.push_back({one.volume, std::to_string(one.size), std::to_string(one.threads),
                    std::to_string(one.least_threads), fixed_text(one.speedup, 2)});
    append_stages(rows.back(), names, one.efficiency);
  }
  std::vector<bool> flush_left(rows.front().size());
  flush_left.front() = true;
  out << "\nparallel efficiency: the speedup of the wall clock over that of the threads (1: twice "
         "the threads, half the time)\n";
  write_rows(out, rows, flush_left);
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted += '"';
}

void write_csv_line(std::ostream& out, const BenchRun& run, const BenchRow& row,
                    const StageCost& stage) {
  const Measurement& median = row.median;
  out << quoted(row.volume) << ',' << row.size << ',' << median.dims[0] << ',' << median.dims[1]
      << ',' << median.dims[2] << ',' << voxels_of(median) << ',' << median.triangles << ','
      << median.genus << ',' << median.loops << ',' << row.threads << ',' << run.repeat << ','
      << stage.name << ',' << shortest_text(stage.cpu_seconds) << ','
      << shortest_text(stage.wall_seconds) << ',' << stage.peak_bytes << ','
      << shortest_text(bytes_per_voxel(row, stage)) << ',';
  if (const auto rate = triangles_per_second(row, stage)) out << shortest_text(*rate);
  out << ',';
  if (stage.name == "all" || stage.name == "loops")
    out << shortest_text(median.slowest_loops_seconds);
  out << ",\n";
}

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json by_stage(const ByStage& figures) {
  Json json = Json::object();
  for (const auto& [name, value] : figures) json[name] = number_or_null(value);
  return json;
}

Json stage_json(const BenchRow& row, const StageCost& stage) {
  return {{"stage", stage.name},
          {"cpu_seconds", stage.cpu_seconds},
          {"wall_seconds", stage.wall_seconds},
          {"peak_bytes", stage.peak_bytes},
          {"bytes_per_voxel", bytes_per_voxel(row, stage)},
          {"triangles_per_second", number_or_null(triangles_per_second(row, stage))}};
}

Json row_json(const BenchRow& row) {
  Json json{{"volume", row.volume}, {"size", row.size}, {"threads", row.threads}};
  if (!is_measured(row)) {
    json["failure"] = row.failure;
    json["exit_code"] = row.exit_code;
    return json;
  }
  const Measurement& median = row.median;
  json["failure"] = nullptr;
  json["dims"] = median.dims;
  json["voxels"] = voxels_of(median);
  json["triangles"] = median.triangles;
  json["genus"] = median.genus;
  json["loops"] = median.loops;
  json["slowest_loops_seconds"] = median.slowest_loops_seconds;
  json["stages"] = {stage_json(row, median.whole)};
  for (const StageCost& stage : median.stages) json["stages"].push_back(stage_json(row, stage));
  return json;
}

Json growth_json(const Growth& growth) {
  return {{"volume", growth.volume},
          {"sizes", {growth.least_size, growth.largest_size}},
          {"threads", growth.threads},
          {"cpu_seconds", by_stage(growth.cpu)},
          {"wall_seconds", number_or_null(growth.wall)},
          {"peak_bytes", number_or_null(growth.peak)}};
}

Json efficiency_json(const Efficiency& one) {
  return {{"volume", one.volume},   {"size", one.size},
          {"threads", one.threads}, {"least_threads", one.least_threads},
          {"speedup", one.speedup}, {"efficiency", by_stage(one.efficiency)}};
}

Json machine_json(const Machine& machine) {
  return {{"processor", machine.processor},       {"cores", machine.cores},
          {"memory_bytes", machine.memory_bytes}, {"system", machine.system},
          {"compiler", machine.compiler},         {"version", machine.version}};
}

}  // namespace

void write_bench_table(std::ostream& out, const BenchRun& run) {
  out << machine_text(run.machine) << '\n'
      << (run.repeat > 1 ? "medians of " + std::to_string(run.repeat) + " runs" : "one run of each")
      << ", each in a process of its own; from reading to loops that are proved\n\n";
  write_runs(out, run);
  write_stages(out, run, "CPU seconds of each stage",
               [](const BenchRow&, const StageCost& s) { return fixed_text(s.cpu_seconds, 2); });
  write_stages(out, run, "peak MiB within each stage", [](const BenchRow&, const StageCost& s) {
    return fixed_text(static_cast<double>(s.peak_bytes) / mebibyte, 0);
  });
  write_stages(out, run, "thousands of triangles a second of wall clock",
               [](const BenchRow& row, const StageCost& s) {
                 const std::optional<double> rate = triangles_per_second(row, s);
                 return rate ? fixed_text(*rate / 1000.0, 0) : "-";
               });
  write_growth(out, run);
  write_efficiency(out, run);
}

void write_bench_csv(std::ostream& out, const BenchRun& run) {
  out << "volume,size,dims_x,dims_y,dims_z,voxels,triangles,genus,loops,threads,repeat,stage,"
         "cpu_seconds,wall_seconds,peak_bytes,bytes_per_voxel,triangles_per_second,"
         "slowest_loops_seconds,failure\n";
  for (const BenchRow& row : run.rows) {
    if (!is_measured(row)) {
      out << quoted(row.volume) << ',' << row.size << ",,,,,,,," << row.threads << ',' << run.repeat
          << ",all,,,,,,," << quoted(row.failure) << '\n';
      continue;
    }
    write_csv_line(out, run, row, row.median.whole);
    for (const StageCost& stage : row.median.stages) write_csv_line(out, run, row, stage);
  }
}

void write_bench_json(std::ostream& out, const BenchRun& run) {
  out << "{\n  \"schema\": \"isoloop-bench/1\",\n  \"machine\": "
      << line_of(machine_json(run.machine)) << ",\n  \"repeat\": " << run.repeat;
  write_list(out, "runs", run.rows, row_json);
  write_list(out, "growth", run.growth, growth_json);
  write_list(out, "efficiency", run.efficiency, efficiency_json);
  out << ",\n  \"seconds\": " << Json{{"total", run.cost.total_seconds}}.dump() << "\n}\n";
}

}  // namespace isoloop
