// SPDX-License-Identifier: Apache-2.0
// What an engine watches, moves and shows, each part by itself.
#include <gtest/gtest.h>

#include <cmath>

#include "manipulation/engine/contact_watch.h"
#include "manipulation/engine/felt_guides.h"
#include "manipulation/engine/posed_joints.h"
#include "manipulation/engine/scene_snapshot.h"
#include "manipulation/engine/scripted_entities.h"
#include "manipulation/engine/set_scheduler.h"
#include "manipulation/engine/snapshot_maker.h"
#include "manipulation/engine/stylus_holder.h"
#include "manipulation/engine/take_recording.h"
#include "tests/kinematics/model/test_robots.h"
#include "tests/manipulation/session/hand_link.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

constexpr workcell::EntityId kTable = 1, kBox = 2;

/// The box over the table, or another cell; time goes on as the test says.
struct Cell {
  explicit Cell(std::vector<workcell::Entity> entities = test::boxOverTable(0.02)) {
    state.setScene(PreparedScene::prepare(std::move(entities), {}, {0.001, 0.010}), {});
    state.tick(0);
  }
  void wait(double seconds) {
    now += std::llround(1e9 * seconds);
    state.tick(now);
  }
  std::unique_ptr<HeldEntity> taken(const HoldOptions& options = {}) const {
    auto held = HeldEntity::take(state.scene(), kBox, {}, options, state.configuration());
    EXPECT_TRUE(held);
    return std::move(*held);
  }
  CellState state{{}};
  std::int64_t now = 0;
};

TEST(ContactWatch, BeginsNearerThanItEnds) {
  const Cell cell;
  const auto held = cell.taken();
  MotionMapping mapping;
  mapping.anchor({}, held->movedFrame());
  const BuiltConstraints built = held->constraints(mapping, {}, {});
  ContactWatch watch;
  std::int64_t now = 0;
  /// The hand at this height over its contact with the table's safety zone.
  const auto isTouchingAt = [&](double height) {
    now += 1'000'000;
    watch.look(*held, built, Pose::translation({0.0, 0.0, height - 0.019}), now, now + 5);
    EXPECT_EQ(watch.isInContact(0), !watch.contacts().empty());
    return watch.isInContact(0);
  };
  EXPECT_FALSE(isTouchingAt(0.01));
  EXPECT_FALSE(isTouchingAt(6e-5));
  EXPECT_EQ(watch.feltAt(), 0) << "nothing was felt yet";
  EXPECT_TRUE(isTouchingAt(4e-5));
  const std::int64_t first = watch.feltAt();
  EXPECT_EQ(first, now + 5);
  EXPECT_TRUE(isTouchingAt(1.9e-4)) << "a hand that trembles goes on touching";
  EXPECT_EQ(watch.feltAt(), first) << "it is the same contact";
  EXPECT_FALSE(isTouchingAt(2.1e-4));
  EXPECT_FALSE(isTouchingAt(6e-5));
  EXPECT_TRUE(isTouchingAt(-1e-3));
  EXPECT_GT(watch.feltAt(), first);
  watch.clear();
  EXPECT_TRUE(watch.contacts().empty());
}

TEST(ContactWatch, MeasuresWhatPasses) {
  const Cell cell(test::boxOverTable(-0.001));
  HoldOptions options;
  options.on_contact = workcell::OnContact::kPass;
  const auto held = cell.taken(options);
  ContactWatch watch;
  watch.look(*held, {}, {}, 0, 3);
  ASSERT_EQ(watch.contacts().size(), 1U) << "no row of a set tells of it";
  EXPECT_EQ(watch.feltAt(), 3);
}

workcell::Guide planeFor(const char* entity, double friction) {
  workcell::Guide guide;
  guide.kind = workcell::GuideKind::kPlane;
  guide.entity = entity;
  guide.friction = friction;
  guide.X_WG = Pose::translation({0.0, 0.0, 0.05});
  return guide;
}

