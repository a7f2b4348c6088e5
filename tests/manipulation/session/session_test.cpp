// SPDX-License-Identifier: Apache-2.0
#include "manipulation/session/server_session.h"
#include "manipulation/session/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "haptic/devices/simulated_device.h"
#include "haptic/server/configured_loop.h"
#include "haptic/server/force_loop.h"
#include "haptic/server/in_memory_link.h"
#include "manipulation/session/local_server.h"
#include "manipulation/session/watched_engine.h"
#include "tests/manipulation/session/test_cells.h"
#include "tests/support/test_data.h"
#include "workcell/format/document_io.h"

namespace hapticell::manipulation {
namespace {

using test::boxOverTable;
using test::handThrough;
using test::sessionOf;

struct Rate {
  double hz;
  double latency_s;
};
const Rate kSlow{10.0, 0.050}, kFast{1000.0, 0.001};

/// Down into the table by 6 mm of hand, along it, and up again.
haptic::HandPath pressAndSlide() {
  return handThrough({{0.0, {0, 0, 0.02}},
                      {1.0, {0, 0, 0.02}},
                      {2.0, {0, 0, -0.006}},
                      {3.0, {0.05, 0, -0.006}},
                      {4.0, {0.05, 0.03, -0.004}},
                      {5.0, {0.05, 0.03, 0.03}},
                      {5.5, {0.05, 0.03, 0.03}}});
}

void expectFeelsRight(const SessionReport& report) {
  EXPECT_LE(report.forces.penetration_max_m, 1e-4);
  EXPECT_LE(report.forces.force_max_n, 6.4);
  EXPECT_LE(report.forces.force_max_step_n_per_ms, 1.0 + 1e-6);
  EXPECT_GE(report.forces.energy_min_j, -1e-3);
}

class SessionAtRate : public testing::TestWithParam<Rate> {};
INSTANTIATE_TEST_SUITE_P(Rates, SessionAtRate, testing::Values(kSlow, kFast),
                         [](const auto& which) { return which.param.hz < 100.0 ? "Slow" : "Fast"; });

TEST_P(SessionAtRate, BoxPressedOnTableSlidesAndLeaves) {
  const auto report =
      runSession(sessionOf(boxOverTable(0.02), "box", pressAndSlide(), GetParam().hz, GetParam().latency_s));
  ASSERT_TRUE(report) << report.error().message();
  expectFeelsRight(*report);
  EXPECT_GT(report->forces.force_max_n, 1.0);
  ASSERT_EQ(report->contacts.size(), 1U);
  EXPECT_EQ(report->contacts[0].other, 1U);
  EXPECT_GT(report->contacts[0].time_in, 1.2);
  EXPECT_LT(report->contacts[0].time_out, 5.0);
  EXPECT_TRUE(report->end.held);
  // The hand ends 10 mm above and 50, 30 mm beside where it took the box.
  EXPECT_NEAR(report->end.X_WM.p.x, 0.05, 0.002);
  EXPECT_NEAR(report->end.X_WM.p.y, 0.03, 0.002);
  EXPECT_NEAR(report->end.X_WM.p.z, 0.06, 0.003);
}

TEST_P(SessionAtRate, WhatStartsInsideComesFreeWithoutAJump) {
  // The box stands 5 mm deep in the table; the hand pushes it down and aside, then lifts it.
  const auto hand = handThrough({{0.0, {0, 0, 0.0}},
                                 {0.5, {0, 0, 0.0}},
                                 {1.0, {0.005, 0, -0.004}},
                                 {1.5, {0, 0, 0.0}},
                                 {3.0, {0, 0, 0.03}},
                                 {3.5, {0, 0, 0.03}}});
  double before = 0.025, longest = 0.0, lowest = before;
  const TraceSink trace = [&](const TraceRow& row) {
    if (row.t < 0.3) return;  // Not held yet.
    longest = std::max(longest, std::abs(row.X_WM.p.z - before));
    lowest = std::min(lowest, row.X_WM.p.z);
    before = row.X_WM.p.z;
  };
  const auto report =
      runSession(sessionOf(boxOverTable(-0.005), "box", hand, GetParam().hz, GetParam().latency_s), trace);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_GT(lowest, 0.025 - 1e-3) << "it gets no deeper";
  // A hand of 31 mm/s moves 3.1 mm between two steps at 10 Hz.
  EXPECT_LT(longest, 1.5 * 0.0315 / std::min(GetParam().hz, 1000.0) + 5e-4);
  EXPECT_NEAR(before, 0.055, 0.002) << "it is where the hand lifted it";
  EXPECT_TRUE(report->end.contacts.empty());
}

TEST_P(SessionAtRate, DemonstrationFeelsRight) {
  Diagnostics diagnostics;
  const auto document = workcell::loadDocument(hapticell::test::sourceFile("config/workcells/demo.hcell"), diagnostics);
  ASSERT_TRUE(document) << document.error().message();
  const auto hand = haptic::readHandPath(hapticell::test::sourceFile("config/workcells/demo-hand.csv"));
  ASSERT_TRUE(hand) << hand.error().message();
  SessionOptions options = sessionOf(document->snapshotEntities(), "robot", *hand, GetParam().hz, GetParam().latency_s);
  options.pairs.sets = document->state().pair_sets;
  const auto report = runSession(options);
  ASSERT_TRUE(report) << report.error().message();
  expectFeelsRight(*report);
  EXPECT_GE(report->contacts.size(), 2U);
  EXPECT_GT(report->forces.force_max_n, 1.0);
}

TEST_P(SessionAtRate, NothingIsTunnelledThroughAtOneMetrePerSecond) {
  // A sheet of 1 mm lies across the way; the hand sweeps 110 mm through it in about 0.15 s.
  const std::vector<workcell::Entity> cell{
      test::solid(1, "sheet", geometry::makeBox({1.0, 1.0, 0.001}), Pose::translation({0, 0, 0})),
      test::solid(2, "box", geometry::makeBox(dvec3(0.02)), Pose::translation({0, 0, 0.06}))};
  const auto report = runSession(sessionOf(
      cell, "box",
      handThrough({{0.0, {0, 0, 0.055}}, {1.2, {0, 0, 0.055}}, {1.35, {0, 0, -0.055}}, {2.0, {0, 0, -0.055}}}),
      GetParam().hz, GetParam().latency_s));
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_LE(report->forces.penetration_max_m, 1e-4);
  EXPECT_GT(report->end.X_WM.p.z, 0.0105);
  EXPECT_LE(report->forces.force_max_n, 6.4);
}

TEST_P(SessionAtRate, StopHoldsWhereSlideGoesOn) {
  const auto end = [&](workcell::OnContact on_contact) {
    SessionOptions options = sessionOf(boxOverTable(0.02), "box",
                                       handThrough({{0.0, {0, 0, 0.02}},
                                                    {1.0, {0, 0, 0.02}},
                                                    {2.0, {0, 0, -0.006}},
                                                    {3.0, {0.03, 0, -0.006}},
                                                    {3.2, {0.03, 0, -0.006}}}),
                                       GetParam().hz, GetParam().latency_s);
    options.on_contact = on_contact;
    const auto report = runSession(options);
    EXPECT_TRUE(report);
    EXPECT_LE(report->forces.penetration_max_m, on_contact == workcell::OnContact::kPass ? 1.0 : 1e-4);
    return report->end.X_WM.p;
  };
  EXPECT_GT(end(workcell::OnContact::kSlide).x, 0.015);
  EXPECT_LT(end(workcell::OnContact::kStop).x, 0.002);
  EXPECT_LT(end(workcell::OnContact::kPass).z, 0.026);
}

TEST_P(SessionAtRate, AnEntityThatLiesOnTheTableCanBeLiftedAndNotPressedIn) {
  const auto report = runSession(sessionOf(
      boxOverTable(0.0), "box",
      handThrough(
          {{0.0, {0, 0, 0}}, {1.0, {0, 0, 0}}, {1.8, {0, 0, -0.005}}, {3.0, {0.01, 0, 0.03}}, {3.3, {0.01, 0, 0.03}}}),
      GetParam().hz, GetParam().latency_s));
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_LE(report->forces.penetration_max_m, 1e-4);
  EXPECT_NEAR(report->end.X_WM.p.z, 0.06, 0.003);
}

TEST(Session, WithForcesOffItIsAThreeDimensionalMouseThatNeverPenetrates) {
  SessionOptions options = sessionOf(boxOverTable(0.02), "box", pressAndSlide(), 60.0, 0.01);
  options.forces = false;
  const auto report = runSession(options);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->forces.force_max_n, 0.0);
  EXPECT_EQ(report->forces.penetration_max_m, 0.0);
  EXPECT_NEAR(report->end.X_WM.p.x, 0.05, 0.001);
}

TEST(Session, TheSameInputGivesTheSameTrace) {
  const auto rows = [] {
    std::vector<double> numbers;
    const auto report =
        runSession(sessionOf(boxOverTable(0.02), "box", pressAndSlide(), 100.0, 0.005), [&](const TraceRow& row) {
          for (int i = 0; i < 3; ++i) {
            numbers.push_back(row.X_DS.p[i]);
            numbers.push_back(row.force_D[i]);
            numbers.push_back(row.X_WM.p[i]);
          }
        });
    EXPECT_TRUE(report);
    return numbers;
  };
  const std::vector<double> first = rows();
  EXPECT_GT(first.size(), 40000U);
  EXPECT_EQ(first, rows());
}

TEST(Session, ScaleMultipliesTranslationOnly) {
  SessionOptions options = sessionOf(
      boxOverTable(0.2), "box",
      handThrough(
          {{0.0, {0, 0, 0}}, {1.0, {0, 0, 0}}, {2.0, {0.02, 0, 0}, {0, 0, 0.3}}, {2.4, {0.02, 0, 0}, {0, 0, 0.3}}}),
      60.0, 0.001);
  options.scale = {ScaleLevel::kRough, 1.0};
  const auto report = runSession(options);
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->end.X_WM.p.x, 0.02 * options.configuration.scale.rough, 0.002);
  EXPECT_NEAR(rotationVector(report->end.X_WM.q).z, 0.3, 0.02);
}

