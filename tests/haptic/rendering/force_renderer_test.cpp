// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/force_renderer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "feel/scene.h"

namespace hapticell::haptic {
namespace {

using feel::planeConstraint;

constexpr double kTick = 0.001;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ConstraintSet floorSet(std::uint64_t sequence, double height = 0.0, const dvec3& reference = dvec3(0.0)) {
  ConstraintSet set;
  set.sequence = sequence;
  set.X_DR = Pose::translation(reference);
  set.count = 1;
  set.constraints[0] = planeConstraint(dvec3(0, 0, height), dvec3(0, 0, 1), set.X_DR, 0);
  return set;
}

Pose at(double x, double y, double z) {
  return Pose::translation(dvec3(x, y, z));
}

/// Moves in steps that a hand makes, then waits until filters have settled.
RenderResult moveTo(ForceRenderer& renderer, const dvec3& from, const dvec3& to, int ticks = 200, int wait = 200) {
  RenderResult result;
  for (int i = 1; i <= ticks; ++i) {
    result = renderer.tick(Pose::translation(glm::mix(from, to, static_cast<double>(i) / ticks)), kTick);
  }
  for (int i = 0; i < wait; ++i) result = renderer.tick(Pose::translation(to), kTick);
  return result;
}

TEST(LimitedByDelay, followsTheTrialsTable) {
  RendererOptions options;
  options.stiffness = 5000.0;
  EXPECT_NEAR(limitedByDelay(options).stiffness, 1495.0, 1e-9);
  options.delay = 0.003;
  EXPECT_NEAR(limitedByDelay(options).stiffness, 498.3, 0.1);
  EXPECT_EQ(limitedByDelay(options).damping, 4.0);
  options = {};
  EXPECT_EQ(limitedByDelay(options).stiffness, 1000.0);
  EXPECT_EQ(limitedByDelay(options).damping, 2.0);
  options.stiffness = kNan;
  options.damping = -1.0;
  EXPECT_EQ(limitedByDelay(options).stiffness, 1000.0);
  EXPECT_EQ(limitedByDelay(options).damping, 2.0);
}

TEST(ForceRenderer, followsTheStylusWithoutASet) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0));
  const RenderResult result = renderer.tick(at(0.3, 0.1, -0.2), kTick);
  EXPECT_EQ(result.X_DP.p, dvec3(0.3, 0.1, -0.2));
  EXPECT_EQ(result.force_D, dvec3(0.0));
}

TEST(ForceRenderer, pushesOutOfAFloorWithItsStiffness) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ASSERT_EQ(renderer.adopt(floorSet(1)), Adoption::kAdopted);
  const RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0.01, 0, -0.002));
  EXPECT_NEAR(result.force_D.z, 2.0, 1e-3);
  EXPECT_NEAR(result.force_D.x, 0.0, 1e-9);
  EXPECT_NEAR(result.X_DP.p.z, 0.0, 1e-8);
  EXPECT_NEAR(result.X_DP.p.x, 0.01, 1e-9);
  EXPECT_TRUE(result.contact);
  EXPECT_FALSE(result.at_zone_edge);
  EXPECT_EQ(result.active_rows, 1u);
  EXPECT_EQ(result.adopted_set, 1u);
}

TEST(ForceRenderer, neverPulls) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.001));
  for (int i = 0; i < 30; ++i) {  // Out at 0.1 m/s: the damper alone would hold back.
    const RenderResult result = renderer.tick(at(0, 0, -0.001 + 1e-4 * i), kTick);
    EXPECT_GE(result.force_D.z, 0.0);
  }
}

TEST(ForceRenderer, refusesSetsThatDoNotFit) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  EXPECT_EQ(renderer.adopt(floorSet(5)), Adoption::kAdopted);
  renderer.tick(at(0, 0, 0.005), kTick);
  EXPECT_EQ(renderer.adopt(floorSet(4)), Adoption::kOutdated);
  EXPECT_EQ(renderer.adopt(floorSet(6, 0.0, dvec3(0.1, 0, 0))), Adoption::kOutsideZone);
  ConstraintSet bad = floorSet(7);
  bad.constraints[0].curvature[3] = kNan;
  EXPECT_EQ(renderer.adopt(bad), Adoption::kMalformed);
  EXPECT_EQ(renderer.tick(at(0, 0, 0.005), kTick).adopted_set, 5u);
}

