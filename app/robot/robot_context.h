// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "kinematics/model/inverse_model.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class Host;

/// The robot or mechanism that the panels of this folder are about: the selected one, else the one that was selected
/// last. GUI thread.
class RobotContext : public QObject {
  Q_OBJECT
 public:
  explicit RobotContext(Host& host, QObject* parent = nullptr);

  Host& host() const { return host_; }
  /// The robot of the document; null without a robot.
  const workcell::Entity* robot() const;
  /// True for a mechanism: it has joints, but no tool centre point to bring somewhere.
  bool isMechanism() const;
  /// Where it stands now, a running hold or played motion included.
  std::vector<double> joints() const;
  Pose base_W() const;
  Pose tool_W() const;
  bool isHeld() const;
  /// False while it is held or locked: nothing may be set then.
  bool isFree() const;
  /// For its tool centre point; null where no joint moves that, and for mechanisms.
  const kinematics::InverseModel* inverse() const;
  /// "A5", else "A3" by its number where the joint's own name is long.
  QString jointName(std::size_t variable) const;

 signals:
  void robotChanged();     ///< Another robot, or another model, tool or set of tools of the same one.
  void documentChanged();  ///< Anything in the document, the joints for instance.

 private:
  void follow();
  void lookAgain();
  Host& host_;
  workcell::EntityId robot_ = 0;
  std::shared_ptr<const workcell::Entity> seen_;  // What robotChanged() was last told about.
  mutable std::unique_ptr<const kinematics::InverseModel> inverse_;
  mutable bool inverse_made_ = false;
};

}  // namespace hapticell::app
