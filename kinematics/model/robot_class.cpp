// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/robot_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/model/arm_axes.h"
#include "kinematics/model/chain_report.h"

namespace hapticell::kinematics {

namespace {

constexpr double kRight = 0.5 * std::numbers::pi;
// m: an arm shorter than this is no arm but what calibration leaves of 0. Half: closed forms divide by less and lose a
// digit; twice: offsets of 1 to 2 mm make a robot numeric.
constexpr double kLeastLength = 1e-3;
// rad: axes nearer to parallel than this, 6 degrees, do not make a wrist: angles then are ten times as inexact. Half:
// twenty times; twice: odd wrists become numeric.
constexpr double kLeastAngle = 0.1;

/// How far a chain is from a class: the worst angle (rad) and the worst length (m) over all its conditions.
class Misfit {
 public:
  explicit Misfit(const ArmAxes& axes) : axes_(axes) {}

  Misfit& square(std::size_t a, std::size_t b) { return angle(kRight - angleBetween(axes_, a, b)); }
  Misfit& parallel(std::size_t a, std::size_t b) { return angle(angleBetween(axes_, a, b)); }
  Misfit& meet(std::size_t a, std::size_t b) {
    possible_ = possible_ && angleBetween(axes_, a, b) > kLeastAngle;
    return length(lineDistance(axes_, a, b));
  }
  /// Three neighbours in one point.
  Misfit& meet(std::size_t a, std::size_t b, std::size_t c) {
    meet(a, b).meet(b, c);
    return length(glm::length(nearestPoint(axes_, a, b) - nearestPoint(axes_, b, c)));
  }
  /// Two points at the same height along an axis.
  Misfit& alongside(const dvec3& a, const dvec3& b, std::size_t axis) {
    return length(glm::dot(b - a, axes_.axis_B[axis]));
  }
  /// Parallel axes must not be the same line.
  Misfit& apart(std::size_t a, std::size_t b) {
    possible_ = possible_ && lineDistance(axes_, a, b) > kLeastLength;
    return *this;
  }
  Misfit& demand(bool condition) {
    possible_ = possible_ && condition;
    return *this;
  }

  bool within(double angle_rad, double length_m) const {
    return possible_ && angle_ <= angle_rad && length_ <= length_m;
  }

 private:
  const ArmAxes& axes_;
  double angle_ = 0.0, length_ = 0.0;
  bool possible_ = true;

