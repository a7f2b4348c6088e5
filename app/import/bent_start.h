// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/import/imported_entities.h"

namespace hapticell::app {

/// Bends a robot whose file gives no home and that is singular at zero joints, and says so in the report.
void startBent(workcell::Entity& entity, workcell::ImportReport& report);

}  // namespace hapticell::app
