// SPDX-License-Identifier: Apache-2.0
// The feel of docs/dev/feel.md in virtual time: what the hand meets must not depend on the client's rate.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <random>

#include "feel/feel_session.h"
#include "tests/support/test_data.h"

namespace hapticell::feel {
namespace {

// One step of a joint's encoder is this far at the tip where the arm is most stretched.
constexpr double kCount = 0.03e-3;

using SceneMaker = std::unique_ptr<FeelScene> (*)();

struct Case {
  const char* name;
  SceneMaker make;
  /// What the turning stylus presses is felt only as far as somebody pays (docs/dev/feel.md): shallower, never deeper.
  bool pressed_by_the_wrist = false;
};

std::ostream& operator<<(std::ostream& stream, const Case& c) {
  return stream << c.name;
}

const Case kCases[] = {{"plane", [] { return planeScene(); }},
                       {"cylinder_R50", [] { return cylinderScene(0.05); }},
                       {"cylinder_R10", [] { return cylinderScene(0.01); }},
                       {"bore_R10", [] { return boreScene(0.01); }},
                       {"edge", [] { return edgeScene(); }},
                       {"corner", [] { return cornerScene(); }},
                       {"hinge", [] { return hingeScene(); }},
                       {"box", [] { return boxScene(); }, true},
                       {"peg", [] { return pegScene(); }}};

void report(const std::string& name, ClientRate rate, const FeelFigures& f) {
  std::printf(
      "%-13s %5.0f Hz: step %.3f N/ms, penetration %.4f mm, depth %.1f %% / %.3f mm, direction %.2f deg, "
      "energy %.3f mJ, largest %.2f N\n",
      name.c_str(), rate.rate_hz, f.step_n, f.penetration * 1e3, f.depth_error_p95 * 100, f.depth_error_max * 1e3,
      f.direction_p95_deg, f.energy_min * 1e3, f.force_max);
}

class FeelOf : public ::testing::TestWithParam<Case> {};

TEST_P(FeelOf, SlidesAlikeAtEveryRate) {
  for (const ClientRate rate : kRates) {
    const auto scene = GetParam().make();
    FeelSession session(*scene, {rate});
    touchAndSlide(session, *scene, 4.0);
    const FeelFigures figures = session.figures();
    report(GetParam().name, rate, figures);
    SCOPED_TRACE(rate.rate_hz);
    EXPECT_GT(figures.contact_ticks, 2000) << "the scene must be felt";
    EXPECT_GT(figures.force_max, 1.9);
    EXPECT_LT(figures.force_max, 6.4);
    EXPECT_LE(figures.step_n, 0.12);
    EXPECT_LE(figures.penetration, 0.05e-3);
    EXPECT_LE(figures.depth_excess_max, 0.15e-3);
    EXPECT_LE(figures.direction_p95_deg, 3.0);
    EXPECT_GE(figures.energy_min, -0.5e-3);
    if (GetParam().pressed_by_the_wrist) continue;
    EXPECT_LE(figures.depth_error_p95, 0.03);
    EXPECT_LE(figures.depth_error_max, 0.15e-3);
    EXPECT_EQ(figures.free_force_max, 0.0);
  }
}

TEST_P(FeelOf, ComesToRestUnderFirmAndLooseHands) {
  for (const ClientRate rate : kRates) {
    for (const haptic::HandOptions& hand : {haptic::HandOptions::firm(), haptic::HandOptions::loose()}) {
      const auto scene = GetParam().make();
      FeelSession session(*scene, {rate, hand});
      pressAtRest(session, *scene);
      EXPECT_GT(glm::length(session.safety().force_D), 1.0);
      EXPECT_LE(session.wobble(0.5), kCount) << rate.rate_hz << " Hz, b " << hand.damping;
    }
  }
}

TEST_P(FeelOf, ComesToRestWhenLetGo) {
  for (const ClientRate rate : kRates) {
    const auto scene = GetParam().make();
    config::DeviceProfile profile;
    profile.mechanics.weight = 0.44;  // All of the apparent mass: the worst case of the trial.
    FeelSession session(*scene, {rate, {}, profile});
    pressAtRest(session, *scene);
    session.letGo(3.0);
    EXPECT_LE(session.wobble(0.5), kCount) << rate.rate_hz;
  }
}

TEST_P(FeelOf, RidesOutAStallOfTheClient) {
  for (const ClientRate rate : kRates) {
    const auto scene = GetParam().make();
    FeelSession session(*scene, {rate});
    session.client().stall(2.0, 2.5);
    touchAndSlide(session, *scene, 2.5);
    const FeelFigures figures = session.figures();
    SCOPED_TRACE(rate.rate_hz);
    EXPECT_LE(figures.step_n, 0.12);
    EXPECT_LE(figures.penetration, 0.05e-3);
    EXPECT_GE(figures.energy_min, -0.5e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, FeelOf, ::testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Feel, FacetsOfTenDegreesAreNoSteps) {
  for (const ClientRate rate : kRates) {
    const auto scene = facetScene(0.01, 10.0);
    FeelSession session(*scene, {rate});
    touchAndSlide(session, *scene, 4.0);
    const FeelFigures figures = session.figures();
    report("facets", rate, figures);
    EXPECT_LE(figures.step_n, 0.12) << rate.rate_hz;
    EXPECT_LE(figures.penetration, 0.05e-3) << rate.rate_hz;
    EXPECT_GE(figures.energy_min, -0.5e-3) << rate.rate_hz;
  }
}

TEST(Feel, LongerDelaysStayStableWithTheirStiffness) {
  for (const int delay : {1, 2, 3}) {
    for (const bool released : {false, true}) {
      config::DeviceProfile profile;
      profile.electronics.delay_ticks = delay;
      profile.mechanics.weight = released ? 0.44 : profile.mechanics.weight;
      haptic::RendererOptions options;
      options.delay = 1e-3 * delay;
      for (const Case& c : {kCases[0], kCases[5]}) {
        const auto scene = c.make();
        FeelSession session(*scene, {kRates[1], haptic::HandOptions::loose(), profile, options});
        pressAtRest(session, *scene);
        if (released) session.letGo(3.0);
        EXPECT_LE(session.wobble(0.5), kCount) << c.name << ", " << delay << " ms, released " << released;
      }
    }
  }
}

TEST(Feel, SixDrivenAxesComeToRestToo) {
  config::DeviceProfile profile;
  profile.driven_axes = 6;
  profile.peak_torque = 0.188;
  for (const Case& c : {kCases[7], kCases[8]}) {
    const auto scene = c.make();
    FeelSession session(*scene, {kRates[1], haptic::HandOptions::loose(), profile});
    pressAtRest(session, *scene);
    EXPECT_LE(session.wobble(0.5), kCount) << c.name;
    session.letGo(3.0);
    EXPECT_LE(session.wobble(0.5), kCount) << c.name << ", let go";
    EXPECT_LE(glm::length(session.device().trueAngularVelocity()), 0.01) << c.name;
  }
}

TEST(Feel, TheMeasureSeesALimitCycle) {
  // A stiffness for one millisecond of delay on a device that has four.
  config::DeviceProfile profile;
  profile.electronics.delay_ticks = 4;
  profile.mechanics.weight = 0.44;
  haptic::RendererOptions options;
  options.stiffness = 1490.0;
  const auto scene = planeScene();
  FeelSession session(*scene, {kRates[1], haptic::HandOptions::loose(), profile, options});
  pressAtRest(session, *scene);
  session.letGo(3.0);
  EXPECT_GT(session.wobble(0.5), 5.0 * kCount);
}

TEST(Feel, EveryShippedProfileComesToRest) {
  for (const char* name : {"phantom_desktop", "touch", "touch_x", "premium"}) {
    const auto file = hapticell::test::sourceFile(std::string("config/devices/") + name + ".toml");
    const auto profile = config::readDeviceProfile(file);
    ASSERT_TRUE(profile.has_value()) << profile.error().message();
    haptic::RendererOptions options;
    options.stiffness = profile->stiffness;
    options.damping = profile->damping;
    options.peak_force = profile->peak_force;
    for (const Case& c : {kCases[0], kCases[5]}) {
      const auto scene = c.make();
      FeelSession session(*scene, {kRates[1], haptic::HandOptions::loose(), *profile, options});
      pressAtRest(session, *scene);
      EXPECT_GT(glm::length(session.safety().force_D), 0.8) << name;
      EXPECT_LE(session.wobble(0.5), 1.5 * profile->resolution) << name << ", " << c.name;
      session.letGo(3.0);
      EXPECT_LE(session.wobble(0.5), 1.5 * profile->resolution) << name << ", " << c.name << ", let go";
    }
  }
}

TEST(Feel, FreeMotionCostsExactlyNothing) {
  int ticks = 0;
  for (const ClientRate rate : kRates) {
    for (const Case& c : {kCases[2], kCases[5]}) {
      const auto scene = c.make();
      // A hand so stiff that the stylus goes where the path goes, without overshoot into the obstacle.
      haptic::HandOptions stiff;
      stiff.stiffness = 20000.0;
      stiff.damping = 60.0;
      FeelSession session(*scene, {rate, stiff});
      const dvec3 middle = scene->start() + dvec3(0.012, 0.012, 0.020);
      session.begin(middle);
      double largest = 0.0;
      int contacts = 0;
      for (int i = 0; i < 10000; ++i) {
        // Up to 1 m/s; 25 mm to and fro beside the obstacle.
        const double t = i * 1e-3, w = 40.0 * std::min(1.0, t / 5.0);
        const dvec3 swing(0.010 * std::sin(w * t), 0.010 * std::sin(0.7 * w * t), 0.012 * std::sin(1.3 * w * t));
        session.follow([&](double) { return middle + swing; }, 1e-3);
        contacts += session.last().contact ? 1 : 0;
        largest = std::max(largest, glm::length(session.last().force_D));
        ++ticks;
      }
      EXPECT_EQ(contacts, 0) << c.name;
      EXPECT_EQ(largest, 0.0) << c.name;
      EXPECT_EQ(session.safety().gate, haptic::GateState::kOpen);
    }
  }
  EXPECT_EQ(ticks, 60000);
}

TEST(Feel, OffsetIsGoneSoonAfterRelease) {
  const auto scene = cylinderScene(0.01);
  FeelSession session(*scene, {kRates[0]});
  touchAndSlide(session, *scene, 1.0);
  const dvec3 from = session.device().truePose().p;
  session.follow([&](double t) { return from + dvec3(0, 0, std::min(0.02, 0.4 * t)); }, 0.2);
  ASSERT_FALSE(session.last().contact);
  EXPECT_EQ(glm::length(session.last().force_D), 0.0);
  EXPECT_EQ(glm::length(session.last().offset_D), 0.0);
}

TEST(Feel, TapsMakeNoEnergy) {
  // 3 Hz taps of up to 0.25 m/s with a loose hand.
  for (const ClientRate rate : kRates) {
    const auto scene = planeScene();
    FeelSession session(*scene, {rate, haptic::HandOptions::loose()});
    session.begin(dvec3(0, 0, 0.01));
    session.follow([&](double t) { return dvec3(0, 0, 0.008 * std::cos(6.0 * std::numbers::pi * t) + 0.002); }, 3.0);
    EXPECT_GE(session.figures().energy_min, -1e-3) << rate.rate_hz;
    EXPECT_GT(session.figures().force_max, 0.5);
  }
}

TEST(Feel, FrictionSlidesAtItsCoefficient) {
  for (const ClientRate rate : kRates) {
    const auto scene = planeScene();
    scene->friction = 0.4;
    FeelSession session(*scene, {rate});
    session.begin(dvec3(-0.03, 0, 0.004));
    session.follow([&](double t) { return dvec3(-0.03, 0, 0.004 - (0.004 + kPress) * std::min(1.0, t / 0.3)); }, 0.5);
    double ratio_sum = 0.0;
    for (int i = 0; i < 400; ++i) {
      session.follow([&](double) { return dvec3(-0.03 + 1e-4 * i, 0, -kPress); }, 1e-3);
      const dvec3 spring = session.last().spring_D;
      if (i >= 200) ratio_sum += std::hypot(spring.x, spring.y) / spring.z / 200.0;
    }
    EXPECT_NEAR(ratio_sum, 0.4, 0.004) << rate.rate_hz;
    EXPECT_LE(session.figures().step_n, 0.13) << rate.rate_hz;
  }
}

/// A plane whose every set has a normal that is off by up to 0.6 degrees, as from a scanned mesh.
class NoisyPlane final : public FeelScene {
 public:
  std::string name() const override { return "noisy plane"; }
  ConstraintSet setAt(const Pose& X_DP, double) const override {
    std::uniform_real_distribution<double> noise(-0.0105, 0.0105);
    ConstraintSet set;
    set.X_DR = X_DP;
    set.count = 1;
    const dvec3 normal = glm::normalize(dvec3(noise(random_), noise(random_), 1.0));
    set.constraints[0] = planeConstraint(dvec3(X_DP.p.x, X_DP.p.y, 0.0), normal, X_DP, 0);
    set.constraints[0].friction = friction;
    return set;
  }
  double penetration(const Pose& X_DP, double) const override { return std::max(0.0, -X_DP.p.z); }
  dvec3 handAt(double t, double press) const override { return {0.1 * t - 0.04, 0.0, -press}; }

 private:
  mutable std::mt19937 random_{7};
};

TEST(Feel, FrictionSticksWithoutDrift) {
  for (const ClientRate rate : kRates) {
    NoisyPlane scene;
    scene.friction = 0.3;
    FeelSession session(scene, {rate});
    session.begin(dvec3(0, 0, 0.004));
    // A pull to the side of half the friction.
    const dvec3 goal(0.5 * 0.3 * kPress, 0, -kPress);
    session.follow([&](double t) { return glm::mix(dvec3(0, 0, 0.004), goal, std::min(1.0, t / 0.3)); }, 1.0);
    const dvec3 before = session.last().X_DP.p;
    session.follow([&](double) { return goal; }, 5.0);
    const dvec3 moved = session.last().X_DP.p - before;
    EXPECT_LT(std::hypot(moved.x, moved.y), 0.02e-3) << rate.rate_hz;
  }
}

TEST(Feel, NoisyNormalsAreNotFeltAsSteps) {
  for (const ClientRate rate : kRates) {
    NoisyPlane scene;
    FeelSession session(scene, {rate});
    session.begin(dvec3(-0.04, 0, 0.004));
    session.follow([&](double t) { return dvec3(-0.04, 0, 0.004 - (0.004 + kPress) * std::min(1.0, t / 0.3)); }, 0.5);
    session.follow([&](double t) { return scene.handAt(t, kPress); }, 0.8);
    EXPECT_LE(session.figures().step_n, 0.13) << rate.rate_hz;
  }
}

}  // namespace
}  // namespace hapticell::feel
