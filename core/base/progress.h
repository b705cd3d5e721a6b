// How long work tells how far it has come, which the public header has.
#pragma once

#include "isoloop/run.h"