TEST(Session, UnknownNamesAreToldWithWhatThereIs) {
  const auto unknown = runSession(sessionOf(boxOverTable(0.1), "bix", pressAndSlide(), 60.0, 0.0));
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message().find("table, box"), std::string::npos);
  SessionOptions options = sessionOf(boxOverTable(0.1), "box", pressAndSlide(), 60.0, 0.0);
  options.moved_by = by::Tool{};
  const auto unfit = runSession(options);
  ASSERT_FALSE(unfit);
  EXPECT_NE(unfit.error().message().find("self_origin"), std::string::npos);
}

/// Taken while it touches the table: it may slide, turn and leave, but the shown box gets no deeper in any step.
TEST_P(SessionAtRate, PlateThatStandsOnTheTableLeavesItWithoutDippingIn) {
  std::vector<workcell::Entity> entities = boxOverTable(0.0);
  entities[1] = test::solid(2, "box", geometry::makeBox({0.4, 0.4, 0.02}), Pose::translation({0, 0, 0.01}));
  const haptic::HandPath hand = handThrough({{0.0, {0, 0, 0}},
                                             {0.8, {0, 0, 0}},
                                             {2.0, {0.05, 0, -0.03}},
                                             {3.0, {0.08, -0.08, -0.08}, {0.5, 0.5, 0.5}},
                                             {4.0, {0, 0, 0.05}}});
  const auto report = runSession(sessionOf(entities, "box", hand, GetParam().hz, GetParam().latency_s));
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_LE(report->forces.penetration_max_m, FreeMotion::kGuard);
  EXPECT_GT(report->end.X_WM.p.z, 0.03);
}

