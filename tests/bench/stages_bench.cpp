// CPU time of each stage of the pipeline on shapes of known topology, and how it grows.
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/analysis/analysis.h"
#include "core/complex/grid_complex.h"
#include "core/complex/grid_sizes.h"
#include "core/cube/voxel_sides.h"
#include "core/engines/dual_pass.h"
#include "core/sizes/closest.h"
#include "core/sizes/geodesic_size.h"
#include "core/surface/edge_index.h"
#include "core/surface/surface.h"
#include "volume/shapes/shapes.h"

namespace isoloop {
namespace {

/// A shape, and what each stage takes from those before it. Not to be moved: parts refer to others.
struct Prepared {
  Prepared(const std::string& name, std::int64_t size)
      : shape(make_shape(name, {.size = size})),
        grid(view(shape.volume)),
        sides(classify(grid, shape.level)),
        edges(sides),
        surface(extract_surface(grid, shape.level, sides, edges)),
        closest(closest_surface_vertices(sides, edges, surface)),
        sizes(geodesic_sizes(sides, edges, surface, closest, GeodesicMode::hierarchy)) {}

  Shape shape;
  AnyGridView grid;
  VoxelSides sides;
  EdgeIndex edges;
  Surface surface;
  UnsetVector<std::uint32_t> closest;
  EdgeSizes sizes;
};

void run_classify(const Prepared& p) { benchmark::DoNotOptimize(classify(p.grid, p.shape.level)); }

void run_surface(const Prepared& p) {
  benchmark::DoNotOptimize(extract_surface(p.grid, p.shape.level, p.sides, p.edges));
}

void run_closest(const Prepared& p) {
  benchmark::DoNotOptimize(closest_surface_vertices(p.sides, p.edges, p.surface));
}

void run_sizes(const Prepared& p) {
  benchmark::DoNotOptimize(
      geodesic_sizes(p.sides, p.edges, p.surface, p.closest, GeodesicMode::hierarchy));
}

void run_pass(const Prepared& p) {
  for (const Side side : {Side::inside, Side::outside}) {
    const GridComplex complex(p.sides, p.edges, side);
    benchmark::DoNotOptimize(dual_pass(complex, GridSizes(complex, p.edges, p.sizes)));
  }
}

void run_count(const Prepared& p) {
  benchmark::DoNotOptimize(count_topology(p.grid, p.shape.level));
}

void run_all(const Prepared& p) { benchmark::DoNotOptimize(analyze(p.grid, p.shape.level)); }

using Stage = void (*)(const Prepared&);

void register_stages(const std::string& shape, const std::vector<std::int64_t>& sizes) {
  const std::vector<std::pair<std::string, Stage>> stages{
      {"classify", run_classify}, {"surface", run_surface}, {"closest", run_closest},
      {"sizes", run_sizes},       {"pass", run_pass},       {"count", run_count},
      {"loops", run_all}};
  for (const auto& entry : stages) {
    auto* registered = benchmark::RegisterBenchmark(
        (shape + "/" + entry.first).c_str(),
        [shape, stage = entry.second](benchmark::State& state) {
          const Prepared prepared(shape, state.range(0));
          const auto voxels = static_cast<std::int64_t>(prepared.sides.lattice.vertex_count());
          for (auto _ : state) stage(prepared);
          state.SetItemsProcessed(voxels * static_cast<std::int64_t>(state.iterations()));
          state.SetComplexityN(voxels);
        });
    for (const std::int64_t size : sizes) registered->Arg(size);
    registered->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond)->Complexity();
  }
}

}  // namespace
}  // namespace isoloop

int main(int argc, char** argv) {
  for (const char* shape : {"torus", "trefoil", "plate", "lattice", "gyroid"})
    isoloop::register_stages(shape, {64, 96, 128});
  isoloop::register_stages("engine_block", {104, 128, 160});
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
