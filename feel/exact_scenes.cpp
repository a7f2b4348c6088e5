// SPDX-License-Identifier: Apache-2.0
#include "feel/scene.h"
#include "geometry/system/assertion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::feel {

namespace {

/// A hand whose intended path keeps its shape on a surface of 10 mm: it presses 2 N by 4 mm, not by 9 mm.
haptic::HandOptions sharpHand() {
  haptic::HandOptions hand;
  hand.stiffness = 1000.0;
  hand.damping = 12.0;
  return hand;
}

class Plane final : public FeelScene {
 public:
  std::string name() const override { return "plane"; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    Constraint c = planeConstraint(dvec3(0.0), dvec3(0, 0, 1), X_DP, 0);
    c.friction = friction;
    add(set, c);
    return set;
  }
  double penetration(const Pose& X_DP, double) const override { return std::max(0.0, -X_DP.p.z); }
  dvec3 handAt(double t, double press) const override { return {0.03 * triangleWave(t, 1.667), 0.0, -press}; }
};

class Cylinder final : public FeelScene {
 public:
  explicit Cylinder(double radius) : radius_(radius) {}
  std::string name() const override { return "cylinder R" + std::to_string(std::lround(radius_ * 1e3)); }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    const dvec3 n = normalAt(X_DP.p);
    const dvec3 t = glm::cross(dvec3(0, 1, 0), n);
    const dmat3 M = (glm::outerProduct(t, t) + glm::outerProduct(n, n)) / radius_;
    Constraint c = quadricConstraint(axis() + radius_ * n + dvec3(0, X_DP.p.y, 0), n, M, X_DP);
    c.friction = friction;
    add(set, c);
    return set;
  }
  haptic::HandOptions hand() const override { return radius_ < 0.02 ? sharpHand() : haptic::HandOptions{}; }
  double penetration(const Pose& X_DP, double) const override {
    return std::max(0.0, radius_ - std::hypot(X_DP.p.x, X_DP.p.z - axis().z));
  }
  dvec3 handAt(double t, double press) const override {
    const double sweep = std::min(0.03 / radius_, 1.2);
    const double angle = sweep * triangleWave(t, 0.1 / (2.0 * sweep * radius_));
    return axis() + (radius_ - press) * dvec3(std::sin(angle), 0.0, std::cos(angle));
  }

 private:
  dvec3 axis() const { return {0.0, 0.0, -radius_}; }
  dvec3 normalAt(const dvec3& p) const {
    const dvec3 r(p.x, 0.0, p.z - axis().z);
    const double length = glm::length(r);
    return length > 1e-9 ? r / length : dvec3(0, 0, 1);
  }
  double radius_;
};

class Facets final : public FeelScene {
 public:
  Facets(double radius, double step) : round_(radius), radius_(radius), step_(step) {
    // More than a set holds would be needed all round: the rest is left out at the bottom, which stays closed.
    count_ = std::min(60, static_cast<int>(std::lround(2.0 * std::numbers::pi / step)));
  }
  std::string name() const override { return "facets"; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    for (int i = 0; i < count_; ++i) {
      add(set, planeConstraint(dvec3(0.0, 0.0, -radius_) + apothem() * normal(i), normal(i), X_DP, 0));
    }
    return set;
  }
  double penetration(const Pose& X_DP, double) const override {
    double depth = 1.0;
    for (int i = 0; i < count_; ++i) {
      depth = std::min(depth, apothem() - glm::dot(normal(i), X_DP.p + dvec3(0.0, 0.0, radius_)));
    }
    return std::max(0.0, depth);
  }
  dvec3 handAt(double t, double press) const override { return round_.handAt(t, press); }
  haptic::HandOptions hand() const override { return round_.hand(); }

 private:
  double apothem() const { return radius_ * std::cos(0.5 * step_); }
  dvec3 normal(int i) const {
    const double angle = step_ * (i + 0.5 - 0.5 * count_);
    return {std::sin(angle), 0.0, std::cos(angle)};
  }
  Cylinder round_;
  double radius_, step_;
  int count_ = 0;
};

