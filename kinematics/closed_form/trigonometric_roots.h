// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace hapticell::kinematics {

/// f(t) = constant + cos1 cos t + sin1 sin t + cos2 cos 2t + sin2 sin 2t.
struct TrigonometricPolynomial {
  double constant = 0.0, cos1 = 0.0, sin1 = 0.0, cos2 = 0.0, sin2 = 0.0;

  double operator()(double t) const;
};

/// Its real roots in (-pi, pi], four at most, a double one once or twice; nearly double roots that rounding made
/// complex count as roots. Returns how many. All coefficients zero: none.
///
/// A quartic in tan((t - shift) / 2), the shift chosen so that no root is near infinity, by Ferrari's method, then
/// Newton steps on f.
int realRoots(const TrigonometricPolynomial& f, std::array<double, 4>& roots);

}  // namespace hapticell::kinematics
