// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinematics/kernels/kernels.h"
#include "kinematics/kernels/lane_math.h"

namespace hapticell::kinematics::kernels {
namespace {

/// rad or m over a limit that rounding may make; put back on it. As the 1e-9 that a pose is met to. Half: a solution on
/// a limit may be lost; twice: limits are passed by nothing one could measure, and put back.
constexpr double kLimitSlack = 1e-9;

inline Choice choose(const JointBounds& bounds, const double* previous, int groups, Solutions& solutions) {
  Choice choice;
  double least = 1e300;
  for (int group = 0; group < groups; ++group) {
    Lanes distance = 0.0;
    Mask within = distance >= Lanes(0.0);
    for (int joint = 0; joint < bounds.joints; ++joint) {
      const double lower = bounds.lower[joint], upper = bounds.upper[joint], turn = bounds.turn[joint];
      const Lanes before = previous[joint];
      double* q = solutions.q[joint] + 4 * group;
      Lanes v = load(q);
      if (turn > 0.0) {
        v -= turn * nearestWhole((v - before) * (1.0 / (2.0 * kLanePi)));
        const Lanes nearest = v;
        v -= select(v > Lanes(upper + kLimitSlack), Lanes(turn), Lanes(0.0));
        v += select(v < Lanes(lower - kLimitSlack), Lanes(turn), Lanes(0.0));
        const Lanes put = minimum(maximum(v, lower), upper);
        const Mask inside = absolute(v - put) <= Lanes(kLimitSlack);
        v = select(inside, put, nearest);
        within = within & inside;
      } else {
        const Lanes put = minimum(maximum(v, lower), upper);
        const Mask inside = absolute(v - put) <= Lanes(kLimitSlack);
        v = select(inside, put, v);
        within = within & inside;
      }
      distance += (v - before) * (v - before);
      store(q, v);
    }
    const unsigned allowed = bitsOf(within) & solutions.valid >> (4 * group) & 0xfu;
    choice.within |= allowed << (4 * group);
    for (int lane = 0; lane < 4; ++lane) {
      if ((allowed >> lane & 1u) == 0 || !(distance[lane] < least)) continue;
      least = distance[lane];
      choice.nearest = 4 * group + lane;
    }
  }
  choice.distance_squared = least;
  return choice;
}

}  // namespace
}  // namespace hapticell::kinematics::kernels
