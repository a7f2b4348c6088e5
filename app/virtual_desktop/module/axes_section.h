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

/// The section *Axes and scale*: along whose axes the hand moves, which of them are free, and how far. GUI thread.
class AxesSection : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  AxesSection(Host& host, VirtualDesktopController& controller, QVBoxLayout& column, QObject* parent = nullptr);

  void showSettings();
  /// How far what is held moves, a millimetre of the hand.
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
