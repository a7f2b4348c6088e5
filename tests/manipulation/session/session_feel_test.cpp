// SPDX-License-Identifier: Apache-2.0
// What the hand feels in whole sessions: taps, torque, force classes, moving obstacles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "manipulation/session/session.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::boxOverTable;
using test::handThrough;
using test::sessionOf;

/// A box under the stylus that taps the table three times a second with 0.25 m/s of hand.
haptic::HandPath tappingHand(double speed) {
  std::vector<haptic::HandSample> samples;
  const double omega = 6.0 * std::numbers::pi, swing = speed / omega;
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.01 * i, share = std::clamp(t - 1.2, 0.0, 1.0);
    const dvec3 p(0, 0, swing * (share * std::cos(omega * (t - 1.2)) - share));
    samples.push_back({t, Pose::translation(p), t >= 0.05 && t < 0.15 ? 1U : 0U});
  }
  return haptic::HandPath(std::move(samples));
}

TEST(SessionFeel, TapsMakeNoMoreThanAMillijoule) {
  for (const double rate : {10.0, 1000.0}) {
    const auto report = runSession(sessionOf(boxOverTable(0.012), "box", tappingHand(0.25), rate, 0.5 / rate));
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_GT(report->forces.force_max_n, 2.0);
    EXPECT_LT(report->forces.energy_min_j, 0.0);
    EXPECT_GE(report->forces.energy_min_j, -1e-3) << rate;
  }
}

/// The box pressed onto the table and the wrist turned.
TEST(SessionFeel, ADeviceOfSixDrivenAxesResistsTheTurn) {
  const auto turnedHand = handThrough({{0.0, {0, 0, 0.01}},
                                       {1.2, {0, 0, 0.01}},
                                       {2.0, {0, 0, -0.002}},
                                       {3.0, {0, 0, -0.002}, {0, 0.2, 0}},
                                       {4.0, {0, 0, -0.002}, {0, 0.2, 0}}});
  auto options = sessionOf(boxOverTable(0.01), "box", turnedHand, 60.0, 0.01);
  dvec3 torque(0.0);
  double most = 0.0;
  const TraceSink watch = [&](const TraceRow& row) {
    torque = row.torque_D;
    most = std::max(most, glm::length(row.torque_D));
  };
  const auto three = runSession(options, watch);
  ASSERT_TRUE(three) << three.error().message();
  EXPECT_EQ(most, 0.0);
  options.device.driven_axes = 6;
  options.device.peak_torque = 0.188;
  const auto six = runSession(options, watch);
  ASSERT_TRUE(six) << six.error().message();
  EXPECT_GT(glm::length(torque), 0.02);
  EXPECT_LT(torque.y, 0.0) << "against the turn";
  EXPECT_LE(most, 0.188 + 1e-9);
  EXPECT_LE(six->forces.penetration_max_m, 1e-4);
  EXPECT_GE(six->forces.energy_min_j, -1e-3);
}

workcell::ScriptedMotion going(const dvec3& way, double duration) {
  workcell::ScriptedMotion motion;
  motion.points = {{0.0, dvec3(0.0)}, {duration, way}};
  motion.repeat = workcell::MotionRepeat::kBack;
  return motion;
}

/// A belt of 2 m runs at 0.2 m/s under the box that is pressed onto it by a hand that stays.
TEST(SessionFeel, AConveyorUnderThePartIsFeltAsItsFrictionOnly) {
  for (const double rate : {10.0, 60.0, 1000.0}) {
    auto cell = boxOverTable(0.01);
    const auto hand =
        handThrough({{0.0, {0, 0, 0.01}}, {1.2, {0, 0, 0.01}}, {2.0, {0, 0, -0.005}}, {4.0, {0, 0, -0.005}}});
    const auto still = runSession(sessionOf(cell, "box", hand, rate, 0.5 / rate));
    cell[0].motion = going({0.8, 0, 0}, 4.0);
    cell[0].body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({4.0, 1.0, 0.1}))};
    dvec3 force(0.0);
    const auto moving =
        runSession(sessionOf(cell, "box", hand, rate, 0.5 / rate), [&](const TraceRow& row) { force = row.force_D; });
    ASSERT_TRUE(still && moving);
    EXPECT_NEAR(moving->forces.force_max_n, still->forces.force_max_n, 0.15 * still->forces.force_max_n) << rate;
    EXPECT_LE(moving->forces.penetration_max_m, 7.5e-5) << rate;
    EXPECT_GE(moving->forces.energy_min_j, -0.75e-3) << rate;
    EXPECT_GT(force.z, 1.0);
    EXPECT_GT(force.x, 0.05 * force.z) << "it drags along, steel on steel";
    EXPECT_LT(force.x, 0.4 * force.z);
  }
}

