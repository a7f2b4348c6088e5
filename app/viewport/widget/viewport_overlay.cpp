// SPDX-License-Identifier: Apache-2.0
// What the viewport paints over the scene: labels, strip, curves, view cube.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/viewport/overlay/curve_painter.h"
#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/overlay/pen_tags.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr QImage::Format kOverlayFormat = QImage::Format_ARGB32_Premultiplied;

}  // namespace

std::vector<StripCell> ViewportWidget::spokenNumbers() const {
  const auto& snapshot = scene_.snapshot();
  std::vector<StripCell> said;
  if (snapshot && snapshot->connected) said = stripCells(*snapshot, strip_);
  for (const OverlayLabel& label : overlayLabels(scene_)) said.push_back({label.mark, label.number, label.names});
  return said;
}

void ViewportWidget::setLabels(const std::string& owner, std::vector<OverlayLabel> labels) {
  const auto known = labels_.find(owner);
  if (known == labels_.end() ? labels.empty() : known->second == labels) return;
  if (labels.empty())
    labels_.erase(known);
  else
    labels_[owner] = std::move(labels);
  update();
}

void ViewportWidget::setFigureStrip(std::vector<StripCell> cells) {
  if (cells == figure_strip_) return;
  figure_strip_ = std::move(cells);
  update();
}

std::vector<OverlayLabel> ViewportWidget::allLabels() const {
  std::vector<OverlayLabel> all = overlayLabels(scene_);
  for (const auto& [owner, labels] : labels_) all.insert(all.end(), labels.begin(), labels.end());
  return all;
}

Strips ViewportWidget::strips() const {
  const auto& snapshot = scene_.snapshot();
  Strips strips;
  const bool stylus = snapshot && snapshot->connected && (snapshot->forces_on || figure_strip_.empty());
  if (stylus) strips.push_back(stripCells(*snapshot, strip_));
  if (!figure_strip_.empty()) strips.push_back(figure_strip_);
  return strips;
}

std::vector<SceneCurve> ViewportWidget::allCurves() const {
  std::vector<SceneCurve> all = frameTriads(scene_, camera_, viewSize());
  for (const auto& [owner, curves] : curves_) all.insert(all.end(), curves.begin(), curves.end());
  if (section_) {
    const auto section = sectionCurves(*section_, scene_.bounds_W(), camera_, viewSize());
    all.insert(all.end(), section.begin(), section.end());
  }
  if (!pick_hover_) return all;
  using Role = SceneCurve::Role;
  using Style = SceneCurve::Style;
  for (const auto& line : pick_hover_->outline_W) all.push_back({line, Role::kSelection, Style::kSolid, 2.5});
  if (pick_hover_->kind != FeatureKind::kFace)
    all.push_back({{pick_hover_->p_WQ}, Role::kSelection, Style::kSolid, 2.5});
  return all;
}

KeptFree ViewportWidget::keptFree(const Overlay& overlay) const {
  const ViewSize size = viewSize();
  const auto pixels = [](const QRectF& box) { return PixelBox{{box.left(), box.top()}, {box.right(), box.bottom()}}; };
  KeptFree kept;
  const QRectF strip = stripsBox(overlay.strips, size);
  if (!strip.isEmpty()) kept.boxes.push_back(pixels(strip));
  constexpr double kHintHeight = 44.0, kHintHalfWidth = 320.0;  // It stands above the strip.
  if (!tools_.hint().isEmpty() && !strip.isEmpty())
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
    for (const QPolygonF& run : seenRuns(curve, camera_, size))
      for (qsizetype i = 1; i < run.size(); ++i) add({run[i - 1].x(), run[i - 1].y()}, {run[i].x(), run[i].y()}, 6.0);
  }
  const auto& snapshot = scene_.snapshot();
  if (!snapshot) return kept;
  if (const auto force = forceArrow(*snapshot, camera_, size)) add(force->from, force->tip, 14.0);
  const auto addPen = [&](const Pose& X_WS) {
    const double length = penPixels(size) * camera_.metresPerPixel(X_WS.p, size);
    const auto tip = camera_.project(X_WS.p, size);
    const auto end = camera_.project(X_WS.p + length * X_WS.rotate(stylusDirection_S()), size);
    if (tip && end) add(*tip, *end, 12.0);
  };
  if (snapshot->connected) addPen(snapshot->X_WStylus);
  if (snapshot->second && snapshot->second->connected) addPen(snapshot->second->X_WStylus);
  return kept;
}

