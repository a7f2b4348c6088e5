// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "haptic/client/tcp_link.h"

namespace hapticell::app {

/// The window's side of the first stylus's link, which the loop owns: only its thread-safe questions are asked. GUI
/// thread.
class StylusLink {
 public:
  /// The loop has a link now; null: none any more.
  void set(haptic::TcpLink* link);
  bool isThere() const { return link_ != nullptr; }
  /// A server answers, and this window has the stylus.
  bool isConnected() const;
  /// A server answers, but another window has the stylus.
  bool isWatching() const;
  /// A server answers, and it wants no client more.
  bool isRefused() const;
  void takeOver();
  /// Why there is no connection; empty: it is not known.
  haptic::LinkProblem problem() const;
  /// Why there is no connection, or that there is one; one line.
  QString line() const;
  const std::optional<haptic::DeviceDescription>& device() const { return device_; }
  bool isSimulated() const { return device_ && device_->simulated; }

  /// Connected since this was asked last, or no more.
  bool takeConnectionChange();
  /// The same for isWatching().
  bool takeWatchingChange();
  /// What the server says newly of the device; empty: nothing.
  std::string takeSentence();

 private:
  haptic::TcpLink* link_ = nullptr;
  std::optional<haptic::DeviceDescription> device_;
  std::string told_sentence_;  // The device's, when it was taken last.
  bool was_connected_ = false, was_watching_ = false;
};

}  // namespace hapticell::app
