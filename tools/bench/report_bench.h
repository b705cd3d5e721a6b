// What `bench` measured, as tables.
#pragma once

#include <ostream>

#include "tools/bench/bench_run.h"

namespace isoloop {

/// The machine; a row for each case and number of threads; CPU time, memory and triangles a second
/// of each stage; growth exponents; parallel efficiency. What cannot be told is "-".
void write_bench_table(std::ostream& out, const BenchRun& run);

/// A header, then one line for each stage of each case on each number of threads, the first of them
/// for the whole run ("all"): volume, size, dims_x, dims_y, dims_z, voxels, triangles, genus,
/// loops, threads, repeat, stage, cpu_seconds, wall_seconds, peak_bytes, bytes_per_voxel,
/// triangles_per_second (of wall clock), slowest_loops_seconds (of "all" and "loops"), failure.
void write_bench_csv(std::ostream& out, const BenchRun& run);

/// One JSON object, schema "isoloop-bench/1".
void write_bench_json(std::ostream& out, const BenchRun& run);

}  // namespace isoloop
