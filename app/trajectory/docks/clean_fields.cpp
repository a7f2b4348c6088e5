// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/clean_fields.h"

#include <QCheckBox>
#include <QVBoxLayout>

#include "app/kit/form.h"
#include "app/trajectory/docks/named_field.h"
#include "geometry/shapes/vector.h"

namespace hapticell::app {

CleanFields::CleanFields(QVBoxLayout& section, QObject* parent) : QObject(parent) {
  tolerance_ = namedField("fieldTolerance", {tr("mm"), 2, 0.01, 1000, 0.5}, 1.0);
  turn_tolerance_ = namedField("fieldTurnTolerance", {QStringLiteral("°"), 2, 0.01, 90, 0.5}, 1.0);
  first_row_ = addRow(section, tr("Tolerance"), sideBySide({tolerance_, turn_tolerance_}));
  keep_free_ = new QCheckBox(tr("Avoid collisions"));
  keep_free_->setObjectName("checkKeepFree");
  keep_free_->setChecked(true);
  section.addWidget(keep_free_);
}

trajectory::PathTolerance CleanFields::tolerance() const {
  return {1e-3 * tolerance_->value(), kDegree * turn_tolerance_->value(), 1e-3 * tolerance_->value()};
}

bool CleanFields::keepsFree() const {
  return keep_free_->isChecked();
}

}  // namespace hapticell::app
