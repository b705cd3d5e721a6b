// Union-find over nodes that differ by even or odd classes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isoloop {

/// Union-find that knows whether a node and the root of its set differ by an odd class.
class Parities {
 public:
  struct Place {
    std::uint32_t root;
    bool odd;
  };

  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    odd_.push_back(0);
    return parent_.back();
  }

  Place find(std::uint32_t node) {
    bool odd = false;
    std::uint32_t root = node;
    for (; parent_[root] != root; root = parent_[root]) odd ^= odd_[root] != 0;
    bool rest = odd;
    while (parent_[node] != root && node != root) {  // hang all on the root
      const std::uint32_t next = parent_[node];
      const bool step = odd_[node] != 0;
      parent_[node] = root;
      odd_[node] = static_cast<char>(rest);
      rest ^= step;
      node = next;
    }
    return {root, odd};
  }

  /// Makes the class between a and b `odd`; false if it is the other one.
  bool unite(std::uint32_t a, std::uint32_t b, bool odd) {
    const Place at_a = find(a);
    const Place at_b = find(b);
    const bool between = at_a.odd ^ at_b.odd ^ odd;
    if (at_a.root == at_b.root) return !between;
    const auto [low, high] = std::minmax(at_a.root, at_b.root);
    parent_[high] = low;
    odd_[high] = static_cast<char>(between);
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<char> odd_;
};

}  // namespace isoloop
