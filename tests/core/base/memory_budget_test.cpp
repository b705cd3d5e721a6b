#include "core/base/memory_budget.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/analysis/analysis.h"
#include "core/base/errors.h"
#include "core/base/threads.h"
#include "core/engines/spanning_forest.h"
#include "tests/samples/core_fixture.h"
#include "tests/samples/octree_fixture.h"

namespace isoloop {
namespace {

/// What analyze() lacks within `bytes`, if anything.
std::optional<LimitExceeded> refusal_within(const testing::SmallVolume& volume, std::uint64_t bytes,
                                            ComplexKind complex = ComplexKind::grid) {
  try {
    analyze(volume.view(), testing::zero_level, {.complex = complex, .max_bytes = bytes});
  } catch (const LimitExceeded& error) {
    return error;
  }
  return std::nullopt;
}

using Stages = std::vector<std::pair<const char*, std::uint64_t>>;

/// Each of them needs more than those before.
void expect_refusals(const testing::SmallVolume& volume, const Stages& stages,
                     ComplexKind complex) {
  for (const auto& [stage, bytes] : stages) {
    const auto error = refusal_within(volume, bytes - 1, complex);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->excess.stage, stage);
    EXPECT_EQ(error->excess.unit, Excess::Unit::bytes);
    EXPECT_EQ(error->excess.needed, bytes);
    EXPECT_EQ(error->excess.limit, bytes - 1);
    EXPECT_EQ(error->finding.advice,
              (std::vector<Advice>{Advice::raise_memory_limit, Advice::take_part}));
    for (const std::string& part : {std::string(stage), bytes_text(bytes), bytes_text(bytes - 1)})
      EXPECT_NE(error->finding.text.find(part), std::string::npos) << error->what();
  }
  EXPECT_FALSE(refusal_within(volume, stages.back().second, complex));
}

TEST(MemoryBudget, EachStageIsRefusedByNameBeforeItStarts) {
  testing::SmallVolume volume = testing::torus({48, 48, 48});
  volume.values.front() = volume.values.back() = 1.0;  // a box beyond the torus: each needs more
  const testing::Prepared p(volume, GeodesicMode::hierarchy);
  const Extent extent{p.sides.lattice.vertex_count(), p.edges.count()};
  expect_refusals(volume,
                  {{"surface", surface_bytes(extent.lattice, extent.surface)},
                   {"closest", closest_bytes(extent)},
                   {"sizes", sizes_bytes(extent) + size_search_bytes(extent.surface)},
                   {"pass", pass_bytes(extent, p.sizes.by_edge.bytes(), 1) +
                                slab_bytes(extent.lattice, p.sides.lattice.dims[2] + 1, 1)}},
                  ComplexKind::grid);
}

TEST(MemoryBudget, AnOctreeIsAskedForByItsOwnVertices) {
  const testing::SmallVolume volume = testing::torus({64, 64, 64});
  const testing::Prepared p(volume, GeodesicMode::hierarchy);
  const testing::PreparedOctree made(p, 1, GeodesicMode::hierarchy);
  const Extent extent{p.sides.lattice.vertex_count(), p.edges.count(), made.octree.vertex_count()};
  expect_refusals(volume,
                  {{"surface", surface_bytes(extent.lattice, extent.surface)},
                   {"closest", closest_bytes(extent)},
                   {"sizes", sizes_bytes(extent) + size_search_bytes(extent.surface)},
                   {"pass", pass_bytes(extent, made.sizes.bytes(), 1) +
                                slab_bytes(extent.octree, made.octree.layer_count() + 1, 1)}},
                  ComplexKind::octree);
}

TEST(MemoryBudget, SearchesForLoopsAreRefusedWhereTheSurfaceIsLarge) {
  const testing::SmallVolume volume = testing::white_noise({14, 14, 14}, 1);
  const testing::Prepared p(volume, GeodesicMode::hierarchy);
  const std::uint64_t vertices = p.surface.points.size();
  const std::uint64_t needed =
      loops_bytes({p.sides.lattice.vertex_count(), vertices}) + loop_search_bytes(vertices);
  const auto error = refusal_within(volume, needed - 1);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->excess.stage, "loops");
  EXPECT_EQ(error->excess.needed, needed);
  EXPECT_FALSE(refusal_within(volume, needed));
}

TEST(MemoryBudget, WhatIsEnoughForOneThreadIsEnoughForSixteen) {
  const testing::SmallVolume volume = testing::torus({48, 48, 48});
  std::uint64_t enough = std::uint64_t{1} << 16;
  with_threads(1, [&] {
    while (refusal_within(volume, enough)) enough += enough / 64;
  });
  EXPECT_FALSE(with_threads(16, [&] { return refusal_within(volume, enough); }));
}

TEST(MemoryBudget, ThreadsAreAsManyAsThereIsRoomFor) {
  EXPECT_EQ(threads_within("sizes", 100, 10, unlimited_bytes, 16), 16);
  EXPECT_EQ(threads_within("sizes", 100, 10, 139, 16), 3);
  EXPECT_EQ(threads_within("sizes", 100, 10, 110, 16), 1);
  EXPECT_THROW(threads_within("sizes", 100, 10, 109, 16), LimitExceeded);
}

TEST(MemoryBudget, TheBoxIsRefusedBeforeItIsAllocated) {
  const testing::SmallVolume volume = testing::torus({40, 40, 40});
  EXPECT_THROW(classify(volume.view(), testing::zero_level, Boundary::closed, 40 * 40),
               LimitExceeded);
}

TEST(MemoryBudget, BytesAreSpelledInTheLargestUnitThatFits) {
  EXPECT_EQ(bytes_text(0), "0 bytes");
  EXPECT_EQ(bytes_text(1), "1 byte");
  EXPECT_EQ(bytes_text(1023), "1023 bytes");
  EXPECT_EQ(bytes_text(1536), "1.5 KiB");
  EXPECT_EQ(bytes_text(std::uint64_t{2} << 30), "2.0 GiB");
}

}  // namespace
}  // namespace isoloop
