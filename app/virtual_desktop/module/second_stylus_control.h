// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "app/virtual_desktop/devices/mouse_stylus.h"
#include "app/virtual_desktop/devices/server_process.h"
#include "haptic/client/tcp_link.h"
#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::app {

class VirtualDesktopController;

/// The second stylus beside the first: its own haptic server on a free port, its link, what it holds. GUI thread.
class SecondStylusControl : public QObject {
  Q_OBJECT
 public:
  /// The owner must outlive it.
  explicit SecondStylusControl(VirtualDesktopController& owner);

  /// See VirtualDesktopController::chooseSecond().
  void choose(const QString& device);
  /// What is chosen; empty: none.
  const QString& profile() const { return profile_; }
  /// See VirtualDesktopController::secondLine().
  QString line() const;
  /// Starts server and link where one is chosen and the loop runs.
  void start();
  /// Ends its server and takes it out of the loop. Before the loop is gone.
  void drop();
  /// The loop is gone, and the link with it.
  void forgetLink() { link_ = nullptr; }
  /// The loop has it, whether it is connected or not.
  bool isThere() const { return link_ != nullptr; }
  /// Connected, and moved by the mouse.
  bool isSimulated() const { return device_ && device_->simulated; }
  bool isConnected() const { return device_.has_value(); }
  /// Where the first holds a mannequin's hand it holds the other one.
  void postSettings();
  /// Sees to it whether it came or went; each tick.
  void follow();
  /// Its pen as the hand holds it; turns it in the snapshot too.
  void updateMouse(manipulation::SceneSnapshot& snapshot);
  MouseStylus& mouse() { return mouse_; }

 private:
  VirtualDesktopController& owner_;
  QString profile_;
  ServerProcess server_;
  haptic::TcpLink* link_ = nullptr;  // Owned by the loop; only its thread-safe questions are asked.
  std::optional<haptic::DeviceDescription> device_;
  MouseStylus mouse_;
};

}  // namespace hapticell::app
