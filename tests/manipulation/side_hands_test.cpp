// SPDX-License-Identifier: Apache-2.0
// Two styluses in one cell, and a hand that a glove poses.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/in_memory_link.h"
#include "manipulation/grasp_keeper.h"
#include "manipulation/second_stylus.h"
#include "mannequin/figure_model.h"
#include "mannequin/forward_kinematics.h"
#include "mannequin/free_hand.h"
#include "tests/manipulation/hand_link.h"
#include "tests/manipulation/test_cells.h"
#include "workcell/entity_source.h"

namespace hapticell::manipulation {
namespace {

constexpr workcell::EntityId kWorker = 7, kShelf = 8, kBox = 9;

workcell::Entity worker(const char* posture) {
  workcell::EntityLoader loader(".");
  Diagnostics diagnostics;
  workcell::Entity entity = *loader.load("mannequin:male:50", 1.0, diagnostics);
  entity.id = kWorker;
  entity.name = "worker";
  const auto model = mannequin::toModel(*entity.figure, *mannequin::libraryPosture(*entity.figure, posture));
  entity.X_WE = model.X_WE;
  entity.joints = model.joints;
  return entity;
}

Pose gripOf(const workcell::Entity& figure, const EntityConfiguration& at, mannequin::Side side) {
  const auto pose =
      mannequin::forwardKinematics(*figure.figure, mannequin::toPosture(*figure.figure, {at.X_WE, at.joints}));
  return mannequin::handPose(pose, side);
}

/// A stylus with all that belongs to it, in virtual time.
struct Station {
  Station() : loop(opened(), clock, haptic::configuredLoop(device, {})) {}
  haptic::Device& opened() {
    EXPECT_TRUE(device.open());
    device.place({});
    return device;
  }
  std::unique_ptr<haptic::InMemoryLink> makeLink() {
    auto made = std::make_unique<haptic::InMemoryLink>(loop, clock, haptic::describe(device));
    link = made.get();
    return made;
  }
  void hold(const dvec3& p_D, bool pressed = false) { device.hand().hold(Pose::translation(p_D), pressed ? 1 : 0); }
  double force() const { return glm::length(loop.current().force_D); }

  haptic::VirtualClock clock;
  haptic::SimulatedDevice device{{}};
  haptic::ForceLoop loop;
  haptic::InMemoryLink* link = nullptr;
};

/// Both styluses on one cell; a step of both engines every ten ticks.
struct TwoStations {
  explicit TwoStations(std::vector<workcell::Entity> entities) : cell(std::move(entities)) {
    first_link = a.makeLink();
    first = std::make_unique<ManipulationEngine>(*first_link, configuration);
    second = std::make_unique<SecondStylus>(b.makeLink(), configuration);
    const auto scene = PreparedScene::prepare(cell, {}, {0.001, 0.01}, nullptr);
    first->setScene(scene);
    second->engine().setScene(scene);
    for (ManipulationEngine* engine : {first.get(), &second->engine()}) {
      engine->apply(command::SetAxes{{AxesMode::kCell, {}}});
      engine->apply(command::SetForces{true});
    }
    a.hold({});
    b.hold({});
    run(2000);
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      a.link->step();
      b.link->step();
      if (i % 10 != 0) continue;
      first->step(a.clock.now());
      second->step(*first, a.clock.now());
    }
  }
  void takeBothHands() {
    first->apply(command::SetMovedBy{{.kind = MovedBy::Kind::kRightHand, .lock_trunk = true}});
    second->engine().apply(command::SetMovedBy{{.kind = MovedBy::Kind::kLeftHand, .lock_trunk = true}});
    first->apply(command::Grab{kWorker});
    run(20);
    second->engine().apply(command::Grab{kWorker});
    run(20);
    ASSERT_NE(first->held(), nullptr);
    ASSERT_NE(second->engine().held(), nullptr);
  }

