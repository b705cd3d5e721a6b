#include "volume/vdb/vdb_message.h"

#include <array>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/volume_test_files.h"

namespace isoloop {
namespace {

VdbHeader small_header() {
  VdbHeader header;
  header.volume.dims = {5, 9, 3};
  header.volume.spacing = {0.5, 1.0, 2.0};
  header.volume.origin = {-1.0, 0.0, 7.0};
  header.volume.frame = Frame::world;
  header.volume.name = "density";
  header.background = -1.0;
  return header;
}

std::array<float, leaf_voxels> counting() {
  std::array<float, leaf_voxels> values{};
  for (std::size_t v = 0; v < values.size(); ++v) values[v] = static_cast<float>(v);
  return values;
}

void send_small_leaf(std::ostream& out, const Index3& corner) {
  const std::array<float, leaf_voxels> values = counting();
  send_leaf<float>(out, corner, values);
}

std::string whole_message() {
  std::ostringstream out;
  send_header(out, small_header());
  send_tile<float>(out, {0, 8, 0}, {4, 8, 1}, 5.0F);
  send_small_leaf(out, {-2, 0, 0});
  send_end(out);
  return out.str();
}

Volume receive(const std::string& bytes, const VoxelLimits& limits = {}) {
  std::istringstream in(bytes);
  return receive_volume(in, limits, "a.vdb");
}

float at(const Volume& volume, std::int64_t i, std::int64_t j, std::int64_t k) {
  const std::int64_t v = i + volume.dims[0] * (j + volume.dims[1] * k);
  return std::get<std::vector<float>>(volume.values).at(static_cast<std::size_t>(v));
}

TEST(VdbMessage, PutsTilesAndLeavesWhereTheyBelong) {
  const Volume volume = receive(whole_message());
  EXPECT_EQ(volume.dims, (Index3{5, 9, 3}));
  EXPECT_EQ(volume.spacing, (Vec3{0.5, 1.0, 2.0}));
  EXPECT_EQ(volume.origin, (Vec3{-1.0, 0.0, 7.0}));
  EXPECT_EQ(volume.frame, Frame::world);
  EXPECT_EQ(volume.name, "density");
  EXPECT_EQ(at(volume, 0, 8, 0), 5.0F);
  EXPECT_EQ(at(volume, 4, 8, 1), 5.0F);
  EXPECT_EQ(at(volume, 4, 8, 2), -1.0F);
  EXPECT_EQ(at(volume, 0, 0, 0), 128.0F);  // two planes of the leaf lie beyond
  EXPECT_EQ(at(volume, 3, 7, 2), 64.0F * 5 + 8 * 7 + 2);
}

TEST(VdbMessage, RefusesAMessageCutAtAnyByte) {
  const std::string whole = whole_message();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(receive(whole.substr(0, length)), BrokenMessage) << length;
  }
}

TEST(VdbMessage, RefusesBlocksThatOverlapOrLieBeyond) {
  for (const Index3& corner : {Index3{-8, 0, 0}, Index3{5, 0, 0}, Index3{0, 0, 1L << 62}}) {
    std::ostringstream out;
    send_header(out, small_header());
    send_small_leaf(out, corner);
    send_end(out);
    EXPECT_THROW(receive(out.str()), BrokenMessage) << corner[0];
  }
  std::ostringstream twice;
  send_header(twice, small_header());
  for (int i = 0; i < 2; ++i) send_tile<float>(twice, {0, 0, 0}, {4, 8, 2}, 1.0F);
  send_end(twice);
  EXPECT_THROW(receive(twice.str()), BrokenMessage);
}

TEST(VdbMessage, RefusesAHeaderThatMakesNoVolume) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](auto&& change) {
    VdbHeader header = small_header();
    change(header);
    std::ostringstream out;
    send_header(out, header);
    send_end(out);
    EXPECT_THROW(receive(out.str()), BrokenMessage);
  };
  refused([](VdbHeader& header) { header.volume.dims[1] = 0; });
  refused([](VdbHeader& header) { header.volume.dims[2] = -3; });
  refused([](VdbHeader& header) { header.volume.spacing[0] = 0.0; });
  refused([&](VdbHeader& header) { header.volume.origin[0] = nan; });
  refused([&](VdbHeader& header) { header.volume.direction[0] = {nan, 0, 0}; });
  refused([](VdbHeader& header) { header.volume.direction[1] = {1, 0, 0}; });
  refused([](VdbHeader& header) { header.type = VoxelType::uint8; });
  refused([](VdbHeader& header) { header.type = static_cast<VoxelType>(99); });
  refused([](VdbHeader& header) { header.background = 1e300; });
}

TEST(VdbMessage, AsksForNoMemoryBeyondTheLimit) {
  VdbHeader header = small_header();
  header.volume.dims = {1L << 20, 1L << 20, 1L << 20};
  std::ostringstream out;
  send_header(out, header);
  EXPECT_EQ(test::error_of<LimitExceeded>([&] { receive(out.str()); }).excess.needed,
            std::uint64_t{4} << 60);
  EXPECT_THROW(receive(whole_message(), {.max_bytes = 5 * 9 * 3 * 4 - 1}), LimitExceeded);
  EXPECT_NO_THROW(receive(whole_message(), {.max_bytes = 5 * 9 * 3 * 4}));
}

TEST(VdbMessage, CarriesErrorsWithAllTheirDataAsOneLine) {
  const Finding sent{.file = "a.vdb",
                     .place = "grid '\x1b[2J\n'",
                     .about = Option::grid,
                     .text = "is bad",
                     .advice = {Advice::choose_grid, Advice::take_part}};
  std::ostringstream out;
  send_error(out, InvalidInput(sent, Fault::unsupported));
  const auto input = test::error_of<InvalidInput>([&] { receive(out.str()); });
  EXPECT_STREQ(input.what(), "a.vdb: grid '?[2J?': the grid is bad");
  EXPECT_EQ(input.fault, Fault::unsupported);
  EXPECT_EQ(input.finding.file, sent.file);
  EXPECT_EQ(input.finding.about, sent.about);
  EXPECT_EQ(input.finding.advice, sent.advice);
  std::ostringstream usage;
  send_error(usage, InvalidArgument({.text = "choose"}, Option::frame));
  EXPECT_EQ(test::error_of<InvalidArgument>([&] { receive(usage.str()); }).option, Option::frame);
}

TEST(VdbMessage, RefusesAnErrorOfNoKnownKindAndOneCutShort) {
  std::ostringstream out;
  send_error(out, InvalidInput({.file = "a.vdb", .text = "no", .advice = {Advice::choose_grid}}));
  const std::string whole = out.str();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_THROW(receive(whole.substr(0, length)), BrokenMessage) << length;
  }
  for (const std::size_t from_end : {4, 8}) {  // the advice, and how much of it there is
    std::string damaged = whole;
    damaged[whole.size() - from_end + 3] = '\x7f';
    EXPECT_THROW(receive(damaged), BrokenMessage) << from_end;
  }
}

}  // namespace
}  // namespace isoloop
