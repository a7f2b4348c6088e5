// SPDX-License-Identifier: Apache-2.0
// M3 of taps, M6 in free motion and after letting go.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "feel/figure_job.h"

namespace hapticell::feel {

namespace {

// Hz: about as quickly as a hand taps. Half: half of the energy in the worst second; twice: twice.
constexpr double kTapRate = 3.0;
// Ticks in which the swing grows, one period of kTapRate (333), so that the stylus meets the wall as fast as the hand
// means it to. Half: it overshoots; twice: fewer taps at full speed.
constexpr double kSwingUp = 300.0;
// s from the measurement to the middle of the force that answers it: a tick of delay, and half of the one that it acts.
// Half or twice would misstate the energy that is printed beside the taps.
constexpr double kMotorDelay = 1.5e-3;

struct TapOutcome {
  double energy = 0.0;  // J, least of a second.
  double speed = 0.0;   // m/s at which the stylus touched at most.
  double depth = 0.0;   // m.
};

TapOutcome tap(const FeelScene& scene, const SessionSetup& setup, double speed) {
  FeelSession session(scene, setup);
  const double omega = 2.0 * std::numbers::pi * kTapRate, swing = speed / omega;
  session.begin(dvec3(0, 0, 1.45 * swing));
  TapOutcome outcome;
  bool touching = false;
  for (int i = 1; i <= 3000; ++i) {
    // Swings up slowly: the stylus is to meet the wall as fast as the hand means it to.
    const double share = std::min(1.0, i / kSwingUp);
    const dvec3 hand(0, 0, swing * (share * std::cos(1e-3 * omega * i) + 1.45 - share));
    session.follow([&](double) { return hand; }, 1e-3);
    const haptic::RenderResult& now = session.last();
    if (now.contact && !touching) outcome.speed = std::max(outcome.speed, glm::length(now.v_DS));
    outcome.depth = std::max(outcome.depth, glm::distance(now.X_DP.p, session.device().truePose().p));
    touching = now.contact;
  }
  outcome.energy = session.figures().energy_min;
  return outcome;
}

std::vector<Figure> tapFigures(double speed, bool judged) {
  std::vector<Figure> figures;
  const auto scene = planeScene();
  SessionSetup setup;
  setup.hand = haptic::HandOptions::loose();
  setup.rate = kRates[0];
  setup.classic = true;
  const TapOutcome classic = tap(*scene, setup, speed);
  setup.classic = false;
  for (const ClientRate& rate : kRates) {
    setup.rate = rate;
    const TapOutcome ours = tap(*scene, setup, speed);
    // What an undamped wall would make of three taps a second: 2 K v d t_d each.
    const double leak = -kTapRate * 2.0 * 1000.0 * ours.speed * ours.depth * kMotorDelay;
    const std::string name = judged ? "taps of 0.25 m/s" : "taps of 0.56 m/s beside 2 K v d t_d";
    figures.push_back({"M3.taps", name, rateName(rate), "mJ", 1e3 * ours.energy, judged ? -1.0 : 1e3 * leak, true,
                       1e3 * classic.energy});
  }
  return figures;
}

/// Presses into the wall and stays there while the force still comes in (the ramp of 0.8 s after taking): the motors
/// must not give what they did not take. J.
double takingEnergy(const FeelScene& scene, const SessionSetup& setup, double force) {
  /// s: at rest (the gate opens after three ticks), pressing, and staying (over twice the ramp of 0.8 s). Half of the
  /// last: just the ramp; twice: the same figure, unless something leaks.
  constexpr double kGate = 0.02, kPressing = 0.15, kStaying = 2.0;
  FeelSession session(scene, setup);
  const dvec3 outside = scene.start();
  const dvec3 goal = scene.rest() + pressDepth(session.hand(), force) * scene.pressDirection();
  session.begin(outside, kGate);
  session.follow([&](double t) { return glm::mix(outside, goal, std::min(1.0, t / kPressing)); }, kStaying);
  return session.figures().energy_min;
}

std::vector<Figure> takingFigures() {
  std::vector<Figure> figures;
  const auto scene = planeScene();
  SessionSetup setup;
  setup.rate = kRates[0];
  setup.classic = true;
  const double classic = takingEnergy(*scene, setup, 4.0);
  setup.classic = false;
  for (const ClientRate& rate : kRates) {
    setup.rate = rate;
    figures.push_back({"M3.taking", "flat wall pressed right after taking", rateName(rate), "mJ",
                       1e3 * takingEnergy(*scene, setup, 4.0), -0.5, true, 1e3 * classic});
  }
  return figures;
}

/// Swings beside the obstacle at up to 1 m/s without touching it. The largest force, N; not a number if it touched.
double freeForce(const FeelScene& scene, const SessionSetup& wanted, int ticks) {
  SessionSetup setup = wanted;
  // A hand so stiff that the stylus goes where the path goes, without overshoot into the obstacle.
  setup.hand = haptic::HandOptions{};
  setup.hand->stiffness = 20000.0;
  setup.hand->damping = 60.0;
  FeelSession session(scene, setup);
  const dvec3 middle = scene.start() + dvec3(0.012, 0.012, 0.020);
  session.begin(middle);
  double largest = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const double t = 1e-3 * (i % 20000), w = 40.0 * std::min(1.0, t / 5.0);
    const dvec3 swing(0.010 * std::sin(w * t), 0.010 * std::sin(0.7 * w * t), 0.012 * std::sin(1.3 * w * t));
    session.follow([&](double) { return middle + swing; }, 1e-3, false);
    if (!setup.classic && session.last().contact) return std::nan("");
    largest = std::max(largest, glm::length(session.last().force_D));
  }
  return largest;
}

std::vector<Figure> freeFigures(const NamedScene& named, int ticks) {
  std::vector<Figure> figures;
  const auto scene = named.make();
  if (!scene) return figures;
  SessionSetup setup;
  setup.rate = kRates[0];
  setup.classic = true;
  const double classic = freeForce(**scene, setup, ticks);
  setup.classic = false;
  for (const ClientRate& rate : kRates) {
    setup.rate = rate;
    figures.push_back(
        {"M6.free_force", named.name, rateName(rate), "N", freeForce(**scene, setup, ticks), 0.0, false, classic});
  }
  return figures;
}

/// How long after the hand has lifted off a force is left, ms.
double releaseTime(const FeelScene& scene, const SessionSetup& setup) {
  FeelSession session(scene, setup);
  touchAndSlide(session, scene, 1.0);
  const dvec3 from = session.device().truePose().p;
  double left = -1.0, gone = 0.0;
  for (int i = 0; i < 400; ++i) {
    session.follow([&](double) { return from + dvec3(0, 0, std::min(0.02, 4e-4 * i)); }, 1e-3);
    const haptic::RenderResult& now = session.last();
    if (now.contact) continue;
    if (left < 0.0) left = session.time();
    if (glm::length(now.force_D) > 0.0 || glm::length(now.offset_D) > 0.0) gone = session.time();
  }
  return left < 0.0 ? std::nan("") : 1e3 * std::max(0.0, gone - left);
}

std::vector<Figure> releaseFigures() {
  std::vector<Figure> figures;
  SessionSetup old;
  old.rate = kRates[0];
  old.classic = true;
  const double classic = releaseTime(*facetScene(0.01, 10.0), old);
  for (const ClientRate& rate : kRates) {
    SessionSetup setup;
    setup.rate = rate;
    const double facets = releaseTime(*facetScene(0.01, 10.0), setup);
    figures.push_back(
        {"M6.release", "cylinder R10 of 10 degree facets", rateName(rate), "ms", facets, 150.0, false, classic});
  }
  return figures;
}

}  // namespace

void addEnergyJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs) {
  jobs.push_back({{"M3"}, "taps of 0.25 m/s", [] { return tapFigures(0.25, true); }});
  jobs.push_back({{"M3"}, "taps of 0.56 m/s", [] { return tapFigures(0.56, false); }});
  jobs.push_back({{"M3"}, "flat wall pressed right after taking", [] { return takingFigures(); }});
  const int ticks = options.full ? 160000 : 10000;
  for (const NamedScene& scene : benchmarkScenes()) {
    if (scene.name != "cylinder R10" && scene.name != "corner of three planes") continue;
    jobs.push_back({{"M6"}, scene.name, [scene, ticks] { return freeFigures(scene, ticks); }});
  }
  jobs.push_back({{"M6"}, "cylinder R10 of 10 degree facets", [] { return releaseFigures(); }});
}

}  // namespace hapticell::feel
