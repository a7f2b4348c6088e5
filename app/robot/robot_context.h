// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "kinematics/model/inverse_model.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class Host;

/// The robot or mechanism that the panels of this folder show: the selected one, else the one that was selected last.
/// GUI thread.
class RobotContext : public QObject {
  Q_OBJECT
 public:
  explicit RobotContext(Host& host, QObject* parent = nullptr);

  Host& host() const { return host_; }
  /// The robot of the document; null without a robot.
  const workcell::Entity* robot() const;
  /// True for a mechanism: it has joints, but no tool centre point to move.
  bool isMechanism() const;
  /// The present joint values, including a running hold or a played motion.
  std::vector<double> joints() const;
  Pose base_W() const;
  Pose tool_W() const;
  bool isHeld() const;
  /// False while it is held or locked, when nothing may be set.
  bool isFree() const;
  /// For its tool centre point; null if no joint moves it, and for mechanisms.
  const kinematics::InverseModel* inverse() const;
  /// "A5", or "A3" made from the joint's number if its own name is long.
  QString jointName(std::size_t variable) const;

 signals:
  void robotChanged();     ///< Another robot, or the model, the tool or the set of tools changed.
  void documentChanged();  ///< Anything in the document changed, the joints for instance.

 private:
  void follow();
  void lookAgain();
  Host& host_;
  workcell::EntityId robot_ = 0;
  std::shared_ptr<const workcell::Entity> seen_;  // The robot at the last robotChanged().
  mutable std::unique_ptr<const kinematics::InverseModel> inverse_;
  mutable bool inverse_made_ = false;
};

}  // namespace hapticell::app
