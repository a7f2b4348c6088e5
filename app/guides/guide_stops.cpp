// SPDX-License-Identifier: Apache-2.0
#include "app/guides/guide_stops.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <optional>
#include <utility>

#include "app/kit/form.h"
#include "app/style/value_field.h"
#include "geometry/shapes/pose.h"

namespace hapticell::app {

bool hasStops(workcell::GuideKind kind) {
  return kind == workcell::GuideKind::kLine || kind == workcell::GuideKind::kHinge ||
         kind == workcell::GuideKind::kSlider || kind == workcell::GuideKind::kScrew;
}

GuideStops::GuideStops(QVBoxLayout& section, GuideEdit edit, QObject* parent)
    : QObject(parent), edit_(std::move(edit)) {
  std::array<QWidget*, 2> sides{};
  for (std::size_t i = 0; i < 2; ++i) {
    has_stop_[i] = new QCheckBox;
    has_stop_[i]->setObjectName(i == 0 ? "checkLower" : "checkUpper");
    has_stop_[i]->setAccessibleName(i == 0 ? tr("Lower stop") : tr("Upper stop"));
    has_stop_[i]->setToolTip(i == 0 ? tr("Lower stop") : tr("Upper stop"));
    mm_stop_[i] = new ValueField({tr("mm"), 1, -1e5, 1e5, 1.0});
    degree_stop_[i] = new ValueField({QStringLiteral("°"), 1, -720.0, 720.0, 1.0});
    mm_stop_[i]->setObjectName(i == 0 ? "fieldLowerMm" : "fieldUpperMm");
    degree_stop_[i]->setObjectName(i == 0 ? "fieldLowerDegrees" : "fieldUpperDegrees");
    sides[i] = new QWidget;
    auto* row = new QHBoxLayout(sides[i]);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(has_stop_[i]);
    row->addWidget(mm_stop_[i], 1);
    row->addWidget(degree_stop_[i], 1);
    connect(has_stop_[i], &QCheckBox::clicked, this, [this, i] { editStop(i == 1); });
    for (ValueField* field : {mm_stop_[i], degree_stop_[i]})
      connect(field, &ValueField::edited, this, [this, i] { editStop(i == 1); });
  }
  row_ = addRow(section, tr("Stops"), sideBySide({sides[0], sides[1]}));
}

void GuideStops::editStop(bool upper) {
  const workcell::Guide* const now = &shown_;
  const std::size_t side = upper ? 1 : 0;
  std::optional<double> stop;
  if (has_stop_[side]->isChecked())
    stop = now->kind == workcell::GuideKind::kHinge ? kDegree * degree_stop_[side]->value()
                                                    : 1e-3 * mm_stop_[side]->value();
  // A stop that is switched on stands where it makes sense.
  const bool fresh = stop && !(upper ? now->upper : now->lower);
  if (fresh && *stop == 0.0 && upper) stop = now->kind == workcell::GuideKind::kHinge ? 1.2 : 0.1;
  edit_([&](workcell::Guide& guide) { (upper ? guide.upper : guide.lower) = stop; });
}

void GuideStops::show(const workcell::Guide& guide) {
  shown_ = guide;
  const bool turns = guide.kind == workcell::GuideKind::kHinge;
  const double unit = turns ? kDegree : 1e-3;
  row_->setVisible(hasStops(guide.kind));
  for (std::size_t i = 0; i < 2; ++i) {
    const std::optional<double>& stop = i == 0 ? guide.lower : guide.upper;
    has_stop_[i]->setChecked(stop.has_value());
    mm_stop_[i]->setVisible(!turns);
    degree_stop_[i]->setVisible(turns);
    mm_stop_[i]->setEnabled(stop.has_value());
    degree_stop_[i]->setEnabled(stop.has_value());
    (turns ? degree_stop_[i] : mm_stop_[i])->setValue(stop ? *stop / unit : 0.0);
  }
}

}  // namespace hapticell::app
