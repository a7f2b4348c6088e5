// SPDX-License-Identifier: Apache-2.0
// Pictures of CAD files and cells that are not shipped: HAPTICELL_PICTURE_DATA names the folder that has them.
#include <QFileInfo>
#include <QTemporaryDir>

#include "app/import/export_work.h"
#include "tests/app/docs_pictures/picture_page.h"

namespace hapticell::app {
namespace {

/// A file below the folder of data; empty if it is not there.
QString dataFile(const char* name) {
  const QString folder = qEnvironmentVariable("HAPTICELL_PICTURE_DATA");
  const QString file = folder + '/' + QLatin1String(name);
  return !folder.isEmpty() && QFileInfo::exists(file) ? file : QString();
}

#define HAPTICELL_DATA_OR_SKIP(file, name)                                                                      \
  const QString file = dataFile(name);                                                                          \
  if (file.isEmpty()) GTEST_SKIP() << name << " is not in the folder that HAPTICELL_PICTURE_DATA names"

constexpr const char* kAssembly = "step/as1-oc-214.stp";

void lookAtAll(PicturePage& page) {
  page.lookFrom(34, 26, page.window().viewport().scene().bounds_W());
}

void importDock(const PictureTask& task) {
  HAPTICELL_DATA_OR_SKIP(file, kAssembly);
  PicturePage page(PictureTask{task.name, {1200, 800}, task.dock, task.file, {}}, Stylus::kNone);
  page.window().importFiles({file});
  const auto isRead = [&] { return page.find<QAbstractButton>("importAccept")->isEnabled(); };
  ASSERT_TRUE(PicturePage::until(isRead, PicturePage::kPatience));
  page.keepDock(task.size);
}

void importTree(const PictureTask& task) {
  HAPTICELL_DATA_OR_SKIP(file, kAssembly);
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.add(file));
  page.select(page.state().entities.front()->id);
  lookAtAll(page);
  page.showDock("dockCollisions");
  page.keep();
}

/// The assembly, saved as OBJ and imported again.
void importObj(const PictureTask& task) {
  HAPTICELL_DATA_OR_SKIP(file, kAssembly);
  QTemporaryDir folder;
  PicturePage page(task, Stylus::kSimulated);
  const QString obj = folder.filePath("as1.obj");
  ASSERT_TRUE(page.add(file));
  page.window().files().exports().exportTo(obj, false);
  ASSERT_TRUE(PicturePage::until([&] { return !page.window().files().isBusy() && QFileInfo(obj).size() > 0; },
                                 PicturePage::kPatience));
  page.window().documentModel().clear();
  ASSERT_TRUE(page.add(obj));
  page.select(page.state().entities.front()->id);
  lookAtAll(page);
  page.showDock("dockCollisions");
  page.keep();
}

void ariac(const PictureTask& task) {
  HAPTICELL_DATA_OR_SKIP(file, "workcell_ariac/worlds/ariac.world");
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.add(file));
  page.look({4.6, -10.4, 6.6}, {-1.2, -0.6, 0.4});
  page.showDock("dockCollisions");
  page.keep();
}

void snp(const PictureTask& task) {
  HAPTICELL_DATA_OR_SKIP(file, "workcell_snp/snp.hcell");
  PicturePage page(task, Stylus::kSimulated);
  ASSERT_TRUE(page.open(file));
  page.lookFrom(34, 26, page.window().viewport().scene().bounds_W());
  page.showDock("dockCollisions");
  page.keep();
}

}  // namespace

std::vector<DocsPicture> importPictures() {
  return {{"import-dialog", {348, 503}, "dockImport", importDock},
          {"import-tree", {1200, 675}, "dockVirtualDesktop", importTree, {1600, 900}},
          {"import-obj", {1200, 675}, "dockVirtualDesktop", importObj, {1600, 900}},
          {"ariac", {1600, 900}, "dockVirtualDesktop", ariac},
          {"snp", {1600, 900}, "dockVirtualDesktop", snp}};
}

}  // namespace hapticell::app
