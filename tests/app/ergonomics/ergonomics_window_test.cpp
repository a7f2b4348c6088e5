// SPDX-License-Identifier: Apache-2.0
// The docks of the ergonomics in the whole window under a virtual display: real clicks, through MannequinPage.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QThreadPool>
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/ergonomics/report_head.h"
#include "app/ergonomics/report_panel.h"
#include "app/ergonomics/sub_score_table.h"
#include "app/ergonomics/time_panel.h"
#include "app/ergonomics/workplace_panel.h"
#include "app/shell/layouts.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/dock_front.h"
#include "geometry/shapes/shapes.h"
#include "mannequin/motion/motion_clip.h"
#include "mannequin/motion/motion_writer.h"
#include "tests/app/pages/mannequin_page.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

struct ErgonomicsPage : MannequinPage {
  bool open() {
    if (!addMannequin()) return false;
    bringDock("actionErgonomics");
    return until([this] { return !rows().empty(); }, kPatience);
  }
  std::vector<SubScoreTable::Row> rows() { return find<SubScoreTable>("subScores")->rows(); }
  const ergonomics::WorkTask* task() { return document().document().state().workTaskOf("Operator"); }
};

TEST(ErgonomicsDock, APanelThatStaysShutWhileTheStylusIsUsedSaysSo) {
  ErgonomicsPage page;
  manipulation::SceneSnapshot used;
  used.stylus.forces_on = true;
  for (const char* command : {"actionWorkplace", "actionTools", "actionMannequinPanel"}) {
    page.window().setSnapshot(used);
    const std::size_t before = page.window().messages().messages().size();
    page.trigger(command);
    ASSERT_EQ(page.window().messages().messages().size(), before + 1) << command;
    EXPECT_EQ(page.window().messages().messages().back().title, "The panel was not opened");
    page.window().setSnapshot(std::nullopt);
    page.trigger(command);
    EXPECT_EQ(page.window().messages().messages().size(), before + 1) << command;
  }
}

TEST(ErgonomicsDock, APostureThatIsSavedWithoutAMannequinSaysWhatIsNeeded) {
  ErgonomicsPage page;
  for (const char* command : {"actionSavePosture", "actionOpenPosture"}) {
    page.trigger(command);
    ASSERT_FALSE(page.window().messages().messages().empty());
    EXPECT_EQ(page.window().messages().messages().back().title, "No mannequin is selected") << command;
  }
}

TEST(ErgonomicsDock, ScoresFollowThePosture) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  EXPECT_TRUE(page.words("labelPartial").contains("not entered"));
  const QString before = page.words("labelWhyTitle");
  page.bringDock("actionMannequinPanel");
  ASSERT_TRUE(page.choose("buttonPostures", "posture_overhead"));
  page.bringDock("actionErgonomics");
  EXPECT_TRUE(page.until([&] { return page.words("labelWhyTitle") != before; }, ErgonomicsPage::kPatience));
  EXPECT_TRUE(page.words("labelWhy").contains("upper arm"));
  EXPECT_TRUE(page.until(
      [&] { return page.words("labelWhy").contains("gives RULA") || page.words("labelWhy").contains("does not lower"); },
      ErgonomicsPage::kPatience));
  page.segment("segmentsMethod", 1);
  EXPECT_EQ(page.rows().size(), 9u) << "REBA";
  page.segment("segmentsMethod", 2);
  EXPECT_EQ(page.rows().size(), 4u) << "OWAS";
  page.segment("segmentsMethod", 3);
  EXPECT_EQ(page.rows().size(), 12u) << "EN 1005-4, ISO 11226, the EAWS outline and the joint comfort";
  EXPECT_TRUE(page.words("labelWhy").contains("EN 1005-4")) << page.words("labelWhy").toStdString();
  EXPECT_TRUE(page.words("labelWhy").contains("EAWS"));
  page.segment("segmentsMethod", 4);
  EXPECT_EQ(page.rows().size(), 8u) << "no lift, no loads, no own limits in the task: moments of the body itself";
  EXPECT_TRUE(page.rows().back().reason.endsWith("N m"));
}

