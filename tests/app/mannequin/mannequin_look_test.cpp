// SPDX-License-Identifier: Apache-2.0
// Pictures of the mannequin and its ergonomics as a user brings them onto the screen, to be looked at. A tool.
//
// HAPTICELL_LOOK_FOLDER=folder is where they go; without it nothing is done. HAPTICELL_LOOK_SIZE and
// HAPTICELL_LOOK_THEME as for the docks, HAPTICELL_LOOK_DATA=folder of recorded motions.
#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QScrollArea>
#include <numbers>

#include "app/ergonomics/time_panel.h"
#include "app/ergonomics/workplace_panel.h"
#include "app/host/selection.h"
#include "app/mannequin/marker_panel.h"
#include "app/shell/layouts.h"
#include "geometry/shapes/shapes.h"
#include "mannequin/shape/figure_model.h"
#include "tests/app/pages/mannequin_page.h"
#include "workcell/import/entity_source.h"

namespace hapticell::app {
namespace {

class Gallery : public MannequinPage {
 public:
  Gallery() {
    window().setTheme(qEnvironmentVariable("HAPTICELL_LOOK_THEME") != "light");
    const QStringList sides = qEnvironmentVariable("HAPTICELL_LOOK_SIZE", "1600x900").split('x');
    window().resize(sides[0].toInt(), sides[1].toInt());
    settle();
  }
  static bool isWanted() { return qEnvironmentVariableIsSet("HAPTICELL_LOOK_FOLDER"); }
  void bench() {
    solid("Bench", {0.7, 1.3, 0.04}, {0.75, 0.0, 0.95});
    solid("Box", {0.2, 0.3, 0.2}, {0.75, 0.25, 1.07});
    solid("Shelf", {0.35, 1.3, 0.03}, {0.95, 0.0, 1.65});
  }
  void solid(const char* name, const dvec3& size, const dvec3& p_W) {
    workcell::Entity entity;
    entity.name = name;
    entity.body = workcell::Solid{std::make_shared<geometry::TriangleMesh>(geometry::makeBox(size))};
    entity.X_WE.p = p_W;
    add(entity);
  }
  /// One at the origin that looks along +X, selected, in a posture of the library.
  void operatorIn(const char* posture) {
    ASSERT_TRUE(addMannequin());
    const workcell::Entity& it = *selected();
    auto stands = *mannequin::libraryPosture(*it.figure(), posture);
    document().executeAll("Posture", {postureCommand(it, stands)});
    settle();
  }
  /// The one of the shipped bench, in a posture of the library where it stands.
  void operatorAtTheBench(const char* posture) {
    ASSERT_TRUE(open(qEnvironmentVariable("HAPTICELL_CONFIG_DIR") + "/workcells/workbench.hcell"));
    const auto& it = *document().document().findByName("operator");
    window().selection().set(it.id);
    document().executeAll("Posture",
                          {postureCommand(it, placedHere(it, *mannequin::libraryPosture(*it.figure(), posture)))});
    settle();
  }
  void look(double azimuth, double elevation, const geometry::Bounds& at) {
    ViewportWidget& viewport = window().viewport();
    Camera camera = viewport.camera();
    camera.azimuth = azimuth * std::numbers::pi / 180.0;
    camera.elevation = elevation * std::numbers::pi / 180.0;
    viewport.setCamera(camera);
    viewport.fit(at, false);
    settle();
  }
  static geometry::Bounds about(const dvec3& p, double half) {
    geometry::Bounds bounds;
    bounds.add(p - dvec3(half));
    bounds.add(p + dvec3(half));
    return bounds;
  }
  /// Waits until all is drawn as it will be, figures in their skins, then keeps the picture.
  void keep(const char* name, bool whole_window = true) {
    setFinePictures();
    until([this] { return window().viewport().isFinished(); }, kPatience);
    QElapsedTimer rests;  // Skins begin once a figure has stood for a moment.
    rests.start();
    until([&] { return rests.elapsed() > 3000; }, 4000);
    until([this] { return window().viewport().isFinished(); }, 4 * kPatience);
    for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
      if (!dock->isVisible()) continue;
      const QRect at = dock->geometry();
      std::printf("%s: %d, %d, %d x %d\n", qPrintable(dock->objectName()), at.x(), at.y(), at.width(), at.height());
    }
    const QString file = qEnvironmentVariable("HAPTICELL_LOOK_FOLDER") + '/' + name + ".png";
    (whole_window ? window().grab().toImage() : window().viewport().finishedPicture()).save(file);
  }
};

#define WANTED() \
  if (!Gallery::isWanted()) GTEST_SKIP() << "no folder for the pictures"

TEST(Gallery, Body) {
  WANTED();
  Gallery page;
  page.operatorIn("standing");
  page.window().selection().set(0);
  const auto& figure = *page.document().document().findByName("Operator")->figure();
  const double top = figure.body[mannequin::Dimension::kStature];
  page.look(0, 4, Gallery::about({0.05, 0.0, top - 0.12}, 0.16));
  page.keep("face-front", false);
  page.look(40, 4, Gallery::about({0.05, 0.0, top - 0.12}, 0.16));
  page.keep("face-side", false);
  page.look(-30, 10, Gallery::about({0.0, -0.25, 0.80}, 0.16));
  page.keep("hand", false);
}

/// The picture of docs/dev/mannequin.md.
TEST(Gallery, Figures) {
  WANTED();
  Gallery page;
  const std::pair<const char*, const char*> figures[]{{"mannequin:female:5", "standing"},
                                                      {"mannequin:male:95", "standing"},
                                                      {"mannequin:female:50", "seated"},
                                                      {"mannequin:male:50", "overhead"},
                                                      {"mannequin:male:50", "kneeling_one"}};
  double y = -1.5;
  for (const auto& [body, posture] : figures) {
    Diagnostics diagnostics;
    workcell::Entity entity = *workcell::EntityLoader(".").load(body, 1.0, diagnostics);
    entity.name = std::string(body) + posture;
    const auto stands = mannequin::toModel(*entity.figure(), *mannequin::libraryPosture(*entity.figure(), posture));
    entity.X_WE = Pose::translation({0.0, y, 0.0}) * stands.X_WE;
    entity.setJoints(stands.joints);
    page.add(entity);
    y += 0.75;
  }
  page.window().selection().set(0);
  page.look(50, 8, page.window().viewport().scene().bounds_W());
  page.keep("figures", false);
}

TEST(Gallery, ExtremePostures) {
  WANTED();
  for (const char* posture : {"overhead", "squatting", "kneeling_one", "t_pose"}) {
    Gallery page;
    page.operatorIn(posture);
    page.window().selection().set(0);
    page.look(25, 8, page.window().viewport().scene().bounds_W());
    page.keep(posture, false);
  }
}

TEST(Gallery, Volumes) {
  WANTED();
  Gallery page;
  page.bench();
  page.operatorIn("both_hands_forward");
  page.bringDock("actionMannequinPanel");
  page.window().findChild<QScrollArea*>();
  const char* const names[]{"reach-arms", "reach-trunk", "zones", "sight", "balance", "reach-sizes"};
  for (int i = 0; i < 6; ++i) {
    const QString name = QStringLiteral("draw%1").arg(i);
    page.find<QCheckBox>(name)->click();
    page.look(35, 20, Gallery::about({0.35, 0.0, 0.95}, 0.95));
    page.keep(names[i]);
    page.find<QCheckBox>(name)->click();
  }
  page.find<QPushButton>("buttonEyes")->click();
  page.keep("eyes");
}

TEST(Gallery, Ergonomics) {
  WANTED();
  Gallery page;
  page.operatorAtTheBench("reaching");
  page.window().layouts().choose("ergonomics");
  page.settle();
  page.look(-35, 12, Gallery::about({0.1, -0.3, 0.95}, 0.85));
  page.trigger("actionWorkTask");
  page.find<QComboBox>("comboTaskPreset")->setCurrentIndex(3);
  emit page.find<QComboBox>("comboTaskPreset")->activated(3);
  page.settle();
  page.trigger("actionErgonomics");
  const QString data = qEnvironmentVariable("HAPTICELL_LOOK_DATA");
  if (!data.isEmpty()) {
    page.window().findChild<TimePanel*>()->open(data + "/02_06.bvh");
    page.until([&] { return page.find<QPushButton>("buttonWorstFrame")->isEnabled(); }, 3 * Gallery::kPatience);
  }
  page.keep("ergonomics");
  page.segment("segmentsMethod", 4);
  page.keep("ergonomics-load");
  page.segment("segmentsMethod", 0);
  page.find<QCheckBox>("checkAllBodies")->click();
  page.keep("ghosts");
}

TEST(Gallery, Workplace) {
  WANTED();
  Gallery page;
  page.operatorAtTheBench("both_hands_forward");
  page.trigger("actionErgonomics");
  page.trigger("actionWorkplace");
  auto* station = page.find<QListWidget>("listStation");
  for (int i = 0; i < station->count(); ++i) station->item(i)->setCheckState(Qt::Checked);
  page.type("fieldRise", "120");
  page.type("fieldAway", "120");
  page.click("buttonStartSearch");
  auto* panel = page.window().findChild<WorkplacePanel*>();
  page.until([&] { return !panel->isBusy() || page.words("labelSearch").contains("1"); }, 2000);
  page.window().grab().save(qEnvironmentVariable("HAPTICELL_LOOK_FOLDER") + "/workplace-runs.png");
  page.until([&] { return panel->map().has_value(); }, 10 * Gallery::kPatience);
  page.look(-35, 12, Gallery::about({0.1, -0.3, 0.95}, 0.85));
  page.keep("workplace");
}

TEST(Gallery, Markers) {
  WANTED();
  const QString data = qEnvironmentVariable("HAPTICELL_LOOK_DATA");
  if (data.isEmpty()) GTEST_SKIP() << "no recorded markers";
  Gallery page;
  page.bringDock("actionMarkers");
  auto* panel = page.window().findChild<MarkerPanel*>();
  panel->open(data + "/cmu_02_05.c3d");
  page.until([&] { return !page.window().viewport().scene().items({}).empty(); }, Gallery::kPatience);
  page.window().viewport().fitAll(false);
  page.keep("markers");
}

}  // namespace
}  // namespace hapticell::app
