// SPDX-License-Identifier: Apache-2.0
// Nothing of a cell is left in the next: a window that had another cell before looks and says the same as a fresh one.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QComboBox>
#include <QLineEdit>
#include <QSlider>
#include <QTemporaryDir>
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/ergonomics/time_panel.h"
#include "app/mannequin/mannequin_panel.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

constexpr int kWait = 60000;  // ms.

/// What differs from run to run: how long the program took, and how busy it was.
bool isOfTheMoment(const QWidget& widget) {
  return widget.objectName() == "labelLive" || widget.objectName() == "labelWhy";
}

/// All that the docks say, a line a widget that is seen; what is told of the program itself is left out.
QStringList said(MainWindow& window) {
  QStringList lines;
  window.setUpdatesEnabled(false);  // What is said is looked at, dock after dock, not how it is drawn.
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    if (dock->objectName() == "dockMessages") continue;
    const bool was_shown = dock->isVisible();
    dock->show();
    dock->raise();
    WindowPage::settle();
    for (const QWidget* widget : dock->findChildren<QWidget*>()) {
      if (!widget->isVisibleTo(dock) || isOfTheMoment(*widget)) continue;
      QString value;
      if (const auto* label = qobject_cast<const QLabel*>(widget)) value = label->text();
      if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
        value = button->text() + (button->isChecked() ? " on" : "") + (button->isEnabled() ? "" : " grey");
      if (const auto* line = qobject_cast<const QLineEdit*>(widget)) value = line->text();
      if (const auto* combo = qobject_cast<const QComboBox*>(widget)) value = combo->currentText();
      if (const auto* slider = qobject_cast<const QSlider*>(widget)) value = QString::number(slider->value());
      if (const auto* view = qobject_cast<const QAbstractItemView*>(widget); view && view->model())
        value = QStringLiteral("%1 rows").arg(view->model()->rowCount());
      if (!value.isEmpty())
        lines << dock->objectName() + '/' + QLatin1String(widget->metaObject()->className()) + '/' +
                     widget->objectName() + ": " + value;
    }
    if (!was_shown) dock->hide();
  }
  window.setUpdatesEnabled(true);
  lines.sort();
  return lines;
}

/// What the docks say once it stays the same: postures are scored, and pictures made, some time after they rest.
QStringList saidAtRest(MainWindow& window) {
  QStringList now = said(window), before;
  for (int again = 0; again < 10 && now != before; ++again) {
    WindowPage::until([] { return false; }, 500);
    before = std::exchange(now, said(window));
  }
  return now;
}

/// Cell B: one box, and a mannequin.
struct CellB {
  QTemporaryDir folder;
  QString path = folder.filePath("b.hcell");
  CellB() {
    CellPage page;
    page.addBox("block", 0.2);
    addMannequin(page);
    EXPECT_TRUE(page.window().documentModel().save(path));
    page.window().files().autosaver().discard();
  }
  static void addMannequin(CellPage& page) {
    const std::size_t before = page.entities();
    page.trigger("actionAddMannequin");
    ASSERT_TRUE(WindowPage::until([&] { return page.entities() == before + 1; }, kWait));
  }
};

