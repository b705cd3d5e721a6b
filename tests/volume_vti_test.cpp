#include <gtest/gtest.h>

#include "core/errors.h"
#include "tests/damaged_files.h"
#include "tests/volume_test_files.h"
#include "volume/vti.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::number_bytes;
using test::TempFolder;
using test::write_bytes;

std::string base64(const std::string& bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<std::uint8_t>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text.push_back(i + j <= bytes.size() ? letters[bits >> (18 - 6 * j) & 63U] : '=');
    }
  }
  return text;
}

// A file of 3 x 2 x 2 voxels of 16 bits, 0 to 11, whose first has the index (1, 0, 0).
struct Written {
  Endian endian = Endian::little;
  bool wide_sizes = false;
  bool packed = false;
  std::string format = "ascii";  // "binary", "raw" or "base64" (appended)
  std::string image = "Origin=\"10 20 30\" Spacing=\"1 2 3\"";
  std::string array{};  // more attributes
  std::string type = "Int16";
  std::string extent = "1 3 0 1 0 1";
  std::string more{};  // more point data

  std::string size(std::uint64_t bytes) const {
    return wide_sizes ? number_bytes(bytes, endian)
                      : number_bytes(static_cast<std::uint32_t>(bytes), endian);
  }
  std::string voxels() const {
    std::string bytes;
    for (std::int16_t i = 0; i < 12; ++i) bytes += number_bytes(i, endian);
    return bytes;
  }
  // Of 24 bytes in blocks of 16, or as they are.
  std::string data(bool as_text) const {
    const std::string bytes = voxels();
    if (!packed) {
      const std::string all = size(bytes.size()) + bytes;
      return as_text ? base64(all) : all;
    }
    const std::string first = test::zlib_bytes(bytes.substr(0, 16));
    const std::string last = test::zlib_bytes(bytes.substr(16));
    const std::string sizes = size(2) + size(16) + size(8) + size(first.size()) + size(last.size());
    return as_text ? base64(sizes) + base64(first + last) : sizes + first + last;
  }
  std::string file() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<!-- a <comment> -->\n<VTKFile "
        "type=\"ImageData\" version=\"1.0\" byte_order=\"";
    text += endian == Endian::big ? "BigEndian\"" : "LittleEndian\"";
    if (wide_sizes) text += " header_type=\"UInt64\"";
    if (packed) text += " compressor=\"vtkZLibDataCompressor\"";
    text += ">\n<ImageData WholeExtent=\"" + extent + "\" " + image + ">\n<Piece Extent=\"" +
            extent + "\">\n<PointData Scalars=\"density\">\n<DataArray type=\"" + type +
            "\" Name=\"density\" " + array;
    const bool appended = format == "raw" || format == "base64";
    if (appended) {
      text += " format=\"appended\" offset=\"0\"/>\n";
    } else if (format == "ascii") {
      text += " format=\"ascii\">0 1 2 3 4 5\n6 7 8 9 10 11</DataArray>\n";
    } else {
      text += " format=\"binary\">\n" + data(true) + "\n</DataArray>\n";
    }
    text += more + "</PointData>\n<CellData/></Piece></ImageData>\n";
    if (appended) {
      text += "<AppendedData encoding=\"" + format + "\">\n _" + data(format == "base64") +
              "\n</AppendedData>\n";
    }
    return text + "</VTKFile>";
  }
};

class Vti : public testing::Test {
 protected:
  Volume read(const std::string& bytes, const FormatOptions& options = {},
              const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.vti", bytes);
    return read_vti(folder_ / "a.vti", options, limits);
  }
  std::string refusal(const Written& written) const {
    return message_of<InvalidInput>([&] { read(written.file()); });
  }
  static std::vector<Written> every_sort() {
    std::vector<Written> sorts{{}};
    for (const char* format : {"binary", "raw", "base64"}) {
      for (const bool packed : {false, true}) {
        sorts.push_back({.packed = packed, .format = format});
        sorts.push_back(
            {.endian = Endian::big, .wide_sizes = true, .packed = packed, .format = format});
      }
    }
    return sorts;
  }
  TempFolder folder_;
};

TEST_F(Vti, EverySortHoldsTheSameVoxels) {
  for (const Written& written : every_sort()) {
    const Volume volume = read(written.file() + "\n");
    EXPECT_EQ(volume.dims, (Index3{3, 2, 2}));
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values),
              (std::vector<std::int16_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}))
        << written.format << written.packed;
    EXPECT_EQ(volume.name, "density");
  }
}

