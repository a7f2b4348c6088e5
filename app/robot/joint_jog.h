// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

class QVBoxLayout;

#include "app/robot/jog_buttons.h"

namespace hapticell::app {

class JointRow;
class RobotContext;
class ValueField;

/// The joints of a robot or mechanism, one per row: scale between the limits, number, step buttons.
class JointJog : public QWidget {
  Q_OBJECT
 public:
  JointJog(RobotContext& context, JointMover& mover, QWidget* parent = nullptr);
  /// Sets the step of the buttons.
  void setStep(const JogStepSize& step) { step_ = step; }
  /// Shows the newest positions; called a few times a second.
  void showNow();
  std::size_t rows() const { return rows_.size(); }

 private:
  struct Row {
    JointRow* scale = nullptr;
    ValueField* field = nullptr;
    HoldButton *less = nullptr, *more = nullptr;
    double unit = 1.0;
    bool slides = false;
  };
  void rebuild();
  void addRow(std::size_t variable);
  void connectRow(std::size_t variable);
  void moveTo(std::size_t variable, double shown);
  void stepBy(std::size_t variable, int direction);
  QString stepText(std::size_t variable) const;
  RobotContext& context_;
  JointMover& mover_;
  QVBoxLayout* column_;
  std::vector<Row> rows_;
  JogStepSize step_;
};

}  // namespace hapticell::app
