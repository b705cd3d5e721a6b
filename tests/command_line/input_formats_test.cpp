// What the formats promise together, kept by the built executable.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "tests/samples/real_data.h"
#include "tests/samples/run_process.h"
#include "tests/samples/scratch_directory.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

using testing::data;

class InputFormats : public ::testing::Test {
 protected:
  Json json_of(Words arguments) const {
    arguments.insert(arguments.end(), {"--json", "-"});
    const ProcessResult result = run_isoloop(scratch_.path(), arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out) : Json();
  }
  ScratchDirectory scratch_;
};

// The same loops, curve by curve, but for the rounding of headers.
void expect_same_loops(const Json& a, const Json& b) {
  EXPECT_EQ(a.at("surface"), b.at("surface"));
  EXPECT_EQ(a.at("betti"), b.at("betti"));
  EXPECT_EQ(a.at("conventions").at("coordinates").at("frame"),
            b.at("conventions").at("coordinates").at("frame"));
  ASSERT_EQ(a.at("loops").size(), b.at("loops").size());
  for (std::size_t i = 0; i < a.at("loops").size(); ++i) {
    const Json& one = a.at("loops")[i];
    const Json& other = b.at("loops")[i];
    EXPECT_EQ(one.at("kind"), other.at("kind"));
    EXPECT_NEAR(one.at("length").get<double>(), other.at("length").get<double>(), 1e-4);
    ASSERT_EQ(one.at("curves").size(), other.at("curves").size());
    for (std::size_t c = 0; c < one.at("curves").size(); ++c) {
      const auto& points = one.at("curves")[c];
      const auto& others = other.at("curves")[c];
      ASSERT_EQ(points.size(), others.size()) << i;
      for (std::size_t p = 0; p < points.size(); ++p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_NEAR(points[p][axis].get<double>(), others[p][axis].get<double>(), 1e-3) << i;
        }
      }
    }
  }
}

TEST_F(InputFormats, OneImageInTwoFormatsHasTheSameLoopsInTheSameWorld) {
  ISOLOOP_NEEDS("formats/FLAIR.nii.gz");
  ISOLOOP_NEEDS("formats/FLAIR.nrrd");
  const Words flags{"--iso", "150", "--world", "ras", "--tighten", "none"};
  Words nifti{"loops", data("formats/FLAIR.nii.gz")};
  Words nrrd{"loops", data("formats/FLAIR.nrrd")};
  nifti.insert(nifti.end(), flags.begin(), flags.end());
  nrrd.insert(nrrd.end(), flags.begin(), flags.end());
  const Json a = json_of(nifti);
  expect_same_loops(a, json_of(nrrd));
  EXPECT_GT(a.at("loops").size(), 0U);
}

TEST_F(InputFormats, OneImageInThreeFormatsHasTheSameLoopsInTheSameWorld) {
  std::vector<Json> all;
  for (const char* name : {"ormir_test_mha.mha", "ormir_test_nii.nii", "ormir_test_nrrd.nrrd"}) {
    const std::string file = std::string("formats/") + name;
    ISOLOOP_NEEDS(file);
    all.push_back(json_of({"loops", data(file), "--iso", "1", "--world", "lps"}));
  }
  expect_same_loops(all[0], all[1]);
  expect_same_loops(all[0], all[2]);
}

TEST_F(InputFormats, TheAtomIsTheSameAsMetaImageAndRaw) {
  ISOLOOP_NEEDS("volumes/hydrogen_128x128x128_uint8.raw");
  ISOLOOP_NEEDS("formats/hydrogenAtom.mha");
  const std::string raw = data("volumes/hydrogen_128x128x128_uint8.raw");
  Json meta = json_of({"loops", data("formats/hydrogenAtom.mha"), "--iso", "15"});
  meta["conventions"]["coordinates"]["frame"] = "index";
  expect_same_loops(meta, json_of({"loops", raw, "--iso", "15"}));
}

TEST_F(InputFormats, EveryFileOfTheDataFolderIsReadOrRefusedWithItsReason) {
  ISOLOOP_NEEDS("formats");
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data("formats"))) {
    const std::string name = entry.path().filename().string();
    const ProcessResult result = run_isoloop(scratch_.path(), {"info", entry.path().string()});
    if (name == "nibabel_example_nifti2.nii.gz") {
      EXPECT_EQ(result.exit_code, 2) << result.err;
      EXPECT_NE(result.err.find("--frame"), std::string::npos) << result.err;
    } else if (name == "tooth.raw") {  // by itself it states no dimensions
      EXPECT_EQ(result.exit_code, 2) << result.err;
    } else {
      EXPECT_EQ(result.exit_code, 0) << result.err;
      ++read;
    }
  }
  EXPECT_EQ(read, 16);
}

