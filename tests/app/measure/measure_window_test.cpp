// SPDX-License-Identifier: Apache-2.0
// Measuring by real events.
#include <gtest/gtest.h>

#include <QClipboard>

#include "app/measure/measure_panel.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

class MeasurePage : public CellPage {
 public:
  MeasurePage() {
    window().resize(1500, 900);
    settle();
    addSolid("left", geometry::makeBox({0.1, 0.1, 0.1}));
    addSolid("right", geometry::makeBox({0.1, 0.1, 0.1}), Pose::translation({0.35, 0, 0.02}));
    trigger("actionMeasure");
    lookAt({0.17, 0, 0}, 0.3);  // The dock took room from the scene.
  }
  QString number() { return find<QLabel>("labelMeasure")->text(); }
  QString text() { return window().findChild<MeasurePanel*>()->text(); }
};

TEST(Measuring, TwoCornersHaveADistanceWithComponents) {
  MeasurePage page;
  page.chooseSegment("segmentsMeasure", 1);
  page.clickPoint({0.046, -0.046, 0.05});
  EXPECT_TRUE(page.text().startsWith("Corner of left")) << page.text().toStdString();
  page.clickPoint({0.304, -0.046, 0.07});
  EXPECT_EQ(page.number().toStdString(), "250.8 mm");
  EXPECT_TRUE(page.text().contains("ΔX\t250.0 mm")) << page.text().toStdString();
  EXPECT_TRUE(page.text().contains("ΔZ\t20.0 mm"));
  page.press("buttonCopyMeasure");
  EXPECT_EQ(QApplication::clipboard()->text(), page.text());
}

TEST(Measuring, OneEdgeHasALength) {
  MeasurePage page;
  page.chooseSegment("segmentsMeasure", 2);
  page.clickPoint({0.01, -0.05, 0.05});
  EXPECT_EQ(page.number(), "100.0 mm");
}

TEST(Measuring, PartsAreMeasuredBesideTheWindow) {
  MeasurePage page;
  page.chooseSegment("segmentsMeasure", 4);
  page.clickPoint({0, 0, 0.05});
  page.clickPoint({0.35, 0, 0.07});
  EXPECT_TRUE(CellPage::until([&] { return page.number() == "250.0 mm"; }, 20000)) << page.number().toStdString();
}

TEST(Measuring, EscapeEndsPickingAndClosingTakesTheLinesAway) {
  MeasurePage page;
  ASSERT_TRUE(page.window().viewport().isPicking());
  page.key(Qt::Key_Escape);
  EXPECT_FALSE(page.window().viewport().isPicking());
  page.press("buttonMeasurePick");
  EXPECT_TRUE(page.window().viewport().isPicking());
  page.find<QDockWidget>("dockMeasure")->close();
  CellPage::settle();
  EXPECT_FALSE(page.window().viewport().isPicking());
}

}  // namespace
}  // namespace hapticell::app
