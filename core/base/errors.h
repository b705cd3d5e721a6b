// The errors that isoloop throws, which the public header has.
#pragma once

#include "isoloop/errors.h"
