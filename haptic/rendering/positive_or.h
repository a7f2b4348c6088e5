// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace hapticell::haptic {

/// What is no number above zero is taken as `fallback`.
inline double positiveOr(double value, double fallback) {
  return std::isfinite(value) && value > 0.0 ? value : fallback;
}

}  // namespace hapticell::haptic
