// Which flags mean something for which kind of file, and together.
#pragma once

#include "tools/flags/input_flags.h"

namespace isoloop {

/// Throws InvalidArgument, naming the flag and the files that it is for, if one was given that
/// means nothing for the kind of file that flags.file is, of several the first typed. Files of an
/// unknown kind pass: their reader refuses them.
void check_flags_fit_file(const VolumeFlags& flags);

/// Throws InvalidArgument where flags contradict each other, in the order typed: labels have no iso
/// value.
void check_flags_agree(const VolumeFlags& volume, const LevelFlags& level);

}  // namespace isoloop
