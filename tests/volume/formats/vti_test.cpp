#include "volume/formats/vti.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/volume_test_files.h"
#include "tests/samples/vti_samples.h"

namespace isoloop {
namespace {

using test::contains;
using test::every_sort_of_vti;
using test::message_of;
using test::TempFolder;
using test::VtiSample;
using test::write_bytes;

class Vti : public ::testing::Test {
 protected:
  Volume read(const std::string& bytes, const FormatOptions& options = {},
              const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.vti", bytes);
    return read_vti(folder_ / "a.vti", options, limits);
  }
  std::string refusal(const VtiSample& sample) const {
    return message_of<InvalidInput>([&] { read(sample.file()); });
  }
  TempFolder folder_;
};

TEST_F(Vti, EverySortHoldsTheSameVoxels) {
  for (const VtiSample& sample : every_sort_of_vti()) {
    const Volume volume = read(sample.file() + "\n");
    EXPECT_EQ(volume.dims, (Index3{3, 2, 2}));
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values),
              (std::vector<std::int16_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}))
        << sample.format << sample.packed;
    EXPECT_EQ(volume.name, "density");
  }
}

TEST_F(Vti, NoFileCutShortIsRead) {
  const auto path = folder_ / "cut.vti";
  for (const VtiSample& sample : every_sort_of_vti()) {
    test::expect_no_beginning_is_read(path, sample.file(), [&] { read_vti(path); });
  }
}

TEST_F(Vti, KeepsTheExtentSpacingAndDirection) {
  const Volume volume = read(VtiSample{}.file());
  EXPECT_EQ(volume.frame, Frame::world);
  EXPECT_EQ(volume.origin, (Vec3{11, 20, 30}));
  EXPECT_EQ(volume.spacing, (Vec3{1, 2, 3}));
  const Volume turned =
      read(VtiSample{.image = "Spacing=\"1 2 3\" Direction=\"0 -1 0 1 0 0 0 0 1\""}.file());
  EXPECT_EQ(turned.direction[0], (Vec3{0, 1, 0}));
  EXPECT_EQ(turned.direction[1], (Vec3{-1, 0, 0}));
  EXPECT_EQ(turned.origin, (Vec3{0, 1, 0}));
}

TEST_F(Vti, OfSeveralArraysOneIsChosen) {
  const std::string other =
      "<DataArray type=\"UInt8\" Name=\"other\" format=\"ascii\">1 1 1 1 1 1 1 1 1 1 1 9"
      "</DataArray>\n";
  std::string file = VtiSample{.more = other}.file();
  EXPECT_EQ(read(file).name, "density");
  EXPECT_EQ(read(file, {.array = "other"}).name, "other");
  EXPECT_TRUE(contains(message_of<InvalidArgument>([&] { read(file, {.array = "no"}); }),
                       "'density', 'other'"));
  file.erase(file.find(" Scalars=\"density\""), 18);
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { read(file); }).option, Option::grid);
}

/// A file of 3 x 3 x 2 points, so of 2 x 2 x 1 cells, 1 to 4.
std::string file_with_cells(const std::string& points, const std::string& cells) {
  return "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"1 3 0 2 0 1\" Origin=\"10 20 30\" "
         "Spacing=\"1 2 3\"><Piece Extent=\"1 3  0 2  0 1\"><PointData>" +
         points + "</PointData><CellData>" + cells + "</CellData></Piece></ImageData></VTKFile>";
}

std::string array_of(const std::string& name, const std::string& numbers) {
  return "<DataArray type=\"UInt8\" Name=\"" + name + "\" format=\"ascii\">" + numbers +
         "</DataArray>";
}

TEST_F(Vti, CellsAreVoxelsWhoseCentresLieHalfASpacingIn) {
  const Volume volume = read(file_with_cells("", array_of("v", "1 2 3 4")));
  EXPECT_EQ(volume.dims, (Index3{2, 2, 1}));
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(volume.values),
            (std::vector<std::uint8_t>{1, 2, 3, 4}));
  EXPECT_EQ(volume.origin, (Vec3{11.5, 21, 31.5}));
  EXPECT_EQ(volume.spacing, (Vec3{1, 2, 3}));
  EXPECT_TRUE(contains(volume.notes.at(0).text, "cells")) << volume.notes.at(0).text;
  std::string flat = file_with_cells("", array_of("v", "1 2 3 4"));
  for (std::size_t at = flat.find(" 0 1\""); at != std::string::npos; at = flat.find(" 0 1\""))
    flat.replace(at, 4, " 5 5");
  EXPECT_EQ(read(flat).dims, (Index3{2, 2, 1}));
  EXPECT_EQ(read(flat).origin, (Vec3{11.5, 21, 45}));
}

