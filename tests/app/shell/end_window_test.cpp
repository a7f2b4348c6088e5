// SPDX-License-Identifier: Apache-2.0
// How the window ends when the system says so: nothing that was done is lost, and no server is left.
#include <gtest/gtest.h>

#include <QDialog>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QProcess>
#include <QRegularExpression>
#include <QScreen>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <csignal>
#include <filesystem>
#include <new>
#include <vector>

#include "app/shell/application.h"
#include "app/shell/end_signals.h"
#include "tests/app/pages/cell_page.h"
#include "tests/app/pages/processes.h"
#include "workcell/files/autosave.h"

namespace hapticell::app {
namespace {

TEST(EndSignals, AreToldInTheEventLoopAndOnlyWhileSomebodyListens) {
  std::vector<int> told;
  {
    EndSignals listener;
    QObject::connect(&listener, &EndSignals::asked, [&told](int number) { told.push_back(number); });
    for (const int number : {SIGTERM, SIGHUP, SIGINT}) {
      ASSERT_EQ(std::raise(number), 0);
      EXPECT_TRUE(WindowPage::until([&] { return !told.empty() && told.back() == number; }, 30000));
    }
    EXPECT_EQ(told.size(), 3u);
  }
  struct sigaction now {};
  ::sigaction(SIGTERM, nullptr, &now);
  EXPECT_EQ(now.sa_handler, SIG_DFL);
}

TEST(OutOfMemory, GivesUpWhatWasAskedAndSaysSo) {
  CellPage page;
  const workcell::EntityId part = page.addSolid("part", geometry::makeBox(dvec3(0.06)));
  auto* application = qobject_cast<Application*>(qApp);
  ASSERT_NE(application, nullptr);
  MainWindow& window = page.window();
  const auto told = QObject::connect(application, &Application::outOfMemory, [&window] { reportOutOfMemory(window); });
  const std::size_t before = window.messages().messages().size();
  bool tried = false;
  QTimer::singleShot(0, &window, [&] {
    tried = true;
    window.documentModel().beginStep("Move part");
    window.documentModel().execute(workcell::SetPlacement{part, Pose::translation({1.0, 0.0, 0.0})});
    throw std::bad_alloc();
  });
  EXPECT_TRUE(WindowPage::until([&] { return tried; }, 30000));
  QObject::disconnect(told);
  ASSERT_EQ(window.messages().messages().size(), before + 1);
  EXPECT_EQ(window.messages().messages().back().severity, Severity::kProblem);
  EXPECT_FALSE(window.documentModel().document().inCompound());
  EXPECT_LT(window.documentModel().document().find(part)->X_WE.p.x, 0.5) << "half a step was kept";
}

struct Recording : CellPage {
  Recording() {
    part = addSolid("part", geometry::makeBox(dvec3(0.06)));
    trigger("actionRecord");
    EXPECT_TRUE(window().recording().isRecording());
    // The waits pace what is recorded; a slower machine only gets more frames.
    for (int step = 1; step <= 20; ++step) {
      window().documentModel().execute(workcell::SetPlacement{part, Pose::translation({0.01 * step, 0.0, 0.1})});
      QTest::qWait(15);
    }
  }
  workcell::EntityId part = 0;
};

TEST(EndOfTheWindow, ClosingWhileRecordingKeepsTheTakeAndAsksAboutIt) {
  Recording page;
  bool asked = false;
  // The question comes from within close(): answered from a timer. Cancel: the window stays, with the take.
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, [&asked] {
    auto* question = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!question) return;
    asked = true;
    question->reject();
  });
  answer.start(20);
  page.window().close();
  EXPECT_TRUE(WindowPage::until([&] { return asked; }, 30000));
  EXPECT_TRUE(page.window().isVisible());
  EXPECT_FALSE(page.window().recording().isRecording());
  EXPECT_EQ(page.state().trajectories.size(), 1u);
}

