// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace hapticell::app {

class LiveScores;
class MannequinContext;
class MotionScoresModel;
class ScoreHistory;

/// Ergonomics over time: the scores of four bodies along a recorded motion, with a cursor that shows the mannequin in
/// that frame, play, worst phase and a button that applies the frame's posture.
class TimePanel : public QWidget {
  Q_OBJECT
 public:
  TimePanel(MannequinContext& context, const LiveScores& scores, MotionScoresModel& motion, QWidget* parent = nullptr);
  void open(const QString& path);
  /// Asks for a recording and opens it.
  void choose();
  /// Writes the motion on this mannequin as BVH; shows errors in the messages.
  bool saveMotion(const QString& path);
  int frame() const { return frame_; }
  void setFrame(int frame);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  void showMotion();
  void play(bool on);
  void takePosture();
  void showPlayed(bool on);
  MannequinContext& context_;
  const LiveScores& scores_;
  MotionScoresModel& motion_;
  ScoreHistory* history_;
  QPushButton *play_, *worst_, *take_, *save_;
  QLabel *name_, *at_, *beyond_;
  QTimer clock_;
  int frame_ = 0;
};

/// The strips with their cursor.
class ScoreHistory : public QWidget {
  Q_OBJECT
 public:
  explicit ScoreHistory(const MotionScoresModel& motion, QWidget* parent = nullptr);
  void setFrame(int frame);
  QSize sizeHint() const override { return {600, 150}; }

 signals:
  void frameChosen(int frame);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF area() const;
  void chooseAt(double x);
  const MotionScoresModel& motion_;
  int frame_ = 0;
};

}  // namespace hapticell::app
