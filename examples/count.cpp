// Counts of a solid that a program holds as numbers: no file, and isoloop::core alone.
#include <iostream>
#include <vector>

#include <isoloop/count.h>

int main() {
  // A plate of 32 x 24 x 5 voxels with two square holes through it, in a margin of one voxel.
  const isoloop::Index3 dims{34, 26, 7};
  std::vector<float> values;
  for (int z = 0; z < dims[2]; ++z)
    for (int y = 0; y < dims[1]; ++y)
      for (int x = 0; x < dims[0]; ++x) {
        const bool margin = x == 0 || x == 33 || y == 0 || y == 25 || z == 0 || z == 6;
        const bool hole = (x - 6) / 8 % 2 == 0 && x >= 6 && x < 30 && y >= 10 && y < 16;
        values.push_back(margin || hole ? 0.0F : 100.0F);
      }

  const isoloop::GridView<float> grid{values, dims, {0.5, 0.5, 1.0}};
  const isoloop::Counts counts = isoloop::count(grid, {.iso = 70});
  std::cout << counts.betti.b0 << " components, " << counts.betti.b1 << " tunnels, "
            << counts.betti.b2 << " cavities\n"
            << counts.triangles << " triangles of genus " << counts.genus << '\n';
}