std::vector<PlacedLabel> ViewportWidget::placeLabels(const Overlay& overlay, const KeptFree& kept) {
  constexpr double kBesideArrow = 18.0, kBesideCurve = 10.0;
  std::vector<LabelWish> wishes;
  const auto& snapshot = scene_.snapshot();
  if (const auto force = snapshot ? forceArrow(*snapshot, camera_, viewSize()) : std::nullopt)
    wishes.push_back({kForceKey,
                      force->tip,
                      {std::ceil(textWidth(bold15(), QString::fromStdString(force->number))) + 16.0, 24.0},
                      kBesideArrow});
  for (std::size_t i = 0; i < overlay.curves.size(); ++i) {
    const auto end = curveTextPoint(overlay.curves[i], camera_, viewSize());
    if (!end) continue;
    const QSizeF size = curveTextSize(overlay.curves[i]);
    wishes.push_back({kCurveKeys + i, {end->x(), end->y()}, {size.width(), size.height()}, kBesideCurve});
  }
  for (const OverlayLabel& label : overlay.labels) {
    const auto anchor = camera_.project(label.p_WQ, viewSize());
    const QSizeF size = labelSize(label);
    if (anchor) wishes.push_back({label.key, *anchor, {size.width(), size.height()}});
  }
  const double now = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  const double seconds = now - last_overlay_s_;
  last_overlay_s_ = now;
  return label_layout_.place(wishes, kept, viewSize(), seconds, motion_);
}

Overlay ViewportWidget::makeOverlay() {
  drawn_numbers_ = spokenNumbers();
  Overlay overlay;
  overlay.theme = &themeOf(palette());
  overlay.camera = camera_;
  overlay.size = viewSize();
  overlay.scene = &scene_;
  overlay.labels = allLabels();
  overlay.curves = allCurves();
  overlay.strips = strips();
  const KeptFree kept = keptFree(overlay);
  overlay.places = drawn_labels_ = placeLabels(overlay, kept);
  overlay.hint = tools_.hint();
  if (pick_) {
    overlay.hint = pick_->prompt;
    if (pick_hover_) overlay.hint += QStringLiteral(" · ") + QString::fromStdString(featureText(*pick_hover_));
  }
  overlay.cube = viewCube();
  overlay.cube_hover = cube_hover_;
  if (scene_.empty()) overlay.empty = empty_;
  // Not where a pen is drawn.
  const auto isFree = [&](double height) {
    const PixelBox words = emptyBox(viewSize(), height);
    return std::none_of(kept.lines.begin(), kept.lines.end(),
                        [&](const PixelLine& line) { return line.reaches(words); });
  };
  for (const double height : {0.74, 0.28})
    if (!isFree(overlay.empty_height) && isFree(height)) overlay.empty_height = height;
  if (drag_ == Drag::kBox) {
    overlay.box = QRectF(press_place_, last_place_).normalized();
    overlay.box_touching = last_place_.x() < press_place_.x();
  }
  if (drag_ == Drag::kNone && !pick_) {
    overlay.hover_name = hover_name_;
    overlay.hover_place = hover_place_;
  }
  overlay.view_strip = &view_strip_;
  overlay.view_strip_hover = view_strip_hover_;
  overlay.simplified = simplified_;
  overlay.missing_parts = renderer_ ? renderer_->missingParts() : 0;
  return overlay;
}

void ViewportWidget::paintOverlayImage() {
  const Overlay overlay = makeOverlay();
  const double ratio = devicePixelRatioF();
  if (overlay_image_.size() != devicePixels()) overlay_image_ = QImage(devicePixels(), kOverlayFormat);
  QRegion pieces;  // In pixels of the screen. Its boxes do not overlap: what is half transparent is laid over once.
  for (const QRectF& piece : overlayPieces(overlay)) {
    const QRectF scaled(piece.topLeft() * ratio, piece.size() * ratio);
    pieces += scaled.toAlignedRect().intersected(overlay_image_.rect());
  }
  // Painted by the raster engine (the one on OpenGL smooths lines only with multisampling), all of it once, and only
  // where there is something; each piece is uploaded.
  {
    QPainter painter(&overlay_image_);
    painter.setClipRegion(pieces);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.fillRect(overlay_image_.rect(), Qt::transparent);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.scale(ratio, ratio);
    paintOverlay(painter, overlay);
  }
  QPainter onto(this);
  for (const QRect& box : pieces) {
    const uchar* first = overlay_image_.constScanLine(box.top()) + qsizetype{4} * box.left();
    const QImage piece(first, box.width(), box.height(), overlay_image_.bytesPerLine(), kOverlayFormat);
    onto.drawImage(QRectF(QPointF(box.topLeft()) / ratio, QSizeF(box.size()) / ratio), piece);
  }
}

}  // namespace hapticell::app
