// Topology repair: removes handles and tunnels by changing few voxels, and nothing else.
#pragma once

#include <string>

#include "core/analysis/analysis.h"
#include "core/grid/grid.h"
#include "isoloop/repair.h"

namespace isoloop {

struct Repair : RepairChanges {
  Analysis before;
  Analysis after;
};

/// Removes what the request asks for, shortest loops first, and analyses the result again, until
/// nothing that it asks for is left. Every removal lowers the genus by one and changes neither
/// components nor cavities; in every round all classes of loops but the removed ones are proved to
/// be still there, each of its kind (HomologyMap). To remove a handle also removes the tunnel that
/// it stands beside, so a loop that was asked for may have gone with another; and where no cut will
/// do (a cut would open a cavity, or the tunnel is knotted), the handle is removed by filling a
/// tunnel that crosses it, and a tunnel by cutting.
///
/// The boundary must be closed. Throws InvalidArgument (an id that does not exist, an open
/// boundary), SelfCheckFailed if a loop cannot be removed so, naming it, unless the request says to
/// keep going, and what analyze() throws.
Repair repair_loops(const AnyGridView& grid, const IsoLevel& level, const RepairRequest& request,
                    const AnalysisOptions& options = {});

}  // namespace isoloop
