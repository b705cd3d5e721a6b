// Topology repair: removes handles and tunnels by changing few voxels, and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/grid/grid.h"
#include "core/loops/loops.h"
#include "core/repair/loop_remover.h"

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

struct Repair {
  Analysis before;
  Analysis after;
  std::vector<Removal> removals;
  std::vector<VoxelChange> changes;  // by voxel; empty where nothing was to be done
  std::int64_t added_voxels = 0;     // now inside
  std::int64_t removed_voxels = 0;   // now outside
  std::int64_t shifted_voxels = 0;   // of another value on the side that they were on
  int rounds = 0;                    // analyses that removed something
};

/// Removes what the request asks for, shortest loops first, and analyses the result again, until
/// nothing that it asks for is left. Every removal lowers the genus by one and changes neither
/// components nor cavities; in every round all classes of loops but the removed ones are proved to
/// be still there, each of its kind (ClassPassage). To remove a handle also removes the tunnel that
/// it stands beside, so a loop that was asked for may have gone with another; and where no cut will
/// do (a cut would open a cavity, or the tunnel is knotted), the handle is removed by filling a
/// tunnel that crosses it, and a tunnel by cutting.
///
/// The boundary must be closed. Throws InvalidArgument (an id that does not exist, an open
/// boundary), SelfCheckFailed if a loop cannot be removed so, naming it, and what find_loops()
/// throws.
Repair repair_loops(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
                    const AnalysisOptions& options = {});

/// "handle 3", "tunnel 7".
std::string text_of(const LoopName& loop);

}  // namespace isoloop
