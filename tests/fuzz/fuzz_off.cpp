#include "tests/fuzz/mesh_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return isoloop::fuzz::read_as_mesh(data, size, isoloop::MeshKind::off);
}
