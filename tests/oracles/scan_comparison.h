// A scan beside as many counts, which find the same numbers each on its own.
#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/scan/scan.h"

namespace isoloop::testing {

inline std::vector<std::int64_t> numbers(const Betti& betti, std::int64_t euler,
                                         std::int64_t genus) {
  return {betti.b0, betti.b1, betti.b2, euler, genus};
}

/// Iso values at which scan and count differ.
inline std::vector<double> differences(const AnyGridView& grid, const std::vector<double>& isos,
                                       InsideRule inside, Topology topology) {
  const auto rows = scan_topology(grid, isos, {inside, topology, {}});
  std::vector<double> different;
  for (std::size_t i = 0; i < isos.size(); ++i) {
    const Analysis counted = count_topology(grid, {isos[i], inside, topology});
    const bool equal = rows[i].iso == isos[i] &&
                       numbers(rows[i].betti, rows[i].euler, rows[i].genus) ==
                           numbers(counted.betti, counted.surface.euler(), counted.surface.genus());
    if (!equal) different.push_back(isos[i]);
  }
  return different;
}

}  // namespace isoloop::testing
