#include "python/module/results.h"

#include <array>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "core/base/errors.h"
#include "python/module/input.h"
#include "tools/reports/report_csv.h"
#include "tools/reports/report_curves.h"
#include "tools/reports/report_features.h"
#include "tools/reports/report_json.h"
#include "tools/reports/report_mesh.h"
#include "tools/reports/report_repair.h"
#include "tools/reports/report_scan.h"
#include "tools/reports/report_summary.h"
#include "tools/reports/report_surface.h"
#include "tools/reports/report_table.h"
#include "tools/reports/scan_plot.h"
#include "tools/runs/repair_run.h"
#include "tools/words/sentence.h"
#include "volume/base/atomic_file.h"

namespace isoloop::python {
namespace {

namespace py = pybind11;

/// A method that returns what `write` writes of a run.
template <class Run>
auto text_by(void (*write)(std::ostream&, const Run&)) {
  return [write](const Run& run) {
    std::ostringstream out;
    write(out, run);
    const std::string text = std::move(out).str();
    // A file's name may hold what is no UTF-8.
    return py::reinterpret_steal<py::str>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace"));
  };
}

/// Rows of three numbers as an array (n, 3): a view, read-only, which keeps `self` alive.
template <class T>
py::array rows_of(const py::object& self, const std::vector<std::array<T, 3>>& rows) {
  static_assert(sizeof(std::array<T, 3>) == 3 * sizeof(T));
  const T* const first = rows.empty() ? nullptr : rows[0].data();
  py::array_t<T> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}}, first, self);
  if (!rows.empty()) array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class T, class Items, class Get>
py::array_t<T> column_of(const Items& items, const Get& get) {
  py::array_t<T> column(static_cast<py::ssize_t>(items.size()));
  T* to = column.mutable_data();
  for (const auto& item : items) *to++ = get(item);
  return column;
}

template <class Items, class Get>
py::array_t<double> points_column(const Items& items, const Get& get) {
  py::array_t<double> column({static_cast<py::ssize_t>(items.size()), py::ssize_t{3}});
  double* to = column.mutable_data();
  for (const auto& item : items)
    for (const double x : Vec3(get(item))) *to++ = x;
  return column;
}

py::tuple betti_of(const Analysis& analysis) {
  return py::make_tuple(analysis.betti.b0, analysis.betti.b1, analysis.betti.b2);
}

py::list components_of(const Analysis& analysis) {
  py::list components;
  for (const SurfaceComponent& part : analysis.surface.components) {
    py::dict row;
    row["vertices"] = part.vertices;
    row["triangles"] = part.triangles;
    row["euler"] = part.euler;
    row["genus"] = part.genus;
    row["bounds"] = bounds_text(analysis.surface.boundary, part);
    row["borders"] = part.borders;
    components.append(row);
  }
  return components;
}

py::dict counts_of(const Analysis& analysis) {
  py::dict counts;
  counts["betti"] = betti_of(analysis);
  counts["vertices"] = analysis.surface.points.size();
  counts["triangles"] = analysis.surface.triangles.size();
  counts["euler"] = analysis.surface.euler();
  counts["genus"] = analysis.surface.genus();
  counts["components"] = components_of(analysis);
  return counts;
}

/// The points of all curves one after another, in voxel indices; the curves that each loop has, and
/// the points that each curve has.
py::tuple curves_of(const LoopsRun& run) {
  std::vector<Vec3> points;
  std::vector<std::int64_t> points_of_curve;
  std::vector<std::int64_t> curves_of_loop;
  for (const Loop& loop : run.reported) {
    const auto curves = drawn_curves(run.analysis.surface, loop);
    curves_of_loop.push_back(static_cast<std::int64_t>(curves.size()));
    for (const std::vector<Vec3>& curve : curves) {
      points_of_curve.push_back(static_cast<std::int64_t>(curve.size()));
      points.insert(points.end(), curve.begin(), curve.end());
    }
  }
  const auto same = [](const auto& item) { return item; };
  return py::make_tuple(points_column(points, same), column_of<std::int64_t>(points_of_curve, same),
                        column_of<std::int64_t>(curves_of_loop, same));
}

