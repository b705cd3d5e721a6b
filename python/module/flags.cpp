#include "python/module/flags.h"

#include <pybind11/stl.h>

#include "tools/flags/input_flags.h"
#include "tools/flags/repair_flags.h"
#include "tools/runs/loops_run.h"
#include "tools/runs/scan_run.h"

namespace isoloop::python {

namespace py = pybind11;

void bind_flags(py::module_& module) {
  py::class_<VolumeFlags>(module, "VolumeFlags")
      .def(py::init<>())
      .def_readwrite("file", &VolumeFlags::file)
      .def_readwrite("dims", &VolumeFlags::dims)
      .def_readwrite("type", &VolumeFlags::type)
      .def_readwrite("endian", &VolumeFlags::endian)
      .def_readwrite("skip", &VolumeFlags::skip)
      .def_readwrite("spacing", &VolumeFlags::spacing)
      .def_readwrite("grid", &VolumeFlags::grid)
      .def_readwrite("frame", &VolumeFlags::frame)
      .def_readwrite("channel", &VolumeFlags::channel)
      .def_readwrite("series", &VolumeFlags::series)
      .def_readwrite("affine", &VolumeFlags::affine)
      .def_readwrite("label", &VolumeFlags::label)
      .def_readwrite("world", &VolumeFlags::world)
      .def_readwrite("nan_as", &VolumeFlags::nan_as)
      .def_readwrite("max_memory", &VolumeFlags::max_memory)
      .def_readwrite("max_voxels", &VolumeFlags::max_voxels)
      .def_readwrite("crop", &VolumeFlags::crop)
      .def("set_voxel", [](VolumeFlags& flags, double length) { flags.voxel_size.length = length; })
      .def("set_resolution",
           [](VolumeFlags& flags, std::int64_t voxels) { flags.voxel_size.resolution = voxels; })
      .def("set_automatic", [](VolumeFlags& flags) { flags.voxel_size.automatic = true; });
  py::class_<LevelFlags>(module, "LevelFlags")
      .def(py::init<>())
      .def_readwrite("iso", &LevelFlags::iso)
      .def_readwrite("inside", &LevelFlags::inside)
      .def_readwrite("topology", &LevelFlags::topology)
      .def_readwrite("connectivity", &LevelFlags::connectivity)
      .def_readwrite("open_boundary", &LevelFlags::open_boundary);
  py::class_<EngineFlags>(module, "EngineFlags")
      .def(py::init<>())
      .def_readwrite("engine", &EngineFlags::engine)
      .def_readwrite("refine", &EngineFlags::refine)
      .def_readwrite("tighten", &EngineFlags::tighten)
      .def_readwrite("complex", &EngineFlags::complex)
      .def_readwrite("grading", &EngineFlags::grading);
  py::class_<LoopFilter>(module, "LoopFilter")
      .def(py::init<>())
      .def_readwrite("min_size", &LoopFilter::min_size)
      .def_readwrite("max_size", &LoopFilter::max_size)
      .def_readwrite("handles", &LoopFilter::handles)
      .def_readwrite("tunnels", &LoopFilter::tunnels);
  py::class_<LoopsInput>(module, "LoopsInput")
      .def(py::init<>())
      .def_readwrite("level", &LoopsInput::level)
      .def_readwrite("engine", &LoopsInput::engine)
      .def_readwrite("geodesic", &LoopsInput::geodesic)
      .def_readwrite("filter", &LoopsInput::filter)
      .def_readwrite("with_scan", &LoopsInput::with_scan)
      .def_readwrite("features_may_lack", &LoopsInput::features_may_lack)
      .def("set_feature_ratio", [](LoopsInput& input, double ratio) {
        input.features = FeatureOptions{.ratio = ratio};
      });
  py::class_<ScanRange>(module, "ScanRange")
      .def(py::init<>())
      .def_readwrite("values", &ScanRange::values)
      .def_readwrite("least", &ScanRange::from)
      .def_readwrite("most", &ScanRange::to);
  py::class_<RepairFlags>(module, "RepairFlags")
      .def(py::init<>())
      .def_readwrite("fill_tunnels", &RepairFlags::fill_tunnels)
      .def_readwrite("cut_handles", &RepairFlags::cut_handles)
      .def_readwrite("either", &RepairFlags::either)
      .def_readwrite("genus", &RepairFlags::genus)
      .def_readwrite("ids", &RepairFlags::ids)
      .def_readwrite("side", &RepairFlags::side)
      .def_readwrite("keep_going", &RepairFlags::keep_going);
}

}  // namespace isoloop::python
