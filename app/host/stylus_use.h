// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// True while the hand works with the stylus (it or the second one holds something, or forces are on): panels then
/// stay where they are. GUI thread.
bool isStylusInUse(const Host& host);

/// The same, and tells the user why nothing opens: for a panel that was asked for by a command.
bool tellsStylusInUse(Host& host);

}  // namespace hapticell::app
