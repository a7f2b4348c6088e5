// SPDX-License-Identifier: Apache-2.0
#include "manipulation/engine/manipulation_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/manipulation/session/hand_link.h"
#include "tests/manipulation/session/test_cells.h"

namespace hapticell::manipulation {
namespace {

using test::HandLink;

class EngineTest : public testing::Test {
 protected:
  EngineTest() : engine(link, {}) {
    engine.apply(command::SetDocument{test::boxOverTable(0.02), {}});
    engine.apply(command::ChooseEntity{2});
  }
  void moveTo(const dvec3& p, std::uint32_t buttons = 0) {
    link.state.X_DS.p = link.state.X_DP.p = p;
    link.state.buttons = buttons;
    now += 10'000'000;
    engine.step(now);
  }
  void click(const dvec3& p) {
    moveTo(p, 1);
    moveTo(p, 0);
  }
  dvec3 box() const { return engine.placement(2).X_WE.p; }

  HandLink link;
  ManipulationEngine engine;
  std::int64_t now = 0;
};

/// The box deep in the table: how it is told, and that it can be led out.
void leadsOut(std::vector<workcell::Entity> entities, const std::string& told, const dvec3& way) {
  HandLink link;
  ManipulationEngine engine(link, {});
  engine.apply(command::SetDocument{std::move(entities), {}});
  engine.apply(command::Grab{2});
  ASSERT_NE(engine.held(), nullptr);
  ASSERT_EQ(engine.held()->notes().size(), 1U);
  const std::string note = english(engine.held()->notes()[0]);
  EXPECT_NE(note.find(told), std::string::npos) << note;
  std::int64_t now = 0;
  const dvec3 start = engine.placement(2).X_WE.p;
  const auto go = [&](const dvec3& to) {
    link.state.X_DS.p = link.state.X_DP.p = to;
    engine.step(now += 10'000'000);
  };
  for (int i = 0; i <= 10; ++i) go(-1e-3 * i * way);
  EXPECT_GT(glm::dot(engine.placement(2).X_WE.p - start, way), -1e-4) << "it gets no deeper";
  for (int i = -10; i <= 80; ++i) go(1e-3 * i * way);
  EXPECT_NEAR(glm::dot(engine.placement(2).X_WE.p - start, way), 0.08, 1e-3) << "it came out";
  for (int i = 80; i >= 0; --i) go(1e-3 * i * way);
  EXPECT_GT(glm::dot(engine.placement(2).X_WE.p - start, way), 0.054) << "and does not go in again";
}

TEST(StartInside, ASolidComesOutTheShortestWay) {
  leadsOut(test::boxOverTable(-0.055), "box starts inside table, 55.0 mm deep: it comes free along (0.00, 0.00, 1.00)",
           {0, 0, 1});
}

TEST(StartInside, AnOpenSoupIsToldByItsWindingNumber) {
  auto entities = test::boxOverTable(-0.07);  // Its top is 10 mm under the table's: no triangles meet.
  geometry::TriangleMesh open = *entities[0].mesh();
  open.triangles.pop_back();
  entities[0].body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(open)};
  HandLink link;
  ManipulationEngine engine(link, {});
  engine.apply(command::SetDocument{entities, {}});
  engine.apply(command::Grab{2});
  ASSERT_NE(engine.held(), nullptr);
  // Nothing touches, so nothing is told; the surface is met from its inner side.
  EXPECT_TRUE(engine.held()->notes().empty());
  entities = test::boxOverTable(-0.055);
  entities[0].body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(open)};
  leadsOut(entities, "(an open mesh: judged by its winding number)", {0, 0, 1});
}

/// A rug of needles, 0.7 mm apart: no 64 entries tell what a plate meets of it.
geometry::TriangleMesh needles(int side) {
  geometry::TriangleMesh rug;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> height(-2e-4, 0.0);
  const int middle = side / 2;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      const dvec3 tip(7e-4 * (i - middle), 7e-4 * (k - middle), height(random));
      const auto first = static_cast<std::uint32_t>(rug.vertices.size());
      for (const dvec3& corner :
           {dvec3(0.0), dvec3(2e-4, 0, -3e-3), dvec3(-1e-4, 2e-4, -3e-3), dvec3(-1e-4, -2e-4, -3e-3)})
        rug.vertices.push_back(tip + corner);
      rug.triangles.insert(rug.triangles.end(), {{first, first + 1, first + 2},
                                                 {first, first + 2, first + 3},
                                                 {first, first + 3, first + 1},
                                                 {first + 1, first + 3, first + 2}});
    }
  }
  return rug;
}