  config::Configuration configuration;
  std::vector<workcell::Entity> cell;
  Station a, b;
  std::unique_ptr<haptic::InMemoryLink> first_link;
  std::unique_ptr<ManipulationEngine> first;
  std::unique_ptr<SecondStylus> second;
};

TEST(SecondStylus, EachDrawsAHandOfTheSameMannequin) {
  TwoStations two({worker("both_hands_forward")});
  two.takeBothHands();
  const workcell::Entity& figure = two.cell[0];
  const EntityConfiguration start = two.first->placement(kWorker);
  const Pose left = gripOf(figure, start, mannequin::Side::kLeft),
             right = gripOf(figure, start, mannequin::Side::kRight);
  for (int ms = 1; ms <= 300; ++ms) {
    two.a.hold({1e-4 * ms, 0.0, 0.0});
    two.b.hold({0.0, 0.0, 1e-4 * ms});
    two.run(2);
  }
  two.run(600);
  const EntityConfiguration end = two.first->placement(kWorker);
  const EntityConfiguration seen = two.second->engine().placement(kWorker);
  for (std::size_t i = 0; i < end.joints.size(); ++i) EXPECT_NEAR(end.joints[i], seen.joints[i], 1e-9) << i;
  const double scale = two.configuration.scale.medium;
  const dvec3 right_way = gripOf(figure, end, mannequin::Side::kRight).p - right.p;
  const dvec3 left_way = gripOf(figure, end, mannequin::Side::kLeft).p - left.p;
  EXPECT_LT(glm::length(right_way - scale * dvec3(0.03, 0.0, 0.0)), 0.002 * scale);
  EXPECT_LT(glm::length(left_way - scale * dvec3(0.0, 0.0, 0.03)), 0.002 * scale);

  SceneSnapshot picture;
  two.first->fillSnapshot(picture);
  two.second->addTo(picture);
  ASSERT_TRUE(picture.second);
  EXPECT_EQ(picture.second->held, kWorker);
  EXPECT_EQ(
      std::count_if(picture.entities.begin(), picture.entities.end(), [](const auto& e) { return e.id == kWorker; }),
      1);
}

TEST(SecondStylus, WhatOneHandTouchesIsFeltByThatHandAlone) {
  const workcell::Entity figure = worker("both_hands_forward");
  const Pose left = gripOf(figure, {figure.X_WE, figure.joints}, mannequin::Side::kLeft);
  workcell::Entity shelf = test::solid(kShelf, "shelf", geometry::makeBox({0.4, 0.2, 0.02}), {});
  shelf.X_WE.p = left.p + dvec3(0.0, 0.05, 0.08);
  TwoStations two({figure, shelf});
  two.takeBothHands();
  for (int ms = 1; ms <= 600; ++ms) {
    two.a.hold({0.0, 0.0, -5e-5 * ms});
    two.b.hold({0.0, 0.0, 1e-4 * ms});
    two.run(2);
  }
  two.run(600);
  EXPECT_GT(two.b.force(), 0.5);
  EXPECT_LT(two.a.force(), 0.2);
  SceneSnapshot picture;
  two.first->fillSnapshot(picture);
  two.second->addTo(picture);
  EXPECT_GT(picture.second->force_n, 0.5);
  EXPECT_TRUE(std::any_of(picture.pairs.begin(), picture.pairs.end(), [](const PairState& pair) {
    return pair.contact && pair.other == kShelf && pair.moved_part.substr(0, 2) == "l_";
  }));
}

/// What one holds stands in the other's way.
TEST(SecondStylus, TheyMeetEachOther) {
  std::vector<workcell::Entity> cell{test::solid(kShelf, "left", geometry::makeBox({0.1, 0.1, 0.1}), {}),
                                     test::solid(kBox, "right", geometry::makeBox({0.1, 0.4, 0.4}), {})};
  cell[0].X_WE.p = {-0.10, 0.0, 0.0};
  cell[1].X_WE.p = {0.10, 0.0, 0.0};
  TwoStations two(cell);
  two.first->apply(command::SetScale{{ScaleLevel::kNumber, 1.0}});
  two.second->engine().apply(command::SetScale{{ScaleLevel::kNumber, 1.0}});
  two.first->apply(command::Grab{kShelf});
  two.second->engine().apply(command::Grab{kBox});
  two.run(50);
  double nearest = 1.0;
  for (int ms = 1; ms <= 600; ++ms) {
    two.a.hold({1.2e-4 * ms, 0.0, 0.0});
    two.b.hold({-1.2e-4 * ms, 0.0, 0.0});
    two.run(2);
    const double gap = two.second->engine().placement(kBox).X_WE.p.x - two.first->placement(kShelf).X_WE.p.x - 0.1;
    nearest = std::min(nearest, gap);
  }
  two.run(1500);
  EXPECT_GT(nearest, 0.0) << "they never enter each other";
  EXPECT_LT(nearest, 0.005);
  EXPECT_GT(two.a.force(), 0.5);
  EXPECT_GT(two.b.force(), 0.5);
}

std::string noticesOf(ManipulationEngine& engine) {
  std::string all;
  for (const Result& one : engine.takeResults()) {
    if (const auto* notice = std::get_if<result::Notice>(&one)) all += notice->sentence + "\n";
  }
  return all;
}

/// Two boxes apart from each other, and a lid that goes with the left one.
std::vector<workcell::Entity> twoBoxesAndLid() {
  std::vector<workcell::Entity> cell{test::solid(kShelf, "left", geometry::makeBox({0.1, 0.1, 0.1}), {}),
                                     test::solid(kBox, "right", geometry::makeBox({0.1, 0.1, 0.1}), {}),
                                     test::solid(10, "lid", geometry::makeBox({0.1, 0.1, 0.01}), {})};
  cell[0].X_WE.p = {-0.3, 0.0, 0.0};
  cell[1].X_WE.p = {0.3, 0.0, 0.0};
  cell[2].X_WE.p = {-0.3, 0.0, 0.2};
  cell[2].attachment.to = "left";
  return cell;
}

TEST(SecondStylus, WhatTheOneHoldsTheOtherDoesNotTake) {
  TwoStations two(twoBoxesAndLid());
  two.first->apply(command::Grab{kShelf});
  two.run(20);
  two.second->engine().apply(command::Grab{kShelf});
  EXPECT_EQ(two.second->engine().held(), nullptr);
  EXPECT_EQ(noticesOf(two.second->engine()), "left is held by the other stylus\n");
  two.second->engine().apply(command::Grab{10});
  EXPECT_EQ(two.second->engine().held(), nullptr);
  EXPECT_EQ(noticesOf(two.second->engine()), "lid goes with left, which the other stylus holds\n");
  // The other way round, and what is free again.
  two.first->apply(command::Release{});
  two.run(20);
  two.second->engine().apply(command::Grab{10});
  two.run(20);
  ASSERT_NE(two.second->engine().held(), nullptr);
  two.first->apply(command::Grab{kShelf});
  EXPECT_EQ(two.first->held(), nullptr);
  EXPECT_EQ(noticesOf(*two.first), "lid, which the other stylus holds, goes with left\n");
  two.first->apply(command::Grab{kBox});
  EXPECT_NE(two.first->held(), nullptr) << "what is free may be taken";
}

/// Both asked between two steps: the second one lets go, and whatever is held is held once.
TEST(SecondStylus, TakenByBothAtOnceItIsTheFirstOnes) {
  TwoStations two(twoBoxesAndLid());
  two.first->apply(command::Grab{kShelf});
  two.second->engine().apply(command::Grab{kShelf});
  two.run(20);
  EXPECT_NE(two.first->held(), nullptr);
  EXPECT_EQ(two.second->engine().held(), nullptr);
  EXPECT_NE(noticesOf(two.second->engine()).find("left is held by the other stylus"), std::string::npos);
}

/// A mannequin's hand each, until the first one wants the whole figure.
TEST(SecondStylus, TheWholeFigureIsNotDrawnByAHandToo) {
  TwoStations two({worker("both_hands_forward")});
  two.takeBothHands();
  two.first->apply(command::SetMovedBy{{.kind = MovedBy::Kind::kWhole}});
  two.run(20);
  EXPECT_NE(two.first->held(), nullptr);
  EXPECT_EQ(two.second->engine().held(), nullptr);
}

TEST(SecondStylus, ATakeHasWhatBothMove) {
  TwoStations two(twoBoxesAndLid());
  two.first->apply(command::Grab{kShelf});
  two.second->engine().apply(command::Grab{kBox});
  two.run(20);
  trajectory::RecordingOptions options;
  options.mode = trajectory::RecordingMode::kEveryStep;
  two.first->apply(command::StartRecording{.options = options, .take = "both"});
  for (int ms = 1; ms <= 400; ++ms) {
    two.a.hold({0.0, 0.0, 1e-4 * ms});
    two.b.hold({0.0, 1e-4 * std::max(0, ms - 200), 0.0});
    two.run(2);
  }
  two.run(400);
  const Pose left = two.first->placement(kShelf).X_WE, right = two.second->engine().placement(kBox).X_WE;
  two.first->takeResults();
  two.first->apply(command::StopRecording{});
  std::vector<trajectory::Trajectory> take;
  for (Result& one : two.first->takeResults()) {
    if (auto* recorded = std::get_if<result::Recorded>(&one)) take = std::move(recorded->trajectories);
  }
  ASSERT_EQ(take.size(), 2u);
  EXPECT_EQ(take[0].entity, "left");
  EXPECT_EQ(take[1].entity, "right");
  EXPECT_EQ(take[1].take, "both");
  EXPECT_LT(glm::length(take[0].frames().back().X_WT.p - left.p), 1e-4);
  EXPECT_LT(glm::length(take[1].frames().back().X_WT.p - right.p), 1e-4);
  EXPECT_GT(right.p.y, 0.015);
  EXPECT_GT(take[1].frames().front().t, 0.3) << "one clock: the second one began later";
}

// What a glove poses.

std::vector<std::size_t> rightHandJoints() {
  return {mannequin::indexOf(mannequin::Dof::kRightFingersCurl), mannequin::indexOf(mannequin::Dof::kRightThumbFlexion),
          mannequin::indexOf(mannequin::Dof::kRightThumbAbduction)};
}

struct GlovedWorker {
  explicit GlovedWorker(std::vector<workcell::Entity> entities) : cell(std::move(entities)), engine(link, {}) {
    engine.setScene(PreparedScene::prepare(cell, {}, {0.001, 0.01}, nullptr));
    step(5);
  }
  void step(int times) {
    for (int i = 0; i < times; ++i) engine.step(now += 10'000'000);
  }
  void pose(double curl, double thumb) {
    command::PoseJoints wanted{kWorker, engine.placement(kWorker).joints, {}};
    const auto joints = rightHandJoints();
    wanted.joints[joints[0]] = curl;
    wanted.joints[joints[1]] = thumb;
    for (const std::size_t joint : joints) wanted.fingers.push_back({joint});
    engine.apply(wanted);
    step(20);
  }
  double curl() const { return engine.placement(kWorker).joints[rightHandJoints()[0]]; }

