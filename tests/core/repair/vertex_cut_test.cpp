#include "core/repair/vertex_cut.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace isoloop {
namespace {

/// Nodes 2 .. 2 + count - 1 can be cut, and hubs after them cannot.
struct Example {
  std::uint32_t count = 0;
  std::uint32_t hubs = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joins;

  CutNetwork network() const {
    CutNetwork made;
    for (std::uint32_t i = 0; i < count + hubs; ++i) made.add_node(i < count);
    for (const auto& [a, b] : joins) made.join(a, b);
    return made;
  }

  bool parts(std::uint32_t removed) const {
    std::vector<bool> seen(2 + count + hubs);
    std::vector<std::uint32_t> todo{CutNetwork::source};
    seen[CutNetwork::source] = true;
    while (!todo.empty()) {
      const std::uint32_t node = todo.back();
      todo.pop_back();
      for (const auto& [a, b] : joins)
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
          const bool gone = to >= 2 && to < 2 + count && (removed >> (to - 2) & 1U) != 0;
          if (from != node || seen[to] || gone) continue;
          seen[to] = true;
          todo.push_back(to);
        }
    }
    return !seen[CutNetwork::sink];
  }
};

Example random_example(std::mt19937& random) {
  Example example;
  example.count = 3 + random() % 7;
  example.hubs = random() % 4;
  const std::uint32_t nodes = 2 + example.count + example.hubs;
  for (std::uint32_t n = 0; n < nodes + random() % (2 * nodes); ++n) {
    const auto a = static_cast<std::uint32_t>(random() % nodes);
    const auto b = static_cast<std::uint32_t>(random() % nodes);
    if (a != b && a + b != 1) example.joins.emplace_back(a, b);
  }
  return example;
}

TEST(VertexCut, IsALeastOneOnRandomGraphs) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    const Example example = random_example(random);
    int least = -1;
    for (std::uint32_t removed = 0; removed < 1U << example.count; ++removed)
      if (example.parts(removed) && (least < 0 || std::popcount(removed) < least))
        least = std::popcount(removed);
    const auto cut = example.network().least_cut();
    ASSERT_EQ(cut.has_value(), least >= 0) << round;
    if (!cut) continue;
    std::uint32_t removed = 0;
    for (const std::uint32_t node : *cut) removed |= 1U << (node - 2);
    EXPECT_TRUE(example.parts(removed)) << round;
    EXPECT_EQ(static_cast<int>(cut->size()), least) << round;
  }
}

TEST(VertexCut, FindsTheWaistOfALargeNetwork) {
  // Square sheets of vertices, each joined to hubs of four as the cells of a grid would be; sheets
  // in the middle are smaller.
  constexpr std::uint32_t length = 61;
  CutNetwork network;
  std::vector<std::vector<std::uint32_t>> sheets;
  const auto side_of_sheet = [](std::uint32_t k) {
    const std::uint32_t off = k > length / 2 ? k - length / 2 : length / 2 - k;
    return 10 + off / 2;
  };
  for (std::uint32_t k = 0; k < length; ++k) {
    std::vector<std::uint32_t> sheet;
    for (std::uint32_t i = 0; i < side_of_sheet(k) * side_of_sheet(k); ++i)
      sheet.push_back(network.add_node(true));
    sheets.push_back(sheet);
  }
  const auto join_all = [&](std::uint32_t hub, const std::vector<std::uint32_t>& nodes) {
    for (const std::uint32_t node : nodes) network.join(hub, node);
  };
  join_all(CutNetwork::source, sheets.front());
  join_all(CutNetwork::sink, sheets.back());
  for (std::uint32_t k = 0; k + 1 < length; ++k) {
    const std::uint32_t hub = network.add_node(false);
    join_all(hub, sheets[k]);
    join_all(hub, sheets[k + 1]);
  }
  const auto cut = network.least_cut();
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->size(), 100U);
}

TEST(VertexCut, IsNothingWhereTheTerminalsAreOne) {
  CutNetwork network;
  const std::uint32_t hub = network.add_node(false);
  network.join(CutNetwork::source, hub);
  network.join(hub, CutNetwork::sink);
  EXPECT_FALSE(network.least_cut());
}

TEST(VertexCut, IsEmptyWhereTheTerminalsArePartedAlready) {
  CutNetwork network;
  network.join(CutNetwork::source, network.add_node(true));
  network.join(CutNetwork::sink, network.add_node(true));
  const auto cut = network.least_cut();
  ASSERT_TRUE(cut);
  EXPECT_TRUE(cut->empty());
}

}  // namespace
}  // namespace isoloop
