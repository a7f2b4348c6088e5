// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/module/virtual_desktop_module.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>

#include "app/host/document_model.h"
#include "app/host/hold_choice.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/top_menus.h"
#include "app/style/dock_title_bar.h"
#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/key_cap.h"
#include "app/style/theme.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/virtual_desktop/devices/device_listing.h"
#include "app/virtual_desktop/devices/device_watch.h"
#include "app/virtual_desktop/module/virtual_desktop_controller.h"
#include "app/virtual_desktop/module/virtual_desktop_panel.h"
#include "app/virtual_desktop/widgets/device_check_panel.h"

namespace hapticell::app {
namespace {}  // namespace

VirtualDesktopModule::VirtualDesktopModule() = default;
VirtualDesktopModule::~VirtualDesktopModule() {
  stop();
}

QString VirtualDesktopModule::purpose() const {
  return tr("Hold an entity with the stylus, move it and feel what it touches");
}

void VirtualDesktopModule::start(Host& host) {
  if (controller_) {
    bringToFront(dock_);
    return;
  }
  host_ = &host;
  controller_ = std::make_unique<VirtualDesktopController>(host);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* panel = new VirtualDesktopPanel(host, *controller_);
  scroll->setWidget(panel);
  QObject::connect(panel, &VirtualDesktopPanel::deviceCheckWanted, controller_.get(),
                   [this, panel] { openCheck(*panel); });
  dock_ = makeDock("dockVirtualDesktop", tr("Virtual Desktop"), scroll);
  scroll->setMinimumWidth(332);
  host.addDock(dock_, Qt::RightDockWidgetArea, nullptr);
  // It comes first, the panels that were there are tabs behind it.
  for (QDockWidget* other : host.window().findChildren<QDockWidget*>())
    if (other != dock_ && !other->isFloating() && host.window().dockWidgetArea(other) == Qt::RightDockWidgetArea)
      host.window().tabifyDockWidget(dock_, other);
  host.window().resizeDocks({dock_}, {344}, Qt::Horizontal);
  dock_->raise();
  // Once more when the window stands: before that Qt forgets which tab was raised.
  QTimer::singleShot(0, dock_, &QWidget::raise);
  addPill();
  addKeys();
  addMenu();
  chooseFirstRobot();
  QObject::connect(&host.documentModel(), &DocumentModel::opened, controller_.get(), [this] { chooseFirstRobot(); });
  QObject::connect(&host.selection(), &Selection::changed, controller_.get(),
                   [this](workcell::EntityId entity) { followSelection(entity); });
  QObject::connect(&host.holdChoice(), &HoldChoice::letGoWanted, controller_.get(), &VirtualDesktopController::letGo);
  controller_->connectDevice();
  qApp->installEventFilter(this);
}

void VirtualDesktopModule::stop() {
  if (!controller_) return;
  qApp->removeEventFilter(this);
  delete menu_;
  for (QAction* action : actions_) delete action;
  actions_.clear();
  for (const QPointer<QDockWidget>& dock : {check_dock_, dock_}) {
    if (!dock) continue;
    host_->removeDock(dock);
    delete dock;
  }
  delete pill_;
  pill_button_ = nullptr;
  controller_.reset();
}

void VirtualDesktopModule::openCheck(VirtualDesktopPanel& panel) {
  if (!check_dock_) {
    auto* checks = new DeviceCheckPanel(controller_->lister());
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(checks);
    check_dock_ = makeDock("dockDeviceCheck", tr("Device check"), scroll);
    QObject::connect(check_dock_, &QDockWidget::visibilityChanged, checks, [this, checks](bool seen) {
      if (!seen) return checks->watch().stop();
      checks->watch().start(controller_->serverHost().toStdString(), controller_->serverPort());
    });
    QObject::connect(checks, &DeviceCheckPanel::stylusWanted, controller_.get(),
                     [this](bool wanted) { wanted ? controller_->disconnectDevice() : controller_->connectDevice(); });
    host_->addDock(check_dock_, Qt::RightDockWidgetArea, dock_);
    const auto show = [&panel, checks] { panel.showChecks(*checks); };
    QObject::connect(controller_.get(), &VirtualDesktopController::snapshotChanged, checks, show);
    QObject::connect(controller_.get(), &VirtualDesktopController::connectionChanged, checks, show);
    show();
  }
  bringToFront(check_dock_);
}

void VirtualDesktopModule::chooseFirstRobot() {
  VirtualDesktopSettings settings = controller_->settings();
  settings.entity = 0;
  settings.moved_by = manipulation::MovedBy();
  for (const auto& entity : host_->documentModel().document().state().entities) {
    if (!entity->robot() || entity->locked) continue;
    settings.entity = entity->id;
    settings.on_contact = entity->contact.on_contact;
    settings.force_class = entity->contact.force_class;
    settings.moved_by = HoldChoice::usual(*entity);
    break;
  }
  controller_->change(settings);
  const bool in_front = dock_ && isInFront(*dock_);
  host_->selection().set(settings.entity);
  // Nobody chose it, so this panel stays in front where it was.
  if (!in_front) return;
  QTimer::singleShot(0, dock_, [this] {
    if (dock_) dock_->raise();
  });
}

/// What is chosen in the scene or in the tree is what the stylus takes next.
void VirtualDesktopModule::followSelection(workcell::EntityId entity) {
  const workcell::Entity* chosen = host_->documentModel().document().find(entity);
  if (!chosen || chosen->locked || controller_->snapshot().stylus.held != 0) return;
  VirtualDesktopSettings settings = controller_->settings();
  if (settings.entity == entity) return;
  settings.entity = entity;
  settings.on_contact = chosen->contact.on_contact;
  settings.force_class = chosen->contact.force_class;
  settings.moved_by = HoldChoice::usual(*chosen);
  controller_->change(settings);
}

void VirtualDesktopModule::addPill() {
  pill_ = new QWidget;
  auto* row = new QHBoxLayout(pill_);
  row->setContentsMargins(8, 0, 12, 0);
  pill_button_ = new QPushButton(icon("forces"), {});
  pill_button_->setObjectName("pillForces");
  pill_button_->setCheckable(true);
  pill_button_->setProperty("pill", true);
  pill_button_->setFont(textFont(TextRole::kSection));
  pill_button_->setFixedHeight(32);
  // Wide enough for either word, so that what stands beside it does not jump.
  const QFontMetrics metrics(pill_button_->font());
  pill_button_->setFixedWidth(
      56 + std::max(metrics.horizontalAdvance(tr("Forces on")), metrics.horizontalAdvance(tr("Forces off"))));
  pill_button_->setIconSize(QSize(18, 18));
  pill_key_ = new KeyCap;
  pill_words_ = new QLabel;
  pill_words_->setFont(textFont(TextRole::kSecond));
  pill_words_->setForegroundRole(kQuietText);
  row->addWidget(pill_button_);
  row->addWidget(pill_key_);
  row->setSpacing(6);
  row->addWidget(pill_words_);
  host_->addToToolBar(pill_);
  // It only turns forces off: on is the switch of the panel or Ctrl+Space, never a click that was meant for something
  // else.
  QObject::connect(pill_button_, &QPushButton::clicked, controller_.get(), [this] {
    controller_->setForces(false);
    showPill();
  });
  QObject::connect(controller_.get(), &VirtualDesktopController::snapshotChanged, pill_, [this] { showPill(); });
  QObject::connect(controller_.get(), &VirtualDesktopController::settingsChanged, pill_, [this] { showPill(); });
  showPill();
}

void VirtualDesktopModule::showPill() {
  if (!pill_button_) return;
  const bool on = controller_->snapshot().stylus.forces_on;
  const bool lost = controller_->forceFacts().lost;
  if (on != pill_button_->isChecked() || lost != pill_lost_ || pill_button_->icon().isNull()) {  // Setting it paints.
    const Theme& theme = themeOf(pill_button_->palette());
    const QIcon forces = on ? icon("forces", theme.on_text) : icon("forces");
    pill_button_->setIcon(lost ? icon("warning", theme.contact) : forces);
  }
  pill_lost_ = lost;
  pill_button_->setChecked(on);
  pill_button_->setEnabled(controller_->isConnected());
  pill_button_->setText(on ? tr("Forces on") : tr("Forces off"));
  pill_key_->setText(on ? tr("Esc") : tr("Ctrl+Space"));
  pill_words_->setText(on ? tr("forces off") : tr("turn on"));
}

void VirtualDesktopModule::addKeys() {
  const auto add = [this](const char* name, const QString& text, const QKeySequence& key, auto&& slot) {
    QAction* action = makeAction(&host_->window(), {name, text, {}, key, {}});
    host_->window().addAction(action);
    QObject::connect(action, &QAction::triggered, controller_.get(), slot);
    actions_.push_back(action);
  };
  add("actionForcesOn", tr("Forces on"), QKeySequence(Qt::CTRL | Qt::Key_Space),
      [this] { controller_->setForces(true); });
  add("actionFollow", tr("Stylus follows the mouse"), QKeySequence(Qt::Key_H), [this] {
    MouseStylus& mouse = controller_->mouse();
    mouse.setFollow(!mouse.follow());
    host_->viewport().refresh();
  });
  add("actionMute", tr("Mute"), QKeySequence(Qt::Key_M),
      [this] { controller_->sound().setOn(!controller_->sound().isOn()); });
  add("actionOnContact", tr("Next contact mode"), QKeySequence(Qt::Key_C), [this] {
    const int now = static_cast<int>(controller_->settings().on_contact);
    controller_->setOnContact(static_cast<workcell::OnContact>((now + 1) % 3));
  });
  for (int axis = 0; axis < 3; ++axis)
    add("actionFreeAxis", tr("Free %1 only").arg(QChar('X' + axis)), QKeySequence(Qt::Key_X + axis), [this, axis] {
      VirtualDesktopSettings settings = controller_->settings();
      settings.free = afterKey(settings.free, static_cast<std::size_t>(axis));
      controller_->change(settings);
    });
  const QString scales[]{tr("rough"), tr("medium"), tr("fine"), tr("screen")};
  for (int level = 0; level < 4; ++level)
    add("actionScale", tr("Motion scale, %1").arg(scales[level]), QKeySequence(Qt::Key_1 + level), [this, level] {
      VirtualDesktopSettings settings = controller_->settings();
      settings.scale = static_cast<manipulation::ScaleLevel>(level);
      controller_->change(settings);
    });
}

/// The keys as a menu too.
void VirtualDesktopModule::addMenu() {
  menu_ = topMenu(host_->window(), "menuHaptics", tr("Haptics"));
  menu_->addActions({actions_.begin(), actions_.end()});
  QMenu* collision = topMenu(host_->window(), "menuCollision", QObject::tr("Collision"));
  for (QAction* action : actions_)
    if (action->objectName() == "actionOnContact" || action->objectName() == "actionMute") collision->addAction(action);
}

bool VirtualDesktopModule::handleKey(int key, bool pressed, bool repeated) {
  if (key == Qt::Key_Escape && pressed) {
    // Always, whatever has the focus: forces off first.
    const bool was_on = controller_->forcesWanted() || controller_->snapshot().stylus.forces_on;
    controller_->setForces(false);
    if (!was_on && controller_->mouse().follow()) controller_->mouse().setFollow(false);
    return was_on;
  }
  bool* held = nullptr;
  if (key == Qt::Key_Space) held = &clutch_;
  if (key == Qt::Key_B) held = &button_key_;
  // What was pressed in the scene is let go wherever the pointer is by then.
  if (!held || !(pressed ? *held || host_->typedKeysAct() : *held)) return false;
  if (repeated) return true;
  *held = pressed;
  key == Qt::Key_Space ? controller_->setClutch(pressed) : controller_->mouse().setButton(pressed);
  return true;
}

bool VirtualDesktopModule::eventFilter(QObject* watched, QEvent* event) {
  const bool press = event->type() == QEvent::KeyPress;
  if (controller_ && (press || event->type() == QEvent::KeyRelease) && qobject_cast<QWidget*>(watched)) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool plain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    if ((plain || key->key() == Qt::Key_Escape || !press) && handleKey(key->key(), press, key->isAutoRepeat()))
      return true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace hapticell::app
