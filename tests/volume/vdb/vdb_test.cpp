#include "volume/vdb/vdb.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>
#include <malloc.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"
#include "volume/vdb/vdb_decode.h"
#include "volume/vdb/vdb_message.h"

namespace isoloop {
namespace {

using openvdb::Coord;
using openvdb::math::Transform;
using test::contains;
using test::message_of;
using test::TempFolder;
using test::write_bytes;

/// Uncompressed, the codec under which OpenVDB notices least.
void write_grids(const std::filesystem::path& path, const openvdb::GridPtrVec& grids) {
  std::ofstream file(path, std::ios::binary);
  openvdb::io::Stream stream(file);
  stream.setCompression(openvdb::io::COMPRESS_NONE);
  stream.write(grids);
}

openvdb::FloatGrid::Ptr small_grid(const std::string& name) {
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(-1.0F);
  grid->setName(name);
  grid->tree().setValueOn(Coord(-3, 5, 7), 1.0F);
  grid->tree().setValueOn(Coord(1, 6, 9), 2.0F);
  grid->tree().setValueOff(Coord(0, 5, 8), 3.0F);
  return grid;
}

template <class Grid>
openvdb::GridBase::Ptr one_voxel_grid(const std::string& name) {
  openvdb::initialize();
  auto grid = Grid::create();
  grid->setName(name);
  grid->tree().setValueOn(Coord(0, 0, 0));
  return grid;
}

float at(const Volume& volume, const Index3& index) {
  const std::int64_t v = index[0] + volume.dims[0] * (index[1] + volume.dims[1] * index[2]);
  return std::get<std::vector<float>>(volume.values).at(static_cast<std::size_t>(v));
}

TEST(VdbReader, SpansTheActiveBoxAloneWhereNoMarginIsWanted) {
  const TempFolder folder;
  write_grids(folder / "a.vdb", {small_grid("density")});
  const Volume volume = read_vdb(folder / "a.vdb", "", {}, VdbMargin::none);
  EXPECT_EQ(volume.dims, (Index3{5, 2, 3}));
  EXPECT_EQ(at(volume, {0, 0, 0}), 1.0F);
  EXPECT_EQ(at(volume, {4, 1, 2}), 2.0F);
}

TEST(VdbReader, SpansTheActiveBoxAndOneLayerOfBackground) {
  const TempFolder folder;
  write_grids(folder / "a.vdb", {small_grid("density")});
  const Volume volume = read_vdb(folder / "a.vdb", "");
  EXPECT_EQ(volume.dims, (Index3{5 + 2, 2 + 2, 3 + 2}));
  EXPECT_EQ(volume.origin, (Vec3{-4.0, 4.0, 6.0}));
  EXPECT_EQ(volume.frame, Frame::world);
  EXPECT_EQ(volume.name, "density");
  EXPECT_FALSE(volume.level_set);
  EXPECT_EQ(at(volume, {1, 1, 1}), 1.0F);
  EXPECT_EQ(at(volume, {5, 2, 3}), 2.0F);
  EXPECT_EQ(at(volume, {4, 1, 2}), 3.0F);  // inactive, but no background
  EXPECT_EQ(at(volume, {0, 0, 0}), -1.0F);
  EXPECT_EQ(at(volume, {6, 3, 4}), -1.0F);
}

TEST(VdbReader, ActiveTilesCount) {
  const TempFolder folder;
  auto grid = small_grid("density");
  grid->tree().addTile(1, Coord(16, 0, 0), 5.0F, true);
  write_grids(folder / "a.vdb", {grid});
  const Volume volume = read_vdb(folder / "a.vdb", "");
  EXPECT_EQ(volume.dims, (Index3{23 + 3 + 1 + 2, 8 + 2, 10 + 2}));
  const auto& values = std::get<std::vector<float>>(volume.values);
  EXPECT_EQ(std::count(values.begin(), values.end(), 5.0F), 512);
}

TEST(VdbReader, KeepsDoublesAndTheLevelSetClass) {
  const TempFolder folder;
  openvdb::initialize();
  auto grid = openvdb::DoubleGrid::create(0.1);
  grid->tree().setValueOn(Coord(0, 0, 0), 1.0 / 3.0);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  write_grids(folder / "a.vdb", {grid});
  const Volume volume = read_vdb(folder / "a.vdb", "");
  EXPECT_TRUE(volume.level_set);
  EXPECT_EQ(std::get<std::vector<double>>(volume.values)[13], 1.0 / 3.0);
  EXPECT_EQ(std::get<std::vector<double>>(volume.values)[0], 0.1);
}

TEST(VdbReader, KeepsARotatedScaledTransform) {
  const TempFolder folder;
  auto grid = small_grid("density");
  openvdb::Mat4d matrix(0.0, 2.0, 0.0, 0.0,   //
                        -3.0, 0.0, 0.0, 0.0,  //
                        0.0, 0.0, -4.0, 0.0,  //
                        10.0, 20.0, 30.0, 1.0);
  grid->setTransform(Transform::createLinearTransform(matrix));
  write_grids(folder / "a.vdb", {grid});
  const Volume volume = read_vdb(folder / "a.vdb", "");
  EXPECT_EQ(volume.spacing, (Vec3{2.0, 3.0, 4.0}));
  EXPECT_EQ(volume.direction[0], (Vec3{0.0, 1.0, 0.0}));
  EXPECT_EQ(volume.direction[1], (Vec3{-1.0, 0.0, 0.0}));
  EXPECT_EQ(volume.direction[2], (Vec3{0.0, 0.0, -1.0}));
  const openvdb::Vec3d expected = grid->transform().indexToWorld(Coord(1, 6, 9));
  const Vec3 world = to_world(volume, {5.0, 2.0, 3.0});
  for (int c = 0; c < 3; ++c) EXPECT_DOUBLE_EQ(world[static_cast<std::size_t>(c)], expected[c]);
}

TEST(VdbReader, RefusesShearedAndPerspectiveTransformsByName) {
  const TempFolder folder;
  auto sheared = small_grid("sheared");
  openvdb::Mat4d matrix = openvdb::Mat4d::identity();
  matrix(1, 0) = 0.25;
  sheared->setTransform(Transform::createLinearTransform(matrix));
  auto frustum = small_grid("frustum");
  frustum->setTransform(
      Transform::createFrustumTransform(openvdb::BBoxd({0, 0, 0}, {9, 9, 9}), 0.5, 10.0));
  write_grids(folder / "a.vdb", {sheared, frustum});
  for (const char* name : {"sheared", "frustum"}) {
    const std::string message = message_of<InvalidInput>([&] { read_vdb(folder / "a.vdb", name); });
    EXPECT_TRUE(contains(message, "'" + std::string(name) + "'")) << message;
  }
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_vdb(folder / "a.vdb", "frustum"); }),
                       "perspective"));
}

