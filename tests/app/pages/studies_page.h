// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/studies/parallel_chart.h"
#include "app/studies/results_panel.h"
#include "app/studies/scatter_chart.h"
#include "app/studies/study_panel.h"
#include "config/configuration.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {

/// What a user does with studies in the window: a copy of the shipped study of the car door, smaller.
class StudiesPage : public RobotPage {
 public:
  static constexpr int kRunPatience = 240000;  // ms; studies share the machine with other tests.

  StudiesPage() {
    namespace fs = std::filesystem;
    const auto shipped = config::findShippedFile("studies");
    EXPECT_TRUE(shipped.has_value());
    const fs::path folder(*shipped);
    for (const char* name : {"car-door.hcell", "car-door-welds.csv"})
      fs::copy_file(folder / name, fs::path(folder_.path().toStdString()) / name);
    std::string text = contentOf(QString::fromStdString((folder / "car-door-robot.hstudy").string()));
    replace(text, "steps = 7", "steps = 2");
    replace(text, "steps = 7", "steps = 3");
    replace(text, "turns = 8", "turns = 2");
    std::ofstream(file("small.hstudy").toStdString()) << text;
    window().resize(1700, 1100);
    settle();
  }
  QString file(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }
  static std::string contentOf(const QString& path) {
    std::ifstream stream(path.toStdString());
    std::stringstream content;
    content << stream.rdbuf();
    return content.str();
  }
  bool openCell() { return open(file("car-door.hcell")); }
  void openStudy(const char* name) {
    trigger("actionStudy");
    window().findChild<StudyPanel*>()->openFile(file(name));
    settle();
  }
  void openResults(const QString& path) {
    trigger("actionStudyResults");
    window().findChild<ResultsPanel*>()->openFile(path);
    settle();
  }
  void select(const char* name) {
    window().selection().set(document().document().findByName(name)->id);
    settle();
  }
  /// The next file dialog gets this path.
  void answerFile(const QString& path) {
    auto* timer = new QTimer(&window());
    QObject::connect(timer, &QTimer::timeout, &window(), [timer, path] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      if (name != nullptr) name->setText(path);
      QTest::keyClick(dialog, Qt::Key_Return);
      if (dialog->isVisible()) return timer->setInterval(1000);
      timer->stop();
      timer->deleteLater();
    });
    timer->start(50);
  }
  void typeText(const QString& field, const QString& text) {
    auto* edit = find<QLineEdit>(field);
    if (edit == nullptr) return;
    edit->setFocus();
    edit->selectAll();
    if (text.isEmpty()) QTest::keyClick(edit, Qt::Key_Delete);
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
    settle();
  }
  void chooseText(const QString& list, const QString& text) {
    auto* choice = find<QComboBox>(list);
    if (choice == nullptr) return;
    choice->setCurrentText(text);
    EXPECT_EQ(choice->currentText(), text);
    emit choice->activated(choice->currentIndex());
    settle();
  }
  /// Chooses a line of the study: group 0 varies, 1 asked, 2 required, 3 objectives.
  void chooseLine(int group, int line) {
    auto* tree = find<QTreeWidget>("treeStudy");
    tree->setCurrentItem(tree->topLevelItem(group)->child(line));
    settle();
  }
  QString line(int group, int row) {
    const QTreeWidgetItem* item = find<QTreeWidget>("treeStudy")->topLevelItem(group)->child(row);
    return item != nullptr ? item->text(0) : QString();
  }
  int lines(int group) { return find<QTreeWidget>("treeStudy")->topLevelItem(group)->childCount(); }
  /// Drags with the left button from one place of the scene to another.
  void drag(const QPoint& from, const QPoint& to) {
    ViewportWidget& scene = window().viewport();
    const auto send = [&](QEvent::Type type, const QPoint& place, Qt::MouseButton button, Qt::MouseButtons held) {
      QMouseEvent event(type, QPointF(place), scene.mapToGlobal(QPointF(place)), button, held, Qt::NoModifier);
      QApplication::sendEvent(&scene, &event);
      settle();
    };
    send(QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseMove, (from + to) / 2, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  }
  bool runToTheEnd() {
    click("buttonRunStudy");
    return until([&] { return words("labelStudyRun").contains("Complete"); }, kRunPatience);
  }
  int resultRows() { return find<QTableView>("tableResults")->model()->rowCount(); }
  /// The number in the first column of a row as it is sorted now.
  int variantIn(int row) {
    auto* table = find<QTableView>("tableResults");
    return table->model()->index(row, 0).data().toInt();
  }
  void clickRow(int row) {
    auto* table = find<QTableView>("tableResults");
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(row, 0)).center());
    settle();
  }
  bool isShowingAVariant() { return find<QAbstractButton>("buttonHideVariant")->isEnabled(); }

 private:
  static void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  QTemporaryDir folder_;
};

}  // namespace hapticell::app
