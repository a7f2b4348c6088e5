// SPDX-License-Identifier: Apache-2.0
#include "haptic/rendering/safety_chain.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace hapticell::haptic {
namespace {

constexpr double kTick = 0.001;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

SafetyInput wanting(const dvec3& force) {
  SafetyInput input;
  input.force_D = force;
  input.enabled = true;
  return input;
}

/// A chain whose gate is fully open.
SafetyChain openChain(const SafetyOptions& options = {}) {
  SafetyChain chain(options);
  for (int i = 0; i < 1100; ++i) chain.tick(wanting(dvec3(0.0)));
  return chain;
}

double run(SafetyChain& chain, const SafetyInput& input, int ticks) {
  double last = 0.0;
  for (int i = 0; i < ticks; ++i) last = glm::length(chain.tick(input).force_D);
  return last;
}

/// Ticks until the force is exactly zero, at most `limit`.
int ticksToZero(SafetyChain& chain, SafetyInput input, int limit) {
  for (int i = 1; i <= limit; ++i) {
    input.link_silence += kTick;
    if (chain.tick(input).force_D == dvec3(0.0)) return i;
  }
  return limit + 1;
}

TEST(SafetyChain, GivesNothingBeforeItIsEnabled) {
  SafetyChain chain;
  SafetyInput input = wanting(dvec3(0, 0, 3));
  input.enabled = false;
  for (int i = 0; i < 2000; ++i) EXPECT_EQ(chain.tick(input).force_D, dvec3(0.0));
}

TEST(SafetyChain, OpensOnlyFromASmallForceAndRampsWithinASecond) {
  SafetyChain chain;
  EXPECT_EQ(run(chain, wanting(dvec3(0, 0, 0.3)), 5000), 0.0) << "0.3 N is no small force";
  EXPECT_EQ(chain.tick(wanting(dvec3(0, 0, 0.1))).gate, GateState::kWaiting);
  chain.tick(wanting(dvec3(0, 0, 0.1)));
  chain.tick(wanting(dvec3(0, 0, 0.1)));
  EXPECT_EQ(chain.tick(wanting(dvec3(0, 0, 0.1))).gate, GateState::kRamping) << "after more than three ticks";
  double ramp = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const SafetyResult result = chain.tick(wanting(dvec3(0, 0, 2)));
    EXPECT_GE(result.ramp, ramp);
    EXPECT_LE(result.ramp - ramp, 0.002);
    ramp = result.ramp;
  }
  EXPECT_EQ(ramp, 1.0);
  EXPECT_NEAR(run(chain, wanting(dvec3(0, 0, 2)), 10), 2.0, 1e-12);
}

/// A share of the force that grew with the ramp would be given back by the motors: a hand that pressed right after
/// taking got 4 mJ and more that it had never put in.
TEST(SafetyChain, RampsByACeilingAndNotByAShare) {
  SafetyChain chain;
  run(chain, wanting(dvec3(0.0)), 4);
  for (int i = 0; i < 700; ++i) {
    const SafetyResult result = chain.tick(wanting(dvec3(0, 0, 0.3)));
    if (result.ramp > 0.0) {
      EXPECT_NEAR(result.force_limit, result.ramp * chain.options().peak_force, 1e-9);
    }
    EXPECT_NEAR(result.force_D.z, std::min(0.3, result.ramp * chain.options().peak_force), 0.01) << i;
  }
}

TEST(SafetyChain, AForceBetweenSmallOnesStartsTheCountAnew) {
  SafetyChain chain;
  for (int i = 0; i < 50; ++i) {
    for (int k = 0; k < 3; ++k) chain.tick(wanting(dvec3(0.0)));
    EXPECT_EQ(chain.tick(wanting(dvec3(0, 1, 0))).gate, GateState::kWaiting);
  }
}

TEST(SafetyChain, DampsTheStylusWhileItRampsOnly) {
  SafetyChain chain;
  SafetyInput input = wanting(dvec3(0.0));
  input.v_DS = dvec3(0.1, 0, 0);
  run(chain, input, 10);
  const SafetyResult ramping = chain.tick(input);
  EXPECT_LT(ramping.force_D.x, -0.1);
  EXPECT_EQ(run(chain, input, 1100), 0.0);
}

TEST(SafetyChain, LetsHonestForcesThroughUntouched) {
  SafetyChain chain = openChain();
  for (int i = 0; i < 400; ++i) {
    const dvec3 wanted(0.5 * std::sin(0.02 * i), 0.3 * std::sin(0.05 * i), 0.4 * std::sin(0.01 * i));
    EXPECT_LT(glm::length(chain.tick(wanting(wanted)).force_D - wanted), 1e-15);
  }
}

