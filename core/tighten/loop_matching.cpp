#include "core/tighten/loop_matching.h"

#include <algorithm>

#include "core/base/errors.h"

namespace isoloop {
namespace {

constexpr auto no_member = static_cast<std::uint32_t>(-1);

/// A bipartite matching grown by augmenting paths (Kuhn, 1955), found breadth first.
class Matching {
 public:
  Matching(const std::vector<BasisMember>& members, const Z2Basis& border_classes)
      : loop_of_(members.size(), BasisMember::no_loop), member_of_(members.size(), no_member) {
    for (const BasisMember& member : members) {
      const auto coordinates = border_classes.coordinates(member.other);
      if (!coordinates) throw SelfCheckFailed("a loop does not bound on its own side");
      coordinates_.push_back(*coordinates);
    }
    for (std::uint32_t m = 0; m < members.size(); ++m)
      if (closes(m, members[m].loop)) match(m, members[m].loop);
    for (std::uint32_t m = 0; m < members.size(); ++m)
      if (loop_of_[m] == BasisMember::no_loop) augment(m);
  }

  const std::vector<std::uint32_t>& loops() const { return loop_of_; }

 private:
  bool closes(std::uint32_t member, std::uint32_t loop) const {
    return std::binary_search(coordinates_[member].begin(), coordinates_[member].end(), loop);
  }

  void match(std::uint32_t member, std::uint32_t loop) {
    loop_of_[member] = loop;
    member_of_[loop] = member;
  }

  void augment(std::uint32_t start) {
    std::vector<std::uint32_t> from(member_of_.size(), no_member);  // by loop: who asked for it
    std::vector<std::uint32_t> asking{start};
    for (std::size_t next = 0; next < asking.size(); ++next) {
      const GeneratorSet& loops = coordinates_[asking[next]];
      for (auto loop = loops.rbegin(); loop != loops.rend(); ++loop) {
        if (from[*loop] != no_member) continue;
        from[*loop] = asking[next];
        if (member_of_[*loop] == no_member) return move_along(start, *loop, from);
        asking.push_back(member_of_[*loop]);
      }
    }
    throw SelfCheckFailed("the loops of one kind are not independent");
  }

  /// Every member on the way from `start` to the free loop takes the loop that it asked for.
  void move_along(std::uint32_t start, std::uint32_t loop, const std::vector<std::uint32_t>& from) {
    while (true) {
      const std::uint32_t member = from[loop];
      const std::uint32_t given_up = loop_of_[member];
      match(member, loop);
      if (member == start) return;
      loop = given_up;
    }
  }

  std::vector<GeneratorSet> coordinates_;  // by member
  std::vector<std::uint32_t> loop_of_;     // by member
  std::vector<std::uint32_t> member_of_;   // by loop
};

}  // namespace

std::vector<std::uint32_t> match_loops(const std::vector<BasisMember>& members,
                                       const Z2Basis& border_classes) {
  return Matching(members, border_classes).loops();
}

}  // namespace isoloop
