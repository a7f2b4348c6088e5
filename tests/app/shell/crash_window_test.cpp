// SPDX-License-Identifier: Apache-2.0
// What a crash costs: nothing. The program of this test is started once more as a window in which something breaks.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <thread>

#include "app/shell/application.h"
#include "app/start/left_work_card.h"
#include "app/start/start_page.h"
#include "app/style/proxy_style.h"
#include "app/style/theme.h"
#include "geometry/system/assertion.h"
#include "tests/app/pages/cell_page.h"
#include "workcell/files/autosave.h"

namespace hapticell::app {
namespace {

constexpr const char* kProgram = "hapticell 9.9.9\ncommit: 0123456789ab\nlibraries: Qt";
constexpr double kPlace = 0.75;  // m, of the last edit.

void breakContract() {
  const bool holds = std::getenv("PATH") == nullptr;
  HAPTICELL_DEMAND(holds);
}

void useBadMemory() {
  // Read where the compiler cannot see it: it leaves out what cannot happen.
  volatile std::uintptr_t address = 16;
  *reinterpret_cast<volatile int*>(address) = 1;
}

/// One of `ways`, in the thread that it names.
void breakBy(const std::string& way) {
  if (way == "contract") breakContract();
  if (way == "worker") std::thread(breakContract).join();
  if (way == "memory") useBadMemory();
  if (way == "uncaught") std::thread([] { throw std::runtime_error("the worker gave up"); }).join();
  if (way == "twice") {
    std::thread other(breakContract);
    useBadMemory();
    other.join();
  }
}

/// A window with an edit that is not saved, which breaks within the event of the last edit. Never returns.
[[noreturn]] void runAndBreak(const std::string& way, const QString& cell) {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  CellPage page;
  page.window().guardAgainstCrash(kProgram);
  if (!cell.isEmpty() && !page.open(cell)) std::_Exit(3);
  page.trigger("actionSelectAll");
  page.window().messages().tell(Severity::kInformation, "told before the crash");
  const workcell::EntityId part = page.addBox("edited", 0.1);
  QTimer::singleShot(0, &page.window(), [&] {
    page.window().documentModel().execute(workcell::SetPlacement{part, Pose::translation({kPlace, 0.0, 0.0})});
    breakBy(way);
  });
  WindowPage::until([] { return false; }, 60000);
  std::_Exit(4);
}

struct Crash {
  QTemporaryDir folder;
  QString cell;

