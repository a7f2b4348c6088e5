// SPDX-License-Identifier: Apache-2.0
// What the user sees while the parts of a large cell are made ready for contacts.
#include "app/virtual_desktop/widgets/preparation_bar.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <optional>

namespace hapticell::app {
namespace {

/// A view with the bar, without a screen.
class PreparationBarTest : public testing::Test {
 protected:
  void SetUp() override {
    if (QApplication::instance() == nullptr) {
      qputenv("QT_QPA_PLATFORM", "offscreen");
      static int count = 1;
      static char name[] = "test";
      static char* names[] = {name, nullptr};
      static QApplication application(count, names);
    }
    view_.emplace();
    view_->resize(800, 600);
    bar_ = new PreparationBar(&*view_);
    view_->show();
  }
  std::optional<QWidget> view_;
  PreparationBar* bar_ = nullptr;  // The view's.
};

TEST_F(PreparationBarTest, ComesForLongWorkOnlyAndTellsHowFarItIs) {
  bar_->setPatience(1000000000);
  bar_->setShare(0.1);
  bar_->setShare(0.9);
  EXPECT_FALSE(bar_->isVisible()) << "short work is not worth a word";
  bar_->setPatience(0);
  bar_->setShare(0.42);
  ASSERT_TRUE(bar_->isVisible());
  EXPECT_EQ(bar_->findChild<QLabel*>()->text(), "Not felt yet: preparing contacts 42 %");
  EXPECT_EQ(bar_->findChild<QProgressBar*>("progressPreparation")->value(), 42);
  EXPECT_TRUE(view_->rect().contains(bar_->geometry())) << "in the corner of the view";
  EXPECT_GE(bar_->width(), bar_->sizeHint().width()) << "nothing is cut";
  bar_->setShare(std::nullopt);
  EXPECT_FALSE(bar_->isVisible());
}

TEST_F(PreparationBarTest, ItsButtonGivesUp) {
  int cancelled = 0;
  QObject::connect(bar_, &PreparationBar::cancelled, bar_, [&cancelled] { ++cancelled; });
  bar_->setPatience(0);
  bar_->setShare(0.5);
  auto* button = bar_->findChild<QToolButton*>("buttonCancelPreparation");
  ASSERT_NE(button, nullptr);
  EXPECT_FALSE(button->toolTip().isEmpty());
  button->click();
  EXPECT_EQ(cancelled, 1);
}

}  // namespace
}  // namespace hapticell::app
