// SPDX-License-Identifier: Apache-2.0
#include "app/start/recent_card.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>

#include "app/style/fonts.h"
#include "app/style/icon.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr QRect kRecentPicture(6, 6, 92, 52);
constexpr int kRecentWords = 106;  // Pixels from the left.

}  // namespace

RecentCard::RecentCard(const QString& path, const QPixmap& picture, QWidget* parent)
    : QAbstractButton(parent), picture_(picture) {
  const QFileInfo info(path);
  when_ = QLocale().toString(info.lastModified(), tr("d MMM yyyy, HH:mm"));
  folder_ = QDir::toNativeSeparators(info.absolutePath());
  setText(info.completeBaseName());
  setToolTip(QDir::toNativeSeparators(path));
  setAccessibleName(info.completeBaseName());
  setAccessibleDescription(when_ + QStringLiteral(", ") + folder_);
  setFocusPolicy(Qt::StrongFocus);
  setFixedSize(sizeHint());
  setAttribute(Qt::WA_Hover);
}

void RecentCard::paintEvent(QPaintEvent*) {
  const Theme& theme = themeOf(palette());
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const bool lit = underMouse() || hasFocus();
  drawBox(&painter, rect(), lit ? theme.selected_row : theme.dock, hasFocus() ? theme.selection : theme.line, 4);
  if (picture_.isNull()) {
    painter.fillRect(kRecentPicture, theme.header);
    app::icon("cell").paint(&painter, QRect(kRecentPicture.center() - QPoint(11, 11), QSize(22, 22)));
  } else {
    // As much of its middle as has the field's shape.
    QSize part = kRecentPicture.size().scaled(picture_.size(), Qt::KeepAspectRatio);
    const QPoint corner((picture_.width() - part.width()) / 2, (picture_.height() - part.height()) / 2);
    painter.drawPixmap(kRecentPicture, picture_, QRect(corner, part));
  }
  const auto line = [&](int top, TextRole role, const QColor& color, const QString& words, Qt::TextElideMode mode) {
    const QRect place(kRecentWords, top, width() - kRecentWords - 8, 18);
    painter.setPen(color);
    painter.setFont(textFont(role));
    painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(words, mode, place.width()));
  };
  line(5, TextRole::kSection, theme.text1, text(), Qt::ElideRight);
  line(23, TextRole::kSecond, theme.text2, when_, Qt::ElideRight);
  line(40, TextRole::kSecond, theme.text2, folder_, Qt::ElideMiddle);
}

}  // namespace hapticell::app
