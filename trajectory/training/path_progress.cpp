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
// m from the last pose at which the expert first arrived, before settling there. Half: passing it beside is no arrival;
// twice: a peg counts as in with 2 mm to go.
constexpr double kArrived = 1e-3;
// m around the last pose in which a hand settles: a box that was let go moved 1 to 2.9 mm in the recordings that were
// looked at. Half: trainees who do not settle alike never finish; twice: a button pressed at the end is taken for it.
constexpr double kSettling = 4e-3;
// Of the length, for short motions. Half: 2 mm of 40, less than a mouse overshoots; twice: part of the task.
constexpr double kSettlingShare = 0.1;

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
  arrival_ = arrivalWay();
}

double PathProgress::away(const Pose& X_WT, const Pose& X_WE) const {
  const PoseDistance off = distanceBetween(X_WE, X_WT);
  return off.position + metres_per_radian_ * off.angle;
}

/// The first way at which the expert was at the last pose and from which on he left it only by a little.
double PathProgress::arrivalWay() const {
  const double settling = std::min(kSettling, kSettlingShare * length());
  double arrival = length();
  for (std::size_t i = poses_.size() - 1; i-- > 0;) {
    if (away(poses_[i + 1], poses_.back()) > settling) break;
    for (int k = kLooks; k-- > 0;) {
      const double way = ways_[i] + (ways_[i + 1] - ways_[i]) * k / kLooks;
      if (away(expertAt(way), poses_.back()) <= std::min(kArrived, settling)) arrival = way;
    }
  }
  return arrival;
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
    const double off = away(X_WT, expertAt(way));
    // Of places equally near, the one where it was.
    if (off < nearest - 1e-9 || (off < nearest + 1e-9 && std::abs(way - way_) < std::abs(best - way_))) {
      nearest = off;
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
