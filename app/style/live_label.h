// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace hapticell::app {

/// A label whose text changes while the panel is used. It always has the height of a fixed number of lines, so that
/// nothing next to or below it moves; the tool tip has all of a longer text. Plain text; no minimum width.
class LiveLabel : public QLabel {
 public:
  explicit LiveLabel(int lines, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// True if the whole text is visible at the present width.
  bool isWhole() const { return shownLines().join(QLatin1Char(' ')) == text().simplified(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QStringList shownLines() const;
  int lines_;
  QString tip_;
};

}  // namespace hapticell::app
