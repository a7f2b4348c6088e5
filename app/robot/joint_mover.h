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

/// Moves the joints of the context's robot, as far as the path is free of collisions. Everything between begin() and
/// end() is one undo step. GUI thread; checks run in the background, and only the newest target counts.
class JointMover : public QObject {
  Q_OBJECT
 public:
  JointMover(RobotContext& context, MotionWorker& worker, QObject* parent = nullptr);
  ~JointMover() override;

  void begin(const QString& text);
  void moveTo(const std::vector<double>& joints);
  /// Ends the undo step once the last motion is checked; if not `keep`, reverts all of it.
  void end(bool keep = true);
  /// Moves the joints as one undo step.
  void step(const QString& text, const std::vector<double>& joints);
  /// Moves to these joints only if the whole path is free, shown as a motion of at most a second; one undo step.
  void travel(const QString& text, const std::vector<double>& joints);
  /// A motion is being checked or played.
  bool isBusy() const { return checking_ || playing_.isActive(); }
  bool isOpen() const { return open_; }
  /// The target of the newest step, from which the next one starts; the robot's joints while nothing moves.
  std::vector<double> target() const;

 signals:
  /// The newest motion ended. If something stopped it: a sentence, and the obstacle's name (empty: a limit).
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
