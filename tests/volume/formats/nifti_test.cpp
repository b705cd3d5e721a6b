#include "volume/formats/nifti.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/byte_samples.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/nifti_samples.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::nifti_2_file;
using test::NiftiSample;
using test::TempFolder;
using test::write_bytes;

class Nifti : public ::testing::Test {
 protected:
  Volume read(const std::string& bytes, const FormatOptions& options = {},
              const VoxelLimits& limits = {}) const {
    write_bytes(folder_ / "a.nii", bytes);
    return read_nifti(folder_ / "a.nii", options, limits);
  }
  std::string refusal(const std::string& bytes, const FormatOptions& options = {}) const {
    return message_of<InvalidInput>([&] { read(bytes, options); });
  }
  TempFolder folder_;
};

TEST_F(Nifti, BothByteOrdersBothVersionsAndGzipHoldTheSameVoxels) {
  std::vector<std::int16_t> expected;
  for (std::int16_t i = 0; i < 12; ++i) expected.push_back(i);
  for (const Endian endian : {Endian::little, Endian::big}) {
    const std::string file = NiftiSample{.endian = endian}.file();
    for (const std::string& bytes : {file, test::gzip_bytes(file)}) {
      const Volume volume = read(bytes);
      EXPECT_EQ(volume.dims, (Index3{3, 2, 2}));
      EXPECT_EQ(std::get<std::vector<std::int16_t>>(volume.values), expected);
    }
    const Volume second = read(nifti_2_file(endian, 1));
    EXPECT_EQ(std::get<std::vector<std::uint8_t>>(second.values),
              (std::vector<std::uint8_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(second.spacing, (Vec3{2, 3, 4}));
  }
}

TEST_F(Nifti, APairIsReadByEitherName) {
  NiftiSample pair{.from = 2, .magic = {"ni1\0", 4}};
  write_bytes(folder_ / "a.hdr", pair.header().substr(0, 348));
  write_bytes(folder_ / "a.img", "xx" + pair.voxels());
  for (const char* name : {"a.hdr", "a.img"}) {
    EXPECT_EQ(read_nifti(folder_ / name).dims, (Index3{3, 2, 2})) << name;
  }
  write_bytes(folder_ / "b.hdr.gz", test::gzip_bytes(pair.header()));
  write_bytes(folder_ / "b.img.gz", test::gzip_bytes("xx" + pair.voxels()));
  for (const char* name : {"b.hdr.gz", "b.img.gz"}) {
    EXPECT_EQ(read_nifti(folder_ / name).dims, (Index3{3, 2, 2})) << name;
  }
  write_bytes(folder_ / "c.hdr", pair.header());
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { read_nifti(folder_ / "c.hdr"); }), "c.img"));
}

TEST_F(Nifti, ExtensionsBeforeTheVoxelsArePassedOver) {
  NiftiSample sample{.from = 352 + 16};
  std::string header = sample.header();
  header[348] = 1;
  const std::string extension = std::string("\x10\0\0\0\6\0\0\0", 8) + "comment.";
  EXPECT_EQ(read(header + extension + sample.voxels()).values, read(NiftiSample{}.file()).values);
}

TEST_F(Nifti, AnAxisOfNoneBeyondTheThirdIsNotThere) {
  const NiftiSample sample{.dim = {4, 3, 2, 2, 0, 0, 0, 0}};
  std::string file = sample.header() + NiftiSample{}.voxels();
  EXPECT_EQ(read(file).values, read(NiftiSample{}.file()).values);
  EXPECT_THROW(read(file + file), InvalidInput);
}

TEST_F(Nifti, NoFileCutShortIsRead) {
  for (const std::string& file : {NiftiSample{}.file(), nifti_2_file(Endian::big, 1)}) {
    for (const std::string& bytes : {file, test::gzip_bytes(file)}) {
      const auto path = folder_ / "cut.nii";
      test::expect_no_beginning_is_read(path, bytes, [&] { read_nifti(path); });
    }
  }
}

