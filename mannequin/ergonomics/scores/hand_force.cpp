// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/scores/hand_force.h"

#include <algorithm>
#include <cmath>

namespace hapticell::ergonomics {
namespace {

using mannequin::Figure;
using mannequin::FigurePose;
using mannequin::Segment;
using mannequin::Side;

constexpr double kGravity = 9.80665;  // m/s^2
/// Of an own limit, where its bands end; our choice, colours only but for 1. Half, twice of the first two: green or
/// orange begins earlier or later.
constexpr std::array<double, 3> kOwnShares{0.5, 0.7, 1.0};

/// Horizontal first moment (kg m) of what is gathered, about points given later: mass and mass-weighted place.
struct Weight {
  double mass = 0.0;
  dvec3 moment{0.0};
  void add(double m, const dvec3& p) {
    mass += m;
    moment += m * p;
  }
  /// Moment of the weights about a point: only their horizontal distances count.
  double about(const dvec3& p) const {
    const dvec3 arm = moment - mass * p;
    return kGravity * std::hypot(arm.x, arm.y);
  }
};

void addSegment(const Figure& figure, const FigurePose& pose, Segment segment, Weight& weight) {
  const std::size_t i = mannequin::indexOf(segment);
  weight.add(figure.mass[i], pose.segments[i].point(figure.p_SC[i]));
}

bool isAbove(Segment segment, Segment root) {
  for (auto at = std::optional(segment); at; at = mannequin::segmentInfo(*at).parent) {
    if (*at == root) return true;
  }
  return false;
}

/// Mass and place of a segment and of all that it carries, its hand's load included.
Weight carriedBy(const Figure& figure, const FigurePose& pose, Segment root, const WorkTask& task) {
  Weight weight;
  for (std::size_t i = 0; i < mannequin::kSegmentCount; ++i) {
    if (isAbove(static_cast<Segment>(i), root)) addSegment(figure, pose, static_cast<Segment>(i), weight);
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t hand = static_cast<std::size_t>(side);
    if (!isAbove(armSegment(side, Segment::kLeftHand), root)) continue;
    weight.add(task.load_kg[hand].value_or(0.0), mannequin::handPose(pose, side) * figure.p_HandGrip[hand]);
  }
  return weight;
}

void addLimit(std::string_view method, int hand, double load_kg, const std::array<double, 2>& classes_kg,
              std::vector<ForceLimit>& limits) {
  ForceLimit limit{method, hand, kGravity * load_kg};
  for (const double bound : classes_kg) {
    if (load_kg < bound) {
      limit.limit_n = kGravity * bound;
      break;
    }
    limit.lower_n = kGravity * bound;
    limit.band = bound == classes_kg[0] ? 1 : 3;
  }
  limits.push_back(limit);
}

/// The user's own limit for what a hand bears, where the table has one for the place of its grip.
bool addOwnLimit(const Figure& figure, const FigurePose& pose, Side side, const ForceTable& own, HandForces& forces) {
  const std::size_t i = static_cast<std::size_t>(side);
  const dvec3 grip = mannequin::handPose(pose, side) * figure.p_HandGrip[i];
  const dvec3 from_shoulder = grip - pose[armSegment(side, Segment::kLeftUpperArm)].p_WS;
  double floor = 1e9;
  for (const Side foot : {Side::kLeft, Side::kRight})
    floor = std::min(floor, pose[legSegment(foot, Segment::kLeftFoot)].point({0, 0, figure.sole.z}).z);
  const auto limit = own.limitAt(static_cast<int>(i), grip.z - floor, std::hypot(from_shoulder.x, from_shoulder.y));
  if (!limit) return false;
  const double share = *forces.force_n[i] / *limit;
  ForceLimit found{"own", static_cast<int>(i), *forces.force_n[i], limit};
  for (const double bound : kOwnShares) {
    if (share <= bound) break;
    ++found.band;
    found.lower_n = bound * *limit;
  }
  forces.limits.push_back(found);
  return true;
}

}  // namespace

HandForces handForces(const Figure& figure, const FigurePose& pose, const WorkTask& task, const ForceTable& own) {
  HandForces forces;
  bool has_limits = true;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = static_cast<std::size_t>(side);
    const Segment upper = armSegment(side, Segment::kLeftUpperArm), fore = armSegment(side, Segment::kLeftForearm);
    forces.shoulder_nm[i] = carriedBy(figure, pose, upper, task).about(pose[upper].p_WS);
    forces.elbow_nm[i] = carriedBy(figure, pose, fore, task).about(pose[fore].p_WS);
    if (!task.load_kg[i]) {
      forces.missing.push_back(side == Side::kLeft ? "load_left" : "load_right");
      continue;
    }
    forces.force_n[i] = kGravity * *task.load_kg[i];
    addLimit("RULA", static_cast<int>(i), *task.load_kg[i], {2.0, 10.0}, forces.limits);
    has_limits = addOwnLimit(figure, pose, side, own, forces) && has_limits;
  }
  if (!has_limits || own.isEmpty()) forces.missing.push_back("force_limits");
  forces.lumbar_nm = carriedBy(figure, pose, Segment::kLowerBack, task).about(pose[Segment::kLowerBack].p_WS);
  if (const auto total = task.totalLoad()) {
    addLimit("REBA", -1, *total, {5.0, 10.0}, forces.limits);
    addLimit("OWAS", -1, *total, {10.0, 20.0}, forces.limits);
  }
  return forces;
}

}  // namespace hapticell::ergonomics