/// A wall comes at 0.1 m/s and takes the box along.
TEST(SessionFeel, AWallThatComesPushesThePartAndNeverEntersIt) {
  for (const double rate : {10.0, 1000.0}) {
    std::vector<workcell::Entity> cell{
        test::solid(1, "wall", geometry::makeBox({0.02, 0.5, 0.5}), Pose::translation({-0.2, 0, 0})),
        test::solid(2, "box", geometry::makeBox(dvec3(0.06)))};
    cell[0].motion = going({0.2, 0, 0}, 2.0);
    const auto hand = handThrough({{0.0, dvec3(0.0)}, {3.0, dvec3(0.0)}});
    auto options = sessionOf(cell, "box", hand, rate, 0.5 / rate);
    options.configuration.hand.stiffness = 150.0;
    const auto report = runSession(options);
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_GT(report->forces.force_max_n, 1.0) << rate;
    EXPECT_LE(report->forces.penetration_max_m, 7.5e-5) << rate;
    ASSERT_EQ(report->contacts.size(), 1U) << rate;
    // 160 mm at 0.1 m/s: it arrives after 1.6 s.
    EXPECT_NEAR(report->contacts[0].time_in, 1.6, 0.15) << rate;
  }
}

/// Down onto the table by 5 mm of hand and to rest, after a swing in free air.
SessionOptions pressing(const std::string& material, workcell::ForceClass force_class) {
  auto cell = boxOverTable(0.02);
  cell[0].contact.material = cell[1].contact.material = material;
  cell[1].contact.mass = 3.0;
  auto options = sessionOf(cell, "box",
                           handThrough({{0.0, {0, 0, 0.02}},
                                        {1.2, {0, 0, 0.02}},
                                        {1.6, {0.03, 0, 0.02}},
                                        {2.0, {0, 0, 0.02}},
                                        {2.4, {0, 0, -0.005}},
                                        {3.4, {0, 0, -0.005}}}),
                           60.0, 0.01);
  options.force_class = force_class;
  return options;
}

struct Felt {
  double in_air = 0.0, at_impact = 0.0, at_rest = 0.0;  ///< N, largest; at rest the vertical one at the end.
};

Felt feltOf(const SessionOptions& options) {
  Felt felt;
  const auto report = runSession(options, [&](const TraceRow& row) {
    const double force = glm::length(row.force_D);
    if (row.t > 1.2 && row.t < 2.0) felt.in_air = std::max(felt.in_air, force);
    if (row.t > 2.0 && row.t < 2.6) felt.at_impact = std::max(felt.at_impact, row.force_D.z);
    felt.at_rest = row.force_D.z;
  });
  EXPECT_TRUE(report.has_value());
  if (report.has_value()) {
    EXPECT_GE(report->forces.energy_min_j, -1e-3);
  }
  return felt;
}

TEST(SessionFeel, TheClassConstantFeelsEveryMaterialAlike) {
  const Felt steel = feltOf(pressing("steel", workcell::ForceClass::kConstant));
  const Felt foam = feltOf(pressing("foam", workcell::ForceClass::kConstant));
  EXPECT_EQ(steel.in_air, 0.0);
  EXPECT_GT(steel.at_rest, 0.8);
  EXPECT_EQ(steel.at_rest, foam.at_rest);
  EXPECT_EQ(steel.at_impact, foam.at_impact);
}

TEST(SessionFeel, TheClassContactFeelsMaterialAndWhatIsLeftOfTheWeight) {
  const Felt steel = feltOf(pressing("steel", workcell::ForceClass::kContact));
  const Felt foam = feltOf(pressing("foam", workcell::ForceClass::kContact));
  EXPECT_LT(foam.at_rest, 0.8 * steel.at_rest) << "a soft thing gives way";
  EXPECT_EQ(steel.in_air, 0.0) << "gravity is compensated as shipped";
  auto heavy = pressing("steel", workcell::ForceClass::kContact);
  heavy.configuration.manipulation.gravity_compensation = 0.99;
  // 1 % of 3 kg: 0.294 N.
  EXPECT_NEAR(feltOf(heavy).in_air, 0.01 * 3.0 * 9.80665, 0.01);
  heavy.configuration.manipulation.gravity_compensation = 0.0;
  EXPECT_NEAR(feltOf(heavy).in_air, 0.5 * heavy.device.continuous_force, 0.01) << "no more than that";
}

