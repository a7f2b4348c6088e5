// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::workcell {

/// Lets the calling thread, and every thread and process that it starts from now on, have the processor only where the
/// window and the loops leave it (10 steps of niceness on Linux, nothing elsewhere). For work that takes seconds:
/// reading, getting meshes ready. It cannot be taken back without privileges.
void stepBehind();

}  // namespace hapticell::workcell