TEST(SafetyChain, SpreadsAStepOverTheSlewLimit) {
  SafetyChain chain = openChain();
  double last = 0.0;
  for (int i = 1; i <= 4; ++i) {
    const SafetyResult result = chain.tick(wanting(dvec3(0, 0, 3.5)));
    EXPECT_NEAR(result.force_D.z, std::min(3.5, 1.0 * i), 1e-12);
    EXPECT_EQ(result.slew_limited, i < 4);
    last = result.force_D.z;
  }
  EXPECT_NEAR(last, 3.5, 1e-12);
}

TEST(SafetyChain, ClampsToThePeakInDirection) {
  SafetyChain chain = openChain();
  run(chain, wanting(dvec3(30, 0, 40)), 20);
  const SafetyResult result = chain.tick(wanting(dvec3(30, 0, 40)));
  EXPECT_NEAR(glm::length(result.force_D), 6.4, 1e-12);
  EXPECT_NEAR(result.force_D.x / result.force_D.z, 0.75, 1e-9);
}

TEST(SafetyChain, DeratesToTheContinuousForceAndRecovers) {
  SafetyChain chain = openChain();
  const double warm = run(chain, wanting(dvec3(0, 0, 6.4)), 300000);
  EXPECT_NEAR(warm, 1.4, 0.02) << "after five minutes at the limit";
  // At the continuous force for ever, nothing is taken away.
  SafetyChain second = openChain();
  EXPECT_NEAR(run(second, wanting(dvec3(0, 0, 1.4)), 300000), 1.4, 1e-9);
  run(chain, wanting(dvec3(0.0)), 120000);
  EXPECT_NEAR(run(chain, wanting(dvec3(0, 0, 6.4)), 10), 6.4, 1e-9);
}

TEST(SafetyChain, TakesTheDevicesTemperatureWhenItIsHigher) {
  SafetyChain chain = openChain();
  SafetyInput input = wanting(dvec3(0, 0, 6.4));
  input.reported_temperature = 1.0;
  EXPECT_NEAR(run(chain, input, 20), 1.4, 1e-9);
}

TEST(SafetyChain, OneWrongReportOfTheTemperatureHoldsNothingDown) {
  SafetyChain chain = openChain();
  SafetyInput input = wanting(dvec3(0, 0, 3.0));
  run(chain, input, 20);
  input.reported_temperature = 2.0;
  run(chain, input, 1);
  input.reported_temperature = 0.0;
  EXPECT_NEAR(run(chain, input, 1), 3.0, 1e-9);
  EXPECT_NEAR(run(chain, input, 200), 3.0, 1e-9);
}

TEST(SafetyChain, IsSilentWithinFiftyMillisecondsOfAClosedSocket) {
  SafetyChain chain = openChain();
  run(chain, wanting(dvec3(0, 0, 6.4)), 20);
  SafetyInput input = wanting(dvec3(0, 0, 6.4));
  input.link_open = false;
  EXPECT_LE(ticksToZero(chain, input, 100), 50);
  input.link_open = true;
  input.force_D = dvec3(0.0);
  run(chain, input, 3000);
  input.force_D = dvec3(0, 0, 2);
  EXPECT_EQ(run(chain, input, 100), 0.0) << "a new client must enable anew";
  input.enabled = false;
  chain.tick(input);
  EXPECT_NEAR(run(chain, wanting(dvec3(0.0)), 1100), 0.0, 0.0);
  EXPECT_NEAR(run(chain, wanting(dvec3(0, 0, 2)), 10), 2.0, 1e-12);
}

TEST(SafetyChain, IsSilentWithinFiftyMillisecondsOfEscape) {
  SafetyChain chain = openChain();
  run(chain, wanting(dvec3(3, 0, 0)), 20);
  SafetyInput input = wanting(dvec3(3, 0, 0));
  input.enabled = false;
  EXPECT_LE(ticksToZero(chain, input, 100), 50);
}

TEST(SafetyChain, HoldsThroughShortSilenceAndDecaysAfterALongOne) {
  SafetyChain chain = openChain();
  run(chain, wanting(dvec3(0, 0, 3)), 20);
  SafetyInput input = wanting(dvec3(0, 0, 3));
  for (int i = 0; i < 590; ++i) {
    input.link_silence += kTick;
    EXPECT_NEAR(chain.tick(input).force_D.z, 3.0, 1e-12);
  }
  const int until_zero = ticksToZero(chain, input, 400);
  EXPECT_LE(until_zero, 10 + 200);
  EXPECT_GE(until_zero, 10 + 100) << "a decay, not a cut";
  // It comes back by way of a small force and the ramp.
  EXPECT_EQ(run(chain, wanting(dvec3(0, 0, 3)), 500), 0.0);
  run(chain, wanting(dvec3(0.0)), 1100);
  EXPECT_NEAR(run(chain, wanting(dvec3(0, 0, 3)), 10), 3.0, 1e-12);
}

