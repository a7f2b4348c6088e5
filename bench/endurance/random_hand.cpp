// SPDX-License-Identifier: Apache-2.0
#include "bench/endurance/random_hand.h"

#include <algorithm>
#include <vector>

namespace hapticell::endurance {

namespace {

constexpr double kReach = 0.07;   // m
constexpr double kTurn = 0.35;    // rad
constexpr double kSample = 0.02;  // s

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Pose randomPlace(std::mt19937_64& random) {
  const dvec3 p(between(random, -kReach, kReach), between(random, -kReach, kReach), between(random, -kReach, kReach));
  const dvec3 axis(between(random, -1.0, 1.0), between(random, -1.0, 1.0), between(random, 0.1, 1.0));
  return {p, glm::angleAxis(between(random, -kTurn, kTurn), glm::normalize(axis))};
}

}  // namespace

haptic::HandPath randomHand(std::mt19937_64& random, double duration) {
  std::vector<haptic::HandSample> samples{{0.0, Pose::identity(), 0}};
  double t = 0.0;
  Pose from = Pose::identity();
  std::uint32_t buttons = 0;
  while (t < duration) {
    // The taken entity is let go now and then; nothing is held for a third of the time at most.
    buttons = between(random, 0.0, 1.0) < (buttons ? 0.85 : 0.7) ? 1u : 0u;
    const bool pauses = between(random, 0.0, 1.0) < 0.1;
    const Pose to = pauses ? from : randomPlace(random);
    const double speed = between(random, 0.0, 1.0) < 0.15 ? 0.4 : between(random, 0.03, 0.15);
    // The quickest moment of the smooth way is 1.5 times its mean speed.
    const double way = std::max(0.25, glm::distance(from.p, to.p) / speed);
    for (double s = kSample; s < way; s += kSample) {
      const double share = s / way, smooth = share * share * (3.0 - 2.0 * share);
      samples.push_back({t + s, {glm::mix(from.p, to.p, smooth), glm::slerp(from.q, to.q, smooth)}, buttons});
    }
    t += way;
    from = to;
  }
  samples.push_back({t, from, 0});
  return haptic::HandPath(std::move(samples));
}

}  // namespace hapticell::endurance
