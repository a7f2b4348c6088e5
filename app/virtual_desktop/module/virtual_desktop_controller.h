// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "app/viewport/drawing/detail_level.h"
#include "app/virtual_desktop/devices/device_listing.h"
#include "app/virtual_desktop/devices/sound_player.h"
#include "app/virtual_desktop/devices/two_pens.h"
#include "app/virtual_desktop/devices/virtual_desktop_settings.h"
#include "app/virtual_desktop/module/force_state.h"
#include "app/virtual_desktop/module/input_control.h"
#include "app/virtual_desktop/module/loop_feed.h"
#include "app/virtual_desktop/module/mouse_hand.h"
#include "app/virtual_desktop/module/plan_control.h"
#include "app/virtual_desktop/module/second_stylus_control.h"
#include "app/virtual_desktop/module/station_server.h"
#include "app/virtual_desktop/module/stylus_link.h"
#include "manipulation/engine/manipulation_loop.h"

namespace hapticell::app {

class Host;
class PreparationBar;

/// Connects the window with the manipulation loop: starts the loop and, if no haptic server answers, a server; passes
/// the document and the user's choices on as commands; takes the newest snapshot at the window's rate. Each part
/// (StationServer, SecondStylusControl, InputControl …) has its own file. GUI thread; never waits.
class VirtualDesktopController : public QObject {
  Q_OBJECT
 public:
  explicit VirtualDesktopController(Host& host, QObject* parent = nullptr);
  ~VirtualDesktopController() override;

  void connectDevice();
  void disconnectDevice();
  /// A server answers, and this window controls the stylus.
  bool isConnected() const { return link_.isConnected(); }
  /// A server answers, but another window controls the stylus.
  bool isWatching() const { return link_.isWatching(); }
  /// Takes control of the stylus from the window that has it.
  void takeStylus() { link_.takeOver(); }
  bool isStarted() const { return loop_ != nullptr; }
  /// One line: why there is no connection, or the name of the device.
  QString deviceLine() const { return link_.line(); }
  const std::optional<haptic::DeviceDescription>& device() const { return link_.device(); }

  const VirtualDesktopSettings& settings() const { return settings_; }
  void change(const VirtualDesktopSettings& settings);
  /// Changes the settings by `edit`.
  void edit(const std::function<void(VirtualDesktopSettings&)>& edit);
  /// Sets the chosen entity's contact mode, as a command of the document; without an entity, for whatever is held next.
  void setOnContact(workcell::OnContact on_contact);
  void setForceClass(workcell::ForceClass force_class);
  /// Chooses another stylus, simulated or of a driver: restarts the own server with that device.
  void chooseDevice(const QString& profile);
  const QString& deviceProfile() const { return station_.profile(); }
  /// Chooses a second stylus with its own server; empty: none. If the first one holds a mannequin's hand, the second
  /// one holds the other hand, else what its tip touches.
  void chooseSecond(const QString& device) { second_.choose(device); }
  const QString& secondProfile() const { return second_.profile(); }
  /// One line about its state; empty if none is chosen.
  QString secondLine() const { return second_.line(); }
  /// Adds a free hand for the glove, in the middle of the view.
  void addFreeHand() { inputs_.addFreeHand(); }
  bool hasFreeHand() const { return inputs_.hasFreeHand(); }
  /// Starts the server now instead of waiting for one.
  void startServer() { station_.start(); }
  QString serverAddress() const { return station_.address(); }
  /// Address of the haptic server: from the configuration, until useServer() changes it.
  const QString& serverHost() const { return station_.host(); }
  int serverPort() const { return station_.port(); }
  /// Changes to another station and stores it in the user's configuration; reconnects if it was connected.
  void useServer(const QString& host, int port);
  ForceFacts forceFacts() const { return forces_.facts(); }
  /// Glove and 3-D mouse.
  InputDevices& inputs() { return inputs_.devices(); }
  /// The plugged-in devices, and changes of them.
  DeviceLister& lister() { return lister_; }
  SoundPlayer& sound() { return sound_; }
  void setForces(bool on);
  /// The user's request; the snapshot says whether forces act.
  bool forcesWanted() const { return forces_.areWanted(); }
  void setClutch(bool on);
  /// Releases what is held; it stays where it is.
  void letGo();
  MouseStylus& mouse() { return mouse_.stylus(); }
  /// The planner beside the hand.
  PlanControl& plan() { return plan_; }
  const manipulation::SceneSnapshot& snapshot() const { return snapshot_; }
  double guiRate() const;

  // For its parts.
  Host& host() { return host_; }
  /// Null: not started.
  manipulation::ManipulationLoop* loop() { return loop_.get(); }
  const StylusLink& link() const { return link_; }
  /// As in HoldChoice; while a second stylus holds the other hand, the trunk does not move.
  manipulation::MovedBy movedBy() const;
  dquat axes_W() const { return feed_.axes_W(); }
  void postCamera() const { feed_.postCamera(); }
  void postSettings();

 signals:
  void snapshotChanged();  ///< Ten times a second, for numbers. The host gets the scene itself each time.
  void settingsChanged();
  void connectionChanged();

 private:
  int busyPeriod() const;  ///< Milliseconds between two ticks while something moves.
  void followHost();
  void tick();
  void followConnection();
  void takeSnapshot();
  void forgetCell();
  void take(const std::vector<manipulation::Result>& results);
  void handleMoved(const manipulation::result::Moved& moved);
  void reportConnectedDevice(const ListedDevice& device);
  void showDevice();
  void updateStrip();
  void takeEntityChoices();
  template <typename Set>
  void choose(const Set& set);

  Host& host_;
  std::unique_ptr<manipulation::ManipulationLoop> loop_;
  StylusLink link_;
  StationServer station_;
  SoundPlayer sound_;
  MouseHand mouse_;
  PreparationBar* preparation_;  // Owned by the viewport.
  SecondStylusControl second_;
  InputControl inputs_;
  DeviceLister lister_;
  LoopFeed feed_;
  ForceState forces_;
  PlanControl plan_;
  TwoPens pens_{mouse_.stylus(), second_.mouse()};
  VirtualDesktopSettings settings_;
  manipulation::SceneSnapshot snapshot_;
  QTimer timer_;
  QElapsedTimer clock_, told_;
  FrameMeter ticks_;
};

}  // namespace hapticell::app