TEST(ErgonomicsDock, TheBetterPostureIsTakenAsOneStep) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.bringDock("actionMannequinPanel");
  ASSERT_TRUE(page.choose("buttonPostures", "posture_overhead"));
  page.bringDock("actionErgonomics");
  auto* button = page.find<QPushButton>("buttonShowPosture");
  ASSERT_TRUE(page.until([&] { return button->isEnabled(); }, ErgonomicsPage::kPatience));
  EXPECT_TRUE(page.clickForStep("buttonShowPosture"));
}

TEST(ErgonomicsScene, LabelsWithAnglesAndTheStripFollowTheFigure) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  ViewportWidget& viewport = page.window().viewport();
  ASSERT_TRUE(page.until([&] { return viewport.figureStrip().size() == 5; }, ErgonomicsPage::kPatience));
  const std::string reach = viewport.figureStrip()[2].value;
  page.bringDock("actionMannequinPanel");
  ASSERT_TRUE(page.choose("buttonPostures", "posture_overhead"));
  page.bringDock("actionErgonomics");
  ASSERT_TRUE(page.until([&] { return viewport.figureStrip().size() == 5 && viewport.figureStrip()[2].value != reach; },
                         ErgonomicsPage::kPatience));
  EXPECT_EQ(viewport.figureStrip()[2].meaning, "of reach left");
  const auto labels = viewport.allLabels();
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_TRUE(labels[0].title.ends_with("shoulder")) << labels[0].title;
  EXPECT_TRUE(labels[0].number.ends_with("°"));
  EXPECT_NE(labels[0].names.find("drives RULA"), std::string::npos) << labels[0].names;
  EXPECT_GE(labels[0].band, 2);
  page.segment("segmentsMethod", 2);
  ASSERT_FALSE(viewport.allLabels().empty());
  EXPECT_NE(viewport.allLabels()[0].names.find("OWAS"), std::string::npos);
  page.window().findChild<QDockWidget*>("dockErgonomics")->hide();
  EXPECT_TRUE(page.until([&] { return viewport.allLabels().empty() && viewport.figureStrip().empty(); },
                         ErgonomicsPage::kPatience));
}

TEST(ErgonomicsScene, TheSkinOfAFigureAtRestIsInTheColoursOfItsScores) {
  ErgonomicsPage page;
  page.window().resize(1100, 640);  // The picture at rest has to be whole.
  ASSERT_TRUE(page.open());
  page.bringDock("actionMannequinPanel");
  ASSERT_TRUE(page.choose("buttonPostures", "posture_overhead"));
  page.bringDock("actionErgonomics");
  const auto hatchedSkin = [&] {
    const auto items = page.window().viewport().scene().items({});
    const auto links = std::count_if(items.begin(), items.end(), [](const auto& item) { return item.link >= 0; });
    const auto hatched =
        std::count_if(items.begin(), items.end(), [](const auto& item) { return item.smooth && item.pattern > 0; });
    return links == 0 && hatched > 0;
  };
  EXPECT_TRUE(page.until(hatchedSkin, 12 * ErgonomicsPage::kPatience));
}

TEST(ErgonomicsDock, StaysInFrontWhereTheFigureIsChosen) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  for (const char* layout : {"move", "ergonomics"}) {
    page.window().layouts().choose(layout);
    for (const char* action : {"actionErgonomics", "actionErgonomicsReport"}) {
      page.bringDock(action);
      const auto* dock = page.window().findChild<QDockWidget*>(
          std::string(action) == "actionErgonomics" ? "dockErgonomics" : "dockReport");
      ASSERT_TRUE(page.until([&] { return isInFront(*dock); }, ErgonomicsPage::kPatience)) << layout;
      const auto operator_id = page.document().document().findByName("Operator")->id;
      page.window().selection().set(0);
      page.window().selection().set(operator_id);
      page.settle();
      EXPECT_TRUE(isInFront(*dock)) << layout << ", " << action;
    }
  }
}