TEST_F(Nifti, NoPairCutShortIsRead) {
  const NiftiSample pair{.from = 0, .magic = {"ni1\0", 4}};
  const auto read_pair = [&] { read_nifti(folder_ / "p.hdr"); };
  write_bytes(folder_ / "p.img", pair.voxels());
  for (const std::string& header :
       {pair.header().substr(0, 348), test::gzip_bytes(pair.header())}) {
    test::expect_no_beginning_is_read(folder_ / "p.hdr", header, read_pair);
  }
  for (const std::string& voxels : {pair.voxels(), test::gzip_bytes(pair.voxels())}) {
    test::expect_no_beginning_is_read(folder_ / "p.img", voxels, read_pair);
  }
  for (const std::size_t length : {349U, 350U, 351U}) {
    write_bytes(folder_ / "p.hdr", pair.header().substr(0, length));
    EXPECT_THROW(read_pair(), InvalidInput) << length;
  }
}

TEST_F(Nifti, BytesTooManyAreRefused) {
  EXPECT_TRUE(contains(refusal(NiftiSample{}.file() + "x"), "more bytes"));
  EXPECT_TRUE(contains(refusal(test::gzip_bytes(NiftiSample{}.file() + "x")), "more bytes"));
  EXPECT_TRUE(
      contains(refusal(test::gzip_bytes(NiftiSample{}.file()) + "x"), "other bytes follow"));
}

TEST_F(Nifti, GzipMembersInARowAreOneStream) {
  const std::string file = NiftiSample{}.file();
  const std::string first = test::gzip_bytes(file.substr(0, 360));
  const std::string second = test::gzip_bytes(file.substr(360));
  EXPECT_EQ(read(first + second).values, read(file).values);
  EXPECT_THROW(read(first + second.substr(0, second.size() - 1)), InvalidInput);
}

TEST_F(Nifti, DamagedCompressedBytesAreRefusedUnlessTheyChangeNothing) {
  const std::string whole = test::gzip_bytes(NiftiSample{}.file());
  const VoxelArray expected = read(whole).values;
  std::size_t refused = 0;
  for (std::size_t at = 10; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    try {
      EXPECT_EQ(read(damaged).values, expected) << at;
    } catch (const InvalidInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, (whole.size() - 10) * 9 / 10);
}

TEST_F(Nifti, SlopeAndInterceptApply) {
  const Volume scaled = read(NiftiSample{.slope = 0.5F, .intercept = -1.0F}.file());
  EXPECT_EQ(std::get<std::vector<float>>(scaled.values)[3], 0.5F);
  const Volume whole = read(NiftiSample{.slope = 2.0F, .intercept = -1024.0F}.file());
  EXPECT_EQ(std::get<std::vector<std::int16_t>>(whole.values)[3], -1018);
  EXPECT_EQ(type_name(read(NiftiSample{.slope = 1.0F}.file()).values), "int16");
  // A slope of 0 or NaN stands for none.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(type_name(read(NiftiSample{.slope = 0, .intercept = 7}.file()).values), "int16");
  EXPECT_EQ(type_name(read(NiftiSample{.slope = nan, .intercept = nan}.file()).values), "int16");
  EXPECT_THROW(read(NiftiSample{.slope = 2, .intercept = nan}.file()), InvalidInput);
}

TEST_F(Nifti, AFrameOfAFourDimensionalFileIsChosen) {
  const std::string file = nifti_2_file(Endian::little, 3);
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { read(file); }).option, Option::frame);
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(read(file, {.frame = 1}).values).front(), 8);
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(read(file, {.frame = 2}).values).back(), 23);
  EXPECT_THROW(read(file, {.frame = 3}), InvalidArgument);
  EXPECT_THROW(read(file, {.frame = -1}), InvalidArgument);
  // All frames must be there, not only the one asked for.
  EXPECT_THROW(read(file.substr(0, file.size() - 1), {.frame = 0}), InvalidInput);
}