TEST(VdbReader, ChoosesTheOnlyScalarGridOrTheNamedOne) {
  const TempFolder folder;
  write_grids(folder / "one.vdb", {one_voxel_grid<openvdb::Vec3SGrid>("v"), small_grid("f")});
  EXPECT_EQ(read_vdb(folder / "one.vdb", "").name, "f");
  write_grids(folder / "two.vdb", {small_grid("a"), small_grid("b")});
  EXPECT_EQ(read_vdb(folder / "two.vdb", "b").name, "b");
  for (const char* name : {"", "c"}) {
    const std::string message =
        message_of<InvalidArgument>([&] { read_vdb(folder / "two.vdb", name); });
    EXPECT_TRUE(contains(message, "'a' (float), 'b' (float)")) << message;
  }
}

TEST(VdbReader, RefusesGridsOfOtherTypesByName) {
  const TempFolder folder;
  write_grids(folder / "a.vdb", {one_voxel_grid<openvdb::Vec3SGrid>("velocity"),
                                 one_voxel_grid<openvdb::BoolGrid>("mask"),
                                 one_voxel_grid<openvdb::Int32Grid>("labels")});
  for (const char* name : {"velocity", "mask", "labels"}) {
    const std::string message = message_of<InvalidInput>([&] { read_vdb(folder / "a.vdb", name); });
    EXPECT_TRUE(contains(message, name)) << message;
  }
  const std::string message = message_of<InvalidInput>([&] { read_vdb(folder / "a.vdb", ""); });
  EXPECT_TRUE(contains(message, "'velocity' (vec3s), 'mask' (bool), 'labels' (int32)")) << message;
}

TEST(VdbReader, RefusesAGridWithoutActiveVoxels) {
  const TempFolder folder;
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(1.0F);
  grid->tree().setValueOff(Coord(1, 2, 3), 4.0F);
  write_grids(folder / "a.vdb", {grid});
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_vdb(folder / "a.vdb", ""); }),
                       "no active voxels"));
  write_grids(folder / "none.vdb", {});
  EXPECT_THROW(read_vdb(folder / "none.vdb", ""), InvalidInput);
}

