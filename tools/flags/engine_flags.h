// The flags that choose the engine and ask for what only the paper's own shows.
#pragma once

#include <optional>
#include <string>

#include "core/analysis/analysis.h"
#include "tools/words/cli_app.h"

namespace isoloop {

/// As typed.
struct EngineFlags {
  std::string engine = "dual";
  std::string refine;      // "none", "1", "2" or "both"; empty: both
  std::string dump_pairs;  // file, "-" or empty
  std::string tighten{};   // "none", "basis" or "curve"; empty: basis, but none with `pair` or open
  std::string complex = "auto";  // "auto", "grid" or "octree"
  std::optional<int> grading{};  // of the octree; none: 1
  bool stats = false;
};

/// Adds --geodesic: "hierarchy" or "exact". `geodesic` must outlive the parse.
void add_geodesic_flag(CLI::App& command, std::string& geodesic);

/// Adds --engine, --refine, --tighten, --complex and --grading. `flags` must outlive the parse.
void add_method_flags(CLI::App& command, EngineFlags& flags);

/// The same, --dump-pairs and --stats.
void add_engine_flags(CLI::App& command, EngineFlags& flags);

Engine engine_of(const EngineFlags& flags);

/// Throws InvalidArgument where "basis" or "curve" is given and the boundary is open.
Tighten tighten_of(const EngineFlags& flags, Boundary boundary);

/// Throws InvalidArgument where --grading is given without an octree.
ComplexKind complex_of(const EngineFlags& flags);

/// Of an octree.
int grading_of(const EngineFlags& flags);

/// Throws InvalidArgument where --refine or --dump-pairs is given and the engine is not `pair`.
PairOptions pair_options(const EngineFlags& flags);

/// As the flags spell them: "dual" or "pair"; "none", "basis" or "curve"; "none", "1", "2" or
/// "both"; "auto", "grid" or "octree".
std::string engine_text(Engine engine);
std::string tighten_text(Tighten tighten);
std::string refinement_text(Refinement refinement);
std::string complex_text(ComplexKind complex);

}  // namespace isoloop
