// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/felt_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "haptic/rendering/proxy_metric.h"
#include "haptic/rendering/proxy_rows.h"
#include "manipulation/engine/hand_trail.h"
#include "manipulation/engine/manipulation_engine.h"
#include "manipulation/engine/plan_ride.h"
#include "tests/manipulation/session/hand_link.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::HandLink;

/// Gives the ways that the test sets, each for the hold in which it is asked for first.
class ScriptedPlans final : public PlanSource {
 public:
  void look(const PlanView& view) override {
    seen = view;
    if (on_look) on_look(view);
    if (way && way->hold == 0) way->hold = view.hold;
  }
  std::shared_ptr<const PlannedWay> newest() override { return way; }
  bool isReached(const PlanView&) const override { return reached; }

  void give(std::vector<Pose> X_WM, std::uint64_t answers = 0, std::vector<std::vector<double>> joints = {}) {
    auto made = std::make_shared<PlannedWay>();
    made->number = ++given;
    made->answers = answers;
    made->X_WM = std::move(X_WM);
    for (std::vector<double>& one : joints) made->postures.push_back({{}, std::move(one)});
    way = std::move(made);
  }

  PlanView seen;
  std::shared_ptr<PlannedWay> way;
  std::uint64_t given = 0;
  bool reached = false;
  std::function<void(const PlanView&)> on_look;
};

class FeltPlanTest : public testing::Test {
 protected:
  FeltPlanTest() : plans(std::make_shared<ScriptedPlans>()), engine(link, {}) {
    engine.apply(command::SetDocument{test::boxOverTable(0.1), {}});
    engine.apply(command::SetAxes{{AxesMode::kCell, {}}});
    engine.apply(command::SetPlan{plans, 1.0});
    engine.apply(command::Grab{2});
    start = engine.placement(2).X_WE;
  }
  void stay(double seconds, const dvec3& p_DS) {
    for (int i = 0; i < std::lround(100.0 * seconds); ++i) {
      link.state.X_DS.p = link.state.X_DP.p = p_DS;
      engine.step(now += 10'000'000);
    }
  }
  /// What the newest set pulls the stylus by, by the renderer's own sum.
  dvec3 pull() const {
    haptic::GroupedSet grouped;
    grouped.take(link.set);
    return grouped.pullAt(link.state.X_DS);
  }
  int pulls() const {
    return static_cast<int>(std::count_if(link.set.active().begin(), link.set.active().end(), [](const auto& c) {
      return c.kind == haptic::ConstraintKind::kPull;
    }));
  }
  Pose at(const dvec3& way) const { return {start.p + way, start.q}; }

  HandLink link;
  std::shared_ptr<ScriptedPlans> plans;
  ManipulationEngine engine;
  Pose start;
  std::int64_t now = 0;
};

TEST_F(FeltPlanTest, PullsAlongTheWayByTheAuthority) {
  stay(0.5, {});
  EXPECT_EQ(pulls(), 0) << "no way yet";
  EXPECT_EQ(plans->seen.entity, 2U);
  plans->give({start, at({0.1, 0.0, 0.0})});
  stay(2.0, {});
  EXPECT_EQ(engine.plan().ways, 1U);
  EXPECT_NEAR(engine.plan().share, 1.0, 1e-9);
  const dvec3 full = pull();
  EXPECT_GT(full.x, 1.0) << "N";
  EXPECT_LT(full.x, 3.0);
  EXPECT_NEAR(full.y, 0.0, 1e-9);
  EXPECT_NEAR(full.z, 0.0, 1e-9);
  engine.apply(command::SetPlan{plans, 0.25});
  stay(0.5, {});
  EXPECT_NEAR(pull().x, 0.25 * full.x, 1e-6);
  engine.apply(command::SetPlan{plans, 0.0});
  stay(0.5, {});
  EXPECT_EQ(pulls(), 0) << "without authority nothing is felt";
  engine.apply(command::SetPlan{plans, 1.0});
  stay(1.5, {});
  plans->reached = true;
  stay(0.5, {});
  EXPECT_EQ(pulls(), 0) << "at the goal nothing pulls on";
  EXPECT_TRUE(engine.plan().reached);
}