TEST(VdbReader, ChecksTheLimitBeforeItDensifies) {
  const TempFolder folder;
  auto grid = small_grid("density");
  write_grids(folder / "small.vdb", {grid});  // densified: 7 x 4 x 5 floats
  EXPECT_THROW(read_vdb(folder / "small.vdb", "", {.max_bytes = 559}), LimitExceeded);
  EXPECT_NO_THROW(read_vdb(folder / "small.vdb", "", {.max_bytes = 560}));
  EXPECT_THROW(read_vdb(folder / "small.vdb", "", {.max_voxels = 139}), LimitExceeded);
  grid->tree().setValueOn(Coord(2000000000, 2000000000, 2000000000));
  grid->tree().setValueOn(Coord(-2000000000, -2000000000, -2000000000));
  write_grids(folder / "wide.vdb", {grid});
  EXPECT_THROW(read_vdb(folder / "wide.vdb", ""), LimitExceeded);
  grid->tree().setValueOn(Coord::max());
  write_grids(folder / "end.vdb", {grid});
  EXPECT_THROW(read_vdb(folder / "end.vdb", ""), InvalidInput);
}

/// One leaf of few values and one tile, in a few thousand bytes.
std::string small_file(std::uint32_t compression) {
  auto grid = small_grid("density");
  grid->tree().addTile(1, Coord(16, 0, 0), 5.0F, true);
  for (int i = 0; i < 40; ++i) grid->tree().setValueOn(Coord(i % 8, i % 5, i % 3), 0.01F * i);
  std::ostringstream out;
  openvdb::io::Stream stream(out);
  stream.setCompression(compression);
  stream.write(openvdb::GridPtrVec{grid});
  return out.str();
}

Volume decode(const std::string& bytes) {
  std::istringstream in(bytes);
  std::stringstream message;
  decode_vdb(in, {}, "a.vdb", message);
  return receive_volume(message, {}, "a.vdb");
}

/// Ends the process: with 0 if each of the lengths is refused, else with 1 and names the others.
[[noreturn]] void decode_beginnings(const std::string& whole,
                                    std::span<const std::size_t> lengths) {
  mallopt(M_MMAP_THRESHOLD, 64 << 20);  // nodes of 260 kB come and go: keep their pages
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  bool refused = true;
  for (const std::size_t length : lengths) {
    try {
      decode(whole.substr(0, length));
      std::cerr << "read: " << length << " of " << whole.size() << '\n';
    } catch (const InvalidInput&) {
      continue;
    } catch (const std::exception& error) {
      std::cerr << length << " of " << whole.size() << ": " << error.what() << '\n';
    }
    refused = false;
  }
  std::_Exit(refused ? 0 : 1);
}

/// Hundreds in one process: tens of thousands of children would take an hour. Not all in this one:
/// OpenVDB loses 260 kB or more of nodes with a file that breaks off, 5 GB in all.
void expect_refusal_at_any_byte(std::uint32_t codec) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a new program: this one may have threads
  const std::string whole = small_file(codec);
  EXPECT_EQ(decode(whole).dims, (Index3{23 + 3 + 1 + 2, 8 + 2, 10 + 2}));
  // Uncompressed, nearly all of the file is the values of two upper nodes, 144 kB.
  const std::size_t edge = 4000;
  const bool large = whole.size() > 40000;
  std::vector<std::size_t> lengths;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    if (large && length > edge && length + edge < whole.size()) length += 210;
    lengths.push_back(length);
  }
  constexpr std::size_t at_a_time = 500;
  for (std::size_t first = 0; first < lengths.size(); first += at_a_time) {
    const auto some =
        std::span(lengths).subspan(first, std::min(at_a_time, lengths.size() - first));
    EXPECT_EXIT(decode_beginnings(whole, some), ::testing::ExitedWithCode(0), "")
        << "codec " << codec;
  }
}

TEST(VdbReader, RefusesAPlainFileTruncatedAtAnyByte) {
  expect_refusal_at_any_byte(openvdb::io::COMPRESS_NONE);
}

TEST(VdbReader, RefusesAMaskedFileTruncatedAtAnyByte) {
  expect_refusal_at_any_byte(openvdb::io::COMPRESS_ACTIVE_MASK);
}

