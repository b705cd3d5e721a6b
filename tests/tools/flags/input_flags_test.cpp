#include "tools/flags/input_flags.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/base/errors.h"

namespace isoloop {
namespace {

using Words = std::vector<std::string>;

TEST(TieNumbersToFlags, LeavesTheFileAlone) {
  EXPECT_EQ(tie_numbers_to_flags({"loops", "--dims", "64", "32", "16", "x.raw"}),
            (Words{"loops", "--dims=64 32 16", "x.raw"}));
  EXPECT_EQ(tie_numbers_to_flags({"--dims", "64x32x16", "x.raw"}),
            (Words{"--dims", "64x32x16", "x.raw"}));
  EXPECT_EQ(tie_numbers_to_flags({"--spacing", "0.5", "x.raw"}), (Words{"--spacing=0.5", "x.raw"}));
}

TEST(TieNumbersToFlags, TakesNegativeNumbersForNumbers) {
  EXPECT_EQ(tie_numbers_to_flags({"--iso", "-.5", "--nan-as", "-1e3"}),
            (Words{"--iso=-.5", "--nan-as=-1e3"}));
}

TEST(TieNumbersToFlags, StopsAtTheDoubleDash) {
  EXPECT_EQ(tie_numbers_to_flags({"--", "--iso", "5"}), (Words{"--", "--iso", "5"}));
}

TEST(TieNumbersToFlags, LeavesWordsThatAreNoNumbers) {
  EXPECT_EQ(tie_numbers_to_flags({"--iso", "five"}), (Words{"--iso", "five"}));
}

TEST(TieNumbersToFlags, RefusesAFlagWithoutNumbers) {
  EXPECT_THROW(tie_numbers_to_flags({"--dims"}), InvalidArgument);
  EXPECT_THROW(tie_numbers_to_flags({"--dims", "--type", "u8"}), InvalidArgument);
}

TEST(ParseDims, TakesBlanksCrossesAndCommas) {
  const Index3 dims{64, 32, 16};
  EXPECT_EQ(parse_dims("64 32 16"), dims);
  EXPECT_EQ(parse_dims("64x32x16"), dims);
  EXPECT_EQ(parse_dims("64,32,16"), dims);
}

TEST(ParseDims, RefusesWhatIsNotThreeCounts) {
  for (const char* text : {"", "64", "64 32", "64 32 16 8", "64 32 0", "64 32 -1", "6.5 3 3",
                           "64 32 16a", "99999999999999999999 1 1"}) {
    EXPECT_THROW(parse_dims(text), InvalidArgument) << text;
  }
}

TEST(ParseSpacing, TakesOneOrThreeLengths) {
  EXPECT_EQ(parse_spacing("0.5"), (Vec3{0.5, 0.5, 0.5}));
  EXPECT_EQ(parse_spacing("0.5 1 2e-3"), (Vec3{0.5, 1, 2e-3}));
}

TEST(ParseSpacing, RefusesWhatIsNoLength) {
  for (const char* text : {"", "0", "-1", "1 2", "inf", "nan", "1 1 1 1", "mm"}) {
    EXPECT_THROW(parse_spacing(text), InvalidArgument) << text;
  }
}

TEST(ParseLists, RefuseASeparatorWithoutANumber) {
  for (const char* text : {"64,,32,16", "64x32x", "x64 32 16", ",64 32 16"}) {
    EXPECT_THROW(parse_dims(text), InvalidArgument) << text;
    EXPECT_THROW(parse_spacing(text), InvalidArgument) << text;
  }
  EXPECT_EQ(parse_dims("64 , 32 x 16"), (Index3{64, 32, 16}));
}

TEST(ParseBytes, KnowsPowersOf1024) {
  EXPECT_EQ(parse_bytes("65536"), 65536U);
  EXPECT_EQ(parse_bytes("512M"), 512U << 20);
  EXPECT_EQ(parse_bytes("4G"), std::uint64_t{4} << 30);
  EXPECT_EQ(parse_bytes("4GiB"), std::uint64_t{4} << 30);
  EXPECT_EQ(parse_bytes("4GB"), std::uint64_t{4} << 30);
  EXPECT_EQ(parse_bytes("1.5k"), 1536U);
}

TEST(ParseBytes, RefusesWhatIsNoSize) {
  for (const char* text : {"", "G", "-1G", "0", "4X", "4G4", "nan", "inf", "99999999999T"}) {
    EXPECT_THROW(parse_bytes(text), InvalidArgument) << text;
  }
}

TEST(ReadOptionsOfFlags, NamesTheFlagThatMakesNoSense) {
  VolumeFlags flags;
  flags.type = "u9";
  try {
    read_options(flags);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("--type u9"), std::string::npos);
  }
}

TEST(ReadOptionsOfFlags, CarriesEveryFlag) {
  const ReadOptions options = read_options({.file = "x.raw",
                                            .dims = "4 5 6",
                                            .type = "i16",
                                            .endian = "big",
                                            .skip = 12,
                                            .spacing = "2",
                                            .grid = "density",
                                            .frame = 3,
                                            .channel = 4,
                                            .series = "1.2.3",
                                            .affine = "qform",
                                            .label = "3,-7",
                                            .world = "lps",
                                            .nan_as = -1.0,
                                            .max_memory = "1K",
                                            .max_voxels = 99,
                                            .crop = "1:2,:,3:"});
  EXPECT_EQ(options.raw.dims, (Index3{4, 5, 6}));
  EXPECT_EQ(options.raw.type, VoxelType::int16);
  EXPECT_EQ(options.raw.endian, Endian::big);
  EXPECT_EQ(options.raw.skip, 12U);
  EXPECT_EQ(options.raw.spacing, (Vec3{2, 2, 2}));
  EXPECT_EQ(options.grid, "density");
  EXPECT_EQ(options.format.array, "density");
  EXPECT_EQ(options.nan_as, -1.0);
  EXPECT_EQ(options.format.spacing, (Vec3{2, 2, 2}));
  EXPECT_EQ(options.labels, (std::vector<std::int64_t>{3, -7}));
  EXPECT_EQ(options.format.frame, 3);
  EXPECT_EQ(options.format.channel, 4);
  EXPECT_EQ(options.format.series, "1.2.3");
  EXPECT_EQ(options.format.transform, NiftiTransform::qform);
  EXPECT_EQ(options.world, Frame::lps);
  EXPECT_EQ(options.max_bytes, 1024U);
  EXPECT_EQ(options.max_voxels, 99U);
  ASSERT_TRUE(options.crop);
  EXPECT_EQ((*options.crop)[0].end, 2);
}

IsoLevel level_for(const LevelFlags& flags, const Volume& volume) {
  return iso_level(flags, volume, value_range(volume));
}

Volume two_voxels(bool level_set) {
  Volume volume;
  volume.dims = {2, 1, 1};
  volume.values = std::vector<float>{-3.0F, 4.0F};
  volume.level_set = level_set;
  return volume;
}

TEST(IsoLevelOfFlags, IsZeroAndBelowForALevelSet) {
  const IsoLevel level = level_for({}, two_voxels(true));
  EXPECT_EQ(level.iso, 0.0);
  EXPECT_EQ(level.inside, InsideRule::below);
}

TEST(IsoLevelOfFlags, FlagsWinOverTheLevelSet) {
  const IsoLevel level = level_for({.iso = "1", .inside = "above"}, two_voxels(true));
  EXPECT_EQ(level.iso, 1.0);
  EXPECT_EQ(level.inside, InsideRule::above);
}

TEST(IsoLevelOfFlags, TwoValuesHaveTheInsideBetweenThem) {
  for (const bool level_set : {false, true}) {
    const IsoLevel level = level_for({.iso = "-1 2.5", .inside = ""}, two_voxels(level_set));
    EXPECT_EQ(level.iso, -1.0);
    EXPECT_EQ(level.upper, 2.5);
    EXPECT_EQ(level.inside, InsideRule::above);
  }
  EXPECT_EQ(level_for({.iso = "3 3", .inside = ""}, two_voxels(false)).upper, 3.0);
  for (const char* const iso : {"2 1", "1 2 3", "1 inf", "1,5", "nan", "x"})
    EXPECT_THROW(level_for({.iso = iso, .inside = ""}, two_voxels(false)), InvalidArgument) << iso;
  EXPECT_THROW(level_for({.iso = "1 2", .inside = "above"}, two_voxels(false)), InvalidArgument);
}

TEST(IsoLevelOfFlags, TopologyIsTrilinearUnlessSimpleIsAskedFor) {
  EXPECT_EQ(level_for({}, two_voxels(true)).topology, Topology::trilinear);
  LevelFlags flags;
  flags.topology = "simple";
  EXPECT_EQ(level_for(flags, two_voxels(true)).topology, Topology::simple);
}

TEST(IsoLevelOfFlags, ConnectivityTakesThePlaceOfTheTopology) {
  LevelFlags flags;
  for (const auto& [text, topology] :
       {std::pair{"6", Topology::connected_6}, std::pair{"18", Topology::connected_18},
        std::pair{"26", Topology::connected_26}}) {
    flags.connectivity = text;
    EXPECT_EQ(level_for(flags, two_voxels(true)).topology, topology) << text;
  }
}

TEST(IsoLevelOfFlags, IsOneHalfForAMask) {
  Volume mask = two_voxels(false);
  mask.mask = true;
  EXPECT_EQ(level_for({}, mask).iso, 0.5);
  EXPECT_EQ(level_for({}, mask).inside, InsideRule::above);
}

TEST(IsoLevelOfFlags, IsRequiredOtherwiseAndTheMessageStatesTheRange) {
  try {
    level_for({}, two_voxels(false));
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("--iso is required"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("-3 to 4"), std::string::npos);
  }
}

TEST(IsoLevelOfFlags, RefusesAnIsoThatIsNotFinite) {
  EXPECT_THROW(level_for({.iso = "inf", .inside = ""}, two_voxels(false)), InvalidArgument);
}

}  // namespace
}  // namespace isoloop
