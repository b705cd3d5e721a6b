#include "volume/slices/tiff_pages.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <set>
#include <span>

#include "core/base/errors.h"
#include "volume/base/byte_order.h"
#include "volume/base/byte_stream.h"

namespace isoloop {
namespace {

constexpr std::uint16_t description_tag = 270;
constexpr std::uint16_t strip_offsets_tag = 273;
constexpr std::uint16_t strip_counts_tag = 279;
constexpr std::uint16_t tile_offsets_tag = 324;
constexpr std::uint16_t tile_counts_tag = 325;
constexpr std::uint64_t longest_description = std::uint64_t{1} << 26;

/// One entry of a directory: where its values are.
struct Entry {
  std::uint16_t tag = 0;
  std::uint16_t type = 0;
  std::uint64_t count = 0;
  std::uint64_t at = 0;  // byte of the values
};

class Walker {
 public:
  explicit Walker(const std::filesystem::path& path)
      : what_(path.string()), size_(stored_bytes(path)), file_(path, std::ios::binary) {}

  TiffPages walk() {
    std::uint64_t at = first_directory();
    TiffPages pages;
    std::set<std::uint64_t> seen;
    while (at != 0) {
      constexpr std::size_t most_pages = 1000000;
      if (!seen.insert(at).second) refuse("its pages run in a circle");
      if (pages.at.size() == most_pages) refuse("has more than a million pages");
      at = directory(at, pages);
    }
    if (pages.at.empty()) refuse("has no pages");
    pages.endian = endian_;
    pages.file_bytes = size_;
    return pages;
  }

 private:
  [[noreturn]] void refuse(const std::string& complaint) const {
    throw InvalidInput({.file = what_, .text = complaint});
  }

  void check(std::uint64_t at, std::uint64_t bytes) const {
    if (at > size_ || bytes > size_ - at) {
      refuse("points " + std::to_string(bytes) + " bytes at byte " + std::to_string(at) +
             ", but has " + std::to_string(size_) + "; fetch the file again");
    }
  }

  // Entries that lie side by side are fewer than the file's bytes, so that pages which share theirs
  // cannot make a small file long work.
  void count_entries(std::uint64_t more) {
    entries_ += more;
    if (entries_ > size_) refuse("its pages share one list of strips; save it as a plain TIFF");
  }

  void read(std::uint64_t at, std::span<std::byte> to) {
    check(at, to.size());
    file_.seekg(static_cast<std::streamoff>(at));
    if (!file_.read(reinterpret_cast<char*>(to.data()), static_cast<std::streamsize>(to.size()))) {
      refuse("cannot be read; check that you may read it");
    }
  }

  template <class T>
  T number(std::uint64_t at) {
    std::array<std::byte, sizeof(T)> bytes{};
    read(at, bytes);
    return load<T>(bytes, 0, endian_);
  }

  // A size or place in the file, of the width that its sort of TIFF has.
  std::uint64_t place(std::uint64_t at) {
    return big_ ? number<std::uint64_t>(at) : number<std::uint32_t>(at);
  }

  std::uint64_t first_directory() {
    std::array<std::byte, 4> magic{};
    read(0, magic);
    const std::byte order = magic[0];
    if (order != magic[1] || (order != std::byte{'I'} && order != std::byte{'M'})) {
      refuse("is no TIFF file");
    }
    endian_ = order == std::byte{'M'} ? Endian::big : Endian::little;
    const auto version = load<std::uint16_t>(magic, 2, endian_);
    if (version != 42 && version != 43) refuse("is no TIFF file");
    big_ = version == 43;
    return place(big_ ? 8 : 4);
  }

  std::uint64_t bytes_of(std::uint16_t type) const {
    constexpr std::array<std::uint8_t, 19> sizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4,
                                                 8, 4, 8, 4, 0, 0, 8, 8, 8};
    if (type >= sizes.size() || sizes[type] == 0) {
      refuse("holds values of type " + std::to_string(type) + ", which TIFF does not know");
    }
    return sizes[type];
  }

