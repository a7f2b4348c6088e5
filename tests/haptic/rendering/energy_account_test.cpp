// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/energy_account.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "haptic/rendering/passivity.h"
#include "tests/haptic/rendering/rendered_floor.h"

namespace hapticell::haptic {
namespace {

TEST(ForceRendererEnergy, BlendsANewSetInsteadOfSteppingAndLetsNobodyPayForIt) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  RenderResult result = moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.001));
  const double before = result.force_D.z;
  renderer.adopt(floorSet(2, 0.002));  // The floor was 2 mm higher all along: 2 N more, but not at once.
  double last = before, largest = 0.0;
  for (int i = 0; i < 17000; ++i) {
    result = renderer.tick(at(0, 0, -0.001), kTick);
    largest = std::max(largest, std::abs(result.force_D.z - last));
    last = result.force_D.z;
    // The hand rests, so what the spring holds more than before was paid by nobody: 0.15 mJ and 0.25 mJ a second.
    const double stored = last * last / 2000.0, had = before * before / 2000.0;
    ASSERT_LE(stored, had + 1.5e-4 + 2.5e-4 * kTick * (i + 2));
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
TEST(ForceRendererEnergy, ComesToItsTrueForceAsFastAsAHandThatRubsPaysForIt) {
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

TEST(ForceRendererEnergy, IsTrueAgainAfterTheHandLiftedByWhatWasHeldBack) {
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
TEST(ForceRendererEnergy, ATurnOfTheWristPaysForNothing) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.001));
  ConstraintSet set = floorSet(1);
  set.constraints[0] = feel::bodyPointConstraint(dvec3(0.1, 0, 0), 0.0, dvec3(0, 0, 1), set.X_DR);
  renderer.adopt(set);
  RenderResult result;
  for (int i = 1; i <= 2000; ++i) {
    const double angle = 0.07 * std::min(1.0, i / 500.0);
    result = renderer.tick({dvec3(0, 0, 0.001), quaternionFromRotationVector(dvec3(0, angle, 0))}, kTick);
    ASSERT_LE(glm::dot(result.spring_D, result.spring_D) / 2000.0, 1.5e-4 + 2.5e-4 * kTick * (i + 1));
  }
  EXPECT_GT(result.spring_D.z, 0.8) << "it is felt, a little";
}

/// A hand that the renderer is told of, booked as docs/dev/feel.md says; a motor that acts a tick late.
class BookedHand {
 public:
  explicit BookedHand(ForceRenderer& renderer, const Pose& X_DS) : renderer_(renderer), last_(X_DS) {}
  RenderResult moveTo(const Pose& X_DS) {
    const RenderResult result = renderer_.tick(X_DS, kTick);
    account_.add(renderer_.way(X_DS, last_), commanded_, result.stiffness);
    loss_.add(t_ += kTick, account_.balance());
    largest_ = std::max(largest_, account_.balance());
    commanded_ = {result.force_D, result.torque_D / kRotationLever};
    last_ = X_DS;
    return result;
  }
  double worst() const { return loss_.value(); }
  double largest() const { return largest_; }

 private:
  ForceRenderer& renderer_;
  EnergyAccount account_{1};
  WorstLoss loss_;
  MetricVector commanded_;
  Pose last_;
  double t_ = 0.0, largest_ = 0.0;
};

/// Sets that say something else each time (3 mm, 17 degrees), a hand that rows about in them unmoved: what is made in a
/// second stays about what its presses leak through the motors' delay.
TEST(ForceRendererEnergy, MakesNoEnergyOutOfWrongSets) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> height(-0.003, 0.003), slope(-0.3, 0.3);
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  BookedHand hand(renderer, at(0, 0, 0.005));
  for (int i = 0; i < 20000; ++i) {
    const double t = i * kTick;
    if (i % 50 == 0) {
      ConstraintSet set = floorSet(static_cast<std::uint64_t>(i + 1), 0.0, renderer.proxy().p);
      const dvec3 up = glm::normalize(dvec3(slope(random), slope(random), 1.0));
      set.constraints[0] = planeConstraint(dvec3(0, 0, height(random)), up, set.X_DR, 0);
      renderer.adopt(set);
    }
    hand.moveTo(at(0.01 * std::sin(3.0 * t), 0.01 * std::cos(2.0 * t), 0.002 - 0.006 * std::sin(5.0 * t)));
  }
  RecordProperty("worst_uj", static_cast<int>(1e6 * hand.worst()));
  EXPECT_GE(hand.worst(), -1.0e-3);
  EXPECT_GT(hand.largest(), 2e-3) << "the hand must have worked";
}

