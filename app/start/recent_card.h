// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace hapticell::app {

/// A workcell that was opened before, as a button: its picture, its name, when it was saved, and its folder.
class RecentCard : public QAbstractButton {
  Q_OBJECT
 public:
  /// `picture` may be null.
  RecentCard(const QString& path, const QPixmap& picture, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {264, 64}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPixmap picture_;
  QString when_, folder_;
};

}  // namespace hapticell::app
