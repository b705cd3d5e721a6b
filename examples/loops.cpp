#include <exception>
#include <iostream>

#include <isoloop/loops.h>
#include <isoloop/read.h>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: loops LEVEL_SET.vdb\n";
    return 2;
  }
  try {
    const isoloop::Volume volume = isoloop::read_volume(argv[1]);
    const isoloop::IsoLevel level{.iso = 0.0, .inside = isoloop::InsideRule::below};
    const isoloop::FoundLoops found = isoloop::find_loops(isoloop::view(volume), level);

    std::cout << found.counts.betti.b0 << " components, " << found.counts.betti.b1 << " tunnels, "
              << found.counts.betti.b2 << " cavities\n";
    for (const isoloop::Loop& loop : found.loops) {
      const bool handle = loop.kind == isoloop::LoopKind::handle;
      const isoloop::Vec3 centre = isoloop::to_world(volume, loop.center_index);
      std::cout << (handle ? "handle loop, cut at " : "tunnel loop, fill at ") << centre[0] << ' '
                << centre[1] << ' ' << centre[2] << ", length " << loop.length << '\n';
      for (const auto& curve : isoloop::to_world(volume, drawn_curves(found.surface, loop)))
        std::cout << "  a closed curve of " << curve.size() << " points from " << curve[0][0] << ' '
                  << curve[0][1] << ' ' << curve[0][2] << '\n';
    }
  } catch (const std::exception& error) {  // those of isoloop/errors.h
    std::cerr << error.what() << '\n';
    return 3;
  }
}
