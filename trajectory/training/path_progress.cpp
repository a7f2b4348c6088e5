// SPDX-License-Identifier: Apache-2.0
#include "trajectory/training/path_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/system/assertion.h"

namespace hapticell::trajectory {

namespace {

// m, rad (0.1 mm, 0.1 degree): frames where the expert stands still are one. Half: pieces of tremor count as a way;
// twice: slow fine motions lose some pieces.
constexpr double kSamePlace = 1e-4, kSameTurn = 1.745e-3;
// Places tried on each piece for the nearest one. Half: the nearest of two bends of a piece may be missed; twice: twice
// the time of a tick.
constexpr int kLooks = 8;
// Halvings of the step around the best of these: 1/256 of it is below what a hand can feel (0.1 mm) for pieces of 20 cm.
// Half: progress goes in steps that can be seen; twice: nothing is gained.
constexpr int kHalvings = 8;

}  // namespace

PathProgress::PathProgress(const Trajectory& expert, double metres_per_radian) : metres_per_radian_(metres_per_radian) {
  HAPTICELL_DEMAND(!expert.empty());
  for (std::size_t i = 0; i < expert.size(); ++i) {
    const Pose& X = expert[i].X_WT;
    if (poses_.empty()) {
      poses_.push_back(X);
      ways_.push_back(0.0);
      times_.push_back(expert[i].t);
      continue;
    }
    const PoseDistance step = distanceBetween(poses_.back(), X);
    const bool last = i + 1 == expert.size();
    if (step.position < kSamePlace && step.angle < kSameTurn && !last) continue;
    const double way = step.position + metres_per_radian_ * step.angle;
    if (way <= 0.0) continue;
    poses_.push_back(X);
    ways_.push_back(ways_.back() + way);
    times_.push_back(expert[i].t);
  }
}

std::size_t PathProgress::pieceAt(double way) const {
  const auto after = std::upper_bound(ways_.begin(), ways_.end(), way);
  if (after == ways_.begin()) return 0;
  const auto piece = static_cast<std::size_t>(after - ways_.begin()) - 1;
  return std::min(piece, poses_.size() < 2 ? 0 : poses_.size() - 2);
}

Pose PathProgress::expertAt(double way) const {
  if (poses_.size() < 2) return poses_.front();
  const std::size_t i = pieceAt(way);
  const double share = std::clamp((way - ways_[i]) / (ways_[i + 1] - ways_[i]), 0.0, 1.0);
  return interpolate(poses_[i], poses_[i + 1], share);
}

double PathProgress::timeAt(double way) const {
  if (poses_.size() < 2) return times_.front();
  const std::size_t i = pieceAt(way);
  const double share = std::clamp((way - ways_[i]) / (ways_[i + 1] - ways_[i]), 0.0, 1.0);
  return times_[i] + share * (times_[i + 1] - times_[i]);
}

void PathProgress::follow(const Pose& X_WT, double reach) {
  if (poses_.size() < 2) return;
  const double from = std::max(0.0, way_ - reach), to = std::min(length(), way_ + reach);
  double nearest = std::numeric_limits<double>::infinity(), best = way_, step = 0.0;
  const auto look = [&](double way) {
    const PoseDistance off = distanceBetween(expertAt(way), X_WT);
    const double away = off.position + metres_per_radian_ * off.angle;
    // Of places equally near, the one where it was.
    if (away < nearest - 1e-9 || (away < nearest + 1e-9 && std::abs(way - way_) < std::abs(best - way_))) {
      nearest = away;
      best = way;
    }
  };
  look(way_);
  for (std::size_t i = pieceAt(from); i <= pieceAt(to); ++i) {
    const double low = std::max(from, ways_[i]), high = std::min(to, ways_[i + 1]);
    for (int k = 0; k <= kLooks; ++k) look(low + (high - low) * k / kLooks);
    step = std::max(step, (high - low) / kLooks);
  }
  // Without this, how far a hand has come would depend on where the places tried happen to lie, and so on when it was
  // asked.
  for (int k = 0; k < kHalvings; ++k) {
    step *= 0.5;
    const double middle = best;
    look(std::max(from, middle - step));
    look(std::min(to, middle + step));
  }
  way_ = best;
}

std::vector<dvec3> PathProgress::window(double behind, double ahead) const {
  const double from = std::max(0.0, way_ - behind), to = std::min(length(), way_ + ahead);
  std::vector<dvec3> points{expertAt(from).p};
  for (std::size_t i = 0; i < ways_.size(); ++i)
    if (ways_[i] > from && ways_[i] < to) points.push_back(poses_[i].p);
  points.push_back(expertAt(to).p);
  return points;
}

}  // namespace hapticell::trajectory
