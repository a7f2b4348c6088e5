// SPDX-License-Identifier: Apache-2.0
// Which class moves what, and a kind of entity of one's own: one class and one registration (docs/dev/architecture.md).
#include "manipulation/manipulators/manipulator_kinds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "manipulation/manipulators/mannequin_head.h"
#include "manipulation/manipulators/mannequin_manipulator.h"
#include "manipulation/manipulators/robot_base_manipulator.h"
#include "manipulation/manipulators/robot_manipulator.h"
#include "manipulation/manipulators/solid_manipulator.h"
#include "tests/manipulation/session/test_cells.h"
#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

/// Turns about its own z axis as the hand goes round it; nothing else gives way.
class TurntableManipulator final : public Manipulator {
 public:
  explicit TurntableManipulator(std::vector<Pose> X_EP) : X_EP_(std::move(X_EP)) {}
  Pose movedFrame(const EntityConfiguration& configuration) const override { return configuration.X_WE * X_EM_; }
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double) const override {
    const dvec3 p_EM = from.X_WE.inverse() * X_WM.p;
    const double turn = std::atan2(p_EM.y, p_EM.x);
    return {{from.X_WE.p, from.X_WE.q * glm::angleAxis(turn, dvec3(0, 0, 1))}, from.joints};
  }
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const override {
    return {interpolate(from.X_WE, to.X_WE, s), from.joints};
  }
  void partPoses(const EntityConfiguration& configuration, std::span<Pose> X_WP) const override {
    for (std::size_t k = 0; k < X_WP.size(); ++k) X_WP[k] = configuration.X_WE * X_EP_[k];
  }
  Pose partPose(const EntityConfiguration& configuration, std::size_t part) const override {
    return configuration.X_WE * X_EP_[part];
  }
  void pathBounds(const EntityConfiguration& from, const EntityConfiguration& to, std::span<const PartSphere> spheres,
                  std::span<double> bounds) const override {
    for (std::size_t k = 0; k < bounds.size(); ++k)
      bounds[k] = turnBound(from, to) * (glm::length(X_EP_[k] * spheres[k].p_PS) + spheres[k].radius);
  }
  double turnBound(const EntityConfiguration& from, const EntityConfiguration& to) const override {
    return glm::length(difference(to.X_WE, from.X_WE).angular);
  }
  std::vector<PartDifferential> differentiate(const EntityConfiguration& configuration) const override {
    // The hand's way round the axis turns the parts; its other ways move nothing.
    const dvec3 axis_W = configuration.X_WE.q * dvec3(0, 0, 1);
    const dvec3 round_W = configuration.X_WE.q * dvec3(0, 1, 0);
    std::vector<PartDifferential> parts(X_EP_.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      parts[k].p_WPo = (configuration.X_WE * X_EP_[k]).p;
      for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 turn_W = axis_W * (round_W[static_cast<int>(i)] / X_EM_.p.x);
        parts[k].velocity[i] = {glm::cross(turn_W, parts[k].p_WPo - configuration.X_WE.p), turn_W};
      }
    }
    return parts;
  }
  std::vector<MotionLimit> limits(const EntityConfiguration&, double, double) const override { return {}; }

 private:
  Pose X_EM_ = Pose::translation({0.3, 0.0, 0.0});  // Where the hand takes it.
  std::vector<Pose> X_EP_;
};

constexpr ManipulatorKind kTurntable{"a turntable",
                                     [](const Taking& taking) { return taking.entity.name == "turntable"; },
                                     [](const Taking& taking) -> Expected<std::unique_ptr<Manipulator>> {
                                       std::vector<Pose> X_EP;
                                       for (const Taking::Part& part : taking.parts) X_EP.push_back(part.X_LP);
                                       return std::make_unique<TurntableManipulator>(std::move(X_EP));
                                     }};

struct Taken {
  explicit Taken(workcell::Entity made) : entity(std::move(made)) {
    entity.id = 1;
    scene = PreparedScene::prepare({entity}, {}, {});
    stands = {entity.X_WE, entity.joints()};
    parts.resize(std::max<std::size_t>(1, entity.robot() ? entity.robot()->links.size() : 1));
    for (std::size_t i = 0; entity.robot() && i < parts.size(); ++i) parts[i].link = static_cast<int>(i);
  }
  Expected<std::unique_ptr<Manipulator>> heldBy(const MovedBy& moved_by,
                                                std::span<const ManipulatorKind> kinds = manipulatorKinds()) const {
    return makeManipulator({entity, stands, resolved(moved_by, entity), *scene, configuration, parts}, kinds);
  }
  workcell::Entity entity;
  std::shared_ptr<const PreparedScene> scene;
  EntityConfiguration stands;
  config::Configuration configuration;
  std::vector<Taking::Part> parts;
};

