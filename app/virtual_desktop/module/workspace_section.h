// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QLabel;
class QVBoxLayout;

namespace hapticell::app {

class VirtualDesktopController;
class WorkspaceView;

/// The section *Hand in the device's workspace*. GUI thread.
class WorkspaceSection : public QObject {
  Q_OBJECT
 public:
  /// The controller must outlive it.
  WorkspaceSection(VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void show();

 private:
  VirtualDesktopController& controller_;
  WorkspaceView* workspace_;
  QLabel* text_;
};

}  // namespace hapticell::app
