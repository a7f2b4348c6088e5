// SPDX-License-Identifier: Apache-2.0
#include "haptic/devices/simulated_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace hapticell::haptic {
namespace {

constexpr double kTick = 0.001;

config::DeviceProfile frictionless() {
  config::DeviceProfile profile;
  profile.mechanics.coulomb_friction = profile.mechanics.viscous_friction = profile.mechanics.weight = 0.0;
  return profile;
}

void advance(SimulatedDevice& device, int ticks) {
  for (int i = 0; i < ticks; ++i) device.advance(kTick);
}

DeviceReading readingOf(SimulatedDevice& device) {
  DeviceReading reading;
  EXPECT_EQ(device.read(reading), DeviceStatus::kOk);
  return reading;
}

TEST(SimulatedDevice, TellsThePapersFigures) {
  const SimulatedDevice device;
  const DeviceCapabilities& can = device.capabilities();
  EXPECT_EQ(can.workspace_max - can.workspace_min, dvec3(0.160, 0.130, 0.130));
  EXPECT_EQ(can.workspace_max + can.workspace_min, dvec3(0.0));
  EXPECT_EQ(can.peak_force, 6.4);
  EXPECT_EQ(can.driven_axes, 3);
}

TEST(SimulatedDevice, IsShutUntilOpened) {
  SimulatedDevice device;
  DeviceReading reading;
  EXPECT_EQ(device.read(reading), DeviceStatus::kNotOpen);
  EXPECT_EQ(device.write(dvec3(1.0), dvec3(0.0)), DeviceStatus::kNotOpen);
  ASSERT_TRUE(device.open().has_value());
  EXPECT_EQ(device.read(reading), DeviceStatus::kOk);
  device.close();
  device.close();
  EXPECT_EQ(device.read(reading), DeviceStatus::kNotOpen);
}

TEST(SimulatedDevice, AcceleratesWithItsApparentMassInTheMiddle) {
  for (int axis = 0; axis < 3; ++axis) {
    SimulatedDevice device(frictionless());
    ASSERT_TRUE(device.open().has_value());
    dvec3 force(0.0);
    force[axis] = 0.5;
    for (int i = 0; i < 21; ++i) {
      device.write(force, dvec3(0.0));
      device.advance(kTick);
    }
    // The force acts from the second tick on; the linkage makes the mass a little different in each direction.
    EXPECT_NEAR(device.trueVelocity()[axis], 0.5 / 0.045 * 0.020, 0.3 * 0.22) << axis;
  }
}

TEST(SimulatedDevice, DelaysTheForceByItsTicks) {
  for (const int delay : {0, 1, 3}) {
    config::DeviceProfile profile = frictionless();
    profile.electronics.delay_ticks = delay;
    SimulatedDevice device(profile);
    ASSERT_TRUE(device.open().has_value());
    device.write(dvec3(0, 0, 1), dvec3(0.0));
    int ticks = 0;
    while (device.motorForce().z < 0.5 && ticks < 20) {
      device.advance(kTick);
      ++ticks;
    }
    EXPECT_EQ(ticks, delay + 1);
  }
}

TEST(SimulatedDevice, QuantisesTheForceByTwelveBits) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  const double step = 7.9 / 2048.0;
  double last = 0.0;
  int changes = 0;
  for (int i = 0; i < 100; ++i) {
    device.place(Pose::identity());
    device.write(dvec3(1e-4 * i, 0, 0), dvec3(0.0));  // The waist alone drives x in the middle.
    device.advance(kTick);
    const double force = device.motorForce().x;
    EXPECT_NEAR(force / step, std::round(force / step), 1e-2);
    changes += force != last ? 1 : 0;
    last = force;
  }
  EXPECT_LE(changes, 4) << "0.01 N are under three steps";
}

