#include "core/repair/vertex_cut.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/pending/disjoint_sets.hpp>  // before the CSR header: that one lacks it

#include "core/base/disjoint_sets.h"

namespace isoloop {
namespace {

constexpr std::int32_t endless = 1 << 30;
constexpr auto unreached = static_cast<std::uint32_t>(-1);
constexpr std::uint32_t small_network = 20'000;  // nodes that can be cut; up to this, in one go
constexpr std::uint32_t band = 5;                // nodes that can be cut, on either side of the cut

struct Link {
  std::uint32_t from;
  std::uint32_t to;
  std::int32_t there;  // capacities
  std::int32_t back;
};

using FlowGraph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, std::uint32_t, std::uint32_t>;

/// Which nodes more could flow to from the source once as much as possible flows to the sink.
std::vector<bool> reached_after_flow(std::uint32_t nodes, const std::vector<Link>& links,
                                     std::uint32_t source, std::uint32_t sink) {
  using Arc = FlowGraph::edge_descriptor;
  std::vector<std::uint32_t> first(nodes + 1);
  for (const Link& link : links) {
    ++first[link.from + 1];
    ++first[link.to + 1];
  }
  for (std::uint32_t n = 0; n < nodes; ++n) first[n + 1] += first[n];
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs(2 * links.size());
  std::vector<std::int32_t> capacity(arcs.size());
  std::vector<Arc> back(arcs.size());
  for (const Link& link : links) {
    const std::uint32_t there = first[link.from]++;
    const std::uint32_t here = first[link.to]++;
    arcs[there] = {link.from, link.to};
    arcs[here] = {link.to, link.from};
    capacity[there] = link.there;
    capacity[here] = link.back;
    back[there] = Arc(link.to, here);
    back[here] = Arc(link.from, there);
  }
  FlowGraph graph(boost::edges_are_sorted, arcs.begin(), arcs.end(), nodes);
  const auto number = get(boost::edge_index, graph);
  const auto vertex = get(boost::vertex_index, graph);
  std::vector<std::int32_t> room(arcs.size());
  std::vector<Arc> parent(nodes);
  std::vector<boost::default_color_type> color(nodes);
  std::vector<std::uint32_t> distance(nodes);
  boost::boykov_kolmogorov_max_flow(
      graph, boost::make_iterator_property_map(capacity.begin(), number),
      boost::make_iterator_property_map(room.begin(), number),
      boost::make_iterator_property_map(back.begin(), number),
      boost::make_iterator_property_map(parent.begin(), vertex),
      boost::make_iterator_property_map(color.begin(), vertex),
      boost::make_iterator_property_map(distance.begin(), vertex), vertex, source, sink);
  std::vector<bool> reached(nodes);
  for (std::uint32_t n = 0; n < nodes; ++n) reached[n] = color[n] == boost::black_color;
  return reached;
}

/// The network with all that no cut can part in one node.
class Banded {
 public:
  Banded(const std::vector<bool>& cuttable, const std::vector<std::array<std::uint32_t, 2>>& joins)
      : cuttable_(cuttable), whole_(static_cast<std::uint32_t>(cuttable.size())) {
    for (const auto& [a, b] : joins)
      if (!cuttable[a] && !cuttable[b]) whole_.unite(a, b);
    whole_.flatten();
    source_ = node(CutNetwork::source);
    sink_ = node(CutNetwork::sink);
    first_.assign(cuttable.size() + 1, 0);
    const auto for_each_join = [&](const auto& visit) {
      for (const auto& [a, b] : joins) {
        if (!cuttable[a] && !cuttable[b]) continue;
        visit(node(a), node(b));
        visit(node(b), node(a));
      }
    };
    for_each_join([&](std::uint32_t a, std::uint32_t) { ++first_[a + 1]; });
    for (std::size_t n = 0; n < cuttable.size(); ++n) first_[n + 1] += first_[n];
    std::vector<std::uint32_t> cursor(first_.begin(), first_.end() - 1);
    to_.resize(first_.back());
    for_each_join([&](std::uint32_t a, std::uint32_t b) { to_[cursor[a]++] = b; });
  }

  bool can_be_cut() const { return source_ != sink_; }

  /// The smallest of the layers round the source, nearest to the source.
  void start() {
    const std::vector<std::uint32_t> steps = steps_from({source_}, unreached);
    const std::uint32_t last = steps[sink_];
    before_.assign(steps.size(), false);
    cut_.clear();
    if (last == unreached) return;  // parted as it is
    std::vector<std::uint32_t> size(last + 1);
    for (std::size_t n = 0; n < steps.size(); ++n)
      if (cuttable_[n] && steps[n] < size.size()) ++size[steps[n]];
    std::uint32_t best = 1;
    for (std::uint32_t k = 2; k < size.size(); ++k)
      if (size[k] < size[best]) best = k;
    for (std::uint32_t n = 0; n < steps.size(); ++n) {
      before_[n] = steps[n] < best;
      if (cuttable_[n] && steps[n] == best) cut_.push_back(n);
    }
  }

