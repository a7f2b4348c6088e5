// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/closure_jets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "workcell/import/entity_source.h"

namespace hapticell::manipulation {
namespace {

const Pose kBase{dvec3(0.4, -1.0, 0.2), quaternionFromRotationVector({0.1, 0.0, 0.8})};

class ClosureJetsOf : public testing::TestWithParam<const char*> {
 protected:
  ClosureJetsOf() {
    Diagnostics notes;
    model_ = workcell::EntityLoader(".").load(GetParam(), 1.0, notes).value().robot();
    rest_ = kinematics::restPositions(*model_);
  }

  std::vector<double> moved(double h) const {
    std::vector<double> q = rest_;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += h * std::sin(1.0 + 2.1 * static_cast<double>(i));
    return q;
  }

  /// The largest error of the second-order motion, m and rad.
  double error(const ClosureJets& jets, double h) const {
    std::vector<Pose> X_BL;
    const std::vector<double> q = moved(h);
    EXPECT_TRUE(model_->closure->pose(q, X_BL));
    double worst = 0.0;
    for (std::size_t link = 0; link < jets.links(); ++link) {
      const Twist truth = difference(kBase * X_BL[link], jets.poses()[link]);
      Twist told;
      for (std::size_t i = 0; i < q.size(); ++i) {
        const double di = q[i] - rest_[i];
        told.linear += di * jets.velocity(i, link).linear;
        told.angular += di * jets.velocity(i, link).angular;
        for (std::size_t j = 0; j < q.size(); ++j) {
          const double dj = q[j] - rest_[j];
          told.linear += 0.5 * di * dj * jets.acceleration(i, j, link).linear;
          told.angular += 0.5 * di * dj * jets.acceleration(i, j, link).angular;
        }
      }
      worst = std::max({worst, glm::length(truth.linear - told.linear), glm::length(truth.angular - told.angular)});
    }
    return worst;
  }

  std::shared_ptr<const kinematics::RobotModel> model_;
  std::vector<double> rest_;
};

TEST_P(ClosureJetsOf, MoveTheLinksToSecondOrder) {
  const ClosureJets jets(*model_, rest_, kBase);
  ASSERT_EQ(jets.links(), model_->links.size());
  std::vector<Pose> X_BL;
  ASSERT_TRUE(model_->closure->pose(rest_, X_BL));
  for (std::size_t k = 0; k < X_BL.size(); ++k) EXPECT_LT(glm::length((kBase * X_BL[k]).p - jets.poses()[k].p), 1e-12);
  // What is left is of third order: a tenth of the way has a thousandth of it.
  const double far = error(jets, 0.03), near = error(jets, 0.003);
  EXPECT_LT(far, 3e-3);
  EXPECT_LT(near, 2e-3 * far + 2e-9);
}

TEST_P(ClosureJetsOf, TellHowTheMarginsChange) {
  // Aside of the rest, where a joint in the middle of its cone has the same margin on all sides.
  const std::vector<double> here = moved(0.05);
  const ClosureJets jets(*model_, here, kBase);
  std::vector<kinematics::ClosureMargin> at, ahead, back;
  model_->closure->margins(here, at);
  ASSERT_EQ(jets.margins().size(), at.size());
  ASSERT_FALSE(at.empty());
  const double h = 1e-3;
  for (std::size_t i = 0; i < here.size(); ++i) {
    std::vector<double> q = here;
    q[i] = here[i] + h;
    model_->closure->margins(q, ahead);
    q[i] = here[i] - h;
    model_->closure->margins(q, back);
    for (std::size_t m = 0; m < at.size(); ++m) {
      EXPECT_NEAR(jets.margins()[m].at.value, at[m].value, 1e-9);
      EXPECT_EQ(jets.margins()[m].at.what, at[m].what);
      EXPECT_NEAR(jets.margins()[m].gradient[i], (ahead[m].value - back[m].value) / (2.0 * h), 0.01)
          << english(at[m].what) << ", variable " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ClosureJetsOf, testing::Values("library:omnid_delta", "library:hexapod_motion_base"),
                         [](const auto& which) { return which.index == 0 ? "Delta" : "Hexapod"; });

}  // namespace
}  // namespace hapticell::manipulation
