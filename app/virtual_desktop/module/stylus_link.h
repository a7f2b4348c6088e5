// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "haptic/client/tcp_link.h"

namespace hapticell::app {

/// The window's side of the first stylus's link, which the loop owns: only its thread-safe functions are called. GUI
/// thread.
class StylusLink {
 public:
  /// The loop has a link now; null: no link any more.
  void set(haptic::TcpLink* link);
  bool isThere() const { return link_ != nullptr; }
  /// A server answers, and this window controls the stylus.
  bool isConnected() const;
  /// A server answers, but another window controls the stylus.
  bool isWatching() const;
  /// A server answers, but accepts no more clients.
  bool isRefused() const;
  void takeOver();
  /// Why there is no connection; empty: unknown.
  haptic::LinkProblem problem() const;
  /// One line: why there is no connection, or that there is one.
  QString line() const;
  const std::optional<haptic::DeviceDescription>& device() const { return device_; }
  bool isSimulated() const { return device_ && device_->simulated; }

  /// True if the connection was made or lost since the last call.
  bool takeConnectionChange();
  /// The same for isWatching().
  bool takeWatchingChange();
  /// A new message of the server about the device; empty: none.
  std::string takeSentence();

 private:
  haptic::TcpLink* link_ = nullptr;
  std::optional<haptic::DeviceDescription> device_;
  std::string told_sentence_;  // The device's message when it was taken last.
  bool was_connected_ = false, was_watching_ = false;
};

}  // namespace hapticell::app
