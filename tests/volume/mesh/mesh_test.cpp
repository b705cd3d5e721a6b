#include "volume/mesh/mesh.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/mesh/mesh_closure.h"

namespace isoloop {
namespace {

using test::box_mesh;
using test::contains;
using test::mesh_bytes;
using test::MeshFormat;
using test::message_of;
using test::parsed;
using test::sample_box;
using test::TempFolder;
using test::write_bytes;

constexpr std::array<MeshFormat, 7> all_formats{
    MeshFormat::stl_ascii, MeshFormat::stl_binary, MeshFormat::ply_ascii, MeshFormat::ply_little,
    MeshFormat::ply_big,   MeshFormat::obj,        MeshFormat::off};

/// The corners' coordinates, triangle by triangle.
std::vector<Vec3> soup(const Mesh& mesh) {
  std::vector<Vec3> corners;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) corners.push_back(mesh.points.at(corner));
  }
  return corners;
}

TEST(MeshReader, ReadsOneMeshFromEachFormat) {
  for (const MeshFormat format : all_formats) {
    const Mesh mesh = parsed(mesh_bytes(sample_box(), format), format);
    EXPECT_EQ(soup(mesh), soup(sample_box())) << static_cast<int>(format);
    EXPECT_EQ(closure_of(mesh).one_way_edges, 0U) << static_cast<int>(format);
  }
}

/// Whether nothing that counts is missing from a file cut to `length` bytes: but for the end of the
/// last line, and in an STL file for the name after the word endsolid.
bool is_whole_but_for_an_end(const std::string& whole, std::size_t length, MeshFormat format) {
  if (format == MeshFormat::stl_ascii) {
    const std::string part = whole.substr(0, length);
    return part.ends_with("endsolid") || part.ends_with("endsolid ") || length + 1 == whole.size();
  }
  const bool is_text =
      format == MeshFormat::ply_ascii || format == MeshFormat::obj || format == MeshFormat::off;
  return is_text && length + 1 == whole.size();
}

TEST(MeshReader, RefusesAFileTruncatedAtAnyByte) {
  for (const MeshFormat format : all_formats) {
    const std::string whole = mesh_bytes(sample_box(), format);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const std::string part = whole.substr(0, length);
      // An OBJ file states no counts: cut at the end of a line it is a mesh with a hole.
      const bool line_of_obj =
          format == MeshFormat::obj && part.ends_with('\n') && contains(part, "\nf ");
      if (line_of_obj) {
        EXPECT_GT(closure_of(parsed(part, format)).open_edges, 0U) << length;
      } else if (is_whole_but_for_an_end(whole, length, format)) {
        EXPECT_EQ(soup(parsed(part, format)), soup(sample_box())) << part.substr(length - 20);
      } else {
        EXPECT_THROW(parsed(part, format), InvalidInput)
            << length << " of " << whole.size() << ", format " << static_cast<int>(format);
      }
    }
  }
}

TEST(MeshReader, RefusesWhatFollowsTheEnd) {
  for (const MeshFormat format : all_formats) {
    const std::string more = format == MeshFormat::obj ? "1 2 3\n" : "x\n";
    EXPECT_THROW(parsed(mesh_bytes(sample_box(), format) + more, format), InvalidInput)
        << static_cast<int>(format);
  }
}

TEST(MeshReader, NamesLineOrByteOfWhatIsGarbled) {
  const auto expect = [](const std::string& bytes, MeshFormat format, const char* part) {
    const std::string message = message_of<InvalidInput>([&] { parsed(bytes, format); });
    EXPECT_TRUE(contains(message, "a.mesh: ") && contains(message, part)) << message;
  };
  expect("OFF\n3 1 0\n0 0 0\n1 0 x7\n0 1 0\n3 0 1 2\n", MeshFormat::off, "line 4: 'x7'");
  expect("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", MeshFormat::off, "line 6: '3'");
  expect("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n", MeshFormat::off, "line 5: 'nan'");
  expect("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", MeshFormat::obj, "line 4: '4'");
  expect("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", MeshFormat::obj, "line 4: corners");
  expect("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", MeshFormat::obj, "line 4: a face");
  expect("v 0 0 0\n1 0 0\n", MeshFormat::obj, "line 2: no OBJ statement");
  expect("v 0 0 0\nsurf 0 1 0 1 1\n", MeshFormat::obj, "line 2: free-form surfaces");
  expect("v 0 0 1e999\n", MeshFormat::obj, "line 1: '1e999'");
  expect("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", MeshFormat::stl_ascii, "line 4");
  std::string ply = mesh_bytes(sample_box(), MeshFormat::ply_little);
  ply[ply.size() - 4] = 99;  // a corner
  expect(ply, MeshFormat::ply_little, "byte ");
  std::string stl = mesh_bytes(sample_box(), MeshFormat::stl_binary);
  stl[84 + 12 + 3] = '\x7f';
  stl[84 + 12 + 2] = '\xc0';  // nan
  expect(stl, MeshFormat::stl_binary, "byte 96");
  stl = mesh_bytes(sample_box(), MeshFormat::stl_binary);
  expect(stl.substr(0, 500), MeshFormat::stl_binary, "the 12 triangles that it states take 684");
}

