// The order of slices by the numbers in their names, and what is odd about these.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace isoloop {

/// Whether `a` comes before `b`: numbers within names compare by their value, so that slice_9 comes
/// before slice_10.
bool name_less(const std::string& a, const std::string& b);

/// What to warn of in names in that order: a number that is left out, or names that differ in more
/// than numbers, after some that are numbered. Nothing where all is as usual. Throws InvalidInput,
/// opening with `what`, where the names count along two axes (z1_c1, z1_c2, z2_c1, …), or one
/// number is there twice (1 and 01).
std::optional<std::string> odd_names(const std::vector<std::string>& names,
                                     const std::string& what);

}  // namespace isoloop
