#include "tools/page/page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "tools/page/drawn_surface.h"
#include "tools/page/viewer_files.h"
#include "tools/reports/report_features.h"
#include "tools/reports/report_table.h"
#include "tools/reports/scan_plot.h"
#include "tools/words/base64.h"
#include "tools/words/flag_checks.h"
#include "tools/words/json_text.h"
#include "tools/words/largest.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

/// The box that all positions are rounded in.
struct Box {
  Vec3 lower{};
  Vec3 upper{};

  std::uint16_t share(double x, std::size_t axis) const {
    const double extent = upper[axis] - lower[axis];
    if (!(extent > 0)) return 0;
    return static_cast<std::uint16_t>(
        std::lround(std::clamp((x - lower[axis]) / extent, 0.0, 1.0) * 65535.0));
  }
};

void append_point(std::vector<std::uint8_t>& bytes, const Box& box, const Vec3& point) {
  for (std::size_t a = 0; a < 3; ++a) append_little_endian(bytes, box.share(point[a], a));
}

Vec3 world_point(const LoopsRun& run, const std::array<float, 3>& point) {
  return to_world(run.volume, {point[0], point[1], point[2]});
}

/// Of the surface; where there is none, of the volume.
Box box_of(const LoopsRun& run) {
  constexpr double most = std::numeric_limits<double>::max();
  Box box{{most, most, most}, {-most, -most, -most}};
  const auto include = [&](const Vec3& point) {
    for (std::size_t a = 0; a < 3; ++a) {
      box.lower[a] = std::min(box.lower[a], point[a]);
      box.upper[a] = std::max(box.upper[a], point[a]);
    }
  };
  for (const auto& point : run.analysis.surface.points) include(world_point(run, point));
  if (run.analysis.surface.points.empty()) {
    const Index3& dims = run.volume.dims;
    for (int corner = 0; corner < 8; ++corner)
      include(to_world(run.volume, {(corner & 1) != 0 ? static_cast<double>(dims[0] - 1) : 0.0,
                                    (corner & 2) != 0 ? static_cast<double>(dims[1] - 1) : 0.0,
                                    (corner & 4) != 0 ? static_cast<double>(dims[2] - 1) : 0.0}));
  }
  return box;
}

Json mesh_of(const LoopsRun& run, const Box& box, const DrawnSurface& drawn) {
  const TriangleMesh& mesh = drawn.mesh;
  std::vector<std::uint8_t> positions;
  for (const Vec3& point : mesh.points) append_point(positions, box, point);
  const bool mirrored = frame_mirrors(run.volume);
  std::vector<std::uint8_t> corners;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const std::uint32_t corner : {a, mirrored ? c : b, mirrored ? b : c})
      append_little_endian(corners, corner);
  Json pieces = Json::array();
  for (const DrawnPiece& piece : drawn.pieces)
    pieces.push_back({piece.component, piece.triangles, piece.area});
  return {{"vertices", mesh.points.size()},       {"triangles", mesh.triangles.size()},
          {"same_topology", drawn.same_topology}, {"pieces", std::move(pieces)},
          {"positions", base64(positions)},       {"corners", base64(corners)}};
}

/// Seven bits a byte, the low ones first; the eighth bit of all but the last byte is 1 (LEB128).
void append_varying(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
  for (; number >= 0x80; number >>= 7) bytes.push_back(static_cast<std::uint8_t>(number | 0x80U));
  bytes.push_back(static_cast<std::uint8_t>(number));
}

/// The points of the drawn mesh that lie in the feature: how many to pass over, how many to take,
/// and so on.
std::string points_of(const Feature& feature, const DrawnSurface& drawn) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t last = 0;  // end of the last run
  std::uint32_t start = 0;
  std::uint32_t end = 0;
  const auto append_run = [&] {
    if (end == start) return;
    append_varying(bytes, start - last);
    append_varying(bytes, end - start);
    last = end;
  };
  for (const std::uint32_t vertex : feature.vertices) {
    const std::uint32_t point = drawn.point_of_vertex[vertex];
    if (point == not_drawn) continue;
    if (point != end) {
      append_run();
      start = point;
    }
    end = point + 1;
  }
  append_run();
  return base64(bytes);
}

