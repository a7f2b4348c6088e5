// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "mannequin/body/skeleton.h"

class QComboBox;

namespace hapticell::app {

class JointRow;
class MannequinContext;

/// All 56 joints of the mannequin and its gaze with their limits, by part of the body. A drag of a row is one undo
/// step. Coupled limits of shoulders and hips stop a row too.
class JointList : public QWidget {
  Q_OBJECT
 public:
  explicit JointList(MannequinContext& context, QWidget* parent = nullptr);
  void showNow();

 private:
  void showPart(int part);
  JointRow* addRow(const QString& name, double lower, double upper);
  void moveTo(mannequin::Dof dof, double radians);
  void look(double radians, bool aside);
  MannequinContext& context_;
  QComboBox* part_;
  struct Row {
    mannequin::Dof dof;
    JointRow* row;
  };
  std::vector<Row> rows_;
  std::array<JointRow*, 2> gaze_{};  ///< Sideways, down.
};

}  // namespace hapticell::app