/// One column for each measure of the reported loops.
py::dict loop_columns(const LoopsRun& run) {
  const std::vector<Loop>& loops = run.reported;
  py::dict columns;
  py::list kinds;
  py::list fixes;
  for (const Loop& loop : loops) {
    kinds.append(kind_text(loop.kind));
    fixes.append(fix_text(loop.kind));
  }
  columns["kind"] = kinds;
  columns["fix"] = fixes;
  columns["id"] = column_of<std::int64_t>(loops, [](const Loop& l) { return l.id; });
  columns["length"] = column_of<double>(loops, [](const Loop& l) { return l.length; });
  columns["found_length"] = column_of<double>(loops, [](const Loop& l) { return l.found_length; });
  columns["size"] = column_of<double>(loops, [](const Loop& l) { return l.size; });
  columns["component"] = column_of<std::int64_t>(loops, [](const Loop& l) { return l.component; });
  columns["center_index"] = points_column(loops, [](const Loop& l) { return l.center_index; });
  columns["certificate"] = column_of<std::uint8_t>(loops, [](const Loop& l) {
    const LoopCertificate& c = l.certificate;
    return static_cast<std::uint8_t>((c.trivial_inside ? 1 : 0) | (c.trivial_outside ? 2 : 0));
  });
  return columns;
}

/// One column for each measure of the features of the reported loops, if there are any.
py::dict feature_columns(const LoopsRun& run) {
  std::vector<const Feature*> features;
  std::vector<std::size_t> labels;
  py::list vertices;
  for (const Loop& loop : run.reported) {
    if (run.features.empty()) break;
    const std::size_t place = place_of(run, loop);
    features.push_back(&run.features[place]);
    labels.push_back(place + 1);
    vertices.append(
        column_of<std::uint32_t>(run.features[place].vertices, [](auto vertex) { return vertex; }));
  }
  const auto column = [&](auto get) {
    return column_of<double>(features, [&](const Feature* f) { return get(*f); });
  };
  py::dict columns;
  columns["label"] =
      column_of<std::int64_t>(labels, [](std::size_t l) { return static_cast<std::int64_t>(l); });
  columns["area"] = column([](const Feature& f) { return f.area; });
  columns["depth"] = column([](const Feature& f) { return f.depth; });
  columns["thickness"] = column([](const Feature& f) { return f.thickness(); });
  columns["least_girth"] = column([](const Feature& f) { return f.least_girth; });
  columns["mean_girth"] = column([](const Feature& f) { return f.mean_girth; });
  columns["axis"] = points_column(features, [&](const Feature* f) { return world_axis(run, *f); });
  columns["vertices"] = vertices;
  return columns;
}

void write_file(const LoopsRun& run, const std::string& path) {
  const auto ends = [&](const char* end) { return path.ends_with(end); };
  AtomicFile file(path);
  if (ends(".json") && !ends(".mrk.json")) {
    write_json(file.stream(), run);
  } else if (ends(".csv")) {
    write_csv(file.stream(), run);
  } else {
    write_ply(file.stream(), run);
  }
  file.commit();
}

void write_by(const LoopsReport& report, const LoopsRun& run, const std::string& path) {
  AtomicFile file(path);
  report(file.stream(), run);
  file.commit();
}

py::list removals_of(const RepairRun& run) {
  py::list rows;
  for (const Removal& removal : run.repair.removals) {
    py::dict row;
    row["kind"] = kind_text(removal.loop.kind);
    row["id"] = removal.loop.id;
    row["round"] = removal.round;
    row["length"] = removal.length;
    row["action"] = removal.action == RepairAction::cut ? "cut" : "fill";
    row["along"] = py::make_tuple(kind_text(removal.by.kind), removal.by.id);
    row["voxels"] = removal.voxels;
    row["center_index"] = py::array_t<double>(3, removal.center_index.data());
    rows.append(row);
  }
  return rows;
}

