// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/virtual_desktop/force_reason.h"

namespace hapticell::app {

/// The device check: one row a check, its mark, what was found.
class DeviceCheckPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DeviceCheckPanel(QWidget* parent = nullptr);
  void setChecks(std::vector<DeviceCheck> checks);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<DeviceCheck> checks_;
};

}  // namespace hapticell::app
