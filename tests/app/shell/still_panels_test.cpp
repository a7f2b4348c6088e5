// SPDX-License-Identifier: Apache-2.0
// No control of a panel moves while the panel is used: what is said has its room, whatever it says.
#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <set>

#include "app/host/language.h"
#include "app/style/live_label.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/pages/control_places.h"
#include "tests/app/pages/mannequin_page.h"

namespace hapticell::app {
namespace {

constexpr const char* kLong =
    "A sentence of a length that nobody thought of, about entities with names of their own that somebody typed on a "
    "long afternoon, and what touches what, and what can be done about it, in a language with long words.";

class StillPage : public MannequinPage {
 public:
  StillPage() {
    window().resize(1600, 1000);
    workcell::Entity bench;
    bench.name = "Bench";
    bench.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.8, 0.6, 0.05}))};
    bench.X_WE.p = {0.6, 0.0, 0.9};
    add(bench);
    window().setUpdatesEnabled(false);  // Where controls lie is what is looked at, not how they are drawn.
  }
  QDockWidget& bring(const char* name) {
    auto* dock = find<QDockWidget>(name);
    dock->show();
    dock->raise();
    settle();
    settle();
    return *dock;
  }
};

class StillPanels : public testing::TestWithParam<const char*> {};

TEST_P(StillPanels, NoSentenceMovesAControl) {
  Translator translator;
  if (!translator.loadLanguage(GetParam())) GTEST_SKIP() << "built without Qt's Linguist tools";
  qApp->installTranslator(&translator);
  StillPage page;
  ASSERT_TRUE(page.addMannequin());
  page.addRobot("hc6");
  for (const char* opens : {"actionAddRobot", "actionTools", "actionMechanism", "actionMeasure", "actionMoveBy",
                            "actionSettings", "actionMarkers", "actionMotionPanel", "actionTraining"})
    page.trigger(opens);
  int labels = 0;
  for (QDockWidget* dock : page.window().findChildren<QDockWidget*>()) {
    page.bring(dock->objectName().toLatin1());
    const ControlPlaces before(*dock);
    for (QLabel* label : dock->findChildren<QLabel*>()) {
      auto* live = dynamic_cast<LiveLabel*>(label);
      if (!live || !live->isVisible()) continue;
      ++labels;
      const QString said = live->text();
      for (const char* words : {kLong, "", "Short"}) {
        live->setText(QString::fromLatin1(words));
        page.settle();
        EXPECT_EQ(before.moved(), "") << live->objectName().toStdString() << " says \"" << words << '"';
      }
      live->setText(said);
    }
  }
  EXPECT_GT(labels, 12);
  qApp->removeTranslator(&translator);
}

INSTANTIATE_TEST_SUITE_P(Languages, StillPanels, testing::Values("en", "fr"));

TEST(StillPanel, TheJointsStayWhileTheListOfConfigurationsGrows) {
  StillPage page;
  page.addRobot("kuka_kr6_r900");
  QDockWidget& dock = page.bring("dockRobot");
  auto* table = page.find<QAbstractItemView>("tableConfigurations");
  ASSERT_TRUE(page.until([&] { return table->model()->rowCount() > 0; }, page.kPatience));
  const ControlPlaces before(dock);
  EXPECT_GT(before.count(), 20u);
  std::set<int> counts{table->model()->rowCount()};
  // At home it reaches over its back, too; with the arm all but stretched only forwards.
  for (const std::vector<double>& joints : std::vector<std::vector<double>>{
           {0.4, -1.2, 1.2, 0.2, 0.7, 0.1}, {0.1, -0.8, 0.05, 0.2, 0.9, 0.1}, {-0.9, -0.9, 1.6, -0.8, 1.1, -0.5}}) {
    page.document().execute(workcell::SetJoints{page.selected()->id, joints});
    const auto listed = [&] { return table->isEnabled() && table->model()->rowCount() > 0; };
    QTest::qWait(200);
    ASSERT_TRUE(page.until(listed, page.kPatience));
    counts.insert(table->model()->rowCount());
    EXPECT_EQ(before.moved(), "") << table->model()->rowCount() << " rows";
  }
  EXPECT_GT(counts.size(), 1u) << "the list never changed its length";
}

TEST(StillPanel, AddRobotKeepsItsButtonInSightAndItsListInPlace) {
  StillPage page;
  page.window().resize(1366, 768);
  page.trigger("actionAddRobot");
  QDockWidget& dock = page.bring("dockAddRobot");
  const ControlPlaces before(dock);
  auto* add = page.find<QAbstractButton>("buttonAddFromLibrary");
  EXPECT_TRUE(page.window().rect().contains(QRect(add->mapTo(&page.window(), QPoint()), add->size())));
  EXPECT_FALSE(add->visibleRegion().isEmpty());
  auto* list = page.find<QAbstractItemView>("listLibrary");
  for (int row : {3, 9, 20}) {
    list->setCurrentIndex(list->model()->index(row, 0));
    QTest::qWait(120);  // Its picture comes.
    EXPECT_EQ(before.moved(), "") << row;
  }
  auto* search = page.find<QLineEdit>("searchLibrary");
  for (const char* words : {"kr6", "nothing is called so", ""}) {
    search->setText(words);
    page.settle();
    EXPECT_EQ(before.moved(), "") << words;
  }
}

TEST(StillPanel, TheMannequinsPanelsStayWhileItsPostureChanges) {
  StillPage page;
  ASSERT_TRUE(page.addMannequin());
  const auto id = page.selected()->id;
  for (const char* name : {"dockMannequin", "dockErgonomics"}) {
    QDockWidget& dock = page.bring(name);
    QTest::qWait(300);
    const ControlPlaces before(dock);
    EXPECT_GT(before.count(), 3u);
    for (const double bent : {0.3, 0.9, 0.1}) {
      auto posture = postureOf(*page.document().document().find(id));
      posture[mannequin::Dof::kVl5Flexion] = bent;
      page.document().executeAll("bend", {postureCommand(*page.document().document().find(id), posture)});
      QTest::qWait(400);
      EXPECT_EQ(before.moved(), "") << bent;
    }
  }
}

TEST(LiveLabel, KeepsItsRoomAndTellsAllInItsTip) {
  LiveLabel label(2);
  label.resize(120, label.sizeHint().height());
  const QSize before = label.sizeHint();
  label.setText("Short");
  EXPECT_EQ(label.sizeHint(), before);
  EXPECT_TRUE(label.isWhole());
  label.setText(QString::fromLatin1(kLong));
  EXPECT_EQ(label.sizeHint(), before);
  EXPECT_FALSE(label.isWhole());
  label.grab();
  EXPECT_EQ(label.toolTip(), QString::fromLatin1(kLong));
  label.setText("Short");
  label.grab();
  EXPECT_TRUE(label.toolTip().isEmpty());
}

}  // namespace
}  // namespace hapticell::app