py::list kept_of(const RepairRun& run) {
  py::list rows;
  for (const KeptLoop& kept : run.repair.kept) {
    py::dict row;
    row["kind"] = kind_text(kept.loop.kind);
    row["id"] = kept.loop.id;
    row["round"] = kept.round;
    row["length"] = kept.length;
    row["center_index"] = py::array_t<double>(3, kept.center_index.data());
    rows.append(row);
  }
  return rows;
}

/// Numbers of voxels in memory, and what they become.
py::tuple changes_of(const RepairRun& run) {
  const std::vector<VoxelChange>& changes = run.repair.changes;
  return py::make_tuple(
      column_of<std::int64_t>(
          changes, [](const VoxelChange& c) { return static_cast<std::int64_t>(c.voxel); }),
      column_of<double>(changes, [](const VoxelChange& c) { return c.after; }));
}

/// The same of the label map that the mask was made of, and how many others were overwritten.
py::tuple label_changes_of(const RepairRun& run, const Input& labels,
                           const std::vector<std::int64_t>& asked) {
  const LabelChanges made = changes_of_labels(run.repair, *labels.run.voxels, asked);
  return py::make_tuple(
      column_of<std::int64_t>(
          made.changes, [](const VoxelChange& c) { return static_cast<std::int64_t>(c.voxel); }),
      column_of<double>(made.changes, [](const VoxelChange& c) { return c.after; }),
      made.overwritten);
}

py::dict scan_columns(const ScanRun& run) {
  const auto column = [&](auto get) {
    return column_of<std::int64_t>(run.scan.rows, [&](const ScanRow& row) { return get(row); });
  };
  py::dict columns;
  columns["iso"] = column_of<double>(run.scan.rows, [](const ScanRow& row) { return row.iso; });
  columns["b0"] = column([](const ScanRow& row) { return row.betti.b0; });
  columns["b1"] = column([](const ScanRow& row) { return row.betti.b1; });
  columns["b2"] = column([](const ScanRow& row) { return row.betti.b2; });
  columns["euler"] = column([](const ScanRow& row) { return row.euler; });
  columns["genus"] = column([](const ScanRow& row) { return row.genus; });
  columns["inside_voxels"] = column([](const ScanRow& row) { return row.inside_voxels; });
  columns["large_b0"] = column([](const ScanRow& row) { return row.large.b0; });
  columns["large_b1"] = column([](const ScanRow& row) { return row.large.b1; });
  columns["large_b2"] = column([](const ScanRow& row) { return row.large.b2; });
  return columns;
}

py::list plateaus_of(const ScanRun& run) {
  py::list rows;
  for (const Plateau& plateau : run.scan.plateaus)
    rows.append(py::make_tuple(plateau.first, plateau.last, plateau.width, plateau.voxels,
                               plateau.meaningful));
  return rows;
}

std::string loops_table(const LoopsRun& run, std::size_t top) {
  std::ostringstream out;
  write_table(out, run, top);
  if (run.with_features) write_features(out, run, top);
  return out.str();
}

std::string repair_table(const RepairRun& run, std::size_t top) {
  std::ostringstream out;
  write_repair_table(out, run, top);
  return out.str();
}

void write_curves_svg(std::ostream& out, const ScanRun& run) {
  write_scan_svg(out, run.scan, run.level.inside);
}

py::array labels_of(const LoopsRun& run) {
  const py::object volume = py::cast(std::make_shared<HeldVolume>(held("", label_volume(run))));
  return array_of(volume, volume.cast<const HeldVolume&>());
}