TEST(TaskData, IsEnteredKeptWithTheCellAndUndone) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.click("buttonTaskData");
  EXPECT_TRUE(page.isShown("dockWorkTask"));
  ASSERT_TRUE(page.typeForStep("fieldLoadRight", "2.4"));
  ASSERT_NE(page.task(), nullptr);
  EXPECT_NEAR(*page.task()->load_kg[1], 2.4, 1e-9);
  EXPECT_FALSE(page.task()->repetitions_per_min.has_value());
  ASSERT_TRUE(page.segmentForStep("segmentsStatic", 1));
  EXPECT_EQ(page.task()->is_static, false);
  ASSERT_TRUE(page.segmentForStep("segmentsGrip", 2));
  EXPECT_EQ(page.task()->grip, ergonomics::Grip::kFair);
  ASSERT_TRUE(page.typeForStep("fieldRepetitions", "5"));
  page.bringDock("actionErgonomics");
  EXPECT_TRUE(page.until([&] { return page.words("labelPartial").isEmpty(); }, ErgonomicsPage::kPatience));
  for (int i = 0; i < 4; ++i) page.trigger("actionUndo");
  EXPECT_EQ(page.task(), nullptr);
}

TEST(ErgonomicsDock, TellsTheLiftingEquationOrWhyItDoesNotApply) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  const auto says = [&page](const char* words) {
    return page.until([&] { return page.words("labelLift").contains(words); }, ErgonomicsPage::kPatience);
  };
  EXPECT_TRUE(page.find<QLabel>("labelLift")->isVisible());
  EXPECT_TRUE(says("nothing is lifted")) << page.words("labelLift").toStdString();
  auto task = ergonomics::workTaskPresets()[5];
  task.mannequin = "Operator";
  task.is_lift = false;
  page.document().execute(workcell::SetWorkTask{task, {}});
  EXPECT_TRUE(says("the load is held")) << page.words("labelLift").toStdString();
  task.is_lift = true;
  page.document().execute(workcell::SetWorkTask{task, task.name});
  EXPECT_TRUE(says("NIOSH: lifting index")) << page.words("labelLift").toStdString();
  task.load_kg[0] = 0.0;
  page.document().execute(workcell::SetWorkTask{task, task.name});
  EXPECT_TRUE(says("only one hand")) << page.words("labelLift").toStdString();
  task.load_kg[0] = task.load_kg[1];
  task.grip.reset();
  page.document().execute(workcell::SetWorkTask{task, task.name});
  EXPECT_TRUE(says("enter the grip")) << page.words("labelLift").toStdString();
}

TEST(TaskData, PresetsFillEverything) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.click("buttonTaskData");
  auto* presets = page.find<QComboBox>("comboTaskPreset");
  presets->setFocus();
  QTest::keyClick(presets, Qt::Key_End);
  QTest::keyClick(presets, Qt::Key_Return);
  page.settle();
  ASSERT_NE(page.task(), nullptr);
  EXPECT_TRUE(page.task()->is_lift);
  EXPECT_EQ(page.task()->mannequin, "Operator");
}

TEST(ReportDock, ShowsThePageAndWritesFiles) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.click("buttonReport");
  auto* shown = page.find<QLabel>("labelReportPage");
  EXPECT_TRUE(page.until([&] { return !shown->pixmap(Qt::ReturnByValue).isNull(); }, ErgonomicsPage::kPatience));
  auto* panel = page.window().findChild<ReportPanel*>();
  ASSERT_NE(panel, nullptr);
  const hapticell::test::TemporaryFolder place;
  const std::filesystem::path& folder = place.path();
  for (const char* name : {"report.pdf", "report.html", "report.csv", "report.json"}) {
    EXPECT_TRUE(panel->write(QString::fromStdString((folder / name).string())));
    EXPECT_GT(std::filesystem::file_size(folder / name), 1000u) << name;
  }
  EXPECT_FALSE(panel->write("/nowhere/report.pdf"));
  page.segment("segmentsReport", 1);
  EXPECT_EQ(panel->report().title, "Task assessment");
}

