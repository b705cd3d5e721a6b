// Writes the seed corpus: one folder for each fuzz target, small files that isoloop itself can
// make.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "tests/mesh_samples.h"
#include "volume/shapes.h"
#include "volume/vdb.h"
#include "volume/vdb_decode.h"
#include "volume/vdb_message.h"

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
  send_error(error, VdbErrorKind::input, "a.vdb: no");
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
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: isoloop_fuzz_seeds FOLDER\n";
    return 2;
  }
  root = argv[1];
  write_raw_seeds();
  write_vdb_seeds();
  write_mesh_seeds();
}
