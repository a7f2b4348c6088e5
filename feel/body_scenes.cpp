// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "feel/scene.h"

namespace hapticell::feel {

namespace {

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
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    for (std::uint32_t i = 0; i < 8; ++i) {
      Constraint c = bodyPointConstraint(corner(i), (X_DP * corner(i)).z, dvec3(0, 0, 1), X_DP);
      c.group = i;
      c.friction = friction;
      add(set, c);
    }
    return set;
  }
  double penetration(const Pose& X_DP, double) const override {
    double depth = 0.0;
    for (std::uint32_t i = 0; i < 8; ++i) depth = std::max(depth, -(X_DP * corner(i)).z);
    return depth;
  }
  dvec3 handAt(double t, double press) const override { return {0.03 * triangleWave(t, 1.667), 0.0, 0.02 - press}; }
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
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    ConstraintSet set = emptySet(X_DP);
    const dvec3 tip = X_DP * kTip;
    addRim(set, X_DP, kTip, false);
    addRim(set, X_DP, {0.0, 0.0, kMouth - X_DP.p.z}, true);
    Constraint bottom = bodyPointConstraint(kTip, tip.z - kBottom, dvec3(0, 0, 1), X_DP);
    bottom.group = 16;
    add(set, bottom);
    return set;
  }
  double penetration(const Pose& X_DP, double) const override {
    const dvec3 tip = X_DP * kTip;
    const dvec3 axis = X_DP.rotate(dvec3(0, 0, 1));
    const dvec3 mouth = tip + axis * ((kMouth - tip.z) / axis.z);
    // The polygon of eight planes is wider than the circle by this factor at its corners.
    const double allowed = kClearance / std::cos(std::numbers::pi / 8.0);
    return std::max({0.0, std::hypot(tip.x, tip.y) - allowed, std::hypot(mouth.x, mouth.y) - allowed, kBottom - tip.z});
  }
  dvec3 handAt(double t, double press) const override {
    const double angle = 3.0 * t;
    return {press * std::cos(angle), press * std::sin(angle), 0.008 * triangleWave(t, 4.0)};
  }
  dquat turnAt(double t) const override {
    return quaternionFromRotationVector({0.03 * std::sin(5.0 * t), 0.0, 0.2 * t});
  }
  dvec3 start() const override { return dvec3(0.0); }
  dvec3 rest() const override { return {0.0, 0.0, kBottom + 0.03}; }
  dvec3 pressDirection() const override { return glm::normalize(dvec3(1.0, 0.5, -1.0)); }

 private:
  // m: a peg of 20 mm depth in its hole with 0.05 mm of play, as the factory's. Half: the same figures ask for twice
  // the accuracy of tilts; twice: an easier scene.
  static constexpr double kClearance = 0.05e-3, kMouth = -0.01, kBottom = -0.04;
  static constexpr dvec3 kTip{0.0, 0.0, -0.03};
  static void addRim(ConstraintSet& set, const Pose& X_DP, const dvec3& p_SB, bool stays) {
    const dvec3 at = X_DP * p_SB;
    for (int i = 0; i < 8; ++i) {
      const dvec3 inward(-std::cos(std::numbers::pi / 4.0 * i), -std::sin(std::numbers::pi / 4.0 * i), 0.0);
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

std::unique_ptr<FeelScene> boxScene() {
  return std::make_unique<Box>();
}
std::unique_ptr<FeelScene> pegScene() {
  return std::make_unique<Peg>();
}

}  // namespace hapticell::feel
