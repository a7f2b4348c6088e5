// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

namespace hapticell::app {

class RobotContext;
class StopLine;

/// Why the robot stops or is about to stop, in one line: a limit, a contact, what ended the last jog, or the nearest
/// limit. GUI thread.
class RobotStop : public QObject {
 public:
  /// The context must outlive it.
  explicit RobotStop(RobotContext& context, QObject* parent = nullptr);
  StopLine* line() const { return line_; }
  /// Sets why the last jog ended early, and which obstacle stopped it; empty: it did not.
  void setStopped(const QString& why, const QString& obstacle);
  /// Sets why a dragged arm does not follow; empty: it follows.
  void setHeldBack(const QString& why) { held_back_ = why; }
  /// Forgets everything, for another robot.
  void forget();
  void show();

 private:
  RobotContext& context_;
  StopLine* line_;
  QString stopped_, obstacle_, held_back_;
};

}  // namespace hapticell::app
