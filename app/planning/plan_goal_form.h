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
  enum Kind { kPose, kFrame, kJoints, kOut };
  explicit PlanGoalForm(Host& host, QWidget* parent = nullptr);

  /// Offers the kinds of goals that the entity may have: joints for a robot or mechanism, out of the cell for a solid, and
  /// neither for a mannequin.
  /// At first all are offered.
  void offerFor(const workcell::Entity& entity);
  /// The goal for an entity that offerFor() was called for. Errors: joints that are no numbers, too few or too many; no
  /// frame is chosen, or it no longer exists.
  Expected<planning::Goal> goal(const workcell::Entity& entity) const;
  /// True while the pose is as take() filled it.
  bool isAsTaken() const;

 signals:
  void takeWanted();  ///< The place where the entity is now shall be the goal.

 public slots:
  /// Fills pose and joints from where the entity is now: its tool, its frame, or the grip of a mannequin's hand.
  void take(const hapticell::workcell::Entity& entity, hapticell::mannequin::Side hand);

 private:
  void offer(const std::vector<Kind>& kinds);
  void showKind();
  QComboBox* kind_;
  std::array<ValueField*, 6> pose_{};
  std::array<double, 6> taken_{};  ///< As the fields show it.
  QWidget *pose_page_, *frame_row_, *joints_row_;
  ReferenceChoice* frame_;
  QLineEdit* joints_;
  QPushButton* take_;
};

}  // namespace hapticell::app
