#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "tests/samples/damaged_files.h"
#include "tests/samples/tiff_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/slices/tiff.h"

namespace isoloop {
namespace {

using test::contains;
using test::message_of;
using test::ome_xml;
using test::TempFolder;
using test::TiffSample;
using test::write_bytes;
using Planes = std::vector<int>;

const std::string imagej = "ImageJ=1.53\n";

using Advices = std::vector<Advice>;

class TiffAxes : public ::testing::Test {
 protected:
  std::string bytes_of(int pages, const std::string& description, float per_unit = 0.0F) const {
    return test::tiff_bytes({.pages = pages, .description = description, .per_unit = per_unit},
                            folder_ / "written");
  }
  Volume read(const std::string& bytes, const FormatOptions& options = {}) const {
    write_bytes(folder_ / "a.tif", bytes);
    return read_tiff(folder_ / "a.tif", options);
  }
  /// The pages that the slices are read from.
  Planes planes(const std::string& bytes, const FormatOptions& options = {}) const {
    const Volume volume = read(bytes, options);
    const auto& values = std::get<std::vector<std::uint16_t>>(volume.values);
    Planes pages;
    for (std::size_t i = 0; i < values.size(); i += 20) {
      EXPECT_EQ(values[i + 19], values[i] + 19);
      pages.push_back(values[i] / 100);
    }
    return pages;
  }
  std::string choice(const std::string& bytes, const FormatOptions& options = {}) const {
    return message_of<InvalidArgument>([&] { read(bytes, options); });
  }
  std::vector<Advice> advice(const std::string& bytes, const FormatOptions& options = {}) const {
    return test::error_of<InvalidArgument>([&] { read(bytes, options); }).finding.advice;
  }
  std::string refusal(int pages, const std::string& description) const {
    return message_of<InvalidInput>([&] { read(bytes_of(pages, description)); });
  }
  TempFolder folder_;
};

TEST_F(TiffAxes, ImageJStatesChannelsSlicesAndFramesTheFirstFastest) {
  const std::string file = bytes_of(12, imagej + "images=12\nchannels=2\nslices=3\nframes=2\n");
  EXPECT_TRUE(contains(choice(file), "holds 2 channels, 3 slices, 2 frames")) << choice(file);
  EXPECT_EQ(advice(file), Advices{Advice::choose_frame_and_channel});
  EXPECT_EQ(advice(file, {.frame = 0}), Advices{Advice::choose_channel});
  EXPECT_EQ(advice(file, {.channel = 0}), Advices{Advice::choose_frame});
  EXPECT_EQ(planes(file, {.frame = 0, .channel = 0}), (Planes{0, 2, 4}));
  EXPECT_EQ(planes(file, {.frame = 1, .channel = 1}), (Planes{7, 9, 11}));
  EXPECT_TRUE(contains(choice(file, {.frame = 2, .channel = 0}),
                       "the frame counts from 0 to 1: there is no 2"));
  EXPECT_TRUE(contains(choice(file, {.frame = 0, .channel = 2}),
                       "the channel counts from 0 to 1: there is no 2"));
}

TEST_F(TiffAxes, ImageJsOrderIsFollowed) {
  const std::string text = imagej + "images=12\nchannels=2\nslices=3\nframes=2\norder=";
  EXPECT_EQ(planes(bytes_of(12, text + "zct\n"), {.frame = 0, .channel = 1}), (Planes{3, 4, 5}));
  EXPECT_EQ(planes(bytes_of(12, text + "xyctz\n"), {.frame = 1, .channel = 0}), (Planes{2, 6, 10}));
  EXPECT_TRUE(contains(refusal(12, text + "zcc\n"), "order=zcc"));
}

TEST_F(TiffAxes, AShapeIsFoundWhereverItStandsAndHoweverItIsWritten) {
  for (const char* text :
       {R"({"axes": "CZYX", "shape": [2, 3, 4, 5]})", R"({"axes":"czyx","shape":[2,3,4,5]})"})
    EXPECT_EQ(planes(bytes_of(6, text), {.channel = 1}), (Planes{3, 4, 5})) << text;
  EXPECT_EQ(planes(bytes_of(6, "shape=(2,3,4,5)"), {.frame = 1}), (Planes{3, 4, 5}));
  const Volume odd = read(bytes_of(3, R"({"shape": [3, 4, 5], "axes": "XYZ"})"));
  ASSERT_EQ(odd.warnings.size(), 1U);
  EXPECT_TRUE(contains(odd.warnings[0].text, "axes XYZ, which are not those of its shape"));
}

TEST_F(TiffAxes, OneChannelNeedsNoChoice) {
  const std::string file = bytes_of(3, imagej + "images=3\nslices=3\n");
  EXPECT_EQ(planes(file), (Planes{0, 1, 2}));
  EXPECT_EQ(planes(file, {.frame = 0, .channel = 0}), (Planes{0, 1, 2}));
  EXPECT_TRUE(
      contains(choice(file, {.channel = 1}), "the channel counts from 0 to 0: there is no 1"));
}

TEST_F(TiffAxes, FramesOfOneSliceAreSlicesUnlessOneIsAskedFor) {
  const std::string file = bytes_of(3, imagej + "images=3\nframes=3\n");
  EXPECT_EQ(planes(file), (Planes{0, 1, 2}));
  EXPECT_TRUE(contains(read(file).notes.at(0).text, "3 frames of one slice"));
  EXPECT_EQ(planes(file, {.frame = 2}), (Planes{2}));
}

TEST_F(TiffAxes, DescriptionsThatContradictThePagesAreRefusedOrWarnedOf) {
  EXPECT_TRUE(contains(refusal(5, imagej + "images=5\nchannels=2\nslices=2\n"), "not fill"));
  EXPECT_TRUE(contains(refusal(2, imagej + "images=0\n"), "images=0"));
  EXPECT_TRUE(contains(refusal(2, imagej + "images=2\nslices=99999999999\n"), "slices="));
  const Volume more = read(bytes_of(4, imagej + "images=2\nslices=2\n"));
  EXPECT_EQ(more.dims[2], 4);
  EXPECT_TRUE(contains(more.warnings.at(0).text, "2 slices, but it holds 4 pages"));
}

TEST_F(TiffAxes, ShapedFilesOfFourDimensionsAreChosenByEitherFlag) {
  const std::string file = bytes_of(6, R"({"shape": [2, 3, 4, 5]})");
  EXPECT_TRUE(contains(choice(file), "holds 2 volumes (an axis without a name), 3 slices"))
      << choice(file);
  EXPECT_EQ(advice(file), (Advices{Advice::choose_frame, Advice::choose_channel}));
  EXPECT_EQ(planes(file, {.frame = 1}), (Planes{3, 4, 5}));
  EXPECT_EQ(planes(file, {.channel = 1}), (Planes{3, 4, 5}));
  EXPECT_TRUE(contains(choice(file, {.frame = 0, .channel = 0}), "not two"));
}

TEST_F(TiffAxes, ShapedFilesMayNameTheirAxes) {
  const std::string file = bytes_of(12, R"({"shape": [2, 3, 2, 4, 5], "axes": "TZCYX"})");
  EXPECT_EQ(planes(file, {.frame = 1, .channel = 1}), (Planes{7, 9, 11}));
  const std::string odd = bytes_of(8, R"({"shape": [2, 2, 2, 4, 5], "axes": "TQZYX"})");
  EXPECT_EQ(advice(odd), Advices{Advice::choose_frame_and_channel});
  EXPECT_EQ(advice(odd, {.frame = 1}), Advices{Advice::choose_channel});
  EXPECT_EQ(planes(odd, {.frame = 1, .channel = 1}), (Planes{6, 7}));
  EXPECT_TRUE(contains(refusal(8, R"({"shape": [2, 2, 2, 4, 5]})"), "2 x 2 x 2 planes"));
}

TEST_F(TiffAxes, ShapedFilesOfOneVolumeAreReadAsTheyAre) {
  for (const char* shape : {"[3, 4, 5]", "[1, 3, 4, 5]", "[3, 4, 5, 1]", "[4, 5]"}) {
    const std::string json = std::string(R"({"shape": )") + shape + "}";
    EXPECT_EQ(planes(bytes_of(3, json)), (Planes{0, 1, 2})) << shape;
  }
  EXPECT_EQ(planes(bytes_of(4, R"({"shape": [2, 4, 5]})"), {.frame = 1}), (Planes{2, 3}));
  const Volume other = read(bytes_of(2, R"({"shape": [2, 9, 9]})"));
  EXPECT_EQ(other.dims[2], 2);
  EXPECT_TRUE(contains(other.warnings.at(0).text, "not that of its pages"));
  EXPECT_TRUE(contains(refusal(3, R"({"shape": [2, 4, 5]})"), "states 2 planes"));
  EXPECT_TRUE(contains(refusal(3, R"({"shape": [-2, 4, 5]})"), "shape that is none"));
}

TEST_F(TiffAxes, OmeStatesTheOrderOfItsPlanes) {
  for (const auto& [order, second] : std::vector<std::pair<std::string, Planes>>{
           {"XYCZT", {1, 4}}, {"XYZCT", {2, 3}}, {"XYTCZ", {1, 4}}, {"XYZTC", {2, 3}}}) {
    const std::string file = bytes_of(6, ome_xml("DimensionOrder=\"" + order + "\""));
    EXPECT_TRUE(contains(choice(file), "3 channels, 2 slices"));
    EXPECT_EQ(advice(file), Advices{Advice::choose_channel});
    EXPECT_EQ(planes(file, {.channel = 1}), second) << order;
  }
}

TEST_F(TiffAxes, OmePlanesLieWhereTiffDataPutsThem) {
  const std::string order = "DimensionOrder=\"XYCZT\"";
  const std::string blocks =
      "<TiffData IFD=\"3\" FirstZ=\"0\" PlaneCount=\"3\"/><TiffData IFD=\"2\" FirstZ=\"1\"/>"
      "<TiffData IFD=\"1\" FirstZ=\"1\" FirstC=\"1\"><UUID FileName=\"a\">u</UUID></TiffData>"
      "<TiffData IFD=\"0\" FirstZ=\"1\" FirstC=\"2\"/>";
  EXPECT_EQ(planes(bytes_of(6, ome_xml(order, blocks)), {.channel = 0}), (Planes{3, 2}));
  EXPECT_EQ(planes(bytes_of(6, ome_xml(order, blocks)), {.channel = 2}), (Planes{5, 0}));
  EXPECT_EQ(planes(bytes_of(6, ome_xml(order, "<TiffData/>")), {.channel = 1}), (Planes{1, 4}));
  EXPECT_TRUE(contains(refusal(6, ome_xml(order, "<TiffData IFD=\"0\"/>")), "plane 1 on no page"));
  EXPECT_TRUE(contains(refusal(6, ome_xml(order, "<TiffData/><TiffData IFD=\"0\"/>")),
                       "plane 0 on two pages"));
  EXPECT_TRUE(contains(refusal(6, ome_xml(order, "<TiffData IFD=\"6\"/>")), "IFD 6"));
}

TEST_F(TiffAxes, OmeThatIsNotOnePageForEachPlaneIsRefusedInASentence) {
  const std::string order = "DimensionOrder=\"XYCZT\"";
  EXPECT_TRUE(contains(refusal(5, ome_xml(order)), "6 planes but holds 5 pages"));
  EXPECT_TRUE(contains(refusal(6, ome_xml(order + " Interleaved=\"true\"")), "interleaved"));
  EXPECT_TRUE(
      contains(refusal(6, ome_xml(order, "<Channel SamplesPerPixel=\"3\"/>")), "interleaved"));
  EXPECT_TRUE(contains(refusal(6, ome_xml(order,
                                          "<TiffData><UUID>a</UUID></TiffData>"
                                          "<TiffData><UUID>b</UUID></TiffData>")),
                       "one of 2 files"));
  EXPECT_TRUE(contains(refusal(6, ome_xml(order,
                                          "<TiffData><UUID FileName=\"a\"/></TiffData>"
                                          "<TiffData><UUID FileName=\"b\"/></TiffData>")),
                       "one of 2 files"));
  EXPECT_TRUE(contains(refusal(6, ome_xml("DimensionOrder=\"XYCZ\"")), "order 'XYCZ'"));
  EXPECT_TRUE(contains(refusal(6, ome_xml(order).substr(0, 200)), "XML"));
  EXPECT_TRUE(contains(refusal(1, "<OME><BinaryOnly MetadataFile=\"m.ome\"/></OME>"), "m.ome"));
  const Volume more = read(bytes_of(7, ome_xml(order)), {.channel = 0});
  EXPECT_TRUE(contains(more.warnings.at(0).text, "1 of its pages are no planes"));
}

TEST_F(TiffAxes, OmeStatesSpacingAndUnit) {
  const std::string order = "DimensionOrder=\"XYCZT\" ";
  const auto placed = [&](const std::string& sizes, const FormatOptions& options = {.channel = 0}) {
    return read(bytes_of(6, ome_xml(order + sizes)), options);
  };
  Volume volume = placed(
      "PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.25\" PhysicalSizeZ=\"2000\" "
      "PhysicalSizeZUnit=\"nm\"");
  EXPECT_EQ(volume.spacing, (Vec3{0.5, 0.25, 2}));
  EXPECT_EQ(volume.unit, "µm");
  EXPECT_TRUE(volume.warnings.empty());
  volume = placed("PhysicalSizeX=\"0.5\" PhysicalSizeXUnit=\"mm\"");
  EXPECT_EQ(volume.spacing, (Vec3{0.5, 0.5, 0.5}));
  EXPECT_EQ(volume.unit, "mm");
  EXPECT_EQ(volume.warnings.size(), 2U);
  volume = placed("PhysicalSizeX=\"0.5\" PhysicalSizeXUnit=\"pixel\"");
  EXPECT_EQ(volume.spacing, (Vec3{1, 1, 1}));
  EXPECT_TRUE(contains(volume.warnings.at(0).text, "'pixel'"));
  volume = placed("PhysicalSizeX=\"0.5\"", {.channel = 0, .spacing = Vec3{1, 2, 3}});
  EXPECT_EQ(volume.spacing, (Vec3{1, 2, 3}));
  EXPECT_EQ(volume.unit, "");
}

TEST_F(TiffAxes, ImageJStatesSpacingAndUnit) {
  const std::string two = imagej + "images=2\nslices=2\n";
  Volume volume = read(bytes_of(2, two + "spacing=2.5\nunit=\\u00B5m\n", 4.0F));
  EXPECT_EQ(volume.spacing, (Vec3{0.25, 0.25, 2.5}));
  EXPECT_EQ(volume.unit, "µm");
  volume = read(bytes_of(2, two + "unit=mm\n", 4.0F));
  EXPECT_EQ(volume.spacing, (Vec3{0.25, 0.25, 1}));
  EXPECT_TRUE(contains(volume.warnings.at(0).text, "no distance between slices"));
  volume = read(bytes_of(2, two, 300.0F));  // of a printer
  EXPECT_EQ(volume.spacing, (Vec3{1, 1, 1}));
  EXPECT_EQ(volume.unit, "");
  EXPECT_TRUE(contains(read(bytes_of(2, two + "spacing=0\n")).warnings.at(0).text, "no length"));
}

TEST_F(TiffAxes, PlanesBehindOnePageAreRead) {
  for (const std::string& text : {imagej + "images=6\nchannels=2\nslices=3\n",
                                  std::string(R"({"shape": [2, 3, 4, 5], "truncated": true})")}) {
    const std::string file = test::one_page_tiff_bytes(6, text);
    const bool by_channel = text.starts_with(imagej);
    EXPECT_EQ(planes(file, {.channel = 1}), by_channel ? (Planes{1, 3, 5}) : (Planes{3, 4, 5}));
    const auto path = folder_ / "cut.tif";
    test::expect_no_beginning_is_read(path, file, [&] { read_tiff(path, {.channel = 0}); });
  }
}

TEST_F(TiffAxes, SlicesWithinAPageAreRead) {
  for (const std::uint16_t compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE}) {
    TiffSample sample{.compression = compression, .tiled = true, .pages = 1, .depth = 3};
    const std::string file = test::tiff_bytes(sample, folder_ / "written");
    EXPECT_EQ(planes(file), (Planes{0, 1, 2}));
    const auto path = folder_ / "cut.tif";
    test::expect_no_beginning_is_read(path, file, [&] { read_tiff(path); });
    sample.pages = 2;
    const std::string two = test::tiff_bytes(sample, folder_ / "written");
    EXPECT_EQ(planes(two), (Planes{0, 1, 2, 3, 4, 5}));
  }
}

TEST_F(TiffAxes, FlippedBytesOfATileOfSlicesAreNoticedOrHarmless) {
  const std::string whole = test::tiff_bytes(
      {.compression = COMPRESSION_ADOBE_DEFLATE, .tiled = true, .pages = 1, .depth = 3},
      folder_ / "written");
  test::expect_flipped_bytes_are_noticed_or_harmless(whole, 1, [&](const std::string& bytes) {
    write_bytes(folder_ / "a.tif", bytes);
    return read_tiff(folder_ / "a.tif", {}, {.max_bytes = 1 << 20});
  });
}

TEST_F(TiffAxes, NoFileWithAxesCutShortIsRead) {
  for (const std::string& text :
       {ome_xml("DimensionOrder=\"XYCZT\""), imagej + "images=6\nchannels=3\nslices=2\n",
        std::string(R"({"shape": [3, 2, 4, 5]})")}) {
    const auto path = folder_ / "cut.tif";
    test::expect_no_beginning_is_read(path, bytes_of(6, text),
                                      [&] { read_tiff(path, {.channel = 0}); });
  }
}

struct KnownFile {
  const char* name;
  FormatOptions options;
  std::int64_t cavities;
};

TEST(TiffAxesData, EveryOddFileHasItsKnownCounts) {
  for (const KnownFile& file : std::vector<KnownFile>{{"odd/ome_zc.ome.tif", {.channel = 0}, 1},
                                                      {"odd/plain4d.tif", {.frame = 0}, 1},
                                                      {"odd/plain4d.tif", {.channel = 0}, 1},
                                                      {"odd/one_c.tif", {}, 1},
                                                      {"odd/imagedepth.tif", {}, 0},
                                                      {"odd/imagej_one_page.tif", {}, 1}}) {
    ISOLOOP_NEEDS(file.name);
    const Volume volume = read_tiff(test::data(file.name), file.options);
    const Betti betti = count_topology(view(volume), {100.0, InsideRule::above}).betti;
    EXPECT_EQ(betti.b0, 2) << file.name;
    EXPECT_EQ(betti.b1, 3) << file.name;
    EXPECT_EQ(betti.b2, file.cavities) << file.name;
  }
}

TEST(TiffAxesData, AFileOfSeveralVolumesListsItsAxes) {
  ISOLOOP_NEEDS("odd/ome_zc.ome.tif");
  const auto error =
      test::error_of<InvalidArgument>([] { read_tiff(test::data("odd/ome_zc.ome.tif")); });
  EXPECT_TRUE(contains(error.what(), "2 channels, 16 slices")) << error.what();
  EXPECT_EQ(error.finding.advice, Advices{Advice::choose_channel});
}

TEST(TiffAxesData, TheSpacingIsTheFilesOwn) {
  for (const char* name : {"odd/one_c.tif", "odd/ome_zc.ome.tif"}) {
    ISOLOOP_NEEDS(name);
    const Volume volume = read_tiff(test::data(name), {.channel = 0});
    EXPECT_EQ(volume.spacing, (Vec3{0.5, 0.5, 2})) << name;
    EXPECT_EQ(volume.unit, "µm") << name;
  }
}

}  // namespace
}  // namespace isoloop
