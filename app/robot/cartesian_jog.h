// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>

#include "kinematics/model/jog.h"

#include "app/robot/jog_buttons.h"

namespace hapticell::app {

class ReferenceChoice;
class RobotContext;
class Segmented;
class ValueField;

/// Jogs the tool centre point along and about the axes of the base, of the tool, of the world or of a frame of the
/// cell, in a straight line and in the robot's present configuration.
class CartesianJog : public QWidget {
  Q_OBJECT
 public:
  CartesianJog(RobotContext& context, JointMover& mover, QWidget* parent = nullptr);
  void setStep(const JogStepSize& step) { step_ = step; }
  /// Shows the newest pose; called a few times a second.
  void showNow();
  kinematics::JogFrame frame() const;
  /// The present pose of the frame for jogging.
  Pose frame_W() const;

 signals:
  /// What limited a step; empty: nothing did.
  void held(const QString& why);
  void frameChosen();

 private:
  void addRow(int axis);
  void showFrames();
  /// Moves one step along (0 to 2) or about (3 to 5) an axis, by an amount in mm or degrees.
  void jog(int axis, double amount);
  void typed(int axis, double value);
  std::array<double, 6> numbersNow() const;
  RobotContext& context_;
  JointMover& mover_;
  Segmented* frame_;
  ReferenceChoice* given_;  ///< The frame, if one of the cell is chosen.
  QWidget* given_row_;
  std::array<ValueField*, 6> fields_{};
  std::array<std::array<HoldButton*, 2>, 6> buttons_{};
  JogStepSize step_;
};

}  // namespace hapticell::app