TEST(VdbReader, RefusesAZipFileTruncatedAtAnyByte) {
  expect_refusal_at_any_byte(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
}

TEST(VdbReader, RefusesABloscFileTruncatedAtAnyByte) {
  expect_refusal_at_any_byte(openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK);
}

TEST(VdbReader, RefusesATruncatedFileInOneSentence) {
  const TempFolder folder;
  const std::string whole = small_file(openvdb::io::COMPRESS_NONE);
  write_bytes(folder / "a.vdb", whole);
  EXPECT_EQ(read_vdb(folder / "a.vdb", "").name, "density");
  for (std::size_t cut = 1; cut < whole.size(); cut += whole.size() / 10) {
    write_bytes(folder / "a.vdb", whole.substr(0, whole.size() - cut));
    const std::string message = message_of<InvalidInput>([&] { read_vdb(folder / "a.vdb", ""); });
    EXPECT_TRUE(contains(message, "a.vdb: not a whole OpenVDB file")) << message;
  }
}

TEST(VdbReader, OutlivesFilesThatBreakOpenVdb) {
  for (const std::string name :
       {"bad/vdb_blosc_one_flipped_bit.vdb", "bad/vdb_zip_memory_bomb.vdb"}) {
    ISOLOOP_NEEDS(name);
    const auto start = std::chrono::steady_clock::now();
    const std::string message = message_of<InvalidInput>([&] { read_vdb(test::data(name), ""); });
    EXPECT_TRUE(contains(message, name + ": not a whole OpenVDB file")) << message;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << name;
  }
}

TEST(VdbReader, NamesTheLimitThatStoppedTheDecoder) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer's own memory goes over any limit";
#endif
  const TempFolder folder;
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(0.0F);
  for (int i = 0; i < 40000; ++i) grid->tree().setValueOn(Coord(8 * (i % 200), 8 * (i / 200), 0));
  write_grids(folder / "a.vdb", {grid});  // 40 000 leaves: 83 MiB
  const auto error =
      test::error_of<LimitExceeded>([&] { read_vdb(folder / "a.vdb", "", {.max_bytes = 1000}); });
  EXPECT_TRUE(test::advises(error.finding, Advice::raise_memory_limit));
  EXPECT_EQ(error.excess.limit, 1000U);
}

TEST(VdbReader, TakesNoMoreMemoryForASparseFileThanItsVoxels) {
  const TempFolder folder;
  auto grid = small_grid("density");
  grid->tree().setValueOn(Coord(200, 200, 200), 4.0F);
  write_grids(folder / "a.vdb", {grid});
  const Volume volume = read_vdb(folder / "a.vdb", "");
  EXPECT_EQ(volume.dims, (Index3{206, 198, 196}));
  EXPECT_EQ(at(volume, {204, 196, 194}), 4.0F);
  EXPECT_EQ(at(volume, {100, 100, 100}), -1.0F);
  EXPECT_LT(std::filesystem::file_size(folder / "a.vdb"), 1000000U);
}

TEST(VdbReader, RefusesBytesThatAreNoVdbFile) {
  const TempFolder folder;
  write_bytes(folder / "a.vdb", std::string(5000, 'x'));
  const std::string message = message_of<InvalidInput>([&] { read_vdb(folder / "a.vdb", ""); });
  EXPECT_TRUE(contains(message, "a.vdb")) << message;
  write_bytes(folder / "empty.vdb", "");
  EXPECT_THROW(read_vdb(folder / "empty.vdb", ""), InvalidInput);
  EXPECT_THROW(read_vdb(folder / "missing.vdb", ""), InvalidInput);
}

TEST(VdbReader, ReadsFogVolumesOfOtherPrograms) {
  for (const std::string name : {"torus01", "oiio_sphere"}) {
    ISOLOOP_NEEDS("vdb/" + name + ".vdb");
    const Volume volume = read_vdb(test::data("vdb/" + name + ".vdb"), "");
    EXPECT_FALSE(volume.level_set) << name;
    EXPECT_EQ(volume.frame, Frame::world) << name;
    EXPECT_GT(value_range(volume).max, value_range(volume).min) << name;
  }
}

TEST(VdbReader, TellsGridsOfOneNameApart) {
  ISOLOOP_NEEDS("vdb/grids.vdb");
  const auto path = test::data("vdb/grids.vdb");
  const std::string message = message_of<InvalidArgument>([&] { read_vdb(path, "density"); });
  EXPECT_TRUE(contains(message, "'density[0]' (float), 'density[1]' (float)")) << message;
  EXPECT_EQ(read_vdb(path, "density[0]").name, "density");
  EXPECT_NE(read_vdb(path, "density[0]").origin, read_vdb(path, "density[1]").origin);
  EXPECT_THROW(read_vdb(path, "density[3]"), InvalidArgument);
}

TEST(VdbReader, ReadsALevelSetOfAnotherProgram) {
  ISOLOOP_NEEDS("vdb/sphere.vdb");
  const Volume volume = read_vdb(test::data("vdb/sphere.vdb"), "");
  EXPECT_TRUE(volume.level_set);
  EXPECT_LT(value_range(volume).min, 0.0);
  EXPECT_EQ(at(volume, {0, 0, 0}), static_cast<float>(value_range(volume).max));
}

TEST(VdbReader, RefusesAVectorGridOfAnotherProgram) {
  ISOLOOP_NEEDS("vdb/oiio_sphereCd.vdb");
  const std::string message =
      message_of<InvalidInput>([] { read_vdb(test::data("vdb/oiio_sphereCd.vdb"), ""); });
  EXPECT_TRUE(contains(message, "vec3")) << message;
}

}  // namespace
}  // namespace isoloop
