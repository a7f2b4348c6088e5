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

/// The second stylus: its own haptic server on a free port, its link, and what it holds. GUI thread.
class SecondStylusControl : public QObject {
  Q_OBJECT
 public:
  /// The owner must outlive it.
  explicit SecondStylusControl(VirtualDesktopController& owner);

  /// See VirtualDesktopController::chooseSecond().
  void choose(const QString& device);
  /// The chosen device; empty: none.
  const QString& profile() const { return profile_; }
  /// See VirtualDesktopController::secondLine().
  QString line() const;
  /// Starts server and link if a device is chosen and the loop runs.
  void start();
  /// Ends its server and removes it from the loop. Call it before the loop ends.
  void drop();
  /// The loop has ended, and the link with it.
  void forgetLink() { link_ = nullptr; }
  /// True if the loop has it, whether it is connected or not.
  bool isThere() const { return link_ != nullptr; }
  /// True if it is connected, and moved by the mouse.
  bool isSimulated() const { return device_ && device_->simulated; }
  bool isConnected() const { return device_.has_value(); }
  /// Sends its settings: if the first one holds a mannequin's hand, the second one holds the other hand.
  void postSettings();
  /// Checks whether it was connected or disconnected; each tick.
  void follow();
  /// Updates its pen as the hand holds it; turns it in the snapshot too.
  void updateMouse(manipulation::SceneSnapshot& snapshot);
  MouseStylus& mouse() { return mouse_; }

 private:
  VirtualDesktopController& owner_;
  QString profile_;
  ServerProcess server_;
  haptic::TcpLink* link_ = nullptr;  // Owned by the loop; only its thread-safe functions are called.
  std::optional<haptic::DeviceDescription> device_;
  MouseStylus mouse_;
};

}  // namespace hapticell::app
