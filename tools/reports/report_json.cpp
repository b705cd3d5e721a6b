#include "tools/reports/report_json.h"

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/flags/engine_flags.h"
#include "tools/flags/input_flags.h"
#include "tools/reports/report_features.h"
#include "tools/reports/report_table.h"
#include "tools/runs/mesh_comparison.h"
#include "tools/words/json_text.h"
#include "tools/words/sentence.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

// One line. Bytes of a file name that are not UTF-8 are replaced rather than refused.
// Rows of the map from (i, j, k, 1) to the world.
Json affine_of(const Volume& volume) {
  Json rows = Json::array();
  for (std::size_t row = 0; row < 3; ++row) {
    Json entries = Json::array();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      entries.push_back(volume.direction[axis][row] * volume.spacing[axis]);
    }
    entries.push_back(volume.origin[row]);
    rows.push_back(entries);
  }
  rows.push_back({0.0, 0.0, 0.0, 1.0});
  return rows;
}

Json input_of(const CountRun& run) {
  const Volume& volume = run.volume;
  return {{"file", run.file},
          {"grid", volume.name},
          {"dims", volume.dims},
          {"part", part_json(volume)},
          {"type", type_name(volume.values)},
          {"spacing", volume.spacing},
          {"origin", volume.origin},
          {"direction", volume.direction},
          {"level_set", volume.level_set},
          {"mesh", mesh_json(run, run.analysis)},
          {"minimum", run.range.min},
          {"maximum", run.range.max},
          {"nan_as", run.nan_as ? Json(*run.nan_as) : Json()},
          {"notes", notes_of(run)},
          {"warnings", sentences_of(volume.warnings)}};
}

const char* inside_rule_text(const IsoLevel& level) {
  if (level.upper) return "between";
  return level.inside == InsideRule::above ? "above" : "below";
}

Json conventions_of(const CountRun& run, const LoopsRun* loops) {
  const bool open = run.analysis.surface.boundary == Boundary::open;
  Json conventions = {{"inside", inside_text(run.level)},
                      {"inside_rule", inside_rule_text(run.level)},
                      {"equal_to_iso", "inside"},
                      {"topology", topology_text(run.level.topology)},
                      {"ambiguous_faces", ambiguous_faces_text(run.level.topology)},
                      {"padding", open ? "none: the surface ends at the border of the volume"
                                       : "one layer outside the volume"},
                      {"coefficients", "Z2"}};
  if (open) conventions["betti"] = "of the surface, whose sides are not told apart";
  if (loops != nullptr) {
    conventions["geodesic"] = loops->geodesic == GeodesicMode::exact ? "exact" : "hierarchy";
    conventions["engine"] = engine_text(loops->engine);
    if (loops->engine == Engine::pair)
      conventions["refinement"] = refinement_text(loops->refinement);
    const ComplexKind complex = run.analysis.complex;
    conventions["complex"] =
        complex == ComplexKind::automatic ? Json() : Json(complex_text(complex));
    if (complex == ComplexKind::octree) conventions["grading"] = loops->grading;
    conventions["tighten"] = tighten_text(loops->tighten);
    conventions["infinite_size"] = "null: the loop joins two components of the surface";
  }
  conventions["coordinates"] = {{"frame", frame_name(run.volume.frame)},
                                {"affine", affine_of(run.volume)},
                                {"center_index", "voxel indices"},
                                {"center_world", "frame"},
                                {"curves", "frame"}};
  conventions["unit"] = "length and size: " + unit_text(run.volume);
  return conventions;
}

Json filter_of(const LoopsRun& run) {
  const char* side = run.filter.handles ? (run.filter.tunnels ? "both" : "handle") : "tunnel";
  return {{"min_size", run.filter.min_size},
          {"max_size", run.filter.max_size},
          {"side", side},
          {"found", run.analysis.loops.size()},
          {"reported", run.reported.size()}};
}

Json curves_of(const LoopsRun& run, const Loop& loop) {
  Json curves = Json::array();
  for (const std::vector<Vec3>& curve : drawn_curves(run.analysis.surface, loop)) {
    Json points = Json::array();
    for (const Vec3& point : curve) points.push_back(to_world(run.volume, point));
    curves.push_back(std::move(points));
  }
  return curves;
}

Json loop_of(const LoopsRun& run, const Loop& loop) {
  const auto triviality = [](bool trivial) { return trivial ? "trivial" : "nontrivial"; };
  const Json certificate =
      loop.kind == LoopKind::loop
          ? Json{{"inside", "unknown"},
                 {"outside", "unknown"},
                 {"surface", triviality(!loop.certificate.nontrivial_on_surface)}}
          : Json{{"inside", triviality(loop.certificate.trivial_inside)},
                 {"outside", triviality(loop.certificate.trivial_outside)}};
  Json json{{"id", loop.id},
            {"kind", kind_text(loop.kind)},
            {"fix", fix_text(loop.kind)},
            {"length", loop.length},
            {"found_length", loop.found_length},
            {"size", loop.size},
            {"component", loop.component},
            {"center_index", loop.center_index},
            {"center_world", to_world(run.volume, loop.center_index)},
            {"curves", curves_of(run, loop)},
            {"certificate", certificate}};
  if (run.with_features) json["feature"] = feature_json(run, loop);
  return json;
}

