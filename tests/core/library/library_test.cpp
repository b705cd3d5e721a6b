// The face of core/ for other programs: the public headers and nothing else of it.
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "isoloop/count.h"
#include "isoloop/errors.h"
#include "isoloop/loops.h"
#include "isoloop/repair.h"
#include "isoloop/scan.h"

namespace isoloop {
namespace {

/// A plate with two square holes: 1 inside, 0 outside, in a margin of one voxel.
struct Plate {
  Index3 dims{22, 12, 6};
  std::vector<float> values{};

  Plate() {
    for (int z = 0; z < 6; ++z)
      for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 22; ++x) {
          const bool margin = x == 0 || x == 21 || y == 0 || y == 11 || z == 0 || z == 5;
          const bool hole = (x / 4 == 1 || x / 4 == 3) && y >= 4 && y < 8;
          values.push_back(margin || hole ? 0.0F : 1.0F);
        }
  }
  GridView<float> view() const { return {values, dims}; }
};

constexpr IsoLevel half{.iso = 0.5};

TEST(Library, CountsAPlate) {
  const Plate plate;
  const Counts counts = count(plate.view(), half);
  EXPECT_EQ(counts.betti, (Betti{1, 2, 0}));
  EXPECT_EQ(counts.genus, 2);
  EXPECT_EQ(counts.euler, -2);
  EXPECT_EQ(counts.triangles, 2 * (counts.vertices - counts.euler));
  ASSERT_EQ(counts.components.size(), 1U);
  EXPECT_EQ(counts.components[0].genus, 2);
}

TEST(Library, CountsAnOpenPieceByItself) {
  const std::vector<float> full{1, 1, 0, 0, 1, 1, 0, 0};
  const GridView<float> grid{full, {2, 2, 2}};
  EXPECT_EQ(count(grid, half).betti, (Betti{1, 0, 0}));
  const Counts open = count(grid, half, {.boundary = Boundary::open});
  EXPECT_EQ(open.components.at(0).borders, 1);
}

TEST(Library, FindsTheLoopsThatItsCountsAskFor) {
  const Plate plate;
  const FoundLoops found = find_loops(plate.view(), half);
  ASSERT_EQ(found.loops.size(), 4U);
  EXPECT_EQ(found.counts.betti, (Betti{1, 2, 0}));
  EXPECT_TRUE(found.features.empty());
  double handles = 0.0;
  for (const Loop& loop : found.loops) {
    EXPECT_EQ(loop.certificate.trivial_inside, loop.kind == LoopKind::handle);
    EXPECT_EQ(loop.certificate.trivial_outside, loop.kind == LoopKind::tunnel);
    if (loop.kind == LoopKind::handle) handles += loop.length;
  }
  EXPECT_GT(found.least_handle_length, 0.0);
  EXPECT_LE(found.least_handle_length, handles * (1 + 1e-6));
}

TEST(Library, DrawnCurvesAreAsLongAsTheLoop) {
  const Plate plate;
  for (const Tighten tighten : {Tighten::basis, Tighten::curve}) {
    const FoundLoops found = find_loops(plate.view(), half, {.tighten = tighten});
    for (const Loop& loop : found.loops) {
      double length = 0.0;
      for (const std::vector<Vec3>& curve : drawn_curves(found.surface, loop))
        for (std::size_t i = 0; i < curve.size(); ++i)
          length += distance(curve[i], curve[(i + 1) % curve.size()]);
      EXPECT_NEAR(length, loop.length, 1e-4);
    }
  }
}

TEST(Library, FeaturesAreThereForEachLoopWhereAskedFor) {
  const Plate plate;
  const FoundLoops found = find_loops(plate.view(), half, {.feature_ratio = 1.5});
  ASSERT_EQ(found.features.size(), found.loops.size());
  for (const Feature& feature : found.features) {
    EXPECT_GT(feature.area, 0.0);
    for (const std::uint32_t vertex : feature.vertices)
      EXPECT_LT(vertex, found.surface.points.size());
  }
  EXPECT_THROW(find_loops(plate.view(), half, {.boundary = Boundary::open, .feature_ratio = 1.5}),
               InvalidArgument);
}

TEST(Library, ScanProposesARowThatCountAgreesWith) {
  const Plate plate;
  const std::vector<double> isos{-1.0, 0.25, 0.5, 0.75, 2.0};
  const Scan found = scan(plate.view(), isos);
  ASSERT_EQ(found.rows.size(), isos.size());
  ASSERT_TRUE(found.proposed);
  const ScanRow& row = found.rows[*found.proposed];
  EXPECT_EQ(row.iso, 0.5);
  EXPECT_EQ(row.betti, count(plate.view(), {.iso = row.iso}).betti);
  EXPECT_EQ(found.plateaus.size(), 3U);
}

TEST(Library, RepairedVoxelsHaveTheCountsThatRepairSays) {
  Plate plate;
  const RepairResult result = repair(plate.view(), half, {.genus = 1});
  EXPECT_EQ(result.before.betti, (Betti{1, 2, 0}));
  EXPECT_EQ(result.after.betti, (Betti{1, 1, 0}));
  ASSERT_EQ(result.removals.size(), 1U);
  EXPECT_FALSE(result.changes.empty());
  make_changes(result, plate.values);
  EXPECT_EQ(count(plate.view(), half).betti, result.after.betti);
}

TEST(Library, OneThreadAndFourFindTheSame) {
  const Plate plate;
  std::set<std::vector<double>> results;
  for (const int threads : {1, 4, 0}) {
    std::vector<double> numbers;
    for (const Loop& loop : find_loops(plate.view(), half, {.threads = threads}).loops)
      numbers.insert(numbers.end(), {loop.length, loop.size, loop.center_index[0]});
    results.insert(numbers);
  }
  EXPECT_EQ(results.size(), 1U);
}

TEST(Library, TellsOfItsProgress) {
  const Plate plate;
  std::mutex mutex;
  std::set<std::string> stages;
  const Progress progress = [&](const char* stage, double) {
    const std::scoped_lock lock(mutex);
    stages.insert(stage);
  };
  find_loops(plate.view(), half, {.progress = progress});
  EXPECT_GT(stages.count("surface") + stages.count("loops"), 1U);
}

TEST(Library, AGridOfAnotherSizeThanItSaysIsRefused) {
  const std::vector<float> values(8, 1.0F);
  const std::vector<double> isos{0.5};
  for (const Index3& dims : {Index3{2, 2, 3}, Index3{2, 2, 1}, Index3{-2, -2, 2}, Index3{0, 0, 0},
                             Index3{std::numeric_limits<std::int64_t>::max(), 8, 8}}) {
    const GridView<float> grid{values, dims};
    EXPECT_THROW(count(grid, half), InvalidArgument);
    EXPECT_THROW(find_loops(grid, half), InvalidArgument);
    EXPECT_THROW(scan(grid, isos), InvalidArgument);
    EXPECT_THROW(repair(grid, half, {}), InvalidArgument);
  }
  EXPECT_THROW(count(GridView<float>{{}, {0, 0, 0}}, half), InvalidArgument);
}

TEST(Library, ASpacingThatIsNoneIsRefused) {
  const std::vector<float> values(8, 1.0F);
  for (const double length : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(count(GridView<float>{values, {2, 2, 2}, {1, 1, length}}, half), InvalidArgument);
}

TEST(Library, MemoryBoundsAreKept) {
  const Plate plate;
  EXPECT_THROW(count(plate.view(), half, {.max_bytes = 1}), LimitExceeded);
  EXPECT_THROW(find_loops(plate.view(), half, {.max_bytes = 1}), LimitExceeded);
}

}  // namespace
}  // namespace isoloop