  Entry entry(std::uint64_t at) {
    Entry entry{.tag = number<std::uint16_t>(at), .type = number<std::uint16_t>(at + 2)};
    entry.count = place(at + 4);
    const std::uint64_t value_at = at + (big_ ? 12 : 8);
    const std::uint64_t bytes = bytes_of(entry.type);
    if (entry.count > size_ / bytes) check(value_at, size_ + 1);
    entry.at = entry.count * bytes <= (big_ ? 8U : 4U) ? value_at : place(value_at);
    check(entry.at, entry.count * bytes);
    return entry;
  }

  std::uint64_t value(const Entry& entry, std::uint64_t i) {
    switch (entry.type) {
      case 3:
        return number<std::uint16_t>(entry.at + 2 * i);
      case 4:
        return number<std::uint32_t>(entry.at + 4 * i);
      case 16:
        return number<std::uint64_t>(entry.at + 8 * i);
      default:
        refuse("states places of pixels that are no whole numbers");
    }
  }

  void describe(const Entry& entry, TiffPages& pages) {
    if (entry.count > longest_description) refuse("has a description of more than 64 MiB");
    pages.description.resize(entry.count);
    read(entry.at, std::as_writable_bytes(std::span(pages.description)));
    pages.description.resize(std::min(pages.description.find('\0'), pages.description.size()));
  }

  // The first page's strips, as long as each begins where the one before ends.
  void add_to_row(std::uint64_t strip, std::uint64_t from, std::uint64_t bytes, TiffPages& pages) {
    if (strip == 0) pages.pixels_at = from;
    in_a_row_ = strip == 0 || (in_a_row_ && from == pages.pixels_at + pages.pixel_bytes);
    pages.pixel_bytes = in_a_row_ ? pages.pixel_bytes + bytes : 0;
  }

  std::uint64_t directory(std::uint64_t at, TiffPages& pages) {
    const std::uint64_t count = big_ ? number<std::uint64_t>(at) : number<std::uint16_t>(at);
    const std::uint64_t first = at + (big_ ? 8 : 2);
    const std::uint64_t width = big_ ? 20 : 12;
    if (count > 4096) refuse("has a directory of " + std::to_string(count) + " entries");
    check(first, count * width + (big_ ? 8 : 4));
    count_entries(count);
    Entry offsets;
    Entry counts;
    for (std::uint64_t i = 0; i < count; ++i) {
      const Entry one = entry(first + i * width);
      if (one.tag == strip_offsets_tag || one.tag == tile_offsets_tag) offsets = one;
      if (one.tag == strip_counts_tag || one.tag == tile_counts_tag) counts = one;
      const bool describes = one.tag == description_tag && (one.type == 2 || one.type == 1);
      if (describes && pages.at.empty()) describe(one, pages);
    }
    if (offsets.count == 0 || offsets.count != counts.count) {
      refuse("does not state where each of its strips is and how long");
    }
    count_entries(offsets.count);
    for (std::uint64_t i = 0; i < offsets.count; ++i) {
      const std::uint64_t from = value(offsets, i);
      const std::uint64_t bytes = value(counts, i);
      check(from, bytes);
      if (pages.at.empty()) add_to_row(i, from, bytes, pages);
    }
    pages.at.push_back(at);
    return place(first + count * width);
  }

  std::string what_;
  std::uint64_t size_;
  std::uint64_t entries_ = 0;  // of directories, and of their lists of strips
  std::ifstream file_;
  Endian endian_ = Endian::little;
  bool big_ = false;
  bool in_a_row_ = false;
};

}  // namespace

TiffPages read_tiff_pages(const std::filesystem::path& path) {
  check_is_file(path);
  return Walker(path).walk();
}

}  // namespace isoloop
