// Topology repair: removes handles and tunnels by changing few voxels, and nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isoloop/count.h"
#include "isoloop/grid.h"
#include "isoloop/loop.h"
#include "isoloop/run.h"

namespace isoloop {

/// A loop by its kind and its id in the analysis of the grid as it came.
struct LoopName {
  LoopKind kind = LoopKind::handle;
  int id = 0;
};

/// What to remove: all that any field asks for. Lengths: unit of the spacing.
struct RepairRequest {
  double cut_handles = 0.0;             // handle loops shorter than this: cut
  double fill_tunnels = 0.0;            // tunnel loops shorter than this: fill
  double either = 0.0;                  // loops of both kinds shorter than this: cut or fill
  std::vector<LoopName> loops{};        // these
  std::optional<std::int64_t> genus{};  // the shortest, until the genus is no more than this
  bool keep_going = false;              // list what cannot be removed, and remove the rest
};

enum class RepairAction { cut, fill };

/// One handle or tunnel that was removed.
struct Removal {
  LoopName loop;  // that was asked for
  int round = 1;  // of analysis: 1 is that of the grid as it came, which the id refers to
  double length = 0.0;
  Vec3 center_index{};
  RepairAction action = RepairAction::cut;
  LoopName by;              // the loop that was cut along or filled: `loop`, or one that crosses it
  std::int64_t voxels = 0;  // changed
};

/// A loop that was asked for and could not be removed.
struct KeptLoop {
  LoopName loop;
  int round = 1;  // of analysis, as in Removal
  double length = 0.0;
  Vec3 center_index{};
};

/// A voxel, numbered in scan order, and what it becomes.
struct VoxelChange {
  std::size_t voxel = 0;
  double before = 0.0;  // unit of the voxel values
  double after = 0.0;
};

/// What a repair did.
struct RepairChanges {
  std::vector<Removal> removals;
  std::vector<KeptLoop> kept;        // only where the request says to keep going
  std::vector<VoxelChange> changes;  // by voxel; empty where nothing was to be done
  std::int64_t added_voxels = 0;     // now inside
  std::int64_t removed_voxels = 0;   // now outside
  std::int64_t shifted_voxels = 0;   // of another value on the side that they were on
  int rounds = 0;                    // analyses that removed something
};

/// The same, with the counts of the grid as it came and as it is with the changes.
struct RepairResult : RepairChanges {
  Counts before;
  Counts after;
};

/// How much a repair may take.
struct RepairOptions {
  GeodesicMode geodesic = GeodesicMode::hierarchy;
  int threads = 0;                            // at most; 0: one for each core
  Progress progress{};                        // may be empty
  std::uint64_t max_bytes = unlimited_bytes;  // to hold beside the grid's voxels
};

/// Removes what the request asks for, shortest loops first, and analyses the result again, until
/// nothing that it asks for is left. Every removal lowers the genus by one and changes neither
/// components nor cavities; all classes of loops but the removed ones are proved to be still there,
/// each of its kind. A handle goes with the tunnel that it stands beside; where no cut will do (a
/// cut would open a cavity, or the tunnel is knotted), the handle is removed by filling a tunnel
/// that crosses it, and a tunnel by cutting.
///
/// The boundary is closed. Throws InvalidArgument (an id that does not exist), SelfCheckFailed if a
/// loop cannot be removed so, naming it, unless the request says to keep going, and what
/// find_loops() throws.
RepairResult repair(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
                    const RepairOptions& options = {});

/// Makes the changes in the voxels that the repair was asked of, in scan order.
template <class T>
void make_changes(std::span<const VoxelChange> changes, std::vector<T>& values) {
  for (const VoxelChange& change : changes) values[change.voxel] = static_cast<T>(change.after);
}
template <class T>
void make_changes(const RepairChanges& repair, std::vector<T>& values) {
  make_changes(std::span(repair.changes), values);
}

/// "handle 3", "tunnel 7".
std::string text_of(const LoopName& loop);

}  // namespace isoloop
