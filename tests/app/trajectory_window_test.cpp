// SPDX-License-Identifier: Apache-2.0
// The trajectory docks in the whole window under a virtual display, by real clicks and keys.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QProcess>
#include <QStandardPaths>

#include "app/host/recording_hub.h"
#include "app/style/proxy_style.h"
#include "app/trajectory/motion_chart.h"
#include "app/trajectory/motion_export.h"
#include "app/trajectory/play_video.h"
#include "app/trajectory/time_bar.h"
#include "app/trajectory/track_rows.h"
#include "app/trajectory/training_panel.h"
#include "app/trajectory/training_report.h"
#include "config/configuration.h"
#include "tests/app/cell_page.h"
#include "trajectory/trajectory_io.h"

namespace hapticell::app {
namespace {

using trajectory::Trajectory;

/// What a user does with motions.
class MotionPage : public CellPage {
 public:
  static constexpr int kPatience = 20000;
  MotionPage() {
    window().resize(1300, 860);
    box_ = addSolid("box", geometry::makeBox(dvec3(0.1)));
    addSolid("wall", geometry::makeBox({0.02, 0.4, 0.4}), Pose::translation({0.5, 0, 0}));
    showDock("dockTrajectory");
    showDock("dockMotion");
    window().activateWindow();
    window().viewport().setFocus();
    settle();
  }
  workcell::EntityId box() const { return box_; }
  TimeBar& bar() { return *find<TimeBar>("timeBar"); }
  const std::vector<TrackRow>& rows() { return bar().rows(); }
  /// A motion of the box along x as a file, imported through the panel's own work.
  bool import(const std::vector<std::pair<double, dvec3>>& points, const QString& name) {
    Trajectory motion;
    motion.name = name.toStdString();
    motion.entity = "box";
    for (const auto& [t, p] : points) motion.addFrame({t, Pose::translation(p)});
    const QString path = folder_.filePath(name + ".htraj");
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(trajectory::toJsonText(motion)));
    file.close();
    const std::size_t before = motions();
    window().findChild<MotionExport*>()->importFrom({path}, "box");
    return until([&] { return motions() == before + 1 && isIdle(); }, kPatience);
  }
  std::size_t motions() { return state().trajectories.size(); }
  bool isIdle() {
    const auto* cancel = window().findChild<QAbstractButton*>("buttonCancelMotionWork");
    return cancel && !cancel->isVisibleTo(cancel->parentWidget());
  }
  /// Clicks and waits until the new motion is there.
  bool pressForMotion(const char* button) {
    const std::size_t before = motions();
    press(button);
    return until([&] { return motions() == before + 1 && isIdle(); }, kPatience);
  }
  const Trajectory& newest() { return *state().trajectories.back().motion; }
  Pose shownBox() {
    const auto& scene = window().viewport().scene();
    return scene.placement_W(*scene.find(box_));
  }
  void scrub(double t) {
    QTest::mouseClick(&bar(), Qt::LeftButton, Qt::NoModifier,
                      QPoint(static_cast<int>(bar().axis().x(t)), TimeBar::kRuler / 2));
    settle();
  }
  QString words(const char* label) { return find<QLabel>(label)->text(); }
  QDir& folder() { return folder_; }

