// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>

#include "app/viewport/drawing/detail_level.h"
#include "app/virtual_desktop/devices/device_listing.h"
#include "app/virtual_desktop/devices/force_reason.h"
#include "app/virtual_desktop/devices/input_devices.h"
#include "app/virtual_desktop/devices/mouse_stylus.h"
#include "app/virtual_desktop/devices/server_process.h"
#include "app/virtual_desktop/devices/sound_player.h"
#include "app/virtual_desktop/devices/two_pens.h"
#include "app/virtual_desktop/devices/virtual_desktop_settings.h"
#include "haptic/client/tcp_link.h"
#include "manipulation/engine/grasp_keeper.h"
#include "manipulation/engine/manipulation_loop.h"

namespace hapticell::app {

class Host;
class PreparationBar;
struct GlovedHand;

/// Ties the window to the manipulation loop: starts loop and, where none answers, the haptic server; hands the document
/// and the user's choices over as commands; takes the newest snapshot at the window's rate. GUI thread; never waits.
class VirtualDesktopController : public QObject {
  Q_OBJECT
 public:
  explicit VirtualDesktopController(Host& host, QObject* parent = nullptr);
  ~VirtualDesktopController() override;

  void connectDevice();
  void disconnectDevice();
  /// A server answers, and this window has the stylus.
  bool isConnected() const;
  /// A server answers, but another window has the stylus.
  bool isWatching() const;
  /// Takes the stylus from the window that has it.
  void takeStylus();
  bool isStarted() const { return loop_ != nullptr; }
  /// Why there is no connection, or what the device is called; one line.
  QString deviceLine() const;
  const std::optional<haptic::DeviceDescription>& device() const { return device_; }

  const VirtualDesktopSettings& settings() const { return settings_; }
  void change(const VirtualDesktopSettings& settings);
  /// The chosen entity's choice, as a command of the document; without one, of whatever is taken next.
  void setOnContact(workcell::OnContact on_contact);
  void setForceClass(workcell::ForceClass force_class);
  /// Another stylus, simulated or a driver's: ends the own server and starts it anew with that device.
  void chooseDevice(const QString& profile);
  const QString& deviceProfile() const { return profile_; }
  /// A second stylus beside the first, at a server of its own; empty: none. Where the first holds a mannequin's hand
  /// it holds the other one, else what its tip touches.
  void chooseSecond(const QString& device);
  const QString& secondProfile() const { return second_profile_; }
  /// How it is, one line; empty where none is chosen.
  QString secondLine() const;
  /// A hand by itself for the glove, in the middle of the view.
  void addFreeHand();
  bool hasFreeHand() const;
  /// Starts the server now instead of waiting for one.
  void startServer();
  QString serverAddress() const;
  /// Where the haptic server is looked for: what the configuration says until useServer() says otherwise.
  const QString& serverHost() const { return server_host_; }
  int serverPort() const { return server_port_; }
  /// Another station from now on, kept in the user's configuration; connects anew when it was connected.
  void useServer(const QString& host, int port);
  ForceFacts forceFacts() const;
  /// Glove and 3-D mouse.
  InputDevices& inputs() { return inputs_; }
  /// What is plugged in, and what comes and goes.
  DeviceLister& lister() { return lister_; }
  SoundPlayer& sound() { return sound_; }
  void setForces(bool on);
  /// What the user asked for; whether they act is in the snapshot.
  bool forcesWanted() const { return forces_wanted_; }
  void setClutch(bool on);
  /// What is held stays where it is.
  void letGo();
  MouseStylus& mouse() { return mouse_; }
  const manipulation::SceneSnapshot& snapshot() const { return snapshot_; }
  double guiRate() const;

 signals:
  void snapshotChanged();  ///< Ten times a second: for numbers. The scene itself is handed to the host each time.
  void settingsChanged();
  void connectionChanged();

 private:
  int busyPeriod() const;  ///< Milliseconds between two ticks while something moves.
  void tick();
  void takeSnapshot();
  void forgetCell();
  bool isOfCell(const manipulation::SceneSnapshot& snapshot) const;
  void take(const std::vector<manipulation::Result>& results);
  void handleMoved(const manipulation::result::Moved& moved);
  void postDocument();
  void postGuides();
  void postCamera();
  void postSettings();
  void postHand(const haptic::HandTarget& target);
  void helpServer();
  void updateMouse();
  void takeInputs();
  void driveByMouse(double seconds);
  MouseStylus* penOfMouse();
  void settleMouse();
  void poseByGlove();
  void keepGloved(std::vector<double> joints);
  void keepRested();
  void restGlove();
  void endGlove();
  void grasp(const GlovedHand& hand);
  bool mayGrasp(workcell::EntityId entity, workcell::EntityId hand) const;
  void vibrate(const GlovedHand& hand);
  std::vector<double> posedJoints(workcell::EntityId id) const;
  void startSecond();
  void dropSecond();
  void followSecond();
  void postSecondSettings();
  void updateSecondMouse();
  manipulation::MovedBy movedBy() const;
  void tellOfDevice();
  void tellOfPlugged(const ListedDevice& device);
  /// Forces went off though nobody asked for it: by the server's safety chain, or the loop stands still.
  void tellOfCut();
  /// They went off because the server is gone.
  void tellOfLoss();
  void showDevice();
  void updateStrip();
  void takeEntityChoices();
  template <typename Set>
  void choose(const Set& set);
  Pose cameraPose_W() const;
  dquat axes_W() const;

  Host& host_;
  std::unique_ptr<manipulation::ManipulationLoop> loop_;
  haptic::TcpLink* link_ = nullptr;  // Owned by the loop; only its thread-safe questions are asked.
  ServerProcess server_;
  QString server_host_;
  int server_port_ = 0;
  SoundPlayer sound_;
  QString profile_;
  MouseStylus mouse_;
  PreparationBar* preparation_;  // The viewport's.
  InputDevices inputs_;
  DeviceLister lister_;
  QTimer input_timer_;
  std::uint32_t input_buttons_ = 0;
  std::vector<double> gloved_joints_;  // As the glove wants them; how far they came the snapshot says.
  workcell::EntityId closed_ids_ = 0;  // Those up to it are of cells that are closed.
  workcell::EntityId gloved_ = 0;      // The mannequin or free hand that it poses.
  manipulation::GraspKeeper grasp_;
  QString second_profile_;
  ServerProcess second_server_;
  haptic::TcpLink* second_link_ = nullptr;  // Owned by the loop, as link_ is.
  std::optional<haptic::DeviceDescription> second_device_;
  MouseStylus second_mouse_;
  TwoPens pens_{mouse_, second_mouse_};
  std::string told_sentence_;  // The device's, when it was told last.
  QElapsedTimer input_clock_, glove_rests_;
  VirtualDesktopSettings settings_;
  manipulation::SceneSnapshot snapshot_;
  std::optional<haptic::DeviceDescription> device_;
  QTimer timer_;
  QElapsedTimer clock_, connecting_, pressed_, told_, since_snapshot_;
  FrameMeter ticks_;
  bool mouse_is_second_ = false;  // The 3-D mouse, since it is to move entities.
  bool forces_wanted_ = false, forces_cut_ = false, forces_lost_ = false, was_connected_ = false, was_watching_ = false,
       server_tried_ = false, server_worked_ = false;
};

}  // namespace hapticell::app