TEST_F(FeltPlanTest, AHandThatInsistsIsLetGoAndAsked) {
  plans->give({start, at({0.1, 0.0, 0.0})});
  stay(2.0, {});
  stay(0.4, {0.0, 0.0, 0.02});
  EXPECT_FALSE(engine.plan().insists) << "not half a second yet";
  EXPECT_GT(pulls(), 0);
  stay(0.6, {0.0, 0.0, 0.02});
  EXPECT_TRUE(engine.plan().insists);
  EXPECT_EQ(engine.plan().insistences, 1U);
  EXPECT_NEAR(engine.plan().share, 0.0, 1e-9);
  EXPECT_EQ(pulls(), 0);
  EXPECT_EQ(plans->seen.insistences, 1U);
  EXPECT_NEAR(plans->seen.push_W.z, 0.02, 2e-3) << "the planner is told where the hand pushes";
  // A way that was asked for before is no answer.
  plans->give({start, at({0.0, 0.1, 0.0})}, 0);
  stay(0.5, {0.0, 0.0, 0.02});
  EXPECT_NEAR(engine.plan().share, 0.0, 1e-9);
  plans->give({start, at({0.0, 0.0, 0.1})}, 1);
  stay(1.5, {0.0, 0.0, 0.02});
  EXPECT_NEAR(engine.plan().share, 1.0, 1e-9);
  EXPECT_GT(pull().z, 1.0) << "it is led on where it pushed";
}

TEST_F(FeltPlanTest, CarriesTheEntityOnTheWayWhileTheHandWandersInTheTube) {
  engine.apply(command::SetScale{{ScaleLevel::kNumber, 20.0}});
  plans->give({start, at({0.5, 0.0, 0.0})});
  stay(2.0, {});
  for (int i = 0; i < 60; ++i) stay(0.01, {0.0, 0.0, 1e-4 * i});
  stay(0.3, {0.0, 0.0, 0.006});
  EXPECT_LT(std::abs(engine.placement(2).X_WE.p.z - start.p.z), 0.25 * plans->way->clearance + 1e-6)
      << "12 cm beside the way by the hand alone";
  EXPECT_NEAR(pull().z, -0.9, 0.05) << "N: what 6 mm of hand are worth";
  // It goes along the way with the hand, as far as the hand goes.
  for (int i = 0; i < 100; ++i) stay(0.01, {1e-4 * i, 0.0, 0.006});
  stay(0.3, {0.01, 0.0, 0.006});
  EXPECT_NEAR(engine.placement(2).X_WE.p.x - start.p.x, 0.2, 0.01);
  // A hand that insists gets the entity back where it is, without a leap.
  Pose last = engine.placement(2).X_WE;
  for (int i = 0; i < 200; ++i) {
    stay(0.01, {0.01, 0.0, 0.015});
    const Pose now_at = engine.placement(2).X_WE;
    if (i > 0) {
      EXPECT_LT(glm::distance(now_at.p, last.p), 20.0 * 0.15 * 0.01 + 1e-6);
    }
    last = now_at;
  }
  EXPECT_TRUE(engine.plan().insists);
  EXPECT_NEAR(last.p.z, start.p.z, 1e-3);
  stay(0.3, {0.01, 0.0, 0.02});
  EXPECT_NEAR(engine.placement(2).X_WE.p.z - last.p.z, 20.0 * 0.005, 1e-3);
}