TEST(WatchedEngine, SaysBeforeItBeginsWhatCannotBeDone) {
  SessionOptions options = sessionOf(boxOverTable(0.02), "lid", pressAndSlide(), 60.0, 0.0);
  haptic::VirtualClock clock;
  haptic::SimulatedDevice device(options.device);
  ASSERT_TRUE(device.open());
  haptic::ForceLoop loop(device, clock, haptic::configuredLoop(device, options.configuration));
  haptic::InMemoryLink link(loop, clock, haptic::describe(device), {});
  const auto nobody = WatchedEngine(link, options).prepare();
  ASSERT_FALSE(nobody);
  EXPECT_THAT(nobody.error().message(), ::testing::HasSubstr("no entity is named 'lid'"));
  options.entity = "box";
  options.axes = {AxesMode::kFrame, "jig"};
  const auto nowhere = WatchedEngine(link, options).prepare();
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message(), ::testing::HasSubstr("no frame is named 'jig'"));
  options.axes = {};
  WatchedEngine engine(link, options);
  ASSERT_TRUE(engine.prepare());
  EXPECT_EQ(engine.sentAt(0), -1.0);
  EXPECT_EQ(engine.sentAt(7), -1.0) << "no such set";
  EXPECT_FALSE(engine.isSolved(10.0)) << "no planner";
  const SessionReport report = engine.finish(0.0);
  EXPECT_FALSE(report.end.held) << "nobody pressed the button";
  EXPECT_EQ(report.rate_manipulation_hz, 0.0);
}