TEST(SafetyChain, ComesBackFromAShortDecayWithoutAStep) {
  SafetyChain chain = openChain();
  run(chain, wanting(dvec3(0, 0, 3)), 20);
  SafetyInput input = wanting(dvec3(0, 0, 3));
  input.link_silence = 0.61;
  const double faded = run(chain, input, 90);
  EXPECT_LT(faded, 2.0);
  const double next = run(chain, wanting(dvec3(0, 0, 3)), 1);
  EXPECT_NEAR(next, faded, 0.02);
  EXPECT_NEAR(run(chain, wanting(dvec3(0, 0, 3)), 1000), 3.0, 1e-12);
}

TEST(SafetyChain, StaysShutAfterATripUntilEnabledAnew) {
  SafetyChain chain = openChain();
  run(chain, wanting(dvec3(0, 0, 3)), 20);
  chain.trip();
  EXPECT_LE(ticksToZero(chain, wanting(dvec3(0, 0, 3)), 100), 50);
  EXPECT_EQ(run(chain, wanting(dvec3(0.0)), 2000), 0.0);
  EXPECT_EQ(chain.tick(wanting(dvec3(0.0))).gate, GateState::kClosed);
  SafetyInput off = wanting(dvec3(0.0));
  off.enabled = false;
  chain.tick(off);
  run(chain, wanting(dvec3(0.0)), 1100);
  EXPECT_NEAR(run(chain, wanting(dvec3(0, 0, 3)), 10), 3.0, 1e-12);
}

/// Calibration lost, measurements that do not come: what the device does not exert is not commanded either, and comes
/// back by the gate, never in one step.
TEST(SafetyChain, ADeviceThatIsNotReadyBeginsAnewWhenItIs) {
  SafetyChain chain = openChain();
  SafetyInput input = wanting(dvec3(0, 0, 2));
  ASSERT_NEAR(run(chain, input, 10), 2.0, 1e-12);
  input.device_ready = false;
  chain.tick(input);
  chain.cut();
  EXPECT_EQ(run(chain, input, 500), 0.0);
  input.device_ready = true;
  EXPECT_EQ(run(chain, input, 500), 0.0) << "2 N is no small force";
  input.force_D = dvec3(0.0);
  run(chain, input, 5);
  input.force_D = dvec3(0, 0, 2);
  double last = 0.0;
  for (int i = 0; i < 900; ++i) {
    const double now = glm::length(chain.tick(input).force_D);
    EXPECT_LE(now - last, 0.02) << i;
    last = now;
  }
  EXPECT_NEAR(last, 2.0, 1e-12) << "without being enabled anew";
}

TEST(SafetyChain, AStylusThatIsFasterThanAHandTrips) {
  for (const dvec3& v : {dvec3(0, 4.1, 0), dvec3(-40, 0, 0), dvec3(kNan, 0, 0), dvec3(0, 0, kInf)}) {
    SafetyChain chain = openChain();
    SafetyInput input = wanting(dvec3(0, 0, 2));
    ASSERT_NEAR(run(chain, input, 10), 2.0, 1e-12);
    input.v_DS = v;
    EXPECT_NEAR(run(chain, input, 4), 2.0, 1e-12) << "a few samples";
    EXPECT_TRUE(chain.tick(input).too_fast);
    input.v_DS = dvec3(0.0);
    EXPECT_EQ(run(chain, input, 60), 0.0);
    input.force_D = dvec3(0.0);
    run(chain, input, 2000);
    EXPECT_EQ(chain.tick(input).gate, GateState::kClosed) << "until it is enabled anew";
  }
  SafetyChain chain = openChain();
  SafetyInput input = wanting(dvec3(0, 0, 2));
  input.v_DS = dvec3(0, 3.9, 0);
  EXPECT_NEAR(run(chain, input, 500), 2.0, 1e-12);
}

