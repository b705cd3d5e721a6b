// Mesh files that are whole but untidy are read as what they are, with a word where something was
// assumed.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/volume_test_files.h"
#include "volume/mesh/mesh.h"
#include "volume/voxelize/voxelize.h"

namespace isoloop {
namespace {

using test::contains;
using test::mesh_bytes;
using test::MeshFormat;
using test::message_of;
using test::parsed;
using test::sample_box;

constexpr std::array<MeshFormat, 4> text_formats{MeshFormat::stl_ascii, MeshFormat::ply_ascii,
                                                 MeshFormat::obj, MeshFormat::off};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Reads as the sample, without a warning.
void expect_tidy(const std::string& bytes, MeshFormat format, const char* how) {
  const Mesh mesh = parsed(bytes, format);
  EXPECT_EQ(mesh.triangles.size(), sample_box().triangles.size()) << how;
  EXPECT_TRUE(mesh.warnings.empty()) << how << ": " << mesh.warnings.front().text;
}

/// Reads as the sample, with one warning that holds `part`.
void expect_warning(const std::string& bytes, MeshFormat format, const std::string& part) {
  const Mesh mesh = parsed(bytes, format);
  EXPECT_EQ(mesh.triangles.size(), sample_box().triangles.size()) << part;
  ASSERT_EQ(mesh.warnings.size(), 1U) << part;
  EXPECT_TRUE(contains(mesh.warnings[0].text, part)) << mesh.warnings[0].text;
}

TEST(UntidyMesh, LinesEndAsOnAnySystem) {
  for (const MeshFormat format : text_formats) {
    const std::string text = mesh_bytes(sample_box(), format);
    expect_tidy(replaced(text, "\n", "\r\n"), format, "CR LF");
    expect_tidy(replaced(text, "\n", "\r"), format, "CR");
    expect_tidy("\xef\xbb\xbf" + text, format, "a byte order mark");
    expect_tidy(replaced(text, " ", "\t"), format, "tabs");
    expect_tidy(replaced(text, "\n", " \n"), format, "blanks at the ends");
  }
  const std::string mixed = replaced(mesh_bytes(sample_box(), MeshFormat::obj), "f", "\r\n\n\rf");
  expect_tidy(mixed, MeshFormat::obj, "all at once");
}

TEST(UntidyMesh, TheHeaderOfABinaryPlyFileMayEndItsLinesAsOnAnySystem) {
  for (const MeshFormat format : {MeshFormat::ply_little, MeshFormat::ply_big}) {
    const std::string file = mesh_bytes(sample_box(), format);
    const std::size_t body = file.find("end_header\n") + 11;
    for (const char* end : {"\r\n", "\r"}) {
      expect_tidy(replaced(file.substr(0, body), "\n", end) + file.substr(body), format, end);
    }
  }
  // The body begins with the byte of "\n".
  const std::string head =
      "ply\rformat binary_little_endian 1.0\relement mark 1\rproperty uchar m\relement vertex 0\r"
      "property float x\rproperty float y\rproperty float z\rend_header\r";
  EXPECT_TRUE(
      contains(message_of<InvalidInput>([&] { parsed(head + "\n", MeshFormat::ply_little); }),
               "no triangle"));
}

TEST(UntidyMesh, TheLastLineNeedsNoEndWhereNothingCanBeMissing) {
  for (const MeshFormat format : text_formats) {
    std::string text = mesh_bytes(sample_box(), format);
    text.pop_back();
    expect_warning(text, format, "last line has no end");
  }
  std::string comment = mesh_bytes(sample_box(), MeshFormat::obj) + "# end of fi";
  expect_warning(comment, MeshFormat::obj, "last line has no end");
  expect_tidy(mesh_bytes(sample_box(), MeshFormat::obj) + "  ", MeshFormat::obj, "blanks");
}

TEST(UntidyMesh, ACutWithinTheLastFaceIsToldByTheHoleThatItLeaves) {
  const Mesh torus = test::torus_mesh({0, 0, 0}, 3, 1, 40, 30);  // corners of up to four digits
  for (const MeshFormat format : {MeshFormat::ply_ascii, MeshFormat::obj, MeshFormat::off}) {
    const std::string whole = mesh_bytes(torus, format);
    const std::size_t last_line = whole.rfind('\n', whole.size() - 2) + 1;
    for (std::size_t length = last_line + 1; length + 1 < whole.size(); ++length) {
      EXPECT_THROW(parsed(whole.substr(0, length), format), InvalidInput)
          << whole.substr(last_line);
    }
    EXPECT_EQ(parsed(whole.substr(0, whole.size() - 1), format).triangles.size(), 2400U);
  }
}

// Of an open mesh an end that is missing may hide a digit or a corner.
TEST(UntidyMesh, AnUnendedCornerMustBeProvedWhole) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  std::string twelve;
  for (int i = 0; i < 12; ++i) twelve += std::to_string(i) + " 0 " + std::to_string(i % 5) + "\n";
  EXPECT_EQ(parsed("OFF\n4 1 0\n" + points + "3 0 1 3", MeshFormat::off).warnings.size(), 1U);
  EXPECT_EQ(parsed("OFF\n12 1 0\n" + twelve + "3 0 1 2", MeshFormat::off).warnings.size(), 1U);
  const auto refusal = [](const std::string& text, MeshFormat format) {
    return message_of<InvalidInput>([&] { parsed(text, format); });
  };
  // Of 12 points the corner 1 may be the beginning of 10 or 11.
  EXPECT_TRUE(contains(refusal("OFF\n12 1 0\n" + twelve + "3 0 2 1", MeshFormat::off), "end the"));
  EXPECT_EQ(parsed("OFF\n12 1 0\n" + twelve + "3 0 2 1 255", MeshFormat::off).warnings.size(), 1U);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
      twelve;
  EXPECT_EQ(parsed(ply + "3 0 1 2", MeshFormat::ply_ascii).warnings.size(), 1U);
  EXPECT_TRUE(contains(refusal(ply + "3 0 2 1", MeshFormat::ply_ascii), "may be cut"));
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  EXPECT_TRUE(contains(refusal(obj + "f 1 2 3", MeshFormat::obj), "end the line"));
  EXPECT_TRUE(contains(refusal(obj + "f 1 2 3\nv 1 1 1", MeshFormat::obj), "within a point"));
  EXPECT_NO_THROW(parsed(obj + "f 1 2 3\n", MeshFormat::obj));
}

TEST(UntidyMesh, AsciiStlMayBeWrittenInAnyCase) {
  const std::string text = mesh_bytes(sample_box(), MeshFormat::stl_ascii);
  std::string capitals = text;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  expect_tidy(capitals, MeshFormat::stl_ascii, "capitals");
  expect_tidy(" \n\n\t" + text, MeshFormat::stl_ascii, "blanks before");
  expect_tidy(text + "\n\n", MeshFormat::stl_ascii, "blank lines behind");
  expect_tidy(replaced(text, "endsolid sample", "endsolid"), MeshFormat::stl_ascii, "no name");
  expect_tidy(replaced(text, "endsolid sample", "endsolid other name"), MeshFormat::stl_ascii, "");
  expect_tidy(replaced(text, "solid sample\nfacet", "solid\nfacet"), MeshFormat::stl_ascii, "");
  expect_tidy(replaced(text, "vertex 1 ", "vertex +1.0E+00 "), MeshFormat::stl_ascii, "exponents");
  EXPECT_EQ(parsed(text + text, MeshFormat::stl_ascii).triangles.size(), 24U);
  const std::string message = message_of<InvalidInput>(
      [&] { parsed(replaced(text, "vertex 1 ", "vertex nan "), MeshFormat::stl_ascii); });
  EXPECT_TRUE(contains(message, "line 6: 'nan' is no finite number")) << message;
}

TEST(UntidyMesh, AnUnendedNameOfAStlSolidIsToldFromAWholeOne) {
  std::string text = mesh_bytes(sample_box(), MeshFormat::stl_ascii);
  const std::string bare = text.substr(0, text.size() - 8);
  expect_warning(bare, MeshFormat::stl_ascii, "without further solids");
  expect_warning(bare + " other", MeshFormat::stl_ascii, "last line has no end");
  EXPECT_THROW(parsed(bare + " sam", MeshFormat::stl_ascii), InvalidInput);
}

TEST(UntidyMesh, BinaryStlMayBeginWithTheWordSolid) {
  std::string bytes = mesh_bytes(sample_box(), MeshFormat::stl_binary);
  bytes.replace(0, 5, "solid");
  expect_tidy(bytes, MeshFormat::stl_binary, "solid");
  EXPECT_TRUE(contains(
      message_of<InvalidInput>([&] { parsed(bytes.substr(0, 300), MeshFormat::stl_binary); }),
      "12 triangles that it states"));
}

TEST(UntidyMesh, BinaryStlMayStateFewerTrianglesThanFollow) {
  for (const char* header : {"solid by a program", "a header"}) {
    std::string bytes = mesh_bytes(sample_box(), MeshFormat::stl_binary);
    bytes.replace(0, std::string(header).size(), header);
    const auto stating = [&](const std::string& count) { return bytes.replace(80, 4, count); };
    expect_warning(stating({"\0\0\0\0", 4}), MeshFormat::stl_binary, "0 triangles, but 12 follow");
    expect_warning(stating({"\5\0\0\0", 4}), MeshFormat::stl_binary, "5 triangles, but 12 follow");
    expect_warning(stating("\xff\xff\xff\xff"), MeshFormat::stl_binary, "12 follow");
    EXPECT_THROW(parsed(stating({"\15\0\0\0", 4}), MeshFormat::stl_binary), InvalidInput);
    EXPECT_THROW(parsed(stating({"\0\0\0\0", 4}) + "x", MeshFormat::stl_binary), InvalidInput);
  }
}

TEST(UntidyMesh, ObjStatementsWithoutPolygonsArePassedOver) {
  const std::string text = mesh_bytes(sample_box(), MeshFormat::obj);
  std::string known;
  for (const char* statement :
       {"g a b", "o name", "s off", "usemtl m", "mtllib m.mtl", "vn 0 0 1", "vt 0 1", "vp 0.5",
        "l 1 2", "p 1", "curv 0 1 1 2 3", "cstype bezier", "deg 3", "parm u 0 1", "end"}) {
    known += std::string(statement) + "\n";
  }
  expect_tidy(replaced(text, "f 1 3 2\n", known + "f 1 3 2\n"), MeshFormat::obj, "known");
  expect_warning("sm 1\n" + text + "c 4\nsm 2\n", MeshFormat::obj, "skipped: c (1), sm (2)");
  expect_tidy(replaced(text, "f 1 3 2", "f 1 \\\n 3 \\\n2"), MeshFormat::obj, "continued");
  expect_tidy(replaced(replaced(text, "f ", "F "), "v ", "V "), MeshFormat::obj, "capitals");
  for (const char* other : {"surf 0 1 0 1 1", "bsp 1 2 3", "call other.obj", "3 4 5", "\x01\x02"}) {
    EXPECT_THROW(parsed(text + other + "\n", MeshFormat::obj), InvalidInput) << other;
  }
  std::string many = text;
  for (int i = 0; i < 100; ++i) many += "w" + std::to_string(i) + " 1\n";
  EXPECT_TRUE(
      contains(message_of<InvalidInput>([&] { parsed(many, MeshFormat::obj); }), "too many sorts"));
}

TEST(UntidyMesh, OffPointsMayCarryMoreThanTheirPlace) {
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const auto file = [&](const std::string& head, const std::string& more) {
    return head + "0 0 0" + more + "\n1 0 0" + more + "\n0 1 0" + more + "\n0 0 1" + more + "\n" +
           faces;
  };
  for (const std::string& text :
       {file("COFF\n4 4 0\n", " 1 0 0 1"), file("NOFF\n4 4 0\n", " 0 0 1"),
        file("STOFF\n4 4 0\n", " 0.5 0.5"), file("STCNOFF 4 4 0\n", " 0 0 1 1 0 0 1 0 0"),
        file("NCOFF\n# c\n4 4 0\n", " 0 0 1 1 0 0 1"), file("off\n4 4\n", ""), file("4 4 6\n", ""),
        file("# first\nOFF # word\n\n4 4 6 # counts\n", " # a point")}) {
    EXPECT_EQ(parsed(text, MeshFormat::off).triangles.size(), 4U) << text;
    EXPECT_TRUE(parsed(text, MeshFormat::off).warnings.empty()) << text;
  }
  EXPECT_TRUE(contains(parsed(file("OFF\n4 4 0\n", " 1 0 0"), MeshFormat::off).warnings.at(0).text,
                       "three numbers"));
  for (const char* head :
       {"4OFF\n4 4 0\n", "nOFF\n4 4 0\n", "OFF BINARY\n4 4 0\n", "OFFX\n4 4\n"}) {
    EXPECT_THROW(parsed(file(head, ""), MeshFormat::off), InvalidInput) << head;
  }
  const Mesh small =
      parsed(replaced(file("OFF\n4 6 0\n", ""), "3 0 2 1", "2 0 1\n1 2\n3 0 2 1"), MeshFormat::off);
  EXPECT_EQ(small.triangles.size(), 4U);
  EXPECT_TRUE(contains(small.warnings.at(0).text, "2 faces of fewer than three corners"));
}

TEST(UntidyMesh, PlyMayHoldWhatIsNoSurface) {
  const auto file = [](const std::string& type, const std::string& index,
                       const std::string& quality) {
    return "ply\nformat ascii 1.0\ncomment c\nobj_info by a scanner\nelement vertex 4\n"
           "property float x\nproperty float y\nproperty float z\nproperty float quality\n"
           "element face 4\nproperty uchar flag\nproperty list " +
           type + " " + index +
           " vertex_index\nelement edge 1\nproperty int a\n"
           "property list uchar float weights\nend_header\n0 0 0 " +
           quality +
           "\n1 0 0 1\n0 1 0 1\n0 0 1 1\n7 3 0 2 1\n7 3 0 1 3\n7 3 1 2 3\n7 3 0 3 2\n0 2 nan 1\n";
  };
  for (const char* type : {"char", "uint8", "short", "ushort", "int", "uint32"}) {
    for (const char* index : {"uchar", "int", "uint", "float"}) {
      const Mesh mesh = parsed(file(type, index, "nan"), MeshFormat::ply_ascii);
      EXPECT_EQ(mesh.triangles.size(), 4U) << type << ' ' << index;
      EXPECT_TRUE(mesh.warnings.empty());
    }
  }
  EXPECT_THROW(parsed(file("float", "int", "1"), MeshFormat::ply_ascii), InvalidInput);
  const std::string small = replaced(file("uchar", "int", "1"), "7 3 0 2 1", "7 2 0 1");
  EXPECT_TRUE(
      contains(parsed(small, MeshFormat::ply_ascii).warnings.at(0).text, "1 faces of fewer"));
  const std::string strips =
      replaced(file("uchar", "int", "1"), "element edge", "element tristrips");
  EXPECT_TRUE(contains(message_of<InvalidInput>([&] { parsed(strips, MeshFormat::ply_ascii); }),
                       "triangle strips"));
}

TEST(UntidyMesh, WhatWasAssumedIsSaidOfTheVolume) {
  std::string text = mesh_bytes(sample_box(), MeshFormat::obj);
  text.pop_back();
  const Volume volume = voxelize(parsed(text, MeshFormat::obj), {.resolution = 9}, {}, "a.obj");
  ASSERT_FALSE(volume.warnings.empty());
  EXPECT_TRUE(contains(volume.warnings[0].text, "last line has no end"));
}

TEST(UntidyMeshData, FilesWithoutALastEndAndWithAWrongCountAreRead) {
  for (const char* name : {"loopy_Plate1_1.stl", "cinolib_torus.obj", "count0.stl"}) {
    ISOLOOP_NEEDS("odd/" + std::string(name));
    const Mesh mesh = read_mesh(test::data("odd/" + std::string(name)));
    EXPECT_EQ(mesh.warnings.size(), 1U) << name;
    if (std::string(name) == "count0.stl") {
      EXPECT_EQ(mesh.triangles.size(), 9216U);
    }
  }
}

}  // namespace
}  // namespace isoloop
