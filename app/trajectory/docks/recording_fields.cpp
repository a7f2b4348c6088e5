// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/recording_fields.h"

#include <QCheckBox>
#include <QVBoxLayout>
#include <algorithm>

#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/trajectory/docks/named_field.h"
#include "geometry/shapes/vector.h"

namespace hapticell::app {

RecordingFields::RecordingFields(QVBoxLayout& section, QObject* parent) : QObject(parent) {
  mode_ = new Segmented({tr("Time"), tr("Distance"), tr("By hand"), tr("All")});
  mode_->setObjectName("segmentedRecording");
  mode_->setCurrent(0);
  addRow(section, tr("Record by"), mode_);
  interval_ = namedField("fieldInterval", {tr("ms"), 0, 1, 60000, 10}, 10);
  interval_row_ = addRow(section, tr("Every"), interval_);
  spacing_ = namedField("fieldSpacing", {tr("mm"), 1, 0.01, 10000, 1}, 5.0);
  turn_spacing_ = namedField("fieldTurnSpacing", {QStringLiteral("°"), 1, 0.01, 360, 1}, 5.0);
  spacing_row_ = addRow(section, tr("Every"), sideBySide({spacing_, turn_spacing_}));
  second_button_ = new QCheckBox(tr("Second stylus button adds a frame"));
  second_button_->setObjectName("checkSecondButton");
  section.addWidget(second_button_);
  connect(mode_, &Segmented::chosen, this, &RecordingFields::show);
  show();
}

manipulation::command::StartRecording RecordingFields::wanted() const {
  using trajectory::RecordingMode;
  constexpr RecordingMode kModes[] = {RecordingMode::kByTime, RecordingMode::kByDistance, RecordingMode::kByHand,
                                      RecordingMode::kEveryStep};
  manipulation::command::StartRecording wanted;
  wanted.options.mode = kModes[std::max(0, mode_->current())];
  wanted.options.interval_s = interval();
  wanted.options.spacing = {1e-3 * spacing_->value(), kDegree * turn_spacing_->value()};
  wanted.mark_by_button = second_button_->isChecked();
  return wanted;
}

double RecordingFields::interval() const {
  return 1e-3 * interval_->value();
}

void RecordingFields::show() {
  interval_row_->setVisible(mode_->current() == 0);
  spacing_row_->setVisible(mode_->current() == 1);
}

}  // namespace hapticell::app
