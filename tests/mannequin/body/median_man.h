// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mannequin/body/anthropometry.h"
#include "mannequin/body/figure.h"

namespace hapticell::mannequin {

/// The man whom half of the men are taller than.
inline Figure medianMan() {
  return *makeFigure({Sex::kMale, *statureOfPercentile(Sex::kMale, 50)});
}

}  // namespace hapticell::mannequin