TEST(Engine, SaysWhereAMeshIsTooDenseForAllContacts) {
  HandLink link;
  ManipulationEngine engine(link, {});
  auto entities = test::boxOverTable(0.004);
  entities[0] = test::solid(1, "rug", needles(60));
  engine.apply(command::SetDocument{std::move(entities), {}});
  engine.apply(command::Grab{2});
  ASSERT_NE(engine.held(), nullptr);
  std::int64_t now = 0;
  for (int i = 0; i <= 30; ++i) {
    link.state.X_DS.p = link.state.X_DP.p = {0, 0, std::max(-0.0045, -2e-4 * i)};
    engine.step(now += 10'000'000);
  }
  EXPECT_GT(engine.placement(2).X_WE.p.z, 0.03) << "it still stops";
  int told = 0;
  for (const Result& result : engine.takeResults()) {
    const auto* notice = std::get_if<result::Notice>(&result);
    told += notice != nullptr && english(notice->sentence).find("box against rug: the meshes are too dense") == 0;
  }
  EXPECT_EQ(told, 1);
}

TEST_F(EngineTest, ButtonTakesAndLetsGo) {
  moveTo({0, 0, 0});
  moveTo({0.01, 0, 0});
  EXPECT_EQ(engine.held(), nullptr);
  click({0.01, 0, 0});
  ASSERT_NE(engine.held(), nullptr);
  moveTo({0.03, 0, 0});
  EXPECT_NEAR(box().x, 0.02, 1e-12);
  click({0.03, 0, 0});
  EXPECT_EQ(engine.held(), nullptr);
  moveTo({0.05, 0, 0});
  EXPECT_NEAR(box().x, 0.02, 1e-12);
  const std::vector<Result> results = engine.takeResults();
  ASSERT_EQ(results.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<result::Grabbed>(results[0]));
  EXPECT_NEAR(std::get<result::Moved>(results[1]).X_WE.p.x, 0.02, 1e-12);
}

TEST_F(EngineTest, ClutchMovesTheHandWithoutTheEntity) {
  click({0, 0, 0});
  moveTo({0.01, 0, 0});
  engine.apply(command::SetClutch{true});
  moveTo({0.05, 0.02, 0.01});
  EXPECT_NEAR(box().x, 0.01, 1e-12);
  engine.apply(command::SetClutch{false});
  moveTo({0.05, 0.02, 0.01});
  EXPECT_NEAR(box().x, 0.01, 1e-12);
  moveTo({0.06, 0.02, 0.01});
  EXPECT_NEAR(box().x, 0.02, 1e-12);
  EXPECT_NEAR(box().y, 0.0, 1e-12);
}

TEST_F(EngineTest, SetIsSentBeforeTouchAboutTheAcceptedPose) {
  click({0, 0, 0});
  moveTo({0, 0, -0.01});
  moveTo({0, 0, -0.01});
  now += 200'000'000;
  moveTo({0, 0, -0.01});
  ASSERT_TRUE(haptic::isWellFormed(link.set));
  EXPECT_NEAR(link.set.X_DR.p.z, -0.01, 1e-9);
  // 10 mm are left to the table, 1 mm of that is the safety distance.
  const auto table = std::find_if(link.set.active().begin(), link.set.active().end(), [](const auto& c) {
    return c.gradient[2] > 0.999 && std::abs(c.gap - 0.009) < 1e-5;
  });
  EXPECT_NE(table, link.set.active().end());
  EXPECT_GT(link.set.zone_radius, 0.02);
}

TEST_F(EngineTest, AProxyThatJumpsThroughTheTableIsNotFollowed) {
  click({0, 0, 0});
  moveTo({0.04, 0, -0.06});
  EXPECT_GT(box().z, 0.03);
  EXPECT_NEAR(box().x, 0.04, 1e-3);  // It slid.
}

TEST_F(EngineTest, DocumentChangeKeepsWhatIsHeld) {
  click({0, 0, 0});
  moveTo({0.01, 0, 0});
  engine.apply(command::SetDocument{test::boxOverTable(0.02), {}});
  ASSERT_NE(engine.held(), nullptr);
  EXPECT_NEAR(box().x, 0.01, 1e-12);
  moveTo({0.02, 0, 0});
  EXPECT_NEAR(box().x, 0.02, 1e-12);
  engine.apply(command::SetDocument{{test::boxOverTable(0.02)[0]}, {}});
  EXPECT_EQ(engine.held(), nullptr);
}

