// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/manipulator_kinds.h"

#include <algorithm>
#include <utility>

#include "geometry/system/overloaded.h"
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
using Made = Expected<std::unique_ptr<Manipulator>>;

bool isFigure(const Entity& entity) {
  return entity.figure() != nullptr && entity.robot() != nullptr;
}

Text choicesOf(const Entity& entity) {
  if (entity.kind() == EntityKind::kMannequin)
    return Text("whole, left_hand, right_hand, both_hands, head or self_origin");
  return entity.robot() ? Text("tcp, tcp_with_axes, base, base_keeping_tcp or frame:NAME of one of its links")
                        : Text("self_origin, geometric_center or frame:NAME of an entity");
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
  return isFigure(taking.entity) && std::holds_alternative<by::Head>(taking.moved_by);
}

Made makeHead(const Taking& taking) {
  const bool trunk_locked = std::get<by::Head>(taking.moved_by).locks.trunk;
  return std::make_unique<MannequinHead>(taking.entity.figure(), taking.entity.robot(), trunk_locked,
                                         bodyParts(taking));
}

bool isByHands(const Taking& taking) {
  return isFigure(taking.entity) &&
         (std::holds_alternative<by::Hand>(taking.moved_by) || std::holds_alternative<by::BothHands>(taking.moved_by));
}

Made makeHandsWith(const Taking& taking, MannequinManipulator::Hands hands, const BodyLocks& body, bool may_step) {
  const MannequinManipulator::Locks locks{body.trunk, body.pelvis,           body.seat,
                                          may_step,   hangsInTheAir(taking), loadsInHands(taking)};
  return std::make_unique<MannequinManipulator>(taking.entity.figure(), taking.entity.robot(), hands, locks,
                                                taking.stands, bodyParts(taking));
}

Made makeHands(const Taking& taking) {
  using Hands = MannequinManipulator::Hands;
  if (const auto* hand = std::get_if<by::Hand>(&taking.moved_by)) {
    const Hands one = hand->side == mannequin::Side::kLeft ? Hands::kLeft : Hands::kRight;
    return makeHandsWith(taking, one, hand->locks, hand->may_step);
  }
  const auto& both = std::get<by::BothHands>(taking.moved_by);
  return makeHandsWith(taking, both.apart ? Hands::kBothApart : Hands::kBoth, both.locks, both.may_step);
}

bool lockNeedsTrunk(const Taking& taking) {
  const BodyLocks* locks = locksOf(taking.moved_by);
  return locks != nullptr && (locks->trunk || locks->pelvis) && taking.entity.kind() != EntityKind::kMannequin;
}

Made refuseLock(const Taking& taking) {
  return makeError(takingRefused(taking.entity, Text("it has no trunk to lock"), Text("a mannequin")));
}

/// The link of the robot that the frame names; -1: none.
int namedLink(const Taking& taking) {
  const auto* frame = std::get_if<by::Frame>(&taking.moved_by);
  return frame != nullptr && isMachine(taking.entity) ? taking.entity.robot()->findLink(frame->name) : -1;
}

bool isByBaseKeepingTool(const Taking& taking) {
  const auto* base = std::get_if<by::Base>(&taking.moved_by);
  return base != nullptr && base->keeps_tool && isMachine(taking.entity);
}

bool isByTool(const Taking& taking) {
  return isMachine(taking.entity) && (std::holds_alternative<by::Tool>(taking.moved_by) || namedLink(taking) >= 0);
}

/// Of a way that has a tool, or keeps one.
std::string atSingularity(const Taking& taking) {
  const std::string chosen = std::visit(
      [](const auto& way) {
        if constexpr (requires { way.at_singularity; }) {
          return way.at_singularity;
        } else {
          return std::string();
        }
      },
      taking.moved_by);
  return chosen.empty() ? taking.configuration.robot.at_singularity : chosen;
}

Expected<RobotManipulator::Tool> heldTool(const Taking& taking) {
  const Entity& entity = taking.entity;
  const int named = namedLink(taking);
  int tip = named >= 0 ? named : entity.robot()->findLink(entity.jointed().tip_link);
  if (tip < 0) tip = entity.robot()->defaultTip();
  if (tip < 0)
    return makeError(takingRefused(entity, Text("the robot has no tip"), Text("a robot with a moving link")));
  if (named < 0) return RobotManipulator::Tool{tip, entity.jointed().X_LT};
  return RobotManipulator::Tool{tip, entity.mechanism() ? middleOf(*entity.robot(), tip) : Pose::identity()};
}

Expected<std::unique_ptr<kinematics::InverseModel>> inverseOf(const Taking& taking,
                                                              const RobotManipulator::Tool& tool) {
  kinematics::InverseOptions options;
  options.at_singularity = singularityChoice(atSingularity(taking));
  return kinematics::createInverse(*taking.entity.robot(), tool.tip_link, tool.X_LT, options);
}

