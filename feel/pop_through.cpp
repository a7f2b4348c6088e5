// SPDX-License-Identifier: Apache-2.0
#include "feel/pop_through.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace hapticell::feel {

namespace {

constexpr double kSweepTick = 0.001;
constexpr double kHalfWidth = 0.05, kHalfThickness = 0.0005;
/// m/s of the sweeps (0.05 to 1.0): a fast hand in free air. It sets the zone that a client asks for; half: sweeps
/// leave it, and it holds them; twice: twice the zone.
constexpr double kFastest = 1.0;
/// m from the rim that a chord may cut off: between two ticks at 1 m/s a proxy goes 2 mm (kLongestMove) twice. Half:
/// going round counts as a pop; twice: pops near the rim are not seen.
constexpr double kRim = 0.004;
/// m that a blocked proxy is away from plate and stylus: five steps of the encoders (0.02 mm). Half: tremor counts as
/// blocked; twice: a short block is missed.
constexpr double kHeldApart = 1e-4;

struct Sweep {
  dvec3 from{0.0}, to{0.0};
  double speed = 0.1;
  double tremor_hz = 10.0, tremor = 0.0;

  double duration() const { return glm::length(to - from) / speed; }
  /// What the encoders tell at `s` seconds.
  dvec3 at(double s) const {
    const double shake = tremor * std::sin(2.0 * std::numbers::pi * tremor_hz * s);
    return glm::round((glm::mix(from, to, s / duration()) + dvec3(0, 0, shake)) / 2e-5) * 2e-5;
  }
};

/// From one side to the other, straight, beside and over the rim too.
Sweep randomSweep(std::mt19937_64& random) {
  std::uniform_real_distribution<double> side(-0.06, 0.06), height(0.004, 0.02), unit(0.0, 1.0);
  Sweep sweep;
  const double sign = unit(random) < 0.5 ? -1.0 : 1.0;
  sweep.from = {side(random), side(random), sign * height(random)};
  sweep.to = {side(random), side(random), -sign * height(random)};
  sweep.speed = 0.05 * std::pow(20.0, unit(random));
  sweep.tremor_hz = 10.0 + 20.0 * unit(random);
  sweep.tremor = 0.5e-3 * unit(random);
  return sweep;
}

double outsidePlate(const dvec3& p) {
  const dvec3 over = glm::abs(p) - dvec3(kHalfWidth, kHalfWidth, kHalfThickness);
  return std::max({over.x, over.y, over.z});
}

bool isBlocked(const haptic::RenderResult& result, const dvec3& p_DS) {
  return result.contact && outsidePlate(result.X_DP.p) > kHeldApart &&
         glm::distance(result.X_DP.p, p_DS) > kHeldApart && outsidePlate(p_DS) > kHeldApart;
}

void run(const Sweep& sweep, const FeelScene& plate, const SweepSetup& setup, SweepOutcome& outcome) {
  std::unique_ptr<RenderingWay> way;
  if (setup.classic)
    way = std::make_unique<ClassicWay>(haptic::RendererOptions{});
  else
    way = std::make_unique<ProxyWay>(haptic::RendererOptions{});
  SlowClient client(plate, setup.rate);
  const double reach = kFastest * (1.0 / setup.rate.rate_hz + setup.rate.latency) + 0.002;
  client.setZone(setup.zone_share * std::max(haptic::kWantedZoneRadius, reach));
  way->reset(Pose::translation(sweep.from));
  double t = 0.0;
  // The client has time to speak first, as behind the engage gate.
  for (; t < setup.rate.latency + 0.005; t += kSweepTick) {
    client.step(t, *way);
    way->tick(Pose::translation(sweep.from), kSweepTick);
  }
  const double start = t, duration = sweep.duration();
  if (setup.stalls) client.stall(start + 0.3 * duration, start + 0.3 * duration + 0.3);
  dvec3 before = sweep.from;
  for (; t < start + duration; t += kSweepTick) {
    const dvec3 p_DS = sweep.at(t - start);
    client.step(t, *way);
    const haptic::RenderResult result = way->tick(Pose::translation(p_DS), kSweepTick);
    outcome.penetration = std::max(outcome.penetration, plate.penetration(result.X_DP, t));
    outcome.pops += crossesPlate(before, result.X_DP.p) ? 1 : 0;
    outcome.blocked += isBlocked(result, p_DS) ? 1 : 0;
    before = result.X_DP.p;
  }
}

}  // namespace

bool crossesPlate(const dvec3& a, const dvec3& b) {
  if (!(std::abs(a.z) >= 0.9 * kHalfThickness && std::abs(b.z) >= 0.9 * kHalfThickness && a.z * b.z < 0.0))
    return false;
  const dvec3 at = glm::mix(a, b, a.z / (a.z - b.z));
  return std::max(std::abs(at.x), std::abs(at.y)) < kHalfWidth - kRim;
}

SweepOutcome sweepThroughPlate(const SweepSetup& setup) {
  const auto plate = plateScene();
  std::mt19937_64 random(setup.seed);
  SweepOutcome outcome;
  for (int i = 0; i < setup.sweeps; ++i) run(randomSweep(random), *plate, setup, outcome);
  return outcome;
}

}  // namespace hapticell::feel
