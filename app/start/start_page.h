// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <vector>

#include "workcell/files/autosave.h"

class QScrollArea;
class QVBoxLayout;

namespace hapticell::app {

class RecentFiles;
class UserSettings;

/// The page over the empty scene at the start: unsaved work after a crash, three sample cells with pictures, recent
/// files, and how to start a new cell. A part of the viewport, not a window: it closes when a cell is opened, when
/// something is picked or placed in the scene, or by Escape. GUI thread.
class StartPage : public QFrame {
  Q_OBJECT
 public:
  StartPage(QWidget& scene, UserSettings& settings, RecentFiles& recent);
  RecentFiles& recentFiles() { return recent_; }
  /// Shows the page with up-to-date lists, above the scene; unsaved work after a crash is first.
  void open(const std::vector<workcell::LeftWork>& left);

 signals:
  void fileWanted(const QString& path);
  void restoreWanted(const hapticell::workcell::LeftWork& left);
  void discardWanted(const hapticell::workcell::LeftWork& left);
  void laterWanted(const hapticell::workcell::LeftWork& left);
  /// One of the window's actions by its name: "actionOpen", "actionImport", "actionNew".
  void actionWanted(const QString& name);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void build(const std::vector<workcell::LeftWork>& left);
  void addLeft(QVBoxLayout& column, const std::vector<workcell::LeftWork>& left);
  void addSamples(QVBoxLayout& column);
  void addOwn(QVBoxLayout& column);
  void place();
  QWidget& scene_;
  UserSettings& settings_;
  RecentFiles& recent_;
  QScrollArea* scroll_ = nullptr;
  QWidget* content_ = nullptr;
};

}  // namespace hapticell::app
