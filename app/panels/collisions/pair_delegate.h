// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>

namespace hapticell::app {

/// Paints the pair table: mark and word of the state, the distance with a bar and the near-miss threshold in it, and
/// the switch of the last column.
class PairDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  /// Widths in pixels for the number of a distance and for its bar; the bar is left out if there is no room.
  static constexpr int kDistanceRoom = 86, kBarRoom = 82;
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace hapticell::app
