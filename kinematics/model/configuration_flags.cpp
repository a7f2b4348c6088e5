// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/configuration_flags.h"

#include <cmath>
#include <numbers>

#include "geometry/system/text_case.h"

namespace hapticell::kinematics {

namespace {

// Sine of the angle between two axes: ClassTolerance's 0.02 rad, so that calibrated arms have flags too. Half: some of
// those have none; twice: an arm with slanted axes gets flags that say little.
constexpr double kNearlyParallel = 0.02;
// m, between two axes: ClassTolerance's 0.3 % of the reach for an arm of 3 m. Half: large calibrated arms have no
// flags; twice: an offset of 20 mm, a real one, is ignored.
constexpr double kNearlyMeeting = 0.01;

bool parallel(const dvec3& a, const dvec3& b) {
  return glm::length(glm::cross(a, b)) < kNearlyParallel;
}

// The point of axis a that is nearest to axis b, where they meet.
std::optional<dvec3> meeting(const dvec3* axis_B, const dvec3* origin_B, std::size_t a, std::size_t b) {
  const dvec3 normal = glm::cross(axis_B[a], axis_B[b]);
  const double squared = glm::dot(normal, normal);
  if (squared < kNearlyParallel * kNearlyParallel) return std::nullopt;
  const dvec3 between = origin_B[b] - origin_B[a];
  const dvec3 point = origin_B[a] + glm::dot(glm::cross(between, axis_B[b]), normal) / squared * axis_B[a];
  if (glm::length(glm::cross(point - origin_B[b], axis_B[b])) > kNearlyMeeting) return std::nullopt;
  return point;
}

bool isSixRevolutesBehindRails(const Chain& chain, std::size_t rails) {
  const auto& elements = chain.elements();
  if (chain.size() < 6 || elements.size() != chain.size()) return false;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].prismatic != (i < rails)) return false;
  }
  return true;
}

// Negative zero and roundings do not make a quadrant: ABB counts -0.0 as the first.
int quadrant(double angle) {
  return static_cast<int>(std::floor(angle / (0.5 * std::numbers::pi) + 1e-9));
}

// m, m^2, sine of joint 5: what is left of an inverse's rounding, a hundred times the 1e-9 a pose is met to. Half,
// twice: no effect but on which side exactly straight wrists and elbows count.
constexpr double kBetween = 1e-7;

int halfTurns(double angle) {
  return static_cast<int>(std::floor((angle + std::numbers::pi) / (2.0 * std::numbers::pi)));
}

}  // namespace

ArmShapes::ArmShapes(const Chain& chain) : rails_(chain.size() < 6 ? 0 : chain.size() - 6) {
  if (!isSixRevolutesBehindRails(chain, rails_)) return;
  ChainState zero;
  chain.evaluate({}, zero);
  const dvec3 *axis_B = zero.axis_B.data() + rails_, *origin_B = zero.origin_B.data() + rails_;
  if (!parallel(axis_B[1], axis_B[2]) || parallel(axis_B[0], axis_B[1])) return;
  any_ = true;
  three_parallel_ = parallel(axis_B[2], axis_B[3]);
  up_B_ = axis_B[0].z < 0.0 ? -axis_B[0] : axis_B[0];
  // "Forward" of the arm plane: the way axis 2 lies from axis 1, else the way the arm points at zero.
  const dvec3 forward = glm::normalize(glm::cross(axis_B[1], up_B_));
  const double offset = glm::dot(origin_B[1] - origin_B[0], forward);
  const double ahead = glm::dot(zero.p_BT - origin_B[0], forward);
  double way = 1.0;
  if (std::abs(ahead) > kNearlyMeeting) way = ahead;
  if (std::abs(offset) > kNearlyMeeting) way = offset;
  forward_sign_ = way < 0.0 ? -1.0 : 1.0;
}

std::optional<ArmShape> ArmShapes::at(const Chain& chain, const ChainPositions& x) const {
  if (!any_) return std::nullopt;
  ChainState state;
  chain.evaluate(x, state);
  return of(state.axis_B.data() + rails_, state.origin_B.data() + rails_);
}

