// SPDX-License-Identifier: Apache-2.0
#include "app/studies/floor_area.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/style/units.h"
#include "app/viewport/widget/floor_point.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

namespace {

constexpr const char* kAreasOwner = "study areas";
/// Pixels about a handle. Half: hard to take; twice: takes clicks that mean the scene.
constexpr double kHandleReach = 9.0;
/// m: the least side of a rectangle. Half and twice: as well; it only keeps the ends in order.
constexpr double kLeastSide = 0.02;

}  // namespace

FloorArea::FloorArea(Host& host, StudyDraft& draft, QObject* parent) : QObject(parent), host_(host), draft_(draft) {
  const auto again = [this] {
    drag_.reset();
    draw();
  };
  connect(&draft_, &StudyDraft::changed, this, again);
  connect(&host_.documentModel(), &DocumentModel::changed, this, again);
  connect(&host_.documentModel(), &DocumentModel::opened, this, again);
  host_.viewport().installEventFilter(this);
}

FloorArea::~FloorArea() = default;

void FloorArea::setShown(bool on) {
  if (on == shown_) return;
  shown_ = on;
  drag_.reset();
  draw();
}

std::array<dvec3, 5> FloorArea::handlesOf(const FloorRange& range) {
  return {dvec3(0.5 * (range.x_from + range.x_to), 0.5 * (range.y_from + range.y_to), 0.0),
          dvec3(range.x_from, range.y_from, 0.0), dvec3(range.x_to, range.y_from, 0.0),
          dvec3(range.x_to, range.y_to, 0.0), dvec3(range.x_from, range.y_to, 0.0)};
}

FloorRange FloorArea::dragged(const FloorRange& range, std::size_t handle, const dvec3& p_W) {
  FloorRange moved = range;
  if (handle == 0) {
    const dvec3 by = p_W - handlesOf(range)[0];
    moved.x_from += by.x;
    moved.x_to += by.x;
    moved.y_from += by.y;
    moved.y_to += by.y;
    return moved;
  }
  const bool right = handle == 2 || handle == 3, far = handle == 3 || handle == 4;
  if (right) {
    moved.x_to = std::max(p_W.x, range.x_from + kLeastSide);
  } else {
    moved.x_from = std::min(p_W.x, range.x_to - kLeastSide);
  }
  if (far) {
    moved.y_to = std::max(p_W.y, range.y_from + kLeastSide);
  } else {
    moved.y_from = std::min(p_W.y, range.y_to - kLeastSide);
  }
  return moved;
}

bool FloorArea::isOfOpenCell() const {
  namespace fs = std::filesystem;
  const fs::path cell(draft_.cell().toStdString());
  const DocumentModel& model = host_.documentModel();
  std::error_code fault;
  for (const fs::path& open : {model.document().path(), model.origin()})
    if (!cell.empty() && !open.empty() && (cell == open || fs::equivalent(cell, open, fault))) return true;
  return false;
}

void FloorArea::draw() {
  ranges_.clear();
  if (shown_ && isOfOpenCell()) ranges_ = draft_.floorRanges(host_.documentModel().document().state());
  std::vector<SceneCurve> curves;
  for (const FloorRange& own : ranges_) {
    const bool moves = drag_ && drag_->range.x == own.x && drag_->range.y == own.y;
    const FloorRange& range = moves ? drag_->range : own;
    const auto handles = handlesOf(range);
    SceneCurve outline{{handles[1], handles[2], handles[3], handles[4], handles[1]},
                       SceneCurve::Role::kSelection,
                       SceneCurve::Style::kSolid};
    outline.text = range.entity + ": " +
                   (lengthText(range.x_to - range.x_from, 0) + QStringLiteral(" × ") +
                    lengthText(range.y_to - range.y_from, 0))
                       .toStdString();
    curves.push_back(std::move(outline));
    for (const dvec3& p_W : handles)
      curves.push_back({{p_W}, SceneCurve::Role::kSelection, SceneCurve::Style::kSolid, 9.0});
  }
  host_.viewport().setCurves(kAreasOwner, std::move(curves));
}

std::optional<FloorArea::Drag> FloorArea::handleAt(const QPointF& place) const {
  const ViewportWidget& viewport = host_.viewport();
  if (isOverViewControls(viewport, place)) return std::nullopt;
  const ViewSize size{static_cast<double>(viewport.width()), static_cast<double>(viewport.height())};
  for (const FloorRange& range : ranges_) {
    const auto handles = handlesOf(range);
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const auto pixel = viewport.camera().project(handles[i], size);
      if (pixel && std::hypot(pixel->x - place.x(), pixel->y - place.y()) <= kHandleReach) return Drag{range, i};
    }
  }
  return std::nullopt;
}

bool FloorArea::eventFilter(QObject* watched, QEvent* event) {
  if (!shown_ || ranges_.empty() || host_.viewport().isPicking()) return QObject::eventFilter(watched, event);
  if (drag_ && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride)) {
    if (dynamic_cast<QKeyEvent&>(*event).key() != Qt::Key_Escape) return false;
    drag_.reset();
    draw();
    event->accept();
    return true;
  }
  const auto* mouse = dynamic_cast<const QMouseEvent*>(event);
  if (mouse == nullptr) return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton && !drag_) {
    drag_ = handleAt(mouse->position());
    return drag_.has_value();
  }
  if (!drag_) return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::MouseMove) {
    if (const auto p_W = floorPoint(host_.viewport(), mouse->position())) {
      const auto own = std::find_if(ranges_.begin(), ranges_.end(),
                                    [&](const FloorRange& one) { return one.x == drag_->range.x; });
      if (own != ranges_.end()) drag_->range = dragged(*own, drag_->handle, *p_W);
      draw();
    }
    return true;
  }
  if (event->type() == QEvent::MouseButtonRelease && mouse->button() == Qt::LeftButton) {
    const FloorRange range = drag_->range;
    drag_.reset();
    draft_.setFloorRange(range, host_.documentModel().document().state());
    draw();
    return true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace hapticell::app