TEST(FeltGuides, AreThoseOfTheHeldEntityThatAreOn) {
  const Cell cell;
  const auto held = cell.taken();
  FeltGuides guides(cell.state);
  EXPECT_EQ(guides.friction(*held), 0.0);
  workcell::Guide off = planeFor("box", 2.5);
  off.enabled = false;
  guides.set({planeFor("box", 0.5), planeFor("box", 1.5), planeFor("table", 3.0), off});
  EXPECT_EQ(guides.friction(*held), 1.5);
  MotionMapping mapping;
  mapping.anchor({}, held->movedFrame());
  EXPECT_EQ(guides.turnWithin(0.1, *held, mapping), 0.0) << "a plane turns nothing";
  const Pose X_DP = guides.onGuides(Pose::translation({0.02, 0.01, -0.013}), *held, mapping);
  EXPECT_NEAR(glm::length(mapping.toCell(X_DP).p - dvec3(0.02, 0.01, 0.05)), 0.0, 1e-9) << "the nearest on the plane";
  BuiltConstraints built;
  guides.addTo(built, *held, mapping, {});
  ASSERT_EQ(built.set.count, 2U) << "a row for each that is on";
  EXPECT_EQ(built.origins.size(), 2U);
  EXPECT_NE(built.set.constraints[0].group, built.set.constraints[1].group);
}

TEST(FeltGuides, RoomIsMadeAtTheFarEnd) {
  BuiltConstraints built;
  built.set.zone_radius = 0.06;
  for (std::size_t i = 0; i < haptic::kMaxConstraints; ++i) {
    haptic::Constraint row;
    row.group = static_cast<std::uint32_t>(i / 2);  // Two rows each.
    row.gap = 0.001 * static_cast<double>((i / 2 * 7) % 32);
    built.set.constraints[built.set.count++] = row;
    built.origins.push_back({static_cast<int>(i), -1});
  }
  makeRoom(built, 3);
  EXPECT_EQ(built.set.count, haptic::kMaxConstraints - 4) << "two groups went";
  ASSERT_EQ(built.origins.size(), built.set.count);
  EXPECT_NEAR(built.set.zone_radius, 0.030, 1e-12) << "good to the nearest of those left out";
  for (std::size_t i = 0; i < built.set.count; ++i) {
    EXPECT_LT(built.set.constraints[i].gap, 0.030);
    EXPECT_EQ(static_cast<std::uint32_t>(built.origins[i].pair / 2), built.set.constraints[i].group);
  }
  const std::size_t before = built.set.count;
  makeRoom(built, 2);
  EXPECT_EQ(built.set.count, before) << "there is room";
}

std::vector<workcell::Entity> boxOnBelt(workcell::MotionRepeat repeat) {
  std::vector<workcell::Entity> entities = test::boxOverTable(0.02);
  entities[1].motion = workcell::ScriptedMotion{{{0.0, dvec3(0.0)}, {1.0, dvec3(0.2, 0.0, 0.0)}}, repeat};
  return entities;
}

TEST(ScriptedEntities, GoByTheCellsTime) {
  Cell cell(boxOnBelt(workcell::MotionRepeat::kOnce));
  ScriptedEntities scripted(cell.state);
  int leaps = 0;
  const auto step = [&](double seconds) {
    cell.wait(seconds);
    return scripted.move({}, [&] { ++leaps; });
  };
  const auto x = [&] { return cell.state.placement(kBox).X_WE.p.x; };
  EXPECT_TRUE(step(0.01)) << "it starts";
  EXPECT_EQ(x(), 0.0);
  EXPECT_FALSE(step(0.05)) << "as was foreseen";
  EXPECT_NEAR(x(), 0.01, 1e-12);
  EXPECT_NEAR(scripted.fastest(), 0.2, 1e-12);
  step(3.0);
  EXPECT_NEAR(x(), 0.03, 1e-12) << "a loop that stood still does not leap";
  bool told = false;
  for (int i = 0; i < 20; ++i) told = step(0.05) || told;
  EXPECT_TRUE(told) << "it has stopped";
  EXPECT_NEAR(x(), 0.2, 1e-12);
  EXPECT_EQ(scripted.fastest(), 0.0);
  EXPECT_EQ(scripted.onTheirWay().size(), 1U);
  EXPECT_EQ(leaps, 0);
}

