#include "core/tighten/shortest_basis.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/tighten/basis_exchange.h"
#include "core/tighten/loop_matching.h"

namespace isoloop {
namespace {

constexpr std::uint32_t most_sheets = 8;  // where the effort suffices for so many
constexpr std::size_t least_batch = 16;   // searches between two looks at the effort spent
constexpr std::size_t most_batches = 32;  // of a round; after each of them all members are sorted
constexpr std::size_t own_starts = 8;     // searches that try to shorten a curve that was exchanged
constexpr int most_rounds = 8;
constexpr std::uint64_t least_settled = 1000;  // paths, by a first search from one of each
constexpr std::uint64_t farther = 4;           // times as many, by the next one
constexpr double share_of_a_round = 0.2;       // of the effort, for those that go farther
constexpr double least_farther = 8.0;          // of these, while the effort lasts

/// A loop of the other kind, as what this side's loops have to cross.
struct Crossed {
  Curve vertices;             // of all its curves
  std::vector<double> along;  // by vertex: length of the curves up to it
  double length = 0.0;
  bool has_many_curves = false;
  GeneratorSet crossing;   // a loop crosses it as often, modulo 2, as its class has one of these
  double searched = 0.0;   // the longest loops that were searched for from here
  double least_met = 0.0;  // the shortest closed walk through a vertex started from that crosses it
                           // an odd number of times; `searched` if all are longer
  double gap = 0.0;        // the longest way along a curve from one such vertex to the next
};

/// No closed walk that crosses it an odd number of times is shorter: such a walk runs through one
/// of its vertices, from where one started from is at most half a gap away, there and back.
double shortest_crossing(const Crossed& crossed) {
  return std::max(0.0, crossed.least_met - crossed.gap);
}

/// The longest way between neighbors of `started`, indices of crossed.vertices; ascending.
double longest_gap(const Crossed& crossed, const std::vector<std::size_t>& started) {
  if (started.size() == crossed.vertices.size()) return 0.0;
  if (crossed.has_many_curves) return crossed.length;  // maybe none started from on one of them
  double gap = crossed.along[started.front()] + crossed.length - crossed.along[started.back()];
  for (std::size_t i = 1; i < started.size(); ++i)
    gap = std::max(gap, crossed.along[started[i]] - crossed.along[started[i - 1]]);
  return gap;
}

std::vector<Crossed> crossed_by(const Surface& surface, const SideLoops& across) {
  std::vector<Crossed> crossed;
  for (const Loop& loop : across.loops) {
    Crossed one;
    for (const Curve& curve : loop.curves)
      for_each_edge(curve, [&](std::uint32_t u, std::uint32_t v) {
        one.vertices.push_back(u);
        one.along.push_back(one.length);
        one.length += distance(scaled_point(surface, u), scaled_point(surface, v));
      });
    one.has_many_curves = loop.curves.size() > 1;
    one.crossing = across.border_classes.coordinates(loop.generators).value();
    crossed.push_back(std::move(one));
  }
  return crossed;
}

/// For each of `crossed`: the length of the longest member that loops which cross it may replace.
/// A loop can take the place of member k only if it crosses, an odd number of times, one of those
/// that sum to the dual of k: the class that crosses k so and no other member.
std::vector<double> replaceable(const std::vector<BasisMember>& members,
                                const std::vector<Crossed>& crossed) {
  std::vector<GeneratorSet> members_with;  // by generator
  for (std::uint32_t k = 0; k < members.size(); ++k)
    for (const std::uint32_t generator : members[k].other) {
      if (generator >= members_with.size()) members_with.resize(generator + 1);
      members_with[generator].push_back(k);
    }
  Z2Basis crosses;  // vector j: the members that cross crossed[j]
  for (const Crossed& one : crossed) {
    GeneratorSet crossing_members;
    for (const std::uint32_t generator : one.crossing)
      if (generator < members_with.size())
        crossing_members = sum_of(crossing_members, members_with[generator]);
    crosses.add(crossing_members);
  }
  std::vector<double> longest(crossed.size());
  for (std::uint32_t k = 0; k < members.size(); ++k) {
    const GeneratorSet dual = crosses.coordinates({&k, 1}).value();
    for (const std::uint32_t j : dual) longest[j] = std::max(longest[j], members[k].length);
  }
  return longest;
}

class Shortening {
 public:
  Shortening(Side side, const Surface& surface, const SurfaceClasses& classes,
             std::vector<BasisMember> members, std::vector<Crossed> crossed,
             const BasisEffort& effort)
      : exchange_(surface, classes, side, std::move(members)),
        crossed_(std::move(crossed)),
        batch_(std::max(least_batch, crossed_.size() / most_batches)),
        longest_(effort.longest),
        left_(effort.settled +
              effort.settled_per_vertex * static_cast<double>(surface.points.size())) {}

