// Which iso value does each of many volumes ask for?
#include <exception>
#include <iostream>
#include <vector>

#include <isoloop/read.h>
#include <isoloop/scan.h>
#include <isoloop/volume.h>

namespace {

/// 255 values between the least voxel and the largest.
std::vector<double> iso_values(const isoloop::Volume& volume) {
  const isoloop::ValueRange range = isoloop::value_range(volume);
  std::vector<double> values;
  for (int i = 1; i < 256 && range.min < range.max; ++i)
    values.push_back(range.min + (range.max - range.min) * i / 256);
  return values;
}

void propose(const char* file) {
  const isoloop::Volume volume = isoloop::read_volume(file);
  const auto inside = volume.level_set ? isoloop::InsideRule::below : isoloop::InsideRule::above;
  const isoloop::Scan scan =
      isoloop::scan(isoloop::view(volume), iso_values(volume), {.inside = inside});
  std::cout << file << ": ";
  if (!scan.proposed) {
    std::cout << "no iso value stands out\n";
    return;
  }
  const isoloop::ScanRow& row = scan.rows[*scan.proposed];
  std::cout << scan.plateaus.size() << " plateaus, iso " << row.iso << ": " << row.betti.b0
            << " components, " << row.betti.b1 << " tunnels, " << row.betti.b2 << " cavities\n";
}

}  // namespace

int main(int argc, char** argv) {
  int failed = 0;
  for (int i = 1; i < argc; ++i) {
    try {
      propose(argv[i]);
    } catch (const std::exception& error) {  // a damaged file is no reason to leave out the others
      std::cerr << error.what() << '\n';
      ++failed;
    }
  }
  return failed == 0 ? 0 : 3;
}
