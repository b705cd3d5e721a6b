// Solids whose topology is known by construction, which the public header has.
#pragma once

#include "isoloop/shapes.h"