void bind_run(py::module_& module) {
  using Run = RunInput;
  py::class_<Run, std::shared_ptr<Run>>(module, "Run")
      .def_property_readonly("file", [](const Run& run) { return run.file; })
      .def_property_readonly("spacing", [](const Run& run) { return run.volume.spacing; })
      .def_property_readonly("affine", [](const Run& run) { return affine_of(run.volume); })
      .def_property_readonly("mirrors", [](const Run& run) { return frame_mirrors(run.volume); })
      .def_property_readonly("frame", [](const Run& run) { return frame_name(run.volume.frame); })
      .def_property_readonly("unit", [](const Run& run) { return run.volume.unit; })
      .def_property_readonly("iso", [](const Run& run) { return run.level.iso; })
      .def_property_readonly("inside", [](const Run& run) { return inside_text(run.level); })
      .def_property_readonly("notes", [](const Run& run) { return notes_of(run); })
      .def_property_readonly("warnings",
                             [](const Run& run) { return sentences_of(run.volume.warnings); });
}

void bind_count(py::module_& module) {
  py::class_<CountRun, RunInput, std::shared_ptr<CountRun>>(module, "CountRun")
      .def("json", text_by(write_count_json))
      .def("table", text_by(write_count_table))
      .def("summary", text_by(write_count_summary))
      .def_property_readonly("counts", [](const CountRun& run) { return counts_of(run.analysis); })
      .def("points",
           [](const py::object& self) {
             return rows_of(self, self.cast<const CountRun&>().analysis.surface.points);
           })
      .def("triangles", [](const py::object& self) {
        return rows_of(self, self.cast<const CountRun&>().analysis.surface.triangles);
      });
}

void bind_loops(py::module_& module) {
  py::class_<LoopsRun, CountRun, std::shared_ptr<LoopsRun>>(module, "LoopsRun")
      .def("json", text_by(write_json))
      .def("table", &loops_table, py::arg("top") = 0)
      .def("summary", text_by(write_loops_summary))
      .def("csv", text_by(write_csv))
      .def_property_readonly("found", [](const LoopsRun& run) { return run.analysis.loops.size(); })
      .def("columns", &loop_columns)
      .def("curves", &curves_of)
      .def("feature_columns", &feature_columns)
      .def("labels", &labels_of)
      .def("write", &write_file, py::arg("path"))
      .def(
          "write_surface",
          [](const LoopsRun& run, const std::string& path) {
            write_by(surface_report(path), run, path);
          },
          py::arg("path"))
      .def(
          "write_curves",
          [](const LoopsRun& run, const std::string& path) {
            write_by(curves_report(path), run, path);
          },
          py::arg("path"));
}

void bind_scan(py::module_& module) {
  py::class_<ScanRun, RunInput, std::shared_ptr<ScanRun>>(module, "ScanRun")
      .def("json", text_by(write_scan_json))
      .def("table", text_by(write_scan_table))
      .def("summary", text_by(write_scan_summary))
      .def("csv", text_by(write_scan_csv))
      .def("svg", text_by(write_curves_svg))
      .def("columns", &scan_columns)
      .def("plateaus", &plateaus_of)
      .def_property_readonly("ignored_below",
                             [](const ScanRun& run) { return run.scan.ignored_below; })
      .def_property_readonly("proposed", [](const ScanRun& run) { return run.scan.proposed; });
}

void bind_repair(py::module_& module) {
  using Run = RepairRun;
  py::class_<Run, RunInput, std::shared_ptr<Run>>(module, "RepairRun")
      .def("json", text_by(write_repair_json))
      .def("table", &repair_table, py::arg("top") = 0)
      .def("summary", text_by(write_repair_summary))
      .def_property_readonly("before", [](const Run& run) { return counts_of(run.repair.before); })
      .def_property_readonly("after", [](const Run& run) { return counts_of(run.repair.after); })
      .def_property_readonly("added_voxels", [](const Run& run) { return run.repair.added_voxels; })
      .def_property_readonly("removed_voxels",
                             [](const Run& run) { return run.repair.removed_voxels; })
      .def("removals", &removals_of)
      .def("kept", &kept_of)
      .def("changes", &changes_of)
      .def("changes_of_labels", &label_changes_of, py::arg("labels"), py::arg("asked"));
}

}  // namespace

void bind_results(py::module_& module) {
  bind_run(module);
  bind_count(module);
  bind_loops(module);
  bind_scan(module);
  bind_repair(module);
}

}  // namespace isoloop::python
