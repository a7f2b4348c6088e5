// SPDX-License-Identifier: Apache-2.0
// A hand that a glove poses, alone and beside styluses.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "manipulation/engine/grasp_keeper.h"
#include "mannequin/motion/free_hand.h"
#include "tests/manipulation/engine/two_stations.h"
#include "tests/manipulation/session/hand_link.h"

namespace hapticell::manipulation {
namespace {

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
  const Pose hand = gripOf(figure, {figure.X_WE, figure.joints()}, mannequin::Side::kRight);
  workcell::Entity bar = test::solid(kBox, "bar", geometry::makeBox({0.03, 0.03, 0.03}), {});
  bar.X_WE.p = hand * figure.figure()->p_HandGrip[1];
  workcell::Entity open = figure;
  for (const std::size_t joint : rightHandJoints()) open.editJointed().joints[joint] = 0.0;
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
  gloved.engine.apply(command::SetMovedBy{by::Hand{.side = mannequin::Side::kLeft, .locks = {.trunk = true}}});
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
  const Pose hand = gripOf(figure, {figure.X_WE, figure.joints()}, mannequin::Side::kRight);
  workcell::Entity bar = test::solid(kBox, "bar", geometry::makeBox({0.03, 0.03, 0.03}), {});
  bar.X_WE.p = hand * figure.figure()->p_HandGrip[1];
  GlovedWorker gloved({figure, bar});
  gloved.engine.apply(command::SetMovedBy{by::Whole{}});
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
  for (const MovedBy& moved_by : {MovedBy(by::Whole{}), MovedBy(by::Hand{mannequin::Side::kRight}),
                                  MovedBy(by::Hand{mannequin::Side::kLeft}), MovedBy(by::Head{})}) {
    const auto held = HeldEntity::take(scene, kWorker, {}, {moved_by, {}, {}, true}, {});
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
  const auto figure = worker("standing").figure();
  workcell::Entity bar = test::solid(kBox, "bar", geometry::makeBox(dvec3(0.041)), {});
  bar.X_WE.p = figure->p_HandGrip[1];
  GlovedWorker gloved({hand, bar});
  mannequin::GloveReadings fist;
  fist.fill(1.57);
  fist[3] = fist[10] = fist[14] = fist[18] = 0.0;
  command::PoseJoints wanted{kWorker, mannequin::freeHandFromGlove(fist, *hand.robot()), {}};
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

/// A free hand with a bar in it, and a glove that makes a fist.
struct FistRoundABar {
  FistRoundABar() {
    workcell::EntityLoader loader(".");
    Diagnostics diagnostics;
    hand = *loader.load("hand:right", 1.0, diagnostics);
    hand.id = kWorker;
    bar = test::solid(kBox, "bar", geometry::makeBox(dvec3(0.041)), {});
    bar.X_WE.p = worker("standing").figure()->p_HandGrip[1];
    bar.locked = true;
  }
  command::PoseJoints pose(double bend) const {
    mannequin::GloveReadings angles;
    angles.fill(bend);
    angles[3] = angles[10] = angles[14] = angles[18] = 0.0;
    command::PoseJoints wanted{kWorker, mannequin::freeHandFromGlove(angles, *hand.robot()), {}};
    for (std::size_t i = 0; i < wanted.joints.size(); ++i) wanted.fingers.push_back({i});
    return wanted;
  }
  /// The four fingers' bends in all: a fist in free air is 12 * 1.57.
  static double bent(const std::vector<double>& joints) {
    double sum = 0.0;
    for (const std::size_t first : {5u, 9u, 13u, 17u}) sum += joints[first] + joints[first + 1] + joints[first + 2];
    return sum;
  }
  /// Where the fingers come to when nothing else happens.
  double closed() const {
    GlovedWorker gloved({hand, bar});
    gloved.engine.apply(pose(1.57));
    gloved.step(60);
    return bent(gloved.engine.placement(kWorker).joints);
  }

  workcell::Entity hand, bar;
};

TEST(PoseJoints, FingersStopAlsoWhereNoStylusIsConnected) {
  const FistRoundABar cell;
  GlovedWorker gloved({cell.hand, cell.bar});
  gloved.link.connected = false;
  ManipulationEngine engine(gloved.link, {});
  engine.apply(cell.pose(1.57));  // Before the first scene is ready, too.
  engine.step(10'000'000);
  engine.setScene(gloved.engine.sharedScene());
  for (int i = 2; i < 60; ++i) engine.step(10'000'000 * i);
  const double bent = FistRoundABar::bent(engine.placement(kWorker).joints);
  EXPECT_GT(bent, 4.0) << "the fingers did not close";
  EXPECT_NEAR(bent, cell.closed(), 1e-3) << "as with a stylus";
  EXPECT_LT(bent, 0.9 * 12 * 1.57) << "the fingers went through the bar";
}

/// Whatever becomes of the document meanwhile: fingers never get farther than where the bar stops them.
TEST(PoseJoints, NoChangeOfTheDocumentLetsAFingerThrough) {
  const FistRoundABar cell;
  const double closed = cell.closed();
  for (const bool kept : {false, true}) {
    GlovedWorker gloved({cell.hand, cell.bar});
    gloved.engine.apply(cell.pose(1.57));
    for (int change = 0; change < 40; ++change) {
      gloved.step(change % 3);
      workcell::Entity hand = cell.hand, bar = cell.bar;
      if (kept) hand.setJoints(gloved.engine.placement(kWorker).joints);
      bar.locked = change % 2 == 0;
      bar.name = "bar " + std::to_string(change);
      const double before = FistRoundABar::bent(gloved.engine.placement(kWorker).joints);
      gloved.engine.setScene(PreparedScene::prepare({hand, bar}, {}, {0.001, 0.01}, gloved.engine.sharedScene().get()));
      EXPECT_EQ(FistRoundABar::bent(gloved.engine.placement(kWorker).joints), before) << "the hand leapt";
      gloved.step(1);
      const double now = FistRoundABar::bent(gloved.engine.placement(kWorker).joints);
      ASSERT_LT(now, closed + 0.05) << "after change " << change;
    }
    gloved.step(60);
    EXPECT_NEAR(FistRoundABar::bent(gloved.engine.placement(kWorker).joints), closed, 0.05);
    gloved.engine.apply(cell.pose(0.0));
    gloved.step(60);
    EXPECT_NEAR(FistRoundABar::bent(gloved.engine.placement(kWorker).joints), 0.0, 1e-3) << "it opens again";
  }
}

/// A stylus, another one (or a 3-D mouse) and a glove at once: a part, the figure's left hand, its right fingers.
TEST(PoseJoints, TwoStylusesAndAGloveWorkTogether) {
  workcell::Entity part = test::solid(kBox, "part", geometry::makeBox(dvec3(0.05)), {});
  part.X_WE.p = {1.5, 0.0, 1.0};
  TwoStations two({worker("both_hands_forward"), part});
  two.first->apply(command::Grab{kBox});
  two.second->holder().apply(command::SetMovedBy{by::Hand{.side = mannequin::Side::kLeft, .locks = {.trunk = true}}});
  two.second->holder().apply(command::Grab{kWorker});
  two.run(20);
  ASSERT_NE(two.first->held(), nullptr);
  ASSERT_NE(two.second->holder().held(), nullptr);
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
  for (const bool second : {false, true}) {
    const auto placed = [&](workcell::EntityId id) {
      return second ? two.second->holder().placement(id) : two.first->placement(id);
    };
    const EntityConfiguration end = placed(kWorker);
    EXPECT_NEAR(end.joints[curl], 0.9, 1e-6) << "the fingers as the glove has them";
    const dvec3 way = gripOf(figure, end, mannequin::Side::kLeft).p - gripOf(figure, start, mannequin::Side::kLeft).p;
    EXPECT_NEAR(way.z, two.configuration.scale.medium * 0.03, 0.002) << "the hand as the second stylus draws it";
    EXPECT_NEAR(placed(kBox).X_WE.p.x, 1.5 + two.configuration.scale.medium * 0.03, 0.002);
  }
  two.first->apply(command::StopRecording{});
  std::size_t tracks = 0;
  for (const Result& one : two.first->takeResults()) {
    if (const auto* recorded = std::get_if<result::Recorded>(&one)) tracks = recorded->trajectories.size();
  }
  EXPECT_EQ(tracks, 2u) << "the part, and the figure with hand and fingers";
}

}  // namespace
}  // namespace hapticell::manipulation
