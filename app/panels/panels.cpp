// SPDX-License-Identifier: Apache-2.0
#include "app/panels/panels.h"

#include "app/host/host.h"

namespace hapticell::app {

void addPanels(Host&) {}

}  // namespace hapticell::app