TEST_F(FeltPlanTest, TurnsTheEntityWithTheWay) {
  const dquat turned = quaternionFromRotationVector({0.0, 0.0, 1.0});
  plans->give({start, {start.p, turned}});
  stay(4.0, {});
  const Pose there = engine.placement(2).X_WE;
  EXPECT_LT(glm::length(rotationVector(turned * glm::conjugate(there.q))), 0.01) << "the stylus has not turned";
  EXPECT_LT(glm::distance(there.p, start.p), 1e-6);
  // From now on the hand's motion goes on from there, unturned.
  engine.apply(command::SetPlan{nullptr, 0.0});
  stay(0.2, {0.02, 0.0, 0.0});
  EXPECT_NEAR(engine.placement(2).X_WE.p.x, start.p.x + 0.02, 1e-6);
}

/// The table is in the way, which the planner did not know: the entity stops at it, and the planner is told.
TEST_F(FeltPlanTest, TellsThePlannerWhatKeepsTheEntityOffItsWay) {
  plans->give({start, at({0.0, 0.0, -0.5})});
  stay(0.3, {});
  EXPECT_FALSE(plans->seen.strayed);
  for (int i = 0; i < 150; ++i) stay(0.01, {0.0, 0.0, -0.001 * i});
  EXPECT_TRUE(plans->seen.strayed);
  EXPECT_GT(engine.placement(2).X_WE.p.z, start.p.z - 0.1 - 1e-4) << "it does not enter the table";
}

/// Contacts of an entity that is carried are as much farther as the hand's motion moves it less.
TEST(PlanRide, EasesContactsAsTheHandMovesLess) {
  const auto scene = PreparedScene::prepare(test::boxOverTable(0.005), {}, {});
  const auto held = HeldEntity::take(scene, 2, {}, {}, {});
  ASSERT_TRUE(held) << held.error().message();
  MotionMapping mapping;
  mapping.anchor({}, (*held)->movedFrame());
  const BuiltConstraints plain = (*held)->constraints(mapping, {}, {});
  ASSERT_GT(plain.set.count, 0U);
  for (const double authority : {0.0, 0.3, 0.7, 1.0}) {
    BuiltConstraints eased = plain;
    easeContacts(eased, **held, 1.0, authority);
    const double by_hand = authority < 1.0 ? 1.0 - authority : 1e-3;
    for (std::size_t i = 0; i < plain.set.count; ++i) {
      const haptic::Vector6 xi{0.004, -0.002, -0.003, 0.02, 0.05, -0.01};
      haptic::Vector6 moved = xi;
      for (double& x : moved) x *= by_hand;
      const int pair = plain.origins[i].pair;
      const double felt_from = pair < 0 ? 0.0 : (*held)->pairs()[static_cast<std::size_t>(pair)].feel.boundary;
      const double gap = (haptic::evaluate(plain.set.constraints[i], moved) + felt_from) / by_hand - felt_from;
      EXPECT_NEAR(haptic::evaluate(eased.set.constraints[i], xi), gap, 1e-9 * std::max(1.0, gap)) << authority;
    }
    EXPECT_GE(eased.set.zone_radius, plain.set.zone_radius);
    eased = plain;
    for (haptic::Constraint& row : eased.set.constraints) row.gap = -0.1;
    easeContacts(eased, **held, 1.0, authority);
    for (std::size_t i = 0; i < eased.set.count; ++i) EXPECT_EQ(eased.set.constraints[i].gap, -0.1) << "it is touched";
  }
}

