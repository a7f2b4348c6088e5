// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the dock of the live view, with its entry in the menu Applications.
void addLiveDock(Host& host);

}  // namespace hapticell::app
