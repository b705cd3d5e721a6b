#include "tests/oracles/slow_reduction.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace isoloop::oracle {
namespace {

using Place = ExplicitComplex::Place;

/// Reduces columns in order; rows of greater number come later. Returns the reduced columns.
std::vector<Chain> reduce(std::vector<Chain> columns) {
  int rows = 0;
  for (const Chain& column : columns)
    if (!column.empty()) rows = std::max(rows, column.back() + 1);
  std::vector<const Chain*> column_of_low(static_cast<std::size_t>(rows), nullptr);
  for (Chain& column : columns) {
    while (!column.empty() && column_of_low[column.back()] != nullptr)
      column = sum(column, *column_of_low[column.back()]);
    if (!column.empty()) column_of_low[column.back()] = &column;
  }
  return columns;
}

std::int64_t rank(const std::vector<ExplicitComplex::Cell>& cells,
                  const std::function<bool(Place)>& counts) {
  std::vector<Chain> columns;
  for (const auto& cell : cells)
    if (counts(cell.place)) columns.push_back(cell.boundary);
  columns = reduce(std::move(columns));
  return std::count_if(columns.begin(), columns.end(), [](const Chain& c) { return !c.empty(); });
}

/// Of the cells in the places that count.
std::array<std::int64_t, 3> betti(const ExplicitComplex& complex,
                                  const std::function<bool(Place)>& counts) {
  const auto number = [&](const auto& cells) {
    return std::count_if(cells.begin(), cells.end(),
                         [&](const auto& cell) { return counts(cell.place); });
  };
  const std::int64_t rank1 = rank(complex.edges, counts);
  const std::int64_t rank2 = rank(complex.faces, counts);
  const std::int64_t rank3 = rank(complex.solids, counts);
  const std::int64_t vertices =
      std::count_if(complex.vertices.begin(), complex.vertices.end(), counts);
  return {vertices - rank1, number(complex.edges) - rank1 - rank2,
          number(complex.faces) - rank2 - rank3};
}

}  // namespace

Chain sum(const Chain& a, const Chain& b) {
  Chain result;
  result.reserve(a.size() + b.size());
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

std::array<std::int64_t, 3> betti_of_m(const ExplicitComplex& complex) {
  return betti(complex, [](Place place) { return place == Place::on_m; });
}

std::array<std::int64_t, 3> betti_inside(const ExplicitComplex& complex) {
  return betti(complex, [](Place place) { return place != Place::outside; });
}

std::int64_t euler_of_m(const ExplicitComplex& complex) {
  const auto on_m = [](const auto& cell) { return cell.place == Place::on_m; };
  return std::count(complex.vertices.begin(), complex.vertices.end(), Place::on_m) -
         std::count_if(complex.edges.begin(), complex.edges.end(), on_m) +
         std::count_if(complex.faces.begin(), complex.faces.end(), on_m);
}

std::vector<int> killing_faces(const ExplicitComplex& complex, const std::vector<int>& order) {
  // M's edges come first in the filtration, so they take the lowest rows.
  std::vector<int> row(complex.edges.size());
  int next = 0;
  for (const bool on_m : {true, false})
    for (std::size_t e = 0; e < complex.edges.size(); ++e)
      if ((complex.edges[e].place == Place::on_m) == on_m) row[e] = next++;
  const auto m_rows =
      static_cast<int>(std::count_if(complex.edges.begin(), complex.edges.end(),
                                     [](const auto& edge) { return edge.place == Place::on_m; }));
  std::vector<Chain> columns;
  const auto push = [&](const Chain& boundary) {
    columns.emplace_back();
    for (const int e : boundary) columns.back().push_back(row[e]);
    std::sort(columns.back().begin(), columns.back().end());
  };
  for (const auto& face : complex.faces)
    if (face.place == Place::on_m) push(face.boundary);
  const std::size_t first = columns.size();
  for (const int face : order) push(complex.faces[face].boundary);
  columns = reduce(std::move(columns));
  std::vector<int> killing;
  for (std::size_t c = first; c < columns.size(); ++c)
    if (!columns[c].empty() && columns[c].back() < m_rows) killing.push_back(order[c - first]);
  return killing;
}

}  // namespace isoloop::oracle