Json loop_of(const LoopsRun& run, const Box& box, const DrawnSurface& drawn, const Loop& loop) {
  Json curves = Json::array();
  for (const std::vector<Vec3>& curve : drawn_curves(run.analysis.surface, loop)) {
    std::vector<std::uint8_t> points;
    for (const Vec3& point : curve) append_point(points, box, to_world(run.volume, point));
    curves.push_back(base64(points));
  }
  Json json{{"id", loop.id},
            {"kind", kind_text(loop.kind)},
            {"fix", fix_text(loop.kind)},
            {"length", loop.length},
            {"size", loop.size},  // null where it is infinite
            {"component", loop.component},
            {"index", loop.center_index},
            {"world", to_world(run.volume, loop.center_index)},
            {"curves", std::move(curves)}};
  if (!run.features.empty()) {
    const Feature& feature = run.features[place_of(run, loop)];
    json["feature"] = {{"depth", feature.depth},
                       {"thickness", feature.thickness()},
                       {"points", points_of(feature, drawn)}};
  }
  return json;
}

/// The volume in blocks of `block` voxels along each axis: mean values, the range of the voxels as
/// 0 to 255.
Json blocks_of(const LoopsRun& run, const PageOptions& options) {
  const Index3& dims = run.volume.dims;
  std::int64_t block = 1;
  Index3 blocks = dims;
  const auto count = [&] { return static_cast<std::size_t>(blocks[0] * blocks[1] * blocks[2]); };
  while (count() > options.most_voxels) {
    ++block;
    for (std::size_t a = 0; a < 3; ++a) blocks[a] = (dims[a] + block - 1) / block;
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(count());
  const double span = run.range.max - run.range.min;
  const bool finite = std::isfinite(span) && span > 0;
  std::visit(
      [&](const auto& grid) {
        for (std::int64_t z = 0; z < dims[2]; z += block)
          for (std::int64_t y = 0; y < dims[1]; y += block)
            for (std::int64_t x = 0; x < dims[0]; x += block) {
              double sum = 0.0;
              std::int64_t voxels = 0;
              for (std::int64_t k = z; k < std::min(z + block, dims[2]); ++k)
                for (std::int64_t j = y; j < std::min(y + block, dims[1]); ++j)
                  for (std::int64_t i = x; i < std::min(x + block, dims[0]); ++i, ++voxels)
                    sum += static_cast<double>(
                        grid.values[static_cast<std::size_t>(i + dims[0] * (j + dims[1] * k))]);
              const double share =
                  finite ? (sum / static_cast<double>(voxels) - run.range.min) / span : 0.0;
              bytes.push_back(static_cast<std::uint8_t>(
                  std::isfinite(share) ? std::lround(255.0 * std::clamp(share, 0.0, 1.0)) : 0));
            }
      },
      voxels_of(run));
  return {{"dims", blocks},
          {"block", block},
          {"iso_share", finite ? (run.level.iso - run.range.min) / span : 0.0},
          {"values", base64(bytes)}};
}

/// The loops of a page, and what it lacks.
struct PageLoops {
  Json drawn = Json::array();  // in the order of the report
  std::size_t left_out = 0;
  double size_left_out = 0.0;  // of the largest of these
};

/// The largest loops whose text has room.
PageLoops loops_of(const LoopsRun& run, const Box& box, const DrawnSurface& drawn,
                   std::size_t most_bytes) {
  PageLoops loops;
  std::vector<std::pair<std::size_t, Json>> chosen;
  std::size_t bytes = 0;
  for (const std::size_t place : largest_first(run.reported, &Loop::size)) {
    Json loop = loop_of(run, box, drawn, run.reported[place]);
    bytes += loop.dump().size();
    if (bytes > most_bytes) {
      loops.left_out = run.reported.size() - chosen.size();
      loops.size_left_out = run.reported[place].size;
      break;
    }
    chosen.emplace_back(place, std::move(loop));
  }
  std::sort(chosen.begin(), chosen.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [place, loop] : chosen) loops.drawn.push_back(std::move(loop));
  return loops;
}

/// Text and what it lacks.
struct PageData {
  Json json;
  LeftOut left_out;
};

PageData data_of(const LoopsRun& run, const PageOptions& options) {
  const Surface& surface = run.analysis.surface;
  const Betti& betti = run.analysis.betti;
  const Volume& volume = run.volume;
  const Box box = box_of(run);
  const DrawnSurface drawn = drawn_surface(run, options.most_triangles, options.most_pieces);
  PageLoops loops = loops_of(run, box, drawn, options.most_loop_bytes);
  const LeftOut left_out{.pieces = drawn.pieces_left_out, .loops = loops.left_out};
  Json json{{"schema", "isoloop/page/1"},
            {"file", run.file},
            {"dims", volume.dims},
            {"type", type_name(volume.values)},
            {"spacing", volume.spacing},
            {"origin", volume.origin},
            {"direction", volume.direction},
            {"frame", frame_name(volume.frame)},
            {"iso", run.level.iso},
            {"inside", inside_text(run)},
            {"open", surface.boundary == Boundary::open},
            {"decimals", length_decimals(volume.spacing)},
            {"unit", volume.unit},
            {"surface",
             {{"vertices", surface.points.size()},
              {"triangles", surface.triangles.size()},
              {"components", surface.components.size()},
              {"euler", surface.euler()},
              {"genus", surface.genus()}}},
            {"betti", {{"b0", betti.b0}, {"b1", betti.b1}, {"b2", betti.b2}}},
            {"found", run.analysis.loops.size()},
            {"box", {{"lower", box.lower}, {"upper", box.upper}}},
            {"left_out",
             {{"pieces", drawn.pieces_left_out},
              {"piece_area", drawn.area_left_out},
              {"loops", loops.left_out},
              {"loop_size", loops.size_left_out}}},
            {"mesh", mesh_of(run, box, drawn)},
            {"volume", blocks_of(run, options)},
            {"loops", std::move(loops.drawn)}};
  return {std::move(json), left_out};
}

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<') {
      escaped += "&lt;";
    } else if (c == '&') {
      escaped += "&amp;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

/// No "</script>" within.
std::string script_text(const Json& json) {
  std::string text = line_of(json);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

std::string plot_text(const LoopsRun& run) {
  if (!run.scan) return "";
  std::ostringstream plot;
  plot << "<details id=\"scan\"><summary>Counts over the iso value</summary>";
  write_scan_svg(plot, *run.scan, run.level.inside);
  plot << "</details>";
  return plot.str();
}

}  // namespace

void add_page_flags(CLI::App& command, PageOptions& options) {
  want_whole_number(
      command
          .add_option("--triangles", options.most_triangles,
                      "of the surface on the page: it is simplified, its topology stays")
          ->type_name("N")
          ->capture_default_str(),
      1);
}

std::string left_out_text(const LeftOut& left_out) {
  const auto count = [](std::size_t n, const std::string& one, const std::string& many) {
    return counted(static_cast<std::int64_t>(n), one, many);
  };
  std::string text;
  if (left_out.pieces > 0) text += count(left_out.pieces, "small piece", "small pieces");
  if (left_out.pieces > 0 && left_out.loops > 0) text += " and ";
  if (left_out.loops > 0) text += count(left_out.loops, "small loop", "small loops");
  return text.empty() ? text : ", which leaves out " + text;
}

LeftOut write_page(std::ostream& out, const LoopsRun& run, const PageOptions& options) {
  const PageData data = data_of(run, options);
  std::string page;
  for (const std::string_view piece : viewer_page()) page += piece;
  std::size_t at = 0;
  // Text up to a marker; the marker itself is passed over.
  const auto write_until = [&](std::string_view marker) {
    const std::size_t next = page.find(marker, at);
    out << std::string_view(page).substr(at, next - at);
    at = next + marker.size();
  };
  write_until("{{title}}");
  out << html_text(run.file) << ", " << inside_text(run.level);
  write_until("{{plot}}");
  out << plot_text(run);
  write_until("{{data}}");
  out << script_text(data.json);
  write_until("{{viewer}}");
  for (const std::string_view piece : viewer_script()) out << piece;
  out << std::string_view(page).substr(at);
  return data.left_out;
}

}  // namespace isoloop
