#include "python/module/runs.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "core/base/errors.h"
#include "core/base/threads.h"
#include "python/module/input.h"
#include "python/module/watched.h"
#include "tools/flags/repair_flags.h"
#include "tools/page/page.h"
#include "tools/runs/count_run.h"
#include "tools/runs/loops_run.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/runs/read_run.h"
#include "tools/runs/repair_run.h"
#include "tools/runs/scan_run.h"
#include "volume/base/memory_limit.h"

namespace isoloop::python {
namespace {

namespace py = pybind11;

/// Returns work(). What is wrong with a voxel is told in the array's axes.
template <class Work>
auto in_array(const Axes& axes, const Work& work) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    Finding finding = error.finding;
    finding.place = place_in_array(axes, finding.place);
    throw InvalidInput(finding, error.fault);
  }
}

/// How much a run may take.
struct Limits {
  int threads = 0;              // at most; 0: one for each core
  std::uint64_t max_bytes = 0;  // beside the array; 0: 80 % of what is available
};

/// A run of `work`, from the input with its level settled to a result in the array's axes.
template <class Work>
auto run_on(const Input& input, const LevelFlags& level, const Limits& limits,
            const py::object& progress, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  const auto all = [given = input.run, axes = input.axes, of_labels = input.of_labels, level,
                    limits, work, start](const Progress& tell) {
    return in_array(axes, [&] {
      RunInput run = given;
      run.cost.max_bytes = limits.max_bytes > 0 ? limits.max_bytes : default_voxel_limit();
      settle_level(run, level, of_labels);
      auto result = on_threads(limits.threads, [&] { return work(std::move(run), tell); });
      result.voxels.reset();  // they are the caller's
      result.cost.peak_bytes = peak_resident_bytes();
      result.cost.total_seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      return std::make_shared<decltype(result)>(std::move(result));
    });
  };
  return watched(progress, input.holder, all);
}

std::shared_ptr<CountRun> count(const Input& input, const LevelFlags& level, const Limits& limits,
                                const py::object& progress) {
  return run_on(
      input, level, limits, progress,
      [axes = input.axes, boundary = boundary_of(level)](RunInput run, const Progress& tell) {
        CountRun counted = counted_run(std::move(run), boundary, tell);
        compare_with_mesh(counted, counted.analysis);
        turn_to_array(axes, counted);
        return counted;
      });
}

std::shared_ptr<LoopsRun> loops(const Input& input, const LoopsInput& asked, const Limits& limits,
                                const py::object& progress) {
  check_engine_flags(asked);
  return run_on(input, asked.level, limits, progress,
                [axes = input.axes, asked](RunInput run, const Progress& tell) {
                  LoopsRun found = find_in(std::move(run), asked, tell);
                  found.with_features = asked.features && !asked.features_may_lack;
                  compare_with_mesh(found, found.analysis);
                  found.analysis.surface.graph = {};  // what follows asks for the mesh alone
                  turn_to_array(axes, found);
                  return found;
                });
}

std::shared_ptr<ScanRun> scan(const Input& input, const LevelFlags& level, const ScanRange& range,
                              const std::string& ignore_below, const Limits& limits,
                              const py::object& progress) {
  LevelFlags without_iso = level;
  without_iso.iso_is_open = true;
  return run_on(
      input, without_iso, limits, progress,
      [range, ignored = parse_ignored_size(ignore_below)](RunInput run, const Progress& tell) {
        ScanRun scanned{std::move(run)};
        const auto isos = scan_values(range, voxels_of(scanned), scanned.range);
        scanned.scan = scan_of(scanned, isos, tell, ignored);
        return scanned;
      });
}

std::shared_ptr<RepairRun> repair(const Input& input, const LevelFlags& level,
                                  const RepairFlags& asked, const Limits& limits,
                                  const py::object& progress) {
  return run_on(input, level, limits, progress,
                [axes = input.axes, boundary = boundary_of(level), request = repair_request(asked)](
                    RunInput run, const Progress& tell) {
                  RepairRun repaired = repaired_run(std::move(run), boundary, request, tell);
                  compare_with_mesh(repaired, repaired.repair.before);
                  turn_to_array(axes, repaired);
                  return repaired;
                });
}

/// `drawn`: the array's voxels, its first axis the fastest, for slices.
py::str page(const std::shared_ptr<LoopsRun>& run, const Input& drawn, std::size_t triangles) {
  const auto written = [run, voxels = drawn.run.voxels, triangles](const Progress&) {
    run->voxels = voxels;
    std::ostringstream out;
    write_page(out, *run, {.most_triangles = triangles});
    run->voxels.reset();
    return std::move(out).str();
  };
  return watched(py::none(), drawn.holder, written);
}

}  // namespace

void bind_runs(py::module_& module) {
  py::class_<Limits>(module, "Limits")
      .def(py::init([](int threads, std::uint64_t max_bytes) {
             return Limits{threads, max_bytes};
           }),
           py::arg("threads"), py::arg("max_bytes"));
  module.def("count", &count, py::arg("input"), py::arg("level"), py::arg("limits"),
             py::arg("progress"));
  module.def("loops", &loops, py::arg("input"), py::arg("asked"), py::arg("limits"),
             py::arg("progress"));
  module.def("scan", &scan, py::arg("input"), py::arg("level"), py::arg("range"),
             py::arg("ignore_below"), py::arg("limits"), py::arg("progress"));
  module.def("repair", &repair, py::arg("input"), py::arg("level"), py::arg("asked"),
             py::arg("limits"), py::arg("progress"));
  module.def("page", &page, py::arg("run"), py::arg("drawn"), py::arg("triangles"));
}

}  // namespace isoloop::python
