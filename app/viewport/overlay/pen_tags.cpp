// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/pen_tags.h"

#include <algorithm>

#include "app/style/fonts.h"
#include "app/viewport/scene/pen_look.h"

namespace hapticell::app {
namespace {

constexpr double kSize = 20.0, kMargin = 4.0;
constexpr double kAway = 14.0;  // Of its middle from the pen's end, along the pen.

QRectF within(QRectF box, const ViewSize& size) {
  box.moveLeft(std::clamp(box.left(), kMargin, std::max(kMargin, size.width - kSize - kMargin)));
  box.moveTop(std::clamp(box.top(), kMargin, std::max(kMargin, size.height - kSize - kMargin)));
  return box;
}

}  // namespace

std::vector<PenTag> penTags(const Overlay& overlay) {
  std::vector<PenTag> tags;
  if (!overlay.scene || !overlay.scene->snapshot()) return tags;
  const manipulation::SceneSnapshot& snapshot = *overlay.scene->snapshot();
  if (!snapshot.stylus.connected || !snapshot.second || !snapshot.second->connected) return tags;
  const double pixel = overlay.camera.metresPerPixel(snapshot.stylus.X_WStylus.p, overlay.size);
  for (const bool second : {false, true}) {
    const Pose& X_WS = second ? snapshot.second->X_WStylus : snapshot.stylus.X_WStylus;
    const dvec3 middle_W = X_WS.p + (penPixels(overlay.size) + kAway) * pixel * X_WS.rotate(stylusDirection_S());
    const auto middle = overlay.camera.project(middle_W, overlay.size);
    if (!middle) continue;
    PenTag tag{second ? 2 : 1, within({middle->x - 0.5 * kSize, middle->y - 0.5 * kSize, kSize, kSize}, overlay.size)};
    if (!tags.empty() && tag.box.intersects(tags[0].box)) {
      const double down = tags[0].box.bottom() + kMargin - tag.box.top();
      tag.box = within(tag.box.translated(0.0, down), overlay.size);
    }
    tags.push_back(tag);
  }
  return tags;
}

void paintPenTags(QPainter& painter, const Overlay& overlay) {
  const Theme& theme = *overlay.theme;
  painter.setFont(textFont(TextRole::kSection));
  for (const PenTag& tag : penTags(overlay)) {
    const auto rgb = penColor(tag.number == 2, theme.dark);
    const QColor body = QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
    painter.setPen(QPen(theme.scene.halo, 3.0));
    painter.setBrush(body);
    painter.drawEllipse(tag.box);
    painter.setPen(theme.dark ? QColor(Qt::black) : QColor(Qt::white));
    painter.drawText(tag.box, Qt::AlignCenter, QString::number(tag.number));
  }
}

}  // namespace hapticell::app
