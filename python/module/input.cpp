#include "python/module/input.h"

#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

#include <pybind11/stl.h>

#include "core/base/errors.h"
#include "isoloop/shapes.h"
#include "python/module/watched.h"
#include "tools/reports/report_table.h"
#include "tools/runs/read_run.h"
#include "tools/runs/written_volume.h"
#include "tools/words/sentence.h"
#include "volume/files/write.h"
#include "volume/voxels/labels.h"
#include "volume/voxels/placement.h"

namespace isoloop::python {
namespace {

namespace py = pybind11;

/// `values` without numbers, in their type.
VoxelArray none_of(const VoxelArray& values) {
  return std::visit([](const auto& some) -> VoxelArray { return std::decay_t<decltype(some)>(); },
                    values);
}

/// Sets voxels and values where `array` holds numbers of type T.
template <class T>
bool take_as(const py::array& array, const Index3& dims, const Vec3& spacing, RunInput& run) {
  if (!py::isinstance<py::array_t<T>>(array)) return false;
  const auto count = static_cast<std::size_t>(array.size());
  run.voxels = GridView<T>{{static_cast<const T*>(array.data()), count}, dims, spacing};
  run.volume.values = std::vector<T>();
  return true;
}

template <class... T>
void take_voxels(const py::array& array, const Index3& dims, const Vec3& spacing, RunInput& run,
                 const std::variant<std::vector<T>...>& /*types*/) {
  if (!(take_as<T>(array, dims, spacing, run) || ...))
    throw InvalidArgument("voxels of this type are not read");
}

Frame frame_of(const std::string& name) {
  if (name == "ras") return Frame::ras;
  if (name == "lps") return Frame::lps;
  return name == "world" ? Frame::world : Frame::index;
}

void place_volume(Volume& volume, const ArrayPlace& where) {
  volume.unit = where.unit;
  if (where.affine) {
    const auto& columns = *where.affine;
    place(volume, {{columns[0], columns[1], columns[2]}, columns[3], frame_of(where.frame)},
          std::nullopt, "affine");
    return;
  }
  volume.spacing = where.spacing;
  for (const double length : where.spacing)
    if (!is_spacing(length))
      throw InvalidArgument(
          {.about = Option::spacing, .text = "must be lengths between 1e-18 and 1e18"});
}

Input input_of_held(py::object holder, const HeldVolume& volume) {
  Input input;
  input.holder = std::move(holder);
  input.of_labels = volume.of_labels;
  input.run.file = volume.file;
  input.run.volume = volume.about;
  input.run.nan_as = volume.nan_as;
  std::visit(
      [&]<class T>(const std::vector<T>& values) {
        input.run.voxels = GridView<T>{values, volume.about.dims, volume.about.spacing};
      },
      volume.values);
  return input;
}

HeldVolume read(const VolumeFlags& flags, bool open_boundary, const py::object& progress) {
  Volume volume = watched(progress, py::none(), [flags, open_boundary](const Progress& tell) {
    if (tell) tell("read", 0.0);
    return read_flagged(flags, open_boundary ? VdbMargin::none : VdbMargin::background);
  });
  HeldVolume read = held(flags.file, std::move(volume));
  read.nan_as = flags.nan_as;
  read.of_labels = !flags.label.empty();
  return read;
}

py::tuple generate(const std::string& shape, const ShapeOptions& options) {
  Shape made = watched(py::none(), py::none(),
                       [shape, options](const Progress&) { return make_shape(shape, options); });
  py::object known = py::none();
  if (made.known) known = py::make_tuple(made.known->b0, made.known->b1, made.known->b2);
  made.volume.level_set = made.level.inside == InsideRule::below && made.level.iso == 0.0;
  return py::make_tuple(held(shape, std::move(made.volume)), known);
}

/// Writes the voxels and their place; returns what the format cannot say.
std::vector<std::string> write(const Input& input, const std::string& path) {
  if (input.axes != Axes{0, 1, 2})
    throw InvalidArgument("voxels to write must be packed, the first axis the fastest");
  Volume volume = input.run.volume;
  std::visit(
      [&]<class T>(const GridView<T>& grid) {
        volume.values = std::vector<T>(grid.values.begin(), grid.values.end());
      },
      *input.run.voxels);
  check_written("path", path, volume);
  watched(py::none(), input.holder, [&](const Progress&) {
    write_volume(volume, path);
    return 0;
  });
  return sentences_of(left_out_of(volume, path));
}

/// The voxels, in the order of the array's axes; a view.
py::array voxels_in_array_axes(const Input& input) {
  return std::visit(
      [&]<class T>(const GridView<T>& grid) -> py::array {
        std::array<py::ssize_t, 3> strides{};
        auto step = static_cast<py::ssize_t>(sizeof(T));
        for (std::size_t a = 0; a < 3; step *= grid.dims[a++]) strides[input.axes[a]] = step;
        return py::array_t<T>(input.run.volume.dims, strides, grid.values.data(), input.holder);
      },
      *input.run.voxels);
}

void bind_volume(py::module_& module) {
  py::class_<HeldVolume, std::shared_ptr<HeldVolume>> volume(module, "HeldVolume");
  volume
      .def("array",
           [](const py::object& self) { return array_of(self, self.cast<const HeldVolume&>()); })
      .def("affine", [](const HeldVolume& self) { return affine_of(self.about); });
  const auto property = [&](const char* name, auto value) {
    volume.def_property_readonly(name, value);
  };
  property("file", [](const HeldVolume& v) { return v.file; });
  property("spacing", [](const HeldVolume& v) { return v.about.spacing; });
  property("unit", [](const HeldVolume& v) { return v.about.unit; });
  property("frame", [](const HeldVolume& v) { return frame_name(v.about.frame); });
  property("name", [](const HeldVolume& v) { return v.about.name; });
  property("level_set", [](const HeldVolume& v) { return v.about.level_set; });
  property("mask", [](const HeldVolume& v) { return v.about.mask; });
  property("notes", [](const HeldVolume& v) { return sentences_of(v.about.notes); });
  property("warnings", [](const HeldVolume& v) { return sentences_of(v.about.warnings); });
}

}  // namespace

Input input_of_array(const py::array& voxels, const Axes& axes, const ArrayPlace& place,
                     const std::optional<double>& nan_as, bool is_mask) {
  check_axes(axes);
  if (voxels.ndim() != 3 || (voxels.flags() & py::array::f_style) == 0 || voxels.size() == 0)
    throw InvalidArgument("voxels must be a packed array of three axes, the first the fastest");
  Input input;
  input.holder = voxels;
  input.axes = axes;
  input.of_labels = is_mask;
  input.run.file = "array";
  input.run.nan_as = nan_as;
  Volume& volume = input.run.volume;
  volume.mask = is_mask;
  const Index3 dims{voxels.shape(0), voxels.shape(1), voxels.shape(2)};
  volume.dims = in_array_axes(axes, dims);
  place_volume(volume, place);
  take_voxels(voxels, dims, in_grid_axes(axes, volume.spacing), input.run, volume.values);
  return input;
}

Input input_of_volume(const py::object& self, const HeldVolume& volume) {
  return input_of_held(self, volume);
}

Input input_of_labels(const Input& input, const std::vector<std::int64_t>& labels) {
  Volume copy = input.run.volume;
  copy.dims = in_grid_axes(input.axes, copy.dims);
  std::visit(
      [&]<class T>(const GridView<T>& grid) {
        copy.values = std::vector<T>(grid.values.begin(), grid.values.end());
      },
      *input.run.voxels);
  Volume mask = mask_of_labels(std::move(copy), labels, input.run.file);
  auto kept = std::make_shared<HeldVolume>(held(input.run.file, std::move(mask)));
  kept->nan_as = input.run.nan_as;
  kept->of_labels = true;
  Input of_mask = input_of_held(py::cast(kept), *kept);
  of_mask.axes = input.axes;
  Volume& about = of_mask.run.volume;
  std::visit([&](auto& grid) { grid.spacing = in_grid_axes(input.axes, about.spacing); },
             *of_mask.run.voxels);
  about.dims = input.run.volume.dims;
  return of_mask;
}

HeldVolume held(std::string file, Volume volume) {
  HeldVolume held{.file = std::move(file), .about = {}, .values = std::move(volume.values)};
  volume.values = none_of(held.values);
  held.about = std::move(volume);
  return held;
}

py::array array_of(const py::object& self, const HeldVolume& volume) {
  return std::visit(
      [&]<class T>(const std::vector<T>& values) -> py::array {
        const Index3& n = volume.about.dims;
        constexpr auto step = static_cast<py::ssize_t>(sizeof(T));
        return py::array_t<T>({n[0], n[1], n[2]}, {step, step * n[0], step * n[0] * n[1]},
                              values.data(), self);
      },
      volume.values);
}

std::array<std::array<double, 4>, 4> affine_of(const Volume& volume) {
  std::array<std::array<double, 4>, 4> rows{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      rows[row][axis] = volume.direction[axis][row] * volume.spacing[axis];
    rows[row][3] = volume.origin[row];
  }
  rows[3][3] = 1.0;
  return rows;
}

void bind_input(py::module_& module) {
  bind_volume(module);
  py::class_<Input>(module, "Input")
      .def_property_readonly("axes", [](const Input& input) { return input.axes; })
      .def("voxels", &voxels_in_array_axes)
      .def_property_readonly(
          "warnings", [](const Input& input) { return sentences_of(input.run.volume.warnings); });
  module.def(
      "input_of_array",
      [](const py::array& voxels, const Axes& axes, const Vec3& spacing,
         const std::optional<std::array<Vec3, 4>>& affine, const std::string& frame,
         const std::string& unit, const std::optional<double>& nan_as, bool is_mask) {
        return input_of_array(voxels, axes, {spacing, affine, frame, unit}, nan_as, is_mask);
      },
      py::arg("voxels"), py::arg("axes"), py::arg("spacing"), py::arg("affine"), py::arg("frame"),
      py::arg("unit"), py::arg("nan_as"), py::arg("is_mask"));
  module.def(
      "input_of_volume",
      [](const py::object& volume) {
        return input_of_volume(volume, volume.cast<const HeldVolume&>());
      },
      py::arg("volume"));
  module.def(
      "bytes_of", [](const std::string& size) { return parse_bytes(size); }, py::arg("size"));
  module.def("input_of_labels", &input_of_labels, py::arg("input"), py::arg("labels"));
  module.def("write", &write, py::arg("input"), py::arg("path"));
  module.def("read", &read, py::arg("flags"), py::arg("open_boundary"), py::arg("progress"));
  module.def(
      "generate",
      [](const std::string& shape, std::int64_t size, int holes, int cells,
         std::uint64_t max_bytes) {
        return generate(shape, {size, holes, cells, max_bytes});
      },
      py::arg("shape"), py::arg("size"), py::arg("holes"), py::arg("cells"), py::arg("max_bytes"));
  module.def("shape_names", &shape_names);
}

}  // namespace isoloop::python
