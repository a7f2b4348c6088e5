// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace hapticell::app {

/// The present force relative to the device's continuous and peak force; the ends are drawn as limits.
class ForceMeter : public QWidget {
  Q_OBJECT
 public:
  explicit ForceMeter(QWidget* parent = nullptr);
  void setDevice(double continuous_n, double peak_n);
  void setForce(double newtons);
  QSize sizeHint() const override { return {200, 34}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double continuous_ = 0.0, peak_ = 0.0, force_ = 0.0;
};

/// The stylus in the device's workspace: a box in perspective, the tip, and its plumb line to the floor.
class WorkspaceView : public QWidget {
  Q_OBJECT
 public:
  explicit WorkspaceView(QWidget* parent = nullptr);
  /// Corners of the workspace and the tip, metres in the device's frame.
  void setState(const double (&min)[3], const double (&max)[3], const double (&tip)[3], bool known);
  QSize sizeHint() const override { return {150, 110}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPointF place(double x, double y, double z) const;
  double min_[3]{-0.08, -0.065, -0.065}, max_[3]{0.08, 0.065, 0.065}, tip_[3]{};
  bool known_ = false;
};

}  // namespace hapticell::app
