// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "geometry/system/error.h"
#include "mannequin/body/skeleton.h"
#include "planning/problem.h"
#include "workcell/entity/entity.h"

class QComboBox;
class QLineEdit;
class QPushButton;

namespace hapticell::app {

class Host;
class ReferenceChoice;
class ValueField;

/// Asks for the goal of a path: a pose, a frame, joints, or out of the cell. GUI thread.
class PlanGoalForm : public QWidget {
  Q_OBJECT
 public:
  using Axes = std::vector<const workcell::Entity*>;
  enum Kind { kPose, kFrame, kJoints, kOut };
  explicit PlanGoalForm(Host& host, QWidget* parent = nullptr);

  /// Offers the kinds of goals that the entity may have: joints for a robot or mechanism, out of the cell for a solid, and
  /// neither for a mannequin.
  /// At first all are offered.
  void offerFor(const workcell::Entity& entity);
  /// The goal for an entity that offerFor() was called for. Errors: joints that are no numbers, too few or too many; no
  /// frame is chosen, or it no longer exists.
  /// `axes`: its external axes that move along, the lowest first; joints are theirs and its own, or its own alone.
  Expected<planning::Goal> goal(const workcell::Entity& entity, const Axes& axes = {}) const;
  /// Fills pose and joints from where the entity is now: its tool, its frame, or the grip of a mannequin's hand.
  void take(const workcell::Entity& entity, mannequin::Side hand, const Axes& axes = {});
  /// Fills the joints again as take() does, for other axes, if they are as it filled them.
  void takeAxes(const workcell::Entity& entity, const Axes& axes);
  /// True while the pose is as take() filled it.
  bool isAsTaken() const;

 signals:
  void takeWanted();  ///< The place where the entity is now shall be the goal.

 private:
  void offer(const std::vector<Kind>& kinds);
  void showKind();
  void takeJoints(const workcell::Entity& entity, const Axes& axes);
  QComboBox* kind_;
  std::array<ValueField*, 6> pose_{};
  std::array<double, 6> taken_{};  ///< As the fields show it.
  QWidget *pose_page_, *frame_row_, *joints_row_;
  ReferenceChoice* frame_;
  QLineEdit* joints_;
  QString taken_joints_;
  QPushButton* take_;
};

}  // namespace hapticell::app
