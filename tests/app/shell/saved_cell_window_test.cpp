// SPDX-License-Identifier: Apache-2.0
// Where a cell and what belongs to it are kept: samples open as copies, recordings are saved with their cell.
#include <gtest/gtest.h>

#include <QDir>
#include <QTemporaryDir>

#include "app/start/recent_files.h"
#include "config/configuration.h"
#include "tests/app/pages/cell_page.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::app {
namespace {

TEST(Sample, OpensAsACopyWithoutAFile) {
  const auto demo = config::findShippedFile("workcells/demo.hcell");
  ASSERT_TRUE(demo);
  CellPage page;
  ASSERT_TRUE(page.open(QString::fromStdString(*demo)));
  EXPECT_GT(page.entities(), 3u);
  EXPECT_TRUE(page.document().path().empty());
  EXPECT_FALSE(page.document().isDirty()) << "looking at it asks nothing at the end";
  EXPECT_TRUE(page.window().windowTitle().startsWith("demo copy")) << page.window().windowTitle().toStdString();
  EXPECT_TRUE(page.window().recentFiles().files().isEmpty());
  const QTemporaryDir folder;
  const QString own = folder.filePath("mine.hcell");
  ASSERT_TRUE(page.window().documentModel().save(own));
  EXPECT_EQ(page.document().path(), own.toStdString());
  EXPECT_TRUE(page.window().windowTitle().startsWith("mine"));
}

TEST(SavedCell, HasItsRecordingsBesideItAndCanBeHandedOn) {
  const QTemporaryDir folder;
  qputenv("XDG_DATA_HOME", folder.filePath("data").toLocal8Bit());
  const QString cell = folder.filePath("cell/made.hcell");
  ASSERT_TRUE(QDir().mkpath(folder.filePath("cell")));
  std::size_t frames = 0;
  {
    CellPage page;
    const workcell::EntityId part = page.addBox("part", 0.06);
    page.trigger("actionRecord");
    for (int step = 1; step <= 20; ++step) {
      page.window().documentModel().execute(workcell::SetPlacement{part, Pose::translation({0.01 * step, 0.0, 0.1})});
      QTest::qWait(15);
    }
    page.trigger("actionRecord");
    ASSERT_TRUE(WindowPage::until([&] { return page.state().trajectories.size() == 1u; }, 30000));
    frames = page.state().trajectories[0].motion->size();
    ASSERT_TRUE(page.window().documentModel().save(cell));
    EXPECT_TRUE(page.state().trajectories[0].path.starts_with(folder.filePath("cell").toStdString()))
        << page.state().trajectories[0].path;
    page.trigger("actionUndo");
    page.trigger("actionRedo");
    EXPECT_TRUE(page.state().trajectories[0].path.starts_with(folder.filePath("cell").toStdString()))
        << "undo knows it";
  }
  // Only the cell's own folder goes to another machine.
  ASSERT_TRUE(QDir(folder.filePath("data")).removeRecursively());
  ASSERT_TRUE(QDir().rename(folder.filePath("cell"), folder.filePath("elsewhere")));
  CellPage page;
  ASSERT_TRUE(page.open(folder.filePath("elsewhere/made.hcell")));
  ASSERT_EQ(page.state().trajectories.size(), 1u);
  const auto read = trajectory::readTrajectory(page.state().trajectories[0].path);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->size(), frames);
  qunsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace hapticell::app