TEST_F(Vti, NoFileCutShortIsRead) {
  const auto path = folder_ / "cut.vti";
  for (const Written& written : every_sort()) {
    test::expect_no_beginning_is_read(path, written.file(), [&] { read_vti(path); });
  }
}

TEST_F(Vti, KeepsTheExtentSpacingAndDirection) {
  const Volume volume = read(Written{}.file());
  EXPECT_EQ(volume.frame, Frame::world);
  EXPECT_EQ(volume.origin, (Vec3{11, 20, 30}));
  EXPECT_EQ(volume.spacing, (Vec3{1, 2, 3}));
  const Volume turned =
      read(Written{.image = "Spacing=\"1 2 3\" Direction=\"0 -1 0 1 0 0 0 0 1\""}.file());
  EXPECT_EQ(turned.direction[0], (Vec3{0, 1, 0}));
  EXPECT_EQ(turned.direction[1], (Vec3{-1, 0, 0}));
  EXPECT_EQ(turned.origin, (Vec3{0, 1, 0}));
}

TEST_F(Vti, OfSeveralArraysOneIsChosen) {
  const std::string other =
      "<DataArray type=\"UInt8\" Name=\"other\" format=\"ascii\">1 1 1 1 1 1 1 1 1 1 1 9"
      "</DataArray>\n";
  std::string file = Written{.more = other}.file();
  EXPECT_EQ(read(file).name, "density");
  EXPECT_EQ(read(file, {.array = "other"}).name, "other");
  EXPECT_TRUE(contains(message_of<InvalidArgument>([&] { read(file, {.array = "no"}); }),
                       "'density', 'other'"));
  file.erase(file.find(" Scalars=\"density\""), 18);
  EXPECT_TRUE(contains(message_of<InvalidArgument>([&] { read(file); }), "--grid"));
}

TEST_F(Vti, WhatIsNoVolumeOfNumbersIsRefusedByName) {
  EXPECT_TRUE(contains(refusal({.array = "NumberOfComponents=\"3\""}), "3 numbers per voxel"));
  EXPECT_TRUE(contains(refusal({.type = "String"}), "'String'"));
  EXPECT_TRUE(contains(refusal({.extent = "3 1 0 1 0 1"}), "extent"));
  EXPECT_TRUE(contains(refusal({.extent = "0 3 0 1 0 1"}), "too short"));
  EXPECT_TRUE(contains(refusal({.image = "Spacing=\"1 -2 3\""}), "length of 2"));
  EXPECT_TRUE(contains(refusal({.image = "Spacing=\"1 0 3\""}), "spacing 0"));
  EXPECT_TRUE(contains(refusal({.image = "Direction=\"1 1 0 0 1 0 0 0 1\""}), "degrees (sheared)"));
  EXPECT_TRUE(
      contains(message_of<InvalidInput>([&] { read("<VTKFile type=\"PolyData\"></VTKFile>"); }),
               "PolyData"));
  std::string file = Written{.packed = true, .format = "raw"}.file();
  file.replace(file.find("ZLib"), 4, "LZ4 ");
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read(file); }), "LZ4"));
}

TEST_F(Vti, NumbersAsTextMustFitTheirType) {
  std::string file = Written{}.file();
  file.replace(file.find("10 11<"), 5, "10 x1");
  EXPECT_THROW(read(file), InvalidInput);
  file.replace(file.find("10 x1<"), 5, "99999");
  EXPECT_THROW(read(file), InvalidInput);
}

TEST_F(Vti, ABombIsRefusedBeforeMemoryIsAskedFor) {
  for (const char* format : {"ascii", "binary", "raw"}) {
    for (const bool packed : {false, true}) {
      const std::string bomb =
          Written{.packed = packed, .format = format, .extent = "0 99999 0 99999 0 99999"}.file();
      EXPECT_TRUE(contains(message_of<LimitExceeded>([&] { read(bomb); }), "--max-memory"));
      EXPECT_THROW(read(bomb, {}, {.max_bytes = ~std::uint64_t{0}}), InvalidInput);
    }
  }
  const std::string deep = "<VTKFile type=\"ImageData\">" + std::string(2000000, '<');
  EXPECT_THROW(read(deep), InvalidInput);
}

TEST_F(Vti, NoFlippedByteEndsTheProcess) {
  for (const Written& written : every_sort()) {
    const std::string whole = written.file();
    for (std::size_t at = 0; at < whole.size(); at += 3) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x15);
      try {
        read(damaged, {}, {.max_bytes = 1 << 20});
      } catch (const std::runtime_error&) {
        continue;
      }
    }
  }
}

}  // namespace
}  // namespace isoloop