TEST(ScriptedEntities, BeginAgainWithALeapAndStayInTheHand) {
  Cell cell(boxOnBelt(workcell::MotionRepeat::kLoop));
  ScriptedEntities scripted(cell.state);
  int leaps = 0;
  for (int i = 0; i < 240; ++i) {
    cell.wait(0.005);
    scripted.move({}, [&] { ++leaps; });
  }
  EXPECT_EQ(leaps, 1);
  EXPECT_LT(cell.state.placement(kBox).X_WE.p.x, 0.05);
  ResultLog log;
  StylusGrip grip(cell.state, log);
  ASSERT_TRUE(grip.take(kBox));
  StylusGrip* const grips[] = {&grip};
  const dvec3 held = cell.state.placement(kBox).X_WE.p;
  cell.wait(0.05);
  scripted.move(grips, [] {});
  EXPECT_EQ(cell.state.placement(kBox).X_WE.p, held);
}

TEST(ScriptedEntities, GiveRowsTheirVelocity) {
  std::vector<workcell::Entity> entities = test::boxOverTable(0.02);
  entities[0].motion = workcell::ScriptedMotion{{{0.0, dvec3(0.0)}, {1.0, dvec3(0.1, 0.0, 0.0)}}, {}};
  Cell cell(std::move(entities));
  ScriptedEntities scripted(cell.state);
  scripted.move({}, [] {});
  const auto held = cell.taken();
  MotionMapping mapping;
  mapping.setScale(2.0);
  BuiltConstraints built;
  built.set.count = 2;
  built.origins = {{0, -1}, {-1, 0}};
  scripted.addVelocities(built, *held, mapping, {0.0, 0.01, 0.0});
  EXPECT_NEAR(glm::length(built.set.constraints[0].velocity_D - dvec3(0.05, -0.01, 0.0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(built.set.constraints[1].velocity_D - dvec3(0.0, -0.01, 0.0)), 0.0, 1e-12)
      << "a limit of its own only drifts";
}

TEST(TakeRecording, KeepsWhatMovesUntilItIsStopped) {
  Cell cell(boxOnBelt(workcell::MotionRepeat::kOnce));
  ResultLog log;
  StylusGrip grip(cell.state, log);
  ScriptedEntities scripted(cell.state);
  TakeRecording recording(cell.state, log);
  const std::vector<std::size_t> contacts;
  recording.stop();
  EXPECT_TRUE(log.take().empty()) << "there was none";
  command::StartRecording wanted;
  wanted.options.interval_s = 0.01;
  wanted.take = "first";
  wanted.mark_by_button = true;
  recording.start(wanted);
  EXPECT_TRUE(recording.isOn());
  EXPECT_TRUE(recording.isMarkedByButton());
  for (int i = 0; i < 20; ++i) {
    cell.wait(0.02);
    scripted.move({}, [] {});
    if (i == 10) recording.mark();
    recording.step({grip, dvec3(0.0), contacts}, nullptr, scripted);
  }
  const SceneSnapshot::Recording shown = recording.shown();
  EXPECT_TRUE(shown.on);
  EXPECT_GT(shown.frames, 10U);
  recording.stop();
  EXPECT_FALSE(recording.isOn());
  EXPECT_FALSE(recording.shown().on);
  const std::vector<Result> told = log.take();
  ASSERT_FALSE(told.empty());
  const auto* recorded = std::get_if<result::Recorded>(&told.back());
  ASSERT_NE(recorded, nullptr);
  ASSERT_EQ(recorded->trajectories.size(), 1U);
  EXPECT_EQ(recorded->trajectories[0].entity, "box");
  EXPECT_GE(recorded->trajectories[0].size(), shown.frames);
}

TEST(SnapshotMaker, ShowsWhatIsHeldAndWhatIsNear) {
  Cell cell;
  ResultLog log;
  StylusGrip grip(cell.state, log);
  test::HandLink link;
  link.state.forces_on = true;
  link.state.force_D = {0.0, 3.0, 4.0};
  StylusInput input(link, {});
  input.watchLink();
  input.takeNewest();
  SnapshotMaker maker(cell.state);
  ContactWatch contacts;
  SceneSnapshot empty;
  maker.addEntities(grip, contacts, empty);
  EXPECT_TRUE(empty.entities.empty()) << "all is as the document says";
  ASSERT_TRUE(grip.take(kBox));
  SceneSnapshot snapshot;
  maker.addEntities(grip, contacts, snapshot);
  SnapshotMaker::addStylus(input, {}, snapshot);
  maker.describe(input, grip, snapshot);
  EXPECT_EQ(snapshot.stylus.held, kBox);
  ASSERT_EQ(snapshot.pairs.size(), 1U);
  EXPECT_EQ(snapshot.pairs[0].other, kTable);
  EXPECT_NEAR(snapshot.pairs[0].distance, 0.02, 1e-9);
  EXPECT_FALSE(snapshot.pairs[0].near_miss) << "that begins at 10 mm";
  EXPECT_NEAR(snapshot.free_gap_m, 0.02, 1e-9);
  ASSERT_EQ(snapshot.entities.size(), 1U);
  EXPECT_FALSE(snapshot.entities[0].in_contact);
  EXPECT_TRUE(snapshot.stylus.connected);
  EXPECT_TRUE(snapshot.stylus.forces_on);
  EXPECT_NEAR(snapshot.stylus.force_n, 5.0, 1e-12);
  EXPECT_NEAR(snapshot.stylus.device_edge_m, 0.08, 1e-12);
  ASSERT_EQ(snapshot.status.size(), 1U);
  EXPECT_EQ(english(snapshot.status[0]).substr(0, 7), "box is ") << english(snapshot.status[0]);
  EXPECT_NE(english(snapshot.status[0]).find("from table"), std::string::npos);
}

TEST(SetScheduler, SendsASetWhenOneIsWanted) {
  Cell cell;
  test::HandLink link;
  HandMapping hand;
  const FeltGuides guides(cell.state);
  const FeltPlan plan;
  const ScriptedEntities scripted(cell.state);
  SetScheduler sets(0.06);
  EXPECT_EQ(sets.sent(), 0U);
  const auto update = [&](HeldEntity* held, std::int64_t now_ns) {
    sets.update({held, hand, link.state, guides, plan, scripted, now_ns}, link);
    return sets.sent();
  };
  EXPECT_EQ(update(nullptr, 1'000'000), 1U) << "the first step";
  EXPECT_EQ(link.set.count, 0U);
  EXPECT_EQ(link.set.stamp_ns, 1'000'000);
  EXPECT_EQ(update(nullptr, 2'000'000), 1U) << "nothing is new";
  sets.wantForOthers(3'000'000);
  EXPECT_EQ(update(nullptr, 3'000'000), 1U) << "too soon after the last one";
  const auto held = cell.taken();
  hand.anchor({}, held->movedFrame());
  sets.want();
  EXPECT_EQ(update(held.get(), 4'000'000), 2U);
  EXPECT_GT(link.set.count, 0U);
  EXPECT_EQ(link.set.sequence, 2U);
  EXPECT_EQ(sets.built().set.count, link.set.count);
  EXPECT_TRUE(haptic::isWellFormed(link.set));
  sets.forget();
  EXPECT_EQ(sets.built().set.count, 0U);
}

/// A robot that lifts, alone; its links have no shapes.
std::vector<workcell::Entity> scaraCell() {
  workcell::Entity robot;
  robot.id = kBox;
  robot.name = "robot";
  auto model = std::make_shared<const kinematics::RobotModel>(kinematics::test::scara());
  const std::string tip = model->links.back().name;
  robot.body = workcell::Robot{{.model = model, .joints = {0.3, 0.8, -0.05, 0.0}, .tip_link = tip}};
  return {robot};
}

TEST(StylusHolder, TakesFollowsAndPutsDown) {
  Cell cell;
  test::HandLink link;
  StylusHolder holder(link, cell.state);
  holder.takeScene();
  holder.apply(command::SetAxes{{AxesMode::kCell, {}}});
  const ScriptedEntities scripted(cell.state);
  const auto moveTo = [&](const dvec3& p_D) {
    link.state.X_DS.p = link.state.X_DP.p = p_D;
    cell.wait(0.002);
    holder.takeState();
    holder.follow(scripted);
  };
  moveTo({0, 0, 0});
  EXPECT_EQ(holder.held(), nullptr);
  holder.grab(99);
  EXPECT_EQ(holder.held(), nullptr) << "there is no such entity";
  holder.grab(kBox);
  ASSERT_NE(holder.held(), nullptr);
  const dvec3 before = holder.placement(kBox).X_WE.p;
  moveTo({0, 0, 0});
  moveTo({0.004, 0, 0.003});
  EXPECT_NEAR(glm::length(holder.placement(kBox).X_WE.p - before - dvec3(0.004, 0, 0.003)), 0.0, 1e-9);
  EXPECT_GT(holder.sets().sent(), 0U);
  EXPECT_TRUE(holder.contacts().contacts().empty());
  holder.takeResults();
  holder.release();
  EXPECT_EQ(holder.held(), nullptr);
  const std::vector<Result> told = holder.takeResults();
  ASSERT_EQ(told.size(), 1U);
  const auto& moved = std::get<result::Moved>(told[0]);
  EXPECT_EQ(moved.entity, kBox);
  EXPECT_NEAR(moved.X_WE.p.x, before.x + 0.004, 1e-9);
}

TEST(PosedJoints, BringTheJointsWhereTheGloveIs) {
  Cell cell(scaraCell());
  test::HandLink link;
  StylusHolder holder(link, cell.state);
  holder.takeScene();
  ResultLog log;
  PosedJoints posed(cell.state, log);
  posed.want({77, {0.0}, {{0}}});
  EXPECT_EQ(posed.wanted(), 0U) << "it does not exist";
  posed.want({kBox, {0.1, 0.2}, {{0, 1}}});
  EXPECT_EQ(posed.wanted(), 0U) << "it has four joints";
  posed.want({kBox, {0.5, 0.7, 0.1, 0.2}, {{0, 1}, {2}}});
  EXPECT_EQ(posed.wanted(), kBox);
  EXPECT_EQ(posed.posed(), nullptr) << "not before a step";
  posed.beginTake();
  cell.wait(0.02);
  posed.follow(holder);
  ASSERT_TRUE(posed.poses(kBox));
  const std::vector<double> joints = posed.posed()->standing().joints;
  EXPECT_NEAR(joints[0], 0.5, 1e-9);
  EXPECT_NEAR(joints[1], 0.7, 1e-9);
  EXPECT_NEAR(joints[2], 0.1, 1e-9);
  EXPECT_EQ(joints[3], 0.0) << "of no finger";
  EXPECT_EQ(posed.movedInTake(), posed.posed());
  posed.letGo();
  EXPECT_EQ(posed.posed(), nullptr);
  posed.want({0, {}, {}});
  EXPECT_EQ(posed.wanted(), 0U);
}

}  // namespace
}  // namespace hapticell::manipulation