TEST(ForceRenderer, blendsANewSetInsteadOfSteppingAndLetsNobodyPayForIt) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.001));
  const double before = result.force_D.z;
  renderer.adopt(floorSet(2, 0.002));  // The floor was 2 mm higher all along: 2 N more, but not at once.
  double last = before, largest = 0.0;
  for (int i = 0; i < 14000; ++i) {
    result = renderer.tick(at(0, 0, -0.001), kTick);
    largest = std::max(largest, std::abs(result.force_D.z - last));
    last = result.force_D.z;
    // The hand rests, so what the spring holds more than before was paid by nobody: 0.2 mJ and 0.3 mJ a second.
    const double stored = last * last / 2000.0, had = before * before / 2000.0;
    ASSERT_LE(stored, had + 2e-4 + 3e-4 * kTick * (i + 2));
  }
  EXPECT_LE(largest, 0.0501);
  EXPECT_NEAR(last, before + 2.0, 1e-3);
  EXPECT_EQ(result.offset_D, dvec3(0.0));
}

/// Presses 1 mm deep and gets a set that lies 2 mm higher, which the force does not follow at once.
RenderResult pressOnARisingFloor(ForceRenderer& renderer, double friction) {
  const auto floor = [&](std::uint64_t sequence, double height) {
    ConstraintSet set = floorSet(sequence, height);
    set.constraints[0].friction = friction;
    return set;
  };
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floor(1, 0.0));
  moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.001));
  renderer.adopt(floor(2, 0.002));
  return moveTo(renderer, dvec3(0, 0, -0.001), dvec3(0, 0, -0.001));
}

/// The facts' M9: |offset| K / 0.05 N ms, as soon as somebody pays: here friction takes 10 mJ and more a second.
TEST(ForceRenderer, comesToItsTrueForceAsFastAsAHandThatRubsPaysForIt) {
  ForceRenderer renderer;
  RenderResult result = pressOnARisingFloor(renderer, 0.3);
  EXPECT_LT(result.spring_D.z, 1.5);
  const double held_back = 3.0 - result.spring_D.z;
  for (int i = 1; i <= 1000; ++i) {
    result = renderer.tick(at(0.02 * std::sin(8.0 * i * kTick), 0, -0.001), kTick);
    // As fast as it may where sets come slowly, in 0.8 of the time between two sets, until friction turns round.
    if (i < 150) {
      EXPECT_GE(result.spring_D.z, 3.0 - 1.1 * held_back * std::exp(-i / 160.0)) << i;
    }
  }
  EXPECT_NEAR(result.spring_D.z, 3.0, 0.03);
}

TEST(ForceRenderer, isTrueAgainAfterTheHandLiftedByWhatWasHeldBack) {
  for (const double speed : {0.02, 0.1, 0.4}) {
    ForceRenderer renderer;
    RenderResult result = pressOnARisingFloor(renderer, 0.0);
    const double held_back = glm::length(result.offset_D);
    for (double z = -0.001; z < 0.0018; z += speed * kTick) {
      result = renderer.tick(at(0, 0, z), kTick);
      EXPECT_GE(result.spring_D.z, -1e-3) << "a pull at " << speed;
      EXPECT_LE(glm::length(result.offset_D), held_back + 0.2e-3);
    }
    for (int i = 0; i < 1000; ++i) result = renderer.tick(at(0, 0, 0.0018), kTick);
    EXPECT_NEAR(result.spring_D.z, 0.2, 2e-3) << speed;
  }
}

