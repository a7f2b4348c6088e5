// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>

#include "app/virtual_desktop/devices/force_reason.h"

namespace hapticell::app {

class VirtualDesktopController;

/// Whether forces are wanted, and whether they act; reports if they went off without a request. GUI thread.
class ForceState {
 public:
  /// The owner must outlive it.
  explicit ForceState(VirtualDesktopController& owner) : owner_(owner) {}

  /// The user's request; the snapshot says whether they act.
  bool areWanted() const { return wanted_; }
  /// True if they went off because the server is gone.
  bool areLost() const { return lost_; }
  void setWanted(bool on);
  /// There is another connection, which never switches forces on.
  void connectionChanged();
  /// The loop starts or ends.
  void reset();
  /// Takes a snapshot. `cut`: the server's safety chain switched forces off without a request.
  void snapshotCame(bool cut);
  /// Reports that forces went off because the server is gone.
  void reportLoss();
  ForceFacts facts() const;

 private:
  void reportCut();

  VirtualDesktopController& owner_;
  QElapsedTimer since_snapshot_;
  bool wanted_ = false, cut_ = false, lost_ = false;
};

}  // namespace hapticell::app
