// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <vector>

class QComboBox;
class QToolButton;
class QWidget;

namespace hapticell::app {

class MotionPlayer;

/// A flat button of the row above the time bar; `word`, if any, is next to the picture.
QToolButton* transportButton(const char* name, const QString& picture, const QString& tip, const QString& word = {});

/// The buttons that play the current motion, and the playback speed. GUI thread.
class PlayControls : public QObject {
  Q_OBJECT
 public:
  /// The player must outlive it.
  explicit PlayControls(MotionPlayer& player, QObject* parent = nullptr);
  /// The widgets from left to right, for the row that contains them.
  std::vector<QWidget*> widgets() const;
  /// Shows the present state of the player.
  void show();

 private:
  MotionPlayer& player_;
  QToolButton *first_, *back_, *play_, *next_, *last_, *loop_, *shown_, *swept_;
  QComboBox* speed_;
};

}  // namespace hapticell::app
