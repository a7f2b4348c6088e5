// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// The dock that measures; made when it is first wanted.
void addMeasureDock(Host& host);

}  // namespace hapticell::app
