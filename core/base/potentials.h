// Union-find over members that differ by known values.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace isoloop {

/// Union-find that knows by how much each member differs from the root of its set: the least. What
/// `Sum` adds up are vectors over Z2: Value{} is 0, and each is its own inverse.
template <class Value, class Sum>
class Potentials {
 public:
  struct Place {
    std::uint32_t root;
    Value value;  // of the way from the member to the root
  };

  explicit Potentials(Sum add_up = {}) : sum(std::move(add_up)) {}

  /// A member of its own. Members are numbered 0, 1, ...
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    step_.push_back(Value{});
    return parent_.back();
  }

  Place find(std::uint32_t member) {
    path_.clear();
    while (parent_[member] != member) {
      path_.push_back(member);
      member = parent_[member];
    }
    Value value{};
    for (std::size_t i = path_.size(); i-- > 0;) {  // hang all on the root
      value = sum(value, step_[path_[i]]);
      step_[path_[i]] = value;
      parent_[path_[i]] = member;
    }
    return {member, value};
  }

  /// Adds a way from a to b of value `between`. The value of the closed way that this makes, and
  /// 0 if it joins two sets.
  Value join(std::uint32_t a, std::uint32_t b, const Value& between) {
    const Place at_a = find(a);
    const Place at_b = find(b);
    const Value around = sum(sum(at_a.value, at_b.value), between);
    if (at_a.root == at_b.root) return around;
    const auto [low, high] = std::minmax(at_a.root, at_b.root);
    parent_[high] = low;
    step_[high] = around;
    return Value{};
  }

  Sum sum;

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<Value> step_;  // to the parent
  std::vector<std::uint32_t> path_;
};

}  // namespace isoloop