TEST(MeshReader, BelievesNoCountThatTheFileCannotHold) {
  const std::string many = "4000000000";
  EXPECT_THROW(parsed("OFF\n" + many + " 1 0\n0 0 0\n", MeshFormat::off), InvalidInput);
  EXPECT_THROW(parsed("OFF\n1 " + many + " 0\n0 0 0\n", MeshFormat::off), InvalidInput);
  for (const std::string format : {"ascii", "binary_little_endian"}) {
    const std::string head = "ply\nformat " + format + " 1.0\nelement vertex ";
    const std::string tail = "\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string face = "element face 1\nproperty list uint int vertex_indices\nend_header\n";
    EXPECT_THROW(parsed(head + many + tail + face + "0 0 0\n", MeshFormat::ply_ascii),
                 InvalidInput);
    EXPECT_THROW(parsed(head + "0" + tail + face + "4000000000 1 2 3\n", MeshFormat::ply_ascii),
                 InvalidInput);
  }
}

TEST(MeshReader, PolygonsBecomeFans) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const Mesh mesh = parsed(points + "f -4/1 -3/2/3 3//1 4\n", MeshFormat::obj);
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
  const Mesh coloured = parsed(
      "COFF\n4 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n"
      "4 0 1 2 3 255 0 0\n",
      MeshFormat::off);
  EXPECT_EQ(coloured.triangles, mesh.triangles);
}

TEST(MeshReader, PointsOfEqualPlaceAreOne) {
  const Mesh mesh =
      parsed("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0.0 0 0\nf 1 2 3\nf 4 3 2\nf 1 4 2\n", MeshFormat::obj);
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 1}}));
}

TEST(MeshReader, RefusesAMeshWithoutTriangles) {
  for (const std::string text : {"v 0 0 0\n", "v 0 0 0\nv 1 1 1\nf 1 2 2\n", "\n"}) {
    EXPECT_TRUE(
        contains(message_of<InvalidInput>([&] { parsed(text, MeshFormat::obj); }), "no triangle"));
  }
}

TEST(MeshReader, GoesByTheExtensionAndKeepsToItsLimit) {
  const TempFolder folder;
  const std::string bytes = mesh_bytes(sample_box(), MeshFormat::off);
  write_bytes(folder / "a.OFF", bytes);
  EXPECT_TRUE(is_mesh(folder / "a.OFF"));
  EXPECT_FALSE(is_mesh(folder / "a.vdb"));
  EXPECT_EQ(read_mesh(folder / "a.OFF").triangles.size(), 12U);
  const auto error =
      test::error_of<LimitExceeded>([&] { read_mesh(folder / "a.OFF", bytes.size() * 15); });
  EXPECT_TRUE(test::advises(error.finding, Advice::raise_memory_limit));
  EXPECT_EQ(error.excess.needed, bytes.size() * 16);
  EXPECT_EQ(error.excess.limit, bytes.size() * 15);
  EXPECT_THROW(read_mesh(folder / "none.stl"), InvalidInput);
}

TEST(MeshClosure, CountsEdgesThatDoNotClose) {
  Mesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(closure_of(mesh).open_edges, 0U);
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_EQ(closure_of(mesh).open_edges, 0U);
  EXPECT_EQ(closure_of(mesh).one_way_edges, 3U);
  mesh.triangles.erase(mesh.triangles.begin());
  EXPECT_EQ(closure_of(mesh).open_edges, 3U);
}

}  // namespace
}  // namespace isoloop
