#include "volume/formats/dicom.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "core/grid/vec3.h"
#include "volume/base/header_text.h"
#include "volume/base/refuse.h"
#include "volume/base/rounded_text.h"
#include "volume/formats/dicom_elements.h"
#include "volume/formats/dicom_slice.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

using Slices = std::vector<DicomSlice>;

using Paths = std::vector<std::filesystem::path>;

/// The files that `Entries` finds, in order, without hidden ones. Throws InvalidInput.
template <class Entries>
Paths files_by(const std::filesystem::path& folder) {
  Paths files;
  std::error_code error;
  Entries entry(folder, std::filesystem::directory_options::skip_permission_denied, error);
  constexpr std::size_t most = 1000000;
  for (; !error && entry != Entries(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (!entry->is_regular_file(ignored) || name.starts_with('.')) continue;
    if (files.size() == most) refuse(folder.string(), "holds more than a million files");
    files.push_back(entry->path());
  }
  if (error) refuse(folder.string(), "cannot be read: " + error.message(), Fault::unreadable);
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether the file is a slice, as the index of a disc of them, DICOMDIR, is not.
bool is_dicom_slice(const std::filesystem::path& path) {
  return path.filename() != "DICOMDIR" && looks_like_dicom(path);
}

/// The files of the folder if some are DICOM, else those of all folders within it that are beside
/// some.
Paths files_beside_dicom(const std::filesystem::path& folder) {
  if (holds_dicom(folder)) return files_by<std::filesystem::directory_iterator>(folder);
  Paths files = files_by<std::filesystem::recursive_directory_iterator>(folder);
  std::set<std::filesystem::path> folders;
  for (const auto& file : files) {
    if (folders.count(file.parent_path()) == 0 && is_dicom_slice(file)) {
      folders.insert(file.parent_path());
    }
  }
  std::erase_if(files, [&](const auto& file) { return folders.count(file.parent_path()) == 0; });
  return files;
}

// Slices often have no extension, or a number as one.
bool may_be_a_slice(const std::filesystem::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension.empty() || extension == ".dcm" || extension == ".ima" ||
         std::all_of(extension.begin() + 1, extension.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

Slices read_slices(const std::filesystem::path& folder) {
  Slices slices;
  for (const auto& file : files_beside_dicom(folder)) {
    if (file.filename() == "DICOMDIR") continue;
    if (looks_like_dicom(file)) {
      slices.push_back(read_dicom_slice(file));
    } else if (may_be_a_slice(file)) {
      refuse(file.string(), "is no DICOM file, or is cut short; fetch it again or move it away");
    }
  }
  return slices;
}

bool is_meant(const DicomSlice& slice, const std::string& wanted) {
  return slice.series.find(wanted) != std::string::npos ||
         slice.description.find(wanted) != std::string::npos;
}

// Of several series the one that is asked for.
Slices choose_series(Slices slices, const std::string& wanted, const std::string& what) {
  std::map<std::string, Slices> series;
  for (DicomSlice& slice : slices) series[slice.series].push_back(std::move(slice));
  std::string list;
  for (const auto& [name, members] : series) {
    list += (list.empty() ? "" : "; ") + name + " (" + members.front().description + ", " +
            std::to_string(members.size()) + " slices)";
  }
  if (const auto exact = series.find(wanted); exact != series.end()) return exact->second;
  std::erase_if(series, [&](const auto& one) { return !is_meant(one.second.front(), wanted); });
  if (series.size() == 1) return std::move(series.begin()->second);
  throw InvalidArgument(
      {.file = what,
       .text = std::string(series.empty() ? "no series" : "more than one series") +
               (wanted.empty() ? "" : " fits '" + wanted + "'") + " among: " + list,
       .advice = {Advice::choose_series}},
      Option::series);
}

void check_alike(const Slices& slices) {
  const DicomSlice& first = slices.front();
  constexpr double tolerance = 1e-4;
  for (const DicomSlice& slice : slices) {
    const bool alike = slice.layout.dims == first.layout.dims &&
                       slice.layout.type == first.layout.type &&
                       distance(slice.axes[0], first.axes[0]) <= tolerance &&
                       distance(slice.axes[1], first.axes[1]) <= tolerance &&
                       std::abs(slice.spacing[0] - first.spacing[0]) <= tolerance &&
                       std::abs(slice.spacing[1] - first.spacing[1]) <= tolerance;
    if (!alike) {
      refuse(slice.path.string(), "differs from " + first.path.string() +
                                      " of the same series in size, type or direction; move one "
                                      "of them away");
    }
  }
}

double height_of(const DicomSlice& slice) {
  const Vec3 normal = cross(slice.axes[0], slice.axes[1]);
  return dot(*slice.position, normal);
}

/// Slices in order, one list for each frame.
std::vector<Slices> sorted_frames(Slices slices, bool by_position, const std::string& what) {
  if (!by_position) {
    std::stable_sort(slices.begin(), slices.end(), [](const DicomSlice& a, const DicomSlice& b) {
      return a.instance < b.instance;
    });
    return {slices};
  }
  std::vector<std::pair<double, const DicomSlice*>> heights;
  for (const DicomSlice& slice : slices) heights.emplace_back(height_of(slice), &slice);
  std::stable_sort(heights.begin(), heights.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second->instance) < std::pair(b.first, b.second->instance);
  });
  std::vector<Slices> places;  // those that lie at one height
  double before = 0.0;
  for (const auto& [height, slice] : heights) {
    constexpr double same = 1e-4;
    if (places.empty() || height - before > same) places.emplace_back();
    places.back().push_back(*slice);
    before = height;
  }
  std::vector<Slices> frames(places.front().size());
  for (Slices& place : places) {
    std::stable_sort(place.begin(), place.end(), [](const DicomSlice& a, const DicomSlice& b) {
      return a.instance < b.instance;
    });
    if (place.size() != frames.size()) {
      refuse(what, "has " + std::to_string(frames.size()) + " slices at one place and " +
                       std::to_string(place.size()) + " at another (" +
                       place.front().path.string() + "); move away what does not belong");
    }
    for (std::size_t i = 0; i < frames.size(); ++i) frames[i].push_back(place[i]);
  }
  return frames;
}

void check_gaps(const Slices& slices, bool spacing_given, Volume& volume) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i + 1 < slices.size(); ++i) {
    gaps.push_back(height_of(slices[i + 1]) - height_of(slices[i]));
  }
  std::vector<double> sorted = gaps;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i] > usual / 1.5 && gaps[i] < 1.5 * usual) continue;
    const std::string file = slices[i + 1].path.string();
    const std::string complaint = "lies " + rounded_text(gaps[i]) + " from " +
                                  slices[i].path.string() + ", other slices lie " +
                                  rounded_text(usual) +
                                  " apart: a slice is missing, or one does not belong";
    if (!spacing_given) {
      refuse(file, complaint + "; a stated spacing has them read as evenly spaced", Fault::damaged,
             {Advice::state_spacing});
    }
    volume.warnings.push_back(
        {.file = file, .text = complaint + "; they are read as evenly spaced"});
    return;
  }
  if (sorted.back() - sorted.front() <= 0.01 * usual) return;
  volume.warnings.push_back({.text = "slices lie " + rounded_text(sorted.front()) + " to " +
                                     rounded_text(sorted.back()) +
                                     " apart; they are read as evenly spaced"});
}