/// A lever of 100 mm that the wrist turns into the floor by 6 mm, the hand at rest: no device of three driven axes
/// feels the turn, so nobody pays.
TEST(ForceRenderer, aTurnOfTheWristPaysForNothing) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.001));
  ConstraintSet set = floorSet(1);
  set.constraints[0] = feel::bodyPointConstraint(dvec3(0.1, 0, 0), 0.0, dvec3(0, 0, 1), set.X_DR);
  renderer.adopt(set);
  RenderResult result;
  for (int i = 1; i <= 2000; ++i) {
    const double angle = 0.07 * std::min(1.0, i / 500.0);
    result = renderer.tick({dvec3(0, 0, 0.001), quaternionFromRotationVector(dvec3(0, angle, 0))}, kTick);
    ASSERT_LE(glm::dot(result.spring_D, result.spring_D) / 2000.0, 2e-4 + 3e-4 * kTick * (i + 1));
  }
  EXPECT_GT(result.spring_D.z, 0.8) << "it is felt, a little";
}

/// Sets that say something else each time, a hand that rows about in them: by force alone no second makes a millijoule.
TEST(ForceRenderer, makesNoEnergyOutOfWrongSets) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> height(-0.003, 0.003), slope(-0.3, 0.3);
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  std::vector<double> balance;
  double work = 0.0;
  dvec3 p_last(0, 0, 0.005), force(0.0);
  for (int i = 0; i < 20000; ++i) {
    const double t = i * kTick;
    if (i % 50 == 0) {
      ConstraintSet set = floorSet(static_cast<std::uint64_t>(i + 1), 0.0, renderer.proxy().p);
      const dvec3 up = glm::normalize(dvec3(slope(random), slope(random), 1.0));
      set.constraints[0] = planeConstraint(dvec3(0, 0, height(random)), up, set.X_DR, 0);
      renderer.adopt(set);
    }
    const dvec3 p(0.01 * std::sin(3.0 * t), 0.01 * std::cos(2.0 * t), 0.002 - 0.006 * std::sin(5.0 * t));
    const RenderResult result = renderer.tick(Pose::translation(p), kTick);
    work -= glm::dot(force, p - p_last);
    p_last = p;
    force = result.force_D;
    balance.push_back(work - glm::dot(result.spring_D, result.spring_D) / 2000.0);
  }
  double least = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < balance.size(); ++i) {
    for (std::size_t j = i; j < std::min(balance.size(), i + 1000); j += 7)
      least = std::min(least, balance[j] - balance[i]);
    largest = std::max(largest, balance[i]);
  }
  EXPECT_GE(least, -0.7e-3);
  EXPECT_GT(largest, 2e-3) << "the hand must have worked";
}

TEST(ForceRenderer, aProxyThatIsOnlyLatePullsAtNobody) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.010));
  ConstraintSet small = floorSet(1, 0.0, dvec3(0, 0, 0.010));
  small.zone_radius = 0.002;
  renderer.adopt(small);
  moveTo(renderer, dvec3(0, 0, 0.010), dvec3(0, 0, 0.030));  // Far out of the zone: its edge holds the proxy back.
  ConstraintSet wide = floorSet(2, 0.0, dvec3(0, 0, 0.012));
  renderer.adopt(wide);
  for (int i = 0; i < 300; ++i) {
    // Nothing is near, so nothing may push the hand on its way up, however long the proxy needs to come.
    EXPECT_LE(renderer.tick(at(0, 0, 0.030), kTick).force_D.z, 1e-9) << i;
  }
}

TEST(ForceRenderer, dropsAForceThatANewSetTakesAwaySlowlyThenExactly) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.004));
  ConstraintSet empty = floorSet(2);
  empty.count = 0;
  renderer.adopt(empty);
  double last = result.force_D.z;
  int ticks = 0;
  while (result.force_D != dvec3(0.0) && ticks < 1000) {
    result = renderer.tick(at(0, 0, -0.004), kTick);
    EXPECT_LE(std::abs(result.force_D.z - last), 0.0501);
    last = result.force_D.z;
    ++ticks;
  }
  EXPECT_LE(ticks, 150);
}

TEST(ForceRenderer, holdsTheProxyInTheZoneWithLittleForce) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0));
  ConstraintSet set = floorSet(1, -1.0);
  set.zone_radius = 0.02;
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0.0), dvec3(0.06, 0, 0));
  EXPECT_TRUE(result.at_zone_edge);
  EXPECT_FALSE(result.contact);
  EXPECT_NEAR(result.X_DP.p.x, 0.02, 1e-6);
  EXPECT_NEAR(glm::length(result.force_D), 0.8, 1e-6);
}

