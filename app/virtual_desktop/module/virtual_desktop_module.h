// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <QObject>
#include <QPointer>
#include <memory>
#include <vector>

#include "app/host/module.h"
#include "workcell/entity/entity.h"

class QAction;
class QDockWidget;
class QLabel;
class QPushButton;

namespace hapticell::app {

class VirtualDesktopController;
class VirtualDesktopPanel;

/// The haptic module: moving entities with the stylus and feeling what they touch.
class VirtualDesktopModule : public QObject, public Module {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID HAPTICELL_MODULE_IID)
  Q_INTERFACES(hapticell::app::Module)
 public:
  VirtualDesktopModule();
  ~VirtualDesktopModule() override;
  QString name() const override { return QStringLiteral("Virtual Desktop"); }
  QString iconName() const override { return QStringLiteral("stylus"); }
  QString purpose() const override;
  void start(Host& host) override;
  void stop() override;
  bool isRunning() const override { return controller_ != nullptr; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addKeys();
  void addMenu();
  void addPill();
  void showPill();
  void chooseFirstRobot();
  void followSelection(workcell::EntityId entity);
  void openCheck(VirtualDesktopPanel& panel);
  bool handleKey(int key, bool pressed, bool repeated);

  Host* host_ = nullptr;
  std::unique_ptr<VirtualDesktopController> controller_;
  QPointer<QDockWidget> dock_, check_dock_;
  QPointer<QWidget> pill_;
  QPushButton* pill_button_ = nullptr;
  QLabel* pill_key_ = nullptr;
  QLabel* pill_words_ = nullptr;
  std::vector<QAction*> actions_;
  QPointer<QMenu> menu_;
  bool clutch_ = false, button_key_ = false;  ///< Held down: Space and B.
  bool pill_lost_ = false;
};

}  // namespace hapticell::app