TEST(ReportDock, IsAsLargeAsWanted) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.click("buttonReport");
  auto* shown = page.find<QLabel>("labelReportPage");
  const auto width = [shown] { return shown->pixmap(Qt::ReturnByValue).deviceIndependentSize().width(); };
  ASSERT_TRUE(page.until([&] { return width() > 0; }, ErgonomicsPage::kPatience));
  const double narrow = width();
  auto* zoom = page.find<QComboBox>("comboReportZoom");
  zoom->setFocus();
  QTest::keyClick(zoom, Qt::Key_End);
  EXPECT_TRUE(page.until([&] { return width() > 2300.0; }, ErgonomicsPage::kPatience)) << width();
  QTest::keyClick(zoom, Qt::Key_Home);
  EXPECT_TRUE(page.until([&] { return std::abs(width() - narrow) < 30.0; }, ErgonomicsPage::kPatience)) << width();
}

TEST(ReportDock, KeepsTheCompanysNameAndLogoWithTheUsersSettings) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.click("buttonReport");
  auto* panel = page.window().findChild<ReportPanel*>();
  auto* head = page.window().findChild<ReportHead*>();
  ASSERT_NE(head, nullptr);
  auto* name = page.find<QLineEdit>("editCompany");
  name->setFocus();
  QTest::keyClicks(name, "Ada Works");
  EXPECT_EQ(panel->report().company, "Ada Works");
  const hapticell::test::TemporaryFolder place;
  const std::filesystem::path& folder = place.path();
  std::ofstream(folder / "none.png") << "no picture";
  EXPECT_FALSE(head->takeLogo(QString::fromStdString((folder / "none.png").string())));
  EXPECT_TRUE(panel->report().logo.isEmpty());
  const QString logo = QString::fromStdString((folder / "logo.png").string());
  QImage red(2000, 500, QImage::Format_RGB32);
  red.fill(Qt::red);
  ASSERT_TRUE(red.save(logo));
  EXPECT_TRUE(head->takeLogo(logo));
  std::filesystem::remove(folder / "logo.png");
  EXPECT_EQ(panel->report().logo.width, 768);
  ReportHead next(page.window());  // As at the next start: the picture's file is gone, the logo is not.
  EXPECT_EQ(next.company(), "Ada Works");
  ASSERT_EQ(next.logo().width, 768);
  EXPECT_EQ(next.logo().pixels.front(), 0xFFFF0000u);
  head->dropLogo();
  EXPECT_TRUE(panel->report().logo.isEmpty());
}

