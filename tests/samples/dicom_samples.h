// Small DICOM files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/samples/byte_samples.h"

namespace isoloop::test {

inline constexpr const char* explicit_little = "1.2.840.10008.1.2.1";
inline constexpr const char* explicit_big = "1.2.840.10008.1.2.2";
inline constexpr const char* implicit_little = "1.2.840.10008.1.2";

/// A slice of 3 x 2 pixels of 16 bits.
struct DicomSlice {
  std::string syntax = explicit_little;
  std::string series = "1.2.3";
  std::string description = "Head";
  int instance = 1;
  std::string position = "10\\20\\0";
  std::string axes = "1\\0\\0\\0\\1\\0";
  std::string spacing = "0.5\\0.25";
  std::string slope{};
  std::string intercept{};
  std::string frames{};
  std::string colours = "MONOCHROME2";
  std::uint16_t samples = 1;
  std::uint16_t rows = 2;
  std::uint16_t columns = 3;
  std::uint16_t allocated = 16;
  std::uint16_t stored = 16;
  std::uint16_t high = 15;
  std::uint16_t is_signed = 1;
  std::vector<std::int16_t> pixels{0, 1, 2, 3, 4, 5};
  std::string after{};  // bytes at the end of the file

  Endian endian() const { return syntax == explicit_big ? Endian::big : Endian::little; }

  static std::string element(std::uint32_t tag, const std::string& kind, std::string value,
                             bool with_kind, Endian endian) {
    if (value.size() % 2 != 0) value.push_back(kind == "UI" ? '\0' : ' ');
    std::string bytes = number_bytes(static_cast<std::uint16_t>(tag >> 16), endian) +
                        number_bytes(static_cast<std::uint16_t>(tag), endian);
    const auto length = static_cast<std::uint32_t>(value.size());
    if (!with_kind) return bytes + number_bytes(length, endian) + value;
    bytes += kind;
    if (kind == "OW" || kind == "SQ")
      return bytes + std::string(2, '\0') + number_bytes(length, endian) + value;
    return bytes + number_bytes(static_cast<std::uint16_t>(length), endian) + value;
  }

  std::string file() const {
    const bool with_kind = syntax != implicit_little;
    const std::string meta = element(0x00020010U, "UI", syntax, true, Endian::little);
    std::string bytes =
        std::string(128, '\0') + "DICM" +
        element(0x00020000U, "UL",
                number_bytes(static_cast<std::uint32_t>(meta.size()), Endian::little), true,
                Endian::little) +
        meta;
    const auto add = [&](std::uint32_t tag, const char* kind, const std::string& value) {
      if (!value.empty()) bytes += element(tag, kind, value, with_kind, endian());
    };
    const auto whole = [&](std::uint16_t value) { return number_bytes(value, endian()); };
    add(0x0008103eU, "LO", description);
    // A sequence of undefined length, with an item of each sort.
    const std::string inner = element(0x00080100U, "SH", "code", with_kind, endian());
    const auto delimiter = [&](std::uint16_t number, std::uint32_t length) {
      return whole(0xfffe) + whole(number) + number_bytes(length, endian());
    };
    bytes += whole(0x0008) + whole(0x1111) + (with_kind ? std::string("SQ\0\0", 4) : "") +
             number_bytes(~std::uint32_t{0}, endian()) + delimiter(0xe000, ~std::uint32_t{0}) +
             inner + delimiter(0xe00d, 0) +
             delimiter(0xe000, static_cast<std::uint32_t>(inner.size())) + inner +
             delimiter(0xe0dd, 0);
    add(0x0020000eU, "UI", series);
    add(0x00200013U, "IS", std::to_string(instance));
    add(0x00200032U, "DS", position);
    add(0x00200037U, "DS", axes);
    add(0x00280002U, "US", whole(samples));
    add(0x00280004U, "CS", colours);
    add(0x00280008U, "IS", frames);
    add(0x00280010U, "US", whole(rows));
    add(0x00280011U, "US", whole(columns));
    add(0x00280030U, "DS", spacing);
    add(0x00280100U, "US", whole(allocated));
    add(0x00280101U, "US", whole(stored));
    add(0x00280102U, "US", whole(high));
    add(0x00280103U, "US", whole(is_signed));
    add(0x00281052U, "DS", intercept);
    add(0x00281053U, "DS", slope);
    std::string data;
    for (const std::int16_t pixel : pixels) data += number_bytes(pixel, endian());
    add(0x7fe00010U, "OW", data);
    return bytes + after;
  }

  /// The file without its first 132 bytes and the group that says how the rest is written.
  std::string data_set() const {
    const std::string whole = file();
    const auto group = load<std::uint32_t>(std::as_bytes(std::span(whole)), 140, Endian::little);
    return whole.substr(144 + group);
  }
};

/// The slice at height 2 z, with pixels from 100 z on.
inline DicomSlice dicom_slice_at(int z) {
  DicomSlice slice;
  slice.instance = z;
  slice.position = std::string("10\\20\\").append(std::to_string(2 * z));
  for (std::int16_t& pixel : slice.pixels) pixel = static_cast<std::int16_t>(pixel + 100 * z);
  return slice;
}

}  // namespace isoloop::test
