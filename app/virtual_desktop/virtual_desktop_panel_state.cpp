// SPDX-License-Identifier: Apache-2.0
// What the Virtual Desktop panel shows of the controller's state.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/style/theme.h"
#include "app/viewport/strip_text.h"
#include "app/viewport/viewport_widget.h"
#include "app/virtual_desktop/force_meter.h"
#include "app/virtual_desktop/virtual_desktop_controller.h"
#include "app/virtual_desktop/virtual_desktop_panel.h"

namespace hapticell::app {
namespace {

QString keyLine(const QString& key, const QString& does) {
  return QStringLiteral("<b>%1</b>&nbsp; %2").arg(key, does);
}

}  // namespace

void VirtualDesktopPanel::listEntities() {
  const workcell::EntityId chosen = controller_.settings().entity;
  entity_->clear();
  entity_->addItem(icon("hand"), tr("What the tip touches"), 0ULL);
  for (const auto& entity : host_.documentModel().document().state().entities) {
    if (entity->locked) continue;
    entity_->addItem(icon(entity->robot ? "robot" : "cube"), QString::fromStdString(entity->name),
                     static_cast<qulonglong>(entity->id));
    if (entity->id == chosen) entity_->setCurrentIndex(entity_->count() - 1);
  }
}

void VirtualDesktopPanel::showForces() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  const bool connected = controller_.isConnected();
  const bool wanted = controller_.forcesWanted();
  forces_->setEnabled(connected);
  forces_->setChecked(connected && wanted);
  forces_state_->setText(now.forces_on ? tr("Forces on") : wanted ? tr("Forces wait") : tr("Forces off"));
  QString why = tr("Ctrl+Space turns them on");
  if (!connected) why = tr("No device is connected");
  if (connected && wanted && !now.forces_on) why = tr("Move the stylus into free space");
  if (now.forces_on)
    why = now.force_ramp < 0.999 ? tr("Ramp %1 %").arg(std::lround(100.0 * now.force_ramp)) : tr("Esc turns them off");
  forces_why_->setText(why);
  force_now_->setText(QString::fromStdString(newtons(now.force_n)));
  meter_->setForce(now.force_n);
}

void VirtualDesktopPanel::showSnapshot() {
  const manipulation::SceneSnapshot& now = controller_.snapshot();
  showForces();
  const double scale = now.motion_scale;
  const double hand = scale < 1.0 ? 1.0 / scale : 1.0;
  const double cell = scale < 1.0 ? 1.0 : scale;
  scale_note_->setText(tr("%1 mm of hand → %2 mm in the cell").arg(hand, 0, 'g', 3).arg(cell, 0, 'g', 3));
  if (const auto& device = controller_.device()) {
    const dvec3 low = device->workspace_min, high = device->workspace_max, tip = now.X_DS.p;
    workspace_->setState({low.x, low.y, low.z}, {high.x, high.y, high.z}, {tip.x, tip.y, tip.z}, true);
    const dvec3 size = 1000.0 * (high - low);
    workspace_text_->setText(QStringLiteral("%1 × %2 × %3 mm<br>%4<br><br>%5<br>%6<br>%7<br>%8")
                                 .arg(std::lround(size.x))
                                 .arg(std::lround(size.y))
                                 .arg(std::lround(size.z))
                                 .arg(tr("%1 mm to the edge").arg(std::lround(1000.0 * now.device_edge_m)))
                                 .arg(keyLine("Space", tr("hold: clutch")), keyLine("1–4", tr("scale")),
                                      keyLine("C", tr("stop, slide, pass")), keyLine("B", tr("stylus button"))));
  } else {
    workspace_->setState({-0.08, -0.065, -0.065}, {0.08, 0.065, 0.065}, {0, 0, 0}, false);
    workspace_text_->setText(tr("No device"));
  }
  const auto rate = [](double hertz) { return hertz > 0.0 ? tr("%1 Hz").arg(std::lround(hertz)) : tr("off"); };
  rates_[0][0]->setText(rate(now.rate_haptic_hz));
  rates_[0][1]->setText(tr("late %1 ms").arg(now.late_p99_ms, 0, 'f', 2));
  rates_[1][0]->setText(rate(now.rate_manipulation_hz));
  rates_[1][1]->setText(tr("step %1 ms").arg(now.step_p99_ms, 0, 'f', 1));
  rates_[2][0]->setText(rate(controller_.isStarted() ? controller_.guiRate() : 0.0));
  rates_[2][1]->setText(tr("frame %1 ms").arg(1000.0 * host_.viewport().lastFrameSeconds(), 0, 'f', 1));
}

void VirtualDesktopPanel::showSettings() {
  using Kind = manipulation::MovedBy::Kind;
  const VirtualDesktopSettings& settings = controller_.settings();
  const workcell::Entity* entity = host_.documentModel().document().find(settings.entity);
  const bool robot = entity && entity->robot;
  const bool solid = entity && !entity->robot;
  for (int i = 0; i < 4; ++i) moved_by_->button(i)->setVisible(!entity || (i < 2 ? robot : solid));
  int moved = -1;
  switch (settings.moved_by) {
    case Kind::kTcp:
      moved = 0;
      break;
    case Kind::kBase:
      moved = 1;
      break;
    case Kind::kSelfOrigin:
      moved = 2;
      break;
    case Kind::kGeometricCenter:
      moved = 3;
      break;
    default:
      moved = robot ? 0 : solid ? 2 : -1;
  }
  moved_by_->setCurrent(moved);
  on_contact_->setCurrent(static_cast<int>(settings.on_contact));
  axes_->setCurrent(settings.axes == manipulation::AxesMode::kScreen ? 0 : 1);
  scale_->setCurrent(static_cast<int>(settings.scale));
  force_class_->setCurrent(static_cast<int>(settings.force_class));
  translates_->setChecked(settings.translates);
  rotates_->setChecked(settings.rotates);
  const int index = entity_->findData(static_cast<qulonglong>(settings.entity));
  entity_->setCurrentIndex(index >= 0 ? index : 0);
  showForces();
}

void VirtualDesktopPanel::showConnection() {
  const bool connected = controller_.isConnected();
  const Theme& theme = themeOf(palette());
  device_icon_->setPixmap(icon(connected ? "check" : "info", connected ? theme.axis_z : theme.text2).pixmap(16, 16));
  device_state_->setText(controller_.deviceLine());
  const auto& device = controller_.device();
  stylus_->setText(device ? QString::fromStdString(device->name) : tr("none"));
  meter_->setDevice(device ? device->continuous_force : 0.0, device ? device->peak_force : 0.0);
  connect_->setText(controller_.isStarted() ? tr("Disconnect") : tr("Connect"));
  showForces();
}

}  // namespace hapticell::app
