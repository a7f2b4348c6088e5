// SPDX-License-Identifier: Apache-2.0
#include "tests/haptic/rendering/feel_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::haptic::test {

namespace {

constexpr double kPi = std::numbers::pi;

ConstraintSet emptySet(const Pose& X_DP) {
  ConstraintSet set;
  set.X_DR = X_DP;
  set.zone_radius = kWantedZoneRadius;
  return set;
}

void add(ConstraintSet& set, const Constraint& constraint) {
  set.constraints[set.count++] = constraint;
}

/// To and fro between -1 and 1 at constant speed; `rate` in ways per second.
double triangle(double t, double rate) {
  const double phase = t * rate - std::floor(t * rate / 2.0) * 2.0;
  return phase < 1.0 ? 2.0 * phase - 1.0 : 3.0 - 2.0 * phase;
}

class Plane final : public FeelScene {
 public:
  std::string name() const override { return "plane"; }
  ConstraintSet setAt(const Pose& X_DP) const override {
    ConstraintSet set = emptySet(X_DP);
    Constraint c = planeConstraint(dvec3(0.0), dvec3(0, 0, 1), X_DP, 0);
    c.friction = friction;
    add(set, c);
    return set;
  }
  double penetration(const Pose& X_DP) const override { return std::max(0.0, -X_DP.p.z); }
  dvec3 handAt(double t, double press) const override { return {0.03 * triangle(t, 1.667), 0.0, -press}; }
};

class Cylinder final : public FeelScene {
 public:
  explicit Cylinder(double radius) : radius_(radius) {}
  std::string name() const override { return "cylinder R" + std::to_string(std::lround(radius_ * 1e3)); }
  ConstraintSet setAt(const Pose& X_DP) const override {
    ConstraintSet set = emptySet(X_DP);
    const dvec3 n = normalAt(X_DP.p);
    const dvec3 t = glm::cross(dvec3(0, 1, 0), n);
    const dmat3 M = (glm::outerProduct(t, t) + glm::outerProduct(n, n)) / radius_;
    Constraint c = quadricConstraint(axis() + radius_ * n + dvec3(0, X_DP.p.y, 0), n, M, X_DP);
    c.friction = friction;
    add(set, c);
    return set;
  }
  double penetration(const Pose& X_DP) const override {
    return std::max(0.0, radius_ - std::hypot(X_DP.p.x, X_DP.p.z - axis().z));
  }
  dvec3 handAt(double t, double press) const override {
    const double sweep = std::min(0.03 / radius_, 1.2);
    const double angle = sweep * triangle(t, 0.1 / (2.0 * sweep * radius_));
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
  Facets(double radius, int count) : round_(radius), radius_(radius), count_(count) {}
  std::string name() const override { return "facets"; }
  ConstraintSet setAt(const Pose& X_DP) const override {
    ConstraintSet set = emptySet(X_DP);
    for (int i = 0; i < count_; ++i) {
      add(set, planeConstraint(dvec3(0.0, 0.0, -radius_) + apothem() * normal(i), normal(i), X_DP, 0));
    }
    return set;
  }
  double penetration(const Pose& X_DP) const override {
    double depth = 1.0;
    for (int i = 0; i < count_; ++i) {
      depth = std::min(depth, apothem() - glm::dot(normal(i), X_DP.p + dvec3(0.0, 0.0, radius_)));
    }
    return std::max(0.0, depth);
  }
  dvec3 handAt(double t, double press) const override { return round_.handAt(t, press); }

 private:
  double apothem() const { return radius_ * std::cos(kPi / count_); }
  dvec3 normal(int i) const {
    const double angle = 2.0 * kPi * (i + 0.5) / count_;
    return {std::sin(angle), 0.0, std::cos(angle)};
  }
  Cylinder round_;
  double radius_;
  int count_;
};

class Bore final : public FeelScene {
 public:
  explicit Bore(double radius) : radius_(radius) {}
  std::string name() const override { return "bore R" + std::to_string(std::lround(radius_ * 1e3)); }
  ConstraintSet setAt(const Pose& X_DP) const override {
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
  double penetration(const Pose& X_DP) const override {
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
  ConstraintSet setAt(const Pose& X_DP) const override {
    ConstraintSet set = emptySet(X_DP);
    add(set, planeConstraint(dvec3(0.0), dvec3(0, 0, 1), X_DP, 0));
    add(set, planeConstraint(dvec3(0.0), dvec3(1, 0, 0), X_DP, 0));
    return set;
  }
  double penetration(const Pose& X_DP) const override { return std::max(0.0, std::min(-X_DP.p.x, -X_DP.p.z)); }
  // Along the top towards the edge, as far as the deep stylus stays nearer to the top (the trial: before leaving).
  dvec3 handAt(double t, double press) const override { return {-0.032 + 0.02 * triangle(t, 2.5), 0.0, -press}; }
};

class Corner final : public FeelScene {
 public:
  std::string name() const override { return "corner"; }
  dvec3 start() const override { return dvec3(0.02, 0.004, 0.004); }
  dvec3 pressDirection() const override { return glm::normalize(dvec3(-1.0, -1.0, -2.0)); }
  ConstraintSet setAt(const Pose& X_DP) const override {
    ConstraintSet set = emptySet(X_DP);
    add(set, planeConstraint(dvec3(0.0), dvec3(1, 0, 0), X_DP, 0));
    add(set, planeConstraint(dvec3(0.0), dvec3(0, 1, 0), X_DP, 1));
    add(set, planeConstraint(dvec3(0.0), dvec3(0, 0, 1), X_DP, 2));
    for (std::size_t i = 0; i < set.count; ++i) set.constraints[i].friction = friction;
    return set;
  }
  double penetration(const Pose& X_DP) const override { return std::max({0.0, -X_DP.p.x, -X_DP.p.y, -X_DP.p.z}); }
  dvec3 handAt(double t, double press) const override {
    // Along the edge into the corner and out of it again.
    return {0.02 + (0.02 + 0.8 * press) * -triangle(t, 2.5), -0.6 * press, -press};
  }
};

class Hinge final : public FeelScene {
 public:
  std::string name() const override { return "hinge"; }
  ConstraintSet setAt(const Pose& X_DP) const override {
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
  double penetration(const Pose& X_DP) const override {
    const double off = std::max(std::abs(std::hypot(X_DP.p.x, X_DP.p.z - kAxis) - kRadius), std::abs(X_DP.p.y));
    return std::max(off, glm::dot(X_DP.p - stop(), dvec3(std::cos(kStop), 0.0, -std::sin(kStop))));
  }
  dvec3 handAt(double t, double press) const override {
    const double angle = 0.6 * triangle(t, 0.1 / (1.2 * kRadius));
    return dvec3(0, 0, kAxis) + (kRadius + press) * dvec3(std::sin(angle), 0.0, std::cos(angle));
  }
  dvec3 start() const override { return handAt(0.0, 0.0); }
  dvec3 rest() const override { return stop(); }

 private:
  static constexpr double kRadius = 0.04, kAxis = -0.04, kStop = 0.5;
  dvec3 stop() const { return dvec3(0, 0, kAxis) + kRadius * dvec3(std::sin(kStop), 0.0, std::cos(kStop)); }
};

class Plate final : public FeelScene {
 public:
  std::string name() const override { return "plate"; }
  ConstraintSet setAt(const Pose& X_DP) const override {
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
  double penetration(const Pose& X_DP) const override {
    double depth = 1.0;
    for (int axis = 0; axis < 3; ++axis) depth = std::min(depth, kHalf[axis] - std::abs(X_DP.p[axis]));
    return std::max(0.0, depth);
  }
  dvec3 handAt(double, double press) const override { return {0.0, 0.0, kHalf.z - press}; }

 private:
  static constexpr dvec3 kHalf{0.05, 0.05, 0.0005};
};

/// The rotation block of a body point's constraint: 1/2 (g rho' + rho g') - (g . rho) I for a plane.
void addTurning(Constraint& c, const dvec3& g, const dvec3& rho) {
  const dmat3 block = 0.5 * (glm::outerProduct(g, rho) + glm::outerProduct(rho, g)) - glm::dot(g, rho) * dmat3(1.0);
  c.curvature[15] = block[0][0];
  c.curvature[16] = block[1][0];
  c.curvature[17] = block[2][0];
  c.curvature[18] = block[1][1];
  c.curvature[19] = block[2][1];
  c.curvature[20] = block[2][2];
}

class Box final : public FeelScene {
 public:
  std::string name() const override { return "box"; }
  ConstraintSet setAt(const Pose& X_DP) const override {
    ConstraintSet set = emptySet(X_DP);
    for (std::uint32_t i = 0; i < 8; ++i) {
      Constraint c = bodyPointConstraint(corner(i), (X_DP * corner(i)).z, dvec3(0, 0, 1), X_DP);
      c.group = i;
      c.friction = friction;
      add(set, c);
    }
    return set;
  }
  double penetration(const Pose& X_DP) const override {
    double depth = 0.0;
    for (std::uint32_t i = 0; i < 8; ++i) depth = std::max(depth, -(X_DP * corner(i)).z);
    return depth;
  }
  dvec3 handAt(double t, double press) const override { return {0.03 * triangle(t, 1.667), 0.0, 0.02 - press}; }
  dquat turnAt(double t) const override {
    return quaternionFromRotationVector({0.2 * std::sin(3.0 * t), 0.15 * std::sin(4.1 * t), 0.5 * std::sin(2.0 * t)});
  }
  dvec3 start() const override { return {-0.03, 0.0, 0.03}; }
  dvec3 rest() const override { return {0.0, 0.0, 0.02}; }

 private:
  static dvec3 corner(std::uint32_t i) {
    return {(i & 1u) != 0 ? 0.03 : -0.03, (i & 2u) != 0 ? 0.02 : -0.02, (i & 4u) != 0 ? 0.0 : -0.02};
  }
};

class Peg final : public FeelScene {
 public:
  std::string name() const override { return "peg"; }
  ConstraintSet setAt(const Pose& X_DP) const override {
    ConstraintSet set = emptySet(X_DP);
    const dvec3 tip = X_DP * kTip;
    addRim(set, X_DP, kTip, false);
    addRim(set, X_DP, {0.0, 0.0, kMouth - X_DP.p.z}, true);
    Constraint bottom = bodyPointConstraint(kTip, tip.z - kBottom, dvec3(0, 0, 1), X_DP);
    bottom.group = 16;
    add(set, bottom);
    return set;
  }
  double penetration(const Pose& X_DP) const override {
    const dvec3 tip = X_DP * kTip;
    const dvec3 axis = X_DP.rotate(dvec3(0, 0, 1));
    const dvec3 mouth = tip + axis * ((kMouth - tip.z) / axis.z);
    // The polygon of eight planes is wider than the circle by this factor at its corners.
    const double allowed = kClearance / std::cos(kPi / 8.0);
    return std::max({0.0, std::hypot(tip.x, tip.y) - allowed, std::hypot(mouth.x, mouth.y) - allowed, kBottom - tip.z});
  }
  dvec3 handAt(double t, double press) const override {
    const double angle = 3.0 * t;
    return {press * std::cos(angle), press * std::sin(angle), 0.008 * triangle(t, 4.0)};
  }
  dquat turnAt(double t) const override {
    return quaternionFromRotationVector({0.03 * std::sin(5.0 * t), 0.0, 0.2 * t});
  }
  dvec3 start() const override { return dvec3(0.0); }
  dvec3 rest() const override { return {0.0, 0.0, kBottom + 0.03}; }
  dvec3 pressDirection() const override { return glm::normalize(dvec3(1.0, 0.5, -1.0)); }

 private:
  static constexpr double kClearance = 0.05e-3, kMouth = -0.01, kBottom = -0.04;
  static constexpr dvec3 kTip{0.0, 0.0, -0.03};
  static void addRim(ConstraintSet& set, const Pose& X_DP, const dvec3& p_SB, bool stays) {
    const dvec3 at = X_DP * p_SB;
    for (int i = 0; i < 8; ++i) {
      const dvec3 inward(-std::cos(kPi / 4.0 * i), -std::sin(kPi / 4.0 * i), 0.0);
      Constraint c = bodyPointConstraint(p_SB, kClearance + glm::dot(inward, at), inward, X_DP);
      c.group = static_cast<std::uint32_t>(set.count);
      if (stays) {
        // The mouth stays where it is while the peg slides through it: rising shortens the lever of a tilt.
        c.gradient[2] -= glm::dot(inward, X_DP.rotate(dvec3(0, 0, 1)));
        const dvec3 mixed = -glm::cross(dvec3(0, 0, 1), inward);
        c.curvature[12] = mixed.x;
        c.curvature[13] = mixed.y;
        c.curvature[14] = mixed.z;
      }
      add(set, c);
    }
  }
};

}  // namespace

Constraint bodyPointConstraint(const dvec3& p_SB, double gap, const dvec3& normal, const Pose& X_DR) {
  const dvec3 rho = X_DR.rotate(p_SB);
  const dvec3 moment = glm::cross(rho, normal);
  Constraint c;
  c.gap = gap;
  c.gradient = {normal.x, normal.y, normal.z, moment.x, moment.y, moment.z};
  addTurning(c, normal, rho);
  return c;
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
std::unique_ptr<FeelScene> facetScene(double radius, int facets) {
  return std::make_unique<Facets>(radius, facets);
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
std::unique_ptr<FeelScene> boxScene() {
  return std::make_unique<Box>();
}
std::unique_ptr<FeelScene> pegScene() {
  return std::make_unique<Peg>();
}
std::unique_ptr<FeelScene> hingeScene() {
  return std::make_unique<Hinge>();
}

}  // namespace hapticell::haptic::test
