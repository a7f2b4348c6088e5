// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/lift_fields.h"

#include <QCheckBox>
#include <QVBoxLayout>
#include <utility>

#include "app/kit/form.h"
#include "app/style/value_field.h"

namespace hapticell::app {
namespace {

constexpr int kLiftNamesColumn = 108;

}  // namespace

LiftFields::LiftFields(QVBoxLayout& column, Change change, QObject* parent)
    : QObject(parent), change_(std::move(change)) {
  QVBoxLayout* section = addSection(column, tr("Lifting (NIOSH)"));
  lift_ = new QCheckBox(tr("The load is lifted or lowered"));
  lift_->setObjectName("checkLift");
  section->addWidget(lift_);
  lift_rows_ = new QWidget;
  auto* rows = new QVBoxLayout(lift_rows_);
  rows->setContentsMargins(0, 0, 0, 0);
  lift_distance_ = new ValueField({tr("mm"), 0, 0.0, 2000.0, 10.0});
  lift_distance_->setObjectName("fieldLiftDistance");
  asymmetry_ = new ValueField({tr("°"), 0, 0.0, 180.0, 5.0});
  asymmetry_->setObjectName("fieldAsymmetry");
  addRow(*rows, tr("Travel"), lift_distance_, kLiftNamesColumn);
  addRow(*rows, tr("Asymmetry"), asymmetry_, kLiftNamesColumn);
  section->addWidget(lift_rows_);
  connect(lift_, &QCheckBox::clicked, this,
          [this](bool on) { change_([&](ergonomics::WorkTask& t) { t.is_lift = on; }); });
  connect(lift_distance_, &ValueField::edited, this,
          [this](double mm) { change_([&](ergonomics::WorkTask& t) { t.lift_distance_m = mm / 1000.0; }); });
  connect(asymmetry_, &ValueField::edited, this,
          [this](double degrees) { change_([&](ergonomics::WorkTask& t) { t.asymmetry_deg = degrees; }); });
}

void LiftFields::show(const ergonomics::WorkTask& task) {
  lift_->setChecked(task.is_lift);
  lift_rows_->setVisible(task.is_lift);
  if (!lift_distance_->hasFocus()) lift_distance_->setValue(1000.0 * task.lift_distance_m);
  if (!asymmetry_->hasFocus()) asymmetry_->setValue(task.asymmetry_deg);
}

}  // namespace hapticell::app
