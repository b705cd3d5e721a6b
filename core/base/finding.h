// What was found, as data, which the public header has.
#pragma once

#include "isoloop/finding.h"
