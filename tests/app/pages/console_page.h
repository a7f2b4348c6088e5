// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTextBlock>

#include "app/console/console_panel.h"
#include "app/console/script_files.h"
#include "app/style/theme.h"
#include "tests/app/pages/robot_page.h"

namespace hapticell::app {

/// Folders of the user that are the test's own, before the window asks for them.
class OwnUserFolders {
 public:
  OwnUserFolders() {
    qputenv("XDG_STATE_HOME", (folder_.path() + QStringLiteral("/state")).toUtf8());
    qputenv("XDG_DATA_HOME", (folder_.path() + QStringLiteral("/share")).toUtf8());
  }
  QString path() const { return folder_.path(); }

 private:
  QTemporaryDir folder_;
};

/// What a user does with the Python console, by real keys.
class ConsolePage : public OwnUserFolders, public RobotPage {
 public:
  static constexpr int kPython = 60000;  // ms: the interpreter starts, or a statement ends, on a machine that is busy.

  void show() {
    activate();
    trigger("actionPythonConsole");
  }
  /// Opens it and waits for the interpreter.
  bool start() {
    show();
    return until([this] { return state().contains(QStringLiteral("ready")); }, kPython);
  }
  QString state() { return words(QStringLiteral("labelConsoleState")); }
  QPlainTextEdit& field() { return *find<QPlainTextEdit>(QStringLiteral("fieldConsoleInput")); }
  QPlainTextEdit& output() { return *find<QPlainTextEdit>(QStringLiteral("textConsoleOutput")); }
  QString printed() { return output().toPlainText(); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&field(), key, modifiers);
    settle();
  }
  void type(const QString& text) {
    QTest::keyClicks(&field(), text);
    settle();
  }
  /// Types a statement, presses Enter and waits until `expected` is printed.
  bool run(const QString& statement, const QString& expected) {
    type(statement);
    key(Qt::Key_Return);
    return prints(expected);
  }
  bool prints(const QString& text) {
    return until([&] { return printed().contains(text); }, kPython);
  }
  bool isReady() {
    return until([this] { return state().contains(QStringLiteral("ready")); }, kPython);
  }
  bool hasSteps(std::size_t count) {
    return until([&] { return steps() == count; }, kPython);
  }
  /// The colour of the last line with this text.
  QColor colorOf(const QString& text) {
    QColor color;
    for (QTextBlock block = output().document()->begin(); block.isValid(); block = block.next())
      for (auto part = block.begin(); !part.atEnd(); ++part)
        if (part.fragment().text().contains(text)) color = part.fragment().charFormat().foreground().color();
    return color;
  }
  /// Chooses an entry of the menu of scripts as the user does.
  void choose(const QString& text) {
    auto* menu = find<QMenu>(QStringLiteral("menuConsoleScripts"));
    emit menu->aboutToShow();
    for (QAction* action : menu->actions())
      if (action->text() == text) return action->trigger();
    ADD_FAILURE() << "no entry " << text.toStdString();
  }
  static void rest(int ms) {
    until([] { return false; }, ms);
  }
  static void writeFile(const QString& path, const QByteArray& text) {
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  void addPart(const char* what, const char* name) {
    Diagnostics diagnostics;
    auto entity = workcell::EntityLoader({}).load(what, 0.0, diagnostics);
    ASSERT_TRUE(entity.has_value());
    entity->name = name;
    add(std::move(*entity));
  }
  Pose placeOf(const char* name) {
    const auto* entity = document().document().findByName(name);
    return entity ? entity->X_WE : Pose();
  }
};

}  // namespace hapticell::app
