#include "tools/flags/engine_flags.h"

#include <CLI/CLI.hpp>

#include "core/base/errors.h"
#include "core/octree/leaves.h"
#include "tools/words/flag_checks.h"

namespace isoloop {

void add_geodesic_flag(CLI::App& command, std::string& geodesic) {
  command
      .add_option("--geodesic", geodesic,
                  "how sizes are measured: exact is the definition to the letter and slow on thick "
                  "parts, hierarchy is exact up to five voxels")
      ->check(CLI::IsMember({"hierarchy", "exact"}))
      ->type_name("HOW")
      ->capture_default_str();
}

void add_method_flags(CLI::App& command, EngineFlags& flags) {
  command
      .add_option("--engine", flags.engine,
                  "dual searches for short loops; pair is the algorithm of Dey, Li, Sun and "
                  "Cohen-Steiner (2008), whose loops are longer")
      ->check(CLI::IsMember({"dual", "pair"}))
      ->type_name("ENGINE")
      ->capture_default_str();
  command
      .add_option(
          "--refine", flags.refine,
          "refinements of --engine pair (default both): 1 takes the shortest cycle met on the "
          "surface, 2 orders by geodesic size")
      ->check(CLI::IsMember({"none", "1", "2", "both"}))
      ->type_name("WHICH");
  command
      .add_option(
          "--tighten", flags.tighten,
          "how short loops become: none leaves them as found; basis (default, but none with "
          "--engine pair or --open-boundary) exchanges them for shorter ones, all of a kind "
          "together; curve also draws each straight across the surface's triangles")
      ->check(CLI::IsMember({"none", "basis", "curve"}))
      ->type_name("HOW");
  command
      .add_option("--complex", flags.complex,
                  "the cells off the surface: grid has one for each cube of voxels; octree has "
                  "larger ones the farther they are from it, and sizes there are less fine; auto "
                  "takes the octree where it has fewer than a fifth of the cells")
      ->check(CLI::IsMember({"auto", "grid", "octree"}))
      ->type_name("WHICH")
      ->capture_default_str();
  command
      .add_option("--grading", flags.grading,
                  "how many of its own widths a cell of the octree keeps from the surface (default "
                  "1): 2 is nearer to the grid, 0 takes least time and memory")
      ->check(CLI::Range(0, max_grading))
      ->type_name("N");
}

void add_engine_flags(CLI::App& command, EngineFlags& flags) {
  add_method_flags(command, flags);
  want_file_name(
      command
          .add_option("--dump-pairs", flags.dump_pairs,
                      "write the edges of the surface that --engine pair pairs with triangles off "
                      "it, as CSV; - is standard output")
          ->type_name("FILE|-"));
  command.add_flag("--stats", flags.stats, "print triangle counts and times, as the paper does");
}

Engine engine_of(const EngineFlags& flags) {
  return flags.engine == "pair" ? Engine::pair : Engine::dual;
}

Tighten tighten_of(const EngineFlags& flags, Boundary boundary) {
  if (boundary == Boundary::open) {
    if (!flags.tighten.empty() && flags.tighten != tighten_text(Tighten::none)) {
      throw InvalidArgument("--tighten " + flags.tighten +
                            " does not go with --open-boundary: it needs handle and tunnel loops");
    }
    return Tighten::none;
  }
  for (const Tighten tighten : {Tighten::none, Tighten::basis, Tighten::curve}) {
    if (flags.tighten == tighten_text(tighten)) return tighten;
  }
  return engine_of(flags) == Engine::pair ? Tighten::none : Tighten::basis;
}

ComplexKind complex_of(const EngineFlags& flags) {
  if (flags.complex == complex_text(ComplexKind::grid)) {
    if (flags.grading) throw InvalidArgument("--grading does not go with --complex grid");
    return ComplexKind::grid;
  }
  return flags.complex == complex_text(ComplexKind::octree) ? ComplexKind::octree
                                                            : ComplexKind::automatic;
}

int grading_of(const EngineFlags& flags) { return flags.grading.value_or(1); }

PairOptions pair_options(const EngineFlags& flags) {
  if (engine_of(flags) != Engine::pair) {
    if (!flags.refine.empty()) throw InvalidArgument("--refine goes with --engine pair only");
    if (!flags.dump_pairs.empty()) {
      throw InvalidArgument("--dump-pairs goes with --engine pair only");
    }
  }
  for (const Refinement refinement : {Refinement::none, Refinement::first, Refinement::second}) {
    if (flags.refine == refinement_text(refinement)) return {refinement};
  }
  return {Refinement::both};
}

std::string engine_text(Engine engine) { return engine == Engine::pair ? "pair" : "dual"; }

std::string tighten_text(Tighten tighten) {
  switch (tighten) {
    case Tighten::none:
      return "none";
    case Tighten::basis:
      return "basis";
    case Tighten::curve:
      return "curve";
  }
  return "basis";
}

std::string refinement_text(Refinement refinement) {
  switch (refinement) {
    case Refinement::none:
      return "none";
    case Refinement::first:
      return "1";
    case Refinement::second:
      return "2";
    case Refinement::both:
      return "both";
  }
  return "both";
}

std::string complex_text(ComplexKind complex) {
  switch (complex) {
    case ComplexKind::automatic:
      return "auto";
    case ComplexKind::grid:
      return "grid";
    case ComplexKind::octree:
      return "octree";
  }
  return "auto";
}

}  // namespace isoloop