TEST(SessionFeel, TheClassDynamicsFeelsInertiaAndStrikesHarder) {
  const Felt light = feltOf(pressing("steel", workcell::ForceClass::kContact));
  const Felt heavy = feltOf(pressing("steel", workcell::ForceClass::kDynamics));
  EXPECT_GT(heavy.in_air, 0.1) << "it must be accelerated";
  EXPECT_GT(heavy.at_impact, light.at_impact);
  EXPECT_NEAR(heavy.at_rest, light.at_rest, 0.15) << "at rest inertia is nothing";
}

struct SlidOver {
  double side = 0.0;   ///< N, the greatest sideways while it slides over the middle.
  double press = 0.0;  ///< N, the same upwards.
};

/// A part of `mesh`, 20 mm over z = 0, pressed `depth` deep and led from x -30 to 30 mm.
SlidOver slidOver(std::vector<workcell::Entity> cell, geometry::TriangleMesh mesh, double height, double rate,
                  double latency, const dvec3& way, double depth) {
  cell.push_back(test::solid(9, "part", std::move(mesh), Pose::translation(-0.03 * way + dvec3(0, 0, height + 0.02))));
  auto options = sessionOf(std::move(cell), "part",
                           handThrough({{0.0, -0.03 * way + dvec3(0, 0, 0.02)},
                                        {1.3, -0.03 * way + dvec3(0, 0, 0.02)},
                                        {2.1, -0.03 * way + dvec3(0, 0, -depth)},
                                        {4.1, 0.03 * way + dvec3(0, 0, -depth)}}),
                           rate, latency);
  for (auto& entity : options.entities) entity.locked = entity.name != "part";
  options.moved_by = *parseMovedBy("self_origin");
  options.axes.mode = AxesMode::kCell;
  options.scale = {ScaleLevel::kNumber, 1.0};
  options.configuration.manipulation.safety_distance = 0.0;
  SlidOver felt;
  const auto report = runSession(options, [&](const TraceRow& row) {
    if (row.t < 2.6 || row.t > 3.9) return;
    felt.side = std::max(felt.side, std::hypot(row.force_D.x, row.force_D.y));
    felt.press = std::max(felt.press, row.force_D.z);
  });
  EXPECT_TRUE(report) << report.error().message();
  if (!report) return felt;
  EXPECT_LE(report->forces.penetration_max_m, 1e-4);
  return felt;
}

/// Two plates that lie flush feel like one, at every rate and latency, whatever is led over them and whichever way.
TEST(SessionFeel, AFlushSeamIsNotFelt) {
  const auto plate = [](workcell::EntityId id, const std::string& name, const dvec3& size, const dvec3& top) {
    return test::solid(id, name, geometry::makeBox(size), Pose::translation(top - dvec3(0, 0, 0.5 * size.z)));
  };
  const std::vector<workcell::Entity> one{plate(1, "a", {0.4, 0.4, 0.02}, {0, 0, 0})};
  const std::vector<workcell::Entity> two{plate(1, "a", {0.2, 0.4, 0.02}, {-0.1, 0, 0}),
                                          plate(2, "b", {0.2, 0.4, 0.02}, {0.1, 0, 0})};
  const std::vector<workcell::Entity> four{
      plate(1, "a", {0.2, 0.2, 0.02}, {-0.1, -0.1, 0}), plate(2, "b", {0.2, 0.2, 0.05}, {0.1, -0.1, 0}),
      plate(3, "c", {0.2, 0.2, 0.02}, {-0.1, 0.1, 0}), plate(4, "d", {0.2, 0.2, 0.02}, {0.1, 0.1, 0})};
  struct Case {
    geometry::TriangleMesh part;
    double height;
    const std::vector<workcell::Entity>* cell;
    dvec3 way;
    double depth = 0.002;
  };
  const std::vector<Case> cases{{geometry::makeSphere(0.01), 0.01, &two, {1, 0, 0}},
                                {geometry::makeSphere(0.01), 0.01, &two, {-1, 0, 0}, 0.008},
                                {geometry::makeSphere(0.01), 0.01, &four, {0.8, 0.6, 0}},
                                {geometry::makeBox(dvec3(0.03)), 0.015, &two, {1, 0, 0}}};
  for (const auto& [rate, latency] : {std::pair{1000.0, 0.0}, {60.0, 0.02}, {30.0, 0.05}, {10.0, 0.05}}) {
    for (const Case& one_case : cases) {
      const SlidOver whole = slidOver(one, one_case.part, one_case.height, rate, latency, one_case.way, one_case.depth);
      const SlidOver seam =
          slidOver(*one_case.cell, one_case.part, one_case.height, rate, latency, one_case.way, one_case.depth);
      ASSERT_GT(whole.side, 0.02) << rate << " Hz, case " << &one_case - cases.data();
      EXPECT_NEAR(seam.side, whole.side, 0.02 * whole.side) << rate << " Hz, case " << &one_case - cases.data();
      EXPECT_NEAR(seam.press, whole.press, 0.02 * whole.press) << rate << " Hz, case " << &one_case - cases.data();
    }
  }
}

