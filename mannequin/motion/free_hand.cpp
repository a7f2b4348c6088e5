// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/free_hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "geometry/system/assertion.h"
#include "mannequin/body/rotations.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::mannequin {

namespace {

using kinematics::Joint;
using kinematics::JointType;
using kinematics::RobotModel;

constexpr const char* kName = "free hand";
constexpr std::array<const char*, 5> kFingerNames{"thumb", "index", "middle", "ring", "pinky"};
// rad to either side, the thumb's, and how far joints bend: 10 deg more than the figure's fingers (0 to 90 deg) and
// back, our choice. Half: fingers stop before the glove's; twice: they bend into the palm.
constexpr double kFingerSpread = 0.45;
constexpr double kThumbIn = -0.6, kThumbOut = 1.2;  // the thumb's,
constexpr double kBack = -0.35, kForward = 1.75;    // and how far joints bend.
// Of the way across the palm: away from it. Our choice, so that the thumb's tip meets the fingers'. Half, twice: it
// bends beside them.
constexpr double kThumbPalmward = 0.35;
constexpr std::array<std::size_t, 3> kBoneIndices{0, 1, 2};

class HandBuilder {
 public:
  HandBuilder(const RobotModel& body, Side side)
      : body_(body), prefix_(side == Side::kLeft ? "l_" : "r_"), out_(outwardSign(side)) {
    model_.name = kName;
    kinematics::Link hand = link(prefix_ + "hand");
    hand.parent_joint = -1;
    model_.links.push_back(std::move(hand));
  }

  RobotModel make() {
    for (std::size_t finger = 0; finger < kFingerNames.size(); ++finger) addFinger(finger);
    addAdjacent();
    return std::move(model_);
  }

 private:
  kinematics::Link link(const std::string& name) const {
    const int at = body_.findLink(name);
    HAPTICELL_DEMAND(at >= 0);
    return body_.links[static_cast<std::size_t>(at)];
  }
  std::string bone(std::size_t finger, std::size_t k) const {
    return prefix_ + kFingerNames[finger] + std::to_string(k + 1);
  }
  /// The joint that carries a bone in the whole figure; it stands on the bone before, unturned.
  const Joint& carrier(std::size_t finger, std::size_t k) const {
    return body_.joints[static_cast<std::size_t>(link(bone(finger, k)).parent_joint)];
  }

  void addJoint(const std::string& name, const dvec3& p_PJ, const dvec3& axis, double lower, double upper) {
    Joint joint;
    joint.name = name;
    joint.type = JointType::kRevolute;
    joint.parent_link = at_;
    joint.child_link = static_cast<int>(model_.links.size());
    joint.X_PJ = Pose::translation(p_PJ);
    joint.axis_J = axis;
    joint.lower = lower;
    joint.upper = upper;
    joint.velocity = 10.0;
    joint.variable = static_cast<int>(model_.moving.size());
    model_.moving.push_back(static_cast<int>(model_.joints.size()));
    model_.links.push_back({name + "_link", static_cast<int>(model_.joints.size()), {}, {}});
    model_.joints.push_back(joint);
    at_ = joint.child_link;
  }

  void dress(std::size_t finger, std::size_t k) {
    kinematics::Link& own = model_.links[static_cast<std::size_t>(at_)];
    const kinematics::Link shape = link(bone(finger, k));
    own.name = shape.name;
    own.visuals = shape.visuals;
    own.collisions = shape.collisions;
  }

  /// About which a finger goes sideways, away from its neighbour nearer to the middle finger.
  dvec3 spreadAxis(std::size_t finger, const dvec3& bend) const {
    const dvec3 along = carrier(finger, 1).X_PJ.p;
    const dvec3 axis = glm::normalize(glm::cross(bend, along));
    const std::size_t neighbour = finger == 1 ? 2 : finger - 1;
    const dvec3 away = carrier(finger, 0).X_PJ.p - carrier(neighbour, 0).X_PJ.p;
    return glm::dot(glm::cross(axis, along), away) < 0.0 ? -axis : axis;
  }

  /// About which a bone bends. The thumb rolls about the length of the hand until it stands before the palm, and its
  /// outer bones bend across it.
  dvec3 bendAxis(std::size_t finger, std::size_t k) const {
    if (finger != 0) return carrier(finger, 1).axis_J;
    if (k == 0) return {0.0, 0.0, -out_};
    const dvec3 across(-1.0, -kThumbPalmward * out_, 0.0);
    return glm::normalize(glm::cross(carrier(0, 1).X_PJ.p, across));
  }

  void addFinger(std::size_t finger) {
    at_ = 0;
    const bool thumb = finger == 0;
    const std::string name = prefix_ + kFingerNames[finger];
    const dvec3 spread = thumb ? carrier(0, 0).axis_J : spreadAxis(finger, bendAxis(finger, 0));
    addJoint(name + "_spread", carrier(finger, 0).X_PJ.p, spread, thumb ? kThumbIn : -kFingerSpread,
             thumb ? kThumbOut : kFingerSpread);
    for (const std::size_t k : kBoneIndices) {
      const dvec3 p_PJ = k == 0 ? dvec3(0.0) : carrier(finger, k).X_PJ.p;
      addJoint(name + std::to_string(k + 1) + "_bend", p_PJ, bendAxis(finger, k), kBack, kForward);
      dress(finger, k);
    }
  }

  /// Bones beside each other, knuckles beside each other: they touch at rest and always.
  void addAdjacent() {
    const auto at = [&](std::size_t finger, std::size_t k) { return model_.findLink(bone(finger, k)); };
    const auto leave = [&](int first, int second) { model_.disabled_pairs.push_back({first, second, "Adjacent"}); };
    for (std::size_t finger = 0; finger < kFingerNames.size(); ++finger) {
      leave(0, at(finger, 0));
      leave(at(finger, 0), at(finger, 1));
      leave(at(finger, 1), at(finger, 2));
      if (finger + 1 < kFingerNames.size()) leave(at(finger, 0), at(finger + 1, 0));
    }
  }

  const RobotModel& body_;
  std::string prefix_;
  double out_;  // The back of the hand looks to out_ y.
  RobotModel model_;
  int at_ = 0;
};

}  // namespace

std::shared_ptr<const RobotModel> freeHandModel(const Figure& figure, Side side) {
  return std::make_shared<const RobotModel>(HandBuilder(*figureModel(figure), side).make());
}

bool isFreeHand(const RobotModel& model) {
  return model.name == kName && model.moving.size() == kFreeHandJoints;
}

Side sideOf(const RobotModel& model) {
  HAPTICELL_DEMAND(isFreeHand(model));
  return model.links.front().name == "l_hand" ? Side::kLeft : Side::kRight;
}

std::vector<double> freeHandFromGlove(const GloveReadings& angles, const RobotModel& model) {
  HAPTICELL_DEMAND(isFreeHand(model));
  std::vector<double> joints{angles[3],
                             angles[0],
                             angles[1],
                             angles[2],
                             angles[10],
                             angles[4],
                             angles[5],
                             angles[6],
                             0.0,
                             angles[7],
                             angles[8],
                             angles[9],
                             angles[14],
                             angles[11],
                             angles[12],
                             angles[13],
                             angles[14] + angles[18],
                             angles[15],
                             angles[16],
                             angles[17]};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    joints[i] = std::clamp(std::isfinite(joints[i]) ? joints[i] : 0.0, joint.lower, joint.upper);
  }
  return joints;
}

}  // namespace hapticell::mannequin