  void run() {
    for (int round = 0; round < most_rounds && left_ > 0.0; ++round)
      if (!search_across()) break;
    for (int round = 0; round < most_rounds && left_ > 0.0; ++round)
      if (!search_along_exchanged()) break;
  }

  const std::vector<BasisMember>& members() const { return exchange_.members(); }

  /// The loops of any basis can be paired with `crossed` so that each crosses its own an odd number
  /// of times. Lengths are sums of single precision.
  double lower_bound() const {
    constexpr double rounding = 1e-5;
    double sum = 0.0;
    for (const Crossed& one : crossed_) sum += shortest_crossing(one);
    return sum * (1.0 - rounding);
  }

 private:
  /// From one vertex of each of `crossed` at first, which tells what a search costs there, then
  /// from as many as the effort allows. Says whether the basis got shorter.
  bool search_across() {
    const double before = total();
    const std::vector<Searched> pilots = search_from_one_of_each();
    const std::vector<std::size_t> count = plan(pilots);
    std::vector<Searched> searched;
    double planned = 1.0;
    for (std::size_t o = 0; o < pilots.size(); ++o) {
      searched.push_back(pilots[o]);
      searched.back().count = count[o];
      planned += static_cast<double>(pilots[o].cost.settled * count[o]);
    }
    search_from(searched,
                static_cast<std::uint32_t>(std::clamp(left_ / planned, 1.0, double{most_sheets})));
    return total() < before;
  }

  /// What is searched from vertices of crossed_[of].
  struct Searched {
    std::uint32_t of = 0;
    std::size_t count = 0;  // of the vertices
    double longest = 0.0;   // loop looked for
    SearchCost cost;        // of the search from the first vertex
  };

  /// Near each of `crossed` first, then farther from fewer of those that were not searched to the
  /// end, for the longest members: these give way to loops that are met on the way, and with them
  /// goes the need to search far.
  std::vector<Searched> search_from_one_of_each() {
    std::vector<Searched> done;
    std::vector<bool> is_open(crossed_.size(), true);
    const double share = left_ * share_of_a_round;
    // Ends: a search that may take all that is left is too far for any.
    for (std::uint64_t settled = least_settled; static_cast<double>(settled) <= left_;
         settled *= farther) {
      std::vector<double> longest = replaceable(exchange_.members(), crossed_);
      for (double& length : longest) length = std::min(length, longest_);
      std::vector<std::uint32_t> open;
      for (std::uint32_t j = 0; j < crossed_.size(); ++j)
        if (is_open[j] && longest[j] > crossed_[j].searched) open.push_back(j);
      if (open.empty()) break;
      std::stable_sort(open.begin(), open.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return longest[a] > longest[b]; });
      if (settled > least_settled) {
        const double each = static_cast<double>(settled);
        const double affordable = std::max(share / each, std::min(least_farther, left_ / each));
        open.resize(std::min(open.size(), static_cast<std::size_t>(affordable)));
      }
      search_from_first(open, longest, settled, is_open, done);
    }
    return done;
  }

  void search_from_first(const std::vector<std::uint32_t>& open, const std::vector<double>& longest,
                         std::uint64_t settled, std::vector<bool>& is_open,
                         std::vector<Searched>& done) {
    for (std::size_t begin = 0; begin < open.size() && left_ > 0.0; begin += batch_) {
      std::vector<SearchStart> starts;
      for (std::size_t o = begin; o < std::min(begin + batch_, open.size()); ++o) {
        starts.push_back(start_at(open[o], 0, longest[open[o]], 1));
        starts.back().limits.most_settled = settled;
      }
      const std::vector<SearchCost> costs = search(starts);
      for (std::size_t s = 0; s < costs.size(); ++s) {
        const std::uint32_t j = open[begin + s];
        is_open[j] = costs[s].searched < longest[j];
        if (!is_open[j]) done.push_back({j, 1, longest[j], costs[s]});
      }
    }
  }

