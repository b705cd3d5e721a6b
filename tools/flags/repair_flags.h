// The flags that say what `isoloop repair` is to remove.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/repair/repair.h"
#include "tools/words/cli_app.h"
#include "volume/voxels/volume.h"

namespace isoloop {

/// As typed. Lengths: unit of the spacing, unless theirs follows; empty: not given.
struct RepairFlags {
  std::string fill_tunnels;  // "30", "3mm"
  std::string cut_handles;
  std::string either;  // --auto
  std::optional<std::int64_t> genus;
  std::string ids;   // "h3,t7", or "3,7" with a side
  std::string side;  // "handle", "tunnel" or empty
  bool keep_going = false;
};

/// Adds --fill-tunnels, --cut-handles, --auto, --ids, --side, --genus and --keep-going. `flags`
/// must outlive the parse.
void add_repair_flags(CLI::App& command, RepairFlags& flags);

/// Lengths in the unit of the volume's spacing; before it is read their numbers alone. Throws
/// InvalidArgument where nothing is asked for, or what is asked for makes no sense.
RepairRequest repair_request(const RepairFlags& flags, const Volume* volume = nullptr);

}  // namespace isoloop
