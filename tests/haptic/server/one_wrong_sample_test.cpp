// SPDX-License-Identifier: Apache-2.0
// One wrong sample of the stylus, of any size, in any steady contact: a tenth of a second later the force is what it
// would have been without it. Force loop and scripted device in virtual time.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "feel/scene.h"
#include "haptic/rendering/sample_gate.h"
#include "tests/haptic/server/scripted_hardware.h"

namespace hapticell::haptic {
namespace {

constexpr int kEngaging = 900, kLowering = 500, kResting = 250, kBack = 100, kCompared = 100;

struct Contact {
  std::shared_ptr<const feel::FeelScene> scene;
  double depth = 0.003;  ///< m.
  int set_period = 16;   ///< Ticks between two sets of the client.
  int slid = 0;          ///< Ticks that the hand slid before it rests.
};

/// A stylus led into a contact by a hand that cannot be moved, with a client that sends exact sets.
class Rig {
 public:
  explicit Rig(const Contact& contact) : contact_(contact), loop_(device_, clock_, patientOptionsFor(device_)) {
    device_.X_DS = poseAt(0);
    loop_.openLink();
    loop_.tick();
    loop_.submit(HapticControl{.forces_enabled = true});
    run(kEngaging, 0);
  }
  /// Lowers, slides, rests.
  void press() {
    run(kLowering + contact_.slid, 1);
    run(kResting, 0);
  }
  void run(int ticks, int steps_a_tick) {
    for (int i = 0; i < ticks; ++i) {
      step_ += steps_a_tick;
      tick(poseAt(step_));
    }
  }
  void tick(const Pose& X_DS) {
    clock_.advance(1'000'000);
    loop_.heard();
    if (ticks_++ % contact_.set_period == 0) {
      ConstraintSet set = contact_.scene->setAt(loop_.current().X_DP, 0.0);
      set.sequence = ++sets_;
      loop_.submit(set);
    }
    device_.X_DS = X_DS;
    loop_.tick();
  }
  const Pose& stylus() const { return device_.X_DS; }
  dvec3 force() const { return device_.force; }

 private:
  Pose poseAt(int step) const {
    const double down = std::min(1.0, static_cast<double>(step) / kLowering);
    const double t = 0.001 * std::max(0, step - kLowering);
    return {contact_.scene->handAt(t, -0.002 + down * (0.002 + contact_.depth)), contact_.scene->turnAt(t)};
  }