  /// How many vertices of each to start from: all, or in proportion to its length over that of the
  /// loops looked for, for the lengths of the shortest loops through two vertices differ by no more
  /// than twice their distance.
  std::vector<std::size_t> plan(const std::vector<Searched>& pilots) const {
    const auto counts = [&](double density) {
      std::vector<std::size_t> count;
      for (const Searched& one : pilots) {
        const Crossed& crossed = crossed_[one.of];
        const auto most = static_cast<double>(crossed.vertices.size());
        count.push_back(static_cast<std::size_t>(
            std::clamp(density * crossed.length / one.longest, 1.0, most)));
      }
      return count;
    };
    const auto is_affordable = [&](double density) {
      double sum = 0.0;
      const std::vector<std::size_t> count = counts(density);
      for (std::size_t o = 0; o < pilots.size(); ++o)
        sum += static_cast<double>(pilots[o].cost.settled * (count[o] - 1));
      return sum <= left_;
    };
    double low = 0.0;
    double high = 1e6;  // searches within the length of the loop looked for
    if (is_affordable(high)) return counts(high);
    for (int step = 0; step < 40; ++step) {
      const double middle = (low + high) / 2;
      (is_affordable(middle) ? low : high) = middle;
    }
    return counts(low);
  }

  void search_from(const std::vector<Searched>& searched, std::uint32_t sheets) {
    std::vector<SearchStart> starts;
    std::vector<std::uint32_t> from;
    for (const Searched& one : searched) {
      Crossed& crossed = crossed_[one.of];
      std::vector<std::size_t> started;
      for (std::size_t k = 0; k < one.count; ++k)
        started.push_back(k * crossed.vertices.size() / one.count);
      const bool is_all = one.count == crossed.vertices.size();
      for (std::size_t k = is_all ? 0 : 1; k < one.count; ++k) {
        starts.push_back(start_at(one.of, started[k], one.longest, is_all ? sheets : 1));
        from.push_back(one.of);
      }
      crossed.searched = one.longest;
      crossed.least_met = one.cost.shortest_crossing;
      crossed.gap = longest_gap(crossed, started);
    }
    const std::vector<SearchCost> costs = search(starts);
    for (std::size_t s = 0; s < starts.size(); ++s) {
      double& least = crossed_[from[s]].least_met;
      least = std::min(least, costs[s].shortest_crossing);
    }
  }

  /// From vertices of the members that a search has found.
  bool search_along_exchanged() {
    const double before = total();
    std::vector<SearchStart> starts;
    for (const BasisMember& member : exchange_.members()) {
      if (member.loop != BasisMember::no_loop) continue;
      for (const Curve& curve : member.curves) {
        const std::size_t count = std::min(curve.size(), own_starts);
        for (std::size_t k = 0; k < count; ++k)
          starts.push_back(
              {curve[k * curve.size() / count], {std::min(member.length, longest_), 1}, {}});
      }
    }
    for (std::size_t done = 0; done < starts.size() && left_ > 0.0; done += batch_)
      search(std::span(starts).subspan(done, std::min(batch_, starts.size() - done)));
    return total() < before;
  }

  SearchStart start_at(std::uint32_t j, std::size_t vertex, double longest,
                       std::uint32_t sheets) const {
    return {crossed_[j].vertices[vertex], {longest, sheets}, crossed_[j].crossing};
  }

  std::vector<SearchCost> search(std::span<const SearchStart> starts) {
    std::vector<SearchCost> costs = exchange_.search(starts);
    for (const SearchCost& cost : costs) left_ -= static_cast<double>(cost.settled);
    return costs;
  }

  double total() const {
    double sum = 0.0;
    for (const BasisMember& member : exchange_.members()) sum += member.length;
    return sum;
  }

  BasisExchange exchange_;
  std::vector<Crossed> crossed_;
  std::size_t batch_;  // searches between two looks at the effort spent
  double longest_;     // loop looked for
  double left_;        // paths, of the effort
};

}  // namespace

ShortenedBasis shorten_basis(const Surface& surface, const SurfaceClasses& classes,
                             const SideLoops& side, const SideLoops& across,
                             const BasisEffort& effort) {
  ShortenedBasis shortened{{side.loops.begin(), side.loops.end()}, 0.0};
  if (side.loops.empty()) return shortened;
  std::vector<BasisMember> members;
  for (const Loop& loop : side.loops)
    members.push_back(
        {loop.curves, loop.length, loop.generators, static_cast<std::uint32_t>(members.size())});
  Shortening shortening(side_of(side.loops.front().kind), surface, classes, std::move(members),
                        crossed_by(surface, across), effort);
  shortening.run();
  const std::vector<std::uint32_t> loop_of = match_loops(shortening.members(), side.border_classes);
  for (std::size_t m = 0; m < loop_of.size(); ++m) {
    const BasisMember& member = shortening.members()[m];
    const Loop& found = side.loops[loop_of[m]];
    Loop& loop = shortened.loops[loop_of[m]];
    loop = measured_loop(surface, found.kind, found.id, found.size, member.curves);
    loop.found_length = found.found_length;
    loop.generators = member.other;
  }
  shortened.least_length = shortening.lower_bound();
  return shortened;
}

}  // namespace isoloop
