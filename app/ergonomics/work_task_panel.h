// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "mannequin/ergonomics/scores/work_task.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QVBoxLayout;

namespace hapticell::app {

class KnownField;
class LiftFields;
class MannequinContext;
class Segmented;

/// Task data that a posture does not show: loads, repetition, hold, grip, duration, lift. Kept with the workcell; each
/// change is one undo step. Values that were not entered are marked as unknown and make scores partial.
class WorkTaskPanel : public QWidget {
  Q_OBJECT
 public:
  explicit WorkTaskPanel(MannequinContext& context, QWidget* parent = nullptr);
  void showNow();

 private:
  void addPerson(QVBoxLayout& column);
  void addWork(QVBoxLayout& column);
  /// The mannequin's task, or a new one for it.
  ergonomics::WorkTask present() const;
  void change(const std::function<void(ergonomics::WorkTask&)>& edit);
  void connectNumber(KnownField* field, std::function<std::optional<double>*(ergonomics::WorkTask&)> of);
  MannequinContext& context_;
  QComboBox* preset_;
  QLineEdit *name_, *note_;
  KnownField *load_left_, *load_right_, *repetitions_, *duration_;
  Segmented *static_, *shock_, *rapid_, *grip_;
  QCheckBox *trunk_, *left_arm_, *right_arm_, *walking_;
  LiftFields* lift_;
  bool showing_ = false;
};

}  // namespace hapticell::app