TEST(ForceRendererEnergy, AProxyThatIsOnlyLatePullsAtNobody) {
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

struct CaughtUp {
  double along = 0.0;    ///< N, the most along the proxy's way, where the hand does not go.
  double stepped = 0.0;  ///< N, the most in a millisecond.
  dvec3 proxy{0.0};
};

/// The edge of a small zone, `height` (m) over a floor, holds the proxy 38 mm behind a hand that presses there and then
/// goes off to a side at 0.6 m/s; the next set lets it come, some milliseconds long and faster than the hand.
CaughtUp catchUp(double height) {
  RendererOptions options;
  options.damping = 4.0;
  ForceRenderer renderer(options);
  renderer.reset(at(0, 0, height + 0.001));
  ConstraintSet small = floorSet(1, 0.0, dvec3(0, 0, height));
  small.zone_radius = 0.002;
  renderer.adopt(small);
  constexpr double kPressed = -0.0005, kAway = 0.040, kStep = 0.0006;  // m; the last one a tick.
  moveTo(renderer, dvec3(0, 0, height + 0.001), dvec3(0, kAway, kPressed));
  CaughtUp caught;
  dvec3 before(0.0);
  for (int i = 1; i <= 60; ++i) {
    const RenderResult result = renderer.tick(at(-kStep * i, kAway, kPressed), kTick);
    if (i > 30) {
      caught.along = std::max(caught.along, result.force_D.y);
      caught.stepped = std::max(caught.stepped, glm::distance(result.force_D, before));
    }
    before = result.force_D;
    if (i != 30) continue;
    EXPECT_LT(renderer.proxy().p.y, 0.0025);
    ConstraintSet wide = floorSet(2, 0.0, renderer.proxy().p);
    wide.zone_radius = 0.2;
    EXPECT_EQ(renderer.adopt(wide), Adoption::kAdopted);
  }
  caught.proxy = renderer.proxy().p;
  return caught;
}

TEST(ForceRendererEnergy, AProxyThatCatchesUpDragsNobodyAlong) {
  // Along the floor; and through the air to it, where besides the pull of the zone's edge (0.8 N) ends.
  for (const auto& [height, most_step] : {std::pair(0.0, 0.5), std::pair(0.004, 0.8)}) {
    const CaughtUp caught = catchUp(height);
    EXPECT_NEAR(caught.proxy.y, 0.040, 1e-3) << "it has come";
    EXPECT_NEAR(caught.proxy.z, 0.0, 1e-5);
    EXPECT_LT(caught.along, 0.05) << height;
    EXPECT_LT(caught.stepped, most_step) << height;
  }
}

TEST(ForceRendererEnergy, DampsWhatAnOverCurvedSetMakes) {
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

TEST(StoredEnergy, IsTheWorkOfReleasingALimitedSpring) {
  // Integrated along the release: min(K s, limit) ds.
  for (const double limit : {1.5, 6.4, 100.0}) {
    double work = 0.0;
    const double stretch = 0.012, step = 1e-6;
    for (double s = 0.5 * step; s < stretch; s += step) work += std::min(1000.0 * s, limit) * step;
    EXPECT_NEAR(storedEnergy(1000.0 * stretch, 1000.0, limit), work, 1e-7);
  }
}

TEST(ForceRendererEnergy, TakesADeratedForceForNoLoss) {
  // Pressed 8 mm deep against warm motors that bear 1.4 N, and released: nobody made energy.
  ForceRenderer renderer;
  renderer.setForceLimit(1.4);
  renderer.reset(at(0, 0, 0.005));
  renderer.adopt(floorSet(1));
  RenderResult result;
  for (int i = 0; i < 3000; ++i) {
    const double z = 0.005 - 0.013 * std::sin(std::numbers::pi * i / 3000.0);
    result = renderer.tick(at(0, 0, z), kTick);
    const double size = glm::length(result.force_D);
    renderer.noteApplied(size > 1.4 ? result.force_D * (1.4 / size) : result.force_D);
    EXPECT_EQ(result.controller_damping, 0.0) << i;
    EXPECT_GT(result.energy, -0.2e-3) << i;
  }
}

/// What the peak force gives a hand that turns round at once, before a motor that is two ticks late has followed, J.
double motorLeak(double speed) {
  return 6.4 * speed * 0.002;
}

/// Worst loss of a hand that follows `points` at `speed`, J.
double leastEnergyAlong(ForceRenderer& renderer, const std::vector<dvec3>& points, double speed) {
  BookedHand hand(renderer, Pose::translation(points.front()));
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const int ticks = static_cast<int>(std::ceil(glm::distance(points[k], points[k + 1]) / (speed * kTick)));
    for (int i = 1; i <= ticks; ++i) {
      hand.moveTo(Pose::translation(glm::mix(points[k], points[k + 1], static_cast<double>(i) / ticks)));
    }
  }
  return hand.worst();
}

TEST(EnergyAccount, BooksTheForceThatActsWhenItActs) {
  // 2 N commanded for one tick and a motor that is two ticks late: only the way of the third tick is work.
  EnergyAccount account(2);
  const MetricVector step{dvec3(0.001, 0, 0), dvec3(0.0)};
  const MetricVector push{dvec3(-2.0, 0, 0), dvec3(0.0)};
  account.add(step, push, 1000.0);
  EXPECT_EQ(account.balance(), 0.0);
  account.add(step, {}, 1000.0);
  EXPECT_EQ(account.balance(), 0.0);
  account.add(step, {}, 1000.0);
  EXPECT_NEAR(account.balance(), 0.002 - 0.002, 1e-15) << "the work, less |F|^2 / 2K";
  account.add(step, {}, 1000.0);
  EXPECT_NEAR(account.balance(), 0.002, 1e-15);
}

TEST(EnergyAccount, CountsATorqueWithItsTurn) {
  EnergyAccount account;
  const double torque = 0.1, angle = 0.2;
  account.add({dvec3(0.0), dvec3(0, 0, kRotationLever * angle)}, {dvec3(0.0), dvec3(0, 0, -torque / kRotationLever)},
              1e9);
  EXPECT_NEAR(account.balance(), torque * angle, 1e-8);
}

TEST(EnergyAccount, ForgetsGainsOnly) {
  EnergyAccount account;
  const MetricVector along{dvec3(0.001, 0, 0), dvec3(0.0)};
  account.add(along, {dvec3(-1.0, 0, 0), dvec3(0.0)}, 1e12);
  account.forgetGains();
  EXPECT_NEAR(account.balance(), 0.0, 1e-12);
  account.add(along, {dvec3(1.0, 0, 0), dvec3(0.0)}, 1e12);
  account.forgetGains();
  EXPECT_NEAR(account.balance(), -0.001, 1e-9);
}

TEST(WorstLoss, IsTheDeepestFallWithinItsWindow) {
  // Against all pairs.
  std::mt19937 random(3);
  std::normal_distribution<double> step(0.0, 1e-3);
  std::vector<double> balance{0.0};
  for (int i = 0; i < 3000; ++i) balance.push_back(balance.back() + step(random));
  WorstLoss loss;
  for (std::size_t i = 0; i < balance.size(); ++i) loss.add(1e-3 * static_cast<double>(i), balance[i]);
  double worst = 0.0;
  for (std::size_t i = 0; i < balance.size(); ++i) {
    for (std::size_t j = i; j < balance.size() && j <= i + 999; ++j) worst = std::min(worst, balance[j] - balance[i]);
  }
  EXPECT_NEAR(loss.value(), worst, 5e-3 * 1.0);
  EXPECT_LE(loss.value(), worst + 1e-12);
}

TEST(ForceRendererEnergy, GivesBackNoMoreThanItsSpringHoldsFromTooDeep) {
  ForceRenderer renderer;
  renderer.reset(at(0, 0, 0.005));
  ASSERT_EQ(renderer.adopt(floorSet(1)), Adoption::kAdopted);
  const std::vector<dvec3> path{{0, 0, 0.005}, {0, 0, -0.020}, {0.02, 0, -0.025}, {0.02, 0.01, 0.005}};
  EXPECT_GE(leastEnergyAlong(renderer, path, 0.3), -1e-3 - motorLeak(0.3));
}

/// Round a post, deeper than the motors can push: the rest point that has yielded must turn with the surface.
TEST(ForceRendererEnergy, YieldsRoundACurveWithoutDrivingTheHand) {
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
  EXPECT_GE(leastEnergyAlong(renderer, path, 0.1), -1e-3 - motorLeak(0.1));
}

TEST(PassivityController, TellsWhatWasLostWithinTheLastSecond) {
  std::mt19937 random(7);
  std::normal_distribution<double> step(0.0, 1e-4);
  PassivityController controller;
  std::vector<double> balance{0.0};
  for (int i = 1; i <= 4000; ++i) {
    controller.add({dvec3(step(random), 0, 0), dvec3(0.0)}, {dvec3(1.0, 0, 0), dvec3(0.0)}, 1e12);
    controller.step(true, 1e-3);
    balance.push_back(controller.balance());
    const auto fallOver = [&](int ticks) {
      return *std::max_element(balance.begin() + std::max(0, i - ticks), balance.end()) - balance.back();
    };
    // To a slice of 50 ms.
    EXPECT_GE(controller.recentLoss(), fallOver(940) - 1e-12) << i;
    EXPECT_LE(controller.recentLoss(), fallOver(1010) + 1e-12) << i;
  }
}

TEST(SpringRation, GivesNoMoreThanIsLeft) {
  for (const double room : {0.0, 0.05e-3, 1.0}) {
    SpringRation ration;
    ration.reset();
    ration.limit(room);
    HeldSpring nothing;
    nothing.limit = 6.4;
    const MetricVector stretch = ration.apply({dvec3(0, 0, 0.002), dvec3(0.0)}, 1000.0, nothing, {}, 1e-3);
    const double gained = 0.5 * 1000.0 * dot(stretch, stretch);
    EXPECT_NEAR(gained, std::min(room, 0.15e-3), 1e-6) << room;
  }
}

}  // namespace
}  // namespace hapticell::haptic