TEST(ForceRenderer, keepsTheProxyOffAFloorMetFarOutsideTheZone) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ConstraintSet set = floorSet(1);
  set.zone_radius = 0.02;
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0.1, 0, -0.05));
  EXPECT_GE(result.X_DP.p.z, -1e-7);
}

TEST(ForceRenderer, feelsAGroupAsOrAndGroupsAsAnd) {
  // A block x < 0, z < 0: above it or beside it is free.
  for (const bool together : {true, false}) {
    ForceRenderer renderer;
    renderer.reset(at(0.005, 0, -0.005));  // Beside the block, under its top's level.
    ConstraintSet set;
    set.sequence = 1;
    set.X_DR = at(0.005, 0, -0.005);
    set.count = 2;
    set.constraints[0] = planeConstraint(dvec3(0.0), dvec3(0, 0, 1), set.X_DR, 0);
    set.constraints[1] = planeConstraint(dvec3(0.0), dvec3(1, 0, 0), set.X_DR, together ? 0 : 1);
    renderer.adopt(set);
    RenderResult result;
    for (int i = 0; i < 300; ++i) result = renderer.tick(at(0.005, 0, -0.005), kTick);
    EXPECT_EQ(result.contact, !together);
    EXPECT_NEAR(result.X_DP.p.z, together ? -0.005 : 0.0, 1e-6);
  }
}

TEST(ForceRenderer, endsACurvedFaceAtItsTrim) {
  // The floor ends at x = 0: beyond, the trim's smaller value says how far inside x < 0 one is.
  ConstraintSet set = floorSet(1, 0.0, dvec3(0, 0, 0.005));
  set.constraints[0].has_trim = true;
  set.constraints[0].trim_gap = 0.0;
  set.constraints[0].trim_gradient = {-1, 0, 0, 0, 0, 0};
  Constraint other = planeConstraint(dvec3(0, 0, -0.01), dvec3(0, 0, 1), set.X_DR, 0);
  set.constraints[set.count++] = other;
  ForceRenderer renderer;
  renderer.reset(at(-0.005, 0, 0.005));
  renderer.adopt(set);
  // Free = (z > 0 and x < 0) or z > -10 mm: the second face alone bounds.
  const RenderResult result = moveTo(renderer, dvec3(-0.005, 0, 0.005), dvec3(0.01, 0, -0.012));
  EXPECT_NEAR(result.X_DP.p.z, -0.01, 1e-6);
}

TEST(ForceRenderer, holdsAGuideFromBothSides) {
  for (const double side : {-0.003, 0.003}) {
    ConstraintSet set = floorSet(1);
    set.constraints[0].kind = ConstraintKind::kEquality;
    ForceRenderer renderer;
    renderer.reset(at(0, 0, 0));
    renderer.adopt(set);
    const RenderResult result = moveTo(renderer, dvec3(0.0), dvec3(0.02, 0, side));
    EXPECT_NEAR(result.X_DP.p.z, 0.0, 1e-6);
    EXPECT_NEAR(result.force_D.z, -1000.0 * side, 0.01);
  }
}

TEST(ForceRenderer, turnsTheProxyInsteadOfPushingWhereTurningIsEasier) {
  // A point 100 mm out on the body meets a floor: with the lever of 50 mm the proxy gives way by turning.
  ConstraintSet set;
  set.sequence = 1;
  set.X_DR = at(0, 0, 0);
  set.count = 1;
  set.constraints[0].gap = 0.001;
  set.constraints[0].gradient = {0, 0, 1, 0, -0.1, 0};  // n = z, rho = (0.1, 0, 0): rho x n = (0, -0.1, 0).
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0));
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0.0), dvec3(0, 0, -0.006));
  const dvec3 turned = rotationVector(result.X_DP.q);
  const dvec3 point = result.X_DP * dvec3(0.1, 0, 0);
  EXPECT_LT(turned.y, -0.01);
  EXPECT_NEAR(point.z, -0.001, 0.1e-3) << "the point stays on the floor (without curvature: to second order)";
  // Nearest in the metric: 5 mm missing, shared 1 : 4 between shift and turn.
  EXPECT_NEAR(result.X_DP.p.z, -0.006 + 0.001, 0.2e-3);
}

