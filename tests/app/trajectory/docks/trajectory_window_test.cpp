// SPDX-License-Identifier: Apache-2.0
// The trajectory docks in the whole window under a virtual display, by real clicks and keys.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QListWidget>
#include <QStandardPaths>

#include "app/ergonomics/sub_score_table.h"
#include "app/host/recording_hub.h"
#include "app/controls/strip_chart.h"
#include "app/style/proxy_style.h"
#include "app/trajectory/docks/motion_chart.h"
#include "tests/app/pages/motion_page.h"

namespace hapticell::app {
namespace {

using trajectory::Trajectory;

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

TEST(TrajectoryDock, SweptVolumeShowsThePlacesAllAlongTheMotion) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0.0, {0, 0, 0}}, {2.0, {0.3, 0, 0.1}}}, "sweep"));
  const auto ghosts = [&page] {
    std::vector<dvec3> places;
    for (const RenderItem& item : page.window().viewport().scene().items({}))
      if (item.ghost != Ghost::kNone) places.push_back(item.X_WM.p);
    return places;
  };
  // What is drawn is asked for until it is so: nothing is said about when.
  const auto swept = [&] {
    const auto places = ghosts();
    const auto reaches = [&places](double x) {
      return std::any_of(places.begin(), places.end(), [x](const dvec3& p) { return std::abs(p.x - x) < 0.03; });
    };
    return reaches(0.05) && reaches(0.15) && reaches(0.25) && reaches(0.3);
  };
  EXPECT_FALSE(swept());
  page.press("buttonSwept");
  EXPECT_TRUE(MotionPage::until(swept, MotionPage::kPatience));
  for (const dvec3& p : ghosts()) EXPECT_NEAR(p.z, p.x / 3.0, 1e-3) << "on the way";
  page.press("buttonSwept");
  EXPECT_TRUE(MotionPage::until([&] { return !swept(); }, MotionPage::kPatience));
}

/// A figure and a box recorded together: one clock, and what scores the figure follows the play.
TEST(TrajectoryDock, SeveralEntitiesAreRecordedOnOneClockAndPlayedWithLiveScores) {
  MotionPage page;
  page.trigger("actionAddMannequin");
  const auto figure = [&page]() -> const workcell::Entity* {
    for (const auto& entity : page.state().entities)
      if (entity->kind() == workcell::EntityKind::kMannequin) return entity.get();
    return nullptr;
  };
  ASSERT_TRUE(MotionPage::until([&] { return figure() != nullptr; }, MotionPage::kPatience));
  page.trigger("actionErgonomics");
  auto* scores = page.find<SubScoreTable>("subScores");
  ASSERT_TRUE(MotionPage::until([&] { return !scores->rows().empty(); }, MotionPage::kPatience));
  const auto score = [scores] {
    QStringList words;
    for (const auto& row : scores->rows()) words << row.name << row.number;
    return words.join(' ');
  };
  std::vector<double> joints = figure()->joints();
  const auto joint = [&](const std::string& name) {
    const auto& robot = *figure()->robot();
    for (std::size_t i = 0; i < robot.moving.size(); ++i)
      if (robot.joints[static_cast<std::size_t>(robot.moving[i])].name == name) return i;
    return robot.moving.size();
  };
  const std::size_t shoulder = joint("r_shoulder_flexion"), fingers = joint("r_fingers_curl");
  ASSERT_LT(std::max(shoulder, fingers), joints.size());
  page.key(Qt::Key_R);
  ASSERT_TRUE(page.window().recording().isRecording());
  const workcell::EntityId id = figure()->id;
  for (int i = 1; i <= 10; ++i) {
    joints[shoulder] = 0.2 * i;
    joints[fingers] = 0.05 * i;
    page.window().documentModel().execute(workcell::SetJoints{id, joints});
    page.window().documentModel().execute(workcell::SetPlacement{page.box(), Pose::translation({0.02 * i, 0, 0})});
    QTest::qWait(20);  // Only paces what is recorded.
  }
  page.key(Qt::Key_R);
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 2 && page.isIdle(); }, MotionPage::kPatience));
  const Trajectory &one = *page.state().trajectories[0].motion, &other = *page.state().trajectories[1].motion;
  const Trajectory& body = one.entity == "box" ? other : one;
  EXPECT_EQ(one.take, other.take);
  EXPECT_NEAR(one.frames().back().t, other.frames().back().t, 1e-9) << "one clock";
  EXPECT_EQ(body.joint_names.size(), joints.size()) << "the hands too";
  EXPECT_NEAR(body.joints(body.size() - 1)[fingers], 0.5, 1e-12);
  // Both are played; the scores are those of the time that is shown.
  ASSERT_TRUE(page.rows()[0].played && page.rows()[1].played);
  page.press("buttonLast");
  ASSERT_TRUE(
      MotionPage::until([&] { return score().contains("upper arm", Qt::CaseInsensitive); }, MotionPage::kPatience));
  const QString raised = score();
  page.press("buttonFirst");
  EXPECT_TRUE(MotionPage::until([&] { return score() != raised; }, MotionPage::kPatience));
  EXPECT_NEAR(page.shownBox().p.x, 0.0, 1e-12);
  page.press("buttonLast");
  EXPECT_TRUE(MotionPage::until([&] { return score() == raised; }, MotionPage::kPatience));
  EXPECT_NEAR(page.shownBox().p.x, 0.2, 1e-12);
}

TEST(TrajectoryDock, ForceAndGapAreDrawnWhileRecording) {
  MotionPage page;
  auto* live = page.find<StripChart>("recordedStrip");
  auto* chart = page.find<MotionChart>("motionChart");
  EXPECT_FALSE(live->isVisible());
  manipulation::SceneSnapshot now;
  now.stylus.connected = true;
  now.pairs.resize(1);
  now.time_s = 50.0;
  now.free_gap_m = 0.02;
  page.key(Qt::Key_R);
  const auto tell = [&](double force) {
    now.time_s += 0.1;
    now.stylus.force_n = force;
    page.window().setSnapshot(now);
    const auto& samples = live->history().samples();
    return MotionPage::until([&] { return !samples.empty() && samples.back().force_n == force; },
                             MotionPage::kPatience);
  };
  EXPECT_TRUE(tell(1.5));
  EXPECT_TRUE(tell(0.25));
  EXPECT_TRUE(live->isVisible());
  EXPECT_FALSE(chart->isVisible()) << "in its place";
  EXPECT_EQ(live->history().samples().back().gap_m, 0.02);
  EXPECT_FALSE(live->grab().isNull());
  page.key(Qt::Key_R);
  EXPECT_TRUE(MotionPage::until([&] { return chart->isVisible() && !live->isVisible(); }, MotionPage::kPatience));
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
  // 0.2 m/s of the 0.5 m/s that a solid is taken to have.
  page.find<QComboBox>("comboCurveOrder")->setCurrentIndex(1);
  EXPECT_NEAR(chart->limitUse(), 0.4, 0.02);
  // All four one below the other: the dock grows for them.
  auto* dock = page.find<QDockWidget>("dockTrajectory");
  const int low = dock->height();
  page.find<QComboBox>("comboCurveOrder")->setCurrentIndex(4);
  EXPECT_TRUE(MotionPage::until([&] { return dock->height() > low; }, MotionPage::kPatience));
  EXPECT_GE(chart->limitUse(), 0.4 - 0.02);
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
