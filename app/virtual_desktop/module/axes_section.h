// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>

class QAbstractButton;
class QComboBox;
class QLabel;
class QWidget;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class VirtualDesktopController;
class Segmented;

/// The section *Axes and scale*: whose axes the hand moves along, which are free, and the motion scale. GUI thread.
class AxesSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  AxesSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void showSettings();
  /// Shows how far the held entity moves per millimetre of the hand.
  void showScale();

 private:
  void listFrames();

  Host& host_;
  VirtualDesktopController& controller_;
  Segmented *axes_, *scale_;
  QComboBox* axes_frame_;
  QWidget* axes_frame_row_;
  std::array<QAbstractButton*, 6> free_{};
  QLabel* scale_note_;
};

}  // namespace hapticell::app