TEST_F(InputFormats, LabelsAndConnectivityDecideWhatIsInside) {
  // Two voxels that touch in a corner, of labels 3 and 7.
  std::string voxels(8, '\0');
  voxels[0] = 3;
  voxels[7] = 7;
  scratch_.write("map_2x2x2_uint8.raw", voxels);
  const auto components = [&](const char* connectivity) {
    return json_of(
               {"count", "map_2x2x2_uint8.raw", "--label", "3,7", "--connectivity", connectivity})
        .at("betti")
        .at("b0")
        .get<int>();
  };
  EXPECT_EQ(components("6"), 2);
  EXPECT_EQ(components("18"), 2);
  EXPECT_EQ(components("26"), 1);
  EXPECT_EQ(json_of({"count", "map_2x2x2_uint8.raw", "--label", "7"}).at("betti").at("b0"), 1);
  EXPECT_EQ(
      run_isoloop(scratch_.path(), {"count", "map_2x2x2_uint8.raw", "--label", "5"}).exit_code, 2);
  EXPECT_EQ(run_isoloop(scratch_.path(), {"count", "map_2x2x2_uint8.raw", "--label", "7",
                                          "--topology", "simple", "--connectivity", "6"})
                .exit_code,
            2);
}

TEST_F(InputFormats, ABombOfAnyFormatEndsAtOnceAndNamesTheFlag) {
  std::string nifti(352, '\0');
  nifti[0] = 0x5c;
  nifti[1] = 1;
  for (const int at : {42, 44, 46}) nifti.replace(at, 2, "\xff\x7f");
  nifti[40] = 3;
  nifti[70] = 64;
  nifti[72] = 64;
  nifti.replace(108, 8, std::string("\0\0\xb0\x43\0\0\0\0", 8));
  nifti.replace(344, 4, std::string("n+1\0", 4));
  scratch_.write("bomb.nii", nifti);
  scratch_.write("bomb.nrrd",
                 "NRRD0004\ntype: double\ndimension: 3\nsizes: 99999 99999 99999\nendian: little\n"
                 "encoding: gzip\n\nx");
  scratch_.write("bomb.mha",
                 "NDims = 3\nDimSize = 99999 99999 99999\nElementType = MET_DOUBLE\n"
                 "BinaryData = True\nElementDataFile = LOCAL\nx");
  std::string array =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (99999, 99999, 99999), }\n";
  scratch_.write("bomb.npy", std::string("\x93NUMPY\1\0", 8) + static_cast<char>(array.size()) +
                                 '\0' + array + "x");
  scratch_.write("bomb.vti",
                 "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 99999 0 99999 0 99999\">"
                 "<Piece Extent=\"0 99999 0 99999 0 99999\"><PointData><DataArray "
                 "type=\"Float64\" Name=\"a\" format=\"binary\">AAAA</DataArray></PointData>"
                 "</Piece></ImageData></VTKFile>");
  // A page of 2^20 x 2^20 doubles: little-endian, seven entries, one strip of one byte.
  std::string tiff("II*\0\x08\0\0\0\x07\0", 10);
  const auto entry = [&](int tag, std::uint32_t value) {
    tiff += static_cast<char>(tag & 255);
    tiff += static_cast<char>(tag >> 8);
    tiff += std::string("\4\0\1\0\0\0", 6);
    for (int shift = 0; shift < 32; shift += 8) tiff += static_cast<char>(value >> shift & 255);
  };
  entry(256, 1U << 20);
  entry(257, 1U << 20);
  entry(258, 64);
  entry(262, 1);
  entry(273, 0);
  entry(279, 1);
  entry(339, 3);
  tiff += std::string(4, '\0');
  scratch_.write("bomb.tif", tiff);
#ifdef __SANITIZE_ADDRESS__
  const std::int64_t most_kib = 200 * 1024;  // AddressSanitizer's own share
#else
  const std::int64_t most_kib = 100 * 1024;
#endif
  for (const char* name :
       {"bomb.nii", "bomb.nrrd", "bomb.mha", "bomb.npy", "bomb.vti", "bomb.tif"}) {
    rusage before{};
    rusage after{};
    getrusage(RUSAGE_CHILDREN, &before);
    const ProcessResult result = run_isoloop(scratch_.path(), {"info", name});
    getrusage(RUSAGE_CHILDREN, &after);
    EXPECT_EQ(result.exit_code, 4) << name << result.err;
    EXPECT_NE(result.err.find("--max-memory"), std::string::npos) << result.err;
    const auto seconds = [](const rusage& use) {
      return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
             1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
    };
    EXPECT_LT(seconds(after) - seconds(before), 0.2) << name;
    // KiB, of the largest child so far, which may be another test's.
    EXPECT_LE(after.ru_maxrss, std::max<std::int64_t>(most_kib, before.ru_maxrss)) << name;
  }
}

}  // namespace
}  // namespace isoloop
