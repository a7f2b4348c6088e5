// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "manipulation/checks/joint_motion.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class MotionWorker;
class RobotContext;

/// Moves the joints of the context's robot, as far as the way is free of collisions. All between begin() and end() is
/// one step of undo. GUI thread; checks run beside it and the newest target wins.
class JointMover : public QObject {
  Q_OBJECT
 public:
  JointMover(RobotContext& context, MotionWorker& worker, QObject* parent = nullptr);
  ~JointMover() override;

  void begin(const QString& text);
  void moveTo(const std::vector<double>& joints);
  /// Ends the step once the last motion is checked; `keep` false takes all of it back.
  void end(bool keep = true);
  /// One step by itself.
  void step(const QString& text, const std::vector<double>& joints);
  /// Goes to these joints only where the whole way is free, seen as a motion of at most a second; one step.
  void travel(const QString& text, const std::vector<double>& joints);
  /// A motion is being checked or played.
  bool isBusy() const { return checking_ || playing_.isActive(); }
  bool isOpen() const { return open_; }
  /// Where the newest step leads, from which the next one goes on: the robot's joints while nothing is under way.
  std::vector<double> target() const;

 signals:
  /// The newest motion is done: nothing, or what stopped it: a sentence, and the obstacle's name (empty: a limit).
  void stopped(const QString& why, const QString& obstacle);

 private:
  void pump();
  void accept(const Expected<manipulation::JointMotion>& motion);
  void play(const manipulation::JointMotion& motion);
  void playFrame();
  void finishTravel();
  void forgetCell();
  RobotContext& context_;
  MotionWorker& worker_;
  workcell::EntityId robot_ = 0;
  std::optional<std::vector<double>> pending_;
  std::vector<double> target_;
  bool open_ = false, checking_ = false, ending_ = false, keep_ = true;
  struct Travel {
    QString text;
    std::vector<double> from;
    manipulation::JointMotion motion;
    double seconds = 0.0;
  };
  Travel travel_;
  QTimer playing_;
  QElapsedTimer clock_;
};

}  // namespace hapticell::app