TEST(ForceRenderer, softensWhereTheMaterialAsksForIt) {
  ConstraintSet set = floorSet(1);
  set.constraints[0].stiffness = 400.0;
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(set);
  const RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.002), 200, 400);
  EXPECT_NEAR(result.force_D.z, 0.8, 1e-3);
}

TEST(ForceRenderer, survivesWrongPosesAndTimes) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.001));
  Pose bad = at(0, 0, -0.001);
  bad.p.x = kNan;
  for (const double dt : {kTick, 0.0, -1.0, kNan, 1e9}) {
    const RenderResult result = renderer.tick(bad, dt);
    EXPECT_TRUE(std::isfinite(glm::length(result.force_D)));
    EXPECT_NEAR(result.X_DP.p.z, 0.0, 1e-6);
  }
  EXPECT_NEAR(moveTo(renderer, dvec3(0, 0, -0.001), dvec3(0, 0, -0.001)).force_D.z, 1.0, 1e-3);
}

TEST(ForceRenderer, dampsWhatAnOverCurvedSetMakes) {
  // The obstacle is told too curved, so that every new set pushes the hand along: the observer sees it, damping
  // answers.
  ForceRenderer renderer;
  renderer.reset(at(-0.03, 0, 0.001));
  double most = 0.0, x = -0.03;
  for (int i = 0; i < 600; ++i, x += 1e-4) {
    if (i % 100 == 0) {
      const double height = 0.0004 * i / 100.0;  // Each set 0.4 mm higher than the one before.
      renderer.adopt(floorSet(static_cast<std::uint64_t>(i) + 1, height, renderer.proxy().p));
    }
    // A hand that lets itself be lifted.
    const double z = std::max(-0.002 + 4e-6 * i, -0.002);
    most = std::max(most, renderer.tick(at(x, 0, z), kTick).controller_damping);
  }
  EXPECT_GT(most, 1.0);
  EXPECT_LE(most, 5.0);
}

TEST(StoredEnergy, isTheWorkOfReleasingALimitedSpring) {
  // Integrated along the release: min(K s, limit) ds.
  for (const double limit : {1.5, 6.4, 100.0}) {
    double work = 0.0;
    const double stretch = 0.012, step = 1e-6;
    for (double s = 0.5 * step; s < stretch; s += step) work += std::min(1000.0 * s, limit) * step;
    EXPECT_NEAR(storedEnergy(1000.0 * stretch, 1000.0, limit), work, 1e-7);
  }
}

TEST(ForceRenderer, takesADeratedForceForNoLoss) {
  // Pressed 8 mm deep against a force that the safety chain holds at 1.4 N, slid and released: nobody made energy.
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  RenderResult result;
  for (int i = 0; i < 3000; ++i) {
    const double z = 0.005 - 0.013 * std::sin(M_PI * i / 3000.0);
    result = renderer.tick(at(0, 0, z), kTick);
    const double size = glm::length(result.force_D);
    renderer.noteApplied(size > 1.4 ? result.force_D * (1.4 / size) : result.force_D);
    EXPECT_EQ(result.controller_damping, 0.0) << i;
    EXPECT_GT(result.energy, -0.2e-3) << i;
  }
}

RC_GTEST_PROP(ForceRendererProperty, keepsTheProxyOutOfRandomConvexBlocks, ()) {
  // Half-spaces of one group through a sphere's surface: the proxy may touch but not enter.
  const auto seed = *rc::gen::arbitrary<unsigned>();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> spread(-1.0, 1.0);
  const auto direction = [&] { return glm::normalize(dvec3(spread(random), spread(random), spread(random) + 1e-6)); };
  std::array<dvec3, 12> normals;
  for (dvec3& normal : normals) normal = direction();
  const auto depth = [&](const dvec3& p) {
    double least = 1.0;
    for (const dvec3& n : normals) least = std::min(least, 0.01 - glm::dot(n, p));
    return least;
  };
  ForceRenderer renderer;
  dvec3 p = 0.03 * direction();
  while (depth(p) > -0.002) p = 0.05 * direction();
  renderer.reset(Pose::translation(p));
  for (int i = 0; i < 1500; ++i) {
    if (i % 50 == 0) {
      ConstraintSet set;
      set.sequence = static_cast<std::uint64_t>(i) + 1;
      set.X_DR = renderer.proxy();
      set.count = normals.size();
      for (std::size_t k = 0; k < set.count; ++k) {
        set.constraints[k] = planeConstraint(0.01 * normals[k], normals[k], set.X_DR, 0);
      }
      renderer.adopt(set);
    }
    p += 4e-4 * direction() - 0.004 * p * (i % 300 < 150 ? 1.0 : -0.5);
    const RenderResult result = renderer.tick(Pose::translation(p), kTick);
    RC_ASSERT(depth(result.X_DP.p) <= 1e-7);
  }
}

