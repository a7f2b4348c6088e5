// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "workcell/import/imported_entities.h"

namespace hapticell::app {

/// The result of an import in sentences: parts, triangles and unit; what was repaired; what was dropped and why. Leaves
/// out the report's own warnings: each is a separate message.
QString reportText(const workcell::ImportReport& report);

}  // namespace hapticell::app
