// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "workcell/entity/built_in_parts.h"

namespace hapticell::app {

/// What users call a built-in part: "Table".
QString partName(const workcell::BuiltInPart& part);

/// What users call one of its sizes: "Width".
QString sizeName(const workcell::PartSize& size);

}  // namespace hapticell::app
