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
/// cell, straight and in the configuration that the robot stands in.
class CartesianJog : public QWidget {
  Q_OBJECT
 public:
  CartesianJog(RobotContext& context, JointMover& mover, QWidget* parent = nullptr);
  void setStep(const JogStepSize& step) { step_ = step; }
  /// Takes the newest pose; called a few times a second.
  void showNow();
  kinematics::JogFrame frame() const;
  /// Where the frame that is jogged in stands now.
  Pose frame_W() const;

 signals:
  /// What held a step back; empty: nothing did.
  void held(const QString& why);
  void frameChosen();

 private:
  void addRow(int axis);
  void showFrames();
  /// One step along (0 .. 2) or about (3 .. 5) an axis by so many mm or degrees.
  void jog(int axis, double amount);
  void typed(int axis, double value);
  std::array<double, 6> numbersNow() const;
  RobotContext& context_;
  JointMover& mover_;
  Segmented* frame_;
  ReferenceChoice* given_;  ///< Which frame, where one of the cell is meant.
  QWidget* given_row_;
  std::array<ValueField*, 6> fields_{};
  std::array<std::array<HoldButton*, 2>, 6> buttons_{};
  JogStepSize step_;
};

}  // namespace hapticell::app
