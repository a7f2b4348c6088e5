// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::workcell {

/// Lowers the priority of the calling thread, and of every thread and process that it starts from now on, below the
/// window and the loops (10 steps of niceness on Linux, nothing elsewhere). For work that takes seconds: reading,
/// preparing meshes. Cannot be undone without privileges.
void lowerThreadPriority();

}  // namespace hapticell::workcell
