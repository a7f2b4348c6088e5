// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/time_bar.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "app/style/style_painting.h"

namespace hapticell::app {
namespace {

// Pixels about a bracket that grab it, as kEdgePixels of feature_picker.h. Half: hard to meet; twice: two near ones
// cannot be distinguished.
constexpr int kGrip = 7;
// Pixels about a dot that choose it, less than a bracket's. Half: hard to meet; twice: neighbours are taken.
constexpr int kDotReach = 6;
constexpr double kRoom = 0.04;  // Of the length, free before and after.

QString seconds(double t) {
  return TimeBar::tr("%1 s").arg(std::abs(t) < 5e-4 ? 0.0 : t, 0, 'f', 2);
}

}  // namespace

TimeBar::TimeBar(QWidget* parent) : QWidget(parent) {
  setObjectName("timeBar");
  setAccessibleName(tr("Time bar"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void TimeBar::setRows(std::vector<TrackRow> rows) {
  const bool more = rows.size() != rows_.size();
  rows_ = std::move(rows);
  if (!zoomed_) showAll();
  if (more) updateGeometry();
  update();
}

void TimeBar::setTime(double t) {
  if (t == time_) return;
  time_ = t;
  setAccessibleDescription(seconds(t));
  update();
}

void TimeBar::setPart(const std::optional<Part>& part) {
  part_ = part;
  if (part_ && part_->from > part_->to) std::swap(part_->from, part_->to);
  update();
  emit partChanged();
}

void TimeBar::setRecorded(std::optional<double> seconds) {
  if (seconds == recorded_) return;
  recorded_ = seconds;
  if (!zoomed_) showAll();
  update();
}

void TimeBar::setFrame(std::optional<std::size_t> frame) {
  frame_ = frame;
  update();
}

void TimeBar::showAll() {
  zoomed_ = false;
  double from = 0.0, to = recorded_.value_or(0.0);
  for (const TrackRow& row : rows_) {
    from = std::min(from, row.begin);
    to = std::max(to, row.end);
  }
  if (to <= from) to = from + 10.0;
  if (recorded_) to = std::max(24.0, 1.3 * to);
  const double room = kRoom * (to - from);
  begin_ = from - 0.4 * room;
  end_ = to + room;
  emit axisChanged();
  update();
}

TimeAxis TimeBar::axis() const {
  return {static_cast<double>(kNames), static_cast<double>(std::max(kNames + 40, width() - kRightRoom)), begin_, end_};
}

QSize TimeBar::sizeHint() const {
  return {900, kRuler + kRow * std::clamp(static_cast<int>(rows_.size()) + (recorded_ ? 1 : 0), 2, 5) + 4};
}

QRect TimeBar::rowRect(std::size_t row) const {
  return {0, kRuler + kRow * (static_cast<int>(row) - first_row_), width(), kRow};
}

int TimeBar::rowAt(int y) const {
  if (y < kRuler) return -1;
  const int row = (y - kRuler) / kRow + first_row_;
  return row < static_cast<int>(rows_.size()) ? row : -1;
}

const TrackRow* TimeBar::currentRow() const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [](const TrackRow& row) { return row.current; });
  return found == rows_.end() ? nullptr : &*found;
}

void TimeBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QPointF place = event->position();
  const int row = rowAt(static_cast<int>(place.y()));
  const TimeAxis at = axis();
  if (place.x() < kNames - 8) {
    if (row < 0) return;
    const TrackRow& chosen = rows_[static_cast<std::size_t>(row)];
    const QString name = QString::fromStdString(chosen.name);
    if (place.x() < 30)
      emit playedToggled(name, !chosen.played);
    else
      emit rowChosen(name);
    return;
  }
  if (part_ && place.y() < kRuler) {
    if (std::abs(place.x() - at.x(part_->from)) < kGrip)
      drag_ = Drag::kFrom;
    else if (std::abs(place.x() - at.x(part_->to)) < kGrip)
      drag_ = Drag::kTo;
  }
  if (drag_ != Drag::kNone) return;
  drag_ = Drag::kScrub;
  if (row >= 0) {
    const TrackRow& chosen = rows_[static_cast<std::size_t>(row)];
    const TrackDot* nearest = nullptr;
    for (const TrackDot& dot : chosen.dots)
      if (std::abs(at.x(dot.t) - place.x()) < kDotReach &&
          (!nearest || std::abs(at.x(dot.t) - place.x()) < std::abs(at.x(nearest->t) - place.x())))
        nearest = &dot;
    const std::optional<TrackDot> found = nearest ? std::optional<TrackDot>(*nearest) : std::nullopt;
    if (!chosen.current) emit rowChosen(QString::fromStdString(chosen.name));
    if (found) {
      emit frameChosen(found->frame);
      emit scrubbed(found->t);
      return;
    }
  }
  emit scrubbed(at.t(std::clamp(place.x(), at.left, at.right)));
}

void TimeBar::mouseMoveEvent(QMouseEvent* event) {
  const TimeAxis at = axis();
  const double x = event->position().x();
  const bool grip = part_ && event->position().y() < kRuler &&
                    (std::abs(x - at.x(part_->from)) < kGrip || std::abs(x - at.x(part_->to)) < kGrip);
  setCursor(grip || drag_ == Drag::kFrom || drag_ == Drag::kTo ? Qt::SizeHorCursor : Qt::ArrowCursor);
  if (drag_ == Drag::kNone) return;
  const double t = at.t(std::clamp(x, at.left, at.right));
  if (drag_ == Drag::kScrub) return emit scrubbed(t);
  Part part = *part_;
  (drag_ == Drag::kFrom ? part.from : part.to) = t;
  if (part.from < part.to) setPart(part);
}

void TimeBar::mouseReleaseEvent(QMouseEvent*) {
  drag_ = Drag::kNone;
}

void TimeBar::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  const TimeAxis at = axis();
  if (event->modifiers() & Qt::ControlModifier) {
    const TimeAxis zoomed = at.zoomed(std::pow(1.25, notches), at.t(event->position().x()));
    begin_ = zoomed.begin;
    end_ = zoomed.end;
    zoomed_ = true;
    emit axisChanged();
  } else if (event->modifiers() & Qt::ShiftModifier) {
    const double shift = 0.1 * notches * (end_ - begin_);
    begin_ -= shift;
    end_ -= shift;
    zoomed_ = true;
    emit axisChanged();
  } else {
    const int seen = std::max(1, (height() - kRuler) / kRow);
    const int most = std::max(0, static_cast<int>(rows_.size()) + (recorded_ ? 1 : 0) - seen);
    first_row_ = std::clamp(first_row_ - static_cast<int>(std::lround(notches)), 0, most);
  }
  update();
  event->accept();
}

void TimeBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
    emit stepped(event->key() == Qt::Key_Right ? 1 : -1);
  } else if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
    const TrackRow* now = currentRow();
    const auto index = now ? now - rows_.data() : -1;
    const auto next = index + (event->key() == Qt::Key_Down ? 1 : -1);
    if (next >= 0 && next < static_cast<std::ptrdiff_t>(rows_.size()))
      emit rowChosen(QString::fromStdString(rows_[static_cast<std::size_t>(next)].name));
  } else if (event->key() == Qt::Key_Home || event->key() == Qt::Key_End) {
    double from = 0.0, to = 0.0;
    for (const TrackRow& row : rows_) to = std::max(to, row.end);
    emit scrubbed(event->key() == Qt::Key_Home ? from : to);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void TimeBar::resizeEvent(QResizeEvent*) {
  emit axisChanged();
}

QString TimeBar::toolTipAt(const QPoint& place) const {
  const int row = rowAt(place.y());
  if (row < 0) return {};
  const TrackRow& shown = rows_[static_cast<std::size_t>(row)];
  if (place.x() < 30) return shown.played ? tr("Played; click to exclude it") : tr("Click to play it");
  if (place.x() < kNames) return QString::fromStdString(shown.name);
  const double t = axis().t(place.x());
  const double reach = 4.0 / axis().pixelsPerSecond();
  QStringList lines;
  for (const TrackSpan& span : shown.spans)
    if (t > span.t_in - reach && t < span.t_out + reach)
      lines << tr("%1 (%2 to %3)").arg(span.text, seconds(span.t_in), seconds(span.t_out));
  return lines.isEmpty() ? shown.note : lines.join('\n');
}

bool TimeBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), toolTipAt(help->pos()), this);
  return true;
}

}  // namespace hapticell::app
