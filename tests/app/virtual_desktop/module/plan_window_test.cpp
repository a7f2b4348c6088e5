// SPDX-License-Identifier: Apache-2.0
// The planner beside the hand in the window: goal, start, authority, the way in the scene, the state in words.
#include <gtest/gtest.h>

#include <QProgressBar>
#include <QSlider>
#include <algorithm>

#include "app/virtual_desktop/module/plan_control.h"
#include "manipulation/holding/held_entity.h"
#include "tests/app/pages/cell_page.h"
#include "tests/app/pages/server_first.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

constexpr int kWaits = 60000;  // ms.

/// A box behind a wall, and a frame on the other side of the wall; the stylus follows the mouse.
class PlanPage : public ServerFirst, public CellPage {
 public:
  PlanPage() : CellPage(on({})) {
    window().loadModules(ModuleLoader::defaultFolders());
    wall = addSolid("wall", geometry::makeBox({0.02, 0.2, 0.2}));
    seat = addSolid("seat", geometry::makeBox({0.02, 0.02, 0.02}), Pose::translation({0.1, 0, -0.2}));
    box = addSolid("box", geometry::makeBox(dvec3(0.03)), Pose::translation({-0.1, 0, 0}));
    std::vector<workcell::Frame> frames;
    frames.push_back({"middle", Pose::translation({0.0, 0.0, 0.2})});
    EXPECT_TRUE(window().documentModel().execute(workcell::SetFrames{seat, frames}));
    lookAt({0, 0, 0}, 0.25);
    EXPECT_TRUE(window().startModule("Virtual Desktop"));
    select(box);
    auto* entity = find<QComboBox>("comboEntity");
    entity->setCurrentIndex(entity->findText("box"));
    emit entity->activated(entity->currentIndex());
    EXPECT_TRUE(until([this] { return window().snapshot() && now().stylus.connected; }, kWaits));
  }
  const manipulation::SceneSnapshot& now() { return *window().snapshot(); }
  void chooseGoal(const QString& name) {
    auto* goals = find<QComboBox>("comboPlanGoal");
    ASSERT_GE(goals->findText(name), 0) << name.toStdString();
    goals->setCurrentIndex(goals->findText(name));
    press("buttonPlanTowards");
  }
  /// By the mouse: the stylus goes to the viewport's middle and takes the box that is chosen.
  void take() {
    const QPointF place(0.5 * window().viewport().width(), 0.5 * window().viewport().height());
    const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons held) {
      QMouseEvent event(type, place, window().viewport().mapToGlobal(place), button, held, Qt::NoModifier);
      QApplication::sendEvent(&window().viewport(), &event);
      QApplication::processEvents(QEventLoop::AllEvents, 5);
    };
    send(QEvent::MouseMove, Qt::NoButton, Qt::NoButton);
    trigger("actionFollow");
    send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    EXPECT_TRUE(until([this] { return now().stylus.held == box; }, kWaits));
    send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton);
  }
  QString state() { return find<QLabel>("labelPlanState")->text(); }
  bool says(const QString& words) {
    return until([&] { return state().contains(words); }, kWaits);
  }
  workcell::EntityId wall = 0, seat = 0, box = 0;
};

