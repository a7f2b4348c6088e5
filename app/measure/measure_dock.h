// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the dock for measuring; it is made when it is first opened.
void addMeasureDock(Host& host);

}  // namespace hapticell::app