 private:
  struct Folder : QDir {
    Folder() : QDir(QDir::temp().filePath(QStringLiteral("motions-%1").arg(::getpid()))) { QDir().mkpath(path()); }
    ~Folder() { removeRecursively(); }
  } folder_;
  workcell::EntityId box_ = 0;
};

TEST(TrajectoryDock, BeginsWithASentenceThatSaysHow) {
  MotionPage page;
  EXPECT_TRUE(page.rows().empty());
  EXPECT_FALSE(page.find<QAbstractButton>("buttonPlay")->isEnabled());
  EXPECT_FALSE(page.find<QAbstractButton>("buttonSmoothMotion")->isEnabled());
  EXPECT_TRUE(page.words("labelMotionFacts").contains("Record one"));
}

TEST(TrajectoryDock, RecordsWhatIsMovedInTheWindow) {
  MotionPage page;
  page.key(Qt::Key_R);
  EXPECT_TRUE(page.window().recording().isRecording());
  for (int i = 1; i <= 20; ++i) {
    page.window().documentModel().execute(workcell::SetPlacement{page.box(), Pose::translation({0.005 * i, 0, 0})});
    QTest::qWait(15);
  }
  page.key(Qt::Key_R);
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 1 && page.isIdle(); }, MotionPage::kPatience));
  const Trajectory& take = page.newest();
  EXPECT_EQ(take.entity, "box");
  EXPECT_GT(take.size(), 8u);
  EXPECT_NEAR(take[0].X_WT.p.x, 0.0, 1e-12);
  EXPECT_NEAR(take.frames().back().X_WT.p.x, 0.1, 1e-12);
  EXPECT_FALSE(take.take.empty());
  EXPECT_TRUE(QFile::exists(QString::fromStdString(page.state().trajectories.back().path))) << "kept at once";
  // In the tree, and one step of undo.
  page.trigger("actionUndo");
  EXPECT_EQ(page.motions(), 0u);
  page.trigger("actionRedo");
  EXPECT_EQ(page.motions(), 1u);
}

TEST(TrajectoryDock, ShiftRAddsFramesByHand) {
  MotionPage page;
  page.select(page.box());
  for (const double x : {0.0, 0.1, 0.2}) {
    page.window().documentModel().execute(workcell::SetPlacement{page.box(), Pose::translation({x, 0, 0})});
    QTest::qWait(30);
    page.key(Qt::Key_R, Qt::ShiftModifier);
  }
  page.key(Qt::Key_R);
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 1; }, MotionPage::kPatience));
  ASSERT_EQ(page.newest().size(), 3u);
  EXPECT_TRUE(page.newest()[1].by_hand);
  EXPECT_NEAR(page.newest()[2].X_WT.p.x, 0.2, 1e-12);
}

TEST(TrajectoryDock, PlaysStepsScrubsAndLoops) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {0.2, {0.2, 0, 0}}, {0.4, {0.2, 0.2, 0}}}, "way"));
  ASSERT_EQ(page.rows().size(), 1u);
  EXPECT_TRUE(page.rows()[0].played);
  const Pose before = page.shownBox();
  page.scrub(0.1);
  EXPECT_NEAR(page.shownBox().p.x, 0.1, 2e-3);
  EXPECT_EQ(page.document().findByName("box")->X_WE.p, before.p) << "the document stays";
  page.bar().setFocus();
  QTest::keyClick(&page.bar(), Qt::Key_Right);
  EXPECT_NEAR(page.shownBox().p.x, 0.2, 1e-9);
  QTest::keyClick(&page.bar(), Qt::Key_Right);
  EXPECT_NEAR(page.shownBox().p.y, 0.2, 1e-9);
  page.press("buttonFirst");
  page.find<QComboBox>("comboSpeed")->setCurrentIndex(1);
  page.press("buttonPlay");
  ASSERT_TRUE(MotionPage::until([&] { return page.shownBox().p.y == 0.2; }, MotionPage::kPatience)) << "to the end";
  page.press("buttonLoop");
  page.press("buttonPlay");
  ASSERT_TRUE(MotionPage::until([&] { return page.shownBox().p.y > 0.1; }, MotionPage::kPatience));
  ASSERT_TRUE(MotionPage::until([&] { return page.shownBox().p.y < 0.05; }, MotionPage::kPatience)) << "again";
  page.press("buttonPlay");
  // The eye: off shows the cell as it stands.
  page.press("buttonShown");
  EXPECT_EQ(page.shownBox().p, before.p);
}

