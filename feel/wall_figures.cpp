// SPDX-License-Identifier: Apache-2.0
// M8: nothing is passed through. M12: the hinge under a sideways pull, and its stop.
#include <algorithm>
#include <cmath>

#include "feel/figure_job.h"
#include "feel/pop_through.h"

namespace hapticell::feel {

namespace {

// N, sideways at the hinge: most of the 6.4 N of the device. Half: an easier figure; twice: beyond its motors.
constexpr double kPull = 5.0;
// N more that a hand notices at 2 N: 7 % (Pang, Tan, Durlach: "Manual discrimination of force", 1991). Half: M12.stop
// counts what nobody feels; twice: it counts later than a hand.
constexpr double kFelt = 0.14;
// m/s onto the stop: a slow approach, at which the spring alone takes 2.8 ms to kFelt (1 N/mm). Half: 5.6 ms, over the
// limit of 3; twice: 1.4 ms.
constexpr double kStopSpeed = 0.05;

struct SweepKind {
  const char* name;
  bool stalls;
  double zone_share;
};

std::vector<Figure> sweepFigures(const SweepKind& kind, const ClientRate& rate, int sweeps) {
  SweepSetup setup;
  setup.rate = rate;
  setup.sweeps = sweeps;
  setup.stalls = kind.stalls;
  setup.zone_share = kind.zone_share;
  const SweepOutcome ours = sweepThroughPlate(setup);
  setup.classic = true;
  setup.rate = kRates[0];
  const SweepOutcome classic = sweepThroughPlate(setup);
  const std::string at = rateName(rate);
  std::vector<Figure> figures{{"M8.pops", kind.name, at, "of " + std::to_string(sweeps), static_cast<double>(ours.pops),
                               0.0, false, static_cast<double>(classic.pops)}};
  // A zone that is too small, or an old set, may hold the stylus at the zone's edge.
  if (!kind.stalls && kind.zone_share == 1.0) {
    figures.push_back({"M8.blocked", kind.name, at, "ticks", static_cast<double>(ours.blocked), 0.0, false,
                       static_cast<double>(classic.blocked)});
  }
  return figures;
}

struct HingeOutcome {
  double off_circle = 0.0;  // mm, proxy and drawn door.
  double stylus = 0.0;      // % that the stylus differs from F/K.
};

HingeOutcome pullSideways(const SessionSetup& setup) {
  const auto scene = hingeScene();
  FeelSession session(*scene, setup);
  session.begin(scene->start());
  const double press = pressDepth(session.hand(), kPull);
  HingeOutcome outcome;
  // Not longer: the motors would warm and be derated.
  for (int i = 1; i <= 1200; ++i) {
    const double share = std::min(1.0, i / 500.0);
    // Stays clear of the stop: only half of the scene's way.
    session.follow([&](double) { return scene->handAt(0.12 * std::sin(4e-3 * i), share * press); }, 1e-3);
    if (share < 1.0) continue;
    const haptic::RenderResult& now = session.last();
    outcome.off_circle = std::max(outcome.off_circle, 1e3 * scene->penetration(now.X_DP, 0.0));
    const double pull = glm::length(session.safety().force_D);
    const double stretch = glm::distance(now.X_DP.p, session.device().truePose().p);
    if (i % 100 == 0) outcome.stylus = std::max(outcome.stylus, 100.0 * std::abs(stretch * now.stiffness / pull - 1.0));
  }
  return outcome;
}

/// ms from crossing the stop at 0.05 m/s to 0.14 N of the motors more than before.
double stopTime(const SessionSetup& setup) {
  const auto scene = planeScene();  // The stop's own row, met straight on.
  FeelSession session(*scene, setup);
  session.begin(dvec3(0, 0, 0.006));
  double crossed = -1.0;
  for (int i = 1; i <= 400; ++i) {
    session.follow([&](double) { return dvec3(0, 0, 0.006 - kStopSpeed * 1e-3 * i); }, 1e-3);
    const double depth = -session.device().truePose().p.z;
    if (crossed < 0.0 && depth >= 0.0) crossed = session.time() + depth / session.device().trueVelocity().z;
    // The motors have exerted it since the beginning of the tick.
    if (crossed >= 0.0 && session.device().motorForce().z >= kFelt) return 1e3 * (session.time() - 1e-3 - crossed);
  }
  return std::nan("");
}

std::vector<Figure> hingeFigures() {
  std::vector<Figure> figures;
  SessionSetup setup;
  setup.rate = kRates[0];
  setup.classic = true;
  const HingeOutcome classic = pullSideways(setup);
  const double classic_stop = stopTime(setup);
  setup.classic = false;
  for (const ClientRate& rate : kRates) {
    setup.rate = rate;
    const HingeOutcome ours = pullSideways(setup);
    const std::string at = rateName(rate);
    figures.push_back(
        {"M12.door", "hinge with stop, 5 N sideways", at, "mm", ours.off_circle, 0.05, false, classic.off_circle});
    figures.push_back(
        {"M12.stylus", "hinge with stop, 5 N sideways", at, "%", ours.stylus, 3.0, false, classic.stylus});
    figures.push_back({"M12.stop", "hinge with stop", at, "ms", stopTime(setup), 3.0, false, classic_stop});
  }
  return figures;
}

}  // namespace

void addWallJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs) {
  const int sweeps = options.full ? 100000 : 500;
  for (const SweepKind& kind : {SweepKind{"thin wall", false, 1.0}, SweepKind{"thin wall, stalls", true, 1.0},
                                SweepKind{"thin wall, zone of a third", false, 1.0 / 3.0}}) {
    for (const ClientRate& rate : kRates) {
      jobs.push_back({{"M8"}, kind.name, [kind, rate, sweeps] { return sweepFigures(kind, rate, sweeps); }});
    }
  }
  jobs.push_back({{"M12"}, "hinge with stop", [] { return hingeFigures(); }});
}

}  // namespace hapticell::feel
