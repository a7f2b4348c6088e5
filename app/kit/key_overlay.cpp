// SPDX-License-Identifier: Apache-2.0
#include "app/kit/key_overlay.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <set>

#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kRow = 24;
constexpr int kColumn = 340;
constexpr int kOverlayPadding = 20;

}  // namespace

std::vector<KeyLine> keyLines(const QMainWindow& window) {
  std::vector<KeyLine> lines{
      {QStringLiteral("Esc"), QObject::tr("Forces off; otherwise end picking or the tool")},
      {QStringLiteral("Space"), QObject::tr("Hold: move the hand without the entity (clutch)")},
      {QStringLiteral("B"), QObject::tr("Stylus button: hold and release")},
      {QObject::tr("Middle button"), QObject::tr("Rotate the view; with Shift, pan")},
      {QObject::tr("Wheel"), QObject::tr("Zoom to the pointer")},
  };
  std::set<QString> seen;
  for (const QAction* action : window.findChildren<QAction*>()) {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    const QString does = QString(action->text()).remove('&').remove(QChar(0x2026)).section(':', 0, 0);
    if (!key.isEmpty() && !does.isEmpty() && seen.insert(key).second) lines.push_back({key, does});
  }
  return lines;
}

KeyOverlay::KeyOverlay(const QMainWindow& window, QWidget& scene) : QWidget(&scene), window_(window), scene_(scene) {
  setObjectName("keyOverlay");
  setAccessibleName(tr("Keys"));
  setProperty("seeThrough", true);  // Keys act through it.
  hide();
}

void KeyOverlay::toggle() {
  if (isVisible()) return close();
  lines_ = keyLines(window_);
  setGeometry(scene_.rect());
  show();
  raise();
  qApp->installEventFilter(this);
}

void KeyOverlay::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int columns = std::max(1, std::min(3, (width() - 2 * kOverlayPadding) / kColumn));
  const int rows = (static_cast<int>(lines_.size()) + columns - 1) / columns;
  const int wanted_height = (rows + 1) * kRow + 2 * kOverlayPadding;  // The rule stands above the keys.
  const QRect box((width() - columns * kColumn) / 2 - kOverlayPadding, std::max(8, (height() - wanted_height) / 2),
                  columns * kColumn + 2 * kOverlayPadding, std::min(height() - 16, wanted_height));
  QColor fill = theme.dock;
  fill.setAlpha(240);
  drawBox(&painter, box, fill, theme.line, 6);
  const QRect inside = box.adjusted(kOverlayPadding, kOverlayPadding - 4, -kOverlayPadding, 0);
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(theme.text1);
  painter.drawText(inside.left(), inside.top(), inside.width(), kRow, Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(
                       tr("Single keys work while the pointer is over the scene; elsewhere they type text."),
                       Qt::ElideRight, inside.width()));
  for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
    const KeyLine& line = lines_[static_cast<std::size_t>(i)];
    const QRect row(box.left() + kOverlayPadding + (i / rows) * kColumn,
                    box.top() + kOverlayPadding + (1 + i % rows) * kRow, kColumn - 16, kRow);
    painter.setFont(textFont(TextRole::kKeyCap));
    const int cap = std::max(24, painter.fontMetrics().horizontalAdvance(line.key) + 12);
    drawBox(&painter, QRect(row.left(), row.top() + 3, cap, kRow - 6), theme.field, theme.line);
    painter.setPen(theme.text1);
    painter.drawText(QRect(row.left(), row.top() + 3, cap, kRow - 6), Qt::AlignCenter, line.key);
    painter.setFont(textFont(TextRole::kSecond));
    painter.setPen(theme.text2);
    const int indent = std::max(104, cap + 10);
    const QString does = painter.fontMetrics().elidedText(line.does, Qt::ElideRight, row.width() - indent);
    painter.drawText(row.adjusted(indent, 0, 0, 0), Qt::AlignVCenter, does);
  }
}

void KeyOverlay::close() {
  qApp->removeEventFilter(this);
  hide();
}

void KeyOverlay::mousePressEvent(QMouseEvent*) {
  close();
}

bool KeyOverlay::eventFilter(QObject* watched, QEvent* event) {
  // A key that is a shortcut comes as an override only. It closes this and still does what it does (Escape above all);
  // `?` itself does that by its action.
  const bool is_key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (is_key && static_cast<QKeyEvent*>(event)->key() != Qt::Key_Question &&
      static_cast<QKeyEvent*>(event)->key() != Qt::Key_Shift)
    close();
  return QWidget::eventFilter(watched, event);
}

}  // namespace hapticell::app
