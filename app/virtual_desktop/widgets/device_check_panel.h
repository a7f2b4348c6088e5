// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/virtual_desktop/devices/force_reason.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace hapticell::app {

class CalibrationSection;
class DeviceLister;
class DeviceWatch;
class RangeView;
class RateGraph;
struct DeviceListing;

/// The checks, one per row: its mark, and the result.
class CheckRows : public QWidget {
  Q_OBJECT
 public:
  explicit CheckRows(QWidget* parent = nullptr);
  void setChecks(std::vector<DeviceCheck> checks);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<DeviceCheck> checks_;
};

/// The device check page: why there is no force, the checks, rate and lateness, range of motion and buttons, a force
/// test that asks first, the devices plugged in and how to fix their problems, versions. GUI thread.
class DeviceCheckPanel : public QWidget {
  Q_OBJECT
 public:
  /// `lister` must outlive it.
  explicit DeviceCheckPanel(DeviceLister& lister, QWidget* parent = nullptr);
  void setChecks(std::vector<DeviceCheck> checks);
  /// Sets the line that says why there is no force, or that there is one.
  void setReason(const ForceReason& reason);
  DeviceWatch& watch() { return *watch_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 signals:
  /// The force test needs the stylus for itself: its controller must release it (true), and may take it again (false).
  void stylusWanted(bool wanted);

 private:
  void addReason(QVBoxLayout& column);
  void addRates(QVBoxLayout& column);
  void addRange(QVBoxLayout& column);
  void addForceTest(QVBoxLayout& column);
  void addCalibration(QVBoxLayout& column);
  void addPlugged(QVBoxLayout& column);
  void showWatch();
  void showForceTest();
  void showListing();
  void fitHeight();
  void addDeviceRow(const QString& title, const QString& detail, const QString& fix, bool good);

  QLabel *state_ = nullptr, *why_ = nullptr;
  CheckRows* rows_ = nullptr;
  RateGraph* graph_ = nullptr;
  RangeView* range_ = nullptr;
  CalibrationSection* calibration_ = nullptr;
  QLabel *force_words_ = nullptr, *versions_ = nullptr, *looking_ = nullptr;
  QPushButton *force_ask_ = nullptr, *force_go_ = nullptr, *force_stop_ = nullptr;
  QVBoxLayout* plugged_ = nullptr;
  DeviceWatch* watch_ = nullptr;
  DeviceLister& lister_;
  bool asked_ = false;
  QString force_result_;
};

}  // namespace hapticell::app