class Bore final : public FeelScene {
 public:
  explicit Bore(double radius) : radius_(radius) {}
  std::string name() const override { return "bore R" + std::to_string(std::lround(radius_ * 1e3)); }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    const dvec3 r(X_DP.p.x, 0.0, X_DP.p.z);
    const dvec3 n = glm::length(r) > 1e-9 ? -r / glm::length(r) : dvec3(0, 0, 1);
    const dvec3 t = glm::cross(dvec3(0, 1, 0), n);
    const dmat3 M = (glm::outerProduct(t, t) + glm::outerProduct(n, n)) / -radius_;
    Constraint c = quadricConstraint(-radius_ * n + dvec3(0, X_DP.p.y, 0), n, M, X_DP);
    c.friction = friction;
    add(set, c);
    return set;
  }
  double penetration(const Pose& X_DP, double) const override {
    return std::max(0.0, std::hypot(X_DP.p.x, X_DP.p.z) - radius_);
  }
  dvec3 handAt(double t, double press) const override {
    const double angle = t * 0.1 / radius_;
    return (radius_ + press) * dvec3(std::sin(angle), 0.0, -std::cos(angle));
  }
  dvec3 rest() const override { return {0.0, 0.0, -radius_}; }

 private:
  double radius_;
};

class Edge final : public FeelScene {
 public:
  std::string name() const override { return "edge"; }
  dvec3 rest() const override { return {-0.02, 0.0, 0.0}; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    add(set, planeConstraint(dvec3(0.0), dvec3(0, 0, 1), X_DP, 0));
    add(set, planeConstraint(dvec3(0.0), dvec3(1, 0, 0), X_DP, 0));
    return set;
  }
  double penetration(const Pose& X_DP, double) const override { return std::max(0.0, std::min(-X_DP.p.x, -X_DP.p.z)); }
  // Along the top towards the edge, as far as the deep stylus stays nearer to the top (the trial: before leaving).
  dvec3 handAt(double t, double press) const override { return {-0.032 + 0.02 * triangleWave(t, 2.5), 0.0, -press}; }
};

class Corner final : public FeelScene {
 public:
  std::string name() const override { return "corner"; }
  dvec3 start() const override { return dvec3(0.02, 0.004, 0.004); }
  dvec3 pressDirection() const override { return glm::normalize(dvec3(-1.0, -1.0, -2.0)); }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    add(set, planeConstraint(dvec3(0.0), dvec3(1, 0, 0), X_DP, 0));
    add(set, planeConstraint(dvec3(0.0), dvec3(0, 1, 0), X_DP, 1));
    add(set, planeConstraint(dvec3(0.0), dvec3(0, 0, 1), X_DP, 2));
    for (std::size_t i = 0; i < set.count; ++i) set.constraints[i].friction = friction;
    return set;
  }
  double penetration(const Pose& X_DP, double) const override {
    return std::max({0.0, -X_DP.p.x, -X_DP.p.y, -X_DP.p.z});
  }
  dvec3 handAt(double t, double press) const override {
    // Along the edge into the corner, a moment of rest, and out of it again, at 0.1 m/s.
    const double half = 0.02 + 0.8 * press, longer = 1.4;
    const double way = std::clamp(longer * triangleWave(t, 0.1 / (2.0 * longer * half)), -1.0, 1.0);
    return {0.02 - half * way, -0.6 * press, -press};
  }
};

class Hinge final : public FeelScene {
 public:
  std::string name() const override { return "hinge"; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    const dvec3 r(X_DP.p.x, 0.0, X_DP.p.z - kAxis);
    const dvec3 n = r / std::max(glm::length(r), 1e-9);
    const dvec3 t = glm::cross(dvec3(0, 1, 0), n);
    const dmat3 M = (glm::outerProduct(t, t) + glm::outerProduct(n, n)) / kRadius;
    Constraint circle = quadricConstraint(dvec3(0, X_DP.p.y, kAxis) + kRadius * n, n, M, X_DP);
    circle.kind = ConstraintKind::kEquality;
    add(set, circle);
    Constraint flat = planeConstraint(dvec3(0.0), dvec3(0, 1, 0), X_DP, 1);
    flat.kind = ConstraintKind::kEquality;
    add(set, flat);
    add(set, planeConstraint(stop(), dvec3(-std::cos(kStop), 0.0, std::sin(kStop)), X_DP, 2));
    return set;
  }
  double penetration(const Pose& X_DP, double) const override {
    const double off = std::max(std::abs(std::hypot(X_DP.p.x, X_DP.p.z - kAxis) - kRadius), std::abs(X_DP.p.y));
    return std::max(off, glm::dot(X_DP.p - stop(), dvec3(std::cos(kStop), 0.0, -std::sin(kStop))));
  }
  dvec3 handAt(double t, double press) const override {
    const double angle = 0.6 * triangleWave(t, 0.1 / (1.2 * kRadius));
    return dvec3(0, 0, kAxis) + (kRadius + press) * dvec3(std::sin(angle), 0.0, std::cos(angle));
  }
  dvec3 start() const override { return handAt(0.0, 0.0); }
  dvec3 rest() const override { return stop(); }