TEST(TrajectoryDock, SmoothSimplifyAndEditGiveCopiesThatCanBeUndone) {
  MotionPage page;
  std::vector<std::pair<double, dvec3>> shaky;
  for (int i = 0; i <= 300; ++i) {
    const double t = 0.01 * i;
    shaky.push_back({t, {0.1 * t, 0.05 * std::sin(t) + 0.0003 * std::sin(56.5 * t), 0}});
  }
  ASSERT_TRUE(page.import(shaky, "hand"));
  const std::string before = trajectory::toJsonText(page.newest());
  ASSERT_TRUE(page.pressForMotion("buttonSmoothMotion"));
  EXPECT_LT(trajectory::toJsonText(page.newest()).size(), before.size() * 2);
  EXPECT_TRUE(page.words("labelMotionResult").contains("jerk")) << page.words("labelMotionResult").toStdString();
  ASSERT_TRUE(page.pressForMotion("buttonSimplify"));
  EXPECT_LT(page.newest().size(), 60u);
  ASSERT_TRUE(page.pressForMotion("buttonReverseMotion")) << page.words("labelMotionResult").toStdString();
  EXPECT_NEAR(page.newest()[0].X_WT.p.x, 0.3, 1e-3);
  ASSERT_TRUE(page.pressForMotion("buttonMirrorMotion"));
  EXPECT_NEAR(page.newest()[0].X_WT.p.x, 0.3, 1e-3);
  ASSERT_TRUE(page.pressForMotion("buttonApproach"));
  ASSERT_TRUE(page.pressForMotion("buttonRetime"));
  EXPECT_EQ(trajectory::toJsonText(*page.state().trajectories.front().motion), before) << "never altered";
  const std::size_t all = page.motions();
  page.trigger("actionUndo");
  EXPECT_EQ(page.motions(), all - 1);
}

TEST(TrajectoryDock, TrimsThePartBetweenTheBrackets) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.1, 0, 0}}, {2, {0.2, 0, 0}}, {4, {0.4, 0, 0}}}, "long"));
  page.press("buttonMarkPart");
  ASSERT_TRUE(page.bar().part().has_value());
  // The left bracket is dragged from 1 s to 2 s.
  const auto x = [&](double t) { return static_cast<int>(std::lround(page.bar().axis().x(t))); };
  QTest::mousePress(&page.bar(), Qt::LeftButton, Qt::NoModifier, QPoint(x(1.0), 20));
  QTest::mouseMove(&page.bar(), QPoint(x(1.5), 20));
  QTest::mouseMove(&page.bar(), QPoint(x(2.0), 20));
  QTest::mouseRelease(&page.bar(), Qt::LeftButton, Qt::NoModifier, QPoint(x(2.0), 20));
  MotionPage::settle();
  EXPECT_NEAR(page.bar().part()->from, 2.0, 0.05);
  ASSERT_TRUE(page.pressForMotion("buttonTrimMotion"));
  EXPECT_NEAR(page.newest().duration(), 1.0, 0.06);
}

TEST(TrajectoryDock, ACheckMarksWhereItCollides) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.3, 0, 0}}, {2, {0.5, 0, 0}}, {3, {0.5, 0.6, 0}}}, "into the wall"));
  page.press("buttonCheckMotion");
  ASSERT_TRUE(MotionPage::until([&] { return page.isIdle() && !page.rows()[0].spans.empty(); }, MotionPage::kPatience));
  const TrackRow& row = page.rows()[0];
  EXPECT_EQ(row.spans[0].mark, CheckMark::kCollision);
  // The box's front meets the wall's face at x = 0.44.
  EXPECT_NEAR(row.spans[0].t_in, 1.0 + (0.44 - 0.3) / 0.2, 0.01);
  bool marked = false;
  for (const TrackDot& dot : row.dots) marked = marked || dot.mark == CheckMark::kCollision;
  EXPECT_TRUE(marked);
  auto* findings = page.find<QListWidget>("listFindings");
  ASSERT_GE(findings->count(), 1);
  EXPECT_TRUE(findings->item(0)->text().contains("wall"));
  // A click in the list goes there.
  findings->setCurrentRow(0);
  MotionPage::settle();
  EXPECT_NEAR(page.shownBox().p.x, 0.44, 0.003);
}

TEST(TrajectoryDock, AFrameIsChosenAndWaitedAt) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.2, 0, 0}}, {2, {0.4, 0, 0}}}, "three"));
  QTest::mouseClick(&page.bar(), Qt::LeftButton, Qt::NoModifier,
                    QPoint(static_cast<int>(page.bar().axis().x(1.0)), TimeBar::kRuler + TimeBar::kRow / 2));
  MotionPage::settle();
  EXPECT_TRUE(page.words("labelFrame").contains("Frame 2 of 3")) << page.words("labelFrame").toStdString();
  page.type("fieldDwell", "1.5");
  ASSERT_TRUE(page.pressForMotion("buttonDwell"));
  EXPECT_DOUBLE_EQ(page.newest()[1].dwell, 1.5);
}

