// A least set of nodes that parts two terminals.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace isoloop {

/// An undirected graph of nodes, some of which may be cut, between a source and a sink.
class CutNetwork {
 public:
  static constexpr std::uint32_t source = 0;
  static constexpr std::uint32_t sink = 1;

  /// Numbers from 2 on. A node that is not cuttable never is in a cut.
  std::uint32_t add_node(bool cuttable);
  void join(std::uint32_t a, std::uint32_t b);

  /// The cuttable nodes of a least cut between source and sink, ascending. Nothing where no set of
  /// cuttable nodes parts them. By maximum flow (Boykov and Kolmogorov, IEEE PAMI 26, 2004); with
  /// more than twenty thousand cuttable nodes, within bands of five round the best cut so far until
  /// it gets no smaller: then no smaller cut is as near as that.
  std::optional<std::vector<std::uint32_t>> least_cut() const;

 private:
  std::vector<bool> cuttable_{false, false};
  std::vector<std::array<std::uint32_t, 2>> joins_;
};

}  // namespace isoloop
