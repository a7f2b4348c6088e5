// SPDX-License-Identifier: Apache-2.0
// M5: no limit cycle at the stiffness that belongs to each delay. M10: the stiffest wall that is stable at all.
#include <algorithm>
#include <cstdio>

#include "feel/figure_job.h"

namespace hapticell::feel {

namespace {

/// m: one step of a joint's encoder where the arm is most stretched. M5's limit is one of them. Half or twice: as if
/// the limit were twice or half.
constexpr double kCount = 0.03e-3;
/// Steps of the encoder, 0.15 mm within 0.5 s, what M10 calls stable. Our choice. Half: stiffer walls count as
/// unstable; twice: a slow swing would count as rest.
constexpr double kStableCounts = 5.0;
/// N: all of the apparent mass (45 g), the worst case of a stylus let go. Half: the counterweights help; twice: no
/// device.
constexpr double kWholeWeight = 0.44;
/// N/m: where the search ends, far above the 4900 that M10 finds, and its step, the accuracy of M10. Half
/// of the step: twice the sessions; twice: M10 is good to 200.
constexpr double kStiffest = 8000.0, kStep = 100.0;

enum class Grip { kFirm, kLoose, kReleased };

/// How far the stylus still moves after two seconds at rest, in encoder steps.
double restlessness(const FeelScene& scene, SessionSetup setup, Grip grip) {
  if (grip == Grip::kLoose) setup.hand = haptic::HandOptions::loose();
  if (grip == Grip::kReleased) setup.device.mechanics.weight = kWholeWeight;
  FeelSession session(scene, setup);
  pressAtRest(session, scene);
  if (grip == Grip::kReleased) session.letGo(3.0);
  return session.wobble(0.5) / kCount;
}

double worstGrip(const FeelScene& scene, const SessionSetup& setup) {
  double worst = 0.0;
  for (const Grip grip : {Grip::kFirm, Grip::kLoose, Grip::kReleased}) {
    worst = std::max(worst, restlessness(scene, setup, grip));
  }
  return worst;
}

SessionSetup delayed(const ClientRate& rate, int ticks) {
  SessionSetup setup;
  setup.rate = rate;
  setup.device.electronics.delay_ticks = ticks;
  setup.renderer.delay = 1e-3 * ticks;
  return setup;
}

Expected<std::vector<Figure>> restFigures(const NamedScene& named, bool full) {
  const auto scene = named.make();
  HAPTICELL_TRY(scene);
  std::vector<Figure> figures;
  for (const ClientRate& rate : kRates) {
    if (!full && rate.rate_hz != kRates[0].rate_hz) continue;
    for (const int ticks : {1, 2, 3}) {
      SessionSetup setup = delayed(rate, ticks);
      const double ours = worstGrip(**scene, setup);
      setup.rate = kRates[0];
      setup.classic = true;
      const double classic = worstGrip(**scene, setup);
      const std::string at = rateName(rate) + ", delay " + std::to_string(ticks) + " ms";
      figures.push_back({"M5", named.name, at, "counts", ours, 1.0, false, classic});
    }
  }
  return figures;
}

bool isStable(const FeelScene& scene, double stiffness, Grip grip, bool classic) {
  SessionSetup setup = delayed(classic ? kRates[0] : kRates[1], 1);
  setup.classic = classic;
  setup.renderer.stiffness = stiffness;
  setup.renderer.damping = 4.0;
  setup.renderer.adapt = false;
  return restlessness(scene, setup, grip) <= kStableCounts;
}

/// The stiffest wall below the first one that is not stable, N/mm.
double stiffest(Grip grip, double from, bool classic = false) {
  const auto scene = planeScene();
  double stiffness = from;
  while (stiffness > kStep && !isStable(*scene, stiffness, grip, classic)) stiffness -= kStep;
  while (stiffness < kStiffest && isStable(*scene, stiffness + kStep, grip, classic)) stiffness += kStep;
  return 1e-3 * stiffness;
}

std::vector<Figure> stiffestFigures() {
  return {{"M10.held", "flat wall, B 4 N s/m, hand b 2", "", "N/mm", stiffest(Grip::kLoose, 3500.0), 3.5, true,
           stiffest(Grip::kLoose, 3500.0, true)},
          {"M10.released", "flat wall, B 4 N s/m", "", "N/mm", stiffest(Grip::kReleased, 2000.0), 2.0, true,
           stiffest(Grip::kReleased, 2000.0, true)}};
}

}  // namespace

void addStabilityJobs(const BenchmarkOptions& options, std::vector<FigureJob>& jobs) {
  for (const NamedScene& scene : benchmarkScenes()) {
    jobs.push_back({{"M5"}, scene.name, [scene, full = options.full] { return restFigures(scene, full); }});
  }
  jobs.push_back({{"M10"}, "flat wall", [] { return stiffestFigures(); }});
}

}  // namespace hapticell::feel
