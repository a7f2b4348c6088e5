// SPDX-License-Identifier: Apache-2.0
// What another station feels: M1 to M4 at 60 Hz over a network with delay, jitter of half as much, and 1 % of loss.
#include <cmath>
#include <cstdio>

#include "feel/figure_job.h"

namespace hapticell::feel {

namespace {

/// s, as kSlide of sliding_figures.cpp: 240 sets, two or three of them lost. Half: perhaps none is lost; twice: the
/// same figures.
constexpr double kNetworkSlide = 4.0;
/// Hz: the middle one of kRates, the usual rate of a client. Half: sets are 33 ms old; twice: fewer steps at each.
constexpr double kRate = 60.0;
/// Share of sets that are lost: our choice for a bad network. Half: one or two in a session; twice: five.
constexpr double kLoss = 0.01;
constexpr double kDelays[] = {0.0, 0.005, 0.020, 0.050};  // s, one way.

/// As for the same scene next door (docs/dev/feel.md).
constexpr double kStep = 0.10;         // N/ms.
constexpr double kPenetration = 0.05;  // mm.
constexpr double kDepth = 3.0;         // %.
constexpr double kEnergy = -0.5;       // mJ.
constexpr double kDirection = 3.0;     // degrees.

std::string nameOf(double delay) {
  char text[64];
  std::snprintf(text, sizeof text, "%.0f Hz + %.0f ms, jitter, 1 %% lost", kRate, 1e3 * delay);
  return text;
}

FeelFigures slide(const FeelScene& scene, const SessionSetup& setup) {
  FeelSession session(scene, setup);
  touchAndSlide(session, scene, kNetworkSlide);
  FeelFigures figures = session.figures();
  if (figures.contact_ticks == 0) figures.step_n = std::nan("");  // Nothing was felt: nothing is proved.
  return figures;
}

Expected<std::vector<Figure>> networkFigures(const NamedScene& named) {
  const auto scene = named.make();
  HAPTICELL_TRY(scene);
  std::vector<Figure> figures;
  for (const double delay : kDelays) {
    SessionSetup setup;
    setup.rate = {kRate, delay, 0.5 * delay, kLoss};
    const FeelFigures ours = slide(**scene, setup);
    setup.classic = true;
    const FeelFigures classic = slide(**scene, setup);
    const auto add = [&](const char* id, const char* unit, double value, double limit, double classic_value) {
      figures.push_back(
          {std::string("NET.") + id, named.name, nameOf(delay), unit, value, limit, limit < 0.0, classic_value});
    };
    add("M1", "N/ms", ours.step_n, kStep, classic.step_n);
    add("M2.penetration", "mm", 1e3 * ours.penetration, kPenetration, 1e3 * classic.penetration);
    add("M2.depth_p95", "%", 100.0 * ours.depth_error_p95, kDepth, 100.0 * classic.depth_error_p95);
    add("M3", "mJ", 1e3 * ours.energy_min, kEnergy, 1e3 * classic.energy_min);
    add("M4", "deg", ours.direction_p95_deg, kDirection, classic.direction_p95_deg);
  }
  return figures;
}

}  // namespace

void addNetworkJobs(const BenchmarkOptions&, std::vector<FigureJob>& jobs) {
  for (const char* name : {"flat wall", "cylinder R50", "bore R10", "corner of three planes", "hinge with stop"}) {
    for (const NamedScene& scene : benchmarkScenes()) {
      if (scene.name == name) jobs.push_back({{"NET"}, scene.name, [scene] { return networkFigures(scene); }});
    }
  }
}

}  // namespace hapticell::feel
