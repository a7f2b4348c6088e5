// SPDX-License-Identifier: Apache-2.0
// What the Virtual Desktop panel shows of the controller's state.
#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>

#include "app/controls/entity_icon.h"
#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/theme.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "app/viewport/scene/strip_text.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/devices/device_watch.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "app/virtual_desktop/module/virtual_desktop_panel.h"
#include "app/virtual_desktop/widgets/device_check_panel.h"
#include "app/virtual_desktop/widgets/device_combo.h"
#include "app/virtual_desktop/widgets/force_meter.h"
#include "app/virtual_desktop/widgets/input_panel.h"

namespace hapticell::app {
namespace {

/// A key as a cap, what it does beside it.
QString keyLine(const QString& key, const QString& does, const Theme& theme) {
  return QStringLiteral(
             "<tr><td><span style=\"font-size:11px; color:%3; background-color:%4\">&nbsp;%1&nbsp;</span></td>"
             "<td>&nbsp;%2</td></tr>")
      .arg(key, does, theme.text1.name(), theme.line.name());
}

void showMoved(Segmented& moved_by, const VirtualDesktopSettings& settings, const workcell::Entity* entity) {
  constexpr int kTool = 0, kOrigin = 2, kWhole = 5;  // Among the ways offered.
  const bool mannequin = entity && entity->kind == workcell::EntityKind::kMannequin;
  const bool robot = entity && entity->robot && !mannequin;
  for (int i = 0; i < 4; ++i) moved_by.button(i)->setVisible(!entity || (!mannequin && (i < 2) == robot));
  moved_by.button(4)->setVisible(!mannequin);
  for (int i = 5; i < 10; ++i) moved_by.button(i)->setVisible(mannequin);
  const std::span<const manipulation::MovedBy> ways = waysOffered();
  const auto chosen = std::find_if(ways.begin(), ways.end(), [&](const manipulation::MovedBy& way) {
    return manipulation::isSameWay(way, settings.moved_by);
  });
  const int usual = mannequin ? kWhole : robot ? kTool : entity ? kOrigin : -1;
  moved_by.setCurrent(chosen == ways.end() ? usual : static_cast<int>(chosen - ways.begin()));
}

}  // namespace

std::span<const manipulation::MovedBy> waysOffered() {
  using mannequin::Side;
  static const manipulation::MovedBy ways[]{by::Tool{},      by::Base{},  by::Origin{},          by::Center{},
                                            by::Frame{},     by::Whole{}, by::Hand{Side::kLeft}, by::Hand{Side::kRight},
                                            by::BothHands{}, by::Head{}};
  return ways;
}

void VirtualDesktopPanel::listEntities() {
  const workcell::EntityId chosen = controller_.settings().entity;
  entity_->clear();
  entity_->addItem(icon("hand"), tr("What the tip touches"), 0ULL);
  for (const auto& entity : host_.documentModel().document().state().entities) {
    if (entity->locked) continue;
    entity_->addItem(icon(entityIcon(*entity)), QString::fromStdString(entity->name),
                     static_cast<qulonglong>(entity->id));
    if (entity->id == chosen) entity_->setCurrentIndex(entity_->count() - 1);
  }
}

void VirtualDesktopPanel::listSets() {
  against_->clear();
  const auto& sets = host_.documentModel().document().state().pair_sets;
  const auto on = std::count_if(sets.begin(), sets.end(), [](const auto& set) { return set.enabled; });
  against_->addItem(sets.empty() ? tr("Everything") : tr("All sets that are on (%1)").arg(on), QString());
  for (const auto& set : sets) {
    const QString name = QString::fromStdString(set.name);
    against_->addItem(name, name);
  }
  against_->setCurrentIndex(std::max(0, against_->findData(QString::fromStdString(controller_.settings().against))));
}

void VirtualDesktopPanel::listFrames(const workcell::Entity* entity) {
  const VirtualDesktopSettings& settings = controller_.settings();
  moved_frame_->clear();
  if (entity)
    for (const auto& frame : entity->frames) moved_frame_->addItem(icon("frame"), QString::fromStdString(frame.name));
  if (entity && entity->robot)
    for (const auto& link : entity->robot->links)
      moved_frame_->addItem(icon("frame"), QString::fromStdString(link.name));
  moved_by_->setChoiceEnabled(4, moved_frame_->count() > 0, tr("This entity has no frames"));
  moved_frame_->setCurrentText(QString::fromStdString(manipulation::frameOf(settings.moved_by)));
  axes_frame_->clear();
  for (const auto& other : host_.documentModel().document().state().entities)
    axes_frame_->addItem(icon(entityIcon(*other)), QString::fromStdString(other->name));
  axes_frame_->setCurrentText(QString::fromStdString(settings.axes_frame));
}

void VirtualDesktopPanel::mend() {
  using Mend = ForceReason::Mend;
  const Mend how = forceReason(controller_.forceFacts()).mend;
  if (how == Mend::kConnect) controller_.connectDevice();
  if (how == Mend::kStartServer) controller_.startServer();
  if (how == Mend::kTakeStylus) controller_.takeStylus();
  if (how == Mend::kSlide) controller_.setOnContact(workcell::OnContact::kSlide);
  if (how == Mend::kCheck)
    host_.documentModel().execute(workcell::SetProperties{.id = controller_.snapshot().held, .checked = true});
}

void VirtualDesktopPanel::showChecks(DeviceCheckPanel& checks) const {
  ForceFacts facts = controller_.forceFacts();
  facts.device_fault = checks.watch().isConnected() && checks.watch().state().device_fault;
  checks.setReason(forceReason(facts));
  const auto& device = controller_.device();
  checks.setChecks(deviceChecks(
      controller_.serverAddress(), controller_.forceFacts(), device ? &*device : nullptr, controller_.snapshot(),
      {host_.viewport().touchFigures(), host_.viewport().isSoftware(), host_.viewport().lastFrameSeconds()}));
}

void VirtualDesktopPanel::showForces() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  const ForceFacts facts = controller_.forceFacts();
  const ForceReason reason = forceReason(facts);
  forces_->setEnabled(facts.connected);
  forces_->setChecked(facts.connected && facts.wanted);
  forces_state_->setText(reason.state);
  const bool broken = reason.mend != ForceReason::Mend::kNone;
  forces_why_->setText(broken ? tr("Nothing is felt") : reason.why);
  mend_why_->setText(reason.why);
  mend_->setText(reason.button);
  meter_or_mend_->setCurrentIndex(broken ? 1 : 0);
  force_now_->setText(QString::fromStdString(newtons(now.force_n)));
  meter_->setForce(now.force_n);
}

