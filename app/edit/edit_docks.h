// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// The gizmo of the selection, its keys and its panel.
void addEditDocks(Host& host);

}  // namespace hapticell::app