TEST(SafetyChain, AClientOfAQuickHeartIsMissedAsQuickly) {
  SafetyOptions options;
  options.close_decay = 0.02;
  SafetyChain chain = openChain(options);
  SafetyInput input = wanting(dvec3(0, 0, 6));
  input.silence_limit = 0.028;
  EXPECT_NEAR(run(chain, input, 10), 6.0, 1e-12);
  const int ticks = ticksToZero(chain, input, 1000);
  EXPECT_GT(ticks, 28);
  EXPECT_LE(ticks, 50);
  EXPECT_EQ(run(chain, input, 300), 0.0) << "heard again: by the gate";
  input.silence_limit = 5.0;
  chain = openChain(options);
  EXPECT_GT(ticksToZero(chain, input, 2000), 600) << "never longer than the option";
  EXPECT_LE(ticksToZero(chain, input, 2000), 1) << "and then it stays";
}

TEST(SafetyChain, CountsAWrongNumberAsZeroAndSaysSo) {
  for (const double bad : {kNan, kInf, -kInf, 1e300}) {
    SafetyChain chain = openChain();
    run(chain, wanting(dvec3(0, 0, 6.4)), 20);
    const SafetyResult result = chain.tick(wanting(dvec3(0, bad, 0)));
    EXPECT_TRUE(result.input_fault);
    EXPECT_NEAR(glm::length(result.force_D), 5.4, 1e-9);
    EXPECT_EQ(run(chain, wanting(dvec3(bad, 0, 0)), 7), 0.0) << "6.4 N are down in 7 ms";
  }
}

TEST(SafetyChain, ReplacesOptionsThatMakeNoSense) {
  SafetyOptions options;
  options.peak_force = kNan;
  options.slew = -1.0;
  options.ramp_time = 0.0;
  options.ramp_damping = kInf;
  const SafetyChain chain(options);
  EXPECT_EQ(chain.options().peak_force, 6.4);
  EXPECT_EQ(chain.options().slew, 1000.0);
  EXPECT_EQ(chain.options().ramp_time, 0.8);
  EXPECT_EQ(chain.options().ramp_damping, 2.0);
}

/// Any number at all, the odd ones often.
rc::Gen<double> anyNumber() {
  return rc::gen::oneOf(
      rc::gen::element(0.0, -0.0, kNan, kInf, -kInf, 5e-324, -5e-324, 1e-310, 1e308, -1e308, 9999.0, 6.4, -6.4),
      rc::gen::map(rc::gen::inRange(-20000, 20001), [](int n) { return n * 1e-3; }));
}

rc::Gen<dvec3> anyVector() {
  return rc::gen::apply([](double x, double y, double z) { return dvec3(x, y, z); }, anyNumber(), anyNumber(),
                        anyNumber());
}

rc::Gen<SafetyInput> anyInput() {
  return rc::gen::apply(
      [](const dvec3& force, const dvec3& velocity, int flags, double silence, double temperature) {
        SafetyInput input;
        input.force_D = force;
        input.v_DS = velocity;
        input.enabled = flags % 8 != 0;
        input.link_open = flags % 11 != 0;
        input.dt = flags % 5 == 0 ? silence * 1e-3 : kTick;
        input.link_silence = flags % 3 == 0 ? silence : 0.0;
        input.reported_temperature = flags % 7 == 0 ? temperature : 0.0;
        return input;
      },
      anyVector(), anyVector(), rc::gen::inRange(0, 10000), anyNumber(), anyNumber());
}

RC_GTEST_PROP(SafetyChainProperty, NeverBreaksClampOrSlewWhateverComes, ()) {
  SafetyChain chain = openChain();
  const auto inputs = *rc::gen::container<std::vector<SafetyInput>>(200, anyInput());
  dvec3 last(0.0);
  for (const SafetyInput& input : inputs) {
    const SafetyResult result = chain.tick(input);
    RC_ASSERT(std::isfinite(result.force_D.x) && std::isfinite(result.force_D.y) && std::isfinite(result.force_D.z));
    RC_ASSERT(glm::length(result.force_D) <= 6.4 * (1.0 + 1e-12));
    RC_ASSERT(glm::length(result.force_D - last) <= 1.0 + 1e-9);
    last = result.force_D;
  }
}

RC_GTEST_PROP(SafetyChainProperty, ReachesZeroWithinItsTimeFromAnywhere, ()) {
  SafetyChain chain = openChain();
  for (const SafetyInput& input : *rc::gen::container<std::vector<SafetyInput>>(60, anyInput())) chain.tick(input);
  SafetyInput closed;
  closed.link_open = false;
  const bool odd = *rc::gen::arbitrary<bool>();
  closed.force_D = odd ? dvec3(kNan) : dvec3(5.0);
  closed.enabled = true;
  RC_ASSERT(ticksToZero(chain, closed, 60) <= 50);
}

}  // namespace
}  // namespace hapticell::haptic
