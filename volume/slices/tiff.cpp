#include "volume/slices/tiff.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "volume/base/refuse.h"
#include "volume/slices/tiff_file.h"
#include "volume/slices/tiff_pages.h"
#include "volume/slices/tiff_planes.h"
#include "volume/voxels/stored_voxels.h"

namespace isoloop {
namespace {

TiffPage first_page(const TiffFile& file, const TiffPages& pages) {
  file.open_page(pages.at.front());
  return page_of(file);
}

/// Decodes the pages one after the other: all must be like the first.
void read_pages(const TiffFile& file, const TiffPages& pages, const TiffPage& first,
                const std::vector<std::uint64_t>& chosen, const VoxelLimits& limits,
                std::span<std::byte> to) {
  const std::size_t bytes = to.size() / chosen.size();
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    file.open_page(pages.at[chosen[i]]);
    const TiffPage page = page_of(file);
    if (page.reduced) {
      refuse(file.what(),
             "its page " + std::to_string(chosen[i]) +
                 " is a reduced picture of another one; save it without previews",
             Fault::unsupported);
    }
    if (page.image != first.image || page.depth != first.depth) {
      refuse(file.what(), "its page " + std::to_string(chosen[i]) +
                              " differs from the first in size, type or whether 0 is white; "
                              "save slices that are alike");
    }
    read_page(file, page, limits, to.subspan(i * bytes, bytes));
  }
}

/// Planes that lie one after the other as they are from the first page's pixels on.
template <class T>
void read_planes_behind_first(const std::filesystem::path& path, const TiffPages& pages,
                              const std::vector<std::uint64_t>& chosen, std::vector<T>& voxels) {
  const std::uint64_t plane = voxels.size() / chosen.size();
  std::ifstream file(path, std::ios::binary);
  for (std::size_t z = 0; z < chosen.size(); ++z) {
    const auto bytes = std::as_writable_bytes(std::span(voxels).subspan(z * plane, plane));
    file.seekg(static_cast<std::streamoff>(pages.pixels_at + chosen[z] * bytes.size()));
    if (!file.read(reinterpret_cast<char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()))) {
      refuse(path.string(), "cannot be read; check that you may read it", Fault::unreadable);
    }
  }
  if (pages.endian != native_endian) swap_bytes(std::span(voxels));
}

void check_that_planes_are_there(const TiffPages& pages, std::uint64_t planes,
                                 std::uint64_t plane_bytes, const std::string& what) {
  if (pages.pixel_bytes < plane_bytes) {
    refuse(
        what,
        "states images behind its one page, whose own pixels lie apart; save it as a plain TIFF");
  }
  const std::uint64_t left = pages.file_bytes - pages.pixels_at;
  if (planes <= left / plane_bytes) return;
  refuse(what, "states " + std::to_string(planes) + " images but holds " +
                   std::to_string(pages.at.size()) + (pages.at.size() == 1 ? " page" : " pages") +
                   ", with pixels behind it for " + std::to_string(left / plane_bytes) +
                   "; fetch the file again");
}

/// Slices within pages, which libtiff decodes only from tiles.
void check_depth(const TiffPages& pages, const TiffPage& first, std::uint64_t slices,
                 TiffPlanes& planes, const std::string& what) {
  if (first.depth == 1) return;
  const auto depth = static_cast<std::uint64_t>(first.depth);
  if (planes.axes.size() > 1 || slices != pages.at.size() * depth) {
    refuse(what,
           "states channels or frames of slices within pages (ImageDepth), which isoloop "
           "does not read; save it as a TIFF of pages",
           Fault::unsupported);
  }
  const std::uint64_t bytes = slice_bytes(first.image, what);
  planes.behind_first = pages.at.size() == 1 && first.plain && pages.pixel_bytes / depth == bytes &&
                        pages.pixel_bytes % depth == 0;
}

std::uint64_t product_of(const std::vector<TiffAxis>& axes) {
  std::uint64_t product = 1;
  for (const TiffAxis& axis : axes) product *= axis.size;
  return product;
}

}  // namespace

Volume read_tiff(const std::filesystem::path& path, const FormatOptions& options,
                 const VoxelLimits& limits) {
  const std::string what = path.string();
  const TiffPages pages = read_tiff_pages(path);
  const TiffFile file(path);
  const TiffPage first = first_page(file, pages);
  const std::uint64_t plane_bytes = slice_bytes(first.image, what);
  TiffPlanes planes = tiff_planes(pages.description, pages.at.size(), first, what);
  std::vector<std::uint64_t> chosen = chosen_pages(planes, options, what);
  check_depth(pages, first, chosen.size(), planes, what);
  if (planes.behind_first) {
    check_that_planes_are_there(pages, product_of(planes.axes), plane_bytes, what);
  }
  Volume volume;
  volume.dims = {first.image.width, first.image.height, static_cast<std::int64_t>(chosen.size())};
  check_voxel_memory(volume.dims, bytes_per_voxel(first.image.type), limits, what);
  volume.notes = std::move(planes.notes);
  volume.warnings = std::move(planes.warnings);
  Placement placement;
  if (planes.spacing) placement.columns = columns_of(*planes.spacing, what);
  place(volume, placement, options.spacing, what);
  if (!options.spacing && planes.spacing) volume.unit = planes.unit;
  if (!options.spacing && !planes.spacing) {
    volume.notes.push_back({.text = "the file does not state a spacing: 1 is taken",
                            .advice = {Advice::override_spacing}});
  }
  volume.values = zero_voxels(first.image.type,
                              plane_bytes / bytes_per_voxel(first.image.type) * chosen.size());
  std::visit(
      [&](auto& voxels) {
        if (planes.behind_first) return read_planes_behind_first(path, pages, chosen, voxels);
        // Each page holds `depth` slices, and all of them are chosen in order.
        if (first.depth > 1) {
          chosen.resize(pages.at.size());
          for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i;
        }
        read_pages(file, pages, first, chosen, limits, std::as_writable_bytes(std::span(voxels)));
      },
      volume.values);
  return volume;
}

SliceImage tiff_slice_image(const std::filesystem::path& path) {
  const TiffPages pages = read_tiff_pages(path);
  const TiffFile file(path);
  const TiffPage page = first_page(file, pages);
  const std::uint64_t slices = pages.at.size() * static_cast<std::uint64_t>(page.depth);
  if (slices > 1) {
    refuse(path.string(),
           "has " + std::to_string(slices) + " pages; in a folder of slices each file is one page",
           Fault::unsupported);
  }
  return page.image;
}

void read_tiff_slice(const std::filesystem::path& path, const VoxelLimits& limits,
                     std::span<std::byte> to) {
  const TiffPages pages = read_tiff_pages(path);
  const TiffFile file(path);
  read_page(file, first_page(file, pages), limits, to);
}

}  // namespace isoloop
