// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// The gizmo of what is selected, its keys and its dock.
void addEditDocks(Host& host);

}  // namespace hapticell::app