TEST(SimulatedDevice, SticksByFrictionAndBreaksLoose) {
  config::DeviceProfile profile = frictionless();
  profile.mechanics.coulomb_friction = 0.06;
  SimulatedDevice device(profile);
  ASSERT_TRUE(device.open().has_value());
  for (int i = 0; i < 500; ++i) {
    device.write(dvec3(0.05, 0, 0), dvec3(0.0));
    device.advance(kTick);
  }
  EXPECT_EQ(device.truePose().p, dvec3(0.0));
  for (int i = 0; i < 50; ++i) {
    device.write(dvec3(0.10, 0, 0), dvec3(0.0));
    device.advance(kTick);
  }
  EXPECT_GT(device.truePose().p.x, 0.5e-3);
  // Left alone it comes to rest, exactly.
  device.write(dvec3(0.0), dvec3(0.0));
  advance(device, 1000);
  EXPECT_EQ(device.trueVelocity(), dvec3(0.0));
}

TEST(SimulatedDevice, ReadsInEncoderSteps) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  double worst = 0.0;
  int steps = 0;
  dvec3 last(0.0);
  for (int i = 0; i < 2000; ++i) {
    const dvec3 p(1e-6 * i, 0, 0);
    device.place(Pose::translation(p));
    const dvec3 read = readingOf(device).X_DS.p;
    worst = std::max(worst, glm::length(read - p));
    steps += glm::length(read - last) > 0.012e-3 ? 1 : 0;  // Of the waist; the others move little.
    last = read;
  }
  EXPECT_LE(worst, 0.02e-3) << "half a step on each of three joints";
  EXPECT_NEAR(steps, 100, 5) << "2 mm in steps of 0.02 mm";
}

TEST(SimulatedDevice, ReadsRotationInGimbalSteps) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  for (int i = 0; i < 500; ++i) {
    const dvec3 turn(0.006 * i, -0.004 * i, 0.003 * i);
    const Pose X_DS{dvec3(0.0), quaternionFromRotationVector(turn)};
    device.place(X_DS);
    const double error = glm::length(difference(readingOf(device).X_DS, X_DS).angular);
    EXPECT_LE(error, 0.75e-3);
  }
  device.place({dvec3(0.0), quaternionFromRotationVector(dvec3(1e-4, 0, 0))});
  EXPECT_LT(glm::length(rotationVector(readingOf(device).X_DS.q)), 1e-12);
}

TEST(SimulatedDevice, StopsAtTheEdgeOfItsWorkspace) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      SimulatedDevice device;
      ASSERT_TRUE(device.open().has_value());
      dvec3 force(0.0);
      force[axis] = 2.0 * side;
      for (int i = 0; i < 1500; ++i) {
        device.write(force, dvec3(0.0));
        device.advance(kTick);
      }
      const double edge = 0.5 * device.profile().workspace[axis];
      EXPECT_NEAR(side * device.truePose().p[axis], edge, 1e-3) << axis << " " << side;
      EXPECT_LT(glm::length(device.trueVelocity()), 0.05);
    }
  }
}

TEST(SimulatedDevice, WarmsToTheLimitAtTheContinuousForce) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  device.hand().hold(Pose::identity());
  for (int i = 0; i < 30000; ++i) {
    device.hand().hold(Pose::identity());
    device.write(dvec3(0, 0, 1.4), dvec3(0.0));
    device.advance(kTick);
  }
  EXPECT_NEAR(readingOf(device).motor_temperature, 1.0 - std::exp(-1.0), 0.02) << "one time constant of 30 s";
}

TEST(SimulatedDevice, RefusesAForceThatIsNoNumber) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  EXPECT_EQ(device.write(dvec3(0, std::nan(""), 0), dvec3(0.0)), DeviceStatus::kFault);
  advance(device, 10);
  EXPECT_TRUE(device.truePose().isValid());
  EXPECT_EQ(device.motorForce(), dvec3(0.0));
}

TEST(SimulatedDevice, FallsUnderAWeightThatFrictionDoesNotHold) {
  config::DeviceProfile profile;
  SimulatedDevice held(profile);
  advance(held, 1000);
  EXPECT_EQ(held.truePose().p, dvec3(0.0)) << "friction holds what the counterweights leave";
  profile.mechanics.weight = 0.44;
  SimulatedDevice falling(profile);
  advance(falling, 2000);
  EXPECT_NEAR(falling.truePose().p.z, -0.065, 1e-3);
}

