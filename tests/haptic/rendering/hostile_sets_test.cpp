// SPDX-License-Identifier: Apache-2.0
// Sets whose every number is finite and that mean harm: nothing of them outlives them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/haptic/rendering/rendered_floor.h"

namespace hapticell::haptic {
namespace {

double drawn(double from, double to) {
  return from + (to - from) * 1e-6 * *rc::gen::inRange(0, 1'000'001);
}

/// 0, or of any size from denormal to `most`, even on the way up, half of them negative.
double anySize(double most) {
  if (*rc::gen::inRange(0, 8) == 0) return 0.0;
  if (*rc::gen::inRange(0, 8) == 0) return most;
  const double size = std::min(most, std::pow(10.0, drawn(-320.0, std::log10(most))));
  return *rc::gen::arbitrary<bool>() ? size : -size;
}

/// Half of them like a row that means well, so that rows hold each other and the proxy.
double anyPart(double most) {
  return *rc::gen::arbitrary<bool>() ? drawn(-1.0, 1.0) : anySize(most);
}

struct Most {
  double length = bound::kLength, slope = bound::kSlope, curvature = bound::kCurvature, friction = bound::kFriction,
         damping = bound::kDamping, stiffness = bound::kStiffness, speed = bound::kSpeed;
  static Most ofDouble() { return {1e308, 1e308, 1e308, 1e308, 1e308, 1e308, 1e308}; }
};

Constraint anyRow(const Most& most) {
  Constraint row;
  row.group = *rc::gen::inRange(0u, 4u);
  row.kind = *rc::gen::element(ConstraintKind::kInequality, ConstraintKind::kEquality, ConstraintKind::kPull);
  row.gap = *rc::gen::arbitrary<bool>() ? drawn(-0.01, 0.01) : anySize(most.length);
  for (double& part : row.gradient) part = anyPart(most.slope);
  if (*rc::gen::arbitrary<bool>())
    for (double& part : row.curvature) part = anyPart(most.curvature);
  row.has_trim = *rc::gen::arbitrary<bool>();
  if (row.has_trim) {
    row.trim_gap = anySize(most.length);
    for (double& part : row.trim_gradient) part = anyPart(most.slope);
  }
  row.stiffness = std::abs(anySize(most.stiffness));
  row.damping = std::abs(anySize(most.damping));
  row.friction = std::abs(anySize(most.friction));
  row.reach = std::abs(anySize(most.length));
  row.velocity_D = {anySize(most.speed), anySize(most.speed), anySize(most.speed)};
  return row;
}

ConstraintSet anySet(const Most& most, const Pose& X_DR, std::uint64_t sequence) {
  ConstraintSet set;
  set.sequence = sequence;
  set.X_DR = X_DR;
  set.zone_radius = *rc::gen::arbitrary<bool>() ? kWantedZoneRadius : std::abs(anySize(most.length));
  set.count = *rc::gen::inRange<std::size_t>(1, 9);
  for (std::size_t i = 0; i < set.count; ++i) set.constraints[i] = anyRow(most);
  return set;
}

void expectSound(const RenderResult& result) {
  RC_ASSERT(result.X_DP.isValid());
  RC_ASSERT(glm::length(result.X_DP.p) < 2.0);  // Whatever a set says, the proxy goes by millimetres.
  RC_ASSERT(std::isfinite(glm::length(result.force_D)) && std::isfinite(glm::length(result.torque_D)));
  RC_ASSERT(std::isfinite(glm::length(result.v_DS)) && std::isfinite(result.energy));
}

/// After whatever was, a clean set holds the proxy where it should and is felt. (How much of it at once is a matter of
/// the energy account: what the set before has made is taken back first.)
void expectCured(ForceRenderer& renderer, std::uint64_t sequence, Pose X_DS) {
  // It may have been led away, by some millimetres a tick.
  for (int i = 0; i < 60 && (i < 10 || glm::distance(renderer.proxy().p, X_DS.p) > 1e-6); ++i) {
    ConstraintSet none;
    none.sequence = sequence++;
    none.X_DR = renderer.proxy();
    RC_ASSERT(renderer.adopt(none) == Adoption::kAdopted);
    for (int k = 0; k < 120; ++k) expectSound(renderer.tick(X_DS, kTick));
  }
  const dvec3 above = X_DS.p;
  ConstraintSet floor = floorSet(sequence);
  floor.X_DR = renderer.proxy();
  floor.constraints[0].gap = 0.002;
  RC_ASSERT(renderer.adopt(floor) == Adoption::kAdopted);
  RenderResult result;
  for (int k = 0; k < 400; ++k)
    result = renderer.tick({above - dvec3(0.0, 0.0, std::min(0.004, 2e-5 * k)), X_DS.q}, kTick);
  expectSound(result);
  RC_LOG() << "proxy off by " << glm::length(result.X_DP.p - above) << " m, force " << result.force_D.z << " N, rows "
           << result.active_rows << ", zone's edge " << result.at_zone_edge << ", energy " << result.energy << '\n';
  RC_ASSERT(result.contact);
  RC_ASSERT(std::abs(result.X_DP.p.z - (above.z - 0.002)) < 1e-5);
  RC_ASSERT(result.force_D.z > 0.2 && result.force_D.z < 3.0);
}

void render(const Most& most, bool turning) {
  RendererOptions options;
  options.peak_torque = turning ? 0.3 : 0.0;
  ForceRenderer renderer(options);
  Pose X_DS = at(0.0, 0.0, 0.0);
  renderer.reset(X_DS);
  std::uint64_t sequence = 0;
  for (int i = 0; i < 6; ++i) {
    renderer.adopt(anySet(most, renderer.proxy(), ++sequence), drawn(0.0, 2.0));
    for (int k = 0; k < 12; ++k) {
      X_DS.p += dvec3(drawn(-1e-3, 1e-3), drawn(-1e-3, 1e-3), drawn(-1e-3, 1e-3));
      X_DS.q = glm::normalize(quaternionFromRotationVector({drawn(-0.01, 0.01), 0.0, 0.005}) * X_DS.q);
      expectSound(renderer.tick(X_DS, kTick));
    }
  }
  expectCured(renderer, ++sequence, X_DS);
}

RC_GTEST_PROP(HostileSets, AnyNumbersWithinTheBoundsKeepTheProxyANumber, ()) {
  render({}, *rc::gen::arbitrary<bool>());
}

RC_GTEST_PROP(HostileSets, AnyFiniteNumbersDo, ()) {
  render(Most::ofDouble(), *rc::gen::arbitrary<bool>());
}

/// The frames that were found: an equality far off that rubs without end, alone and among others.
TEST(HostileSets, TheOnesThatWereFoundHarmNoSetAfterThem) {
  for (const double gap : {1e150, 1e10, 1e6, 1.0, 0.0}) {
    for (const double friction : {1e300, 1e10, 1e4, 1.0, 0.0}) {
      for (const double speed : {1e308, 1e160, 1e20, 1e6, 0.0}) {
        for (const ConstraintKind kind : {ConstraintKind::kInequality, ConstraintKind::kEquality}) {
          ForceRenderer renderer;
          renderer.reset(at(0, 0, 0.005));
          ConstraintSet set = floorSet(1);
          Constraint& row = set.constraints[0];
          row.gap = gap;
          row.gradient = {1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
          row.kind = kind;
          row.friction = friction;
          row.velocity_D.x = speed;
          renderer.adopt(set);
          for (int i = 0; i < 20; ++i) {
            const RenderResult result = renderer.tick(at(0, 0, 0.005), kTick);
            ASSERT_TRUE(result.X_DP.isValid()) << gap << ' ' << friction << ' ' << speed;
            ASSERT_TRUE(std::isfinite(glm::length(result.force_D)));
          }
          ConstraintSet clean = floorSet(2);
          clean.X_DR = renderer.proxy();
          clean.constraints[0].gap = clean.X_DR.p.z;
          ASSERT_EQ(renderer.adopt(clean), Adoption::kAdopted);
          ASSERT_TRUE(renderer.tick(at(0, 0, 0.005), kTick).X_DP.isValid());
        }
      }
    }
  }
}

/// A coupling whose damping is no wish of anybody's: what it makes is no number, and the tick ends all the same.
TEST(HostileSets, ATickThatMakesNoNumbersEndsWithTheLastGoodProxyAndWithoutTheSet) {
  ForceRenderer renderer(RendererOptions{.damping = 1e308, .adapt = false});
  renderer.reset(at(0, 0, 0.001));
  ASSERT_EQ(renderer.adopt(floorSet(1)), Adoption::kAdopted);
  bool dropped = false;
  dvec3 last(0.0, 0.0, 0.001);
  for (int i = 0; i < 40 && !dropped; ++i) {
    last = renderer.proxy().p;
    const RenderResult result = renderer.tick(at(1e-4 * i, 0, 0.001 - 2e-4 * i), kTick);
    ASSERT_TRUE(result.X_DP.isValid());
    ASSERT_TRUE(std::isfinite(glm::length(result.force_D)));
    dropped = result.dropped;
    if (!dropped) continue;
    EXPECT_EQ(result.X_DP.p, last);
    EXPECT_EQ(result.force_D, dvec3(0.0));
    EXPECT_EQ(result.adopted_set, 0u);
  }
  EXPECT_TRUE(dropped);
  renderer.setOptions({});
  renderer.reset(at(0, 0, 0.005));
  ASSERT_EQ(renderer.adopt(floorSet(2)), Adoption::kAdopted);
  EXPECT_NEAR(moveTo(renderer, dvec3(0, 0, 0.005), dvec3(0, 0, -0.002)).force_D.z, 2.0, 0.01);
}

TEST(LimitedByDelay, NoClientGetsADampingThatKicks) {
  for (const double delay : {0.001, 0.002, 0.004}) {
    RendererOptions options;
    options.delay = delay;
    options.damping = 160.0;
    EXPECT_EQ(limitedByDelay(options).damping, 8.0);
  }
}

}  // namespace
}  // namespace hapticell::haptic
