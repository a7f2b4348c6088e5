// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/hand_trail.h"

#include <utility>

namespace hapticell::manipulation {

namespace {

/// Configurations kept: 1.5 m of hand at 3 mm. Half: long ways are kept in coarse steps; twice: a copy of 100 kB each
/// few millimetres.
constexpr std::size_t kMostKept = 512;
/// m a radian, as trajectory::PathProgress. Half: turns are kept in steps of 3 deg; twice: in steps of 1 deg.
constexpr double kTrailMetresPerRadian = 0.1;

}  // namespace

void HandTrail::clear() {
  trail_ = std::make_shared<const Trail>();
}

void HandTrail::add(const EntityConfiguration& at, const Pose& X_WM, double spacing) {
  const Twist way = difference(X_WM, X_WLast_);
  const double length = glm::length(way.linear) + kTrailMetresPerRadian * glm::length(way.angular);
  if (!trail_->empty() && length < spacing) return;
  auto longer = std::make_shared<Trail>();
  // Half of a trail that is full stays, its ends among them.
  const std::size_t step = trail_->size() >= kMostKept ? 2 : 1;
  longer->reserve(trail_->size() / step + 2);
  for (std::size_t i = 0; i < trail_->size(); i += step) longer->push_back((*trail_)[i]);
  longer->push_back(at);
  trail_ = std::move(longer);
  X_WLast_ = X_WM;
}

}  // namespace hapticell::manipulation
