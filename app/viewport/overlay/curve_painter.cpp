// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/overlay/curve_painter.h"

#include <QFontMetricsF>
#include <cmath>

#include "app/style/fonts.h"

namespace hapticell::app {
namespace {

constexpr double kDisc = 4.5;
constexpr double kRoom = 8.0;

QColor colorOf(SceneCurve::Role role, const Theme& theme) {
  switch (role) {
    case SceneCurve::Role::kGuide:
      return theme.scene.guide;
    case SceneCurve::Role::kGuideOff:
      return theme.text3;
    case SceneCurve::Role::kSelection:
      return theme.selection;
    case SceneCurve::Role::kAxisX:
      return theme.scene.axis_x;
    case SceneCurve::Role::kAxisY:
      return theme.scene.axis_y;
    case SceneCurve::Role::kAxisZ:
      return theme.scene.axis_z;
    case SceneCurve::Role::kLimit:
      return theme.limit;
    case SceneCurve::Role::kContact:
      return theme.contact;
    case SceneCurve::Role::kNearMiss:
      return theme.near_miss;
    case SceneCurve::Role::kMeasure:
      return theme.scene.force;
  }
  return theme.text2;
}

}  // namespace

std::vector<QPolygonF> seenRuns(const SceneCurve& curve, const Camera& camera, const ViewSize& size) {
  std::vector<QPolygonF> runs(1);
  for (const dvec3& p_W : curve.points_W) {
    const auto p = camera.project(p_W, size);
    if (p && std::abs(p->x) < 1e5 && std::abs(p->y) < 1e5)
      runs.back() << QPointF(p->x, p->y);
    else if (!runs.back().isEmpty())
      runs.emplace_back();
  }
  return runs;
}

QSizeF curveTextSize(const SceneCurve& curve) {
  const QFontMetricsF metrics(textFont(TextRole::kSecond));
  return {std::ceil(metrics.horizontalAdvance(QString::fromStdString(curve.text)) + 12.0), 20.0};
}

std::optional<QPointF> curveTextPoint(const SceneCurve& curve, const Camera& camera, const ViewSize& size) {
  if (curve.text.empty()) return std::nullopt;
  const auto runs = seenRuns(curve, camera, size);
  return runs.back().isEmpty() ? std::nullopt : std::optional(runs.back().back());
}

void paintCurveText(QPainter& painter, const SceneCurve& curve, const QRectF& box, const Theme& theme) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.scene.label_box);
  painter.drawRoundedRect(box, 4, 4);
  painter.setFont(textFont(TextRole::kSecond));
  painter.setPen(theme.text1);
  painter.drawText(box, Qt::AlignCenter, QString::fromStdString(curve.text));
}

void paintCurve(QPainter& painter, const SceneCurve& curve, const Camera& camera, const ViewSize& size,
                const Theme& theme) {
  const QColor color = colorOf(curve.role, theme);
  const auto runs = seenRuns(curve, camera, size);
  if (curve.points_W.size() == 1) {
    if (runs.front().isEmpty()) return;
    painter.setPen(QPen(theme.scene.halo, 1.5));
    painter.setBrush(color);
    painter.drawEllipse(runs.front().front(), kDisc, kDisc);
  }
  painter.setBrush(Qt::NoBrush);
  for (const QPolygonF& run : runs) {
    if (run.size() < 2) continue;
    QPen pen(color, curve.width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    // In widths of the pen: long, gap, dot, gap as a centre line of a drawing.
    if (curve.style == SceneCurve::Style::kDashDot)
      pen.setDashPattern({14.0 / curve.width, 4.0 / curve.width, 2.0 / curve.width, 4.0 / curve.width});
    if (curve.style == SceneCurve::Style::kDashed) pen.setDashPattern({5.0 / curve.width, 4.0 / curve.width});
    // The halo has the same dashes, else it would be the darker line of the two.
    QPen halo = pen;
    halo.setColor(theme.scene.halo);
    halo.setWidthF(curve.width + 3.0);
    QList<qreal> dashes = pen.dashPattern();
    for (qreal& dash : dashes) dash *= curve.width / halo.widthF();
    if (curve.style != SceneCurve::Style::kSolid) halo.setDashPattern(dashes);
    painter.setPen(halo);
    painter.drawPolyline(run);
    painter.setPen(pen);
    painter.drawPolyline(run);
  }
}

QRectF curveBox(const SceneCurve& curve, const Camera& camera, const ViewSize& size) {
  QRectF box;
  const auto runs = seenRuns(curve, camera, size);
  for (const QPolygonF& run : runs)
    for (const QPointF& p : run) box = box.united(QRectF(p.x() - kRoom, p.y() - kRoom, 2 * kRoom, 2 * kRoom));
  return box.intersected(QRectF(0, 0, size.width, size.height));
}

}  // namespace hapticell::app
