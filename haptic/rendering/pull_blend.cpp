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
/// N/s: pull and rest together, a little less than M1's 0.10 N in a millisecond. Half: pulls give way to every quick
/// hand; twice: never, and along a hinge with a changing plan M1 is 0.120.
constexpr double kFastestTogether = 95.0;
/// N/s that a pull gives way, within the 0.05 N/ms that it may change by itself, and N at most. Half: M1 along that hinge
/// is 0.110; twice: felt as a softer pull after each impact.
constexpr double kFastestYield = 30.0, kMostYield = 0.3;

}  // namespace

dvec3 PullBlend::tick(const dvec3& pull_D, bool changed, double dt, const dvec3& rest_step_D) {
  if (changed) offset_D_ += last_D_ - pull_D;
  last_D_ = pull_D;
  const double size = glm::length(offset_D_);
  if (size > 0.0) {
    const double less = std::min(kFastestChange * dt, size * (1.0 - std::exp(-dt / kDecay)));
    offset_D_ *= size < 1e-9 ? 0.0 : 1.0 - less / size;
  }
  yield_D_ *= std::exp(-dt / kDecay);
  const dvec3 step_D = rest_step_D + pull_D + offset_D_ + yield_D_ - rendered_D_;
  const double step = glm::length(step_D), over = step - kFastestTogether * dt;
  if (over > 0.0 && pull_D != dvec3(0.0)) {
    const double given = std::min({over, glm::length(rest_step_D), kFastestYield * dt});
    yield_D_ = shortenedTo(yield_D_ - step_D * (given / step), kMostYield);
  }
  rendered_D_ = pull_D + offset_D_ + yield_D_;
  return rendered_D_;
}

}  // namespace hapticell::haptic
