// SPDX-License-Identifier: Apache-2.0
#include "app/robot/joint_limit_fields.h"

#include <QCheckBox>
#include <QVBoxLayout>
#include <cmath>
#include <limits>
#include <utility>

#include "app/kit/form.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kLimitLabel = 72;

ValueField* limitField(const char* name, const ValueField::Format& format) {
  auto* field = new ValueField(format);
  field->setObjectName(QLatin1String(name));
  return field;
}

}  // namespace

JointLimitFields::JointLimitFields(QVBoxLayout& rows, Edit edit, QObject* parent)
    : QObject(parent), edit_(std::move(edit)) {
  limited_ = new QCheckBox(tr("Joint limits, from the current position"));
  limited_->setObjectName("checkLimited");
  rows.addWidget(limited_);
  const char* const names[2]{"", "Slide"};
  for (int i = 0; i < 2; ++i) {
    const QString unit = i == 0 ? QStringLiteral("°") : QStringLiteral("mm");
    const auto name = [&](const char* field) {
      return QStringLiteral("%1%2").arg(QLatin1String(field), QLatin1String(names[i]));
    };
    const auto make = [&](const char* field, const QString& of, double low) {
      auto* made = limitField("", {of, 1, low, 1e5, 1.0});
      made->setObjectName(name(field));
      return made;
    };
    lower_[i] = make("fieldLower", unit, -1e5);
    upper_[i] = make("fieldUpper", unit, -1e5);
    limit_row_[i] = addRow(rows, tr("From, to"), sideBySide({lower_[i], upper_[i]}), kLimitLabel);
    velocity_[i] = make("fieldVelocity", unit + tr("/s"), 0.0);
    friction_[i] = make("fieldFriction", i == 0 ? tr("N m") : tr("N"), 0.0);
    effort_row_[i] = addRow(rows, tr("Speed, friction"), sideBySide({velocity_[i], friction_[i]}), kLimitLabel);
    connect(lower_[i], &ValueField::edited, this, [this](double value) {
      edit_([&](workcell::MechanismJoint& joint) { joint.lower = value * shownUnit(joint); });
    });
    connect(upper_[i], &ValueField::edited, this, [this](double value) {
      edit_([&](workcell::MechanismJoint& joint) { joint.upper = value * shownUnit(joint); });
    });
    connect(velocity_[i], &ValueField::edited, this, [this](double value) {
      edit_([&](workcell::MechanismJoint& joint) { joint.velocity = value * shownUnit(joint); });
    });
    connect(friction_[i], &ValueField::edited, this,
            [this](double value) { edit_([&](workcell::MechanismJoint& joint) { joint.friction = value; }); });
  }
  pitch_ = limitField("fieldPitch", {tr("mm/turn"), 1, -1e4, 1e4, 1.0});
  pitch_row_ = addRow(rows, tr("Pitch"), pitch_, kLimitLabel);
  connectFields();
}

void JointLimitFields::connectFields() {
  connect(limited_, &QCheckBox::clicked, this, [this](bool on) {
    edit_([&](workcell::MechanismJoint& joint) {
      if (on) return suitLimits(joint);
      joint.lower = -kInfinite;
      joint.upper = kInfinite;
    });
  });
  connect(pitch_, &ValueField::edited, this,
          [this](double value) { edit_([&](workcell::MechanismJoint& joint) { joint.pitch = 0.001 * value; }); });
}

void JointLimitFields::show(const workcell::MechanismJoint& joint) {
  const int i = joint.type == workcell::MechanismJointType::kPrismatic ? 1 : 0;
  const bool limited = std::isfinite(joint.lower);
  limited_->setChecked(limited);
  for (int k = 0; k < 2; ++k) {
    limit_row_[k]->setVisible(k == i && limited);
    effort_row_[k]->setVisible(k == i);
  }
  if (limited) {
    lower_[i]->setValue(joint.lower / shownUnit(joint));
    upper_[i]->setValue(joint.upper / shownUnit(joint));
  }
  velocity_[i]->setValue(joint.velocity / shownUnit(joint));
  friction_[i]->setValue(joint.friction);
  pitch_row_->setVisible(joint.type == workcell::MechanismJointType::kScrew);
  pitch_->setValue(1000.0 * joint.pitch);
}

}  // namespace hapticell::app
