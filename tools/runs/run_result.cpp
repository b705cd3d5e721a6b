#include "tools/runs/run_result.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <utility>

#include <sys/resource.h>
#include <unistd.h>

#include "core/base/errors.h"
#include "tools/words/number_text.h"
#include "tools/words/sentence.h"

namespace isoloop {
namespace {

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

VertexPair unordered(std::uint32_t a, std::uint32_t b) {
  return a < b ? VertexPair{a, b} : VertexPair{b, a};
}

std::string numbered(const Loop& loop) {
  return name_of(loop.kind) + " " + std::to_string(loop.id);
}

// The curves of a loop, and the walks beside its geodesics.
std::vector<Curve> walks_of(const Loop& loop) {
  std::vector<Curve> walks = loop.curves;
  for (const Geodesic& geodesic : loop.geodesics) walks.push_back(pushed_to_edges(geodesic));
  return walks;
}

// Every step of every curve, the step from its last vertex to its first among them, and every edge
// that a geodesic crosses.
std::vector<VertexPair> loop_steps(const Analysis& analysis) {
  std::vector<VertexPair> steps;
  const auto add = [&](const Loop& loop, std::uint32_t from, std::uint32_t to) {
    if (from >= analysis.surface.points.size() || from == to) {
      throw SelfCheckFailed(numbered(loop) + " leaves the surface");
    }
    steps.push_back(unordered(from, to));
  };
  for (const Loop& loop : analysis.loops) {
    if (loop.curves.empty()) throw SelfCheckFailed(numbered(loop) + " has no curve");
    for (const Curve& walk : walks_of(loop)) {
      if (walk.size() < 3) throw SelfCheckFailed(numbered(loop) + " does not go round anything");
      for (std::size_t i = 0; i < walk.size(); ++i) {
        add(loop, walk[i], walk[i + 1 == walk.size() ? 0 : i + 1]);
      }
    }
    for (const Geodesic& geodesic : loop.geodesics) {
      for (const SurfacePoint& point : geodesic) {
        if (point.at != 0.0) add(loop, point.edge[0], point.edge[1]);
      }
    }
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

void check_steps_lie_on_surface(const Analysis& analysis) {
  const std::vector<VertexPair> steps = loop_steps(analysis);
  std::vector<char> on_loop(analysis.surface.points.size(), 0);
  for (const auto& [a, b] : steps) on_loop[a] = on_loop[b] = 1;
  std::vector<char> found(steps.size(), 0);
  for (const auto& triangle : analysis.surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i];
      const std::uint32_t b = triangle[(i + 1) % 3];
      if (on_loop[a] == 0 || on_loop[b] == 0) continue;
      const auto place = std::lower_bound(steps.begin(), steps.end(), unordered(a, b));
      if (place != steps.end() && *place == unordered(a, b)) {
        found[static_cast<std::size_t>(place - steps.begin())] = 1;
      }
    }
  }
  if (std::find(found.begin(), found.end(), 0) != found.end()) {
    throw SelfCheckFailed("a loop takes a step that is no edge of the surface");
  }
}

}  // namespace

std::vector<Loop> select_loops(const std::vector<Loop>& loops, const LoopFilter& filter) {
  std::vector<Loop> selected;
  for (const Loop& loop : loops) {
    const bool kind_wanted = (loop.kind != LoopKind::handle || filter.handles) &&
                             (loop.kind != LoopKind::tunnel || filter.tunnels);
    if (kind_wanted && loop.size >= filter.min_size && loop.size <= filter.max_size) {
      selected.push_back(loop);
    }
  }
  return selected;
}

void add_warning(RunInput& run, std::string sentence) {
  run.volume.warnings.push_back({.text = std::move(sentence)});
}

void tell_warnings(std::ostream& out, RunInput& run) {
  const std::vector<std::string> sentences = sentences_of(run.volume.warnings);
  for (; run.warnings_told < sentences.size(); ++run.warnings_told)
    out << "isoloop: warning: " << sentences[run.warnings_told] << '\n';
}

AnyGridView voxels_of(const RunInput& run) { return run.voxels ? *run.voxels : view(run.volume); }

std::vector<std::string> notes_of(const RunInput& run) {
  std::vector<std::string> notes = sentences_of(run.volume.notes);
  if (!run.iso_choice.empty())
    notes.push_back("iso " + shortest_text(run.level.iso) + " is " + run.iso_choice);
  if (!run.remark.empty()) notes.push_back(run.remark);
  if (!run.hint.empty()) notes.push_back(run.hint);
  return notes;
}

std::uint64_t peak_resident_bytes() {
  // What getrusage() says begins with the set of the process that started this one.
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    std::uint64_t kibibytes = 0;
    if (word == "VmHWM:" && file >> kibibytes) return kibibytes * 1024;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

std::uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0;
  std::uint64_t resident = 0;
  if (!(file >> all >> resident)) return peak_resident_bytes();
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void check_counts(const Analysis& analysis) {
  std::int64_t euler = 0;
  std::int64_t genus = 0;
  std::int64_t cavities = 0;
  std::int64_t without_border = 0;
  const bool closed = analysis.surface.boundary == Boundary::closed;
  for (const SurfaceComponent& part : analysis.surface.components) {
    if (part.genus < 0 || part.borders < 0 || part.euler != 2 - 2 * part.genus - part.borders ||
        (closed && part.borders != 0)) {
      throw SelfCheckFailed(closed ? "a component of the surface is not closed"
                                   : "a component of the surface is no surface with a border");
    }
    without_border += part.borders == 0 ? 1 : 0;
    euler += part.euler;
    genus += part.genus;
    cavities += part.bounds_cavity ? 1 : 0;
  }
  const auto parts = static_cast<std::int64_t>(analysis.surface.components.size());
  const auto on_grid = static_cast<std::int64_t>(analysis.surface.grid_edges.size());
  if (euler != analysis.surface.euler() || genus != analysis.surface.genus() ||
      (closed && euler != analysis.surface.polygons - on_grid)) {
    throw SelfCheckFailed("the components of the surface do not add up to the whole");
  }
  const Betti& betti = analysis.betti;
  const bool agree = closed
                         ? betti.b0 == parts - cavities && betti.b1 == genus && betti.b2 == cavities
                         : betti.b0 == parts && betti.b0 - betti.b1 + betti.b2 == euler &&
                               betti.b2 == without_border;
  if (!agree) {
    throw SelfCheckFailed("the Betti numbers contradict the components of the surface");
  }
}

void check_loops(const Analysis& analysis) {
  std::array<std::int64_t, 3> count{};  // by kind
  for (const Loop& loop : analysis.loops) {
    const LoopCertificate& certificate = loop.certificate;
    if (++count[static_cast<std::size_t>(loop.kind)] != loop.id) {
      throw SelfCheckFailed(numbered(loop) + " is out of order");
    }
    if (!certificate.nontrivial_on_surface ||
        certificate.trivial_inside != (loop.kind == LoopKind::handle) ||
        certificate.trivial_outside != (loop.kind == LoopKind::tunnel)) {
      throw SelfCheckFailed(numbered(loop) + " lacks the certificate of its kind");
    }
  }
  const Surface& surface = analysis.surface;
  if (surface.boundary == Boundary::open) {
    if (count != std::array<std::int64_t, 3>{0, 0, surface.betti1()}) {
      throw SelfCheckFailed("found " + std::to_string(count[2]) + " loops where the surface has " +
                            std::to_string(surface.betti1()) + " independent ones");
    }
    check_steps_lie_on_surface(analysis);
    return;
  }
  const std::int64_t genus = surface.genus();
  if (count != std::array<std::int64_t, 3>{genus, genus, 0}) {
    throw SelfCheckFailed("found " + std::to_string(count[0]) + " handle loops and " +
                          std::to_string(count[1]) + " tunnel loops on a surface of genus " +
                          std::to_string(genus));
  }
  check_steps_lie_on_surface(analysis);
}

}  // namespace isoloop
