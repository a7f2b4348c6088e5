// SPDX-License-Identifier: Apache-2.0
// What the window writes into its log file.
#include "app/shell/window_log.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

struct LoggedState {
  QTemporaryDir folder;
  LoggedState() { qputenv("XDG_STATE_HOME", folder.path().toLocal8Bit()); }
  ~LoggedState() { qunsetenv("XDG_STATE_HOME"); }
  QString text() const {
    QFile file(folder.filePath("hapticell/logs/hapticell.log"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  }
};

TEST(WindowLog, HoldsStartFilesMessagesDeviceAndEnd) {
  const LoggedState state;
  const QString cell = state.folder.filePath("cell.hcell");
  {
    CellPage page;
    page.window().keepLog(config::LogLevel::kInfo, "hapticell 9.9.9\ncommit: 0123456789ab");
    page.addBox("a box", 0.1);
    ASSERT_TRUE(page.window().documentModel().save(cell));
    ASSERT_TRUE(page.open(cell));
    page.window().messages().reportCause(Severity::kProblem, "It was not read",
                                         Error{.file = "part.stl", .found = "3 bytes", .expected = "a mesh"});
    page.window().setDeviceText("Touch", true);
    page.window().setDeviceText("Touch", true);
    page.trigger("actionSelectAll");
    EXPECT_TRUE(WindowPage::until([&] { return state.text().contains("OpenGL: "); }, 30000));
  }
  const QString text = state.text();
  for (const QString& part : {QString("info: hapticell 9.9.9; commit: 0123456789ab"), "info: opened: " + cell,
                              QString("error: message: It was not read | part.stl: 3 bytes; expected a mesh"),
                              QString("info: device: Touch"), QString("info: hapticell ends")})
    EXPECT_TRUE(text.contains(part)) << part.toStdString() << " is missing:\n" << text.toStdString();
  EXPECT_EQ(text.count("device: Touch"), 1);
  EXPECT_FALSE(text.contains("actionSelectAll")) << "actions are of level debug";
}

TEST(WindowLog, HoldsActionsAndButtonsAtLevelDebug) {
  const LoggedState state;
  CellPage page;
  page.window().keepLog(config::LogLevel::kDebug, "hapticell");
  page.trigger("actionSelectAll");
  QWidget later(&page.window());
  later.setObjectName("later");
  QPushButton named("words", &later), unnamed("typed by the user", &later);
  named.setObjectName("buttonNamed");
  later.show();
  WindowPage::settle();
  named.click();
  unnamed.click();
  EXPECT_TRUE(state.text().contains("debug: action: actionSelectAll")) << state.text().toStdString();
  EXPECT_TRUE(state.text().contains("action: buttonNamed"));
  EXPECT_TRUE(state.text().contains("action: QPushButton in later"));
  EXPECT_FALSE(state.text().contains("typed by the user"));
}

TEST(WindowLog, IsDoneWithoutWhereItsFolderCannotBeMade) {
  const LoggedState state;
  QFile file(state.folder.filePath("hapticell"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  CellPage page;
  const auto before = page.window().messages().messages().size();
  page.window().keepLog(config::LogLevel::kInfo, "hapticell");
  ASSERT_EQ(page.window().messages().messages().size(), before + 1);
  EXPECT_EQ(page.window().messages().messages().back().title, "There is no log file");
  page.window().setDeviceText("Touch", true);
}

}  // namespace
}  // namespace hapticell::app
