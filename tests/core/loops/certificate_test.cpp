#include "core/loops/certificate.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/loops/killing_border.h"
#include "core/z2/z2_basis.h"
#include "tests/samples/classified.h"
#include "tests/samples/core_fixture.h"

namespace isoloop {
namespace {

using testing::Classified;

TEST(Certificate, EveryTriangleOfMIsTrivial) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Classified c(testing::white_noise({7, 6, 8}, seed));
    for (const auto& t : c.prepared.surface.triangles) {
      const Curve curve{t[0], t[1], t[2]};
      ASSERT_TRUE(class_of(c.prepared.surface, c.classes, {&curve, 1}).empty());
    }
  }
}

TEST(Certificate, TheClassesOfMSpanBothHomologies) {
  // Cycles closed by one edge over a spanning tree generate H1(M), of rank 2 g.
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Classified c(testing::white_noise({6, 6, 6}, seed));
    const EdgeGraph& graph = c.prepared.surface.graph;
    std::vector<std::int64_t> parent(graph.vertex_count(), -1);
    std::vector<GeneratorSet> to_root(graph.vertex_count());
    Z2Basis basis;
    for (std::uint32_t root = 0; root < graph.vertex_count(); ++root) {
      if (parent[root] >= 0) continue;
      parent[root] = root;
      std::vector<std::uint32_t> todo{root};
      while (!todo.empty()) {
        const std::uint32_t u = todo.back();
        todo.pop_back();
        graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t edge) {
          const GeneratorSet through =
              sum_of(to_root[u], c.classes.pool.generators(c.classes.of_edge[edge]));
          if (parent[v] < 0) {
            parent[v] = u;
            to_root[v] = through;
            todo.push_back(v);
          } else {
            basis.add(sum_of(through, to_root[v]));
          }
        });
      }
    }
    EXPECT_EQ(basis.rank(), 2 * c.prepared.surface.genus());
  }
}

TEST(Certificate, BothDirectionsOfAnEdgeHaveOneClass) {
  const Classified c(testing::white_noise({8, 8, 8}, 4));
  const EdgeGraph& graph = c.prepared.surface.graph;
  for (std::uint32_t u = 0; u < graph.vertex_count(); ++u)
    graph.for_each_out_edge(u, [&](std::uint32_t v, std::uint32_t there) {
      graph.for_each_out_edge(v, [&](std::uint32_t w, std::uint32_t back) {
        if (w == u) {
          ASSERT_EQ(c.classes.of_edge[there], c.classes.of_edge[back]);
        }
      });
    });
}

TEST(Certificate, ABorderOfAKillingSurfaceIsTrivialOnItsSideOnly) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Classified c(testing::smooth_noise({14, 14, 14}, seed, 1));
    for (const Side side : {Side::inside, Side::outside}) {
      const DualPass& pass = side == Side::inside ? c.inside : c.outside;
      const KillingBorders borders = killing_borders(c.prepared.complex(side), pass);
      for (std::uint32_t i = 0; i < pass.killing.size(); ++i) {
        const GeneratorSet set =
            class_of(c.prepared.surface, c.classes, closed_curves(borders.of(i)));
        EXPECT_TRUE(split_class(c.classes, side, set).own.empty());
        EXPECT_FALSE(split_class(c.classes, side, set).other.empty());
      }
    }
  }
}

TEST(Certificate, AClassSplitsIntoItsPartsOnBothSides) {
  SurfaceClasses classes;
  classes.inside_rank = 3;
  classes.outside_rank = 3;
  const GeneratorSet set{0, 2, 3, 5};
  const SplitClass inside = split_class(classes, Side::inside, set);
  EXPECT_EQ(inside.own, (GeneratorSet{0, 2}));
  EXPECT_EQ(inside.other, (GeneratorSet{0, 2}));
  const SplitClass outside = split_class(classes, Side::outside, GeneratorSet{1, 4, 5});
  EXPECT_EQ(outside.own, (GeneratorSet{1, 2}));
  EXPECT_EQ(outside.other, (GeneratorSet{1}));
}

TEST(Certificate, AWalkOffMIsRefused) {
  const Classified c(testing::torus({20, 20, 20}));
  const Curve curve{0, static_cast<std::uint32_t>(c.prepared.surface.points.size() - 1)};
  EXPECT_THROW(class_of(c.prepared.surface, c.classes, {&curve, 1}), SelfCheckFailed);
}

}  // namespace
}  // namespace isoloop
