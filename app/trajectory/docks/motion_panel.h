// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "app/trajectory/docks/time_bar.h"
#include "manipulation/engine/manipulation_command.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class CleanFields;
class MotionExport;
class MotionFacts;
class MotionList;
class MotionPlayer;
class MotionWork;
class ProgramFields;
class RecordingFields;
class TimingFields;
class ValueField;

/// The dock *Motion*: how to record, and everything that can be done with the current motion. Every edit makes a copy.
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
  explicit MotionPanel(const Parts& parts, QWidget* parent = nullptr);

  /// The user's choices for recording.
  manipulation::command::StartRecording recordingWanted() const;
  void showLine(const QString& line, bool careful);
  void markMissed();  ///< Makes the shown result red, because it missed what was asked, until the next one.
  void setFrame(std::optional<std::size_t> frame);
  std::optional<std::size_t> frame() const { return frame_; }
  /// Seconds before and after a moved frame that move along with it.
  double reach() const;
  void smooth();
  void trim();
  /// Scrolls to a section: "Clean", "Export" ...
  void showSection(const QString& heading);

 signals:
  void frameChanged();
  void sectionWanted(QWidget* section);

 private:
  void addRecording(QVBoxLayout& column);
  void addMotion(QVBoxLayout& column);
  void addShape(QVBoxLayout& column);
  void addFrames(QVBoxLayout& column);
  void addClean(QVBoxLayout& column);
  void addTiming(QVBoxLayout& column);
  void addCheck(QVBoxLayout& column);
  void addExport(QVBoxLayout& column);
  QPushButton* action(const char* name, const QString& text, const QString& tip, std::function<void()> act);
  void show();
  void showCheck();
  void showFrame();
  std::optional<TimeBar::Part> part() const;
  void retime();
  void insertFrame();
  void deletePart();
  void addWay(bool approach);

  MotionList& list_;
  MotionPlayer& player_;
  MotionWork& work_;
  MotionExport& files_;
  TimeBar& bar_;
  std::optional<std::size_t> frame_;
  RecordingFields* recording_;
  MotionFacts* facts_;
  CleanFields* clean_;
  TimingFields* timing_;
  ProgramFields* program_;
  ValueField *dwell_, *way_, *reach_;
  QLabel* frame_label_;
  QComboBox* mirror_;
  QListWidget* findings_;
  std::vector<QPushButton*> need_motion_, need_frame_;
  std::vector<std::pair<QString, QWidget*>> sections_;
};

}  // namespace hapticell::app
