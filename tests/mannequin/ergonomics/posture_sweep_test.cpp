// SPDX-License-Identifier: Apache-2.0
// One degree of any joint changes no sub-score by more than a class.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mannequin/anthropometry.h"
#include "mannequin/ergonomics/body_sizes.h"
#include "mannequin/ergonomics/posture_scores.h"

namespace hapticell::ergonomics {
namespace {

using mannequin::Dof;
using mannequin::Figure;
using mannequin::Posture;

constexpr double kOneDegree = 3.14159265358979323846 / 180.0;

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
