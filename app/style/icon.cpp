// SPDX-License-Identifier: Apache-2.0
#include "app/style/icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

#include "app/style/theme.h"

namespace hapticell::app {
namespace {

class LineIconEngine final : public QIconEngine {
 public:
  LineIconEngine(QByteArray svg, const QColor& color) : svg_(std::move(svg)), color_(color) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    if (svg_.isEmpty()) return;
    const Theme& theme = themeOf(QApplication::palette());
    QColor color = color_.isValid() ? color_ : theme.text1;
    if (mode == QIcon::Disabled) color = theme.text3;
    QByteArray colored = svg_;
    colored.replace("currentColor", color.name(QColor::HexRgb).toLatin1());
    QSvgRenderer renderer(colored);
    renderer.render(painter, QRectF(rect));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap result(size);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return result;
  }

  QIconEngine* clone() const override { return new LineIconEngine(svg_, color_); }
  bool isNull() override { return svg_.isEmpty(); }

 private:
  QByteArray svg_;
  QColor color_;
};

}  // namespace

QIcon icon(const QString& name) {
  return icon(name, QColor());
}

QIcon icon(const QString& name, const QColor& color) {
  QFile file(":/hapticell/icons/" + name + ".svg");
  QByteArray svg;
  if (file.open(QIODevice::ReadOnly)) svg = file.readAll();
  return QIcon(new LineIconEngine(svg, color));
}

}  // namespace hapticell::app