/// Where a ball of 10 mm rests that a hand presses onto `floor` from `side` (1: above), and with what force.
std::pair<double, double> restsOn(const geometry::TriangleMesh& floor, double side, const dvec3& at = dvec3(0.0)) {
  std::vector<workcell::Entity> cell{
      test::solid(1, "floor", floor),
      test::solid(2, "ball", geometry::makeSphere(0.01), Pose::translation(at + dvec3(0, 0, 0.03 * side)))};
  auto options = sessionOf(cell, "ball",
                           handThrough({{0.0, {0, 0, 0.02 * side}},
                                        {1.3, {0, 0, 0.02 * side}},
                                        {2.3, {0, 0, -0.01 * side}},
                                        {3.3, {0, 0, -0.01 * side}}}),
                           60.0, 0.01);
  options.moved_by = *parseMovedBy("self_origin");
  options.axes.mode = AxesMode::kCell;
  options.scale = {ScaleLevel::kNumber, 1.0};
  options.configuration.manipulation.safety_distance = 0.0;
  std::pair<double, double> found{0.0, 0.0};
  double jump = 0.0;
  double before = 0.03;
  const auto report = runSession(options, [&](const TraceRow& row) {
    const double now = side * row.X_WM.p.z;
    if (row.t > 0.2) jump = std::max(jump, std::abs(now - std::exchange(before, now)));
    found = {now, side * row.force_D.z};
  });
  EXPECT_TRUE(report) << report.error().message();
  EXPECT_LT(jump, 0.003) << "nothing pulls through the air";
  return found;
}

geometry::TriangleMesh insideOut(geometry::TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TEST(SessionFeel, AMeshIsFeltWhicheverWayItsTrianglesTurn) {
  geometry::TriangleMesh box = geometry::makeBox({0.4, 0.4, 0.04});
  for (dvec3& v : box.vertices) v.z -= 0.02;
  const auto right = restsOn(box, 1.0);
  EXPECT_NEAR(right.first, 0.01, 1e-4);
  EXPECT_GT(right.second, 2.0);
  const auto inward = restsOn(insideOut(box), 1.0);
  EXPECT_NEAR(inward.first, right.first, 1e-6);
  EXPECT_NEAR(inward.second, right.second, 1e-3);
  // Two bodies of one mesh, the second inside out.
  geometry::TriangleMesh two = box;
  geometry::append(two, insideOut(box), Pose::translation({0.5, 0, 0}));
  const auto second = restsOn(two, 1.0, {0.5, 0, 0});
  EXPECT_NEAR(second.first, right.first, 1e-4);
  EXPECT_NEAR(second.second, right.second, 0.02);
}

TEST(SessionFeel, ASheetIsFeltFromEitherSide) {
  const geometry::TriangleMesh sheet{{{-0.2, -0.2, 0}, {0.2, -0.2, 0}, {0.2, 0.2, 0}, {-0.2, 0.2, 0}},
                                     {{0, 1, 2}, {0, 2, 3}}};
  for (const geometry::TriangleMesh& mesh : {sheet, insideOut(sheet)}) {
    for (const double side : {1.0, -1.0}) {
      const auto [z, force] = restsOn(mesh, side);
      EXPECT_NEAR(z, 0.01, 1e-4) << side;
      EXPECT_GT(force, 2.0) << side;
    }
  }
}

}  // namespace
}  // namespace hapticell::manipulation
