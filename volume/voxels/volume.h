// Volumes in memory, which the public header has.
#pragma once

#include "isoloop/volume.h"
