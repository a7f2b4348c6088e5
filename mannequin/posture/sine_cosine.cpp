// SPDX-License-Identifier: Apache-2.0
#include "mannequin/posture/sine_cosine.h"

namespace hapticell::mannequin {

namespace {

constexpr double kTwoOverPi = 0.63661977236758134308;
// A quarter turn in two parts, the first with fewer digits, so that taking off a few of them loses nothing.
constexpr double kQuarterHigh = 1.5707963267341256;
constexpr double kQuarterLow = 6.0771005065061922e-11;
// Adding and taking off 1.5 * 2^52 rounds to the nearest integer.
constexpr double kRounder = 6755399441055744.0;

}  // namespace

void sinesAndCosines(const JointAngles& angles, SineCosine& result) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const double x = angles[i];
    const double quarters = (x * kTwoOverPi + kRounder) - kRounder;
    const double r = (x - quarters * kQuarterHigh) - quarters * kQuarterLow;
    const double r2 = r * r;
    const double s =
        r + r * r2 *
                (-1.0 / 6 +
                 r2 * (1.0 / 120 +
                       r2 * (-1.0 / 5040 +
                             r2 * (1.0 / 362880 + r2 * (-1.0 / 39916800 +
                                                        r2 * (1.0 / 6227020800.0 + r2 * (-1.0 / 1307674368000.0)))))));
    const double c =
        1.0 +
        r2 * (-0.5 + r2 * (1.0 / 24 + r2 * (-1.0 / 720 +
                                            r2 * (1.0 / 40320 + r2 * (-1.0 / 3628800 +
                                                                      r2 * (1.0 / 479001600.0 +
                                                                            r2 * (-1.0 / 87178291200.0 +
                                                                                  r2 * (1.0 / 20922789888000.0))))))));
    // Quarter 0: s, c; 1: c, -s; 2: -s, -c; 3: -c, s. By arithmetic, so that no branch stands in the loop.
    const double half = 0.5 * quarters;
    const double half_floor = ((half - 0.25) + kRounder) - kRounder;  // floor of quarters / 2
    const double odd = quarters - 2.0 * half_floor;                   // 0 or 1
    const double turn = half_floor * 0.5;
    const double turn_floor = ((turn - 0.25) + kRounder) - kRounder;
    const double sign = 1.0 - 2.0 * (half_floor - 2.0 * turn_floor);  // +1 or -1
    result.sine[i] = sign * (s + odd * (c - s));
    result.cosine[i] = sign * (c - odd * (c + s));
  }
}

}  // namespace hapticell::mannequin