 private:
  // m, m, rad: a door of 40 mm whose way fits the workspace (130 mm), with a stop at 29 deg. Half: a tighter circle,
  // larger steps; twice: a flatter one.
  static constexpr double kRadius = 0.04, kAxis = -0.04, kStop = 0.5;
  dvec3 stop() const { return dvec3(0, 0, kAxis) + kRadius * dvec3(std::sin(kStop), 0.0, std::cos(kStop)); }
};

class Plate final : public FeelScene {
 public:
  std::string name() const override { return "plate"; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        dvec3 normal(0.0);
        normal[axis] = side;
        add(set, planeConstraint(normal * kHalf[axis], normal, X_DP, 0));
      }
    }
    return set;
  }
  double penetration(const Pose& X_DP, double) const override {
    double depth = 1.0;
    for (int axis = 0; axis < 3; ++axis) depth = std::min(depth, kHalf[axis] - std::abs(X_DP.p[axis]));
    return std::max(0.0, depth);
  }
  dvec3 handAt(double t, double press) const override { return {0.03 * triangleWave(t, 1.667), 0.0, kHalf.z - press}; }

 private:
  // m: a plate of 1 mm, the thinnest that must not be passed through (M8). Half: harder, twice: easier to keep to.
  static constexpr dvec3 kHalf{0.05, 0.05, 0.0005};
};

}  // namespace

ConstraintSet emptySet(const Pose& X_DP) {
  ConstraintSet set;
  set.X_DR = X_DP;
  set.zone_radius = haptic::kWantedZoneRadius;
  return set;
}

void add(ConstraintSet& set, const Constraint& constraint) {
  HAPTICELL_DEMAND(set.count < haptic::kMaxConstraints);
  set.constraints[set.count++] = constraint;
}

double triangleWave(double t, double rate) {
  const double phase = t * rate - std::floor(t * rate / 2.0) * 2.0;
  return phase < 1.0 ? 2.0 * phase - 1.0 : 3.0 - 2.0 * phase;
}

Constraint planeConstraint(const dvec3& point, const dvec3& normal, const Pose& X_DR, std::uint32_t group) {
  Constraint c = quadricConstraint(point, normal, dmat3(0.0), X_DR);
  c.group = group;
  c.id = group + 1;
  return c;
}

Constraint quadricConstraint(const dvec3& point, const dvec3& normal, const dmat3& M, const Pose& X_DR) {
  const dvec3 e = X_DR.p - point;
  const dvec3 gradient = normal + M * e;
  Constraint c;
  c.gap = glm::dot(normal, e) + 0.5 * glm::dot(e, M * e);
  c.gradient = {gradient.x, gradient.y, gradient.z, 0.0, 0.0, 0.0};
  c.curvature[0] = M[0][0];
  c.curvature[1] = M[1][0];
  c.curvature[2] = M[2][0];
  c.curvature[6] = M[1][1];
  c.curvature[7] = M[2][1];
  c.curvature[11] = M[2][2];
  return c;
}

std::unique_ptr<FeelScene> planeScene() {
  return std::make_unique<Plane>();
}
std::unique_ptr<FeelScene> cylinderScene(double radius) {
  return std::make_unique<Cylinder>(radius);
}
std::unique_ptr<FeelScene> facetScene(double radius, double degrees) {
  return std::make_unique<Facets>(radius, degrees * std::numbers::pi / 180.0);
}
std::unique_ptr<FeelScene> boreScene(double radius) {
  return std::make_unique<Bore>(radius);
}
std::unique_ptr<FeelScene> edgeScene() {
  return std::make_unique<Edge>();
}
std::unique_ptr<FeelScene> cornerScene() {
  return std::make_unique<Corner>();
}
std::unique_ptr<FeelScene> plateScene() {
  return std::make_unique<Plate>();
}
std::unique_ptr<FeelScene> hingeScene() {
  return std::make_unique<Hinge>();
}

}  // namespace hapticell::feel
