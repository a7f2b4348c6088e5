// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QProxyStyle>

namespace hapticell::app {

/// Fusion with the program's sizes: fields of 26 px, corners of 4 px, flat buttons, underlined tabs, a 2 px bar on the
/// selected row, a focus frame in the selection colour, and a switch for every check box whose property `switch` is
/// true. A button whose property `main` is true is the one main button of its panel; with `quiet`, a button has no
/// frame until hovered.
class ProxyStyle : public QProxyStyle {
 public:
  ProxyStyle();

  void polish(QWidget* widget) override;
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
  using QProxyStyle::polish;
  /// Makes the wheel scroll the panel around a slider or a choice, and change these only if they have the focus.
  bool eventFilter(QObject* watched, QEvent* event) override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;
  QRect subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
};

}  // namespace hapticell::app