  Contact contact_;
  ScriptedDevice device_;
  VirtualClock clock_;
  ForceLoop loop_;
  int step_ = 0, ticks_ = 0;
  std::uint64_t sets_ = 0;
};

std::shared_ptr<feel::FeelScene> sceneOf(int kind) {
  switch (kind) {
    case 0:
      return feel::planeScene();
    case 1:
      return feel::cylinderScene(0.05);
    case 2:
      return feel::cylinderScene(0.01);
    case 3:
      return feel::boreScene(0.01);
    case 4:
      return feel::cornerScene();
    case 5:
      return feel::facetScene(0.01, 5.0);
    default:
      return feel::boxScene();
  }
}

double uniform(double from, double to) {
  return from + (to - from) * *rc::gen::inRange(0, 1000001) * 1e-6;
}

Contact anyContact() {
  Contact contact;
  auto scene = sceneOf(*rc::gen::inRange(0, 7));
  scene->friction = *rc::gen::element(0.0, 0.3);
  contact.scene = std::move(scene);
  contact.depth = uniform(0.0005, 0.005);
  contact.set_period = *rc::gen::element(1, 16, 100);
  contact.slid = *rc::gen::element(0, 0, 150);
  return contact;
}

/// Off by 10 um to 10 m in any direction, half of the time turned by up to pi besides.
Pose anyWrong(const Pose& X_DS) {
  const double z = uniform(-1.0, 1.0), angle = uniform(0.0, 2.0 * std::numbers::pi), side = std::sqrt(1.0 - z * z);
  const dvec3 direction(side * std::cos(angle), side * std::sin(angle), z);
  Pose wrong = X_DS;
  wrong.p += std::pow(10.0, uniform(-5.0, 1.0)) * direction;
  if (*rc::gen::arbitrary<bool>())
    wrong.q = glm::normalize(quaternionFromRotationVector(std::pow(10.0, uniform(-4.0, 0.49)) *
                                                          dvec3(direction.z, direction.x, direction.y)) *
                             X_DS.q);
  return wrong;
}

RC_GTEST_PROP(OneWrongSample, IsForgottenWithinATenthOfASecond, ()) {
  const Contact contact = anyContact();
  Rig undisturbed(contact), disturbed(contact);
  undisturbed.press();
  disturbed.press();
  const Pose wrong = anyWrong(disturbed.stylus());
  // As little as a hand may have gone is answered as a motion, and friction may hold what it was: K times the way.
  const double way = glm::length(wrong.p - disturbed.stylus().p);
  const double left = contact.scene->friction > 0.0 && way < 1.5 * SampleGate::kLeap ? 1000.0 * way : 0.0;
  disturbed.tick(wrong);
  undisturbed.run(1, 0);
  disturbed.run(kBack - 1, 0);
  undisturbed.run(kBack - 1, 0);
  for (int i = 0; i < kCompared; ++i) {
    disturbed.run(1, 0);
    undisturbed.run(1, 0);
    const dvec3 right = undisturbed.force();
    const double off = glm::length(disturbed.force() - right);
    if (off > 0.01 * glm::length(right) + left + 1e-4)
      RC_FAIL(contact.scene->name() + ", friction " + std::to_string(contact.scene->friction) + ", depth " +
              std::to_string(contact.depth) + ", slid " + std::to_string(contact.slid) + ": " +
              std::to_string(glm::length(right)) + " N, off by " + std::to_string(off) + " N after " +
              std::to_string(kBack + i) + " ms; wrong by " +
              std::to_string(1e3 * glm::length(wrong.p - disturbed.stylus().p)) + " mm");
  }
}

/// The cases of the trial: 20 and 50 mm deeper, sideways and higher, on a floor that is pressed with 3 N.
TEST(OneWrongSample, NeitherTakesTheFloorAwayNorKicks) {
  for (const dvec3& off : {dvec3(0, 0, -0.05), dvec3(0, 0, -0.02), dvec3(0.05, 0, 0), dvec3(0, 0, 0.05)}) {
    Rig rig({sceneOf(0), 0.003, 16, 0});
    rig.press();
    ASSERT_NEAR(glm::length(rig.force()), 3.0, 0.03);
    rig.tick({rig.stylus().p + off, rig.stylus().q});
    for (int i = 0; i < 400; ++i) {
      EXPECT_NEAR(glm::length(rig.force()), 3.0, 0.05) << i << " ms after " << off.x << ' ' << off.z;
      rig.run(1, 0);
    }
  }
}

/// A device that says each sample several times gives the wrong one as often: the floor is back all the same.
TEST(OneWrongSample, MaySayItSeveralTimes) {
  for (const int times : {2, 4, 10}) {
    Rig rig({sceneOf(0), 0.003, 16, 0});
    rig.press();
    const Pose right = rig.stylus();
    for (int i = 0; i < times; ++i) {
      rig.tick({right.p + dvec3(0.0, 0.0, -0.05), right.q});
      EXPECT_LE(glm::length(rig.force()), 3.0 + 0.06 * times) << times;
    }
    rig.tick(right);
    rig.run(100, 0);
    EXPECT_NEAR(glm::length(rig.force()), 3.0, 0.03) << times;
  }
}

/// A true push beyond what the motors bear makes the spring yield; under a hand that rests it comes back.
/// Presses by `depth`, then 12 mm deeper for 0.4 s, far beyond what the motors bear, and back. Gives the hand's work,
/// J: a command acts a tick later.
double overload(Rig& rig, const Pose& right) {
  double work = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const double deeper = 0.012 * (i < 200 ? i / 200.0 : 2.0 - i / 200.0);
    const dvec3 before = rig.stylus().p, acting = rig.force();
    rig.tick({right.p - dvec3(0.0, 0.0, deeper), right.q});
    work -= glm::dot(acting, rig.stylus().p - before);
  }
  return work;
}

/// What the hand put in pays for it: the true force is back within two seconds, and by no kick.
TEST(YieldedSpring, ComesBackWithinTwoSecondsUnderAHandThatRests) {
  for (const double depth : {0.0012, 0.003, 0.005}) {
    Rig rig({sceneOf(0), depth, 16, 0});
    rig.press();
    const double right_force = glm::length(rig.force());
    ASSERT_NEAR(right_force, 1000.0 * depth, 0.03 * right_force);
    const Pose right = rig.stylus();
    const double work = overload(rig, right);
    EXPECT_LT(glm::length(rig.force()), std::max(0.7, right_force - 4.0)) << "no more than it was given";
    EXPECT_GT(work, 0.5 * right_force * depth) << "what comes back is paid";
    double before = glm::length(rig.force()), step = 0.0;
    for (int i = 0; i < 2000; ++i) {
      rig.run(1, 0);
      step = std::max(step, glm::length(rig.force()) - std::exchange(before, glm::length(rig.force())));
    }
    EXPECT_NEAR(glm::length(rig.force()), right_force, 0.01 * right_force) << depth;
    EXPECT_LT(step, 0.02) << "N in a millisecond";
  }
}

/// A hand that gives way to what comes back still rests, and gets no energy out of the whole: lifted, it has put in.
TEST(YieldedSpring, ComesBackUnderAHandThatGivesWay) {
  constexpr double kHand = 2000.0, kDepth = 0.004;  // N/m
  Rig rig({sceneOf(0), kDepth, 16, 0});
  rig.press();
  const Pose right = rig.stylus();
  double work = overload(rig, right);
  const auto go = [&](const dvec3& p) {
    const dvec3 before = rig.stylus().p, acting = rig.force();
    rig.tick({p, right.q});
    work -= glm::dot(acting, rig.stylus().p - before);
  };
  for (int i = 0; i < 2200; ++i) {
    const dvec3 wanted = right.p + rig.force() / kHand;
    go(rig.stylus().p + 0.02 * (wanted - rig.stylus().p));
  }
  EXPECT_NEAR(glm::length(rig.force()), 1000.0 * kDepth / (1.0 + 1000.0 / kHand), 0.05);
  for (int i = 0; i < 200; ++i) go(rig.stylus().p + dvec3(0.0, 0.0, 5e-5));
  EXPECT_EQ(glm::length(rig.force()), 0.0);
  EXPECT_GT(work, 0.0);
}

}  // namespace
}  // namespace hapticell::haptic
