// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "manipulation/session/exercise.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

/// The section *Exercise* of the dock *Training*: the list of exercises, the chosen one's task, and its buttons. GUI
/// thread.
class ExerciseSection : public QObject {
  Q_OBJECT
 public:
  explicit ExerciseSection(QVBoxLayout& column, QObject* parent = nullptr);

  /// The folder for exercises made here; the list shows them after the shipped ones.
  const QString& folder() const { return own_folder_; }
  void setFolder(const QString& folder) { own_folder_ = folder; }
  /// Fills the list again and selects this file; empty: no selection.
  void fill(const QString& file);
  void chooseNone();
  struct State {
    const std::optional<manipulation::Exercise>* exercise = nullptr;
    bool is_running = false, is_playing = false;
    bool has_motion = false;  ///< The current motion can be taught.
  };
  void show(const State& state);

 signals:
  void chosen(const QString& path);
  void playWanted();  ///< Asks to start or stop showing the expert's motion.
  void newWanted();
  void editWanted();
  void teachWanted();  ///< Asks to make an exercise of the current motion.

 private:
  void choose(int index);

  QString own_folder_;
  QComboBox* exercises_;
  QLabel* text_;
  QPushButton *show_me_, *new_, *edit_, *use_;
};

}  // namespace hapticell::app
