// SPDX-License-Identifier: Apache-2.0
// Agents in the whole window under a virtual display: real clicks, through AgentsPage.
#include <gtest/gtest.h>

#include "tests/app/pages/agents_page.h"

namespace hapticell::app {
namespace {

using Phase = agents::AgentSession::Phase;

// Over the suitcase in the trunk; the sill is in the straight way.
constexpr dvec3 kBottle{930.0, -160.0, 800.0};

TEST(AgentsDock, StepsPausesAndStopsWithoutChangingTheCell) {
  AgentsPage page;
  ASSERT_TRUE(page.openCell("trunk.hcell"));
  EXPECT_FALSE(page.find<QAbstractButton>("buttonAgentsStart")->isEnabled()) << "nothing is chosen";
  page.setUp("worker", kBottle);
  EXPECT_EQ(page.words("labelAgentEntity"), "worker");
  const std::vector<double> before = page.joints();
  page.click("buttonAgentsStep");
  ASSERT_TRUE(AgentsPage::until([&] { return page.state() && page.state()->steps == 1; }, AgentsPage::kPatience));
  AgentsPage::rest();
  EXPECT_EQ(page.state()->steps, 1u) << "one step, no more";
  EXPECT_GT(page.arrows(), 0u);
  // An agent that is switched off wants nothing any more.
  EXPECT_GT(page.state()->wishes.front().strength, 0.0);
  page.click("switchAgent_goal");
  page.click("buttonAgentsStep");
  ASSERT_TRUE(AgentsPage::until([&] { return page.state()->steps == 2; }, AgentsPage::kPatience));
  EXPECT_EQ(page.state()->wishes.front().strength, 0.0);
  page.setSlider("sliderAgent_goal", 20);
  page.click("switchAgent_goal");
  page.click("buttonAgentsStep");
  ASSERT_TRUE(AgentsPage::until([&] { return page.state()->steps == 3; }, AgentsPage::kPatience));
  EXPECT_EQ(page.state()->wishes.front().weight, 2.0);
  page.click("buttonAgentsStop");
  EXPECT_EQ(page.arrows(), 0u);
  EXPECT_FALSE(page.state().has_value());
  EXPECT_EQ(page.joints(), before) << "the document is as it was";
}

TEST(AgentsDock, ADeadlockGoesToThePlannerAndTheResultIsOneStepOfUndo) {
  AgentsPage page;
  ASSERT_TRUE(page.openCell("trunk.hcell"));
  page.setUp("worker", kBottle);
  const std::vector<double> before = page.joints();
  page.click("buttonAgentsStart");
  ASSERT_TRUE(page.untilPhase(Phase::kDeadlocked));
  EXPECT_TRUE(page.words("labelAgentsSay").contains("sill")) << page.words("labelAgentsSay").toStdString();
  page.keepLook("agents-deadlock");
  page.click("buttonAgentsPlanner");
  ASSERT_TRUE(AgentsPage::until([&] { return page.state()->phase != Phase::kPlanning; }, AgentsPage::kRunPatience));
  EXPECT_FALSE(page.state()->way_W.empty()) << page.words("labelAgentsSay").toStdString();
  AgentsPage::rest();
  page.keepLook("agents-way");
  // The body may be caught on the way of its hand; then the planner is asked for the next one.
  const auto is_over = [&] {
    return page.state()->phase != Phase::kRunning && page.state()->phase != Phase::kPlanning;
  };
  ASSERT_TRUE(AgentsPage::until(is_over, AgentsPage::kRunPatience));
  EXPECT_EQ(page.state()->phase, Phase::kArrived)
      << page.words("labelAgentsSay").toStdString() << " after " << page.state()->plans << " plans";
  AgentsPage::rest();
  ASSERT_TRUE(page.clickForStep("buttonAgentsAdopt"));
  EXPECT_NE(page.joints(), before);
  EXPECT_FALSE(page.state().has_value());
  page.trigger("actionUndo");
  EXPECT_EQ(page.joints(), before);
}

TEST(AgentsDock, TheMouseLeadsOutOfADeadlock) {
  AgentsPage page;
  ASSERT_TRUE(page.openCell("trunk.hcell"));
  page.setUp("worker", kBottle);
  page.click("buttonAgentsStart");
  ASSERT_TRUE(page.untilPhase(Phase::kDeadlocked));
  const dvec3 p_WStuck = page.state()->X_WM.p;
  ViewportWidget& scene = page.window().viewport();
  const auto send = [&](QEvent::Type type, const QPoint& place, Qt::MouseButtons held) {
    const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, QPointF(place), scene.mapToGlobal(QPointF(place)), button, held, Qt::NoModifier);
    QApplication::sendEvent(&scene, &event);
  };
  const QPoint from = page.pixelOfPoint(p_WStuck), to = page.pixelOfPoint(p_WStuck + dvec3(-0.1, 0.0, 0.3));
  send(QEvent::MouseButtonPress, from, Qt::LeftButton);
  send(QEvent::MouseMove, to, Qt::LeftButton);
  const auto higher = [&] { return page.state()->X_WM.p.z > p_WStuck.z + 0.1; };
  EXPECT_TRUE(AgentsPage::until(higher, AgentsPage::kPatience)) << "the hand is followed";
  send(QEvent::MouseButtonRelease, to, Qt::NoButton);
  page.click("buttonAgentsPause");
  const std::size_t motions = page.document().document().state().trajectories.size();
  AgentsPage::rest();
  page.click("buttonAgentsMotion");
  EXPECT_TRUE(AgentsPage::until(
      [&] { return page.document().document().state().trajectories.size() == motions + 1; }, AgentsPage::kPatience));
}

}  // namespace
}  // namespace hapticell::app
