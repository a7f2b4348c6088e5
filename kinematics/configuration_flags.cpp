// SPDX-License-Identifier: Apache-2.0
#include "kinematics/configuration_flags.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::kinematics {

namespace {

constexpr double kParallel = 0.02;  // sine of the angle between two axes; calibrated arms have shapes too
constexpr double kMeeting = 0.01;   // m, between two axes

double distanceToAxis(const dvec3& point, const ChainState& state, std::size_t axis) {
  return glm::length(glm::cross(point - state.origin_B[axis], state.axis_B[axis]));
}

bool parallel(const ChainState& state, std::size_t a, std::size_t b) {
  return glm::length(glm::cross(state.axis_B[a], state.axis_B[b])) < kParallel;
}

// The point of axis a that is nearest to axis b, where they meet.
std::optional<dvec3> meeting(const ChainState& state, std::size_t a, std::size_t b) {
  const dvec3 normal = glm::cross(state.axis_B[a], state.axis_B[b]);
  const double squared = glm::dot(normal, normal);
  if (squared < kParallel * kParallel) return std::nullopt;
  const dvec3 between = state.origin_B[b] - state.origin_B[a];
  const dvec3 point =
      state.origin_B[a] + glm::dot(glm::cross(between, state.axis_B[b]), normal) / squared * state.axis_B[a];
  if (distanceToAxis(point, state, b) > kMeeting) return std::nullopt;
  return point;
}

/// What says front and back, and what says elbow up and down.
struct WristPoints {
  dvec3 reach;
  dvec3 bend;
};

std::optional<WristPoints> wristPoints(const ChainState& state) {
  if (parallel(state, 2, 3)) {  // three parallel axes: the wrist is a forearm of its own
    const auto point = meeting(state, 4, 5);
    if (!point) return std::nullopt;
    return WristPoints{*point, state.origin_B[3]};
  }
  const auto point = meeting(state, 3, 4);
  if (!point) return std::nullopt;
  return WristPoints{*point, *point};
}

// "Forward" of the arm plane: the way axis 2 lies from axis 1, else the way the arm points at zero.
dvec3 forwardDirection(const ChainState& state, const ChainState& zero, const dvec3& up) {
  const dvec3 forward = glm::normalize(glm::cross(state.axis_B[1], up));
  const dvec3 forward_zero = glm::normalize(glm::cross(zero.axis_B[1], up));
  const double offset = glm::dot(zero.origin_B[1] - zero.origin_B[0], forward_zero);
  const double ahead = glm::dot(zero.p_BT - zero.origin_B[0], forward_zero);
  const double sign = std::abs(offset) > kMeeting ? offset : (std::abs(ahead) > kMeeting ? ahead : 1.0);
  return sign < 0.0 ? -forward : forward;
}

// Negative zero and roundings do not make a quadrant: ABB counts -0.0 as the first.
int quadrant(double angle) {
  return static_cast<int>(std::floor(angle / (0.5 * std::numbers::pi) + 1e-9));
}

int halfTurns(double angle) {
  return static_cast<int>(std::floor((angle + std::numbers::pi) / (2.0 * std::numbers::pi)));
}

}  // namespace

std::optional<ArmShape> armShape(const Chain& chain, const ChainPositions& x) {
  const auto& elements = chain.elements();
  const std::size_t rails = chain.size() < 6 ? 0 : chain.size() - 6;
  if (chain.size() < 6 || elements.size() != chain.size()) return std::nullopt;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].prismatic != (i < rails)) return std::nullopt;
  }
  ChainState state, zero;
  chain.evaluate(x, state);
  chain.evaluate({}, zero);
  for (ChainState* s : {&state, &zero}) {
    std::move(s->axis_B.begin() + static_cast<std::ptrdiff_t>(rails), s->axis_B.end(), s->axis_B.begin());
    std::move(s->origin_B.begin() + static_cast<std::ptrdiff_t>(rails), s->origin_B.end(), s->origin_B.begin());
  }
  if (!parallel(state, 1, 2) || parallel(state, 0, 1)) return std::nullopt;
  const auto wrist = wristPoints(state);
  if (!wrist) return std::nullopt;
  const dvec3 up = state.axis_B[0].z < 0.0 ? -state.axis_B[0] : state.axis_B[0];
  const dvec3 forward = forwardDirection(state, zero, up);
  const dvec3 to_wrist = wrist->bend - state.origin_B[1], to_elbow = state.origin_B[2] - state.origin_B[1];
  ArmShape shape;
  shape.front = glm::dot(wrist->reach - state.origin_B[0], forward) >= 0.0;
  shape.wrist_forward = glm::dot(glm::cross(to_wrist, to_elbow), glm::cross(forward, up)) >= 0.0;
  shape.elbow_up = shape.wrist_forward == shape.front;
  shape.flipped = glm::dot(glm::cross(state.axis_B[3], state.axis_B[5]), state.axis_B[4]) < 0.0;
  return shape;
}

std::string toString(const ArmShape& shape) {
  return std::string(shape.front ? "front" : "back") + (shape.elbow_up ? ", elbow up" : ", elbow down") +
         (shape.flipped ? ", wrist flipped" : ", wrist not flipped");
}

Maker makerOf(const RobotModel& model) {
  std::string names = model.name;
  for (const Link& link : model.links) {
    names += ' ' + link.name;
    for (const LinkShape& shape : link.visuals) names += ' ' + shape.source;
  }
  std::transform(names.begin(), names.end(), names.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto has = [&](const char* word) { return names.find(word) != std::string::npos; };
  if (has("kuka")) return Maker::kKuka;
  if (has("abb_") || has("abb ") || has("irb")) return Maker::kAbb;
  if (has("fanuc")) return Maker::kFanuc;
  return Maker::kUnknown;
}

KukaFlags kukaFlags(const ArmShape& shape, const std::array<double, 6>& q) {
  constexpr double kPi = std::numbers::pi;
  const bool wrist = (q[4] < 0.0 && q[4] >= -kPi) || q[4] >= kPi;
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