void VirtualDesktopPanel::showSnapshot() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  showForces();
  scale_note_->setText(scaleNote(now.motion_scale));
  if (const auto& device = controller_.device()) {
    const dvec3 low = device->workspace_min, high = device->workspace_max, tip = now.X_DS.p;
    workspace_->setState({low.x, low.y, low.z}, {high.x, high.y, high.z}, {tip.x, tip.y, tip.z}, true);
    const dvec3 size = high - low;
    const auto number = [](double metres) { return lengthText(metres, 0).section(QLatin1Char(' '), 0, 0); };
    const Theme& theme = themeOf(palette());
    const QString keys = keyLine("Space", tr("hold: clutch"), theme) + keyLine("1–4", tr("scale"), theme) +
                         keyLine("C", tr("stop, slide, pass"), theme) + keyLine("B", tr("stylus button"), theme);
    workspace_text_->setText(
        QStringLiteral("%1 × %2 × %3<br>%4<table style=\"margin-top:6px\" cellpadding=\"1\">%5</table>")
            .arg(number(size.x), number(size.y), lengthText(size.z, 0))
            .arg(tr("%1 to the edge").arg(lengthText(now.device_edge_m, 0)), keys));
  } else {
    workspace_->setState({-0.08, -0.065, -0.065}, {0.08, 0.065, 0.065}, {0, 0, 0}, false);
    workspace_text_->setText(tr("No device"));
  }
  second_state_->setText(controller_.secondLine());
  showRates(now);
}

