// SPDX-License-Identifier: Apache-2.0
#include "planning/free_space.h"

#include <gtest/gtest.h>

#include <random>

#include "manipulation/checks/joint_check.h"
#include "tests/planning/planning_cells.h"

namespace hapticell::planning {
namespace {

constexpr double kClearance = 0.01;

EntityConfiguration randomAt(const FreeSpace& space, std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-2.5, 2.5);
  EntityConfiguration at = space.present();
  for (double& q : at.joints) q = angle(random);
  return at;
}

TEST(FreeSpace, AgreesWithTheJointCheckAtConfigurations) {
  const auto scene = test::robotCell(true);
  auto space = FreeSpace::create(scene, 1, {});
  ASSERT_TRUE(space) << space.error().message();
  auto check = manipulation::JointCheck::create(scene, 1, {}, manipulation::RestContacts::kLeaveOutLasting);
  ASSERT_TRUE(check);
  space->setClearance(kClearance);
  std::mt19937 random(3);
  int free = 0;
  for (int i = 0; i < 200; ++i) {
    const EntityConfiguration at = randomAt(*space, random);
    const double distance = check->clearance(at.joints, 0.1);
    if (std::abs(distance - kClearance) < 1e-5) continue;
    EXPECT_EQ(space->isFree(at), check->isFree(at.joints, kClearance)) << distance;
    EXPECT_EQ(space->isFree(at), !space->blocker().has_value());
    EXPECT_NEAR(space->clearanceAt(at, 0.1), distance, 1e-9);
    free += space->isFree(at) ? 1 : 0;
  }
  EXPECT_GT(free, 20);
  EXPECT_LT(free, 180);
}

/// A motion that is called free keeps the clearance wherever it is looked at; one that is not comes nearer than 1.15
/// times that, or touches, at one of many places.
TEST(FreeSpace, ProvesWholeMotions) {
  const auto scene = test::robotCell(true);
  auto space = FreeSpace::create(scene, 1, {});
  ASSERT_TRUE(space);
  auto check = manipulation::JointCheck::create(scene, 1, {}, manipulation::RestContacts::kLeaveOutLasting);
  ASSERT_TRUE(check);
  space->setClearance(kClearance);
  std::mt19937 random(5);
  int free = 0, blocked = 0;
  for (int i = 0; i < 60; ++i) {
    const EntityConfiguration from = randomAt(*space, random);
    const EntityConfiguration to = space->between(from, randomAt(*space, random), 0.3);
    const bool is_free = space->isFree(from, to);
    double least = 0.1;
    bool touches = false;
    for (int k = 0; k <= 300; ++k) {
      const auto at = space->between(from, to, k / 300.0);
      least = std::min(least, check->clearance(at.joints, least));
      touches = touches || !check->isFree(at.joints);
    }
    if (is_free) {
      EXPECT_GE(least, kClearance - 1e-6);
      EXPECT_FALSE(touches);
      ++free;
    } else {
      EXPECT_TRUE(touches || least < 1.15 * kClearance) << least;
      ++blocked;
    }
  }
  EXPECT_GT(free, 5);
  EXPECT_GT(blocked, 5);
}

TEST(FreeSpace, NamesWhatIsInTheWay) {
  auto space = FreeSpace::create(test::boxWithBar(0.3), 1, {});
  ASSERT_TRUE(space);
  EXPECT_FALSE(space->hasJoints());
  const EntityConfiguration at = space->present();
  EXPECT_TRUE(space->isFree(at));
  EntityConfiguration beyond = at;
  beyond.X_WE.p.x += 0.5;
  EXPECT_TRUE(space->isFree(beyond));
  EXPECT_FALSE(space->isFree(at, beyond));
  ASSERT_TRUE(space->blocker());
  EXPECT_EQ(space->blocker()->met, "right");
  EXPECT_EQ(space->blocker()->other, 3U);
  EXPECT_EQ(english(space->blocker()->text()), "bar would touch right");
  EXPECT_NEAR(space->clearanceAt(at, 1.0), 0.05, 1e-6);
}

TEST(FreeSpace, AnswersNothingOnceStopped) {
  auto space = FreeSpace::create(test::boxWithBar(0.3), 1, {});
  ASSERT_TRUE(space);
  std::atomic<bool> stop{true};
  space->setStop(&stop);
  EXPECT_FALSE(space->isFree(space->present()));
  EXPECT_FALSE(space->blocker());
  stop = false;
  EXPECT_TRUE(space->isFree(space->present()));
}

TEST(FreeSpace, RefusesWhatItCannotMove) {
  const auto scene = test::boxWithBar(0.3);
  EXPECT_FALSE(FreeSpace::create(scene, 77, {}));
}

}  // namespace
}  // namespace hapticell::planning