  Misfit& angle(double value) {
    angle_ = std::max(angle_, std::abs(value));
    return *this;
  }
  Misfit& length(double value) {
    length_ = std::max(length_, std::abs(value));
    return *this;
  }
};

Misfit planarArm(const ArmAxes& axes) {
  return Misfit(axes).square(0, 1).parallel(1, 2).apart(1, 2);
}

Misfit fitTo(RobotClass robot_class, const ArmAxes& axes) {
  switch (robot_class) {
    case RobotClass::kOpw:
      return planarArm(axes).square(2, 3).square(3, 4).square(4, 5).meet(3, 4, 5).demand(
          distanceFromAxis(axes, nearestPoint(axes, 3, 4), 2) > kLeastLength);
    case RobotClass::kUr:
      return planarArm(axes).parallel(2, 3).apart(2, 3).square(3, 4).square(4, 5).meet(3, 4).meet(4, 5);
    case RobotClass::kOffsetWrist:
      return planarArm(axes)
          .square(2, 3)
          .square(3, 4)
          .meet(3, 4)
          .demand(angleBetween(axes, 4, 5) > kLeastAngle)
          .demand(distanceFromAxis(axes, nearestPoint(axes, 3, 4), 5) > kLeastLength)
          .demand(distanceFromAxis(axes, nearestPoint(axes, 3, 4), 2) > kLeastLength);
    case RobotClass::kSphericalWrist:
      return Misfit(axes).meet(3, 4, 5);
    case RobotClass::kSphericalBase:
      return Misfit(axes).meet(0, 1, 2);
    case RobotClass::kSrs: {
      Misfit misfit = Misfit(axes).meet(0, 1, 2).meet(2, 3).meet(3, 4).meet(4, 5, 6);
      for (std::size_t i = 0; i < 6; ++i) misfit.square(i, i + 1);
      const dvec3 elbow = nearestPoint(axes, 2, 3);
      misfit.demand(glm::length(elbow - nearestPoint(axes, 0, 1)) > kLeastLength);
      misfit.demand(glm::length(elbow - nearestPoint(axes, 4, 5)) > kLeastLength);
      return misfit;
    }
    case RobotClass::kPanda: {
      Misfit misfit = Misfit(axes).meet(0, 1, 2).meet(4, 5);
      for (std::size_t i = 0; i < 6; ++i) misfit.square(i, i + 1);
      const dvec3 shoulder = nearestPoint(axes, 0, 1), wrist = nearestPoint(axes, 4, 5);
      // Shoulder, elbow and wrist in one plane, axis 7 square over the wrist.
      misfit.alongside(shoulder, wrist, 3).alongside(wrist, axes.origin_B[6], 5);
      return misfit.demand(distanceFromAxis(axes, shoulder, 3) > kLeastLength)
          .demand(distanceFromAxis(axes, wrist, 3) > kLeastLength);
    }
    default:
      break;
  }
  return Misfit(axes).demand(false);
}

// Three turning joints and a slide, all parallel, in any order; rails that are parallel to the axes count as the slide.
bool isScara(const Chain& chain, double angle) {
  if (chain.size() != 4) return false;
  ChainState state;
  chain.evaluate({}, state);
  std::array<std::size_t, 4> turning{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (glm::length(glm::cross(state.axis_B[i], state.axis_B[0])) > angle) return false;
    if (!chain.elements()[i].prismatic) turning[count++] = i;
  }
  if (count != 3) return false;
  const auto apart = [&](std::size_t a, std::size_t b) {
    return glm::length(glm::cross(state.origin_B[turning[b]] - state.origin_B[turning[a]], state.axis_B[0]));
  };
  return apart(0, 1) > kLeastLength && apart(1, 2) > kLeastLength;
}

}  // namespace

const char* toString(RobotClass robot_class) {
  switch (robot_class) {
    case RobotClass::kOpw:
      return "opw";
    case RobotClass::kUr:
      return "ur";
    case RobotClass::kSphericalWrist:
      return "spherical_wrist";
    case RobotClass::kSphericalBase:
      return "spherical_base";
    case RobotClass::kOffsetWrist:
      return "offset_wrist";
    case RobotClass::kSrs:
      return "srs";
    case RobotClass::kPanda:
      return "panda";
    case RobotClass::kScara:
      return "scara";
    case RobotClass::kNumeric:
      break;
  }
  return "numeric";
}

Classification classify(const Chain& chain, const ClassTolerance& tolerance) {
  const ArmAxes axes = armAxes(chain);
  if (!axes.simple) return {};
  if (isScara(chain, tolerance.exact)) return {RobotClass::kScara, 0, false};
  if (std::any_of(axes.prismatic.begin(), axes.prismatic.begin() + static_cast<std::ptrdiff_t>(axes.count),
                  [](bool slides) { return slides; })) {
    return {};
  }
  static constexpr RobotClass kSix[] = {RobotClass::kOpw, RobotClass::kUr, RobotClass::kSphericalWrist,
                                        RobotClass::kSphericalBase, RobotClass::kOffsetWrist};
  static constexpr RobotClass kSeven[] = {RobotClass::kSrs, RobotClass::kPanda};
  for (const bool near : {false, true}) {
    const double angle = near ? tolerance.near_angle : tolerance.exact;
    const double length = near ? tolerance.near_length * axes.reach : tolerance.exact;
    const auto fits = [&](RobotClass robot_class) { return fitTo(robot_class, axes).within(angle, length); };
    if (axes.count == 6) {
      const auto* const found = std::find_if(std::begin(kSix), std::end(kSix), fits);
      if (found != std::end(kSix) && armIsDeficient(chain, axes.rails)) return {};
      if (found != std::end(kSix)) return {*found, axes.rails, near};
    } else if (axes.count == 7) {
      const auto* const found = std::find_if(std::begin(kSeven), std::end(kSeven), fits);
      if (found != std::end(kSeven)) return {*found, axes.rails, near};
    }
  }
  return {};
}

std::string describe(const Classification& classification) {
  std::string text = toString(classification.robot_class);
  if (classification.robot_class == RobotClass::kNumeric) return text;
  if (classification.rails > 0) text = (classification.rails == 1 ? "rail+" : "gantry+") + text;
  return classification.calibrated ? text + " (calibrated)" : text;
}

}  // namespace hapticell::kinematics
