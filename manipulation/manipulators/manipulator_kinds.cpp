// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/manipulator_kinds.h"

#include <algorithm>
#include <utility>

#include "kinematics/closed_form/inverse_factory.h"
#include "manipulation/manipulators/jointed_whole.h"
#include "manipulation/manipulators/mannequin_head.h"
#include "manipulation/manipulators/mannequin_manipulator.h"
#include "manipulation/manipulators/mannequin_taking.h"
#include "manipulation/manipulators/robot_base_manipulator.h"
#include "manipulation/manipulators/robot_manipulator.h"
#include "manipulation/manipulators/solid_manipulator.h"
#include "mannequin/motion/free_hand.h"

namespace hapticell::manipulation {
namespace {

using workcell::Entity;
using workcell::EntityKind;
using Kind = MovedBy::Kind;
using Made = Expected<std::unique_ptr<Manipulator>>;

/// Or a mechanism.
bool isRobot(const Entity& entity) {
  return entity.robot != nullptr && entity.kind != EntityKind::kMannequin;
}

bool isFigure(const Entity& entity) {
  return entity.figure != nullptr && entity.robot != nullptr;
}

std::string choicesOf(const Entity& entity) {
  if (entity.kind == EntityKind::kMannequin) return "whole, left_hand, right_hand, both_hands, head or self_origin";
  return entity.robot ? "tcp, tcp_with_axes, base, base_keeping_tcp or frame:NAME of one of its links"
                      : "self_origin, geometric_center or frame:NAME of an entity";
}

/// The middle of a mechanism's part: where a hand takes it, away from its joint.
Pose middleOf(const kinematics::RobotModel& model, int link) {
  geometry::Bounds bounds;
  for (const kinematics::LinkShape& shape : model.links[static_cast<std::size_t>(link)].visuals) {
    for (const dvec3& p_SV : shape.mesh->vertices) bounds.add(shape.X_LS * p_SV);
  }
  return bounds.isEmpty() ? Pose::identity() : Pose::translation(bounds.center());
}

kinematics::SingularityChoice singularityChoice(const std::string& at_singularity) {
  using Choice = kinematics::SingularityChoice;
  if (at_singularity == "keep_orientation") return Choice::kKeepOrientation;
  return at_singularity == "keep_joint_4" ? Choice::kKeepJoint4 : Choice::kKeepPosition;
}

std::vector<MannequinBody::Part> bodyParts(const Taking& taking) {
  std::vector<MannequinBody::Part> parts;
  for (const Taking::Part& part : taking.parts) parts.push_back({part.link, part.X_LP});
  return parts;
}

// What hangs on the robot's base, not on a link of it, goes with its root.
std::vector<RobotManipulator::Part> robotParts(const Taking& taking) {
  std::vector<RobotManipulator::Part> parts;
  for (const Taking::Part& part : taking.parts) parts.push_back({std::max(0, part.link), part.X_LP});
  return parts;
}

bool isByHead(const Taking& taking) {
  return isFigure(taking.entity) && taking.moved_by.kind == Kind::kHead;
}

Made makeHead(const Taking& taking) {
  return std::make_unique<MannequinHead>(taking.entity.figure, taking.entity.robot, taking.moved_by.lock_trunk,
                                         bodyParts(taking));
}

bool isByHands(const Taking& taking) {
  const Kind kind = taking.moved_by.kind;
  return isFigure(taking.entity) && (kind == Kind::kLeftHand || kind == Kind::kRightHand || kind == Kind::kBothHands);
}

Made makeHands(const Taking& taking) {
  using Hands = MannequinManipulator::Hands;
  const MovedBy& moved_by = taking.moved_by;
  const Hands both = moved_by.hands_apart ? Hands::kBothApart : Hands::kBoth;
  const Hands hands = moved_by.kind == Kind::kLeftHand    ? Hands::kLeft
                      : moved_by.kind == Kind::kRightHand ? Hands::kRight
                                                          : both;
  const MannequinManipulator::Locks locks{moved_by.lock_trunk, moved_by.lock_pelvis,  moved_by.on_seat,
                                          moved_by.may_step,   hangsInTheAir(taking), loadsInHands(taking)};
  return std::make_unique<MannequinManipulator>(taking.entity.figure, taking.entity.robot, hands, locks, taking.stands,
                                                bodyParts(taking));
}

bool lockNeedsTrunk(const Taking& taking) {
  return (taking.moved_by.lock_trunk || taking.moved_by.lock_pelvis) && taking.entity.kind != EntityKind::kMannequin;
}

Made refuseLock(const Taking& taking) {
  return makeError(takingRefused(taking.entity, "it has no trunk to lock", "a mannequin"));
}

/// The link of the robot that the frame names; -1: none.
int namedLink(const Taking& taking) {
  const bool named = isRobot(taking.entity) && taking.moved_by.kind == Kind::kFrame;
  return named ? taking.entity.robot->findLink(taking.moved_by.frame) : -1;
}

bool isByBaseKeepingTool(const Taking& taking) {
  return isRobot(taking.entity) && taking.moved_by.kind == Kind::kBase && taking.moved_by.keep_tcp;
}

bool isByTool(const Taking& taking) {
  return isRobot(taking.entity) && (taking.moved_by.kind == Kind::kTcp || namedLink(taking) >= 0);
}

const std::string& atSingularity(const Taking& taking) {
  const std::string& chosen = taking.moved_by.at_singularity;
  return chosen.empty() ? taking.configuration.robot.at_singularity : chosen;
}

Expected<RobotManipulator::Tool> toolOf(const Taking& taking) {
  const Entity& entity = taking.entity;
  const int named = namedLink(taking);
  int tip = named >= 0 ? named : entity.robot->findLink(entity.tip_link);
  if (tip < 0) tip = entity.robot->defaultTip();
  if (tip < 0) return makeError(takingRefused(entity, "the robot has no tip", "a robot with a moving link"));
  const Pose X_LT = named < 0 ? entity.X_LT : entity.mechanism ? middleOf(*entity.robot, tip) : Pose::identity();
  return RobotManipulator::Tool{tip, X_LT};
}

Expected<std::unique_ptr<kinematics::InverseModel>> inverseOf(const Taking& taking,
                                                              const RobotManipulator::Tool& tool) {
  kinematics::InverseOptions options;
  options.at_singularity = singularityChoice(atSingularity(taking));
  return kinematics::createInverse(*taking.entity.robot, tool.tip_link, tool.X_LT, options);
}

Made makeByBaseKeepingTool(const Taking& taking) {
  const auto tool = toolOf(taking);
  HAPTICELL_TRY(tool);
  auto inverse = inverseOf(taking, *tool);
  HAPTICELL_TRY(inverse);
  return std::make_unique<RobotBaseManipulator>(taking.entity.robot, *tool, std::move(*inverse), robotParts(taking),
                                                taking.stands);
}

Made makeByTool(const Taking& taking) {
  const auto tool = toolOf(taking);
  HAPTICELL_TRY(tool);
  auto inverse = inverseOf(taking, *tool);
  HAPTICELL_TRY(inverse);
  auto made = std::make_unique<RobotManipulator>(taking.entity.robot, *tool, std::move(*inverse), robotParts(taking));
  if (atSingularity(taking) == "stop") made->stopAtSingularities();
  return made;
}

bool isAny(const Taking&) {
  return true;
}

/// As a rigid whole, by its origin, its middle or a frame.
Made makeWhole(const Taking& taking) {
  const Entity& entity = taking.entity;
  const Kind kind = taking.moved_by.kind;
  Pose X_EM;
  if (kind == Kind::kFrame) {
    const PreparedScene::FoundFrame frame = taking.scene.findFrame(taking.moved_by.frame);
    if (frame.entity == nullptr) {
      return makeError(
          takingRefused(entity, "there is no frame '" + taking.moved_by.frame + "' to move it by", choicesOf(entity)));
    }
    X_EM = entity.X_WE.inverse() * frame.entity->X_WE * frame.X_EF;
  } else if (kind == Kind::kGeometricCenter && entity.mesh) {
    X_EM = Pose::translation(entity.mesh->bounds().center());
  } else if (kind == Kind::kTcp || kind > Kind::kWhole || (kind == Kind::kBase) != isRobot(entity)) {
    return makeError(takingRefused(entity, "it cannot be moved by that", choicesOf(entity)));
  }
  if (taking.moved_by.joints_move && entity.robot && !entity.robot->closure) {
    std::vector<JointedWhole::Part> parts;
    for (const Taking::Part& part : taking.parts) parts.push_back({part.link, part.X_LP});
    return std::make_unique<JointedWhole>(entity.robot, X_EM, std::move(parts));
  }
  std::vector<Pose> X_EP;
  for (const Taking::Part& part : taking.parts) {
    X_EP.push_back(PreparedScene::partPose(entity, Pose::identity(), taking.stands.joints, part.link) * part.X_LP);
  }
  return std::make_unique<SolidManipulator>(X_EM, std::move(X_EP));
}

constexpr ManipulatorKind kKinds[] = {
    {"a mannequin by its head", isByHead, makeHead},
    {"a mannequin by its hands", isByHands, makeHands},
    {"a lock without a trunk", lockNeedsTrunk, refuseLock},
    {"a robot by its base, the tool kept", isByBaseKeepingTool, makeByBaseKeepingTool},
    {"a robot or mechanism by its tool or a link", isByTool, makeByTool},
    {"anything as a rigid whole", isAny, makeWhole},
};

}  // namespace

std::span<const ManipulatorKind> manipulatorKinds() {
  return kKinds;
}

MovedBy resolved(const MovedBy& moved_by, const Entity& entity) {
  MovedBy result = moved_by;
  if (result.kind == Kind::kWhole) result.kind = Kind::kSelfOrigin;
  const bool whole = isRobot(entity) && mannequin::isFreeHand(*entity.robot);  // Its fingers are the glove's.
  if (result.kind == Kind::kDefault) {
    result.kind = !isRobot(entity) ? Kind::kSelfOrigin : whole ? Kind::kBase : Kind::kTcp;
  }
  return result;
}

Made makeManipulator(const Taking& taking, std::span<const ManipulatorKind> kinds) {
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.suits(taking); });
  if (kind != kinds.end()) return kind->make(taking);
  return makeError(takingRefused(taking.entity, "it cannot be moved by that", choicesOf(taking.entity)));
}

Error takingRefused(const Entity& entity, std::string found, std::string expected) {
  return {.file = {},
          .place = "entity '" + entity.name + "'",
          .found = std::move(found),
          .expected = std::move(expected),
          .fix = {}};
}

}  // namespace hapticell::manipulation