TEST_F(Nifti, VoxelsThatAreNoNumbersAreRefusedByName) {
  EXPECT_TRUE(contains(refusal(NiftiSample{.type = 128, .bits = 24}.file()), "RGB"));
  EXPECT_TRUE(contains(refusal(NiftiSample{.type = 32, .bits = 64}.file()), "complex"));
  EXPECT_TRUE(contains(refusal(NiftiSample{.dim = {5, 3, 2, 2, 1, 3, 1, 1}}.file()), "vector"));
  EXPECT_TRUE(contains(refusal(NiftiSample{.type = 1536, .bits = 128}.file()), "1536"));
  EXPECT_TRUE(contains(refusal(NiftiSample{.bits = 8}.file()), "bits"));
}

TEST_F(Nifti, HeadersThatMakeNoSenseAreRefused) {
  EXPECT_THROW(read(NiftiSample{.dim = {3, 3, 0, 2, 1, 1, 1, 1}}.file()), InvalidInput);
  EXPECT_THROW(read(NiftiSample{.dim = {3, 3, -2, 2, 1, 1, 1, 1}}.file()), InvalidInput);
  EXPECT_THROW(read(NiftiSample{.dim = {0, 3, 2, 2, 1, 1, 1, 1}}.file()), InvalidInput);
  EXPECT_THROW(read(NiftiSample{.dim = {8, 3, 2, 2, 1, 1, 1, 1}}.file()), InvalidInput);
  for (const float from : {0.0F, -1.0F, 352.5F, 1e30F, std::nanf("")}) {
    EXPECT_THROW(read(NiftiSample{.from = from}.file()), InvalidInput) << from;
  }
  EXPECT_TRUE(contains(refusal(NiftiSample{.magic = {"\0\0\0\0", 4}}.file()), "ANALYZE"));
  EXPECT_TRUE(contains(refusal(std::string(400, 'x')), "348"));
}

TEST_F(Nifti, TheSformComesBeforeTheQform) {
  NiftiSample file{.qform = 1,
                   .sform = 2,
                   .quaternion = {0, 0, 0, 10, 20, 30},
                   .rows = {-2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 4, 7}};
  const Volume by_sform = read(file.file());
  EXPECT_EQ(by_sform.frame, Frame::ras);
  EXPECT_EQ(by_sform.origin, (Vec3{5, 6, 7}));
  EXPECT_EQ(by_sform.direction[0], (Vec3{-1, 0, 0}));
  EXPECT_TRUE(contains(by_sform.notes.at(0).text, "sform"));
  ASSERT_EQ(by_sform.warnings.size(), 1U);
  EXPECT_TRUE(test::advises(by_sform.warnings[0], Advice::choose_qform));
  const Volume by_qform = read(file.file(), {.transform = NiftiTransform::qform});
  EXPECT_EQ(by_qform.origin, (Vec3{10, 20, 30}));
  EXPECT_EQ(by_qform.spacing, (Vec3{2, 3, 4}));
  EXPECT_TRUE(contains(by_qform.notes.at(0).text, "qform"));
  file.quaternion = {0, 1, 0, 5, 6, 7};
  file.pixdim[0] = -1;
  EXPECT_TRUE(read(file.file()).warnings.empty());
  file.sform = 0;
  EXPECT_EQ(read(file.file()).direction, by_sform.direction);
  EXPECT_THROW(read(file.file(), {.transform = NiftiTransform::sform}), InvalidArgument);
  file.qform = 0;
  EXPECT_EQ(read(file.file()).frame, Frame::index);
}

TEST_F(Nifti, SpacingsThatAreNoneAreRefusedAndMayBeReplaced) {
  EXPECT_TRUE(contains(refusal(NiftiSample{.pixdim = {1, 2, -3, 4}}.file()), "length of 3"));
  EXPECT_TRUE(contains(refusal(NiftiSample{.pixdim = {1, 2, 0, 4}}.file()), "spacing 0 along y"));
  EXPECT_TRUE(contains(refusal(NiftiSample{.pixdim = {1, 2, std::nanf(""), 4}}.file()), "nan"));
  const Volume volume =
      read(NiftiSample{.pixdim = {1, 2, -3, 4}}.file(), {.spacing = Vec3{1, 2, 3}});
  EXPECT_EQ(volume.spacing, (Vec3{1, 2, 3}));
  EXPECT_EQ(volume.frame, Frame::index);
}

