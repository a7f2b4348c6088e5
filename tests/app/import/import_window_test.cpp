// SPDX-License-Identifier: Apache-2.0
// Importing, opening and reading again through the whole window: nothing is read in its thread.
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QTest>
#include <QTreeWidget>
#include <QUrl>

#include <iostream>

#include "app/kit/dock_front.h"
#include "app/panels/tree/tree_edits.h"
#include "geometry/shapes/shapes.h"
#include "tests/app/pages/import_page.h"
#include "tests/support/test_data.h"

namespace hapticell::app {
namespace {

/// An importer that never ends, for as long as this lives.
class HangingImporter {
 public:
  explicit HangingImporter(const QTemporaryDir& folder) {
    const QString path = folder.filePath("importer.sh");
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    // As packed() of geometry/system/packed_text.h writes a text.
    file.write(
        "#!/bin/sh\n"
        "echo 'progress 0.4 \001meshing part %1 of %2, %3\003n2\003n5\003sClamp arm\003\002' >&4\n"
        "exec sleep 600\n");
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    file.close();
    qputenv("HAPTICELL_IMPORTER", path.toLocal8Bit());
  }
  ~HangingImporter() { qunsetenv("HAPTICELL_IMPORTER"); }
};

QString writeStepName(const QTemporaryDir& folder, const char* name) {
  QFile file(folder.filePath(name));
  EXPECT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("ISO-10303-21;\n");
  return file.fileName();
}

TEST(ImportWindow, WhyAFileWasRefusedIsInFrontAndAgainByAClickOnTheStatusLine) {
  QTemporaryDir folder;
  ImportPage page;
  auto* messages = page.window().findChild<QDockWidget*>("dockMessages");
  bringToFront(page.window().findChild<QDockWidget*>("dockCollisions"));
  WindowPage::settle();
  ASSERT_FALSE(isInFront(*messages));
  page.window().importFiles({writeStepName(folder, "cut.step")});
  EXPECT_TRUE(WindowPage::until([&] { return isInFront(*messages); }, 60000));
  EXPECT_NE(page.told("cut.step was not added"), nullptr);
  bringToFront(page.window().findChild<QDockWidget*>("dockCollisions"));
  WindowPage::settle();
  ASSERT_FALSE(isInFront(*messages));
  auto* line = page.window().findChild<QWidget*>("statusLine");
  EXPECT_TRUE(line->toolTip().contains("cut.step was not added")) << line->toolTip().toStdString();
  QTest::mouseClick(line, Qt::LeftButton, {}, {60, 12});
  WindowPage::settle();
  EXPECT_TRUE(isInFront(*messages));
}

TEST(ImportWindow, AFileWithoutUnitIsGuessedFromItsSizeAndSaysSo) {
  QTemporaryDir folder;
  ImportPage page;
  ASSERT_TRUE(page.ask({writeBlock(folder.filePath("block.off"), 100, 50, 20)}));
  EXPECT_EQ(page.entities(), 0u) << "the user has not said yes";
  EXPECT_EQ(page.unit(), "Millimetre, guessed from the size");
  EXPECT_EQ(page.text("importSize"), "100.0 × 50.0 × 20.0 mm");
  EXPECT_TRUE(page.text("importKind").startsWith("OFF, ")) << page.text("importKind").toStdString();
  EXPECT_TRUE(page.text("importKind").endsWith("1 part"));
  ASSERT_TRUE(page.press("importAccept"));
  ASSERT_TRUE(page.idle());
  const workcell::Entity* block = page.entity("block");
  ASSERT_NE(block, nullptr);
  EXPECT_NEAR(block->mesh()->bounds().size().x, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(block->source.scale, 0.001);
  ASSERT_NE(page.told("block.off is added to the cell"), nullptr);
  EXPECT_TRUE(page.told("block.off is added to the cell")->text.contains("12 triangles"));
  EXPECT_FALSE(page.window().files().dock().isVisible()) << "it goes when there is nothing more to ask";
}

TEST(ImportWindow, ASizeThatMayBeMetresOrMillimetresIsAskedFor) {
  QTemporaryDir folder;
  ImportPage page;
  ASSERT_TRUE(page.ask({writeBlock(folder.filePath("conveyor.off"), 3.071, 0.768, 0.916),
                        writeBlock(folder.filePath("stop.off"), 4, 1, 1)}));
  EXPECT_EQ(page.text("importUnitAsked"), "The file states no unit. Which size is right?");
  EXPECT_EQ(page.text("importSize"), "3.071 × 0.768 × 0.916, unit unknown");
  EXPECT_FALSE(page.press("importAccept")) << "nothing is guessed";
  ASSERT_TRUE(page.press("importAll"));
  EXPECT_EQ(page.entities(), 0u);
  ASSERT_TRUE(page.press("unitMetres"));
  EXPECT_EQ(page.text("importSize"), "3071 × 768 × 916 mm");
  ASSERT_TRUE(page.press("importAll")) << "the answer counts for all that are open";
  ASSERT_TRUE(page.idle());
  ASSERT_NE(page.entity("conveyor"), nullptr);
  EXPECT_NEAR(page.entity("conveyor")->mesh()->bounds().size().x, 3.071, 1e-9);
  ASSERT_NE(page.entity("stop"), nullptr);
  EXPECT_NEAR(page.entity("stop")->mesh()->bounds().size().x, 4.0, 1e-9);
}

TEST(ImportWindow, WhoIsNotAskedIsToldThatTheUnitMayBeAnother) {
  QTemporaryDir folder;
  ImportPage page;
  ASSERT_TRUE(page.add(writeBlock(folder.filePath("block.off"), 100, 50, 20)));
  EXPECT_NEAR(page.entity("block")->mesh()->bounds().size().x, 100.0, 1e-9);
  const Message* told = page.told("block.off was read with warnings");
  ASSERT_NE(told, nullptr);
  EXPECT_TRUE(told->text.contains("the file has no unit")) << told->text.toStdString();
}

TEST(ImportWindow, RemarksAreGroupedAndAClickSelectsThePart) {
  QTemporaryDir folder;
  QFile file(folder.filePath("arm.urdf"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  const auto link = [](const char* name) {
    return QByteArray("<link name='") + name + "'><visual><geometry><mesh filename='" + name +
           ".stl'/></geometry></visual></link>";
  };
  file.write("<robot name='arm'>" + link("foot") + link("boom") +
             "<joint name='j' type='revolute'><parent link='foot'/><child link='boom'/><axis xyz='0 0 1'/>"
             "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>");
  file.close();
  ImportPage page;
  ASSERT_TRUE(page.add(file.fileName()));
  ASSERT_TRUE(page.add(writeBlock(folder.filePath("block.off"), 1, 1, 1)));
  const Message* told = page.told("arm.urdf was read with warnings");
  ASSERT_NE(told, nullptr);
  ASSERT_GE(told->lines.size(), 2u);
  EXPECT_NE(page.window().selection().current(), page.entity("arm")->id);

  auto* dock = page.window().findChild<QDockWidget*>("dockMessages");
  dock->show();
  dock->raise();
  WindowPage::settle();
  QTreeWidget* list = nullptr;
  for (auto* one : dock->findChildren<QTreeWidget*>("messageLines"))
    if (!one->findItems("foot.stl", Qt::MatchContains | Qt::MatchRecursive).isEmpty()) list = one;
  ASSERT_NE(list, nullptr);
  QTreeWidgetItem* item = list->findItems("boom.stl", Qt::MatchContains | Qt::MatchRecursive).front();
  ASSERT_NE(item->parent(), nullptr) << "two shapes were lost for one reason";
  EXPECT_TRUE(item->parent()->text(0).endsWith("(2)")) << item->parent()->text(0).toStdString();
  const int closed = list->height();
  list->parentWidget()->window()->activateWindow();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item->parent()).center());
  ASSERT_TRUE(item->parent()->isExpanded());
  EXPECT_GT(list->height(), closed);
  WindowPage::settle();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
  EXPECT_EQ(page.window().selection().current(), page.entity("arm")->id);

  page.trigger("actionRemove");
  WindowPage::settle();
  ASSERT_EQ(page.entity("arm"), nullptr);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
  EXPECT_EQ(page.window().selection().current(), 0u) << "what is gone is not selected";
}

TEST(ImportWindow, NamesColoursAndUnitOfAnObjFileComeWithIt) {
  QTemporaryDir folder;
  const auto write = [&](const char* name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  };
  write("two.mtl", "newmtl red\nKd 1 0 0\n");
  write("two.obj",
        "# File units = inches\nmtllib two.mtl\no Plate\nv 0 0 0\nv 40 0 0\nv 0 40 0\nf 1 2 3\no Pin\nusemtl red\n"
        "v 0 0 9\nv 40 0 9\nv 0 40 9\nf 4 5 6\n");
  ImportPage page;
  ASSERT_TRUE(page.ask({folder.filePath("two.obj")}));
  EXPECT_EQ(page.unit(), "Inch, from the file");
  EXPECT_TRUE(page.text("importKind").endsWith("2 parts")) << page.text("importKind").toStdString();
  EXPECT_TRUE(page.text("importSize").startsWith("1016 × 1016 × 229")) << page.text("importSize").toStdString();
  ASSERT_TRUE(page.press("importAccept"));
  ASSERT_TRUE(page.idle());
  ASSERT_NE(page.entity("Plate"), nullptr);
  ASSERT_NE(page.entity("Pin"), nullptr);
  EXPECT_EQ(page.entity("Pin")->color, (std::array<float, 3>{1, 0, 0}));
  EXPECT_DOUBLE_EQ(page.entity("Pin")->source.scale, 0.0254);
  const QString cell = folder.filePath("cell.hcell");
  ASSERT_TRUE(page.window().documentModel().save(cell));
  ASSERT_TRUE(page.open(cell));
  ASSERT_NE(page.entity("Pin"), nullptr);
  EXPECT_NEAR(page.entity("Pin")->mesh()->bounds().min.z, 9 * 0.0254, 1e-12);
  EXPECT_EQ(page.entity("Pin")->color, (std::array<float, 3>{1, 0, 0}));
}

TEST(ImportWindow, UnitAndUpAxisAreTheUsersChoice) {
  QTemporaryDir folder;
  ImportPage page;
  ASSERT_TRUE(page.ask({writeBlock(folder.filePath("block.off"), 100, 50, 20)}));
  page.chooseUnit("Inch");
  page.choose("importUp", 1);
  ASSERT_TRUE(WindowPage::until([&] { return page.text("importSize").startsWith("2540 × 508 × 1270"); }, 20000))
      << page.text("importSize").toStdString();
  ASSERT_TRUE(page.press("importAccept"));
  ASSERT_TRUE(page.idle());
  const workcell::Entity* block = page.entity("block");
  ASSERT_NE(block, nullptr);
  const dvec3 size = block->mesh()->bounds().size();
  EXPECT_NEAR(size.x, 2.54, 1e-9);
  EXPECT_NEAR(size.y, 0.508, 1e-9);
  EXPECT_NEAR(size.z, 1.27, 1e-9);
  EXPECT_EQ(block->source.up_axis, workcell::UpAxis::kY);
}

TEST(ImportWindow, SeveralFilesWaitForEachOtherAndAreOneStepEach) {
  QTemporaryDir folder;
  ImportPage page;
  ASSERT_TRUE(page.ask({writeBlock(folder.filePath("a.off"), 1, 1, 1), writeBlock(folder.filePath("b.off"), 1, 1, 1),
                        writeBlock(folder.filePath("c.off"), 1, 1, 1)}));
  ASSERT_TRUE(page.press("importCancel"));
  ASSERT_TRUE(page.press("importAll"));
  ASSERT_TRUE(page.idle());
  EXPECT_EQ(page.entity("a"), nullptr) << "the one that was shown was given up";
  EXPECT_EQ(page.entities(), 2u);
  page.trigger("actionUndo");
  EXPECT_EQ(page.entities(), 1u);
}

TEST(ImportWindow, AHangingFileIsCancelledAndTheCellIsAsItWas) {
  QTemporaryDir folder;
  const HangingImporter importer(folder);
  ImportPage page;
  page.window().importFiles({writeStepName(folder, "slow.step")});
  ASSERT_TRUE(WindowPage::until([&] { return page.text("importShare").startsWith("40 %"); }, 20000));
  EXPECT_EQ(page.text("importStage"), "Meshing part 2 of 5, Clamp arm");
  EXPECT_TRUE(page.window().files().isBusy());
  // The window goes on working: another file goes into the cell only after it, but the cell can be changed.
  page.window().documentModel().addImported({[] {
    workcell::Entity group;
    group.name = "group";
    group.body = workcell::Assembly{};
    return group;
  }()});
  EXPECT_EQ(page.entities(), 1u);
  ASSERT_TRUE(page.press("importCancel"));
  EXPECT_FALSE(page.window().files().isBusy());
  EXPECT_EQ(page.entities(), 1u);
}

TEST(ImportWindow, AnImporterThatFailsIsASentence) {
  QTemporaryDir folder;
  qputenv("HAPTICELL_IMPORTER", "/bin/false");
  ImportPage page;
  EXPECT_FALSE(page.add(writeStepName(folder, "bad.step")));
  qunsetenv("HAPTICELL_IMPORTER");
  const Message* told = page.told("bad.step was not added");
  ASSERT_NE(told, nullptr);
  EXPECT_TRUE(told->text.contains("The cell is unchanged."));
  EXPECT_EQ(page.entities(), 0u);
}

TEST(ImportWindow, FilesThatAreDroppedAreAskedAbout) {
  QTemporaryDir folder;
  ImportPage page;
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(writeBlock(folder.filePath("a.off"), 1, 1, 1)),
                QUrl::fromLocalFile(writeBlock(folder.filePath("b.off"), 1, 1, 1))});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&page.window(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&page.window(), &drop);
  WindowPage::settle();
  EXPECT_EQ(page.window().files().session().files().size(), 2u);
}

TEST(ImportWindow, AMissingFileIsAskedForOnceAndTheRestIsThere) {
  QTemporaryDir folder;
  const QString cell = folder.filePath("cell.hcell");
  {
    ImportPage page;
    for (const char* name : {"a.off", "b.off"}) ASSERT_TRUE(page.add(writeBlock(folder.filePath(name), 1, 1, 1)));
    ASSERT_TRUE(page.window().documentModel().save(cell));
  }
  ASSERT_TRUE(QFile::remove(folder.filePath("b.off")));
  ImportPage page;
  ASSERT_TRUE(page.open(cell));
  EXPECT_NE(page.entity("a")->mesh(), nullptr);
  ASSERT_NE(page.entity("b"), nullptr);
  EXPECT_TRUE(page.entity("b")->unloaded);
  const Message* told = page.told("A file of this cell is missing");
  ASSERT_NE(told, nullptr);
  EXPECT_TRUE(told->text.contains("b.off"));
  ASSERT_EQ(told->actions.size(), 1u);
  EXPECT_EQ(page.told("was read with warnings"), nullptr) << "one message for all of them";
}

TEST(ImportWindow, AFileThatChangedIsReadAgainWithPlacementsKept) {
  QTemporaryDir folder;
  const QString file = writeBlock(folder.filePath("a.off"), 1, 1, 1);
  ImportPage page;
  ASSERT_TRUE(page.add(file));
  const auto id = page.entity("a")->id;
  ASSERT_TRUE(page.window().documentModel().execute(workcell::SetPlacement{id, Pose::translation({1, 2, 3})}));
  writeBlock(file, 2, 1, 1);
  page.window().selection().set(id);
  page.trigger("actionReload");
  ASSERT_TRUE(page.idle());
  WindowPage::settle();
  EXPECT_NEAR(page.entity("a")->mesh()->bounds().size().x, 2.0, 1e-12);
  EXPECT_EQ(page.entity("a")->X_WE.p, dvec3(1, 2, 3));
  page.trigger("actionUndo");
  EXPECT_NEAR(page.entity("a")->mesh()->bounds().size().x, 1.0, 1e-12);
  EXPECT_EQ(page.entity("a")->X_WE.p, dvec3(1, 2, 3));
}

/// The longest time between two turns of the event loop while `busy`; how many turns there were.
template <typename Busy>
std::pair<double, int> longestGap(Busy busy) {
  QElapsedTimer clock;
  clock.start();
  double longest = 0.0;
  int turns = 0;
  for (qint64 last = clock.nsecsElapsed(); busy(); ++turns) {
    QApplication::processEvents(QEventLoop::AllEvents, 5);
    const qint64 now = clock.nsecsElapsed();
    longest = std::max(longest, 1e-6 * static_cast<double>(now - last));
    last = now;
  }
  return {longest, turns};
}

TEST(ImportWindow, TheWindowAnswersWhileARealPartIsRead) {
  HAPTICELL_SHARED_DATA_OR_SKIP(part, "cad/step/NIST_MBE_PMI_2.stp");
  ImportPage page;
  page.window().importFiles({QString::fromStdString(part.string())});
  const auto [gap, turns] = longestGap([&] { return page.window().files().isBusy(); });
  EXPECT_GT(turns, 20);
  EXPECT_TRUE(page.text("importKind").startsWith("STEP AP203")) << page.text("importKind").toStdString();
  QElapsedTimer clock;
  clock.start();
  ASSERT_TRUE(page.press("importAccept"));  // What was read enters at once: the mesh is there, nothing is read again.
  const double landing = 1e-6 * static_cast<double>(clock.nsecsElapsed());
  std::cout << "longest gap in the window's loop: " << gap << " ms while reading; entering the cell took " << landing
            << " ms\n";
  EXPECT_EQ(page.entities(), 1u);
}

TEST(ImportWindow, FiveHundredPartsAreHiddenAtOnce) {
  ImportPage page;
  std::vector<workcell::Entity> parts(501);
  parts[0].name = "rig";
  parts[0].body = workcell::Assembly{};
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({0.01, 0.01, 0.01}));
  for (std::size_t k = 1; k < parts.size(); ++k) {
    parts[k].name = "part " + std::to_string(k);
    parts[k].parent = "rig";
    parts[k].body = workcell::Solid{mesh};
    const std::size_t column = k % 25;
    const std::size_t row = k / 25;
    parts[k].X_WE = Pose::translation({0.02 * static_cast<double>(column), 0.02 * static_cast<double>(row), 0.0});
  }
  ASSERT_TRUE(page.window().documentModel().addImported(std::move(parts)));
  WindowPage::settle();
  Entities all;
  for (const auto& entity : page.window().documentModel().document().state().entities) all.push_back(entity->id);
  all.erase(all.begin());  // Each part by itself: the slower way.
  QElapsedTimer clock;
  clock.start();
  ASSERT_TRUE(showEntities(page.window().documentModel(), all, false));
  const double document_ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
  QApplication::processEvents();
  std::cout << "500 parts hidden: " << document_ms << " ms, with what the window then does "
            << 1e-6 * static_cast<double>(clock.nsecsElapsed()) << " ms\n";
  for (const auto id : all) EXPECT_FALSE(page.window().documentModel().document().find(id)->visible);
  EXPECT_EQ(page.window().documentModel().document().undoTexts().size(), 2u);
}

