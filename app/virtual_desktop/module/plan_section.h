// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "app/virtual_desktop/module/plan_control.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class LiveLabel;
class VirtualDesktopController;

/// The section *Planner beside the hand*: the goal, start and stop, the authority that the user gives and the part of it
/// that acts, the state in words. Draws the newest way and the goal in the scene. GUI thread.
class PlanSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  PlanSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);
  /// Removes what it has drawn.
  ~PlanSection() override;

  /// Lists the goals again: entities, frames or the chosen entity have changed.
  void listGoals();
  /// Shows the state; ten times a second.
  void show();

 private:
  void addAuthority(QVBoxLayout& section);
  void takeListed();
  void takePresent();
  void startOrStop();
  void draw();

  Host& host_;
  VirtualDesktopController& controller_;
  QComboBox* goals_;
  QPushButton *listed_, *present_, *start_;
  QSlider* authority_;
  QLabel* given_;
  QProgressBar* acts_;
  LiveLabel* state_;
  std::uint64_t held_ = 0;
};

}  // namespace hapticell::app
