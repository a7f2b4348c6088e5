// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace hapticell::app {

class LiveScores;

/// RULA of four bodies by the height of the work, with the present height and the best height for the worst body.
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
