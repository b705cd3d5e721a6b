#include "tools/reports/report_mesh.h"

#include <array>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/samples/sample_run.h"
#include "tools/drawings/tube.h"

namespace isoloop {
namespace {

struct Vertex {
  std::array<float, 3> position{};
  std::array<std::uint8_t, 3> colour{};
  std::int32_t label = -1;  // of files that state one
};

struct Mesh {
  std::string header;
  std::vector<Vertex> vertices;
  std::vector<std::array<std::int32_t, 3>> faces;
};

std::size_t count_after(const std::string& header, const std::string& words) {
  return std::stoul(header.substr(header.find(words) + words.size()));
}

// Reads what a PLY reader on a little-endian machine would.
Mesh mesh_of(const LoopsRun& run) {
  std::ostringstream out;
  write_ply(out, run);
  const std::string bytes = out.str();
  Mesh mesh;
  std::size_t place = bytes.find("end_header\n") + std::strlen("end_header\n");
  mesh.header = bytes.substr(0, place);
  mesh.vertices.resize(count_after(mesh.header, "element vertex "));
  mesh.faces.resize(count_after(mesh.header, "element face "));
  const bool labelled = mesh.header.find("property int label\n") != std::string::npos;
  const std::size_t vertex_bytes = labelled ? 19 : 15;
  EXPECT_EQ(bytes.size(), place + vertex_bytes * mesh.vertices.size() + 13 * mesh.faces.size());
  for (Vertex& vertex : mesh.vertices) {
    std::memcpy(vertex.position.data(), bytes.data() + place, 12);
    std::memcpy(vertex.colour.data(), bytes.data() + place + 12, 3);
    if (labelled) std::memcpy(&vertex.label, bytes.data() + place + 15, 4);
    place += vertex_bytes;
  }
  for (auto& face : mesh.faces) {
    EXPECT_EQ(bytes[place], 3);
    std::memcpy(face.data(), bytes.data() + place + 1, 12);
    place += 13;
  }
  return mesh;
}

bool is_green(const Vertex& v) { return v.colour[1] > v.colour[0] + 100; }
bool is_red(const Vertex& v) { return v.colour[0] > v.colour[1] + 100; }
bool is_grey(const Vertex& v) { return v.colour[0] == v.colour[1] && v.colour[1] == v.colour[2]; }

TEST(ReportMesh, HoldsTheSurfaceAndATubeForEachLoop) {
  const Mesh mesh = mesh_of(torus_run());
  EXPECT_EQ(mesh.vertices.size(), 9 + 2 * 3 * tube_sides);
  EXPECT_EQ(mesh.faces.size(), 18 + 2 * 6 * tube_sides);
  for (const auto& face : mesh.faces) {
    for (const std::int32_t corner : face) {
      EXPECT_GE(corner, 0);
      EXPECT_LT(corner, static_cast<std::int32_t>(mesh.vertices.size()));
    }
  }
}

TEST(ReportMesh, LabelsVerticesWhereItTellsOfFeatures) {
  const Mesh mesh = mesh_of(torus_run_with_features());
  constexpr std::size_t one_tube = std::size_t{3} * tube_sides;
  ASSERT_EQ(mesh.vertices.size(), 9 + 2 * one_tube);
  const std::vector<std::int32_t> labels{1, 1, 1, 1, 1, 1, 2, 2, 0};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(mesh.vertices[i].label, labels[i]);
  for (std::size_t i = 0; i < 2 * one_tube; ++i)
    EXPECT_EQ(mesh.vertices[9 + i].label, i < one_tube ? 1 : 2);
  EXPECT_EQ(mesh_of(torus_run()).vertices[0].label, -1) << "without features no label";
}

TEST(ReportMesh, DrawsGeodesicsWhereThereAreAny) {
  LoopsRun run = torus_run();
  run.reported[0].geodesics = {{{{0, 1}, 0.5}, {{1, 2}, 0.5}, {{2, 2}, 0.0}, {{2, 0}, 0.25}}};
  const Mesh mesh = mesh_of(run);
  EXPECT_EQ(mesh.vertices.size(), 9 + (4 + 3) * tube_sides);
  EXPECT_EQ(mesh.faces.size(), 18 + 2 * (4 + 3) * tube_sides);
}

TEST(ReportMesh, PaintsHandlesGreenAndTunnelsRed) {
  const Mesh mesh = mesh_of(torus_run());
  EXPECT_TRUE(is_green(mesh.vertices[0]));
  EXPECT_TRUE(is_green(mesh.vertices[1]));
  EXPECT_TRUE(is_red(mesh.vertices[3]));
  EXPECT_TRUE(is_grey(mesh.vertices[4]));
  constexpr std::size_t one_tube = std::size_t{3} * tube_sides;
  for (std::size_t i = 0; i < one_tube; ++i) {
    EXPECT_TRUE(is_green(mesh.vertices[9 + i]));
    EXPECT_TRUE(is_red(mesh.vertices[9 + one_tube + i]));
  }
}

TEST(ReportMesh, PaintsLoopsOfAnOpenBoundaryBlue) {
  const Mesh mesh = mesh_of(open_run());
  ASSERT_EQ(mesh.vertices.size(), 9 + 3 * tube_sides);
  const auto is_blue = [](const Vertex& v) { return v.colour[2] > v.colour[0] + 100; };
  for (const std::size_t i : {0, 1, 2, 9}) EXPECT_TRUE(is_blue(mesh.vertices[i])) << i;
  EXPECT_TRUE(is_grey(mesh.vertices[3]));
}

TEST(ReportMesh, PutsPointsInTheWorldFrame) {
  const Mesh mesh = mesh_of(torus_run());
  EXPECT_FLOAT_EQ(mesh.vertices[0].position[0], 104.5F);
  EXPECT_FLOAT_EQ(mesh.vertices[0].position[1], 2.5F);
  EXPECT_NE(mesh.header.find("comment frame world"), std::string::npos);
}

TEST(ReportMesh, TubesHaveAQuarterVoxelRadius) {
  const Mesh mesh = mesh_of(torus_run());
  const auto& centre = mesh.vertices[0].position;
  const auto& point = mesh.vertices[9].position;
  EXPECT_NEAR(std::hypot(point[0] - centre[0], point[1] - centre[1], point[2] - centre[2]),
              0.25 * 0.5, 1e-4);
}

TEST(ReportMesh, TurnsTrianglesOverWhereTheFrameMirrors) {
  LoopsRun run = torus_run();
  const Mesh straight = mesh_of(run);
  run.volume.direction[0] = {-1, 0, 0};
  const Mesh mirrored = mesh_of(run);
  EXPECT_EQ(straight.faces[0][1], mirrored.faces[0][2]);
  EXPECT_EQ(straight.faces[0][2], mirrored.faces[0][1]);
}

TEST(ReportMesh, WritesAnEmptySurface) {
  const Mesh mesh = mesh_of(empty_run());
  EXPECT_TRUE(mesh.vertices.empty());
  EXPECT_TRUE(mesh.faces.empty());
}

TEST(ReportMesh, DrawsReportedLoopsOnly) {
  LoopsRun run = torus_run();
  run.reported.pop_back();
  const Mesh mesh = mesh_of(run);
  EXPECT_EQ(mesh.vertices.size(), 9 + 3 * tube_sides);
  EXPECT_TRUE(is_grey(mesh.vertices[3]));
}

}  // namespace
}  // namespace isoloop
