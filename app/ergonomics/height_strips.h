// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace hapticell::app {

class LiveScores;

/// RULA of four bodies by the height of the work, with where it is now and where the worst body fares best.
class HeightStrips : public QWidget {
  Q_OBJECT
 public:
  explicit HeightStrips(const LiveScores& scores, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {420, 118}; }
  QSize minimumSizeHint() const override { return {300, 118}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const LiveScores& scores_;
};

}  // namespace hapticell::app