TEST(TimeDock, ScoresAMotionAndTakesAFrame) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.bringDock("actionErgonomicsTime");
  const auto figure = *mannequin::makeFigure({});
  std::vector<mannequin::Posture> postures;
  const auto from = *mannequin::libraryPosture(figure, "standing"), to = *mannequin::libraryPosture(figure, "stooping");
  for (int i = 0; i <= 20; ++i) postures.push_back(mannequin::interpolate(from, to, i / 20.0));
  const auto file = std::filesystem::temp_directory_path() / "hapticell_stoop.bvh";
  std::ofstream(file) << mannequin::bvhText(figure, postures, 0.1);
  auto* panel = page.window().findChild<TimePanel*>();
  panel->open(QString::fromStdString(file.string()));
  page.until([&] { return page.find<QPushButton>("buttonWorstFrame")->isEnabled(); }, ErgonomicsPage::kPatience);
  if (page.find<QPushButton>("buttonWorstFrame")->isEnabled()) {
    EXPECT_GT(panel->frame(), 0) << "the worst phase is shown at once";
    panel->setFrame(0);
    page.click("buttonWorstFrame");
    EXPECT_GT(panel->frame(), 0);
    EXPECT_TRUE(page.words("labelScoredFrame").contains("worst phase")) << page.words("labelScoredFrame").toStdString();
    auto* report = page.window().findChild<ReportPanel*>();
    const std::string standing = ergonomics::reportCsv(report->report());
    EXPECT_NE(standing.find("As it stands in the cell"), std::string::npos);
    EXPECT_NE(standing.find("Worst phase: "), std::string::npos);
    page.bringDock("actionErgonomicsReport");
    page.segment("segmentsReport", 1);
    const auto of_task = report->report();
    EXPECT_NE(ergonomics::reportCsv(of_task).find("hapticell_stoop, Worst phase: "), std::string::npos);
    EXPECT_FALSE(of_task.picture.empty());
    EXPECT_GT(std::stoi(of_task.result), 3) << "the stoop's, not that of frame 0";
    page.bringDock("actionErgonomicsTime");
    page.click("buttonWorstFrame");
    EXPECT_TRUE(page.clickForStep("buttonTakeFrame"));
  }
  std::filesystem::remove(file);
}

TEST(TimeDock, SaysWhatIsBeyondALimitAndSavesTheMotionAsItIsOnTheFigure) {
  ErgonomicsPage page;
  ASSERT_TRUE(page.open());
  page.bringDock("actionErgonomicsTime");
  const auto figure = *mannequin::makeFigure({});
  auto posture = *mannequin::libraryPosture(figure, "standing");
  posture[mannequin::Dof::kLeftElbowFlexion] = 0.2;
  auto beyond = posture;
  beyond[mannequin::Dof::kLeftWristFlexion] = 2.0;
  const auto folder = std::filesystem::temp_directory_path() / "hapticell_motion_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "in.bvh") << mannequin::bvhText(figure, std::vector{posture, beyond, beyond}, 0.1);
  auto* panel = page.window().findChild<TimePanel*>();
  panel->open(QString::fromStdString((folder / "in.bvh").string()));
  ASSERT_TRUE(
      page.until([&] { return page.find<QPushButton>("buttonSaveMotion")->isEnabled(); }, ErgonomicsPage::kPatience));
  EXPECT_TRUE(page.words("labelBeyondLimits").contains("left wrist flexion in 2 frames"))
      << page.words("labelBeyondLimits").toStdString();
  const auto out = folder / "out.bvh";
  ASSERT_TRUE(panel->saveMotion(QString::fromStdString(out.string())));
  const auto clip = mannequin::readMotionFile(out);
  ASSERT_TRUE(clip);
  EXPECT_EQ(clip->frames.size(), 3u);
  EXPECT_NEAR(clip->frame_time, 0.1, 1e-6);
  EXPECT_FALSE(panel->saveMotion("/nowhere/out.bvh"));
  std::filesystem::remove_all(folder);
}

