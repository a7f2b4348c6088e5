// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "app/trajectory/docks/time_bar.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace hapticell::app {

class Host;
class MotionChart;
class MotionList;
class MotionPlayer;
class PlayControls;
class RecordedStrip;

/// The dock under the scene: transport, recording, the time bar and the curves of the current motion on one time axis.
class TrajectoryPanel : public QWidget {
  Q_OBJECT
 public:
  TrajectoryPanel(Host& host, MotionList& list, MotionPlayer& player, QWidget* parent = nullptr);

  TimeBar& timeBar() { return *bar_; }
  MotionChart& chart() { return *chart_; }
  /// The state of the recording, ten times a second; empty: nothing is recorded.
  struct Recording {
    double seconds = 0.0;
    std::size_t frames = 0, by_hand = 0;
  };
  void showRecording(const std::optional<Recording>& recording);
  /// Shows what an edit did, until the next edit.
  void showLine(const QString& line, bool careful);
  void markMissed();  ///< Makes the shown result red, because it missed what was asked, until the next one.
  /// Sets the frame of the current motion that is being edited.
  void setFrame(std::optional<std::size_t> frame);

 signals:
  void recordWanted();
  void editWanted();  ///< Asks for the panel for editing.
  void smoothWanted();
  void checkWanted();
  void exportWanted();
  void trimWanted();
  void frameChosen(std::size_t frame);
  void roomWanted();  ///< All four curves are shown: they need a high dock.

 private:
  QWidget* makeTransport();
  void connectBar();
  void showMotions();
  void showCurrent();
  void showTime();
  void chooseCurves();

  MotionList& list_;
  MotionPlayer& player_;
  TimeBar* bar_;
  MotionChart* chart_;
  RecordedStrip* live_;  ///< In place of the chart.
  PlayControls* play_;
  QToolButton *record_, *trim_, *smooth_, *check_, *export_, *edit_;
  QComboBox *group_, *order_;
  QLabel* info_;
  bool recording_ = false, slow_told_ = false;  ///< Reported once per playback.
  std::shared_ptr<const trajectory::Trajectory> shown_motion_;
};

}  // namespace hapticell::app
