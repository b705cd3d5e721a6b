// Arrays as the runs of isoloop take them, and volumes of files as arrays.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "python/module/axes.h"
#include "tools/flags/input_flags.h"
#include "tools/runs/run_result.h"

namespace isoloop::python {

/// A volume whose voxels an array of Python is a view of.
struct HeldVolume {
  std::string file;
  Volume about;  // without its values, of which the type is left
  VoxelArray values;
  std::optional<double> nan_as{};  // the value that was read in place of NaN
  bool of_labels = false;          // made from labels of a label map
};

/// Voxels and all that is known of them, for a run.
struct Input {
  pybind11::object holder;  // of the voxels' memory
  Axes axes{0, 1, 2};
  RunInput run{};  // in the array's axes; `voxels` is set, along memory
  bool of_labels = false;
};

/// Where an array lies, as a user says it; along the array's axes.
struct ArrayPlace {
  Vec3 spacing{1.0, 1.0, 1.0};
  std::optional<std::array<Vec3, 4>> affine{};  // columns: along each axis, and the origin
  std::string frame;                            // "index", "world", "ras" or "lps"
  std::string unit;                             // of the spacing; may be empty
};

/// `is_mask`: of booleans, whose iso value defaults to 0.5.
/// `voxels`: three-dimensional, its first axis the fastest in memory and nothing between its
/// numbers. They are not copied. Throws InvalidArgument for another type or layout, a spacing that
/// is none, and a frame without an affine; InvalidInput for an affine whose axes are not at right
/// angles.
Input input_of_array(const pybind11::array& voxels, const Axes& axes, const ArrayPlace& place,
                     const std::optional<double>& nan_as, bool is_mask);

/// The same of a volume, which is kept alive; `self`: its object.
Input input_of_volume(const pybind11::object& self, const HeldVolume& volume);

/// 1 where the voxel has one of the labels, else 0. Copies the voxels while it runs. Throws as
/// mask_of_labels() does.
Input input_of_labels(const Input& input, const std::vector<std::int64_t>& labels);

HeldVolume held(std::string file, Volume volume);

/// The voxels as an array of three axes, the first the fastest; a view, which keeps `self` alive.
pybind11::array array_of(const pybind11::object& self, const HeldVolume& volume);

/// Rows of the map from (i, j, k, 1) to the world.
std::array<std::array<double, 4>, 4> affine_of(const Volume& volume);

/// Adds the classes and functions that make inputs to the module.
void bind_input(pybind11::module_& module);

}  // namespace isoloop::python