  /// The least cut within `width` steps of the present one.
  void improve(std::uint32_t width) {
    std::vector<std::uint32_t> place(cuttable_.size(), unreached);
    std::vector<std::uint32_t> inner{source_, sink_};
    const auto add = [&](std::uint32_t n) {
      place[n] = static_cast<std::uint32_t>(inner.size());
      inner.push_back(n);
    };
    place[source_] = 0;
    place[sink_] = 1;
    const std::vector<std::uint32_t> steps = steps_from(cut_, width);
    for (std::uint32_t n = 0; n < steps.size(); ++n)
      if (steps[n] <= width && place[n] == unreached) add(n);
    const auto count = static_cast<std::uint32_t>(inner.size());
    std::uint32_t nodes = count;
    std::vector<std::uint32_t> way_out(count);
    for (std::uint32_t i = 0; i < count; ++i) way_out[i] = cuttable_[inner[i]] ? nodes++ : i;
    std::vector<Link> links;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t n = inner[i];
      if (cuttable_[n]) links.push_back({i, way_out[i], 1, 0});
      if (i < 2) continue;
      bool to_source = false;
      bool to_sink = false;
      for (std::uint32_t k = first_[n]; k < first_[n + 1]; ++k) {
        const std::uint32_t other = to_[k];
        if (place[other] >= 2 && place[other] != unreached) {
          links.push_back({way_out[i], place[other], endless, 0});
        } else if (place[other] == 0 || (place[other] == unreached && before_[other])) {
          to_source = true;
        } else {
          to_sink = true;
        }
      }
      if (to_source) links.push_back({0, i, endless, 0});
      if (to_sink) links.push_back({way_out[i], 1, endless, 0});
    }
    const std::vector<bool> reached = reached_after_flow(nodes, links, 0, 1);
    cut_.clear();
    for (std::uint32_t i = 2; i < count; ++i) {
      before_[inner[i]] = reached[i] && (way_out[i] == i || reached[way_out[i]]);
      if (way_out[i] != i && reached[i] && !reached[way_out[i]]) cut_.push_back(inner[i]);
    }
  }

  const std::vector<std::uint32_t>& cut() const { return cut_; }

 private:
  std::uint32_t node(std::uint32_t n) const { return cuttable_[n] ? n : whole_.root(n); }

  /// For each node: how many nodes that can be cut, itself among them, are on a shortest way to it
  /// from one of `start`; up to `most`, else unreached.
  std::vector<std::uint32_t> steps_from(const std::vector<std::uint32_t>& start,
                                        std::uint32_t most) const {
    std::vector<std::uint32_t> steps(cuttable_.size(), unreached);
    std::deque<std::uint32_t> queue(start.begin(), start.end());
    for (const std::uint32_t n : start) steps[n] = 0;
    while (!queue.empty()) {
      const std::uint32_t n = queue.front();
      queue.pop_front();
      for (std::uint32_t k = first_[n]; k < first_[n + 1]; ++k) {
        const std::uint32_t to = to_[k];
        const std::uint32_t there = steps[n] + (cuttable_[to] ? 1 : 0);
        if (there > most || there >= steps[to]) continue;
        steps[to] = there;
        if (cuttable_[to]) {
          queue.push_back(to);
        } else {
          queue.push_front(to);
        }
      }
    }
    return steps;
  }

  const std::vector<bool>& cuttable_;
  DisjointSets whole_;
  std::uint32_t source_ = 0;
  std::uint32_t sink_ = 0;
  std::vector<std::uint32_t> first_;  // by node: in to_, and the end
  std::vector<std::uint32_t> to_;
  std::vector<bool> before_;        // by node: on the source's side of the cut
  std::vector<std::uint32_t> cut_;  // ascending
};

}  // namespace

std::uint32_t CutNetwork::add_node(bool cuttable) {
  cuttable_.push_back(cuttable);
  return static_cast<std::uint32_t>(cuttable_.size() - 1);
}

void CutNetwork::join(std::uint32_t a, std::uint32_t b) { joins_.push_back({a, b}); }

std::optional<std::vector<std::uint32_t>> CutNetwork::least_cut() const {
  Banded network(cuttable_, joins_);
  if (!network.can_be_cut()) return std::nullopt;
  network.start();
  const auto size =
      static_cast<std::uint32_t>(std::count(cuttable_.begin(), cuttable_.end(), true));
  if (size <= small_network) {
    network.improve(unreached - 1);
    return network.cut();
  }
  for (std::size_t before = network.cut().size() + 1; network.cut().size() < before;) {
    before = network.cut().size();
    network.improve(band);
  }
  return network.cut();
}

}  // namespace isoloop
