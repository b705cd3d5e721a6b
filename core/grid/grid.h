// Spans of voxels, which the public header has.
#pragma once

#include "isoloop/grid.h"