TEST(PlanRide, GoesTheWaysDirection) {
  const auto along = [](const std::vector<Pose>& X_WM) {
    trajectory::Trajectory way;
    for (const Pose& X : X_WM) way.addFrame({static_cast<double>(way.size()), X});
    return trajectory::PathProgress(way);
  };
  const auto bent = along({{}, Pose::translation({0.1, 0, 0}), Pose::translation({0.1, 0.1, 0})});
  EXPECT_LT(glm::length(directionOf(bent, 0.05) - dvec3(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(directionOf(bent, 0.15) - dvec3(0, 1, 0)), 1e-12);
  EXPECT_LT(glm::length(directionOf(bent, 0.2) - dvec3(0, 1, 0)), 1e-12) << "at its end, the last one";
  const auto turns = along({{}, {{0, 0, 0}, quaternionFromRotationVector({0, 0, 1.0})}});
  EXPECT_EQ(directionOf(turns, 0.05), dvec3(0.0));
}

TEST_F(FeltPlanTest, RemembersTheHandsWay) {
  for (int i = 0; i <= 50; ++i) stay(0.01, {0.001 * i, 0.0, 0.0});
  const Trail& trail = *plans->seen.trail;
  ASSERT_GT(trail.size(), 10U);
  EXPECT_NEAR(trail.back().X_WE.p.x - start.p.x, 0.05, 0.004);
  for (std::size_t i = 1; i < trail.size(); ++i) EXPECT_GE(trail[i].X_WE.p.x - trail[i - 1].X_WE.p.x, 0.003 - 1e-9);
  engine.apply(command::Release{});
  engine.apply(command::Grab{2});
  stay(0.02, {0.05, 0.0, 0.0});
  EXPECT_LE(plans->seen.trail->size(), 2U) << "a new hold begins anew";
}

TEST_F(FeltPlanTest, AWayIsOfOneHold) {
  plans->give({start, at({0.3, 0.0, 0.0})});
  stay(0.5, {0.0, 0.0, 0.0});
  ASSERT_EQ(engine.plan().ways, 1U);
  engine.apply(command::Release{});
  engine.apply(command::Grab{2});
  stay(0.5, {0.0, 0.0, 0.0});
  EXPECT_EQ(engine.plan().way, nullptr) << "it led from where the entity was then";
  EXPECT_EQ(engine.plan().share, 0.0);
}

TEST(HandTrail, StaysShort) {
  HandTrail trail;
  for (int i = 0; i < 5000; ++i) {
    EntityConfiguration at;
    at.X_WE.p.x = 0.01 * i;
    trail.add(at, at.X_WE, 0.003);
  }
  EXPECT_LE(trail.trail()->size(), 513U);
  EXPECT_EQ(trail.trail()->front().X_WE.p.x, 0.0);
  EXPECT_NEAR(trail.trail()->back().X_WE.p.x, 49.99, 1e-9);
}

TEST(PlanPull, HasAPotential) {
  const MotionMapping mapping;
  const Pose X_WM = Pose::translation({0.01, -0.004, 0.002});
  const auto rows = planPull(X_WM, {0.02, 0.0, 0.0}, 0.8, mapping);
  for (const haptic::Constraint& row : rows) {
    // Work on the way there and back along any line is none: the force is a function of f alone, along f's gradient.
    EXPECT_EQ(row.kind, haptic::ConstraintKind::kPull);
    EXPECT_GT(row.reach, kPlanLead);
    EXPECT_NEAR(haptic::lengthOf(row.gradient), 1.0, 1e-12);
  }
  EXPECT_NEAR(rows[0].gap, -0.01, 1e-12);
  EXPECT_NEAR(rows[1].gap, -0.004, 1e-12);
}

/// Sessions in virtual time: a plan that changes ten times a second, in the air and pressed onto the table.
void changesTenTimes(double height, double rate_hz, double latency_s) {
  using test::Waypoint;
  auto plans = std::make_shared<ScriptedPlans>();
  plans->on_look = [source = plans.get()](const PlanView& view) {
    const auto due = static_cast<std::uint64_t>(view.time_ns / 100'000'000);
    if (due <= source->given) return;
    const double angle = 2.4 * static_cast<double>(due);
    source->give({view.X_WM, {view.X_WM.p + 0.1 * dvec3(std::cos(angle), std::sin(angle), 0.3 * std::cos(3.0 * angle)),
                              quaternionFromRotationVector({0.0, 0.0, std::sin(angle)})}});
  };
  const double down = height < 0.05 ? -height - 0.004 : 0.0;
  SessionOptions options = test::sessionOf(
      test::boxOverTable(height), "box",
      test::handThrough({{0.0, {}}, {1.0, {}}, {2.0, {0.0, 0.0, down}}, {3.5, {0.03, 0.0, down}}, {5.0, {-0.03, 0.02, down}}}),
      rate_hz, latency_s);
  options.axes.mode = AxesMode::kCell;
  options.assistance = {plans, 1.0};
  const auto report = runSession(options);
  ASSERT_TRUE(report.has_value()) << report.error().message();
  ASSERT_TRUE(report->plan.has_value());
  EXPECT_GT(report->plan->ways, 40U);
  EXPECT_GT(report->forces.force_max_n, 0.5) << "it is felt";
  EXPECT_LE(report->forces.force_max_step_n_per_ms, 0.10) << height << " m, " << rate_hz << " Hz";
  EXPECT_LE(report->forces.penetration_blocked_m, 1e-6);
  EXPECT_GE(report->forces.energy_min_j, -0.5e-3);
  EXPECT_FALSE(report->plan->authority.empty());
}

TEST(ChangingPlan, IsNotFeltAsJumpsInTheAir) {
  changesTenTimes(0.1, 1000.0, 0.001);
  changesTenTimes(0.1, 60.0, 0.010);
  changesTenTimes(0.1, 10.0, 0.050);
}

TEST(ChangingPlan, IsNotFeltAsJumpsOnTheTable) {
  changesTenTimes(0.003, 1000.0, 0.001);
  changesTenTimes(0.003, 60.0, 0.010);
}

/// A hand that presses the box onto the table all the time, and a way that first of all turns it.
TEST(ChangingPlan, LeadsAwayFromWhatTheHandPressesAgainst) {
  auto plans = std::make_shared<ScriptedPlans>();
  std::int64_t begin = -1;
  plans->on_look = [source = plans.get(), &begin](const PlanView& view) {
    if (begin < 0) begin = view.time_ns;
    if (source->given > 0 || view.time_ns - begin < 1'500'000'000) return;
    const dquat turned = quaternionFromRotationVector({0.0, 0.0, 1.0});
    const dvec3 up(0.0, 0.0, 0.006), side(0.02, 0.0, 0.0);
    source->give({view.X_WM, {view.X_WM.p + up, turned}, {view.X_WM.p + up + side, turned}});
  };
  SessionOptions options = test::sessionOf(
      test::boxOverTable(0.003), "box",
      test::handThrough({{0.0, {}}, {0.5, {}}, {1.0, {0.0, 0.0, -0.006}}, {6.0, {0.0, 0.0, -0.006}}}), 250.0, 0.004);
  options.axes.mode = AxesMode::kCell;
  options.assistance = {plans, 1.0};
  double pressed = 0.0;
  const auto report = runSession(options, [&](const TraceRow& row) {
    if (row.t < 1.4 && row.contact) pressed = std::max(pressed, glm::length(row.force_D));
  });
  ASSERT_TRUE(report.has_value()) << report.error().message();
  EXPECT_GT(pressed, 0.5) << "N";
  const double lifted = report->end.X_WM.p.z - test::boxOverTable(0.003)[1].X_WE.p.z;
  EXPECT_NEAR(lifted, 0.004, 1e-4) << "2 mm down to the table's boundary, 6 mm up by the way";
  EXPECT_NEAR(glm::length(rotationVector(report->end.X_WM.q)), 1.0, 0.02);
  EXPECT_LE(report->forces.force_max_step_n_per_ms, 0.10);
  EXPECT_LE(report->forces.penetration_blocked_m, 1e-6);
  EXPECT_GE(report->forces.energy_min_j, -0.5e-3);
}

}  // namespace
}  // namespace hapticell::manipulation
