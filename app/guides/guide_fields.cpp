// SPDX-License-Identifier: Apache-2.0
#include "app/guides/guide_fields.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "app/guides/detents_text.h"
#include "app/guides/guide_row.h"
#include "app/kit/form.h"
#include "geometry/shapes/pose.h"

namespace hapticell::app {
namespace {

bool hasDetents(workcell::GuideKind kind) {
  return hasStops(kind) && kind != workcell::GuideKind::kScrew;
}

}  // namespace

GuideFields::GuideFields(QVBoxLayout& column, GuideEdit edit, QObject* parent)
    : QObject(parent), edit_(std::move(edit)) {
  QVBoxLayout* section = addSection(column, {});
  addSizes(*section);
  stops_ = new GuideStops(*section, edit_, this);
  addDetents(*section);
  friction_ = field("fieldFriction", {tr("N"), 1, 0.0, 3.0, 0.1}, 1.0, &workcell::Guide::friction);
  addRow(*section, tr("Friction"), friction_);
  addHelp(*section);
  addLocks(*section);
  auto* words = makeLabel(tr("Changes are felt immediately."), TextRole::kSecond, true);
  section->addWidget(words);
}

ValueField* GuideFields::field(const char* name, const ValueField::Format& format, double unit,
                               double workcell::Guide::*what) {
  auto* made = new ValueField(format);
  made->setObjectName(name);
  connect(made, &ValueField::edited, this,
          [this, unit, what](double value) { edit_([&](workcell::Guide& guide) { guide.*what = value * unit; }); });
  return made;
}

void GuideFields::addSizes(QVBoxLayout& section) {
  radius_ = field("fieldRadius", {tr("mm"), 1, 0.1, 1e5, 1.0}, 1e-3, &workcell::Guide::radius);
  radius_row_ = addRow(section, tr("Radius"), radius_);
  pitch_ = field("fieldPitch", {tr("mm/turn"), 2, -1000.0, 1000.0, 0.1}, 1e-3, &workcell::Guide::pitch);
  pitch_row_ = addRow(section, tr("Pitch"), pitch_);
  offset_ = field("fieldOffset", {tr("mm"), 1, 0.0, 1e5, 1.0}, 1e-3, &workcell::Guide::offset);
  offset_row_ = addRow(section, tr("Offset"), offset_);
}

void GuideFields::addDetents(QVBoxLayout& section) {
  detents_ = new QLineEdit;
  detents_->setObjectName("fieldDetents");
  detents_->setToolTip(tr("Snap positions, separated by spaces"));
  detents_row_ = addRow(section, tr("Detents"), detents_);
  detent_width_ = field("fieldDetentWidth", {tr("mm wide"), 1, 0.1, 1000.0, 1.0}, 1e-3, &workcell::Guide::detent_width);
  detent_force_ = field("fieldDetentForce", {tr("N/mm"), 2, 0.0, 0.5, 0.05}, 1e3, &workcell::Guide::detent_stiffness);
  detent_row_ = addRow(section, {}, sideBySide({detent_width_, detent_force_}));
  connect(detents_, &QLineEdit::editingFinished, this, [this] {
    const bool turns = shown_.kind == workcell::GuideKind::kHinge;
    const std::vector<double> places = readDetents(detents_->text(), turns, shown_.detents);
    if (places != shown_.detents) edit_([&](workcell::Guide& guide) { guide.detents = places; });
    showDetents(shown_);
  });
}

void GuideFields::addHelp(QVBoxLayout& section) {
  help_ = new QSlider(Qt::Horizontal);
  help_->setObjectName("sliderHelp");
  help_->setRange(0, 100);
  help_value_ = makeLabel({}, TextRole::kText);
  help_value_->setMinimumWidth(40);
  help_value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  help_row_ = addRow(section, tr("Guidance"), guideRow(help_, {help_value_}));
  connect(help_, &QSlider::sliderReleased, this,
          [this] { edit_([this](workcell::Guide& guide) { guide.help = 5.0 * help_->value(); }); });
  connect(help_, &QSlider::valueChanged, this, [this](int value) {
    help_value_->setText(tr("%1 %").arg(value));
    if (!help_->isSliderDown() && help_->hasFocus())
      edit_([value](workcell::Guide& guide) { guide.help = 5.0 * value; });
  });
}

void GuideFields::addLocks(QVBoxLayout& section) {
  const char* const names[]{"X", "Y", "Z", "A", "B", "C"};
  for (std::size_t i = 0; i < 6; ++i) {
    locks_[i] = new QPushButton(names[i]);
    locks_[i]->setObjectName(QString("lock") + names[i]);
    locks_[i]->setCheckable(true);
    locks_[i]->setMinimumWidth(24);
    locks_[i]->setToolTip(i < 3 ? tr("Held along %1").arg(names[i]) : tr("No rotation about %1").arg("XYZ"[i - 3]));
    locks_[i]->setAccessibleName(locks_[i]->toolTip());
    connect(locks_[i], &QPushButton::clicked, this,
            [this, i](bool on) { edit_([&](workcell::Guide& guide) { guide.locked[i] = on; }); });
  }
  locks_row_ =
      addRow(section, tr("Locked"), sideBySide({locks_[0], locks_[1], locks_[2], locks_[3], locks_[4], locks_[5]}));
}

void GuideFields::show(const workcell::Guide& guide) {
  shown_ = guide;
  radius_->setValue(1e3 * guide.radius);
  pitch_->setValue(1e3 * guide.pitch);
  offset_->setValue(1e3 * guide.offset);
  friction_->setValue(guide.friction);
  detent_width_->setValue(1e3 * guide.detent_width);
  detent_force_->setValue(1e-3 * guide.detent_stiffness);
  const int help = static_cast<int>(std::lround(guide.help / 5.0));
  if (!help_->isSliderDown()) help_->setValue(help);
  help_value_->setText(tr("%1 %").arg(help));
  for (std::size_t i = 0; i < 6; ++i) locks_[i]->setChecked(guide.locked[i]);
  const workcell::GuideKind kind = guide.kind;
  radius_row_->setVisible(kind == workcell::GuideKind::kCircle || kind == workcell::GuideKind::kTube);
  help_row_->setVisible(kind == workcell::GuideKind::kTube);
  pitch_row_->setVisible(kind == workcell::GuideKind::kScrew);
  offset_row_->setVisible(kind == workcell::GuideKind::kSurface);
  locks_row_->setVisible(kind == workcell::GuideKind::kLock);
  stops_->show(guide);
  showDetents(guide);
}

void GuideFields::showDetents(const workcell::Guide& guide) {
  const bool turns = guide.kind == workcell::GuideKind::kHinge;
  detents_row_->setVisible(hasDetents(guide.kind));
  detent_row_->setVisible(hasDetents(guide.kind) && !guide.detents.empty());
  if (!detents_->hasFocus()) detents_->setText(detentsText(guide.detents, turns));
  const std::array<double, 2> example{0.0, turns ? 60.0 * kDegree : 0.12};
  detents_->setPlaceholderText(tr("none; e.g. %1").arg(detentsText(example, turns)));
}

}  // namespace hapticell::app
