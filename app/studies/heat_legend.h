// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace hapticell::app {

class VariantView;

/// The colours of the map with the numbers at their ends, worst to best.
class HeatLegend : public QWidget {
 public:
  explicit HeatLegend(const VariantView& view, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {150, 18}; }
  QSize minimumSizeHint() const override { return {110, 18}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const VariantView& view_;
};

}  // namespace hapticell::app