// Of all loops of a kind, whatever the filter. The bound is one along edges of the surface.
Json total_of(const LoopsRun& run, LoopKind kind, double least) {
  double length = 0.0;
  double found = 0.0;
  for (const Loop& loop : run.analysis.loops) {
    if (loop.kind != kind) continue;
    length += loop.length;
    found += loop.found_length;
  }
  return {{"length", length},
          {"found_length", found},
          {"lower_bound", least > 0.0 ? Json(least) : Json()}};
}

Json component_of(Boundary boundary, const SurfaceComponent& component) {
  Json json = {{"vertices", component.vertices},
               {"triangles", component.triangles},
               {"euler", component.euler},
               {"genus", component.genus},
               {"bounds", bounds_text(boundary, component)}};
  if (boundary == Boundary::open) json["borders"] = component.borders;
  return json;
}

void write_loops(std::ostream& out, const LoopsRun& run) {
  write_member(out, "filter", filter_of(run));
  Json total = {{"handles", total_of(run, LoopKind::handle, run.analysis.least_handle_length)},
                {"tunnels", total_of(run, LoopKind::tunnel, run.analysis.least_tunnel_length)}};
  if (run.analysis.surface.boundary == Boundary::open)
    total = {{"loops", total_of(run, LoopKind::loop, 0.0)}};
  write_member(out, "total", total);
  write_list(out, "loops", run.reported, [&run](const Loop& loop) { return loop_of(run, loop); });
}

/// What both kinds of run have, and of `loops`, where there are some, what they have.
void write_document(std::ostream& out, const CountRun& run, const LoopsRun* loops) {
  const Surface& surface = run.analysis.surface;
  const Betti& betti = run.analysis.betti;
  const StageSeconds& seconds = run.analysis.seconds;
  out << "{\n  \"schema\": \"isoloop/1\"";
  write_member(out, "input", input_of(run));
  write_member(out, "iso", run.level.iso);
  if (run.level.upper) write_member(out, "iso_upper", *run.level.upper);
  write_member(out, "conventions", conventions_of(run, loops));
  write_member(out, "surface",
               {{"vertices", surface.points.size()},
                {"triangles", surface.triangles.size()},
                {"components", surface.components.size()},
                {"euler", surface.euler()},
                {"genus", surface.genus()}});
  write_list(out, "components", surface.components, [&surface](const SurfaceComponent& component) {
    return component_of(surface.boundary, component);
  });
  write_member(out, "betti", {{"b0", betti.b0}, {"b1", betti.b1}, {"b2", betti.b2}});
  if (loops != nullptr) write_loops(out, *loops);
  write_member(out, "verified", true);
  Json stages = {{"read", run.cost.read_seconds},
                 {"surface", seconds.surface},
                 {"closest", seconds.closest},
                 {"sizes", seconds.sizes},
                 {"pass", seconds.pass}};
  if (loops != nullptr && loops->engine == Engine::pair) stages["pair"] = seconds.pair;
  stages["loops"] = seconds.loops;
  stages["total"] = run.cost.total_seconds;
  if (loops != nullptr) stages["slowest_loops"] = seconds.slowest_loops;
  write_member(out, "seconds", stages);
  write_member(out, "peak_bytes", run.cost.peak_bytes);
  out << "\n}\n";
}

}  // namespace

Json part_json(const Volume& volume) {
  if (!volume.part) return {};
  return {{"first", volume.part->first}, {"of", volume.part->whole}};
}

Json mesh_json(const RunInput& run, const Analysis& analysis) {
  if (!run.volume.mesh) return {};
  const MeshCounts& mesh = *run.volume.mesh;
  const std::optional<bool> agree = voxels_agree(run, analysis);
  Json json = {{"triangles", mesh.triangles},
               {"shells", mesh.betti ? Json(mesh.shells) : Json()},
               {"swallowed", mesh.betti ? Json(mesh.swallowed) : Json()},
               {"betti", Json()},
               {"unknown", mesh.unknown.empty() ? Json() : Json(mesh.unknown)},
               {"gap", mesh.gap ? Json(*mesh.gap) : Json()},
               {"voxels_agree", agree ? Json(*agree) : Json()}};
  if (mesh.betti)
    json["betti"] = {{"b0", mesh.betti->b0}, {"b1", mesh.betti->b1}, {"b2", mesh.betti->b2}};
  return json;
}

void write_json(std::ostream& out, const LoopsRun& run) { write_document(out, run, &run); }

void write_count_json(std::ostream& out, const CountRun& run) { write_document(out, run, nullptr); }

}  // namespace isoloop