TEST(Session, RunsInRealTimeThroughAServerOfItsOwn) {
  const SessionOptions options = sessionOf(
      boxOverTable(0.02), "box",
      handThrough({{0.0, {0, 0, 0.02}}, {0.8, {0, 0, 0.02}}, {1.6, {0, 0, -0.005}}, {2.0, {0, 0, -0.005}}}), 60.0, 0.0);
  const auto server = LocalServer::start(options.device, options.configuration);
  ASSERT_TRUE(server) << server.error().message();
  const auto report = runSessionOnServer(options, "127.0.0.1", (*server)->port());
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_GT(report->ticks, 0U);
  EXPECT_LE(report->forces.penetration_max_m, 1e-4);
  EXPECT_LE(report->forces.force_max_n, 6.4);
}

TEST(Session, EndsInAnErrorThatSaysWhenItsServerWasLost) {
  const SessionOptions options =
      sessionOf(boxOverTable(0.02), "box", handThrough({{0.0, {0, 0, 0.02}}, {30.0, {0, 0, 0.01}}}), 60.0, 0.0);
  auto server = LocalServer::start(options.device, options.configuration);
  ASSERT_TRUE(server) << server.error().message();
  std::thread end;
  const auto report = runSessionOnServer(options, "127.0.0.1", (*server)->port(), [&](const TraceRow& row) {
    if (row.t > 0.3 && !end.joinable()) end = std::thread([&] { server->reset(); });
  });
  if (end.joinable()) end.join();
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message(), ::testing::HasSubstr("the haptic server was lost after 0."));
}

TEST(Session, PassingThroughIsNotFeltEvenAtTenHertz) {
  SessionOptions options = sessionOf(boxOverTable(0.02), "box", pressAndSlide(), 10.0, 0.05);
  options.on_contact = workcell::OnContact::kPass;
  const auto report = runSession(options);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_EQ(report->forces.force_max_n, 0.0);
}

}  // namespace
}  // namespace hapticell::manipulation
