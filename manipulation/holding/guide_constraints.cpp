// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/guide_constraints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "manipulation/manipulators/symmetric.h"

namespace hapticell::manipulation {

namespace {

using haptic::Constraint;
using haptic::ConstraintKind;
using workcell::Guide;
using workcell::GuideKind;

/// m: nearer to its axis a circle has no direction (five encoder steps). Half: its tangent trembles by 20 deg; twice:
/// small circles are held as points.
constexpr double kLeastRadius = 1e-4;
/// rad: a stop farther away than this is not in the set yet; under a right angle, where its plane would cut the circle
/// at the wrong side. Half: still ahead of kMostGuidedTurn; twice: false stops.
constexpr double kFarStop = 1.2;
constexpr std::uint64_t kGuideIds = std::uint64_t{1} << 61;

/// Rows about one reference pose.
class Rows {
 public:
  Rows(const Guide& guide, const Pose& X_WM, const Pose& X_WM0, std::uint32_t first_group)
      : guide_(guide), X_WM_(X_WM), X_WM0_(X_WM0), group_(first_group) {
    for (int i = 0; i < 3; ++i) axis_[i] = guide.X_WG.rotate(dvec3(i == 0, i == 1, i == 2));
  }

  std::vector<Constraint> make();

 private:
  Constraint& add(ConstraintKind kind, double gap, const dvec3& linear, const dvec3& angular = dvec3(0.0));
  void holdPosition(int axis, const dvec3& p_W);
  void holdTurn(const dvec3& axis, double error);
  void circle(double radius);
  void hinge();
  void slide();
  void screw();
  void tube();
  dvec3 ahead(std::size_t piece, dvec3 p_W) const;
  void leadTo(const dvec3& p_WT);
  void lock();
  void stopsAlong(const dvec3& from);
  void detent(const dvec3& p_W, const dvec3& direction);

