// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/overlay_painter.h"

#include <QPainterPath>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/units.h"
#include "app/viewport/drawing/frame.h"
#include "app/viewport/overlay/curve_painter.h"
#include "app/viewport/overlay/overlay_boxes.h"
#include "app/viewport/overlay/pen_tags.h"

namespace hapticell::app {
namespace {

void paintCubeFace(QPainter& painter, const ViewCubeFace& face, const Theme& theme) {
  QPolygonF outline;
  for (const auto& corner : face.corners) outline << point(corner);
  const double light = 0.62 + 0.38 * face.facing;
  const QColor base = theme.dark ? QColor("#8A949E") : QColor("#FFFFFF");
  QColor fill = QColor::fromRgbF(static_cast<float>(base.redF() * light), static_cast<float>(base.greenF() * light),
                                 static_cast<float>(base.blueF() * light));
  fill.setAlpha(235);
  painter.setPen(QPen(theme.dark ? QColor("#20262D") : QColor("#7E8A96"), 1.0));
  painter.setBrush(fill);
  painter.drawPolygon(outline);
}

void paintCubeName(QPainter& painter, const ViewCubeFace& face, bool lit) {
  QPolygonF outline;
  for (const auto& corner : face.corners) outline << point(corner);
  // The name lies in the face.
  const QPolygonF unit({QPointF(0, 0), QPointF(100, 0), QPointF(100, 100), QPointF(0, 100)});
  QTransform into;
  if (face.facing < 0.12 || !QTransform::quadToQuad(unit, outline, into)) return;
  painter.save();
  painter.setTransform(into, true);
  QFont name_font = textFont(TextRole::kText);
  name_font.setPixelSize(24);
  name_font.setWeight(QFont::Bold);
  QPainterPath name;
  const QString text = QObject::tr(face.name);
  if (const double width = textWidth(name_font, text); width > 80.0)
    name_font.setPixelSize(static_cast<int>(24.0 * 80.0 / width));
  name.addText(50.0 - 0.5 * textWidth(name_font, text), 58.5, name_font, text);
  painter.fillPath(name, lit ? QColor(Qt::white) : QColor("#1A2027"));
  painter.restore();
}

void paintCube(QPainter& painter, const Overlay& overlay) {
  const Theme& theme = *overlay.theme;
  const dvec3 corner(-1, -1, -1);
  struct Axis {
    dvec3 end;
    const char* name;
    QColor color;
  };
  const Axis axes[]{{{1.55, -1, -1}, "X", theme.scene.axis_x},
                    {{-1, 1.55, -1}, "Y", theme.scene.axis_y},
                    {{-1, -1, 1.55}, "Z", theme.scene.axis_z}};
  const auto paintAxis = [&](const Axis& axis) {
    const QPointF from = point(overlay.cube.project(corner, overlay.camera));
    const QPointF to = point(overlay.cube.project(axis.end, overlay.camera));
    haloLine(painter, QPolygonF({from, to}), axis.color, 2.0, theme.scene.halo);
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    const QPointF at = to + (length > 1 ? along / length : QPointF(0, -1)) * 9.0;
    painter.setFont(textFont(TextRole::kSection));
    painter.setPen(axis.color);
    painter.drawText(QRectF(at.x() - 8, at.y() - 8, 16, 16), Qt::AlignCenter, QString::fromLatin1(axis.name));
  };
  // An axis that points away from the eye lies behind the cube.
  for (const Axis& axis : axes)
    if (glm::dot(axis.end - corner, overlay.camera.forward_W()) > 0.3) paintAxis(axis);
  for (const ViewCubeFace& face : overlay.cube.visibleFaces(overlay.camera)) {
    paintCubeFace(painter, face, theme);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.on);
  if (overlay.cube_hover)
    for (const auto& patch : overlay.cube.patches(*overlay.cube_hover, overlay.camera))
      painter.drawPolygon(QPolygonF({point(patch[0]), point(patch[1]), point(patch[2]), point(patch[3])}));
  for (const ViewCubeFace& face : overlay.cube.visibleFaces(overlay.camera))
    paintCubeName(painter, face, overlay.cube_hover && glm::length(*overlay.cube_hover - face.normal_W) < 0.5);
  for (const Axis& axis : axes)
    if (glm::dot(axis.end - corner, overlay.camera.forward_W()) <= 0.3) paintAxis(axis);
}

void paintPairs(QPainter& painter, const Overlay& overlay) {
  const Theme& theme = *overlay.theme;
  const manipulation::SceneSnapshot& snapshot = *overlay.scene->snapshot();
  bool contact_done = false;
  bool near_done = false;
  for (const auto& pair : snapshot.pairs) {
    const auto a = overlay.camera.project(pair.p_WA, overlay.size);
    const auto b = overlay.camera.project(pair.p_WB, overlay.size);
    if (!a || !b) continue;
    if (pair.contact && !contact_done) {
      contact_done = true;
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(theme.scene.halo, 5.5));
      painter.drawEllipse(point(*b), 10, 10);
      painter.setPen(QPen(theme.contact, 2.5));
      painter.drawEllipse(point(*b), 10, 10);
    } else if (!pair.contact && !near_done) {
      near_done = true;
      const QColor color = pair.near_miss ? theme.near_miss : theme.text2;
      haloLine(painter, QPolygonF({point(*a), point(*b)}), color, 2.5, theme.scene.halo);
      for (const auto& end : {*a, *b}) {
        painter.setPen(QPen(theme.scene.halo, 1.5));
        painter.setBrush(color);
        painter.drawEllipse(point(end), 4.5, 4.5);
      }
    }
  }
}

void paintForce(QPainter& painter, const Overlay& overlay) {
  const Theme& theme = *overlay.theme;
  const auto force = forceArrow(*overlay.scene->snapshot(), overlay.camera, overlay.size);
  if (!force) return;
  const double length = glm::length(force->tip - force->from);
  const QPointF from = point(force->from);
  const QPointF u = (point(force->tip) - from) / length;
  const QPointF v(-u.y(), u.x());
  const double head = std::min(26.0, 0.6 * length);
  QPolygonF arrow;
  arrow << from + v * 4 << from + u * (length - head) + v * 4 << from + u * (length - head) + v * 11
        << from + u * length << from + u * (length - head) - v * 11 << from + u * (length - head) - v * 4
        << from - v * 4;
  painter.setOpacity(force->opacity);
  painter.setBrush(theme.scene.force);
  painter.setPen(QPen(theme.scene.halo, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolygon(arrow);
  if (const PlacedLabel* place = overlay.placeOf(kForceKey)) {
    const QRectF box(point(place->box.min), point(place->box.max));
    paintBox(painter, box, theme);
    painter.setFont(bold15());
    painter.setPen(theme.text1);
    painter.drawText(box, Qt::AlignCenter, QString::fromStdString(force->number));
  }
  painter.setOpacity(1.0);
}

/// Quiet text with a halo. By shifted copies: glyphs are kept, while the outline of a path is worked out each time and
/// took a third of the overlay.
void haloText(QPainter& painter, const QPointF& place, const QString& text, const Theme& theme) {
  constexpr double kAside = 1.25;
  painter.setPen(theme.scene.halo);
  for (const double x : {-kAside, 0.0, kAside})
    for (const double y : {-kAside, 0.0, kAside})
      if (x != 0.0 || y != 0.0) painter.drawText(place + QPointF(x, y), text);
  painter.setPen(theme.text2);
  painter.drawText(place, text);
}

void paintQuietText(QPainter& painter, const Overlay& overlay) {
  const Theme& theme = *overlay.theme;
  const double cell = floorCell(overlay.camera);
  const bool usual = unitsNow().length == Units::Length::kMillimetre;
  const QString grid =
      usual && cell >= 1.0 ? QObject::tr("Grid %1 m").arg(cell) : QObject::tr("Grid %1").arg(lengthText(cell, 0));
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(theme.text2);
  QString missing = overlay.missing_parts == 0
                        ? QString()
                        : QObject::tr("  ·  preparing %n parts", nullptr, static_cast<int>(overlay.missing_parts));
  if (overlay.simplified) missing += QObject::tr("  ·  Simplified while moving");
  const QRectF strip = stripsBox(overlay.strips, overlay.size);
  const bool under_strip = 14 + textWidth(textFont(TextRole::kSecond), grid + missing) + 8 > strip.left();
  const double base = !strip.isEmpty() && under_strip ? strip.top() - 8 : overlay.size.height - 17;
  haloText(painter, {14, base}, grid + missing, theme);
  if (overlay.hint.isEmpty()) return;
  const double above = strip.isEmpty() ? 34.0 : overlay.size.height - strip.top() + 26.0;
  const double width = textWidth(textFont(TextRole::kSecond), overlay.hint) + 20.0;
  const QRectF box(std::round(0.5 * (overlay.size.width - width)), overlay.size.height - above - 14.0, width, 22);
  paintBox(painter, box, theme);
  painter.setPen(theme.text1);
  painter.drawText(box, Qt::AlignCenter, overlay.hint);
}

void paintEmpty(QPainter& painter, const Overlay& overlay) {
  const Theme& theme = *overlay.theme;
  const QPointF middle(0.5 * overlay.size.width, overlay.empty_height * overlay.size.height);
  painter.setPen(QPen(theme.text3, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  const QPointF c = middle - QPointF(0, 60);
  painter.drawPolygon(QPolygonF({c + QPointF(0, -34), c + QPointF(32, -16), c + QPointF(32, 20), c + QPointF(0, 38),
                                 c + QPointF(-32, 20), c + QPointF(-32, -16)}));
  painter.drawPolyline(QPolygonF({c + QPointF(-32, -16), c + QPointF(0, 2), c + QPointF(32, -16)}));
  painter.drawLine(c + QPointF(0, 2), c + QPointF(0, 38));
  painter.setFont(textFont(TextRole::kPanelState));
  painter.setPen(theme.text1);
  painter.drawText(QRectF(middle.x() - 300, middle.y(), 600, 24), Qt::AlignCenter, overlay.empty->title);
  painter.setFont(textFont(TextRole::kText));
  painter.setPen(theme.text2);
  painter.drawText(QRectF(middle.x() - 300, middle.y() + 26, 600, 44),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, overlay.empty->how);
}

/// Beside the pointer, on the side where there is room.
QRectF hoverBox(const Overlay& overlay) {
  constexpr double kBeside = 16.0, kHeight = 24.0;
  const double width = std::ceil(textWidth(textFont(TextRole::kSecond), overlay.hover_name)) + 20.0;
  const QPointF place = overlay.hover_place;
  const bool left = place.x() + kBeside + width > overlay.size.width - 4.0;
  const bool above = place.y() + kBeside + kHeight > overlay.size.height - 4.0;
  return {std::round(left ? std::max(4.0, place.x() - kBeside - width) : place.x() + kBeside),
          std::round(above ? place.y() - kBeside - kHeight : place.y() + kBeside), width, kHeight};
}

void paintHoverName(QPainter& painter, const Overlay& overlay) {
  paintBox(painter, hoverBox(overlay), *overlay.theme);
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(overlay.theme->text1);
  painter.drawText(hoverBox(overlay), Qt::AlignCenter, overlay.hover_name);
}

void paintRubberBand(QPainter& painter, const Overlay& overlay) {
  QColor fill = overlay.theme->selection;
  fill.setAlpha(28);
  painter.setBrush(fill);
  painter.setPen(QPen(overlay.theme->selection, 1.5, overlay.box_touching ? Qt::DashLine : Qt::SolidLine));
  painter.drawRect(*overlay.box);
}

}  // namespace

PixelBox emptyBox(const ViewSize& size, double height) {
  const glm::dvec2 middle(0.5 * size.width, height * size.height);
  return {middle - glm::dvec2(250.0, 96.0), middle + glm::dvec2(250.0, 60.0)};
}

std::vector<QRectF> overlayPieces(const Overlay& overlay) {
  const double reach = 2.9 * overlay.cube.halfEdge();
  std::vector<QRectF> pieces{{overlay.cube.center().x - reach, overlay.cube.center().y - reach, 2 * reach, 2 * reach}};
  const double bottom = 100.0 + (overlay.strips.size() > 1 ? stripsBox(overlay.strips, overlay.size).height() : 0.0);
  pieces.emplace_back(0, overlay.size.height - bottom, overlay.size.width, bottom);
  if (overlay.view_strip) pieces.push_back(overlay.view_strip->box().adjusted(-2, -2, 2, 2));
  if (overlay.box) pieces.push_back(overlay.box->adjusted(-2, -2, 2, 2));
  if (!overlay.hover_name.isEmpty()) pieces.push_back(hoverBox(overlay).adjusted(-2, -2, 2, 2));
  if (overlay.empty)
    pieces.emplace_back(0.5 * overlay.size.width - 320, overlay.empty_height * overlay.size.height - 120, 640, 220);
  QRectF curves;
  for (const SceneCurve& curve : overlay.curves) curves = curves.united(curveBox(curve, overlay.camera, overlay.size));
  if (!curves.isEmpty()) pieces.push_back(curves);
  QRectF middle;
  const auto add = [&middle](const QPointF& p, double room) {
    middle = middle.united(QRectF(p.x() - room, p.y() - room, 2 * room, 2 * room));
  };
  for (const PenTag& tag : penTags(overlay)) pieces.push_back(tag.box.adjusted(-2, -2, 2, 2));
  for (const PlacedLabel& place : overlay.places) {
    add(point(place.anchor), 20);
    middle = middle.united(QRectF(point(place.box.min), point(place.box.max)).adjusted(-4, -4, 4, 4));
  }
  if (overlay.scene && overlay.scene->snapshot()) {
    const manipulation::SceneSnapshot& snapshot = *overlay.scene->snapshot();
    for (const auto& pair : snapshot.pairs)
      for (const dvec3& p_WQ : {pair.p_WA, pair.p_WB})
        if (const auto p = overlay.camera.project(p_WQ, overlay.size)) add(point(*p), 20);
    if (const auto force = forceArrow(snapshot, overlay.camera, overlay.size)) {
      add(point(force->from), 20);
      add(point(force->tip), 20);
    }
  }
  if (!middle.isEmpty())
    pieces.push_back(middle.intersected(QRectF(0, 0, overlay.size.width, overlay.size.height - bottom)));
  return pieces;
}

void paintOverlay(QPainter& painter, const Overlay& overlay) {
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  if (overlay.empty) paintEmpty(painter, overlay);
  for (const SceneCurve& curve : overlay.curves)
    paintCurve(painter, curve, overlay.camera, overlay.size, *overlay.theme);
  paintCube(painter, overlay);
  if (overlay.scene && overlay.scene->snapshot()) {
    paintPenTags(painter, overlay);
    paintPairs(painter, overlay);
    paintForce(painter, overlay);
  }
  for (std::size_t i = 0; i < overlay.curves.size(); ++i)
    if (const PlacedLabel* place = overlay.placeOf(kCurveKeys + i))
      paintCurveText(painter, overlay.curves[i], QRectF(point(place->box.min), point(place->box.max)), *overlay.theme);
  for (const PlacedLabel& place : overlay.places)
    for (const OverlayLabel& label : overlay.labels)
      if (label.key == place.key) paintLabel(painter, label, place, *overlay.theme);
  paintStrips(painter, overlay.strips, overlay.size, *overlay.theme);
  if (overlay.box) paintRubberBand(painter, overlay);
  if (overlay.view_strip) overlay.view_strip->paint(painter, *overlay.theme, overlay.view_strip_hover);
  paintQuietText(painter, overlay);
  if (!overlay.hover_name.isEmpty()) paintHoverName(painter, overlay);
}

}  // namespace hapticell::app