TEST(WorkplaceDock, SearchesShowsItsMapAndMovesTheTable) {
  ErgonomicsPage page;
  workcell::Entity table;
  table.name = "Bench";
  table.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.6, 0.4, 0.04}))};
  table.X_WE.p = {0.0, 1.2, 0.7};
  const auto bench = page.add(table);
  table.name = "Shelf";
  table.X_WE.p = {0.0, 2.2, 0.7};
  const auto shelf = page.add(table);
  ASSERT_TRUE(page.open());
  page.bringDock("actionMannequinPanel");
  ASSERT_TRUE(page.choose("buttonPostures", "posture_both_hands_forward"));
  page.click("buttonSearchWorkplace");
  page.bringDock("actionWorkplace");
  auto* list = page.find<QListWidget>("listStation");
  ASSERT_EQ(list->count(), 2) << "parts of the cell, not the mannequin";
  EXPECT_FALSE(page.find<QPushButton>("buttonStartSearch")->isEnabled()) << "nothing is ticked";
  list->item(0)->setCheckState(Qt::Checked);
  EXPECT_TRUE(page.words("labelMoves").contains("everything else stays")) << page.words("labelMoves").toStdString();
  page.type("fieldRise", "100");
  page.type("fieldAway", "100");
  page.type("fieldStep", "100");
  page.click("buttonStartSearch");
  auto* panel = page.window().findChild<WorkplacePanel*>();
  ASSERT_TRUE(page.until([&] { return panel->map().has_value(); }, 15 * ErgonomicsPage::kPatience));
  EXPECT_EQ(panel->map()->cells.size(), 9u);
  EXPECT_TRUE(page.words("labelSearch").contains("Moved: Bench.")) << page.words("labelSearch").toStdString();
  page.bringDock("actionErgonomicsReport");
  page.segment("segmentsReport", 1);
  const std::string told = ergonomics::reportCsv(page.window().findChild<ReportPanel*>()->report());
  EXPECT_NE(told.find("Moved, and nothing else: Bench"), std::string::npos) << told;
  page.bringDock("actionWorkplace");
  const dvec3 shelf_before = page.document().document().find(shelf)->X_WE.p;
  if (panel->map()->best >= 0) {
    const dvec3 before = page.document().document().find(bench)->X_WE.p;
    ASSERT_TRUE(page.clickForStep("buttonTakePlace"));
    const auto& best = panel->map()->cells[static_cast<std::size_t>(panel->map()->best)];
    EXPECT_NEAR(page.document().document().find(bench)->X_WE.p.z - before.z, best.rise, 1e-9);
    EXPECT_EQ(page.document().document().find(shelf)->X_WE.p, shelf_before);
    const auto warned = [&] {
      const auto& all = page.window().messages().messages();
      return std::count_if(all.begin(), all.end(), [](const Message& message) {
        return message.title == "This placement does not give the score that was found";
      });
    };
    QThreadPool::globalInstance()->waitForDone();
    page.settle();
    EXPECT_EQ(warned(), 0) << "the cell is as it was searched";
    // In the meantime somebody puts the shelf where the people are to stand.
    page.trigger("actionUndo");
    const dvec3 stands = best.postures[0].X_WR.p;
    ASSERT_TRUE(page.document().execute(workcell::SetPlacement{shelf, Pose::translation({stands.x, stands.y, 1.0})}));
    ASSERT_TRUE(page.clickForStep("buttonTakePlace"));
    EXPECT_TRUE(page.until([&] { return warned() == 1; }, ErgonomicsPage::kPatience));
  }
}

TEST(WorkplaceDock, IsSavedAsAStudyOnlyWithAStationAndASavedCell) {
  ErgonomicsPage page;
  workcell::Entity table;
  table.name = "Bench";
  table.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox({0.6, 0.4, 0.04}))};
  table.X_WE.p = {0.0, 1.2, 0.7};
  page.add(table);
  ASSERT_TRUE(page.open());
  page.bringDock("actionWorkplace");
  auto* save = page.find<QPushButton>("buttonSaveWorkplaceStudy");
  EXPECT_FALSE(save->isEnabled()) << "nothing is ticked";
  page.find<QListWidget>("listStation")->item(0)->setCheckState(Qt::Checked);
  EXPECT_TRUE(save->isEnabled());
  page.click("buttonSaveWorkplaceStudy");
  EXPECT_TRUE(page.words("labelSearch").contains("Save the workcell first")) << page.words("labelSearch").toStdString();
  page.find<QListWidget>("listStation")->item(0)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(save->isEnabled());
}

}  // namespace
}  // namespace hapticell::app
