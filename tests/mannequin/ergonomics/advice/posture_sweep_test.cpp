// SPDX-License-Identifier: Apache-2.0
// One degree of any joint changes no sub-score by more than a class.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "mannequin/body/anthropometry.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/ergonomics/scores/posture_scores.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Figure;
using mannequin::Posture;

constexpr double kOneDegree = std::numbers::pi / 180.0;

PostureScores sweptScores(const Figure& figure, const Posture& posture) {
  return scorePosture(figure, posture, mannequin::forwardKinematics(figure, posture), WorkTask{});
}

template <class Values>
int greatestStep(const Values& a, const Values& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i].value_or(0) - b[i].value_or(0)));
  return most;
}

/// How many of its digits change: they name postures and have no order.
int changedDigits(const Owas::Values& a, const Owas::Values& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

/// How many zones the farthest part goes.
int greatestStep(const PartVerdicts& a, const PartVerdicts& b) {
  int most = std::abs(static_cast<int>(a.worst) - static_cast<int>(b.worst));
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    EXPECT_EQ(a.parts[i].part, b.parts[i].part);
    most = std::max(most, std::abs(static_cast<int>(a.parts[i].zone) - static_cast<int>(b.parts[i].zone)));
  }
  return most;
}

/// Rare, held, often, supported, and all of it: the zones' limits depend on them.
std::array<WorkTask, 5> usesOfZones() {
  std::array<WorkTask, 5> tasks{};
  tasks[1].is_static = tasks[4].is_static = true;
  tasks[2].repetitions_per_min = tasks[4].repetitions_per_min = 12.0;
  tasks[3].trunk_supported = tasks[4].trunk_supported = true;
  tasks[3].arm_supported = tasks[4].arm_supported = {true, true};
  return tasks;
}

void compareZones(const PostureScores& before, const PostureScores& now, const std::string& where) {
  static const auto tasks = usesOfZones();
  for (const WorkTask& task : tasks) {
    for (const mannequin::Side side : {mannequin::Side::kLeft, mannequin::Side::kRight}) {
      const ZonePosture a = zonePosture(before, side, task), b = zonePosture(now, side, task);
      EXPECT_LE(greatestStep(en1005(a.measured, a.gaze_below_horizontal, a.use),
                             en1005(b.measured, b.gaze_below_horizontal, b.use)),
                1)
          << where << " EN 1005-4, task " << &task - tasks.data();
      EXPECT_LE(greatestStep(iso11226(a.measured, a.head_inclination, a.use),
                             iso11226(b.measured, b.head_inclination, b.use)),
                1)
          << where << " ISO 11226, task " << &task - tasks.data();
    }
  }
}

/// EAWS' lines are named postures without an order; what decides between them changes one at a time, the trunk by a
/// class at most.
int changedObservations(const EawsObservation& a, const EawsObservation& b) {
  const auto bend = [](const EawsObservation& o) {
    const double trunk = std::abs(o.trunk_flexion);
    return (trunk > 20.0 ? 1 : 0) + (trunk > 60.0 ? 1 : 0);
  };
  return std::abs(bend(a) - bend(b)) + (a.hands_above_head != b.hands_above_head ? 1 : 0) +
         (a.elbow_at_shoulder != b.elbow_at_shoulder ? 1 : 0) + (a.seated != b.seated ? 1 : 0) +
         (a.kneeling != b.kneeling ? 1 : 0);
}

void sweep(const Figure& figure, const char* base, Posture posture, Dof dof) {
  const auto& info = mannequin::dofInfo(dof);
  std::optional<PostureScores> before;
  const int first = static_cast<int>(std::ceil(info.lower / kOneDegree - 1e-9));
  const int last = static_cast<int>(std::floor(info.upper / kOneDegree + 1e-9));
  for (int degree = first; degree <= last; ++degree) {
    posture[dof] = degree * kOneDegree;
    const PostureScores now = sweptScores(figure, posture);
    if (before) {
      for (std::size_t side = 0; side < 2; ++side) {
        const SideScores &a = before->sides[side], &b = now.sides[side];
        EXPECT_LE(greatestStep(a.rula, b.rula), 1) << base << ", " << info.name << " to " << degree << " RULA";
        EXPECT_LE(greatestStep(a.reba, b.reba), 1) << base << ", " << info.name << " to " << degree << " REBA";
      }
      EXPECT_LE(changedDigits(before->owas, now.owas), 1) << base << ", " << info.name << " to " << degree << " OWAS";
      EXPECT_LE(changedObservations(before->eaws_observation, now.eaws_observation), 1)
          << base << ", " << info.name << " to " << degree << " EAWS";
      compareZones(*before, now, std::string(base) + ", " + std::string(info.name) + " to " + std::to_string(degree));
    }
    before = now;
  }
}

void sweepAllJoints(const mannequin::NamedFigure& body, const char* library) {
  const Posture posture = *mannequin::libraryPosture(body.figure, library);
  const std::string base = body.name + std::string(" ") + library;
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i) sweep(body.figure, base.c_str(), posture, static_cast<Dof>(i));
}

TEST(PostureSweep, OneDegreeOfAJointIsAtMostOneClass) {
  const auto bodies = mannequin::boundaryFigures();
  for (const auto& library : mannequin::postureLibrary()) sweepAllJoints(bodies[3], library.name.c_str());
  for (const char* library : {"zero", "seated", "reaching"}) sweepAllJoints(bodies[0], library);
}

}  // namespace
}  // namespace hapticell::ergonomics
