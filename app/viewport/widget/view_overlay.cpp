// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/view_overlay.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/viewport/overlay/curve_painter.h"
#include "app/viewport/overlay/pen_tags.h"
#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/widget/scene_picks.h"
#include "app/viewport/widget/view_pointer.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr QImage::Format kOverlayFormat = QImage::Format_ARGB32_Premultiplied;

}  // namespace

std::vector<StripCell> ViewOverlay::spokenNumbers() const {
  const auto& snapshot = view_.scene().snapshot();
  std::vector<StripCell> said;
  if (snapshot && snapshot->stylus.connected) said = stripCells(*snapshot, strip_);
  for (const OverlayLabel& label : overlayLabels(view_.scene()))
    said.push_back({label.mark, label.number, label.names});
  return said;
}

void ViewOverlay::setLabels(const std::string& owner, std::vector<OverlayLabel> labels) {
  const auto known = labels_.find(owner);
  if (known == labels_.end() ? labels.empty() : known->second == labels) return;
  if (labels.empty())
    labels_.erase(known);
  else
    labels_[owner] = std::move(labels);
  view_.update();
}

void ViewOverlay::setFigureStrip(std::vector<StripCell> cells) {
  if (cells == figure_strip_) return;
  figure_strip_ = std::move(cells);
  view_.update();
}

std::vector<OverlayLabel> ViewOverlay::allLabels() const {
  std::vector<OverlayLabel> all = overlayLabels(view_.scene());
  for (const auto& [owner, labels] : labels_) all.insert(all.end(), labels.begin(), labels.end());
  return all;
}

Strips ViewOverlay::strips() const {
  const auto& snapshot = view_.scene().snapshot();
  Strips strips;
  const bool stylus = snapshot && snapshot->stylus.connected && (snapshot->stylus.forces_on || figure_strip_.empty());
  if (stylus) strips.push_back(stripCells(*snapshot, strip_));
  if (!figure_strip_.empty()) strips.push_back(figure_strip_);
  return strips;
}

std::vector<SceneCurve> ViewOverlay::allCurves() const {
  std::vector<SceneCurve> all = frameTriads(view_.scene(), view_.camera(), view_.viewSize());
  for (const auto& [owner, curves] : curves_) all.insert(all.end(), curves.begin(), curves.end());
  if (view_.section()) {
    const auto section = sectionCurves(*view_.section(), view_.scene().bounds_W(), view_.camera(), view_.viewSize());
    all.insert(all.end(), section.begin(), section.end());
  }
  const auto& picked = view_.picks().hovered();
  if (!picked) return all;
  using Role = SceneCurve::Role;
  using Style = SceneCurve::Style;
  for (const auto& line : picked->outline_W) all.push_back({line, Role::kSelection, Style::kSolid, 2.5});
  if (picked->kind != FeatureKind::kFace) all.push_back({{picked->p_WQ}, Role::kSelection, Style::kSolid, 2.5});
  return all;
}

KeptFree ViewOverlay::keptFree(const Overlay& overlay) const {
  const ViewSize size = view_.viewSize();
  const auto pixels = [](const QRectF& box) { return PixelBox{{box.left(), box.top()}, {box.right(), box.bottom()}}; };
  KeptFree kept;
  const QRectF strip = stripsBox(overlay.strips, size);
  if (!strip.isEmpty()) kept.boxes.push_back(pixels(strip));
  constexpr double kHintHeight = 44.0, kHintHalfWidth = 320.0;  // It stands above the strip.
  if (!view_.pointer().hint().isEmpty() && !strip.isEmpty())
    kept.boxes.push_back({{strip.center().x() - kHintHalfWidth, strip.top() - kHintHeight},
                          {strip.center().x() + kHintHalfWidth, strip.top()}});
  kept.boxes.push_back({{size.width - 140, 0}, {size.width, 130}});
  const QRectF views = view_strip_.box();
  if (!views.isEmpty()) kept.boxes.push_back({{0, 0}, {views.right() + 8, views.bottom() + 8}});
  for (const PenTag& tag : penTags(overlay)) kept.boxes.push_back(pixels(tag.box));
  const auto add = [&kept](const glm::dvec2& from, const glm::dvec2& to, double room) {
    kept.lines.push_back({from, to, room});
  };
  // What is grabbed: the axes and rings of gizmos and frames.
  for (const SceneCurve& curve : overlay.curves) {
    using Role = SceneCurve::Role;
    if (curve.role != Role::kAxisX && curve.role != Role::kAxisY && curve.role != Role::kAxisZ) continue;
    for (const QPolygonF& run : seenRuns(curve, view_.camera(), size))
      for (qsizetype i = 1; i < run.size(); ++i) add({run[i - 1].x(), run[i - 1].y()}, {run[i].x(), run[i].y()}, 6.0);
  }
  const auto& snapshot = view_.scene().snapshot();
  if (!snapshot) return kept;
  if (const auto force = forceArrow(*snapshot, view_.camera(), size)) add(force->from, force->tip, 14.0);
  const auto addPen = [&](const Pose& X_WS) {
    const double length = penPixels(size) * view_.camera().metresPerPixel(X_WS.p, size);
    const auto tip = view_.camera().project(X_WS.p, size);
    const auto end = view_.camera().project(X_WS.p + length * X_WS.rotate(stylusDirection_S()), size);
    if (tip && end) add(*tip, *end, 12.0);
  };
  if (snapshot->stylus.connected) addPen(snapshot->stylus.X_WStylus);
  if (snapshot->second && snapshot->second->connected) addPen(snapshot->second->X_WStylus);
  return kept;
}