TEST(TrajectoryDock, TwoEntitiesPlayAtTheSameTime) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.2, 0, 0}}}, "first"));
  Trajectory other;
  other.entity = "wall";
  other.addFrame({0, Pose::translation({0.5, 0, 0})});
  other.addFrame({2, Pose::translation({0.5, 0, 1.0})});
  const QString path = page.folder().filePath("second.csv");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(trajectory::toCsvText(other)));
  file.close();
  page.window().findChild<MotionExport*>()->importFrom({path}, "wall");
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 2 && page.isIdle(); }, MotionPage::kPatience));
  // The circle at the left of the first row.
  QTest::mouseClick(&page.bar(), Qt::LeftButton, Qt::NoModifier, QPoint(18, TimeBar::kRuler + TimeBar::kRow / 2));
  MotionPage::settle();
  ASSERT_TRUE(page.rows()[0].played && page.rows()[1].played);
  page.scrub(0.5);
  const auto& scene = page.window().viewport().scene();
  EXPECT_NEAR(page.shownBox().p.x, 0.1, 3e-3);
  const auto* wall = page.document().findByName("wall");
  EXPECT_NEAR(scene.placement_W(*wall).p.z, 0.25, 0.01);
}

TEST(TrajectoryDock, CurvesShowTheChosenQuantity) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0, 0, 0}}, {1, {0.2, 0, 0}}, {2, {0.4, 0, 0}}}, "straight"));
  auto* chart = page.find<MotionChart>("motionChart");
  page.find<QComboBox>("comboCurveGroup")->setCurrentIndex(1);
  page.find<QComboBox>("comboCurveOrder")->setCurrentIndex(3);
  EXPECT_EQ(chart->group(), MotionChart::Group::kPlace);
  EXPECT_EQ(chart->order(), MotionChart::Order::kJerk);
  EXPECT_FALSE(chart->grab().isNull());
}

TEST(TrajectoryDock, ExportsAndReadsBack) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0.1, 0.2, 0.3}}, {1, {0.2, 0.2, 0.3}}, {2.5, {0.4, 0.1, 0.3}}}, "out"));
  auto* files = page.window().findChild<MotionExport*>();
  for (const char* format : {"csv", "json", "urscript", "val3"}) {
    const QString path = page.folder().filePath(QStringLiteral("x.") + (QString(format) == "json" ? "htraj" : format));
    std::optional<bool> done;
    const auto connection =
        QObject::connect(files, &MotionExport::finished, [&](const QString&, bool ok) { done = ok; });
    files->exportTo(path, format, {});
    ASSERT_TRUE(MotionPage::until([&] { return done.has_value(); }, MotionPage::kPatience)) << format;
    QObject::disconnect(connection);
    EXPECT_TRUE(*done) << format;
    EXPECT_TRUE(QFile::exists(path)) << format;
  }
  const auto again = trajectory::readTrajectory(page.folder().filePath("x.csv").toStdString());
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(trajectory::toCsvText(*again), trajectory::toCsvText(page.newest())) << "bit for bit";
}

