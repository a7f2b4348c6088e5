// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "workcell/import/imported_entities.h"

namespace hapticell::app {

/// What an import did, as sentences: parts, triangles and unit; what was repaired; what was dropped and why. The
/// report's own warnings are not in it: each is a message of its own.
QString reportText(const workcell::ImportReport& report);

}  // namespace hapticell::app