/// Least change of work less |F|^2 / 2K that a hand sees which follows `points` at `speed`, J.
double leastEnergyAlong(ForceRenderer& renderer, const std::vector<dvec3>& points, double speed) {
  double balance = 0.0, highest = 0.0, least = 0.0;
  dvec3 force(0.0), last = points.front();
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double length = glm::distance(points[k], points[k + 1]);
    const int ticks = static_cast<int>(std::ceil(length / (speed * kTick)));
    for (int i = 1; i <= ticks; ++i) {
      const dvec3 p = glm::mix(points[k], points[k + 1], static_cast<double>(i) / ticks);
      const double stored = glm::dot(force, force) / 2000.0;
      const RenderResult result = renderer.tick(Pose::translation(p), kTick);
      balance -= glm::dot(0.5 * (force + result.force_D), p - last);
      balance += stored - glm::dot(result.force_D, result.force_D) / 2000.0;
      force = result.force_D;
      last = p;
      highest = std::max(highest, balance);
      least = std::min(least, balance - highest);
    }
  }
  return least;
}

TEST(ForceRenderer, slidesOnWithFrictionHoweverFarTheProxyIsBehind) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ConstraintSet set = floorSet(1);
  set.zone_radius = 1.0;
  set.constraints[0].friction = 0.15;
  ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
  moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.030));
  const RenderResult result = moveTo(renderer, dvec3(0, 0, -0.030), dvec3(0.2, 0, -0.030), 200, 100);
  EXPECT_NEAR(result.X_DP.p.x, 0.2 - 0.15 * 0.030, 1e-4);
}

TEST(ForceRenderer, givesBackNoMoreThanItsSpringHoldsFromTooDeep) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ASSERT_EQ(renderer.adopt(floorSet(1)), Adoption::kAdopted);
  const std::vector<dvec3> path{{0, 0, 0.005}, {0, 0, -0.020}, {0.02, 0, -0.025}, {0.02, 0.01, 0.005}};
  EXPECT_GE(leastEnergyAlong(renderer, path, 0.3), -1e-3);
}

/// Round a post, deeper than the motors can push: the rest point that has yielded must turn with the surface.
TEST(ForceRenderer, yieldsRoundACurveWithoutDrivingTheHand) {
  ConstraintSet set;
  set.sequence = 1;
  set.zone_radius = 1.0;
  set.count = 1;
  set.X_DR = Pose::translation(dvec3(0.050, 0, 0));
  set.constraints[0] = planeConstraint(dvec3(0.050, 0, 0), dvec3(1, 0, 0), set.X_DR, 0);
  for (const std::size_t xx : {0u, 6u}) set.constraints[0].curvature[xx] = 1.0 / 0.050;
  ForceRenderer renderer;
  renderer.reset(at(0.055, 0, 0));
  ASSERT_EQ(renderer.adopt(set), Adoption::kAdopted);
  std::vector<dvec3> path{{0.055, 0, 0}};
  for (double angle = 0.0; angle < 0.6; angle += 0.01) {
    path.emplace_back(0.036 * std::cos(angle), 0.036 * std::sin(angle), 0.0);
  }
  path.emplace_back(0.055 * std::cos(0.6), 0.055 * std::sin(0.6), 0.0);
  EXPECT_GE(leastEnergyAlong(renderer, path, 0.1), -1e-3);
}

}  // namespace
}  // namespace hapticell::haptic