TEST(PlanWindow, FindsAWayWhileTheBoxIsHeldAndShowsWhatActs) {
  PlanPage page;
  EXPECT_TRUE(page.says("No goal yet"));
  EXPECT_FALSE(page.find<QAbstractButton>("buttonPlanStart")->isEnabled());
  page.chooseGoal("seat / middle");
  EXPECT_TRUE(page.says("box should go to: seat / middle"));
  page.press("buttonPlanStart");
  EXPECT_EQ(page.find<QAbstractButton>("buttonPlanStart")->text(), "Stop planner");
  EXPECT_TRUE(page.says("Hold box"));
  page.take();
  EXPECT_TRUE(page.says("Way found, 2.0 mm clearance")) << page.state().toStdString();
  const auto way = page.now().plan.way;
  ASSERT_NE(way, nullptr);
  EXPECT_LT(glm::distance(way->X_WM.back().p, dvec3(0.1, 0, 0)), 1e-6) << "the frame of the seat";
  // Half of the authority, then none: what acts follows it, once forces are on.
  page.trigger("actionForcesOn");
  auto* slider = page.find<QSlider>("sliderPlanAuthority");
  auto* bar = page.find<QProgressBar>("barPlanAuthority");
  slider->setValue(50);
  EXPECT_TRUE(WindowPage::until([&] { return page.now().plan.authority == 0.5; }, kWaits));
  EXPECT_TRUE(WindowPage::until([&] { return bar->value() > 0 && bar->value() <= 50; }, kWaits));
  EXPECT_EQ(page.find<QLabel>("labelPlanAuthority")->text(), "50 %");
  slider->setValue(0);
  EXPECT_TRUE(WindowPage::until([&] { return bar->value() == 0; }, kWaits));
  page.press("buttonPlanStart");
  EXPECT_TRUE(WindowPage::until([&] { return page.now().plan.way == nullptr; }, kWaits));
  EXPECT_TRUE(page.says("Press Start"));
}

TEST(PlanWindow, APlaceThatIsShownIsAGoalAndTheCellsEndForgetsIt) {
  PlanPage page;
  page.press("buttonPlanPresent");
  EXPECT_TRUE(page.says("box should go to: the place that you showed"));
  page.press("buttonPlanStart");
  page.take();
  EXPECT_TRUE(page.says("box is at the goal")) << page.state().toStdString();
  page.window().documentModel().undo();  // The goal is no part of the document.
  EXPECT_TRUE(page.find<QAbstractButton>("buttonPlanStart")->isEnabled());
}

TEST(PlanWindow, TheGripOfTheHandThatMovesAMannequinIsItsGoal) {
  PlanPage page;
  workcell::EntityLoader loader("/");
  Diagnostics notes;
  workcell::Entity worker = *loader.load("mannequin:male:50", 0.0, notes);
  worker.name = "worker";
  worker.X_WE.p.x += 2.0;
  ASSERT_TRUE(page.window().documentModel().execute(workcell::AddEntity{worker}));
  page.select(page.document().findByName("worker")->id);
  auto* entity = page.find<QComboBox>("comboEntity");
  entity->setCurrentIndex(entity->findText("worker"));
  emit entity->activated(entity->currentIndex());
  page.window().holdChoice().set(by::Hand{mannequin::Side::kLeft});
  page.press("buttonPlanPresent");
  EXPECT_TRUE(page.says("worker should go to: the place that you showed"));
  // As the hold itself has it.
  const auto scene = manipulation::PreparedScene::prepare(page.document().snapshotEntities(), {}, {});
  const workcell::EntityId id = page.document().findByName("worker")->id;
  const auto held = manipulation::HeldEntity::take(scene, id, {}, {by::Hand{mannequin::Side::kLeft}}, {});
  ASSERT_TRUE(held.has_value());
  const dvec3 p_WGrip = (*held)->movedFrame().p;
  const auto curves = page.window().viewport().allCurves();
  EXPECT_TRUE(std::any_of(curves.begin(), curves.end(), [&](const SceneCurve& curve) {
    return !curve.points_W.empty() && glm::distance(curve.points_W.front(), p_WGrip) < 1e-9;
  })) << "the goal's axes are drawn there";
}

TEST(PlanWindow, TellsWhyThereIsNoWay) {
  PlanPage page;
  page.chooseGoal("wall");
  page.press("buttonPlanStart");
  page.take();
  EXPECT_TRUE(page.says("No way yet: ")) << page.state().toStdString();
  EXPECT_TRUE(page.state().contains("wall")) << page.state().toStdString();
}

}  // namespace
}  // namespace hapticell::app
