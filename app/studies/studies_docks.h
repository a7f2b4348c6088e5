// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

class Host;

/// Adds the docks of studies, to set one up and to see its results, with their entries in the menu Applications.
void addStudiesDocks(Host& host);

}  // namespace hapticell::app
