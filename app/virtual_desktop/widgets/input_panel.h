// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "app/virtual_desktop/devices/input_devices.h"

class QLabel;
class QPushButton;

namespace hapticell::app {

class DeviceCombo;
class Segmented;
struct DeviceListing;

/// The rows for glove and 3D mouse: which device, what it does, and the glove's calibration, one pose after another.
class InputPanel : public QWidget {
  Q_OBJECT
 public:
  explicit InputPanel(InputDevices& inputs, QWidget* parent = nullptr);
  /// Sets what is plugged in now.
  void setListing(const DeviceListing& listing);
  /// Whether a free hand may be added for the glove, because the cell has none of its side.
  void setFreeHandMissing(bool missing);
  /// Shows the present state of the devices.
  void refresh();

 signals:
  void freeHandWanted();

 private:
  void addCalibration();
  void stepCalibration();
  void showCalibration();

  InputDevices& inputs_;
  DeviceCombo *glove_, *mouse_;
  QLabel *glove_line_, *mouse_line_, *instruction_;
  QWidget* moves_row_;
  Segmented* moves_;
  QPushButton *calibrate_, *next_, *cancel_, *free_hand_;
  bool free_hand_missing_ = true;
  std::optional<GloveCalibrator> calibrator_;
};

}  // namespace hapticell::app
