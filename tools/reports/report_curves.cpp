#include "tools/reports/report_curves.h"

#include <array>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/errors.h"
#include "tools/drawings/colours.h"
#include "tools/reports/report_table.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

using Json = nlohmann::ordered_json;

/// Calls visit(loop, number of the curve within it, its points in the frame of the input).
template <class Visit>
void for_each_curve(const LoopsRun& run, const Visit& visit) {
  for (const Loop& loop : run.reported) {
    std::size_t number = 0;
    for (std::vector<Vec3>& curve : drawn_curves(run.analysis.surface, loop)) {
      for (Vec3& point : curve) point = to_world(run.volume, point);
      visit(loop, number++, curve);
    }
  }
}

std::string point_text(const Vec3& point) {
  return shortest_text(static_cast<float>(point[0])) + ' ' +
         shortest_text(static_cast<float>(point[1])) + ' ' +
         shortest_text(static_cast<float>(point[2]));
}

template <class ValueOf>
void write_cell_array(std::ostream& out, const LoopsRun& run, const char* type, const char* name,
                      const ValueOf& value_of) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\">";
  for_each_curve(run, [&](const Loop& loop, std::size_t, const std::vector<Vec3>&) {
    out << ' ' << shortest_text(value_of(loop));
  });
  out << "</DataArray>\n";
}

/// Of 1, to two places.
std::array<double, 3> shares_of(const Colour& colour) {
  std::array<double, 3> shares{};
  for (std::size_t i = 0; i < 3; ++i) shares[i] = std::round(100.0 * colour[i] / 255.0) / 100.0;
  return shares;
}

}  // namespace

void write_curves_vtp(std::ostream& out, const LoopsRun& run) {
  std::size_t points = 0;
  std::size_t curves = 0;
  for_each_curve(run, [&](const Loop&, std::size_t, const std::vector<Vec3>& curve) {
    points += curve.size();
    ++curves;
  });
  out << "<?xml version=\"1.0\"?>\n<!-- isoloop: " << frame_comment(run)
      << " -->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      << "<PolyData><Piece NumberOfPoints=\"" << points << "\" NumberOfLines=\"" << curves
      << "\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for_each_curve(run, [&](const Loop&, std::size_t, const std::vector<Vec3>& curve) {
    for (const Vec3& point : curve) out << point_text(point) << '\n';
  });
  out << "</DataArray></Points>\n<Lines><DataArray type=\"Int64\" Name=\"connectivity\" "
         "format=\"ascii\">\n";
  std::size_t first = 0;
  for_each_curve(run, [&](const Loop&, std::size_t, const std::vector<Vec3>& curve) {
    for (std::size_t i = 0; i < curve.size(); ++i) out << first + i << ' ';
    out << first << '\n';
    first += curve.size();
  });
  out << "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t end = 0;
  for_each_curve(run, [&](const Loop&, std::size_t, const std::vector<Vec3>& curve) {
    end += curve.size() + 1;
    out << end << ' ';
  });
  out << "</DataArray></Lines>\n<CellData>\n";
  write_cell_array(out, run, "Int32", "loop", [](const Loop& loop) { return loop.id; });
  write_cell_array(out, run, "Int32", "kind",
                   [](const Loop& loop) { return static_cast<int>(loop.kind); });
  write_cell_array(out, run, "Float64", "size",
                   [](const Loop& loop) { return std::isfinite(loop.size) ? loop.size : -1.0; });
  write_cell_array(out, run, "Float64", "length", [](const Loop& loop) { return loop.length; });
  out << "</CellData></Piece></PolyData></VTKFile>\n";
}

void write_curves_obj(std::ostream& out, const LoopsRun& run) {
  out << "# isoloop: " << frame_comment(run) << '\n';
  std::size_t next = 1;
  for_each_curve(run, [&](const Loop& loop, std::size_t number, const std::vector<Vec3>& curve) {
    if (number == 0) out << "o " << kind_text(loop.kind) << '_' << loop.id << '\n';
    for (const Vec3& point : curve) out << "v " << point_text(point) << '\n';
    out << 'l';
    for (std::size_t i = 0; i < curve.size(); ++i) out << ' ' << next + i;
    out << ' ' << next << '\n';
    next += curve.size();
  });
}

void write_curves_mrk(std::ostream& out, const LoopsRun& run) {
  Json markups = Json::array();
  for_each_curve(run, [&](const Loop& loop, std::size_t number, const std::vector<Vec3>& curve) {
    Json points = Json::array();
    for (const Vec3& point : curve)
      points.push_back({{"id", std::to_string(points.size() + 1)}, {"position", point}});
    std::string name = kind_text(loop.kind) + ' ' + std::to_string(loop.id);
    if (loop.curves.size() > 1) name += ", curve " + std::to_string(number + 1);
    const auto colour = shares_of(colour_of(loop.kind));
    markups.push_back({{"type", "ClosedCurve"},
                       {"coordinateSystem", run.volume.frame == Frame::ras ? "RAS" : "LPS"},
                       {"name", name},
                       {"description", "size " + shortest_text(loop.size) + ", length " +
                                           shortest_text(loop.length) + ", " + frame_comment(run)},
                       {"locked", true},
                       {"controlPoints", std::move(points)},
                       {"display",
                        {{"color", colour},
                         {"selectedColor", colour},
                         {"pointLabelsVisibility", false},
                         {"propertiesLabelVisibility", true},
                         {"glyphScale", 0.5}}}});
  });
  const Json file = {
      {"@schema",
       "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
       "Schema/markups-schema-v1.0.3.json#"},
      {"markups", std::move(markups)}};
  out << file.dump(1) << '\n';
}

LoopsReport curves_report(const std::string& name) {
  if (name.ends_with(".vtp")) return write_curves_vtp;
  if (name.ends_with(".obj")) return write_curves_obj;
  if (name.ends_with(".mrk.json")) return write_curves_mrk;
  throw InvalidArgument("--curves " + name + ": loops are written as .vtp, .obj and .mrk.json");
}

}  // namespace isoloop
