// SPDX-License-Identifier: Apache-2.0
// Two programs on one cell: the second is told, and saving asks before it undoes what others wrote.
#include <gtest/gtest.h>

#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <fstream>

#include "tests/app/pages/cell_page.h"
#include "workcell/files/autosave.h"
#include "workcell/files/content_name.h"
#include "workcell/format/document_io.h"
#include "workcell/files/document_lock.h"

namespace hapticell::app {
namespace {

/// Answers the question about saving, each time that it is asked.
class Answer {
 public:
  explicit Answer(const QString& button) {
    QObject::connect(&timer_, &QTimer::timeout, [this, button] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!question || question->objectName() != QLatin1String("askSaving")) return;
      ++asked_;
      why_ = question->informativeText();
      for (QAbstractButton* each : question->buttons())
        if (each->text().remove('&').startsWith(button)) return each->click();
    });
    timer_.start(20);
  }
  int asked() const { return asked_; }
  const QString& why() const { return why_; }

 private:
  QTimer timer_;
  int asked_ = 0;
  QString why_;
};

class TwoWindows : public ::testing::Test {
 protected:
  TwoWindows() {
    qputenv("XDG_STATE_HOME", folder_.filePath("state").toLocal8Bit());
    workcell::Document document;
    EXPECT_TRUE(workcell::saveDocument(document, file().toStdString()));
  }
  ~TwoWindows() override { qunsetenv("XDG_STATE_HOME"); }
  QString file() const { return folder_.filePath("cell.hcell"); }
  std::string content() const { return workcell::contentNameOf(file().toStdString()); }
  QTemporaryDir folder_;
};

TEST_F(TwoWindows, TheSecondIsToldAndItsSaveAsks) {
  CellPage first;
  ASSERT_TRUE(first.open(file()));
  const std::string before = content();
  CellPage second;
  ASSERT_TRUE(second.open(file()));
  EXPECT_FALSE(first.window().files().guard().isReadOnly());
  EXPECT_TRUE(second.window().files().guard().isReadOnly());
  EXPECT_TRUE(second.window().windowTitle().contains("open elsewhere"));
  const Message& told = second.window().messages().messages().back();
  EXPECT_TRUE(told.title.contains("cell.hcell is open elsewhere")) << told.title.toStdString();
  second.addBox("second", 0.1);
  {
    const Answer cancel("Cancel");
    second.trigger("actionSave");
    EXPECT_EQ(cancel.asked(), 1);
    EXPECT_TRUE(cancel.why().contains("has had it open since")) << cancel.why().toStdString();
  }
  EXPECT_EQ(content(), before) << "nothing is written";
  EXPECT_TRUE(second.document().isDirty());
  {
    const Answer anyway("Save anyway");
    second.trigger("actionSave");
    EXPECT_EQ(anyway.asked(), 1);
  }
  EXPECT_NE(content(), before);
  EXPECT_FALSE(second.document().isDirty());
  first.addBox("first", 0.1);
  {
    const Answer cancel("Cancel");
    first.trigger("actionSave");
    EXPECT_EQ(cancel.asked(), 1) << "it would undo what the second one saved";
    EXPECT_TRUE(cancel.why().contains("after it was opened here")) << cancel.why().toStdString();
  }
  first.window().files().autosaver().discard();
}

TEST_F(TwoWindows, TheSecondHasItOnceTheFirstIsGone) {
  CellPage second;
  {
    CellPage first;
    ASSERT_TRUE(first.open(file()));
    ASSERT_TRUE(second.open(file()));
    ASSERT_TRUE(second.window().files().guard().isReadOnly());
  }
  second.addBox("second", 0.1);
  const Answer none("Cancel");
  second.trigger("actionSave");
  EXPECT_EQ(none.asked(), 0);
  EXPECT_FALSE(second.document().isDirty());
  EXPECT_FALSE(second.window().windowTitle().contains("open elsewhere"));
}

TEST_F(TwoWindows, SavingOneselfAsksNothing) {
  CellPage page;
  ASSERT_TRUE(page.open(file()));
  const Answer none("Cancel");
  for (const char* name : {"a", "b"}) {
    page.addBox(name, 0.1);
    page.trigger("actionSave");
    EXPECT_FALSE(page.document().isDirty());
  }
  EXPECT_EQ(none.asked(), 0);
  EXPECT_TRUE(QFile::exists(folder_.filePath(".cell.hcell.lock")));
  page.trigger("actionNew");
  EXPECT_FALSE(QFile::exists(folder_.filePath(".cell.hcell.lock"))) << "the lock goes with the document";
}

TEST_F(TwoWindows, AFileThatOthersChangedIsAskedAbout) {
  CellPage page;
  ASSERT_TRUE(page.open(file()));
  Diagnostics notes;
  auto other = workcell::loadDocument(file().toStdString(), notes);
  ASSERT_TRUE(other);
  ASSERT_TRUE(other->execute(workcell::AddEntity{workcell::makeBuiltInPart("box:1,1,1", 1.0).value()}));
  ASSERT_TRUE(workcell::saveDocument(*other, file().toStdString()));
  std::filesystem::last_write_time(file().toStdString(),
                                   std::filesystem::file_time_type::clock::now() - std::chrono::hours(48));
  const std::string theirs = content();
  page.addBox("mine", 0.1);
  const Answer cancel("Cancel");
  page.trigger("actionSave");
  EXPECT_EQ(cancel.asked(), 1) << "whatever the clocks say";
  EXPECT_EQ(content(), theirs);
  page.window().files().autosaver().discard();
}

TEST_F(TwoWindows, ACopyFromACrashKnowsWhatItIsACopyOf) {
  {
    CellPage page;
    ASSERT_TRUE(page.open(file()));
    page.addBox("unsaved", 0.1);
    page.window().files().autosaver().save();
    const auto run = page.window().files().autosaver().runFolder();
    ASSERT_TRUE(run);
    ASSERT_TRUE(WindowPage::until([&] { return std::filesystem::exists(workcell::copyIn(*run)); }, 30000));
    EXPECT_EQ(workcell::copyFactsIn(*run).base, content());
    EXPECT_EQ(workcell::copyFactsIn(*run).document, file().toStdString());
  }
  const auto left = workcell::findLeftWork();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_FALSE(left[0].document_changed);
  std::ofstream(file().toStdString(), std::ios::app) << "\n";
  ASSERT_EQ(workcell::findLeftWork().size(), 1u);
  EXPECT_TRUE(workcell::findLeftWork()[0].document_changed);
  CellPage page;
  page.window().files().restore(left[0]);
  ASSERT_TRUE(WindowPage::until([&] { return page.entities() == 1u; }, 30000));
  const Answer cancel("Cancel");
  page.trigger("actionSave");
  EXPECT_EQ(cancel.asked(), 1) << "the file is not what the copy was made of";
  page.window().files().autosaver().discard();
}

}  // namespace
}  // namespace hapticell::app