TEST_F(Vti, OfPointsAndCellsOneIsChosen) {
  const std::string eighteen = "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18";
  const std::string both = file_with_cells(array_of("p", eighteen), array_of("c", "1 2 3 4"));
  const std::string message = message_of<InvalidArgument>([&] { read(both); });
  EXPECT_TRUE(contains(message, "of points 'p'; of cells 'c'")) << message;
  EXPECT_EQ(read(both, {.array = "p"}).dims, (Index3{3, 3, 2}));
  EXPECT_EQ(read(both, {.array = "c"}).dims, (Index3{2, 2, 1}));
  const std::string same = file_with_cells(array_of("v", eighteen), array_of("v", "1 2 3 4"));
  EXPECT_TRUE(contains(message_of<InvalidArgument>([&] { read(same, {.array = "v"}); }),
                       "points:v and cells:v"));
  EXPECT_EQ(read(same, {.array = "points:v"}).dims, (Index3{3, 3, 2}));
  EXPECT_EQ(read(same, {.array = "cells:v"}).dims, (Index3{2, 2, 1}));
  std::string active = both;
  active.replace(active.find("<PointData>"), 11, "<PointData Scalars=\"p\">");
  EXPECT_THROW(read(active), InvalidArgument);
  std::string cells = file_with_cells("", array_of("b", "4 3 2 1") + array_of("c", "1 2 3 4"));
  EXPECT_THROW(read(cells), InvalidArgument);
  cells.replace(cells.find("<CellData>"), 10, "<CellData Scalars=\"c\">");
  EXPECT_EQ(read(cells).name, "c");
  EXPECT_EQ(
      read(file_with_cells(array_of("vtkGhostType", eighteen), array_of("c", "1 2 3 4"))).name,
      "c");
  EXPECT_THROW(read(file_with_cells("", "")), InvalidInput);
}

TEST_F(Vti, ABlockMayHoldLessThanItsSize) {
  const VtiSample sample{.packed = true, .format = "raw", .block = 32768};
  EXPECT_EQ(read(sample.file()).values, read(VtiSample{}.file()).values);
  std::string wrong = sample.file();
  const std::size_t block = wrong.find(test::number_bytes(std::uint32_t{32768}, Endian::little));
  wrong.replace(block, 4, test::number_bytes(std::uint32_t{20}, Endian::little));
  EXPECT_THROW(read(wrong), InvalidInput);
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
  std::string file = VtiSample{.packed = true, .format = "raw"}.file();
  file.replace(file.find("ZLib"), 4, "LZ4 ");
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read(file); }), "LZ4"));
}

TEST_F(Vti, NumbersAsTextMustFitTheirType) {
  std::string file = VtiSample{}.file();
  file.replace(file.find("10 11<"), 5, "10 x1");
  EXPECT_THROW(read(file), InvalidInput);
  file.replace(file.find("10 x1<"), 5, "99999");
  EXPECT_THROW(read(file), InvalidInput);
}

TEST_F(Vti, ABombIsRefusedBeforeMemoryIsAskedFor) {
  for (const char* format : {"ascii", "binary", "raw"}) {
    for (const bool packed : {false, true}) {
      const std::string bomb =
          VtiSample{.packed = packed, .format = format, .extent = "0 99999 0 99999 0 99999"}.file();
      EXPECT_EQ(test::error_of<LimitExceeded>([&] { read(bomb); }).excess.unit,
                Excess::Unit::bytes);
      EXPECT_THROW(read(bomb, {}, {.max_bytes = ~std::uint64_t{0}}), InvalidInput);
    }
  }
  const std::string deep = "<VTKFile type=\"ImageData\">" + std::string(2000000, '<');
  EXPECT_THROW(read(deep), InvalidInput);
}

TEST_F(Vti, FlippedBytesAreNoticedOrHarmless) {
  for (const VtiSample& sample : every_sort_of_vti())
    test::expect_flipped_bytes_are_noticed_or_harmless(
        sample.file(), 3,
        [&](const std::string& bytes) { return read(bytes, {}, {.max_bytes = 1 << 20}); });
}

TEST(VtiData, FilesOfOneBlockAndOfCellsAreRead) {
  ISOLOOP_NEEDS("odd/one_partial_block.vti");
  ISOLOOP_NEEDS("odd/cell_data.vti");
  EXPECT_EQ(read_vti(test::data("odd/one_partial_block.vti")).dims, (Index3{25, 25, 25}));
  EXPECT_EQ(read_vti(test::data("odd/cell_data.vti")).dims, (Index3{24, 20, 16}));
}

}  // namespace
}  // namespace isoloop
