// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QWidget>
#include <vector>

namespace hapticell::app {

/// Colours for parts: quiet, so that the colours of states stand out.
std::vector<QColor> quietColors();

/// A few quiet colours to choose from, side by side; the chosen one is framed. Arrow keys move the frame. A last field,
/// "…", can offer any other colour.
class SwatchRow : public QWidget {
  Q_OBJECT
 public:
  explicit SwatchRow(std::vector<QColor> colors, QWidget* parent = nullptr);
  /// Frames the swatch of that colour; a colour without a swatch is shown in front of the others.
  void setCurrent(const QColor& color);
  QColor current() const { return current_; }
  /// Adds the field "…" for any other colour.
  void offerOther();
  QSize sizeHint() const override { return {160, 26}; }

 signals:
  void chosen(const QColor& color);
  /// The field "…" was clicked, or Enter was pressed on it.
  void otherWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRect swatch(int index) const;
  int currentIndex() const;
  std::vector<QColor> colors_;
  QColor current_;
  bool offers_other_ = false;
};

}  // namespace hapticell::app