std::vector<PlacedLabel> ViewOverlay::placeLabels(const Overlay& overlay, const KeptFree& kept) {
  constexpr double kBesideArrow = 18.0, kBesideCurve = 10.0;
  std::vector<LabelWish> wishes;
  const auto& snapshot = view_.scene().snapshot();
  if (const auto force = snapshot ? forceArrow(*snapshot, view_.camera(), view_.viewSize()) : std::nullopt)
    wishes.push_back({kForceKey,
                      force->tip,
                      {std::ceil(textWidth(bold15(), QString::fromStdString(force->number))) + 16.0, 24.0},
                      kBesideArrow});
  for (std::size_t i = 0; i < overlay.curves.size(); ++i) {
    const auto end = curveTextPoint(overlay.curves[i], view_.camera(), view_.viewSize());
    if (!end) continue;
    const QSizeF size = curveTextSize(overlay.curves[i]);
    wishes.push_back({kCurveKeys + i, {end->x(), end->y()}, {size.width(), size.height()}, kBesideCurve});
  }
  for (const OverlayLabel& label : overlay.labels) {
    const auto anchor = view_.camera().project(label.p_WQ, view_.viewSize());
    const QSizeF size = labelSize(label);
    if (anchor) wishes.push_back({label.key, *anchor, {size.width(), size.height()}});
  }
  const double now = view_.seconds();
  const double seconds = now - last_s_;
  last_s_ = now;
  return layout_.place(wishes, kept, view_.viewSize(), seconds, view_.motion());
}

Overlay ViewOverlay::make() {
  drawn_numbers_ = spokenNumbers();
  Overlay overlay;
  overlay.theme = &themeOf(view_.palette());
  overlay.camera = view_.camera();
  overlay.size = view_.viewSize();
  overlay.scene = &view_.scene();
  overlay.labels = allLabels();
  overlay.curves = allCurves();
  overlay.strips = strips();
  const KeptFree kept = keptFree(overlay);
  overlay.places = drawn_labels_ = placeLabels(overlay, kept);
  overlay.hint = view_.pointer().hint();
  const ScenePicks& picks = view_.picks();
  if (picks.open()) {
    overlay.hint = picks.open()->prompt;
    if (picks.hovered()) overlay.hint += QStringLiteral(" · ") + QString::fromStdString(featureText(*picks.hovered()));
  }
  const PointerMarks marks = view_.pointer().marks();
  overlay.cube = view_.viewCube();
  overlay.cube_hover = marks.cube;
  if (view_.scene().empty()) overlay.empty = empty_;
  // Not where a pen is drawn.
  const auto isFree = [&](double height) {
    const PixelBox words = emptyBox(view_.viewSize(), height);
    return std::none_of(kept.lines.begin(), kept.lines.end(),
                        [&](const PixelLine& line) { return line.reaches(words); });
  };
  for (const double height : {0.74, 0.28})
    if (!isFree(overlay.empty_height) && isFree(height)) overlay.empty_height = height;
  overlay.box = marks.box;
  overlay.box_touching = marks.box_touching;
  overlay.hover_name = marks.name;
  overlay.hover_place = marks.name_place;
  overlay.view_strip = &view_strip_;
  overlay.view_strip_hover = marks.view_strip_cell;
  overlay.simplified = view_.isSimplified();
  overlay.missing_parts = view_.missingParts();
  return overlay;
}

void ViewOverlay::forgetCell() {
  curves_.clear();
  labels_.clear();
  setFigureStrip({});
}

void ViewOverlay::paintStill(QPainter& painter) {
  layout_.place({}, {}, view_.viewSize(), 1.0, false);
  paintOverlay(painter, make());
}

void ViewOverlay::paint() {
  const Overlay overlay = make();
  const double ratio = view_.devicePixelRatioF();
  if (image_.size() != view_.devicePixels()) image_ = QImage(view_.devicePixels(), kOverlayFormat);
  QRegion pieces;  // In pixels of the screen. Its boxes do not overlap: what is half transparent is laid over once.
  for (const QRectF& piece : overlayPieces(overlay)) {
    const QRectF scaled(piece.topLeft() * ratio, piece.size() * ratio);
    pieces += scaled.toAlignedRect().intersected(image_.rect());
  }
  // Painted by the raster engine (the one on OpenGL smooths lines only with multisampling), all of it once, and only
  // where there is something; each piece is uploaded.
  {
    QPainter painter(&image_);
    painter.setClipRegion(pieces);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.fillRect(image_.rect(), Qt::transparent);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.scale(ratio, ratio);
    paintOverlay(painter, overlay);
  }
  QPainter onto(&view_);
  for (const QRect& box : pieces) {
    const uchar* first = image_.constScanLine(box.top()) + qsizetype{4} * box.left();
    const QImage piece(first, box.width(), box.height(), image_.bytesPerLine(), kOverlayFormat);
    onto.drawImage(QRectF(QPointF(box.topLeft()) / ratio, QSizeF(box.size()) / ratio), piece);
  }
}

void ViewOverlay::setCurves(const std::string& owner, std::vector<SceneCurve> curves) {
  const auto known = curves_.find(owner);
  if (known == curves_.end() ? curves.empty() : known->second == curves) return;
  if (curves.empty())
    curves_.erase(known);
  else
    curves_[owner] = std::move(curves);
  view_.update();
}

}  // namespace hapticell::app