TEST_F(EngineTest, ARuleGivenWhileDraggingCountsAtOnce) {
  click({0, 0, 0});
  ASSERT_NE(engine.held(), nullptr);
  const std::size_t all = engine.held()->pairs().size();
  ASSERT_GT(all, 0u);
  workcell::PairRule rule{.first = "table", .second = "box", .on_contact = workcell::OnContact::kPass};
  engine.apply(command::SetDocument{test::boxOverTable(0.02), workcell::PairPolicy({}, {rule})});
  moveTo({0, 0, 0});
  ASSERT_EQ(engine.held()->pairs().size(), all);
  EXPECT_EQ(engine.held()->pairs()[0].on_contact, workcell::OnContact::kPass);
  rule.checked = false;
  engine.apply(command::SetDocument{test::boxOverTable(0.02), workcell::PairPolicy({}, {rule})});
  moveTo({0, 0, 0});
  ASSERT_NE(engine.held(), nullptr) << "it is still held";
  EXPECT_EQ(engine.held()->pairs().size(), all - 1);
}

TEST_F(EngineTest, TipTakesWhatItTouches) {
  engine.apply(command::ChooseEntity{0});
  moveTo({0.0, 0.0, 0.0});
  command::SetCamera camera;
  camera.p_WFocus = {0, 0, 0.084};  // 4 mm over the box.
  engine.apply(camera);
  moveTo({0.0, 0.0, 0.0}, 1);
  ASSERT_NE(engine.held(), nullptr);
  EXPECT_EQ(engine.held()->id(), 2U);
}

/// The force loop's tick, by the clock of the program, tells when a contact was felt; each new one anew.
TEST_F(EngineTest, TellsWhenTheNewestContactWasFelt) {
  link.statistics.emplace().clock_offset_ms = 5000.0;  // Its clock is five seconds ahead.
  click({0, 0, 0});
  const auto felt = [this] {
    SceneSnapshot snapshot;
    engine.fillSnapshot(snapshot);
    return snapshot.felt_ns;
  };
  const auto press = [this](double z) {
    link.state.server_stamp_ns = 5'000'000'000 + now + 7'000'000;  // 3 ms before the step.
    moveTo({0, 0, z});
  };
  for (int i = 1; i <= 18; ++i) press(-0.001 * i);
  EXPECT_EQ(felt(), 0) << "nothing was touched";
  std::int64_t first = 0;
  for (int i = 0; i < 20 && engine.contacts().empty(); ++i) press(-0.019), first = now - 3'000'000;
  ASSERT_FALSE(engine.contacts().empty());
  EXPECT_EQ(felt(), first);
  press(-0.019);
  EXPECT_EQ(felt(), first) << "the same contact goes on";
  for (int i = 0; i < 20 && !engine.contacts().empty(); ++i) press(-0.010);
  ASSERT_TRUE(engine.contacts().empty());
  for (int i = 0; i < 20 && engine.contacts().empty(); ++i) press(-0.019);
  EXPECT_GT(felt(), first);
  EXPECT_EQ(felt(), now - 3'000'000);
}

TEST_F(EngineTest, ForcesOfALostServerDoNotComeBackWithTheNext) {
  moveTo({0, 0, 0});
  engine.apply(command::SetForces{true});
  moveTo({0, 0, 0});
  ASSERT_TRUE(link.control.forces_enabled);
  link.state.forces_on = true;
  link.state.force_ramp = 1.0;
  link.state.force_D = dvec3(0, 0, 1);
  moveTo({0, 0, 0});
  const auto shown = [this] {
    SceneSnapshot snapshot;
    engine.fillSnapshot(snapshot);
    return snapshot;
  };
  ASSERT_TRUE(shown().stylus.forces_on);
  link.connected = false;
  moveTo({0, 0, 0});
  EXPECT_FALSE(shown().stylus.forces_on);
  EXPECT_EQ(shown().stylus.force_n, 0.0);
  link.state = {};  // The next server has not been asked for forces.
  link.connected = true;
  moveTo({0, 0, 0});
  EXPECT_FALSE(link.control.forces_enabled) << "what is sent at the new connection";
  EXPECT_FALSE(shown().stylus.forces_on);
}

TEST_F(EngineTest, SnapshotShowsTheNearestPair) {
  click({0, 0, 0});
  moveTo({0, 0, -0.005});
  SceneSnapshot snapshot;
  engine.fillSnapshot(snapshot);
  EXPECT_EQ(snapshot.stylus.held, 2U);
  ASSERT_FALSE(snapshot.pairs.empty());
  EXPECT_NEAR(snapshot.pairs[0].distance, 0.015, 1e-9);
  EXPECT_EQ(english(snapshot.status), "box is 15.0 mm from table");
}

}  // namespace
}  // namespace hapticell::manipulation
