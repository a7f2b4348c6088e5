// SPDX-License-Identifier: Apache-2.0
// The questions for files, by real events.
#include "app/kit/file_dialog.h"

#include <gtest/gtest.h>

#include <QFileDialog>
#include <QGridLayout>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>

#include "app/host/user_settings.h"
#include "app/start/recent_files.h"
#include "tests/app/pages/cell_page.h"

namespace hapticell::app {
namespace {

/// Answers the next file dialog: `answer` is called while it is open, and once more each second while it stays: the
/// files of a folder are looked up beside the window, and what is not known yet may not be chosen.
void answerFileDialog(std::function<void(QFileDialog&)> answer) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, qApp, [timer, answer] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    answer(*dialog);
    if (dialog->isVisible()) return timer->setInterval(1000);
    timer->stop();
    timer->deleteLater();
  });
  timer->start(20);
}

void makeFile(const QString& path) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("cell");
}

TEST(FileDialog, ShowsThePictureOfACellInTheWindowsTheme) {
  QTemporaryDir folder, cache;
  qputenv("XDG_CACHE_HOME", cache.path().toLocal8Bit());
  const QString path = folder.filePath("cell.hcell");
  makeFile(path);
  QImage red(320, 180, QImage::Format_RGB32);
  red.fill(Qt::red);
  UserSettings kept(cache.filePath("window.ini"));
  RecentFiles(kept).keepPicture(path, red);
  WindowPage page;
  QString words;
  QColor middle;
  answerFileDialog([&](QFileDialog& dialog) {
    EXPECT_TRUE(dialog.testOption(QFileDialog::DontUseNativeDialog));
    emit dialog.currentChanged(path);
    auto* picture = dialog.findChild<QLabel*>("filePreviewPicture");
    ASSERT_NE(picture, nullptr) << "beside the list";
    const QPixmap shown = picture->pixmap(Qt::ReturnByValue);
    middle = shown.toImage().pixelColor(shown.width() / 2, shown.height() / 2);
    words = dialog.findChild<QLabel*>("filePreviewWords")->text();
    emit dialog.currentChanged(folder.path());
    EXPECT_FALSE(dialog.findChild<QLabel*>("filePreviewWords")->text().contains("cell.hcell")) << "a folder is chosen";
    // Not selectFile(): where the field has the focus already, that leaves it as it is.
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    name->setText(path);
    QTest::keyClick(name, Qt::Key_Return);
  });
  EXPECT_EQ(askToOpen(&page.window(), "Open", folder.path(), "Workcells (*.hcell)"), path);
  EXPECT_GT(middle.red(), 240);
  EXPECT_LT(middle.green(), 20);
  EXPECT_TRUE(words.contains("cell.hcell")) << words.toStdString();
  qunsetenv("XDG_CACHE_HOME");
}

TEST(FileDialog, ANameWithoutAnEndingGetsTheFiltersAndEscCancels) {
  QTemporaryDir folder;
  WindowPage page;
  answerFileDialog([&](QFileDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    ASSERT_NE(name, nullptr);
    EXPECT_EQ(name->text(), "part.step") << "what is proposed";
    name->selectAll();
    QTest::keyClicks(name, "mine");
    QTest::keyClick(name, Qt::Key_Return);
  });
  EXPECT_EQ(askToSave(&page.window(), "Export", folder.filePath("part.step"), "glTF (*.glb);;STEP (*.step)"),
            folder.filePath("mine.step"))
      << "the filter of the proposed name is chosen";
  answerFileDialog([](QFileDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  EXPECT_TRUE(askToSave(&page.window(), "Export", folder.filePath("part.step"), "STEP (*.step)").isEmpty());
}

TEST(FileDialog, OpenAsksInIt) {
  CellPage page;
  bool asked = false;
  answerFileDialog([&](QFileDialog& dialog) {
    asked = dialog.objectName() == "fileDialog";
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  page.trigger("actionOpen");
  EXPECT_TRUE(asked);
}

}  // namespace
}  // namespace hapticell::app
