// The flags of `bench`, and those that it hands on to the runs that it measures.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "isoloop/shapes.h"
#include "tools/bench/bench_run.h"
#include "tools/runs/loops_run.h"
#include "tools/words/cli_app.h"

namespace isoloop {

/// As typed.
struct BenchFlags {
  LoopsInput input{};                // of a file, and how loops are found; its threads mean nothing
  std::string shapes{};              // "torus,lattice:7"; empty: a handful, unless there is a file
  std::string sizes = "64,128,256";  // voxels along the longest axis of a shape
  std::string threads = "1,all";     // numbers of threads; all: one for each core
  int repeat = 1;                    // runs of each
  double max_seconds = 0.0;          // wall clock of a run; 0: as long as it takes
};

/// Adds the flags of a run that is measured: --file with what describes it, and how loops are
/// found. `input` must outlive the parse.
void add_measured_flags(CLI::App& command, LoopsInput& input);

/// The same, and the flags of BenchFlags.
void add_bench_flags(CLI::App& command, BenchFlags& flags);

/// Which runs the flags ask for, on a machine with so many cores. `command`: that they were parsed
/// for. Throws InvalidArgument, naming the flag, where they make no sense by themselves or
/// together.
BenchPlan plan_of(const BenchFlags& flags, const CLI::App& command, int cores);

/// A shape as it is typed: its name, and after a colon the cells of a lattice or the holes of a
/// plate.
struct NamedShape {
  std::string name{};
  ShapeOptions options{};
};

/// Throws InvalidArgument for an unknown name and for a number that the shape has none of.
NamedShape parse_shape(std::string_view text);

/// Ascending, each once; `all` stands for `cores`. Throws InvalidArgument.
std::vector<int> parse_threads(std::string_view text, int cores);

}  // namespace isoloop
