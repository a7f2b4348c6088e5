// SPDX-License-Identifier: Apache-2.0
// Pictures of mannequins and of their ergonomics.
#include <QListWidget>
#include <utility>

#include "app/ergonomics/workplace_panel.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/shell/layouts.h"
#include "mannequin/shape/figure_model.h"
#include "tests/app/docs_pictures/picture_page.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

/// The person of the shipped bench, in a posture of the library where it stands.
void standAtTheBench(PicturePage& page, const char* posture) {
  ASSERT_TRUE(page.openShipped("workcells/workbench.hcell"));
  const auto& person = *page.document().findByName("operator");
  page.select(person.id);
  ASSERT_TRUE(page.window().documentModel().executeAll(
      "Posture", {postureCommand(person, placedHere(person, *mannequin::libraryPosture(*person.figure(), posture)))}));
  PicturePage::settle();
}

void lookAtTheBench(PicturePage& page) {
  page.lookFrom(-35, 12, PicturePage::about({0.1, -0.3, 0.95}, 0.85));
}

void figures(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  const std::pair<const char*, const char*> all[]{{"mannequin:female:5", "standing"},
                                                  {"mannequin:male:95", "standing"},
                                                  {"mannequin:female:50", "seated"},
                                                  {"mannequin:male:50", "overhead"},
                                                  {"mannequin:male:50", "kneeling_one"}};
  double y = -1.5;
  for (const auto& [body, posture] : all) {
    Diagnostics diagnostics;
    auto entity = workcell::EntityLoader(".").load(body, 1.0, diagnostics);
    ASSERT_TRUE(entity.has_value()) << body;
    entity->name = std::string(body) + posture;
    const auto stands = mannequin::toModel(*entity->figure(), *mannequin::libraryPosture(*entity->figure(), posture));
    entity->X_WE = Pose::translation({0.0, y, 0.0}) * stands.X_WE;
    entity->setJoints(stands.joints);
    ASSERT_TRUE(page.window().documentModel().execute(workcell::AddEntity{std::move(*entity)}));
    y += 0.75;
  }
  page.window().selection().set(0);
  for (QDockWidget* dock : page.window().findChildren<QDockWidget*>()) dock->hide();
  PicturePage::settle();
  // Again until it fits: docks give their room back when the window is laid out next.
  const auto fits = [&] {
    const QSize off = task.size - page.window().viewport().size();
    if (!off.isNull()) page.window().resize(page.window().size() + off);
    return off.isNull();
  };
  EXPECT_TRUE(PicturePage::until(fits, PicturePage::kPatience)) << "the scene does not take the size of the picture";
  page.lookFrom(50, 8, page.window().viewport().scene().bounds_W());
  page.keepScene();
}

/// The layout Ergonomics with a task, the scores of one method in front.
void scores(const PictureTask& task, int method) {
  PicturePage page(task, Stylus::kNone);
  standAtTheBench(page, "reaching");
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  page.window().layouts().choose("ergonomics");
  PicturePage::settle();
  lookAtTheBench(page);
  page.trigger("actionWorkTask");
  constexpr int kSomeTask = 3;
  page.chooseEntry("comboTaskPreset", kSomeTask);
  page.trigger("actionErgonomics");
  page.chooseSegment("segmentsMethod", method);
  page.keep();
}

void ergonomics(const PictureTask& task) {
  scores(task, 0);
}

void loads(const PictureTask& task) {
  scores(task, 4);
}

void workplace(const PictureTask& task) {
  PicturePage page(task, Stylus::kNone);
  standAtTheBench(page, "both_hands_forward");
  ASSERT_FALSE(testing::Test::HasFatalFailure());
  page.trigger("actionErgonomics");
  page.trigger("actionWorkplace");
  auto* parts = page.find<QListWidget>("listStation");
  ASSERT_NE(parts, nullptr);
  for (int i = 0; i < parts->count(); ++i) parts->item(i)->setCheckState(Qt::Checked);
  page.type("fieldRise", "120");
  page.type("fieldAway", "120");
  page.press("buttonStartSearch");
  auto* panel = page.window().findChild<WorkplacePanel*>();
  ASSERT_TRUE(PicturePage::until([&] { return panel->map().has_value(); }, 5 * PicturePage::kPatience));
  lookAtTheBench(page);
  page.keep();
}

}  // namespace

std::vector<DocsPicture> figurePictures() {
  return {{"mannequin", {958, 519}, nullptr, figures},
          {"ergonomics", {1600, 900}, "dockErgonomics", ergonomics},
          {"ergonomics-load", {1600, 900}, "dockErgonomics", loads},
          {"workplace", {1600, 900}, "dockWorkplace", workplace}};
}

}  // namespace hapticell::app