Placement placement_of(const Slices& slices) {
  const DicomSlice& first = slices.front();
  const Vec3 spacing = first.spacing;
  Placement placement{.frame = Frame::lps};
  columns_of(spacing, first.path.string());  // refuses what is no length
  placement.origin = *first.position;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t c = 0; c < 3; ++c) {
      placement.columns[axis][c] = first.axes[axis][c] * spacing[axis];
    }
  }
  Vec3 step = cross(first.axes[0], first.axes[1]);
  for (std::size_t c = 0; c < 3; ++c) {
    const double steps = static_cast<double>(slices.size()) - 1.0;
    step[c] = slices.size() == 1 ? step[c] * spacing[2]
                                 : ((*slices.back().position)[c] - (*first.position)[c]) / steps;
  }
  placement.columns[2] = step;
  return placement;
}

bool scales_alike(const Slices& slices) {
  const VoxelLayout& first = slices.front().layout;
  return std::all_of(slices.begin(), slices.end(), [&](const DicomSlice& slice) {
    return slice.layout.slope == first.slope && slice.layout.intercept == first.intercept;
  });
}

template <class T>
void append(std::vector<T>& values, const VoxelArray& layer) {
  std::visit(
      [&](const auto& pixels) {
        for (const auto pixel : pixels) values.push_back(static_cast<T>(pixel));
      },
      layer);
}

