// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "app/trajectory/docks/time_bar.h"
#include "manipulation/engine/manipulation_command.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class MotionExport;
class MotionList;
class MotionPlayer;
class MotionWork;
class Segmented;
class ValueField;

/// The dock *Motion*: how is recorded, and all that can be done with the current motion. Every edit gives a copy.
class MotionPanel : public QWidget {
  Q_OBJECT
 public:
  struct Parts {
    MotionList& list;
    MotionPlayer& player;
    MotionWork& work;
    MotionExport& files;
    TimeBar& bar;
  };
  MotionPanel(Host& host, const Parts& parts, QWidget* parent = nullptr);

  /// As the user chose it.
  manipulation::command::StartRecording recordingWanted() const;
  void showLine(const QString& line, bool careful);
  void markMissed();  ///< The line that is shown misses what was asked: red, until the next one.
  void setFrame(std::optional<std::size_t> frame);
  std::optional<std::size_t> frame() const { return frame_; }
  /// Seconds about a moved frame that go along with it.
  double reach() const;
  void smooth();
  void trim();
  /// Brings a section into view: "Clean", "Export" ...
  void showSection(const QString& heading);

 signals:
  void frameChanged();
  void sectionWanted(QWidget* section);

 private:
  void addRecording(QVBoxLayout& column);
  void addMotion(QVBoxLayout& column);
  void addShape(QVBoxLayout& column);
  void addFrames(QVBoxLayout& column);
  trajectory::PathTolerance tolerance() const;
  void addClean(QVBoxLayout& column);
  void addTiming(QVBoxLayout& column);
  void addCheck(QVBoxLayout& column);
  void addExport(QVBoxLayout& column);
  QPushButton* action(const char* name, const QString& text, const QString& tip, std::function<void()> act);
  void show();
  void showCheck();
  void showFrame();
  void showProgress();
  std::optional<TimeBar::Part> part() const;
  void retime();
  void insertFrame();
  void deletePart();
  void addWay(bool approach);

  Host& host_;
  MotionList& list_;
  MotionPlayer& player_;
  MotionWork& work_;
  MotionExport& files_;
  TimeBar& bar_;
  std::optional<std::size_t> frame_;
  Segmented* mode_;
  ValueField *interval_, *spacing_, *turn_spacing_, *tolerance_, *turn_tolerance_, *speed_, *jerk_time_, *dwell_, *way_,
      *reach_, *blend_, *program_speed_;
  QWidget *interval_row_, *spacing_row_, *speed_row_, *jerk_row_;
  QCheckBox *second_button_, *keep_free_;
  QLineEdit *name_, *program_tool_, *program_base_;
  QLabel *facts_, *line_, *frame_label_, *busy_;
  QComboBox *format_, *mirror_, *timing_;
  QListWidget* findings_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  std::vector<QPushButton*> need_motion_, need_frame_;
  std::vector<std::pair<QString, QWidget*>> sections_;
};

}  // namespace hapticell::app