std::optional<ArmShape> ArmShapes::of(const dvec3* axis_B, const dvec3* origin_B) const {
  if (!any_) return std::nullopt;
  // What says front and back; with three parallel axes the wrist is a forearm of its own.
  const auto wrist = three_parallel_ ? meeting(axis_B, origin_B, 4, 5) : meeting(axis_B, origin_B, 3, 4);
  if (!wrist) return std::nullopt;
  const dvec3 forward = forward_sign_ * glm::cross(axis_B[1], up_B_);
  const dvec3 bend = three_parallel_ ? origin_B[3] : *wrist;  // What says elbow up and down.
  const dvec3 to_wrist = bend - origin_B[1], to_elbow = origin_B[2] - origin_B[1];
  ArmShape shape;
  // Between two branches (a straight wrist, a stretched elbow, a wrist over axis 1) rounding must not choose.
  shape.front = glm::dot(*wrist - origin_B[0], forward) >= -kBetween;
  shape.wrist_forward = glm::dot(glm::cross(to_wrist, to_elbow), glm::cross(forward, up_B_)) >= -kBetween;
  shape.elbow_up = shape.wrist_forward == shape.front;
  shape.flipped = glm::dot(glm::cross(axis_B[3], axis_B[5]), axis_B[4]) < -kBetween;
  return shape;
}

std::optional<ArmShape> armShape(const Chain& chain, const ChainPositions& x) {
  return ArmShapes(chain).at(chain, x);
}

std::string toString(const ArmShape& shape) {
  constexpr const char* kNames[] = {"back, elbow down, wrist not flipped",  "back, elbow down, wrist flipped",
                                    "back, elbow up, wrist not flipped",    "back, elbow up, wrist flipped",
                                    "front, elbow down, wrist not flipped", "front, elbow down, wrist flipped",
                                    "front, elbow up, wrist not flipped",   "front, elbow up, wrist flipped"};
  return kNames[(shape.front ? 4 : 0) + (shape.elbow_up ? 2 : 0) + (shape.flipped ? 1 : 0)];
}

Maker makerOf(const RobotModel& model) {
  std::string names = model.name;
  for (const Link& link : model.links) {
    names += ' ' + link.name;
    for (const LinkShape& shape : link.visuals) names += ' ' + shape.source;
  }
  names = lowerCase(names);
  const auto has = [&](const char* word) { return names.find(word) != std::string::npos; };
  if (has("kuka")) return Maker::kKuka;
  if (has("abb_") || has("abb ") || has("irb")) return Maker::kAbb;
  if (has("fanuc")) return Maker::kFanuc;
  return Maker::kUnknown;
}

KukaFlags kukaFlags(const ArmShape& shape, const std::array<double, 6>& q) {
  const bool wrist = (q[4] < 0.0 && q[4] >= -std::numbers::pi) || q[4] >= std::numbers::pi;
  KukaFlags flags{(shape.front ? 0 : 1) + (shape.wrist_forward ? 2 : 0) + (wrist ? 4 : 0), 0};
  for (std::size_t i = 0; i < 6; ++i) flags.turn += q[i] < 0.0 ? 1 << i : 0;
  return flags;
}

AbbFlags abbFlags(const ArmShape& shape, const std::array<double, 6>& q) {
  return {quadrant(q[0]), quadrant(q[3]), quadrant(q[5]),
          (shape.front ? 0 : 4) + (shape.wrist_forward ? 0 : 2) + (q[4] < 0.0 ? 1 : 0)};
}

FanucFlags fanucFlags(const ArmShape& shape, const std::array<double, 6>& q) {
  return {q[4] < 0.0 ? 'N' : 'F',
          shape.elbow_up ? 'U' : 'D',
          shape.front ? 'T' : 'B',
          {halfTurns(q[0]), halfTurns(q[3]), halfTurns(q[5])}};
}

std::string makerFlags(Maker maker, const ArmShape& shape, const std::array<double, 6>& q) {
  switch (maker) {
    case Maker::kKuka: {
      const KukaFlags flags = kukaFlags(shape, q);
      return "S " + std::to_string(flags.status) + ", T " + std::to_string(flags.turn);
    }
    case Maker::kAbb: {
      const AbbFlags flags = abbFlags(shape, q);
      return "cf1 " + std::to_string(flags.cf1) + ", cf4 " + std::to_string(flags.cf4) + ", cf6 " +
             std::to_string(flags.cf6) + ", cfx " + std::to_string(flags.cfx);
    }
    case Maker::kFanuc: {
      const FanucFlags flags = fanucFlags(shape, q);
      std::string text{flags.wrist, ' ', flags.elbow, ' ', flags.base};
      for (const int turns : flags.turns) text += ", " + std::to_string(turns);
      return text;
    }
    case Maker::kUnknown:
      break;
  }
  return {};
}

}  // namespace hapticell::kinematics
