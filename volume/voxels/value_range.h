// The voxel values of grids, whoever holds them.
#pragma once

#include "isoloop/grid.h"
#include "isoloop/volume.h"

namespace isoloop {

/// What value_range() finds of a volume, of any grid.
ValueRange value_range(const AnyGridView& grid);

}  // namespace isoloop
