// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace hapticell::app {

/// Words that change while the panel is used. The room of so many lines is kept whatever they say, so that nothing
/// beside or below them moves; longer words end with "…" and stand whole in the tip. Plain text; no narrowest width.
class LiveLabel : public QLabel {
 public:
  explicit LiveLabel(int lines, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// All words are seen at the width of now.
  bool isWhole() const { return shownLines().join(QLatin1Char(' ')) == text().simplified(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QStringList shownLines() const;
  int lines_;
  QString tip_;
};

}  // namespace hapticell::app
