#include <exception>
#include <iostream>

#include "core/analysis/analysis.h"
#include "volume/files/read.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: sample LEVEL_SET.vdb\n";
    return 2;
  }
  try {
    const isoloop::Volume volume = isoloop::read_volume(argv[1]);
    const isoloop::IsoLevel level{0.0, isoloop::InsideRule::below};
    const isoloop::Analysis analysis = isoloop::find_loops(isoloop::view(volume), level);

    std::cout << analysis.betti.b0 << " components, " << analysis.betti.b1 << " tunnels, "
              << analysis.betti.b2 << " cavities\n";
    for (const isoloop::Loop& loop : analysis.loops) {
      const bool handle = loop.kind == isoloop::LoopKind::handle;
      const isoloop::Vec3 centre = isoloop::to_world(volume, loop.center_index);
      std::cout << (handle ? "handle loop, cut at " : "tunnel loop, fill at ") << centre[0] << ' '
                << centre[1] << ' ' << centre[2] << ", length " << loop.length << '\n';
    }
  } catch (const std::exception& error) {  // those of core/base/errors.h
    std::cerr << error.what() << '\n';
    return 3;
  }
}
