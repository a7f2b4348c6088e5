// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/force_section.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/units.h"
#include "app/viewport/scene/strip_text.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "app/virtual_desktop/widgets/force_meter.h"

namespace hapticell::app {
namespace {

constexpr int kMendHeight = 56;  // Three lines next to the button that fixes it; the meter has the same room.

}  // namespace

ForceSection::ForceSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent)
    : QObject(parent), host_(host), controller_(controller) {
  QVBoxLayout* section = addSection(column, {});
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  forces_ = new QCheckBox;
  forces_->setProperty("switch", "large");
  forces_->setObjectName("switchForces");
  forces_->setAccessibleName(tr("Forces"));
  forces_->setToolTip(tr("Forces on (Ctrl+Space), off (Esc)"));
  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  state_ = makeLabel({}, TextRole::kPanelState);
  why_ = makeLive(2, TextRole::kSecond, true);
  words->addWidget(state_);
  words->addWidget(why_);
  auto* number = new QVBoxLayout;
  number->setSpacing(0);
  force_now_ = makeLabel({}, TextRole::kPanelNumber);
  force_now_->setAlignment(Qt::AlignRight);
  force_now_->setMinimumWidth(70);
  auto* now = makeLabel(tr("now"), TextRole::kSecond, true);
  now->setAlignment(Qt::AlignRight);
  number->addWidget(force_now_);
  number->addWidget(now);
  row->addWidget(forces_);
  row->addLayout(words, 1);
  row->addLayout(number);
  section->addLayout(row);
  meter_ = new ForceMeter;
  auto* mending = new QWidget;
  auto* mending_row = new QHBoxLayout(mending);
  mending_row->setContentsMargins(0, 4, 0, 4);
  mend_why_ = makeLive(3, TextRole::kSecond, true);
  fix_ = new QPushButton;
  fix_->setObjectName("buttonFix");
  fix_->setProperty("main", true);
  mending_row->addWidget(mend_why_, 1);
  mending_row->addWidget(fix_);
  meter_or_fix_ = new QStackedWidget;
  meter_or_fix_->addWidget(meter_);
  meter_or_fix_->addWidget(mending);
  meter_or_fix_->setFixedHeight(kMendHeight);
  section->addWidget(meter_or_fix_);
  connect(fix_, &QPushButton::clicked, this, &ForceSection::fix);
  connect(forces_, &QCheckBox::clicked, this, [this](bool on) {
    controller_.setForces(on);
    show();
  });
}

void ForceSection::show() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  const ForceFacts facts = controller_.forceFacts();
  const ForceReason reason = forceReason(facts);
  forces_->setEnabled(facts.connected);
  forces_->setChecked(facts.connected && facts.wanted);
  state_->setText(reason.state);
  const bool broken = reason.fix != ForceReason::Fix::kNone;
  why_->setText(broken ? tr("No forces felt") : reason.why);
  mend_why_->setText(reason.why);
  fix_->setText(reason.button);
  meter_or_fix_->setCurrentIndex(broken ? 1 : 0);
  force_now_->setText(QString::fromStdString(newtons(now.stylus.force_n)));
  meter_->setForce(now.stylus.force_n);
}

void ForceSection::showDevice() {
  const auto& device = controller_.device();
  meter_->setDevice(device ? device->continuous_force : 0.0, device ? device->peak_force : 0.0);
}

void ForceSection::fix() {
  using Fix = ForceReason::Fix;
  const Fix how = forceReason(controller_.forceFacts()).fix;
  if (how == Fix::kConnect) controller_.connectDevice();
  if (how == Fix::kStartServer) controller_.startServer();
  if (how == Fix::kTakeStylus) controller_.takeStylus();
  if (how == Fix::kSlide) controller_.setOnContact(workcell::OnContact::kSlide);
  if (how == Fix::kCheck)
    host_.documentModel().execute(workcell::SetProperties{.id = controller_.snapshot().stylus.held, .checked = true});
}

}  // namespace hapticell::app
