// SPDX-License-Identifier: Apache-2.0
// RULA, REBA and OWAS of a posture that is taken from the library, or bent joint by joint.
#include <mannequin/body/figure.h>
#include <mannequin/ergonomics/scores/posture_scores.h>
#include <mannequin/ergonomics/scores/work_task.h>
#include <mannequin/posture/forward_kinematics.h>
#include <mannequin/posture/posture.h>

#include <cstdio>
#include <numbers>

namespace ergonomics = hapticell::ergonomics;
namespace mannequin = hapticell::mannequin;

namespace {

ergonomics::PostureScores scoresOf(const mannequin::Figure& figure, const mannequin::Posture& posture,
                                   const ergonomics::WorkTask& task) {
  return ergonomics::scorePosture(figure, posture, mannequin::forwardKinematics(figure, posture), task);
}

}  // namespace

int main() {
  const auto figure = mannequin::makeFigure({.sex = mannequin::Sex::kMale, .stature = 1.80});
  if (!figure) {
    std::fprintf(stderr, "%s\n", figure.error().message().c_str());
    return 1;
  }

  // What a posture does not show. What is left out is never scored as zero: the score is marked as partial.
  ergonomics::WorkTask task;
  task.load_kg = {4.0, 4.0};
  task.repetitions_per_min = 2.0;
  task.is_static = false;
  task.has_shock = false;
  task.grip = ergonomics::Grip::kGood;

  for (const char* name : {"standing", "stooping", "squatting", "overhead"}) {
    const auto posture = mannequin::libraryPosture(*figure, name);
    if (!posture) return 1;
    const ergonomics::PostureScores scores = scoresOf(*figure, *posture, task);
    std::printf("%-10s RULA %d  REBA %2d  OWAS %d\n", name, scores.rula(), scores.reba(), scores.owasCode());
  }

  // The same trunk, bent further and further.
  mannequin::Posture bent = *mannequin::libraryPosture(*figure, "standing");
  for (int degrees = 0; degrees <= 60; degrees += 15) {
    for (const auto dof : {mannequin::Dof::kVl5Flexion, mannequin::Dof::kVl1Flexion, mannequin::Dof::kVt6Flexion})
      bent[dof] = degrees / 3.0 * std::numbers::pi / 180.0;
    std::printf("bent by %2d degrees: REBA %d\n", degrees, scoresOf(*figure, bent, task).reba());
  }
  return 0;
}
