// Fills every tunnel whose loop is shorter than a length, and changes nothing else.
#include <exception>
#include <iostream>
#include <string>
#include <variant>

#include <isoloop/read.h>
#include <isoloop/repair.h>
#include <isoloop/volume.h>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: repair LEVEL_SET.vdb LENGTH REPAIRED.nrrd\n";
    return 2;
  }
  try {
    isoloop::Volume volume = isoloop::read_volume(argv[1]);
    const isoloop::IsoLevel level{.iso = 0.0, .inside = isoloop::InsideRule::below};
    const isoloop::RepairResult result =
        isoloop::repair(isoloop::view(volume), level, {.fill_tunnels = std::stod(argv[2])});

    for (const isoloop::Removal& removal : result.removals)
      std::cout << "removed " << text_of(removal.loop) << " of length " << removal.length << " by "
                << removal.voxels << " voxels\n";
    std::cout << result.before.betti.b1 << " tunnels before, " << result.after.betti.b1
              << " after\n";
    std::visit([&](auto& values) { make_changes(result, values); }, volume.values);
    isoloop::write_volume(volume, argv[3]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}