TEST(SimulatedHand, BringsTheStylusWhereItWants) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  const Pose goal{dvec3(0.03, -0.02, 0.01), quaternionFromRotationVector(dvec3(0.3, -0.2, 0.5))};
  for (int i = 0; i < 1500; ++i) {
    device.hand().hold(goal, 1);
    device.advance(kTick);
  }
  // Friction of 0.06 N on a spring of 300 N/m leaves up to 0.2 mm.
  EXPECT_LT(glm::length(device.truePose().p - goal.p), 0.35e-3);
  EXPECT_LT(glm::length(difference(device.truePose(), goal).angular), 1e-3);
  EXPECT_EQ(readingOf(device).buttons, 1u);
}

TEST(SimulatedHand, IsASpringOfItsStiffness) {
  SimulatedDevice device(frictionless());
  ASSERT_TRUE(device.open().has_value());
  for (int i = 0; i < 3000; ++i) {
    device.hand().hold(Pose::identity());
    device.write(dvec3(0, 0, 1.5), dvec3(0.0));
    device.advance(kTick);
  }
  EXPECT_NEAR(device.truePose().p.z, 1.5 / 300.0, 0.03e-3);
  EXPECT_NEAR(device.handForce().z, -1.5, 0.01);
}

TEST(SimulatedHand, SwingsWithTheFrequencyOfItsMassAndSpring) {
  SimulatedDevice device(frictionless());
  ASSERT_TRUE(device.open().has_value());
  HandOptions hand;
  hand.damping = 0.0;
  device.hand().setOptions(hand);
  device.place(Pose::translation(dvec3(0.001, 0, 0)));
  device.hand().hold(Pose::translation(dvec3(0.001, 0, 0)));
  device.advance(kTick);
  int crossings = 0;
  double last = 1.0;
  for (int i = 0; i < 5000; ++i) {
    device.hand().hold(Pose::identity());
    device.advance(kTick);
    if (last > 0.0 && device.truePose().p.x <= 0.0) ++crossings;
    last = device.truePose().p.x;
  }
  // omega^2 = 300 / (0.1 + 0.045 in this direction): 7.24 Hz.
  EXPECT_NEAR(crossings / 5.0, std::sqrt(300.0 / 0.145) / (2.0 * std::numbers::pi), 0.4);
}

TEST(SimulatedHand, LetsGoOfTheButtonWithTheStylus) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  device.hand().hold(Pose::identity(), 1);
  device.advance(kTick);
  EXPECT_EQ(readingOf(device).buttons, 1u);
  device.hand().release();
  device.advance(kTick);
  EXPECT_EQ(readingOf(device).buttons, 0u);
  EXPECT_EQ(device.handForce(), dvec3(0.0));
}

TEST(SimulatedHand, FollowsAJumpingMouseAtAHandsSpeed) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  double fastest = 0.0;
  for (int i = 0; i < 400; ++i) {
    device.hand().hold(Pose::translation(dvec3(i < 100 ? -0.05 : 0.05, 0, 0)));
    device.advance(kTick);
    fastest = std::max(fastest, glm::length(device.trueVelocity()));
    EXPECT_LE(glm::length(device.handForce()), 30.0 + 1e-9);
  }
  EXPECT_LT(fastest, 3.0);
  EXPECT_TRUE(device.truePose().isValid());
}

TEST(SimulatedHand, IgnoresAPoseThatIsNone) {
  SimulatedDevice device;
  ASSERT_TRUE(device.open().has_value());
  device.hand().hold(Pose::identity(), 1);
  device.hand().hold({dvec3(std::nan("")), dquat(1, 0, 0, 0)}, 0);
  device.advance(kTick);
  EXPECT_TRUE(device.truePose().isValid());
  EXPECT_EQ(readingOf(device).buttons, 1u);
}

TEST(SimulatedDevice, StepsAlikeInVirtualTimeAgain) {
  const auto run = [] {
    SimulatedDevice device;
    EXPECT_TRUE(device.open().has_value());
    for (int i = 0; i < 500; ++i) {
      device.hand().hold(Pose::translation(dvec3(0.02 * std::sin(0.02 * i), 0.01, 0)));
      device.write(dvec3(0, 0, 0.001 * i), dvec3(0.0));
      device.advance(kTick);
    }
    return device.truePose();
  };
  const Pose first = run(), second = run();
  EXPECT_EQ(first.p, second.p);
  EXPECT_EQ(first.q, second.q);
}

}  // namespace
}  // namespace hapticell::haptic