TEST(ImportWindow, WhatIsExportedCanBeImportedAgainAndTheReportIsWritten) {
  QTemporaryDir folder;
  ImportPage page;
  ASSERT_TRUE(page.add(writeBlock(folder.filePath("a.off"), 1, 1, 1)));
  const QString cell = folder.filePath("cell.hcell"), mesh = folder.filePath("out.glb");
  ASSERT_TRUE(page.window().documentModel().save(cell));
  ASSERT_TRUE(page.window().documentModel().execute(
      workcell::SetPlacement{page.entity("a")->id, Pose::translation({0.5, 0, 0})}));
  ExportWork& exports = page.window().files().exports();
  exports.exportTo(mesh, false);
  exports.packTo(folder.filePath("pack.zip"));
  exports.reportTo(folder.filePath("changes.pdf"), ExportWork::Against::kSaved);
  exports.reportTo(folder.filePath("changes.csv"), ExportWork::Against::kImport);
  exports.exportTo(folder.filePath("none.urdf"), false);
  ASSERT_TRUE(page.idle());
  WindowPage::settle();
  for (const char* name : {"out.glb", "pack.zip", "changes.pdf", "changes.csv"})
    EXPECT_TRUE(QFile::exists(folder.filePath(name))) << name;
  QFile pdf(folder.filePath("changes.pdf")), csv(folder.filePath("changes.csv"));
  ASSERT_TRUE(pdf.open(QIODevice::ReadOnly) && csv.open(QIODevice::ReadOnly));
  EXPECT_TRUE(pdf.readAll().startsWith("%PDF"));
  EXPECT_TRUE(csv.readAll().contains("a,solid,moved,0,0,0,"));
  EXPECT_NE(page.told("none.urdf was not saved"), nullptr);
}