void VirtualDesktopPanel::showRates(const manipulation::SceneSnapshot& now) {
  const double window = controller_.isStarted() ? controller_.guiRate() : 0.0;
  const double hertz[3]{now.server.rate_hz, now.rate_manipulation_hz, window};
  const double times[3]{now.server.late_p99_ms, now.step_p99_ms, 1000.0 * host_.viewport().lastFrameSeconds()};
  const QString words[3]{tr("late %1 ms"), tr("step %1 ms"), tr("frame %1 ms")};
  const auto rate = [](double value) { return value > 0.0 ? tr("%1 Hz").arg(std::lround(value)) : tr("off"); };
  for (int i = 0; i < 3; ++i) {
    const bool idle = now.idle && i > 0;
    if (!idle) steady_rates_[i].take(hertz[i], now.idle ? SteadyNumber::kAtRest : 1.0);
    if (!idle) steady_times_[i].take(times[i], now.idle ? SteadyNumber::kAtRest : 1.0);
    rates_[i][0]->setText(idle ? tr("idle") : rate(steady_rates_[i].shown()));
    rates_[i][1]->setText(words[i].arg(steady_times_[i].shown(), 0, 'f', i == 0 ? 2 : 1));
  }
}

void VirtualDesktopPanel::showSettings() {
  const VirtualDesktopSettings& settings = controller_.settings();
  const workcell::Entity* entity = host_.documentModel().document().find(settings.entity);
  listSets();
  listFrames(entity);
  showMoved(*moved_by_, settings, entity);
  moved_frame_row_->setVisible(std::holds_alternative<by::Frame>(settings.moved_by));
  axes_frame_row_->setVisible(settings.axes == manipulation::AxesMode::kFrame);
  on_contact_->setCurrent(static_cast<int>(settings.on_contact));
  axes_->setCurrent(static_cast<int>(settings.axes));
  scale_->setCurrent(static_cast<int>(settings.scale));
  force_class_->setCurrent(static_cast<int>(settings.force_class));
  for (std::size_t i = 0; i < 6; ++i) free_[i]->setChecked(i < 3 ? settings.free.moves[i] : settings.free.turns[i - 3]);
  const int index = entity_->findData(static_cast<qulonglong>(settings.entity));
  entity_->setCurrentIndex(index >= 0 ? index : 0);
  showMaterial(entity);
  showForces();
}

void VirtualDesktopPanel::showMaterial(const workcell::Entity* entity) {
  material_->setEnabled(entity);
  const std::string key = entity ? entity->material : "steel";
  material_->setCurrentIndex(material_->findData(QString::fromStdString(key)));
  const auto& materials = host_.configuration().materials;
  const auto material = materials.find(key);
  if (material == materials.end()) return;
  stiffness_->setValue(material->second.stiffness / 1000.0);
  damping_->setValue(material->second.damping);
}

void VirtualDesktopPanel::showConnection() {
  const bool connected = controller_.isConnected();
  const Theme& theme = themeOf(palette());
  device_icon_->setPixmap(
      icon(connected ? "check" : "warning", connected ? theme.axis_z : theme.near_miss).pixmap(16, 16));
  device_state_->setText(controller_.deviceLine());
  const auto& device = controller_.device();
  stylus_->setChosen(controller_.deviceProfile());
  second_->setChosen(controller_.secondProfile());
  second_state_->setText(controller_.secondLine());
  second_state_->setVisible(!controller_.secondProfile().isEmpty());
  inputs_->setFreeHandMissing(!controller_.hasFreeHand());
  inputs_->refresh();
  meter_->setDevice(device ? device->continuous_force : 0.0, device ? device->peak_force : 0.0);
  connect_->setText(controller_.isStarted() ? tr("Disconnect") : tr("Connect"));
  showForces();
}

}  // namespace hapticell::app