TEST_F(Nifti, AShearedSformIsRefusedWithBothReadings) {
  NiftiSample file{.sform = 2, .rows = {2, 1, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0}};
  EXPECT_TRUE(contains(refusal(file.file()), "sheared"));
  EXPECT_TRUE(contains(refusal(file.file()), "degrees"));
  file.qform = 1;
  EXPECT_TRUE(test::advises(test::error_of<InvalidInput>([&] { read(file.file()); }).finding,
                            Advice::choose_qform));
  EXPECT_EQ(read(file.file(), {.transform = NiftiTransform::qform}).spacing, (Vec3{2, 3, 4}));
}

TEST_F(Nifti, ABombIsRefusedBeforeMemoryIsAskedFor) {
  NiftiSample bomb{.dim = {3, 32767, 32767, 32767, 1, 1, 1, 1}};
  const std::string bytes = bomb.header() + std::string(16, '\0');
  for (const std::string& file : {bytes, test::gzip_bytes(bytes)}) {
    write_bytes(folder_ / "a.nii", file);
    EXPECT_EQ(test::error_of<LimitExceeded>([&] { read(file); }).excess.unit, Excess::Unit::bytes);
    EXPECT_EQ(test::error_of<LimitExceeded>([&] {
                read(file, {}, {.max_bytes = 0, .max_voxels = 1000});
              }).excess.unit,
              Excess::Unit::voxels);
    // Whatever is allowed, the bytes are not there.
    EXPECT_THROW(read(file, {}, {.max_bytes = ~std::uint64_t{0}}), InvalidInput);
  }
}

TEST_F(Nifti, IntegersOf64BitsAreReadIfTheyFit) {
  NiftiSample wide{.dim = {1, 2, 1, 1, 1, 1, 1, 1}, .type = 1024, .bits = 64};
  const auto file = [&](std::int64_t value) {
    return wide.header() + test::number_bytes(value, Endian::little) +
           test::number_bytes(std::int64_t{-7}, Endian::little);
  };
  EXPECT_EQ(std::get<std::vector<std::int32_t>>(read(file(70000)).values),
            (std::vector<std::int32_t>{70000, -7}));
  EXPECT_TRUE(contains(refusal(file(std::int64_t{1} << 31)), "2147483648"));
}

TEST(NiftiData, EveryFileOfTheDataFolderIsRead) {
  ISOLOOP_NEEDS("formats/FLAIR.nii.gz");
  struct Known {
    const char* name;
    Index3 dims;
    const char* type;
  };
  for (const auto& [name, dims, type] :
       {Known{"FLAIR.nii.gz", {124, 160, 140}, "uint8"},
        Known{"avg152T1_RL_nifti.nii.gz", {91, 109, 91}, "uint8"},
        Known{"chris_MRA.nii.gz", {200, 256, 120}, "uint8"},
        Known{"hippo.nii.gz", {91, 109, 91}, "float32"},
        Known{"nibabel_anatomical.nii", {33, 41, 25}, "int16"},
        Known{"ormir_test_nii.nii", {25, 25, 25}, "uint8"},
        Known{"someones_anatomy.nii.gz", {57, 67, 56}, "float32"}}) {
    const Volume volume = read_nifti(test::data(std::string("formats/") + name));
    EXPECT_EQ(volume.dims, dims) << name;
    EXPECT_EQ(type_name(volume.values), type) << name;
    EXPECT_EQ(volume.frame, Frame::ras) << name;
    EXPECT_TRUE(volume.warnings.empty()) << name;
  }
  const auto four_d = test::data("formats/nibabel_example_nifti2.nii.gz");
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { read_nifti(four_d); }).option, Option::frame);
  EXPECT_EQ(read_nifti(four_d, {.frame = 1}).dims, (Index3{32, 20, 12}));
}

}  // namespace
}  // namespace isoloop