  Crash() { qputenv("XDG_STATE_HOME", folder.filePath("state").toLocal8Bit()); }
  ~Crash() { qunsetenv("XDG_STATE_HOME"); }
  /// A cell on disk with one part.
  void saveCell() {
    cell = folder.filePath("cell.hcell");
    CellPage page;
    page.addBox("saved", 0.1);
    ASSERT_TRUE(page.window().documentModel().save(cell));
    page.window().files().autosaver().discard();
  }
  /// Runs a window until it breaks so.
  void by(const char* way) {
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(), {"--break", way, cell});
    ASSERT_TRUE(WindowPage::until([&] { return program.state() == QProcess::NotRunning; }, 120000));
    EXPECT_EQ(program.exitStatus(), QProcess::CrashExit) << "it ends as a crash does: " << program.exitCode();
  }
};

/// The reports of crashes, oldest first.
QStringList reports(const Crash& crash) {
  const QDir folder(crash.folder.filePath("state/hapticell/crashes"));
  QStringList texts;
  for (const QString& name : folder.entryList({"crash-*.txt"}, QDir::Files, QDir::Name)) {
    QFile file(folder.filePath(name));
    if (file.open(QIODevice::ReadOnly)) texts << QString::fromUtf8(file.readAll());
  }
  return texts;
}

struct Restart : CellPage {
  Restart() { window().showStartPage(); }
  QList<LeftWorkCard*> cards() { return window().findChildren<LeftWorkCard*>("leftWork"); }
  QString words() {
    QStringList all;
    for (LeftWorkCard* card : cards())
      for (const QLabel* label : card->findChildren<QLabel*>()) all << label->text();
    return all.join('\n');
  }
};

class CrashedWindow : public testing::TestWithParam<const char*> {};

TEST_P(CrashedWindow, KeepsTheWorkToTheLastEditAndSaysWhatBroke) {
  Crash crash;
  crash.by(GetParam());
  Restart page;
  ASSERT_EQ(page.cards().size(), 1);
  const QString words = page.words();
  const std::string way = GetParam();
  EXPECT_TRUE(words.contains("New workcell")) << words.toStdString();
  const std::map<std::string, const char*> reasons{
      {"memory", "SIGSEGV"}, {"uncaught", "the worker gave up"}, {"twice", "Cause"}};
  const char* const why = reasons.contains(way) ? reasons.at(way) : "crash_window_test.cpp";
  EXPECT_TRUE(words.contains(why)) << words.toStdString();
  page.press("buttonRestoreLeft");
  ASSERT_TRUE(WindowPage::until([&] { return page.entities() == 1u; }, 60000));
  EXPECT_NEAR(page.document().findByName("edited")->X_WE.p.x, kPlace, 1e-12);
  EXPECT_TRUE(page.document().isDirty());
  EXPECT_TRUE(page.window().files().leftWork().empty()) << "it is this run's now";
  page.window().files().autosaver().discard();
}

TEST_P(CrashedWindow, LeavesOneReport) {
  Crash crash;
  crash.by(GetParam());
  const QStringList texts = reports(crash);
  ASSERT_EQ(texts.size(), 1);
  for (const char* part :
       {"cause: ", "thread: ", "kept in the recovery copy", "hapticell 9.9.9", "commit: 0123456789ab",
        "actionSelectAll", "message: told before the crash", "calls, innermost first:\n/"})
    EXPECT_TRUE(texts[0].contains(part)) << part << " is missing:\n" << texts[0].toStdString();
}

TEST(CrashReport, IsToldOnceByTheNextStart) {
  Crash crash;
  crash.by("memory");
  const QString settings = crash.folder.filePath("window.ini");
  const auto told = [&settings] {
    MainWindow window({}, settings);
    window.guardAgainstCrash(kProgram);
    QStringList texts;
    for (const Message& message : window.messages().messages())
      if (message.title == "A report of the crash was saved on this computer") texts << message.text;
    return texts;
  };
  const QStringList first = told();
  ASSERT_EQ(first.size(), 1);
  EXPECT_TRUE(first[0].contains("hapticell/crashes/crash-")) << first[0].toStdString();
  EXPECT_TRUE(first[0].contains("Nothing was sent")) << first[0].toStdString();
  EXPECT_TRUE(told().isEmpty());
  EXPECT_EQ(reports(crash).size(), 1) << "it is kept";
}

INSTANTIATE_TEST_SUITE_P(Ways, CrashedWindow, testing::Values("contract", "worker", "memory", "uncaught", "twice"));

TEST(LeftWork, OfASavedCellKeepsItsPlaceAndTheFileAsItWas) {
  Crash crash;
  crash.saveCell();
  crash.by("contract");
  Restart page;
  ASSERT_EQ(page.cards().size(), 1);
  EXPECT_TRUE(page.words().contains("cell.hcell")) << page.words().toStdString();
  page.press("buttonRestoreLeft");
  ASSERT_TRUE(WindowPage::until([&] { return page.entities() == 2u; }, 60000));
  EXPECT_EQ(page.document().path(), crash.cell.toStdString());
  EXPECT_TRUE(page.document().isDirty());
  page.window().files().autosaver().discard();
}

TEST(LeftWork, ACancelledRestoringIsOfferedAgain) {
  Crash crash;
  crash.by("contract");
  Restart page;
  // Cut short: what is read then is no document.
  const auto left = page.window().files().leftWork();
  ASSERT_EQ(left.size(), 1u);
  const auto whole = left[0].copy.string() + ".whole";
  std::filesystem::rename(left[0].copy, whole);
  { QFile(QString::fromStdString(left[0].copy.string())).open(QIODevice::WriteOnly); }
  page.press("buttonRestoreLeft");
  ASSERT_TRUE(WindowPage::until([&] { return !page.window().files().isBusy(); }, 60000));
  WindowPage::settle();
  EXPECT_EQ(page.entities(), 0u);
  std::filesystem::rename(whole, left[0].copy);
  ASSERT_EQ(page.cards().size(), 1);
  EXPECT_TRUE(page.cards().front()->isVisible());
  auto* restore = page.find<QPushButton>("buttonRestoreLeft");
  ASSERT_NE(restore, nullptr);
  EXPECT_TRUE(restore->isEnabled());
  page.press("buttonRestoreLeft");
  EXPECT_TRUE(WindowPage::until([&] { return page.entities() == 1u; }, 60000));
  page.window().files().autosaver().discard();
}

TEST(LeftWork, LaterKeepsItForTheNextStartAndDiscardRemovesIt) {
  Crash crash;
  crash.by("contract");
  {
    Restart page;
    page.press("buttonLaterLeft");
    EXPECT_TRUE(WindowPage::until([&] { return page.cards().isEmpty(); }, 30000));
  }
  Restart page;
  ASSERT_EQ(page.cards().size(), 1);
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, [] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!question) return;
    for (QAbstractButton* button : question->buttons())
      if (question->buttonRole(button) == QMessageBox::DestructiveRole) button->click();
  });
  answer.start(20);
  page.press("buttonDiscardLeft");
  EXPECT_TRUE(WindowPage::until([&] { return page.cards().isEmpty(); }, 30000));
  EXPECT_TRUE(workcell::findLeftWork().empty());
}

TEST(LeftWork, IsToldWhereItsCellIsOpenedWithoutIt) {
  Crash crash;
  crash.saveCell();
  crash.by("contract");
  CellPage page;
  ASSERT_TRUE(page.open(crash.cell));
  const Message& told = page.window().messages().messages().back();
  EXPECT_TRUE(told.title.contains("cell.hcell")) << told.title.toStdString();
  ASSERT_EQ(told.actions.size(), 1u);
  told.actions[0].act();
  WindowPage::settle();
  EXPECT_EQ(page.window().findChildren<LeftWorkCard*>("leftWork").size(), 1);
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  hapticell::app::Application application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  QApplication::setPalette(hapticell::app::paletteOf(hapticell::app::darkTheme()));
  if (argc > 2 && std::string_view(argv[1]) == "--break")
    hapticell::app::runAndBreak(argv[2], argc > 3 ? QString::fromLocal8Bit(argv[3]) : QString());
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