// Where slices have scales of their own the values are float32.
VoxelArray read_values(const Slices& slices, std::uint64_t count, const std::string& what) {
  const VoxelLayout& first = slices.front().layout;
  if (!scales_alike(slices)) {
    std::vector<float> values;
    values.reserve(count);
    for (const DicomSlice& slice : slices) {
      append(values, rescaled(read_pixels(slice), slice.layout.slope, slice.layout.intercept,
                              slice.path.string()));
    }
    return values;
  }
  VoxelArray stored = read_pixels(slices.front());
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        values.reserve(count);
        for (std::size_t i = 1; i < slices.size(); ++i) append(values, read_pixels(slices[i]));
      },
      stored);
  return rescaled(std::move(stored), first.slope, first.intercept, what);
}

}  // namespace

Volume read_dicom(const std::filesystem::path& path, const FormatOptions& options,
                  const VoxelLimits& limits) {
  const std::string what = path.string();
  const bool folder = std::filesystem::is_directory(path);
  Slices slices = folder ? read_slices(path) : Slices{read_dicom_slice(path)};
  if (slices.empty()) refuse(what, "holds no DICOM files");
  slices = choose_series(std::move(slices), options.series, what);
  check_alike(slices);
  const bool placed = std::all_of(slices.begin(), slices.end(), [](const DicomSlice& slice) {
    return slice.position.has_value();
  });
  if (!placed && !options.spacing) {
    refuse(what,
           "its slices do not state their place; with a stated spacing they are read in the order "
           "of their instance numbers",
           Fault::damaged, {Advice::state_spacing});
  }
  const std::vector<Slices> frames = sorted_frames(std::move(slices), placed, what);
  const Slices& first = frames.front();
  VoxelLayout layout = first.front().layout;
  layout.dims[2] = static_cast<std::int64_t>(first.size());
  layout.frames = frames.size();
  if (!scales_alike(first)) layout.slope = 0.5;  // takes the memory of values that are scaled
  check_layout(layout, limits, what);
  const Slices& chosen = frames[choose_frame(layout, options.frame, what)];
  Volume volume;
  volume.dims = layout.dims;
  if (placed && chosen.size() > 2) check_gaps(chosen, options.spacing.has_value(), volume);
  place(volume, options.spacing ? Placement{} : placement_of(chosen), options.spacing, what);
  if (!options.spacing) volume.unit = "mm";
  if (folder && chosen.front().path.parent_path() != (path / "").parent_path()) {
    volume.notes.push_back({.text = "slices are in " + chosen.front().path.parent_path().string()});
  }
  if (scales_alike(chosen)) {
    add_scale_note(chosen.front().layout, volume);
  } else {
    volume.notes.push_back({.text = "values are scaled slice by slice, as each states"});
  }
  volume.values = read_values(chosen, checked_voxel_count(volume.dims, what), what);
  return volume;
}

std::vector<DicomSeries> dicom_series(const std::filesystem::path& folder) {
  std::map<std::string, DicomSeries> series;
  for (const DicomSlice& slice : read_slices(folder)) {
    DicomSeries& one = series[slice.series];
    one.id = slice.series;
    one.description = slice.description;
    ++one.slices;
  }
  std::vector<DicomSeries> list;
  list.reserve(series.size());
  for (const auto& [id, one] : series) list.push_back(one);
  return list;
}

bool holds_dicom(const std::filesystem::path& folder) {
  const Paths files = files_by<std::filesystem::directory_iterator>(folder);
  return std::any_of(files.begin(), files.end(), is_dicom_slice);
}

bool holds_dicom_within(const std::filesystem::path& folder) {
  const Paths files = files_by<std::filesystem::recursive_directory_iterator>(folder);
  return std::any_of(files.begin(), files.end(), is_dicom_slice);
}

}  // namespace isoloop
