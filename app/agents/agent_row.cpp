// SPDX-License-Identifier: Apache-2.0
#include "app/agents/agent_row.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "app/agents/agent_arrows.h"
#include "app/agents/agent_setup.h"
#include "app/kit/form.h"

namespace hapticell::app {

namespace {

/// Of the slider: a tenth of a weight a step, up to 5. Half: too coarse for helpers; twice: nobody weighs so high.
constexpr double kPerStep = 0.1;
constexpr int kSteps = 50;
/// px
constexpr int kBarWidth = 40, kBarHeight = 6, kNameWidth = 96;

}  // namespace

AgentRow::AgentRow(std::string kind, bool enabled, double weight, QWidget* parent)
    : QWidget(parent), kind_(std::move(kind)) {
  const QString name = agentName(kind_), key = QString::fromStdString(kind_);
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  switch_ = new QCheckBox(name);
  switch_->setObjectName("switchAgent_" + key);
  switch_->setChecked(enabled);
  switch_->setFixedWidth(kNameWidth);
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName("sliderAgent_" + key);
  slider_->setAccessibleName(tr("Weight of %1").arg(name));
  slider_->setRange(0, kSteps);
  slider_->setPageStep(5);
  slider_->setValue(static_cast<int>(std::lround(weight / kPerStep)));
  number_ = makeLive(1, TextRole::kSecond);
  number_->setFixedWidth(34);
  number_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bar_ = new QWidget;
  bar_->setObjectName("barAgent_" + key);
  bar_->setFixedSize(kBarWidth, kBarHeight);
  line->addWidget(switch_);
  line->addWidget(slider_, 1);
  line->addWidget(number_);
  line->addWidget(bar_);
  connect(switch_, &QCheckBox::toggled, this, &AgentRow::changed);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    showWeight();
    emit changed();
  });
  showWeight();
}

bool AgentRow::isOn() const {
  return switch_->isChecked();
}

double AgentRow::weight() const {
  return kPerStep * slider_->value();
}

void AgentRow::setStrength(double strength) {
  if (std::abs(strength - strength_) < 0.01) return;
  strength_ = strength;
  bar_->setToolTip(tr("Wants %1 % of the greatest speed").arg(std::lround(100.0 * strength)));
  update();
}

void AgentRow::showWeight() {
  number_->setText(locale().toString(weight(), 'f', 1));
}

void AgentRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const Theme& theme = themeOf(palette());
  QRectF box(bar_->geometry());
  painter.setBrush(theme.field);
  painter.drawRoundedRect(box, 3, 3);
  // A full bar is the greatest speed; what wants more cannot have it.
  box.setWidth(box.width() * std::clamp(strength_, 0.0, 1.0));
  painter.setBrush(colorOfAgent(kind_, theme));
  if (box.width() >= 1.0) painter.drawRoundedRect(box, 3, 3);
}

}  // namespace hapticell::app