Made makeByBaseKeepingTool(const Taking& taking) {
  const auto tool = heldTool(taking);
  HAPTICELL_TRY(tool);
  auto inverse = inverseOf(taking, *tool);
  HAPTICELL_TRY(inverse);
  return std::make_unique<RobotBaseManipulator>(taking.entity.robot(), *tool, std::move(*inverse), robotParts(taking),
                                                taking.stands);
}

Made makeByTool(const Taking& taking) {
  const auto tool = heldTool(taking);
  HAPTICELL_TRY(tool);
  auto inverse = inverseOf(taking, *tool);
  HAPTICELL_TRY(inverse);
  auto made = std::make_unique<RobotManipulator>(taking.entity.robot(), *tool, std::move(*inverse), robotParts(taking));
  if (atSingularity(taking) == "stop") made->stopAtSingularities();
  return made;
}

bool isAny(const Taking&) {
  return true;
}

/// Where the moved frame is in what moves as a rigid whole; an error where that is not moved by it.
Expected<Pose> frameOfWhole(const Taking& taking) {
  const Entity& entity = taking.entity;
  const auto refused = [&](const auto&) -> Expected<Pose> {
    return makeError(takingRefused(entity, Text("the entity cannot be moved in this way"), choicesOf(entity)));
  };
  const auto by_origin = [&](const auto& way) -> Expected<Pose> {
    return isMachine(entity) ? refused(way) : Pose::identity();
  };
  return std::visit(Overloaded{
                        [&](const by::Default& way) { return by_origin(way); },
                        [&](const by::Tool& way) { return refused(way); },
                        [&](const by::Base& way) { return isMachine(entity) ? Pose::identity() : refused(way); },
                        [&](const by::Origin& way) { return by_origin(way); },
                        [&](const by::Center& way) {
                          return entity.mesh() ? Pose::translation(entity.mesh()->bounds().center()) : by_origin(way);
                        },
                        [&](const by::Frame& way) -> Expected<Pose> {
                          const PreparedScene::FoundFrame frame = taking.scene.findFrame(way.name);
                          if (frame.entity != nullptr) return entity.X_WE.inverse() * frame.entity->X_WE * frame.X_EF;
                          return makeError(takingRefused(entity, Text("no frame of the entity is named '%1'", way.name),
                                                         choicesOf(entity)));
                        },
                        [&](const by::Whole& way) { return by_origin(way); },
                        [&](const by::Hand& way) { return refused(way); },
                        [&](const by::BothHands& way) { return refused(way); },
                        [&](const by::Head& way) { return refused(way); },
                    },
                    taking.moved_by);
}

/// As a rigid whole, by its origin, its middle or a frame.
Made makeWhole(const Taking& taking) {
  const Entity& entity = taking.entity;
  const Expected<Pose> X_EM = frameOfWhole(taking);
  HAPTICELL_TRY(X_EM);
  if (taking.joints_move && entity.robot() && !entity.robot()->closure) {
    std::vector<JointedWhole::Part> parts;
    for (const Taking::Part& part : taking.parts) parts.push_back({part.link, part.X_LP});
    return std::make_unique<JointedWhole>(entity.robot(), *X_EM, std::move(parts));
  }
  std::vector<Pose> X_EP;
  for (const Taking::Part& part : taking.parts) {
    X_EP.push_back(PreparedScene::partPose(entity, Pose::identity(), taking.stands.joints, part.link) * part.X_LP);
  }
  return std::make_unique<SolidManipulator>(*X_EM, std::move(X_EP));
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
  if (std::holds_alternative<by::Whole>(moved_by)) return by::Origin{};
  const auto* usual = std::get_if<by::Default>(&moved_by);
  if (usual == nullptr) return moved_by;
  if ((usual->locks.trunk || usual->locks.pelvis) && entity.kind() != EntityKind::kMannequin) return moved_by;
  if (!isMachine(entity)) return by::Origin{};
  if (mannequin::isFreeHand(*entity.robot())) return by::Base{};  // Its fingers are the glove's.
  return usual->tool;
}

Made makeManipulator(const Taking& taking, std::span<const ManipulatorKind> kinds) {
  const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.suits(taking); });
  if (kind != kinds.end()) return kind->make(taking);
  return makeError(
      takingRefused(taking.entity, Text("the entity cannot be moved in this way"), choicesOf(taking.entity)));
}

Error takingRefused(const Entity& entity, Text found, Text expected) {
  return {.place = Text("entity '%1'", entity.name), .found = std::move(found), .expected = std::move(expected)};
}

}  // namespace hapticell::manipulation
