// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <QPainter>
#include <vector>

#include "app/style/theme.h"

namespace hapticell::app {

/// One choice of the view strip: the present choice, and the menu to change it.
struct ViewStripCell {
  QString text;
  QMenu* menu = nullptr;  ///< Not owned; must outlive the time it is shown.
};

/// The strip at the top left of the viewport that shows and sets how the scene is drawn. Painted over the scene, so it
/// takes no keyboard focus; the View menu has the same choices. Pixels at 100 %, origin top left of the viewport.
class ViewStrip {
 public:
  void setCells(std::vector<ViewStripCell> cells) { cells_ = std::move(cells); }
  const std::vector<ViewStripCell>& cells() const { return cells_; }
  /// Empty without cells.
  QRectF box() const;
  QRectF cellBox(std::size_t cell) const;
  /// Index of the cell at this position, or -1.
  int cellAt(const QPointF& place) const;
  /// `hovered`: index of the cell under the pointer, or -1.
  void paint(QPainter& painter, const Theme& theme, int hovered) const;

 private:
  std::vector<ViewStripCell> cells_;
};

}  // namespace hapticell::app
