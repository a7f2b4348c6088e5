// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "workcell/import/imported_entities.h"

namespace hapticell::app {

/// A robot whose file says no home and whose joints at zero make it singular starts bent, and the report says so.
void startBent(workcell::Entity& entity, workcell::ImportReport& report);

}  // namespace hapticell::app