  std::vector<workcell::Entity> cell;
  test::HandLink link;
  ManipulationEngine engine;
  std::int64_t now = 0;
};

TEST(PoseJoints, TheGloveClosesTheHandInFreeAir) {
  GlovedWorker gloved({worker("both_hands_forward")});
  gloved.pose(1.0, 0.5);
  EXPECT_NEAR(gloved.curl(), 1.0, 1e-6);
  gloved.pose(0.2, 0.1);
  EXPECT_NEAR(gloved.curl(), 0.2, 1e-6);
}

TEST(PoseJoints, FingersStopAtWhatTheyGraspAndTellIt) {
  const workcell::Entity figure = worker("both_hands_forward");
  const Pose hand = gripOf(figure, {figure.X_WE, figure.joints}, mannequin::Side::kRight);
  workcell::Entity bar = test::solid(kBox, "bar", geometry::makeBox({0.03, 0.03, 0.03}), {});
  bar.X_WE.p = hand * figure.figure->p_HandGrip[1];
  workcell::Entity open = figure;
  for (const std::size_t joint : rightHandJoints()) open.joints[joint] = 0.0;
  GlovedWorker gloved({open, bar});
  gloved.pose(1.5, 0.8);
  EXPECT_LT(gloved.curl(), 1.4) << "the fingers went through the bar";
  SceneSnapshot picture;
  gloved.engine.fillSnapshot(picture);
  EXPECT_TRUE(std::any_of(picture.pairs.begin(), picture.pairs.end(), [](const PairState& pair) {
    return pair.contact && pair.other == kBox && pair.moved == kWorker;
  }));
  const auto shown =
      std::find_if(picture.entities.begin(), picture.entities.end(), [](const auto& e) { return e.id == kWorker; });
  ASSERT_NE(shown, picture.entities.end());
  EXPECT_TRUE(shown->in_contact);
  gloved.pose(0.0, 0.0);
  EXPECT_NEAR(gloved.curl(), 0.0, 1e-6);
}

TEST(PoseJoints, TheStylusHoldsTheFigureMeanwhile) {
  GlovedWorker gloved({worker("both_hands_forward")});
  gloved.engine.apply(command::SetMovedBy{{.kind = MovedBy::Kind::kLeftHand, .lock_trunk = true}});
  gloved.engine.apply(command::Grab{kWorker});
  gloved.pose(0.9, 0.3);
  EXPECT_NEAR(gloved.curl(), 0.9, 1e-6);
  const Pose before = gloved.engine.held()->movedFrame();
  gloved.link.state.X_DP.p = gloved.link.state.X_DS.p = {0.0, 0.0, 0.01};
  gloved.step(40);
  EXPECT_GT(gloved.engine.held()->movedFrame().p.z, before.p.z + 0.002);
  EXPECT_NEAR(gloved.curl(), 0.9, 1e-6) << "the hand that is not held keeps its fingers";
}

/// However the stylus holds the figure, the glove's fingers are checked: a rigid whole is taken anew with its joints.
TEST(PoseJoints, FingersStopAlsoWhileTheWholeFigureIsHeld) {
  const workcell::Entity figure = worker("both_hands_forward");
  const Pose hand = gripOf(figure, {figure.X_WE, figure.joints}, mannequin::Side::kRight);
  workcell::Entity bar = test::solid(kBox, "bar", geometry::makeBox({0.03, 0.03, 0.03}), {});
  bar.X_WE.p = hand * figure.figure->p_HandGrip[1];
  GlovedWorker gloved({figure, bar});
  gloved.engine.apply(command::SetMovedBy{{.kind = MovedBy::Kind::kWhole}});
  gloved.engine.apply(command::Grab{kWorker});
  gloved.step(3);
  gloved.pose(1.5, 0.8);
  EXPECT_GT(gloved.curl(), 0.5);
  EXPECT_LT(gloved.curl(), 1.4) << "the fingers went through the bar";
  // The hand goes on holding the whole: it moves, the fingers stay.
  const double curl = gloved.curl();
  gloved.link.state.X_DP.p = gloved.link.state.X_DS.p = {0.0, 0.0, 0.01};
  gloved.step(20);
  EXPECT_GT(gloved.engine.placement(kWorker).X_WE.p.z, figure.X_WE.p.z + 0.005);
  EXPECT_NEAR(gloved.curl(), curl, 0.3);
}

/// The bounds that the exact check goes by, for every way of holding that lets fingers move.
TEST(PoseJoints, NoFingertipMovesFartherThanItsBound) {
  const workcell::Entity figure = worker("both_hands_forward");
  const auto scene = PreparedScene::prepare({figure}, {}, {0.001, 0.01}, nullptr);
  for (const MovedBy& moved_by :
       {MovedBy{.kind = MovedBy::Kind::kWhole, .joints_move = true}, MovedBy{.kind = MovedBy::Kind::kRightHand},
        MovedBy{.kind = MovedBy::Kind::kLeftHand}, MovedBy{.kind = MovedBy::Kind::kHead}}) {
    const auto held = HeldEntity::take(scene, kWorker, {}, {moved_by, {}, {}}, {});
    ASSERT_TRUE(held);
    const Manipulator& manipulator = (*held)->manipulator();
    ASSERT_TRUE(manipulator.movesJoints());
    const EntityConfiguration from = (*held)->accepted();
    EntityConfiguration to = from;
    for (const std::size_t joint : rightHandJoints()) to.joints[joint] += 0.4;
    std::size_t parts = 0;
    for (const ScenePart& part : scene->parts()) parts += part.entity == kWorker;
    std::vector<PartSphere> spheres(parts, {dvec3(0.0, 0.0, -0.02), 0.02});
    std::vector<double> bounds(parts), ways(parts, 0.0);
    manipulator.pathBounds(from, to, spheres, bounds);
    std::vector<Pose> before(parts), after(parts);
    manipulator.partPoses(from, before);
    for (int i = 1; i <= 40; ++i) {
      manipulator.partPoses(manipulator.between(from, to, i / 40.0), after);
      for (std::size_t k = 0; k < parts; ++k)
        ways[k] += glm::length(after[k] * dvec3(0.0, 0.0, -0.04) - before[k] * dvec3(0.0, 0.0, -0.04));
      std::swap(before, after);
    }
    for (std::size_t k = 0; k < parts; ++k) EXPECT_LE(ways[k], bounds[k] + 1e-9) << k;
    EXPECT_GT(*std::max_element(ways.begin(), ways.end()), 0.02);
    EXPECT_GE(manipulator.turnBound(from, to), 0.4);
  }
}

TEST(PoseJoints, NonsenseIsNoPose) {
  GlovedWorker gloved({worker("both_hands_forward")});
  const double before = gloved.curl();
  gloved.engine.apply(command::PoseJoints{kWorker, {1.0, 2.0}, {{0}}});
  gloved.engine.apply(command::PoseJoints{99, {1.0, 2.0}, {{0}}});
  gloved.step(3);
  command::PoseJoints far{kWorker, gloved.engine.placement(kWorker).joints, {{100000}}};
  gloved.engine.apply(far);
  gloved.step(3);
  EXPECT_EQ(gloved.curl(), before);
}

/// A hand by itself: each joint of a finger goes on until it touches, the stylus carries the whole.
TEST(PoseJoints, AFreeHandClosesRoundWhatIsInItAndIsCarriedByTheStylus) {
  workcell::EntityLoader loader(".");
  Diagnostics diagnostics;
  workcell::Entity hand = *loader.load("hand:right", 1.0, diagnostics);
  hand.id = kWorker;
  const auto figure = worker("standing").figure;
  workcell::Entity bar = test::solid(kBox, "bar", geometry::makeBox(dvec3(0.041)), {});
  bar.X_WE.p = figure->p_HandGrip[1];
  GlovedWorker gloved({hand, bar});
  mannequin::GloveReadings fist;
  fist.fill(1.57);
  fist[3] = fist[10] = fist[14] = fist[18] = 0.0;
  command::PoseJoints wanted{kWorker, mannequin::freeHandFromGlove(fist, *hand.robot), {}};
  for (std::size_t i = 0; i < wanted.joints.size(); ++i) wanted.fingers.push_back({i});
  gloved.engine.apply(wanted);
  gloved.step(60);
  SceneSnapshot picture;
  gloved.engine.fillSnapshot(picture);
  GraspKeeper keeper;
  const GraspKeeper::Look look{picture.pairs, kWorker, mannequin::Side::kRight, {0.5, 1.0, 1.0, 1.0, 1.0}};
  EXPECT_EQ(keeper.look(look, [](workcell::EntityId) { return true; }).taken, kBox);
  const std::vector<double> closed = gloved.engine.placement(kWorker).joints;
  EXPECT_GT(closed[9], 0.2);
  EXPECT_LT(closed[9] + closed[10] + closed[11], 4.2) << "the middle finger went through the bar";

  // The stylus takes it as a whole.
  gloved.engine.apply(command::PoseJoints{});
  gloved.engine.apply(command::Grab{kWorker});
  ASSERT_NE(gloved.engine.held(), nullptr);
  gloved.link.state.X_DP.p = gloved.link.state.X_DS.p = {0.0, -0.02, 0.0};
  gloved.step(30);
  EXPECT_GT(glm::length(gloved.engine.placement(kWorker).X_WE.p), 0.003);
  EXPECT_EQ(gloved.engine.placement(kWorker).joints, closed);
}

/// A stylus, another one (or a 3-D mouse) and a glove at once: a part, the figure's left hand, its right fingers.
TEST(PoseJoints, TwoStylusesAndAGloveWorkTogether) {
  workcell::Entity part = test::solid(kBox, "part", geometry::makeBox(dvec3(0.05)), {});
  part.X_WE.p = {1.5, 0.0, 1.0};
  TwoStations two({worker("both_hands_forward"), part});
  two.first->apply(command::Grab{kBox});
  two.second->engine().apply(command::SetMovedBy{{.kind = MovedBy::Kind::kLeftHand, .lock_trunk = true}});
  two.second->engine().apply(command::Grab{kWorker});
  two.run(20);
  ASSERT_NE(two.first->held(), nullptr);
  ASSERT_NE(two.second->engine().held(), nullptr);
  trajectory::RecordingOptions options;
  options.mode = trajectory::RecordingMode::kEveryStep;
  two.first->apply(command::StartRecording{.options = options, .take = "all"});
  const workcell::Entity& figure = two.cell[0];
  const EntityConfiguration start = two.first->placement(kWorker);
  const std::size_t curl = rightHandJoints()[0];
  for (int ms = 1; ms <= 300; ++ms) {
    two.a.hold({1e-4 * ms, 0.0, 0.0});
    two.b.hold({0.0, 0.0, 1e-4 * ms});
    command::PoseJoints wanted{kWorker, start.joints, {{curl}}};
    wanted.joints[curl] = 0.003 * ms;
    two.first->apply(wanted);
    two.run(2);
  }
  two.run(600);
  for (const ManipulationEngine* engine : {two.first.get(), &two.second->engine()}) {
    const EntityConfiguration end = engine->placement(kWorker);
    EXPECT_NEAR(end.joints[curl], 0.9, 1e-6) << "the fingers as the glove has them";
    const dvec3 way = gripOf(figure, end, mannequin::Side::kLeft).p - gripOf(figure, start, mannequin::Side::kLeft).p;
    EXPECT_NEAR(way.z, two.configuration.scale.medium * 0.03, 0.002) << "the hand as the second stylus draws it";
    EXPECT_NEAR(engine->placement(kBox).X_WE.p.x, 1.5 + two.configuration.scale.medium * 0.03, 0.002);
  }
  two.first->apply(command::StopRecording{});
  std::size_t tracks = 0;
  for (const Result& one : two.first->takeResults()) {
    if (const auto* recorded = std::get_if<result::Recorded>(&one)) tracks = recorded->trajectories.size();
  }
  EXPECT_EQ(tracks, 2u) << "the part, and the figure with hand and fingers";
}

PairState touch(const char* link, workcell::EntityId other, bool hand_moves = true) {
  PairState pair;
  pair.moved = hand_moves ? kWorker : other;
  pair.other = hand_moves ? other : kWorker;
  (hand_moves ? pair.moved_part : pair.other_part) = link;
  pair.contact = true;
  return pair;
}

TEST(GraspKeeper, TakesWhatThumbAndFingerTouchAndLetsItGoWhenTheyOpen) {
  const auto any = [](workcell::EntityId) { return true; };
  const auto none = [](workcell::EntityId) { return false; };
  const GraspKeeper::Bend bent{0.4, 0.8, 0.8, 0.8, 0.8}, flat{};
  std::vector<PairState> pairs{touch("r_index2", kBox), touch("r_middle2", kBox)};
  GraspKeeper keeper;
  const auto look = [&](const GraspKeeper::Bend& bend, const auto& may) {
    return keeper.look({pairs, kWorker, mannequin::Side::kRight, bend}, may);
  };
  EXPECT_EQ(look(bent, any).taken, 0u) << "fingers alone";
  pairs.push_back(touch("l_thumb3", kBox));
  EXPECT_EQ(look(bent, any).taken, 0u) << "the other hand's thumb";
  pairs.push_back(touch("r_thumb3", kShelf));
  EXPECT_EQ(look(bent, any).taken, 0u) << "the thumb on something else";
  pairs.push_back(touch("r_thumb3", kBox, false));
  EXPECT_EQ(look(bent, none).taken, 0u) << "it may not be carried off";
  EXPECT_EQ(look(flat, any).taken, 0u) << "a flat hand rests on it";
  EXPECT_EQ(look(bent, any).taken, kBox);
  EXPECT_EQ(keeper.held(), kBox);
  pairs.clear();  // What hangs on the hand is not told as touching any more.
  EXPECT_EQ(look(bent, any).let_go, 0u);
  EXPECT_EQ(look({0.4, 0.7, 0.7, 0.7, 0.7}, any).let_go, 0u) << "a little is a tremble";
  EXPECT_EQ(look({0.4, 0.4, 0.4, 0.4, 0.4}, any).let_go, kBox);
  EXPECT_EQ(keeper.held(), 0u);
}

}  // namespace
}  // namespace hapticell::manipulation
