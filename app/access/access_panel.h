// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/access/access_job.h"

class QComboBox;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class LiveLabel;
class MotionList;
class ValueField;

/// Access for maintenance: the question about a part, the answer, and each step drawn, felt, kept as a motion or shown
/// by hand. GUI thread.
class AccessPanel : public QWidget {
  Q_OBJECT
 public:
  /// `motions` are those of the document.
  AccessPanel(Host& host, MotionList& motions, QWidget* parent = nullptr);
  /// What it draws in the scene is hidden with its dock.
  void setShown(bool on);

 private:
  void addQuestion(QVBoxLayout& column);
  void addAnswer(QVBoxLayout& column);
  void addStep(QVBoxLayout& column);
  void useSelection();
  void ask();
  void takeAnswer();
  void refresh();
  void showStep();
  void showAlong();
  void feel(bool on);
  void keepMotion();
  void addMotion(const trajectory::Trajectory& measured);
  void layAside();
  void useShown();
  void writeReport();
  const access::RemovalStep* step() const;
  workcell::EntityId entityOf(const access::RemovalStep& step) const;
  QString wordsOf(const access::RemovalStep& step) const;

  Host& host_;
  MotionList& motions_;
  AccessJob job_;
  QString said_;
  bool shown_ = false;
  LiveLabel *part_, *result_, *facts_;
  ValueField *tolerance_, *glove_, *tool_length_, *tool_diameter_;
  QComboBox* persons_;
  QPushButton *ask_, *report_, *keep_, *feel_, *by_hand_, *aside_;
  QProgressBar* bar_;
  QListWidget *steps_, *people_;
  QSlider* along_;
};

}  // namespace hapticell::app
