// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTemporaryDir>
#include <QThreadPool>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/kit/dock_front.h"
#include "app/shell/module_loader.h"
#include "config/configuration.h"
#include "tests/app/docs_pictures/led_hand.h"
#include "tests/app/docs_pictures/picture_file.h"
#include "tests/app/docs_pictures/picture_table.h"
#include "tests/app/pages/cell_page.h"
#include "tests/app/pages/server_first.h"

namespace hapticell::app {

enum class Stylus { kNone, kSimulated };

/// The window as a picture of the documents shows it: as it is shipped, in the size of the picture. With a simulated
/// stylus, Virtual Desktop is connected to a haptic server of the page's own.
class PicturePage : public ServerFirst, public CellPage {
 public:
  static constexpr int kRough = 0, kMedium = 1;  // Scales, as the dock has them.
  static constexpr int kPatience = 60000;        // ms: a slow machine that draws by its processor.

  PicturePage(const PictureTask& task, Stylus stylus) : CellPage(on(withoutMotion())), hand(server.loop), task_(task) {
    setFinePictures();
    window().setTheme(!task.name.contains("light"));
    window().resize(task.window.isEmpty() ? task.size : task.window);
    window().loadModules(ModuleLoader::defaultFolders());
    if (stylus == Stylus::kSimulated) {
      EXPECT_TRUE(window().startModule("Virtual Desktop"));
    }
    window().restoreLayout();
    settle();
    if (stylus == Stylus::kNone) return;
    EXPECT_TRUE(until([this] { return window().snapshot() && now().stylus.connected; }, kPatience)) << "no stylus";
    hand.put(dvec3(0.0));
  }
  const manipulation::SceneSnapshot& now() { return *window().snapshot(); }
  bool openShipped(const char* name) {
    const auto shipped = config::findShippedFile(name);
    if (!shipped) return false;
    // A copy, with the robots beside it: the window writes recordings to the folder of the cell.
    namespace fs = std::filesystem;
    const fs::path from(*shipped), all = from.parent_path().parent_path(), to(copies_.path().toStdString());
    fs::copy(all, to, fs::copy_options::recursive | fs::copy_options::skip_existing);
    if (!open(QString::fromStdString((to / from.lexically_relative(all)).string()))) return false;
    return until([this] { return !window().files().isBusy() && entities() > 0; }, kPatience);
  }
  static haptic::HandPath shippedHand(const char* name) {
    const auto file = config::findShippedFile(name);
    auto path = haptic::readHandPath(file ? *file : std::string(name));
    EXPECT_TRUE(path.has_value()) << name;
    return path ? *path : haptic::HandPath({haptic::HandSample{}});
  }
  void look(const dvec3& p_WEye, const dvec3& p_WTarget) {
    window().viewport().setCamera(window().viewport().camera().looking(p_WEye, p_WTarget), false);
    settle();
  }
  /// From these angles (degrees), as near as a box about a point allows.
  void lookFrom(double azimuth, double elevation, const geometry::Bounds& bounds_W) {
    Camera camera = window().viewport().camera();
    camera.azimuth = azimuth * kDegree;
    camera.elevation = elevation * kDegree;
    window().viewport().setCamera(camera, false);
    window().viewport().fit(bounds_W, false);
    settle();
  }
  static geometry::Bounds about(const dvec3& p_W, double half) {
    geometry::Bounds bounds;
    bounds.add(p_W - dvec3(half));
    bounds.add(p_W + dvec3(half));
    return bounds;
  }
  /// As the user chooses an entry of a list.
  void chooseEntry(const char* name, int index) {
    auto* list = find<QComboBox>(name);
    if (!list || index < 0) return;
    list->setCurrentIndex(index);
    emit list->activated(index);
    settle();
  }
  void chooseEntry(const char* name, const QString& text) { chooseEntry(name, find<QComboBox>(name)->findText(text)); }
  /// What the hand will hold, in the axes of the cell so that its way does not depend on the view, with forces on.
  void prepareHand(const char* entity, int scale) {
    const workcell::Entity* held = document().findByName(entity);
    ASSERT_NE(held, nullptr) << entity;
    select(held->id);
    chooseEntry("comboEntity", QString::fromLatin1(entity));
    chooseSegment("segmentsAxes", 1);
    chooseSegment("segmentsScale", scale);
    trigger("actionForcesOn");
    ASSERT_TRUE(until([this] { return now().stylus.forces_on; }, kPatience)) << "forces do not come";
  }
  /// The hand at `p_DH` presses the stylus's button: it holds the chosen entity.
  void take(const dvec3& p_DH) {
    hand.put(p_DH);
    rest(700);
    hand.put(p_DH, true);
    ASSERT_TRUE(until([this] { return now().stylus.held != 0; }, kPatience)) << "nothing is held";
    hand.put(p_DH);
    rest(300);
  }
  /// The hand goes in this direction (device frame, unit), a little at a time, until `there`, or so far; whether it is.
  template <class There>
  bool leadUntil(dvec3& p_DH, const dvec3& direction_D, double most, There&& there) {
    constexpr double kStep = 0.001;  // m
    for (double way = 0.0; way < most && !there(); way += kStep) {
      p_DH += kStep * direction_D;
      hand.put(p_DH);
      rest(40);
    }
    return until(there, 2000);
  }
  bool followHand(const haptic::HandPath& path, double end_s) {
    hand.follow(path, end_s);
    return until([this] { return !hand.isFollowing(); }, static_cast<int>(1000.0 * end_s) + kPatience);
  }
  static void rest(int ms) {
    until([] { return false; }, ms);
  }
  /// Waits until nothing is read or computed beside the window and the scene is drawn, then keeps the whole window.
  void keep() {
    finish();
    expectScene();
    const QImage whole = window().picture().toImage();
    EXPECT_TRUE(task_.window.isEmpty() || whole.size() == task_.window) << "the window has another size";
    keepImage(task_.window.isEmpty() ? whole
                                     : whole.scaled(task_.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }
  /// Only the scene.
  void keepScene() {
    finish();
    expectScene();
    keepImage(window().viewport().finishedPicture());
  }
  /// Only the dock, in the size of the picture.
  void keepDock(const QSize& size) {
    auto* dock = find<QDockWidget>(task_.dock);
    ASSERT_NE(dock, nullptr);
    dock->setFloating(true);
    dock->show();
    dock->resize(size);
    finish();
    task_.size = size;
    keepImage(dock->grab().toImage());
  }
  LedHand hand;

 private:
  static config::Configuration withoutMotion() {
    config::Configuration configuration;
    configuration.gui.motion = false;
    return configuration;
  }
  void finish() {
    EXPECT_TRUE(until([this] { return !window().files().isBusy(); }, kPatience)) << "files are still being read";
    constexpr int kRests = 3000;  // ms: skins begin once a figure has stood for a moment.
    QElapsedTimer rests;
    rests.start();
    const auto works = [&] {
      if (QThreadPool::globalInstance()->activeThreadCount() > 0) rests.restart();
      return rests.elapsed() < kRests;
    };
    until([&] { return !works(); }, kPatience);
    until([this] { return window().viewport().missingParts() == 0; }, kPatience);
    if (task_.dock) showDock(task_.dock);  // A selection or a hold may have raised another one.
    until([this] { return window().viewport().isFinished(); }, 5000);  // Never, while something moves.
  }
  /// Something stands in the middle of the scene; beside it lie the cube and the strips.
  void expectScene() {
    constexpr double kLeast = 0.03;
    const QImage scene = window().viewport().finishedPicture();
    const int fifth = scene.width() / 5, high = scene.height() / 5;
    EXPECT_GT(drawnShare(scene.copy(fifth, high, 3 * fifth, 3 * high)), kLeast) << "the scene is empty";
  }
  void keepImage(const QImage& image) {
    if (task_.dock) {
      const auto* dock = window().findChild<QDockWidget*>(task_.dock);
      ASSERT_TRUE(dock && isInFront(*dock)) << task_.dock << " is not visible";
    }
    const QString problem = savePicture(image, task_.size, task_.file);
    EXPECT_TRUE(problem.isEmpty()) << problem.toStdString();
  }
  PictureTask task_;
  QTemporaryDir copies_;  ///< Of shipped cells.
};

}  // namespace hapticell::app