TEST(ImportWindow, APackAsksBeforeItTakesFilesFromOutsideOfTheCellsFolder) {
  QTemporaryDir folder, elsewhere;
  ImportPage page;
  ASSERT_TRUE(page.add(writeBlock(elsewhere.filePath("far.off"), 1, 1, 1)));
  ASSERT_TRUE(page.window().documentModel().save(folder.filePath("cell.hcell")));
  ExportWork& exports = page.window().files().exports();
  const auto answer = [&](const QString& button) {
    exports.packTo(folder.filePath("pack.zip"));
    QMessageBox* question = nullptr;
    if (!WindowPage::until([&] { return (question = page.window().findChild<QMessageBox*>("askOutside")) != nullptr; },
                           60000))
      return QString();
    const QString list = question->informativeText();
    for (QAbstractButton* one : question->buttons())
      if (one->text().remove('&') == button) one->click();
    WindowPage::until([&] { return !page.window().findChild<QMessageBox*>("askOutside"); }, 5000);
    page.idle();
    WindowPage::settle();
    return list;
  };
  EXPECT_TRUE(answer("Cancel").contains("far.off"));
  EXPECT_FALSE(QFile::exists(folder.filePath("pack.zip")));
  EXPECT_TRUE(answer("Pack them too").contains("far.off"));
  EXPECT_TRUE(QFile::exists(folder.filePath("pack.zip")));
}

}  // namespace
}  // namespace hapticell::app
