// The part of the .vdb reader that hands a file's bytes to OpenVDB, which a damaged file can make
// write anywhere or ask for any amount of memory. Run it where that does no harm: see vdb_decoder.
#pragma once

#include <iosfwd>
#include <string>

#include "volume/vdb/vdb.h"

namespace isoloop {

struct VdbRequest {
  std::string grid{};  // name; empty: the only float or double grid
  VdbMargin margin = VdbMargin::background;
};

/// Reads all grids of a file and sends the one that is asked for (vdb_message.h), voxels that
/// equal the background left out. `what` opens the message of an error. Throws InvalidArgument and
/// InvalidInput as read_vdb does, and std::bad_alloc; a failure to write shows in the stream's
/// state.
void decode_vdb(std::istream& file, const VdbRequest& request, const std::string& what,
                std::ostream& out);

}  // namespace isoloop
