// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the host's own panels to a window that is being set up.
void addPanels(Host& host);

}  // namespace hapticell::app
