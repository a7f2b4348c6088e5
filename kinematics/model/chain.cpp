// SPDX-License-Identifier: Apache-2.0
#include "kinematics/model/chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/system/assertion.h"
#include "kinematics/model/jacobian.h"

namespace hapticell::kinematics {

namespace {

dmat3 rotationAbout(const dvec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const dvec3 v = (1.0 - c) * axis;
  const dvec3 w = s * axis;
  return {v.x * axis.x + c,   v.x * axis.y + w.z, v.x * axis.z - w.y, v.y * axis.x - w.z, v.y * axis.y + c,
          v.y * axis.z + w.x, v.z * axis.x + w.y, v.z * axis.y - w.x, v.z * axis.z + c};
}

Error refusal(const RobotModel& model, int tip_link, const Text& found, const Text& expected) {
  const std::string& tip = model.links[static_cast<std::size_t>(tip_link)].name;
  return {.place = Text("robot '%1', link '%2'", model.name, tip),
          .found = found,
          .expected = expected,
          .fix = "Choose another tip link."};
}

}  // namespace

void Chain::addElement(const RobotModel& model, const Joint& joint, const Pose& X_PJ) {
  const Joint& driver = joint.mimic ? model.joints[static_cast<std::size_t>(joint.mimic->joint)] : joint;
  auto found = std::find(variables_.begin(), variables_.end(), driver.variable);
  const auto variable = static_cast<std::size_t>(found - variables_.begin());
  Element element{X_PJ.R(), X_PJ.p, joint.axis_J, joint.type == JointType::kPrismatic, static_cast<int>(variable),
                  1.0,      0.0};
  if (joint.mimic) {
    element.factor = joint.mimic->multiplier;
    element.offset = joint.mimic->offset;
  }
  const bool whole_turns = !element.prismatic && element.factor == std::round(element.factor);
  turns_[variable] = turns_[variable] && whole_turns;
  elements_.push_back(element);
}

Expected<Chain> Chain::create(const RobotModel& model, int tip_link, const Pose& X_LT) {
  HAPTICELL_DEMAND(tip_link >= 0 && static_cast<std::size_t>(tip_link) < model.links.size());
  Chain chain;
  chain.variables_ = variablesOfChain(model, tip_link);
  const std::size_t count = chain.variables_.size();
  if (count == 0)
    return makeError(refusal(model, tip_link, Text("no moving joint moves this link"), Text("at least one")));
  if (count > kMaxChainVariables) {
    return makeError(refusal(model, tip_link, Text("%1 moving joints move this link", count), Text("at most 16")));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Joint& joint =
        model.joints[static_cast<std::size_t>(model.moving[static_cast<std::size_t>(chain.variables_[i])])];
    chain.lower_[i] = joint.lower;
    chain.upper_[i] = joint.upper;
    chain.velocity_[i] = greatestSpeed(joint);
    chain.turns_[i] = joint.type != JointType::kPrismatic;
  }
  Pose X_PJ;
  for (const int index : chainToTip(model, tip_link)) {
    const Joint& joint = model.joints[static_cast<std::size_t>(index)];
    X_PJ = X_PJ * joint.X_PJ;
    const bool driven = joint.mimic && model.joints[static_cast<std::size_t>(joint.mimic->joint)].variable >= 0;
    if (joint.type == JointType::kFixed || (joint.variable < 0 && !driven)) continue;
    chain.addElement(model, joint, X_PJ);
    X_PJ = Pose::identity();
  }
  if (chain.elements_.size() > kMaxChainJoints) {
    return makeError(refusal(model, tip_link, Text("%1 joints are on the path to this link", chain.elements_.size()),
                             Text("at most 24")));
  }
  X_PJ = X_PJ * X_LT;
  chain.R_LT_ = X_PJ.R();
  chain.p_LT_ = X_PJ.p;
  chain.setReach();
  return chain;
}

void Chain::setReach() {
  reach_ = scale_ = glm::length(p_LT_);
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    if (i > 0) reach_ += glm::length(elements_[i].p_PJ);
    if (i > 0) scale_ += glm::length(elements_[i].p_PJ);
    if (!elements_[i].prismatic) continue;
    const auto variable = static_cast<std::size_t>(elements_[i].variable);
    const double extent = std::max(std::abs(lower_[variable]), std::abs(upper_[variable]));
    reach_ += std::abs(elements_[i].factor) * extent + std::abs(elements_[i].offset);
    scale_ += std::abs(elements_[i].factor) * (std::isfinite(extent) ? extent : 1.0) + std::abs(elements_[i].offset);
  }
}

void Chain::evaluate(const ChainPositions& x, ChainState& state) const {
  dmat3 R(1.0);
  dvec3 p(0.0);
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const Element& element = elements_[i];
    p += R * element.p_PJ;
    R = R * element.R_PJ;
    const double position = element.factor * x[static_cast<std::size_t>(element.variable)] + element.offset;
    state.axis_B[i] = R * element.axis_J;
    state.origin_B[i] = p;
    if (element.prismatic) {
      p += position * state.axis_B[i];
    } else {
      R = R * rotationAbout(element.axis_J, position);
    }
  }
  state.p_BT = p + R * p_LT_;
  state.R_BT = R * R_LT_;
}

}  // namespace hapticell::kinematics