TEST(TrajectoryDock, AVideoOfThePlayIsWritten) {
  if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) GTEST_SKIP() << "no ffmpeg here";
  MotionPage page;
  ASSERT_TRUE(page.import({{0.0, {0, 0, 0}}, {0.4, {0.2, 0, 0.1}}}, "short"));
  auto* video = page.window().findChild<PlayVideo*>();
  ASSERT_NE(video, nullptr);
  const QString file = page.folder().filePath("play.mkv");
  std::optional<QString> problem;
  QObject::connect(video, &PlayVideo::ended, &page.window(),
                   [&problem](const QString&, const QString& what) { problem = what; });
  const auto begun = video->start(file, {320, 180});
  ASSERT_TRUE(begun) << begun.error().message();
  EXPECT_TRUE(video->isBusy());
  ASSERT_TRUE(MotionPage::until([&] { return problem.has_value(); }, 120000));
  EXPECT_EQ(*problem, "");
  // Read back by ffmpeg itself: as many pictures as the motion is long, of that size, and the box moves in them.
  QProcess reader;
  reader.start("ffmpeg", {"-v", "error", "-i", file, "-f", "rawvideo", "-pix_fmt", "gray", "-"});
  ASSERT_TRUE(reader.waitForFinished(120000));
  const QByteArray pictures = reader.readAllStandardOutput();
  constexpr qsizetype kPicture = 320 * 180;
  EXPECT_EQ(pictures.size(), 11 * kPicture) << reader.readAllStandardError().toStdString();
  ASSERT_GE(pictures.size(), 2 * kPicture);
  EXPECT_NE(pictures.first(kPicture), pictures.last(kPicture));
  EXPECT_FALSE(page.shownBox().p.x > 0.3) << "the window's own scene goes on";
}

TEST(TrainingDock, AMotionIsTaughtRunAndScored) {
  MotionPage page;
  std::vector<std::pair<double, dvec3>> way;
  for (int i = 0; i <= 50; ++i) way.push_back({0.04 * i, {0.004 * i, 0, 0}});
  ASSERT_TRUE(page.import(way, "lesson"));
  page.trigger("actionTraining");
  auto* panel = page.window().findChild<TrainingPanel*>();
  ASSERT_NE(panel, nullptr);
  panel->setResults(page.folder().filePath("ana.htrain"));
  EXPECT_FALSE(page.find<QAbstractButton>("buttonStartRun")->isEnabled());
  page.press("buttonTeachMotion");
  EXPECT_TRUE(page.find<QAbstractButton>("buttonStartRun")->isEnabled());
  page.press("buttonStartRun");
  ASSERT_TRUE(panel->isRunning());
  ASSERT_TRUE(page.window().recording().guide().has_value()) << "the guide is handed to who moves";
  EXPECT_EQ(page.window().recording().guide()->entity, "box");
  EXPECT_GT(page.window().recording().guide()->help, 0.0);
  for (int i = 0; i <= 50 && panel->isRunning(); ++i) {
    page.window().documentModel().execute(workcell::SetPlacement{page.box(), Pose::translation({0.004 * i, 0.001, 0})});
    QTest::qWait(40);
  }
  ASSERT_TRUE(MotionPage::until([&] { return !panel->isRunning(); }, MotionPage::kPatience)) << "the end ends the run";
  ASSERT_EQ(panel->session().attempts.size(), 1u);
  const auto& attempt = panel->session().attempts.front();
  EXPECT_EQ(attempt.score.completed, 1.0);
  EXPECT_LT(attempt.score.max_deviation, 0.005);
  EXPECT_FALSE(page.window().recording().guide().has_value());
  EXPECT_TRUE(QFile::exists(page.folder().filePath("ana.htrain")));
  if (attempt.success) {
    EXPECT_NEAR(panel->session().nextHelp(), 0.8, 1e-9);
  }
  for (const char* name : {"results.pdf", "results.csv"}) {
    const QString path = page.folder().filePath(name);
    ASSERT_TRUE(writeTrainingReport(path, panel->session(), 60.0).has_value());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().startsWith(QString(name).endsWith("pdf") ? "%PDF" : "attempt,"));
  }
  EXPECT_FALSE(writeTrainingReport("/nowhere/at/all.pdf", panel->session(), 60.0).has_value());
}

TEST(TrainingDock, AShippedExerciseOpensItsCell) {
  MotionPage page;
  page.window().documentModel().clear();
  auto* panel = page.window().findChild<TrainingPanel*>();
  const auto folder = config::findShippedFile("exercises");
  ASSERT_TRUE(folder.has_value());
  ASSERT_TRUE(panel->openExercise(QString::fromStdString(*folder) + "/door.hexercise"));
  ASSERT_TRUE(MotionPage::until([&] { return page.document().findByName("door") != nullptr; }, MotionPage::kPatience));
  EXPECT_TRUE(page.words("labelExercise").contains("handle"));
  EXPECT_FALSE(panel->openExercise("/nowhere.hexercise"));
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
