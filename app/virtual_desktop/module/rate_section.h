// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "app/style/steady_number.h"

class QLabel;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class VirtualDesktopController;

/// Rates of the haptic loop, the collision loop and the window, and the duration of a step. GUI thread.
class RateSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  RateSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void show();

 private:
  Host& host_;
  VirtualDesktopController& controller_;
  QLabel* rates_[3][2];
  /// Shows rates, and milliseconds next to them.
  SteadyNumber steady_rates_[3]{SteadyNumber(0.05), SteadyNumber(0.05), SteadyNumber(0.05)};
  SteadyNumber steady_times_[3]{SteadyNumber(0.3, 0.1), SteadyNumber(0.3, 0.3), SteadyNumber(0.3, 1.0)};
};

}  // namespace hapticell::app
