// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "app/robot/mechanism_draft.h"
#include "app/robot/mechanism_samples.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace hapticell::app {

class JointLimitFields;
class RobotContext;
class Segmented;
class ValueField;

/// Defines joints between parts of the cell and makes a mechanism of them, or changes the joints of one: kind, the two
/// parts, axis picked in the scene and shown there, limits, friction, coupling.
class MechanismPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MechanismPanel(RobotContext& context, QWidget* parent = nullptr);
  const MechanismDraft& draft() const { return draft_; }
  /// Starts with the mechanism of the context, or with a new one.
  void begin();
  /// Adds a mechanism from the samples, as one undo step.
  void addSample(MechanismSample sample);

 signals:
  void made();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void addHeading(QVBoxLayout& column);
  void addJoint(QVBoxLayout& column);
  void addLimits(QVBoxLayout& column);
  void addFoot(QVBoxLayout& column);
  QWidget* partRow(QVBoxLayout& rows, const QString& name, const char* object, QComboBox*& box, const QString& prompt);
  workcell::MechanismJoint* current();
  void edit(const std::function<void(workcell::MechanismJoint&)>& change);
  void show();
  void showJoint();
  void showFault();
  void drawAxes();
  void pickPart(QComboBox* box, const QString& prompt);
  void pickAxis();
  void finish();
  RobotContext& context_;
  MechanismDraft draft_;
  QLineEdit *name_, *joint_name_;
  QListWidget* joints_;
  Segmented* kind_;
  QComboBox *child_, *parent_, *coupled_;
  QLabel *axis_, *fault_;
  JointLimitFields* limit_fields_;
  ValueField* ratio_;
  QWidget *details_, *limits_, *ratio_row_;
  QPushButton *remove_, *make_;
  bool showing_ = false;
};

}  // namespace hapticell::app
