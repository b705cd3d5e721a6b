// All of isoloop: core and volumes.
#pragma once

#include "isoloop/count.h"
#include "isoloop/errors.h"
#include "isoloop/grid.h"
#include "isoloop/loop.h"
#include "isoloop/loops.h"
#include "isoloop/read.h"
#include "isoloop/repair.h"
#include "isoloop/run.h"
#include "isoloop/scan.h"
#include "isoloop/shapes.h"
#include "isoloop/surface.h"
#include "isoloop/volume.h"