TEST(EndOfTheWindow, EndNowKeepsTheTakeAndACopyOfWhatIsNotSaved) {
  Recording page;
  ASSERT_TRUE(page.window().documentModel().document().isDirty());
  page.window().endNow();
  EXPECT_TRUE(WindowPage::until([&] { return page.state().trajectories.size() == 1u; }, 30000));
  const auto run = page.window().files().autosaver().runFolder();
  ASSERT_TRUE(run);
  EXPECT_TRUE(WindowPage::until([&] { return std::filesystem::exists(workcell::copyIn(*run)); }, 30000)) << *run;
  page.window().files().autosaver().discard();
}

/// Starts the program with settings of its own in `folder`.
void startProgram(QProcess& program, const QTemporaryDir& folder, const QStringList& words) {
  QFile settings(folder.filePath("test.toml"));
  ASSERT_TRUE(settings.open(QIODevice::WriteOnly));
  settings.write(QByteArray("[server]\nport = ") + QByteArray::number(freePort()) + "\n");
  settings.close();
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) environment.insert(name, folder.path());
  program.setProcessEnvironment(environment);
  program.start(QDir(QCoreApplication::applicationDirPath()).filePath("hapticell"),
                QStringList{"--config", settings.fileName()} + words);
  ASSERT_TRUE(program.waitForStarted(30000));
}

/// The first start on a screen lower than the window's usual size: its last line would lie below the edge.
TEST(FirstStart, HasRoomOnTheScreenForTheWindowAndItsFrame) {
  if (QStandardPaths::findExecutable("xdotool").isEmpty()) GTEST_SKIP() << "xdotool is not installed";
  const QTemporaryDir folder;
  QProcess program;
  startProgram(program, folder, {"--no-module"});
  const QSize screen = QGuiApplication::primaryScreen()->size();
  ASSERT_LE(screen.height(), 900);
  QSize size;
  const auto measured = [&] {
    QProcess look;
    look.start("xdotool", {"search", "--onlyvisible", "--pid", QString::number(program.processId()), "--name", "HaptiCell",
                           "getwindowgeometry"});
    look.waitForFinished(30000);
    const auto found = QRegularExpression("Geometry: (\\d+)x(\\d+)").match(QString::fromUtf8(look.readAllStandardOutput()));
    if (found.hasMatch()) size = {found.captured(1).toInt(), found.captured(2).toInt()};
    return found.hasMatch();
  };
  EXPECT_TRUE(WindowPage::until(measured, 60000));
  EXPECT_LE(size.width(), screen.width());
  EXPECT_LE(size.height(), screen.height() - 40) << "no room for a title bar";
  program.terminate();
  EXPECT_TRUE(WindowPage::until([&] { return program.state() == QProcess::NotRunning; }, 60000));
}

class EndedProgram : public testing::TestWithParam<int> {};

TEST_P(EndedProgram, LeavesNoServerWhicheverWayItEnds) {
  if (!QFile::exists("/proc/self/task")) GTEST_SKIP() << "no list of processes here";
  const QTemporaryDir folder;
  QProcess program;
  startProgram(program, folder, {"--size", "640x400"});
  QByteArrayList children;
  ASSERT_TRUE(WindowPage::until(
      [&] {
        children = childrenOf(program.processId());
        return children.size() == 1 && !children.front().isEmpty();
      },
      60000))
      << "its server";
  const auto server = static_cast<pid_t>(children.front().toLongLong());
  ASSERT_EQ(::kill(static_cast<pid_t>(program.processId()), GetParam()), 0);
  ASSERT_TRUE(WindowPage::until([&] { return program.state() == QProcess::NotRunning; }, 60000));
  if (GetParam() != SIGKILL) {
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(program.exitCode(), 0);
  }
  EXPECT_TRUE(WindowPage::until([&] { return ::kill(server, 0) != 0; }, 30000)) << "the server goes on";
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedProgram, testing::Values(SIGTERM, SIGHUP, SIGKILL));

}  // namespace
}  // namespace hapticell::app
