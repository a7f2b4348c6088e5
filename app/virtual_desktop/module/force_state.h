// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

#include "app/virtual_desktop/devices/force_reason.h"

namespace hapticell::app {

class VirtualDesktopController;

/// Whether forces are wanted, and what became of them; reports if they went off without a request. GUI thread.
class ForceState {
 public:
  /// The owner must outlive it.
  explicit ForceState(VirtualDesktopController& owner) : owner_(owner) {}

  /// What the user asked for; whether they act is in the snapshot.
  bool areWanted() const { return wanted_; }
  /// They went off because the server is gone.
  bool areLost() const { return lost_; }
  void setWanted(bool on);
  /// Another connection: forces are never on by it.
  void connectionChanged();
  /// The loop begins, or ends.
  void reset();
  /// A snapshot came. `cut`: they went off though nobody asked for it, by the server's safety chain.
  void snapshotCame(bool cut);
  /// They went off because the server is gone.
  void reportLoss();
  ForceFacts facts() const;

 private:
  void reportCut();

  VirtualDesktopController& owner_;
  QElapsedTimer since_snapshot_;
  bool wanted_ = false, cut_ = false, lost_ = false;
};

}  // namespace hapticell::app