  const Guide& guide_;
  const Pose& X_WM_;
  const Pose& X_WM0_;
  std::uint32_t group_;
  dvec3 axis_[3];
  std::vector<Constraint> rows_;
};

Constraint& Rows::add(ConstraintKind kind, double gap, const dvec3& linear, const dvec3& angular) {
  Constraint row;
  row.kind = kind;
  row.group = group_++;
  row.id = kGuideIds + rows_.size();
  row.gap = gap;
  row.gradient = {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
  rows_.push_back(row);
  return rows_.back();
}

void Rows::holdPosition(int axis, const dvec3& p_W) {
  add(ConstraintKind::kEquality, glm::dot(axis_[axis], X_WM_.p - p_W), axis_[axis]);
}

/// Keeps the turn about `axis` at its value less `error` (rad).
void Rows::holdTurn(const dvec3& axis, double error) {
  const double lever = haptic::kRotationLever;
  add(ConstraintKind::kEquality, lever * error, dvec3(0.0), lever * axis);
}

/// f = (|r|^2 - R^2) / 2R for the part r of the position that is normal to z: the cylinder is its exact zero set.
void Rows::circle(double radius) {
  const dvec3 from = X_WM_.p - guide_.X_WG.p;
  const dvec3 r = from - axis_[2] * glm::dot(axis_[2], from);
  const dmat3 across = dmat3(1.0) - glm::outerProduct(axis_[2], axis_[2]);
  Constraint& row = add(ConstraintKind::kEquality, (glm::dot(r, r) - radius * radius) / (2.0 * radius), r / radius);
  Blocks blocks = blocksOf(row.curvature);
  blocks.linear = across / radius;
  row.curvature = symmetricOf(blocks);
}

void Rows::detent(const dvec3& p_W, const dvec3& direction) {
  Constraint& row = add(ConstraintKind::kPull, glm::dot(direction, X_WM_.p - p_W), direction);
  row.stiffness = guide_.detent_stiffness;
  row.reach = guide_.detent_width;
}

void Rows::hinge() {
  const dvec3 o = guide_.X_WG.p, z = axis_[2];
  const auto across = [&](const dvec3& p) { return p - o - z * glm::dot(z, p - o); };
  const dvec3 r0 = across(X_WM0_.p), r = across(X_WM_.p);
  const double radius = glm::length(r0);
  holdPosition(2, X_WM0_.p);
  if (radius < kLeastRadius) {  // Held on the axis itself: it may turn as the wrist does.
    for (int i : {0, 1}) holdPosition(i, o);
    const dvec3 turned = difference(X_WM_, X_WM0_).angular;
    for (int i : {0, 1}) holdTurn(axis_[i], glm::dot(axis_[i], turned));
    return;
  }
  circle(radius);
  const double phi = std::atan2(glm::dot(z, glm::cross(r0, r)), glm::dot(r0, r));
  const auto at = [&](double angle) { return quaternionFromRotationVector(angle * z) * r0; };
  const auto stop = [&](double angle, double sign) {
    if (std::abs(angle - phi) > kFarStop) return;
    const dvec3 normal = sign * glm::cross(z, at(angle)) / radius;
    add(ConstraintKind::kInequality, glm::dot(normal, r - at(angle)), normal);
  };
  if (guide_.lower) stop(*guide_.lower, 1.0);
  if (guide_.upper) stop(*guide_.upper, -1.0);
  for (const double angle : guide_.detents) {
    if (std::abs(angle - phi) < kFarStop)
      detent(o + z * glm::dot(z, X_WM0_.p - o) + at(angle), glm::cross(z, at(angle)) / radius);
  }
}

void Rows::stopsAlong(const dvec3& from) {
  const double s = glm::dot(axis_[2], X_WM_.p - from);
  if (guide_.lower) add(ConstraintKind::kInequality, s - *guide_.lower, axis_[2]);
  if (guide_.upper) add(ConstraintKind::kInequality, *guide_.upper - s, -axis_[2]);
  for (const double position : guide_.detents) detent(from + position * axis_[2], axis_[2]);
}

void Rows::slide() {
  for (int i : {0, 1}) holdPosition(i, X_WM0_.p);
  stopsAlong(X_WM0_.p);
}

void Rows::screw() {
  const dvec3 turned = difference(X_WM_, X_WM0_).angular;
  for (int i : {0, 1}) holdPosition(i, guide_.X_WG.p);
  for (int i : {0, 1}) holdTurn(axis_[i], glm::dot(axis_[i], turned));
  const double lead = guide_.pitch / (2.0 * std::numbers::pi);
  const double error = glm::dot(axis_[2], X_WM_.p - X_WM0_.p) - lead * glm::dot(axis_[2], turned);
  add(ConstraintKind::kEquality, error, axis_[2], -lead * axis_[2]);
  stopsAlong(X_WM0_.p);
}

/// The point of the path `lead` ahead of a point on one of its pieces.
dvec3 Rows::ahead(std::size_t piece, dvec3 p_W) const {
  double left = guide_.lead;
  for (std::size_t i = piece; i + 1 < guide_.path.size(); ++i) {
    const dvec3 next = guide_.path[i + 1];
    const double way = glm::distance(p_W, next);
    if (way > left) return p_W + left / way * (next - p_W);
    left -= way;
    p_W = next;
  }
  return p_W;
}

/// A spring to a point, that lets go of a hand that is far away.
void Rows::leadTo(const dvec3& p_WT) {
  for (const dvec3& direction : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}) {
    Constraint& pull = add(ConstraintKind::kPull, glm::dot(direction, X_WM_.p - p_WT), direction);
    pull.stiffness = guide_.help;
    pull.reach = 2.0 * (guide_.radius + guide_.lead);
  }
}

/// Inside the tube about the nearest piece of the path, and inside the balls about its ends: pieces are OR.
void Rows::tube() {
  const std::uint32_t group = group_;
  double nearest = std::numeric_limits<double>::infinity();
  dvec3 middle(0.0), along(0.0);
  std::size_t piece = 0;
  for (std::size_t i = 0; i + 1 < guide_.path.size(); ++i) {
    const dvec3 a = guide_.path[i], way = guide_.path[i + 1] - a;
    const double s = std::clamp(glm::dot(X_WM_.p - a, way) / std::max(glm::dot(way, way), 1e-18), 0.0, 1.0);
    const double away = glm::distance(X_WM_.p, a + s * way);
    if (away >= nearest) continue;
    nearest = away;
    piece = i;
    middle = a + s * way;
    // At an end of the path and at its corners the middle is a point, else a line.
    along = s > 0.0 && s < 1.0 ? glm::normalize(way) : dvec3(0.0);
  }
  const dvec3 e = X_WM_.p - middle;
  const dmat3 across = dmat3(1.0) - glm::outerProduct(along, along);
  const double radius = guide_.radius;
  Constraint& row = add(ConstraintKind::kInequality, (radius * radius - glm::dot(e, across * e)) / (2.0 * radius),
                        -(across * e) / radius);
  row.group = group;
  Blocks blocks = blocksOf(row.curvature);
  blocks.linear = across / -radius;
  row.curvature = symmetricOf(blocks);
  if (guide_.help <= 0.0) return;
  if (guide_.lead > 0.0) return leadTo(ahead(piece, middle));
  const dvec3 side = std::abs(along.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = glm::normalize(side - along * glm::dot(along, side)), v = glm::cross(along, u);
  for (const dvec3& direction : {u, v}) {
    if (glm::dot(direction, direction) < 0.5) continue;
    Constraint& pull = add(ConstraintKind::kPull, glm::dot(direction, e), direction);
    pull.stiffness = guide_.help;
    pull.reach = 2.0 * radius;
  }
}

void Rows::lock() {
  const dvec3 turned = difference(X_WM_, X_WM0_).angular;
  const bool slaved = guidedTurn(guide_, X_WM_, X_WM0_).has_value();
  for (int i = 0; i < 3; ++i) {
    if (guide_.locked[static_cast<std::size_t>(i)]) holdPosition(i, X_WM0_.p);
    if (guide_.locked[static_cast<std::size_t>(i) + 3] && !slaved) holdTurn(axis_[i], glm::dot(axis_[i], turned));
  }
}

std::vector<Constraint> Rows::make() {
  const dvec3 o = guide_.X_WG.p;
  switch (guide_.kind) {
    case GuideKind::kPoint:
      for (int i = 0; i < 3; ++i) holdPosition(i, o);
      break;
    case GuideKind::kLine:
      for (int i : {0, 1}) holdPosition(i, o);
      stopsAlong(o);
      break;
    case GuideKind::kPlane:
      holdPosition(2, o);
      break;
    case GuideKind::kCircle:
      holdPosition(2, o);
      circle(guide_.radius);
      break;
    case GuideKind::kHinge:
      hinge();
      break;
    case GuideKind::kSlider:
      slide();
      break;
    case GuideKind::kScrew:
      screw();
      break;
    case GuideKind::kTube:
      tube();
      break;
    case GuideKind::kSurface:
      break;
    case GuideKind::kLock:
      lock();
      break;
  }
  return std::move(rows_);
}

}  // namespace

std::vector<Constraint> guideConstraints(const Guide& guide, const Pose& X_WM, const Pose& X_WM0,
                                         std::uint32_t first_group) {
  return Rows(guide, X_WM, X_WM0, first_group).make();
}

std::optional<GuidedTurn> guidedTurn(const Guide& guide, const Pose& X_WM, const Pose& X_WM0) {
  if (guide.kind == GuideKind::kSlider) return GuidedTurn{X_WM0.q};
  if (guide.kind == GuideKind::kLock && guide.locked[3] && guide.locked[4] && guide.locked[5]) {
    return GuidedTurn{X_WM0.q};
  }
  if (guide.kind != GuideKind::kHinge) return std::nullopt;
  const dvec3 o = guide.X_WG.p, z = guide.X_WG.rotate(dvec3(0, 0, 1));
  const auto across = [&](const dvec3& p) { return p - o - z * glm::dot(z, p - o); };
  const dvec3 r0 = across(X_WM0.p), r = across(X_WM.p);
  if (glm::length(r0) < kLeastRadius) return std::nullopt;
  const double phi = std::atan2(glm::dot(z, glm::cross(r0, r)), glm::dot(r0, r));
  // phi changes by (z x r) . dp / |r|^2.
  const dvec3 tangent = glm::cross(z, r) / std::max(glm::dot(r, r), kLeastRadius * kLeastRadius);
  return GuidedTurn{glm::normalize(quaternionFromRotationVector(phi * z) * X_WM0.q), glm::outerProduct(z, tangent)};
}

void slaveTurning(const dmat3& rate, Constraint& constraint) {
  const auto slaved = [&](haptic::Vector6& gradient) {
    const dvec3 more = glm::transpose(rate) * dvec3(gradient[3], gradient[4], gradient[5]);
    gradient = {gradient[0] + more.x, gradient[1] + more.y, gradient[2] + more.z, 0.0, 0.0, 0.0};
  };
  slaved(constraint.gradient);
  slaved(constraint.trim_gradient);
  Blocks blocks = blocksOf(constraint.curvature);
  const dmat3 crossed = blocks.mixed * rate;
  blocks.linear += crossed + glm::transpose(crossed) + glm::transpose(rate) * blocks.angular * rate;
  blocks.mixed = blocks.angular = dmat3(0.0);
  constraint.curvature = symmetricOf(blocks);
}

}  // namespace hapticell::manipulation
