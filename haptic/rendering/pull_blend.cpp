// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/pull_blend.h"

#include <algorithm>
#include <cmath>

namespace hapticell::haptic {

namespace {

/// N/s: 0.02 N in a millisecond, a fifth of what M1 allows, since the contacts change too. Half: guides lag by 0.3 s
/// after a change of 3 N; twice: M1 of a plan that changes at a wall is at its bound.
constexpr double kFastestChange = 20.0;
/// s: the time constant where little is left. Half: the end of a change is felt as a corner; twice: guides lag.
constexpr double kDecay = 0.05;

}  // namespace

dvec3 PullBlend::tick(const dvec3& pull_D, bool changed, double dt) {
  if (changed) offset_D_ += last_D_ - pull_D;
  last_D_ = pull_D;
  const double size = glm::length(offset_D_);
  if (size > 0.0) {
    const double less = std::min(kFastestChange * dt, size * (1.0 - std::exp(-dt / kDecay)));
    offset_D_ *= size < 1e-9 ? 0.0 : 1.0 - less / size;
  }
  return pull_D + offset_D_;
}

}  // namespace hapticell::haptic
