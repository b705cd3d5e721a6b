// Writes the seed corpus: one folder for each fuzz target, small files that isoloop itself can
// make.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "tests/samples/byte_samples.h"
#include "tests/samples/dicom_samples.h"
#include "tests/samples/mesh_samples.h"
#include "tests/samples/meta_image_samples.h"
#include "tests/samples/nifti_samples.h"
#include "tests/samples/npy_samples.h"
#include "tests/samples/nrrd_samples.h"
#include "tests/samples/slice_samples.h"
#include "tests/samples/tiff_samples.h"
#include "tests/samples/vti_samples.h"
#include "volume/shapes/shapes.h"
#include "volume/vdb/vdb.h"
#include "volume/vdb/vdb_decode.h"
#include "volume/vdb/vdb_message.h"

namespace {

using namespace isoloop;

std::filesystem::path root;

void write_seed(const std::string& target, const std::string& name, const std::string& bytes) {
  std::filesystem::create_directories(root / target);
  std::ofstream(root / target / name, std::ios::binary) << bytes;
}

void write_raw_seeds() {
  for (unsigned type = 0; type < 8; ++type) {
    for (unsigned dims = 0; dims < 4; ++dims) {
      const std::uint64_t bytes = 4 * (1 + dims) * bytes_per_voxel(static_cast<VoxelType>(type));
      std::string seed(1 + bytes, '\1');
      seed[0] = static_cast<char>(dims | type << 2U | (type == 1 ? 32U : 0U));
      write_seed("raw", std::to_string(type) + "_" + std::to_string(dims), seed);
    }
  }
  write_seed("raw", "by_name", std::string(32, '\2'));
}

void write_nifti_seeds() {
  using test::NiftiSample;
  for (const Endian endian : {Endian::little, Endian::big}) {
    const std::string end = endian == Endian::big ? "_big" : "_little";
    write_seed("nifti", "first" + end, NiftiSample{.endian = endian}.file());
    write_seed("nifti", "second" + end, test::nifti_2_file(endian, 1));
    write_seed("nifti", "frames" + end, test::nifti_2_file(endian, 3));
  }
  write_seed("nifti", "placed",
             NiftiSample{.slope = 0.5F,
                         .intercept = -1.0F,
                         .qform = 1,
                         .sform = 2,
                         .quaternion = {0, 1, 0, 5, 6, 7},
                         .rows = {-2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 4, 7}}
                 .file());
  const NiftiSample pair{.from = 2, .magic = {"ni1\0", 4}};
  write_seed("nifti", "pair", pair.header().substr(0, 348) + "xx" + pair.voxels());
  write_seed("nifti", "gzip", test::gzip_bytes(NiftiSample{}.file()));
}

void write_nrrd_seeds() {
  using test::nrrd_header;
  const std::string voxels = test::dozen_voxels(Endian::little);
  const std::string packed = test::gzip_bytes(voxels);
  const auto write = [](const std::string& name, const std::string& lines,
                        const std::string& data) {
    write_seed("nrrd", name, nrrd_header(lines) + "\n" + data);
  };
  write("little", test::nrrd_plain, voxels);
  write("big", "endian: big\nencoding: raw\nspacings: 1 2 3\n", test::dozen_voxels(Endian::big));
  write("placed",
        test::nrrd_plain +
            "space: left-anterior-superior\nspace directions: (0,2,0) (-3,0,0) (0,0,4)\n"
            "space origin: (10,20,30)\n",
        voxels);
  write("skips", test::nrrd_plain + "line skip: 1\nbyte skip: 3\n", "line\nabc" + voxels);
  write("last", test::nrrd_plain + "byte skip: -1\n", "any bytes" + voxels);
  write("detached", test::nrrd_plain + "data file: a.raw\n", voxels);
  write("gzip", "endian: little\nencoding: gzip\nkey:=any value\n", packed);
  write("detached_gzip", "endian: little\nencoding: gz\ndata file: ./a.raw\n", packed);
  write_seed("nrrd", "frames",
             "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 2 1 3\n"
             "kinds: domain domain domain list\nspace: LPS\n"
             "space directions: (1,0,0) (0,1,0) (0,0,1) none\nencoding: raw\n\nabcdefghijkl");
}

void write_meta_image_seeds() {
  using test::meta_image_header;
  const std::string voxels = test::dozen_voxels(Endian::little);
  const auto write = [](const std::string& name, const std::string& bytes) {
    write_seed("meta_image", name, bytes);
  };
  write("little", meta_image_header("") + voxels);
  write("big",
        meta_image_header("BinaryDataByteOrderMSB = True\n") + test::dozen_voxels(Endian::big));
  write("placed", meta_image_header("TransformMatrix = 0 1 0 -1 0 0 0 0 1\nOffset = 5 6 7\n"
                                    "ElementSpacing = 1 2 3\nElementSize = 9 9 9\n"
                                    "ElementToIntensityFunctionSlope = 2\n"
                                    "ElementToIntensityFunctionOffset = -3\n") +
                      voxels);
  write("zlib", test::meta_image_packed(test::zlib_bytes(voxels)));
  write("gzip", test::meta_image_packed(test::gzip_bytes(voxels)));
  write("detached", meta_image_header("", "a.raw") + voxels);
  write("skips", meta_image_header("HeaderSize = 3\n", "a.raw") + "xyz" + voxels);
  write("last", meta_image_header("HeaderSize = -1\n", "a.raw") + "xyz" + voxels);
  write("wrong_size", meta_image_header("CompressedData = True\nCompressedDataSize = 5\n") +
                          test::zlib_bytes(voxels));
  write("frames",
        "NDims = 4\nBinaryData = True\nDimSize = 2 2 1 3\nElementType = MET_UCHAR\n"
        "ElementDataFile = LOCAL\nabcdefghijkl");
}

void write_npy_seeds() {
  const auto write = [](const std::string& name, const std::string& header,
                        const std::string& voxels) { write_seed("npy", name, header + voxels); };
  for (const char version : {1, 2, 3}) {
    write("version_" + std::to_string(version),
          test::npy_header("<i2", "(2, 2, 3)", false, version), test::dozen_voxels(Endian::little));
  }
  write("big", test::npy_header(">i2", "(2, 2, 3)"), test::dozen_voxels(Endian::big));
  write("flat", test::npy_header("<i2", "(4, 3)"), test::dozen_voxels(Endian::little));
  write("fortran", test::npy_header("<i2", "(2, 2, 3)", true), test::dozen_voxels(Endian::little));
  write("frames", test::npy_header("<i2", "(3, 2, 2, 1)"), test::dozen_voxels(Endian::little));
  write("bool", test::npy_header("|b1", "(1, 1, 2)"), std::string("\1\0", 2));
  write("wide", test::npy_header("<i8", "(1, 1, 3)"), test::dozen_voxels(Endian::little));
  write("float", test::npy_header("<f4", "(1, 2, 3)"), test::dozen_voxels(Endian::little));
}

void write_vti_seeds() {
  int number = 0;
  for (const test::VtiSample& sample : test::every_sort_of_vti()) {
    write_seed("vti", sample.format + std::to_string(number++), sample.file());
  }
  write_seed("vti", "placed",
             test::VtiSample{.image = "Spacing=\"1 2 3\" Direction=\"0 -1 0 1 0 0 0 0 1\"",
                             .more = "<DataArray type=\"UInt8\" Name=\"other\" format=\"ascii\">"
                                     "1 1 1 1 1 1 1 1 1 1 1 9</DataArray>\n"}
                 .file());
  const std::string cells =
      "<CellData Scalars=\"v\"><DataArray type=\"UInt8\" Name=\"v\" format=\"ascii\">1 2"
      "</DataArray></CellData>";
  write_seed("vti", "cells", test::VtiSample{.cells = cells}.file());
}

void write_dicom_seeds() {
  using test::DicomSlice;
  for (const char* syntax : {test::explicit_little, test::explicit_big, test::implicit_little}) {
    write_seed("dicom", syntax, DicomSlice{.syntax = syntax}.file());
    write_seed("dicom", std::string(syntax) + "_data_set", DicomSlice{.syntax = syntax}.data_set());
  }
  DicomSlice few_bits{.slope = "1", .intercept = "-1024", .stored = 12, .high = 11};
  write_seed("dicom", "few_bits", few_bits.file());
  std::string series;
  for (int z = 0; z < 3; ++z) series += test::dicom_slice_at(2 - z).file();
  write_seed("dicom", "series", series);
  DicomSlice later = test::dicom_slice_at(0);
  later.instance = 2;
  write_seed("dicom", "frames", test::dicom_slice_at(0).file() + later.file());
}

void write_tiff_seeds() {
  int number = 0;
  const auto write = [](const std::string& name, const test::TiffSample& sample) {
    write_seed("tiff", name, test::tiff_bytes(sample, root / "written.tif"));
  };
  for (const test::TiffSample& sample : test::every_sort_of_tiff()) {
    write(std::to_string(number++), sample);
  }
  write("signed", {.format = SAMPLEFORMAT_INT});
  write("stack", {.pages = 6, .description = "ImageJ=1.53\nimages=6\nslices=2\nframes=3\n"});
  write("channels", {.pages = 6,
                     .description = "ImageJ=1.53\nimages=6\nchannels=3\nslices=2\nspacing=2\n"
                                    "unit=um\n",
                     .per_unit = 2.0F});
  write("shaped", {.pages = 6, .description = R"({"shape": [2, 3, 4, 5]})"});
  write("shaped_axes", {.pages = 6, .description = R"({"shape": [3, 2, 4, 5], "axes": "CZYX"})"});
  const std::string order = "DimensionOrder=\"XYCZT\" ";
  write("ome", {.pages = 6,
                .description = test::ome_xml(order + "PhysicalSizeX=\"0.5\" PhysicalSizeZ=\"2\"",
                                             "<TiffData IFD=\"0\" PlaneCount=\"6\"/>")});
  write("ome_blocks", {.pages = 6,
                       .description = test::ome_xml(
                           order,
                           "<TiffData IFD=\"3\" PlaneCount=\"3\"/><TiffData FirstZ=\"1\" "
                           "PlaneCount=\"3\"/>")});
  write("depth", {.tiled = true, .pages = 1, .depth = 3});
  write_seed("tiff", "one_page", test::one_page_tiff_bytes(6, "ImageJ=1.53\nimages=6\nslices=6\n"));
}

void write_slice_seeds() {
  int number = 0;
  for (const test::PngSample& sample : test::every_sort_of_png()) {
    write_seed("png", std::to_string(number++), sample.file());
  }
  for (const test::BmpSample& sample : test::every_sort_of_bmp()) {
    write_seed("bmp", std::to_string(number++), sample.file());
  }
}

void write_vdb_seeds() {
  for (const std::string name : {"ball", "torus"}) {
    const Volume volume = make_shape(name, {.size = 16}).volume;
    std::ostringstream file;
    write_vdb(file, volume, name);
    write_seed("vdb", name, file.str());
    write_seed("vdb_decode", name, file.str());
    std::istringstream in(file.str());
    std::ostringstream message;
    decode_vdb(in, {}, name, message);
    write_seed("vdb_message", name, message.str());
  }
  std::ostringstream error;
  const Finding finding{.file = "a.vdb", .text = "no"};
  send_error(error, InvalidInput(finding));
  write_seed("vdb_message", "error", error.str());
}

void write_mesh_seeds() {
  using test::MeshFormat;
  const Mesh box = test::box_mesh({-1, 0.5, 2}, {1, 3, 5});
  Mesh open = box;
  open.triangles.pop_back();
  const Mesh torus = test::torus_mesh({0, 0, 0}, 3, 1, 5, 4);
  const auto write = [&](const std::string& target, const std::string& name, MeshFormat format) {
    write_seed(target, name + "box", test::mesh_bytes(box, format));
    write_seed(target, name + "open", test::mesh_bytes(open, format));
    write_seed(target, name + "torus", test::mesh_bytes(torus, format));
  };
  write("stl", "ascii_", MeshFormat::stl_ascii);
  write("stl", "binary_", MeshFormat::stl_binary);
  write("ply", "ascii_", MeshFormat::ply_ascii);
  write("ply", "little_", MeshFormat::ply_little);
  write("ply", "big_", MeshFormat::ply_big);
  write("obj", "", MeshFormat::obj);
  write("off", "", MeshFormat::off);
  write_seed("stl", "count_0",
             test::mesh_bytes(box, MeshFormat::stl_binary).replace(80, 1, 1, '\0'));
  write_seed("stl", "capitals",
             "  SOLID a\r\n FACET NORMAL 0 0 1\r OUTER LOOP\n VERTEX 0 0 1e+0\n"
             "VERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID");
  write_seed("obj", "strangers",
             "sm 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 \\\n3\nc 4\n# en");
  write_seed("off", "more",
             "STCNOFF 3 2 0 # c\r0 0 0 0 0 1 1\r1 0 0 0 0 1 1\r0 1 0 0 0 1 1\r"
             "2 0 1\r3 0 1 2");
  write_seed("ply", "more",
             "ply\rformat ascii 1.0\robj_info i\relement vertex 3\rproperty double x\r"
             "property double y\rproperty double z\rproperty float q\relement face 2\r"
             "property list int float vertex_index\rend_header\r0 0 0 nan\r1 0 0 1\r0 1 0 1\r"
             "2 0 1\r3 0 1 2");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: isoloop_fuzz_seeds FOLDER\n";
    return 2;
  }
  root = argv[1];
  write_raw_seeds();
  write_nifti_seeds();
  write_nrrd_seeds();
  write_meta_image_seeds();
  write_npy_seeds();
  write_vti_seeds();
  write_dicom_seeds();
  write_tiff_seeds();
  write_slice_seeds();
  write_vdb_seeds();
  write_mesh_seeds();
}