/// Every kind of state that a user makes of a cell.
void useCellA(CellPage& page, const QTemporaryDir& folder) {
  page.window().resize(1500, 950);
  const workcell::EntityId part = page.addSolid("part", geometry::makeBox(dvec3(0.1)));
  page.addSolid("other", geometry::makeBox(dvec3(0.1)), Pose::translation({0.3, 0, 0}));
  // A recording, played, with the room that it needs.
  page.trigger("actionRecord");
  for (int step = 1; step <= 10; ++step) {
    page.window().documentModel().execute(workcell::SetPlacement{part, Pose::translation({0.0, 0.01 * step, 0.1})});
    QTest::qWait(15);
  }
  page.trigger("actionRecord");
  ASSERT_TRUE(WindowPage::until([&] { return page.state().trajectories.size() == 1u; }, kWait));
  page.showDock("dockTrajectory");
  page.find<QAbstractButton>("buttonShown")->click();
  page.find<QAbstractButton>("buttonSwept")->click();
  page.find<QAbstractButton>("buttonTeachMotion")->click();
  // A measurement and a section.
  page.trigger("actionMeasure");
  page.lookAt({0.17, 0, 0}, 0.3);
  page.clickPoint({0.3, 0, 0.05});
  page.trigger("actionSection");
  page.trigger("actionKeepView");
  // A mannequin on a seat, with its drawings, all bodies and a scored motion.
  CellB::addMannequin(page);
  page.showDock("dockMannequin");
  for (const char* name : {"lock0", "lock3", "draw0", "draw4"}) page.find<QAbstractButton>(name)->click();
  page.showDock("dockErgonomics");
  page.find<QAbstractButton>("checkAllBodies")->click();
  const QString motion = folder.filePath("stand.bvh");
  ASSERT_TRUE(page.window().findChild<MannequinPanel*>()->savePostureFile(motion));
  page.showDock("dockErgonomicsTime");
  WindowPage::until([] { return false; }, 300);  // Scored some times a second while it is seen.
  page.window().findChild<TimePanel*>()->open(motion);
  ASSERT_TRUE(WindowPage::until([&] { return page.find<QLabel>("labelMotion")->text() == "stand"; }, kWait));
  // Words in the filters, and contacts in the log.
  page.find<QLineEdit>("fieldFilter")->setText("par");
  page.find<QLineEdit>("filterPairs")->setText("oth");
  manipulation::SceneSnapshot snapshot;
  snapshot.time_s = 1.0;
  snapshot.stylus.held = part;
  manipulation::PairState pair;
  pair.moved = part;
  pair.other = page.document().findByName("other")->id;
  pair.contact = pair.near_miss = true;
  snapshot.pairs = {pair};
  page.window().setSnapshot(snapshot);
  WindowPage::until([] { return false; }, 300);
  page.window().setSnapshot(std::nullopt);
  page.trigger("actionFollowEyes");
  WindowPage::settle();
}

void openB(CellPage& page, const CellB& b) {
  page.window().resize(1500, 950);
  ASSERT_TRUE(page.open(b.path));
  page.select(page.document().findByName("block")->id);
  page.showDock("dockTrajectory");
}

TEST(NextCell, HasNothingOfTheOneBefore) {
  const CellB b;
  const QTemporaryDir folder;
  QStringList fresh, after;
  {
    CellPage page;
    openB(page, b);
    fresh = saidAtRest(page.window());
  }
  CellPage page;
  useCellA(page, folder);
  EXPECT_TRUE(page.window().viewport().section().has_value());
  EXPECT_FALSE(page.window().viewport().scene().ghosts().empty());
  page.window().files().autosaver().discard();
  openB(page, b);
  EXPECT_FALSE(page.window().viewport().section().has_value());
  EXPECT_TRUE(page.window().viewport().scene().ghosts().empty());
  EXPECT_EQ(page.window().holdChoice().hands(), by::BothHands());
  after = saidAtRest(page.window());
  QStringList left, missing;
  std::set_difference(after.begin(), after.end(), fresh.begin(), fresh.end(), std::back_inserter(left));
  std::set_difference(fresh.begin(), fresh.end(), after.begin(), after.end(), std::back_inserter(missing));
  EXPECT_TRUE(left.isEmpty()) << "only after another cell:\n" << left.join('\n').toStdString();
  EXPECT_TRUE(missing.isEmpty()) << "only in a fresh window:\n" << missing.join('\n').toStdString();
}

TEST(NextCell, HasOtherIdsAndRevisions) {
  const CellB b;
  CellPage page;
  const workcell::EntityId part = page.addSolid("part", geometry::makeBox(dvec3(0.1)));
  const auto revision = page.document().revision();
  page.window().files().autosaver().discard();
  ASSERT_TRUE(page.open(b.path));
  EXPECT_EQ(page.document().find(part), nullptr);
  EXPECT_GT(page.document().revision(), revision);
}

}  // namespace
}  // namespace hapticell::app