template <class Class>
bool is(const Expected<std::unique_ptr<Manipulator>>& made) {
  return made && dynamic_cast<const Class*>(made->get()) != nullptr;
}

workcell::Entity loaded(const char* source) {
  Diagnostics diagnostics;
  auto entity = workcell::EntityLoader({}).load(source, 0.0, diagnostics);
  EXPECT_TRUE(entity.has_value());
  if (entity && entity->robot() && entity->joints().empty())
    entity->setJoints(kinematics::restPositions(*entity->robot()));
  return entity ? *entity : workcell::Entity();
}

TEST(ManipulatorKinds, ASolidIsMovedAsAWholeAndSaysWhatElseGoes) {
  const Taken solid(test::solid(1, "box", geometry::makeBox(dvec3(0.1))));
  EXPECT_TRUE(is<SolidManipulator>(solid.heldBy(by::Default{})));
  EXPECT_TRUE(is<SolidManipulator>(solid.heldBy(by::Center{})));
  const auto refused = solid.heldBy(by::Tool{});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("geometric_center"), std::string::npos) << refused.error().message();
  EXPECT_FALSE(solid.heldBy(by::Frame{"nowhere"}));
  EXPECT_FALSE(solid.heldBy(by::Default{.locks = {.trunk = true}})) << "it has no trunk";
}

TEST(ManipulatorKinds, ARobotIsMovedByItsToolOrItsBase) {
  const Taken robot(loaded("library:hc6"));
  EXPECT_TRUE(is<RobotManipulator>(robot.heldBy(by::Default{})));
  EXPECT_TRUE(is<RobotManipulator>(robot.heldBy(by::Frame{robot.entity.robot()->links[3].name})));
  EXPECT_TRUE(is<SolidManipulator>(robot.heldBy(by::Base{})));
  EXPECT_TRUE(is<RobotBaseManipulator>(robot.heldBy(by::Base{.keeps_tool = true})));
  EXPECT_FALSE(robot.heldBy(by::Head{}));
}

TEST(ManipulatorKinds, OfOnesOwnIsOneClassAndOneRegistration) {
  workcell::Entity table = test::solid(1, "turntable", geometry::makeBox({0.6, 0.6, 0.02}));
  table.X_WE.p = {1.0, 0.0, 0.5};
  const Taken taken(table);
  std::vector<ManipulatorKind> kinds{kTurntable};
  kinds.insert(kinds.end(), manipulatorKinds().begin(), manipulatorKinds().end());
  const auto made = taken.heldBy({}, kinds);
  ASSERT_TRUE(is<TurntableManipulator>(made));
  EXPECT_TRUE(is<SolidManipulator>(taken.heldBy(by::Default{}))) << "without the registration it is a solid";
  // A quarter round, whatever else the hand wants.
  const EntityConfiguration turned = (*made)->propose(taken.stands, {dvec3(1.0, 0.4, 0.9), dquat(1, 0, 0, 0)}, 1.0);
  EXPECT_LT(glm::length(turned.X_WE.p - table.X_WE.p), 1e-12);
  EXPECT_NEAR(difference(turned.X_WE, table.X_WE).angular.z, glm::half_pi<double>(), 1e-9);
  // Its differential against central differences of what it proposes.
  const auto differential = (*made)->differentiate(taken.stands);
  const Pose X_WM = (*made)->movedFrame(taken.stands);
  const dvec3 p_PQ(0.2, -0.1, 0.01);
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr double kStep = 1e-6;
    dvec3 step(0.0);
    step[static_cast<int>(i)] = kStep;
    const auto at = [&](const dvec3& by) {
      return (*made)->propose(taken.stands, {X_WM.p + by, X_WM.q}, 1.0).X_WE * p_PQ;
    };
    const dvec3 expected = (at(step) - at(-step)) / (2.0 * kStep);
    const dvec3 p_WQ = table.X_WE * p_PQ;
    EXPECT_LT(glm::length(pointVelocity(differential[0], p_WQ, i) - expected), 1e-6) << i;
  }
}

}  // namespace
}  // namespace hapticell::manipulation
