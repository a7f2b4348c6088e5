// SPDX-License-Identifier: Apache-2.0
// Measures scoring: all methods, both sides, for one posture after another of random ones; and with the forward
// kinematics before it, as each frame of a drag does. Prints a table for docs/dev/performance.md.
#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

#include "bench/mannequin_goals.h"
#include "bench/thread_clock.h"
#include "geometry/system/percentile.h"
#include "mannequin/ergonomics/advice/better_place.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/ergonomics/advice/driving_parts.h"
#include "mannequin/ergonomics/advice/method_advice.h"
#include "mannequin/ergonomics/scores/posture_scores.h"

namespace {

using namespace hapticell;

void row(const char* name, const std::vector<double>& ms) {
  std::printf("| %s | %.2f | %.2f |\n", name, 1e3 * percentile(ms, 0.5), 1e3 * percentile(ms, 0.99));
}

}  // namespace

int main() {
  using namespace mannequin;
  const Figure figure = *makeFigure({Sex::kMale, *statureOfPercentile(Sex::kMale, 50)});
  const std::vector<NamedFigure> figures = boundaryFigures();
  ergonomics::WorkTask task;
  task.load_kg = {2.0, 3.0};
  task.repetitions_per_min = 4.0;
  task.duration_h = 1.0;
  task.is_static = false;
  task.grip = ergonomics::Grip::kFair;
  std::mt19937_64 random(3);
  std::vector<Posture> postures;
  for (int i = 0; i < 2000; ++i) postures.push_back(bench::makeGoal(figure, {}, random).reached);
  std::vector<double> scored, with_kinematics, lifted, labelled, advised, placed, bodies;
  long sum = 0;
  const double cost = bench::threadClockCost();
  for (const Posture& posture : postures) {
    double begin = bench::threadMilliseconds();
    const FigurePose pose = forwardKinematics(figure, posture);
    const double posed = bench::threadMilliseconds();
    const auto scores = ergonomics::scorePosture(figure, posture, pose, task);
    const double now = bench::threadMilliseconds();
    scored.push_back(now - posed - cost);
    with_kinematics.push_back(now - begin - 2.0 * cost);
    sum += scores.rula() + scores.reba() + scores.owas_category;
    begin = bench::threadMilliseconds();
    sum += ergonomics::scoreLift(figure, pose, scores, task).has_value() ? 1 : 0;
    lifted.push_back(bench::threadMilliseconds() - begin - cost);
    begin = bench::threadMilliseconds();
    sum += static_cast<long>(ergonomics::drivingParts(scores, ergonomics::PostureMethod::kRula).size());
    labelled.push_back(bench::threadMilliseconds() - begin - cost);
    begin = bench::threadMilliseconds();
    for (const auto method : ergonomics::kPostureMethods) sum += ergonomics::advise(scores, method, task).now.level;
    advised.push_back(bench::threadMilliseconds() - begin - cost);
  }
  for (std::size_t i = 0; i < postures.size(); i += 40) {
    const double begin = bench::threadMilliseconds();
    for (const auto& place : ergonomics::betterPlaces(figure, postures[i], task)) sum += place ? 1 : 0;
    placed.push_back(bench::threadMilliseconds() - begin - cost);
  }
  for (std::size_t i = 0; i < postures.size(); i += 10) {
    const double begin = bench::threadMilliseconds();
    sum += static_cast<long>(ergonomics::atSameTask(figures, figure, postures[i], task).size());
    bodies.push_back(bench::threadMilliseconds() - begin - cost);
  }
  std::printf("| %zu random postures (checksum %ld) | median us | p99 us |\n| --- | --- | --- |\n", postures.size(),
              sum);
  row("RULA, REBA (both sides), OWAS, EN 1005-4, ISO 11226, EAWS line, comfort", scored);
  row("the same with forward kinematics", with_kinematics);
  row("NIOSH lift of the posture", lifted);
  row("driving joints of one method, for the scene's labels", labelled);
  row("drivers and nearest posture of the next level, six methods, worse side", advised);
  row("nearest place of the work, six methods", placed);
  row("four bodies solved and scored at the same task", bodies);
  return 0;
}
