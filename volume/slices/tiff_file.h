// Pages of a TIFF file, decoded by libtiff.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "volume/base/memory_limit.h"
#include "volume/slices/slice_image.h"

struct tiff;

namespace isoloop {

/// An open file that stands at one of its pages.
class TiffFile {
 public:
  /// Throws InvalidInput if libtiff does not open it.
  explicit TiffFile(const std::filesystem::path& path);
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  /// Goes to the page whose directory is at this byte. Throws InvalidInput.
  void open_page(std::uint64_t at) const;

  tiff* get() const { return tiff_.get(); }
  const std::string& what() const { return what_; }

  /// Throws InvalidInput with what libtiff complained of last.
  [[noreturn]] void fail() const;

 private:
  struct Closer {
    void operator()(tiff* file) const;
  };
  std::string what_;
  std::string message_ = "unreadable";
  std::unique_ptr<tiff, Closer> tiff_{};
};

/// A page as its directory states it.
struct TiffPage {
  SliceImage image{};
  std::int64_t depth = 1;          // slices within the page (tag ImageDepth)
  bool reduced = false;            // a smaller picture of another page
  bool plain = true;               // stored pixel after pixel, neither packed nor in tiles
  double pixels_per_unit_x = 0.0;  // of `resolution_unit`; 0: not stated
  double pixels_per_unit_y = 0.0;
  int resolution_unit = 0;  // 1: none, 2: inch, 3: cm, as TIFF numbers them
};

/// The page at which `file` stands. Throws InvalidInput: colour, several samples per pixel, packed
/// bits, lossy or unknown compression.
TiffPage page_of(const TiffFile& file);

/// Decodes the page's slices into `to`, which has their size. Tiles take memory of their own, which
/// `limits` bounds. Throws InvalidInput (damage; ImageDepth with packed strips, which libtiff does
/// not reach) and LimitExceeded.
void read_page(const TiffFile& file, const TiffPage& page, const VoxelLimits& limits,
               std::span<std::byte> to);

}  // namespace isoloop
