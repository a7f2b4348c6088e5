// SPDX-License-Identifier: Apache-2.0
// What the benchmark is made of: limits, the end of a measurement, ways to render, and scenes of meshes.
#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "feel/figure.h"
#include "feel/mesh_scenes.h"
#include "feel/part_scenes.h"
#include "feel/rendering_way.h"
#include "feel/stop_of_thread.h"

namespace hapticell::feel {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

TEST(Figure, PassesOnTheRightSideOfItsLimitAndNeverAsNoNumber) {
  Figure figure;
  figure.value = 2.0;
  EXPECT_TRUE(figure.pass()) << "only reported";
  figure.limit = 2.0;
  EXPECT_TRUE(figure.pass());
  figure.value = 2.1;
  EXPECT_FALSE(figure.pass());
  figure.at_least = true;
  EXPECT_TRUE(figure.pass());
  figure.value = 1.9;
  EXPECT_FALSE(figure.pass());
  figure.value = kNoNumber;
  for (const bool at_least : {false, true}) {
    figure.at_least = at_least;
    EXPECT_FALSE(figure.pass());
  }
  figure.limit.reset();
  EXPECT_FALSE(figure.pass());
}

TEST(StopOfThread, EndsTheMeasurementOfItsOwnThreadWhileItLives) {
  std::atomic<bool> stop{false};
  EXPECT_NO_THROW(endWhereStopped());
  {
    const StopOfThread outer(&stop);
    EXPECT_NO_THROW(endWhereStopped());
    stop = true;
    EXPECT_THROW(endWhereStopped(), MeasurementStopped);
    {
      const StopOfThread inner(nullptr);
      EXPECT_NO_THROW(endWhereStopped());
    }
    EXPECT_THROW(endWhereStopped(), MeasurementStopped) << "the outer one again";
    std::thread other([] { EXPECT_NO_THROW(endWhereStopped()); });
    other.join();
  }
  EXPECT_NO_THROW(endWhereStopped());
}

TEST(RenderingWay, TheClassicOneSendsTheNearestPlaneAloneAndPushesOutOfIt) {
  const auto corner = cornerScene();
  const Pose X_DS = Pose::translation({0.004, 0.002, -0.001});
  const haptic::ConstraintSet exact = corner->setAt(X_DS, 0.0);
  ASSERT_GE(exact.count, 3u);
  ClassicWay way({});
  way.reset(X_DS);
  const haptic::ConstraintSet sent = way.sent(exact);
  ASSERT_EQ(sent.count, 1u);
  // A millimetre below the floor z = 0; the walls are 4 and 2 mm away.
  EXPECT_NEAR(sent.constraints[0].gap, -0.001, 1e-9);
  const haptic::Vector6& along = sent.constraints[0].gradient;
  EXPECT_LT(glm::length(dvec3(along[0], along[1], along[2]) - dvec3(0.0, 0.0, 1.0)), 1e-9);
  way.offer(sent, 0.0);
  const haptic::RenderResult result = way.tick(X_DS, 1e-3);
  EXPECT_TRUE(result.contact);
  EXPECT_GT(result.stiffness, 0.0);
  EXPECT_LT(glm::length(result.force_D - dvec3(0.0, 0.0, 0.001 * result.stiffness)), 1e-9) << "Hooke's law";
  EXPECT_NEAR(result.X_DP.p.z, 0.0, 1e-12);
  way.reset(X_DS);
  EXPECT_EQ(glm::length(way.tick(X_DS, 1e-3).force_D), 0.0) << "no plane has come since";
}

TEST(RenderingWay, TheProxyIsLookedAtAndGetsTheWholeSet) {
  const auto corner = cornerScene();
  const Pose X_DS = Pose::translation({0.004, 0.002, 0.003});
  ProxyWay way({});
  way.reset(X_DS);
  EXPECT_EQ(way.lookedAt().p, X_DS.p);
  const haptic::ConstraintSet exact = corner->setAt(X_DS, 0.0);
  EXPECT_EQ(way.sent(exact).count, exact.count);
  way.offer(exact, 0.0);
  // Pressed through the floor the stylus goes on, the proxy stays on it.
  const Pose below = Pose::translation({0.004, 0.002, -0.001});
  for (int i = 0; i < 20; ++i) way.tick(below, 1e-3);
  EXPECT_NEAR(way.lookedAt().p.z, 0.0, 1e-5);
}

TEST(MeshScenes, TheHeldBallLiesInItsSphere) {
  const geometry::TriangleMesh ball = heldBall();
  double volume = 0.0;
  for (const auto& t : ball.triangles) {
    const dvec3 &a = ball.vertices[t[0]], &b = ball.vertices[t[1]], &c = ball.vertices[t[2]];
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  for (const dvec3& vertex : ball.vertices) EXPECT_NEAR(glm::length(vertex), kBallRadius, 1e-12);
  const double exact = 4.0 / 3.0 * 3.14159265358979 * kBallRadius * kBallRadius * kBallRadius;
  EXPECT_LT(volume, exact);
  EXPECT_GT(volume, 0.9 * exact) << "closed, outside out";
}

TEST(MeshScenes, EachIsFreeWhereItsHandBegins) {
  const std::vector<std::string> names = meshCaseNames();
  ASSERT_FALSE(names.empty());
  const MeshCase flat = makeMeshCase(names.front());
  EXPECT_EQ(flat.name, names.front());
  EXPECT_EQ(flat.exact->penetration(Pose::translation(flat.exact->start()), 0.0), 0.0);
  // What a client of meshes sees of the wall is what is exactly there: the ball's depth of 0.5 mm.
  const Pose X_DP = Pose::translation({0.002, 0.001, -0.0005});
  EXPECT_NEAR(flat.exact->penetration(X_DP, 0.0), 0.0005, 1e-9);
  const haptic::ConstraintSet seen = flat.mesh->setAt(X_DP, 0.0);
  ASSERT_GE(seen.count, 1u);
  double least = 1.0;
  for (std::size_t i = 0; i < seen.count; ++i) least = std::min(least, seen.constraints[i].gap);
  EXPECT_NEAR(least, -0.0005, 0.00005) << "facets lie inside the ball";
}

TEST(PartScenes, TheBallTouchesEachPartAtTheOriginAndIsAsDeepAsItIsLowered) {
  for (const Part& part : freeFormParts()) {
    SCOPED_TRACE(part.name);
    const MeshCase both = makePartCase(part);
    EXPECT_EQ(both.exact->penetration(Pose::translation(both.exact->start()), 0.0), 0.0);
    EXPECT_LT(both.exact->roundPenetration(Pose::identity(), 0.0), 1e-5);
    // Straight down on a floor that is level, a ridge, or two facets of 4 degrees.
    const Pose lowered = Pose::translation({0.0, 0.0, -0.001});
    EXPECT_NEAR(both.exact->roundPenetration(lowered, 0.0), 0.001, 0.00005);
    EXPECT_LE(both.exact->penetration(lowered, 0.0), both.exact->roundPenetration(lowered, 0.0) + 1e-5);
  }
}

}  // namespace
}  // namespace hapticell::feel
