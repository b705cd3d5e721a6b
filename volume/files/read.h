// Volumes from files, which the public header has.
#pragma once

#include "isoloop/read.h"
