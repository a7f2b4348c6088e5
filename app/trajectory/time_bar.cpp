// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/time_bar.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "app/style/fonts.h"
#include "app/style/style_painting.h"
#include "app/style/theme.h"

namespace hapticell::app {
namespace {

constexpr int kGrip = 7;        // Pixels about a bracket that grab it.
constexpr int kDotReach = 6;    // Pixels about a dot that choose it.
constexpr double kRoom = 0.04;  // Of the length, free before and after.
constexpr double kDot = 3.5;

QString seconds(double t) {
  return TimeBar::tr("%1 s").arg(std::abs(t) < 5e-4 ? 0.0 : t, 0, 'f', 2);
}

}  // namespace

QColor colorOf(CheckMark mark, const Theme& theme) {
  switch (mark) {
    case CheckMark::kCollision:
      return theme.contact;
    case CheckMark::kLimit:
      return theme.limit;
    case CheckMark::kCareful:
      return theme.near_miss;
    case CheckMark::kFree:
    case CheckMark::kNone:
      break;
  }
  return theme.text1;
}

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

void TimeBar::paintRuler(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  painter.setFont(textFont(TextRole::kSecond));
  for (const TimeAxis::Tick& tick : at.ticks()) {
    const double x = std::round(at.x(tick.t));
    painter.fillRect(QRectF(x, kRuler - (tick.named ? 10 : 6), 1, tick.named ? 8 : 4), theme.text3);
    if (!tick.named || std::abs(x - at.x(time_)) < 44) continue;
    painter.setPen(theme.text2);
    const double step = 60.0 / at.pixelsPerSecond();
    const int decimals = step < 0.1 ? 2 : step < 1.0 ? 1 : 0;
    painter.drawText(QRectF(x - 34, 0, 68, 18), Qt::AlignCenter, tr("%1 s").arg(tick.t, 0, 'f', decimals));
  }
}

void TimeBar::paintDots(QPainter& painter, const TrackRow& row, const QRect& bar) const {
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  const double y = bar.center().y() + 0.5;
  double last = -1e9;
  for (const TrackDot& dot : row.dots) {
    const double x = at.x(dot.t);
    const bool chosen = row.current && frame_ && *frame_ == dot.frame;
    if (x < at.left - 4 || x > at.right + 4 || (x - last < (dot.by_hand ? 3.0 : 10.0) && !chosen)) continue;
    last = x;
    const QColor color = colorOf(dot.mark, theme);
    painter.setPen(QPen(chosen ? theme.selection : color, chosen ? 2.5 : 1.4));
    painter.setBrush(dot.mark == CheckMark::kFree || chosen ? QBrush(color) : QBrush(Qt::NoBrush));
    // Shape beside colour: diamond, H, triangle, ring (checked and free: disc).
    if (dot.mark == CheckMark::kCollision) {
      painter.setBrush(color);
      const QPointF diamond[4] = {{x, y - 5}, {x + 5, y}, {x, y + 5}, {x - 5, y}};
      painter.drawPolygon(diamond, 4);
    } else if (dot.mark == CheckMark::kLimit) {
      painter.drawLine(QPointF(x - 3, y - 4), QPointF(x - 3, y + 4));
      painter.drawLine(QPointF(x + 3, y - 4), QPointF(x + 3, y + 4));
      painter.drawLine(QPointF(x - 3, y), QPointF(x + 3, y));
    } else if (dot.mark == CheckMark::kCareful) {
      const QPointF triangle[3] = {{x, y - 5}, {x + 5, y + 4}, {x - 5, y + 4}};
      painter.drawPolygon(triangle, 3);
    } else {
      const double size = chosen ? kDot + 1.5 : dot.by_hand ? kDot + 0.5 : kDot - 1.0;
      painter.drawEllipse(QPointF(x, y), size, size);
    }
  }
}

void TimeBar::paintRow(QPainter& painter, std::size_t index) const {
  const Theme& theme = themeOf(palette());
  const TrackRow& row = rows_[index];
  const QRect rect = rowRect(index);
  const TimeAxis at = axis();
  if (row.current) {
    painter.fillRect(QRect(0, rect.top(), kNames - 8, rect.height()), theme.selected_row);
    painter.fillRect(QRect(0, rect.top(), 2, rect.height()), theme.selection);
  }
  const QPointF light(18.5, rect.center().y() + 0.5);
  painter.setPen(QPen(row.playable ? theme.text1 : theme.text3, 1.4));
  painter.setBrush(row.played ? QBrush(theme.selection) : QBrush(Qt::NoBrush));
  painter.drawEllipse(light, 4.5, 4.5);
  painter.setFont(textFont(TextRole::kText));
  painter.setPen(row.playable ? theme.text1 : theme.text3);
  const QRect words(32, rect.top(), kNames - 48, rect.height());
  painter.drawText(words, Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(QString::fromStdString(row.name), Qt::ElideRight, words.width()));
  const int left = static_cast<int>(std::max(at.left, at.x(row.begin))),
            right = static_cast<int>(std::min(at.right, at.x(row.end)));
  const QRect bar(left, rect.top() + 4, std::max(2, right - left), rect.height() - 8);
  painter.save();
  painter.setClipRect(QRectF(at.left - 6, rect.top(), at.right - at.left + 12, rect.height()));
  if (row.end > row.begin)
    drawBox(&painter, bar, row.played ? theme.selected_row : theme.field, row.played ? theme.selection : theme.line, 2);
  for (const TrackSpan& span : row.spans) {
    const double from = at.x(span.t_in), to = std::max(from + 3.0, at.x(span.t_out));
    QColor color = colorOf(span.mark, theme);
    painter.fillRect(QRectF(from, bar.bottom() - 2, to - from, 3), color);
    color.setAlpha(50);
    painter.fillRect(QRectF(from, bar.top() + 1, to - from, bar.height() - 1), color);
  }
  paintDots(painter, row, bar);
  painter.restore();
  if (row.note.isEmpty()) return;
  // Beside the bar where there is room, else in it.
  painter.setFont(textFont(TextRole::kSecond));
  const int width = painter.fontMetrics().horizontalAdvance(row.note) + 12;
  const bool beside = right + 10 + width < at.right;
  painter.setPen(theme.text2);
  if (!beside) {
    const QRect box(left + 10, bar.top() + 1, std::min(width, bar.width() - 14), bar.height() - 1);
    QColor back = theme.dock;
    back.setAlpha(210);
    painter.fillRect(box, back);
    painter.drawText(box.adjusted(4, 0, -4, 0), Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(row.note, Qt::ElideRight, box.width() - 8));
  } else {
    painter.drawText(QRect(right + 10, rect.top(), width, rect.height()), Qt::AlignVCenter, row.note);
  }
}

void TimeBar::paintPart(QPainter& painter) const {
  if (!part_) return;
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  QColor veil = theme.dock;
  veil.setAlpha(150);
  const double from = std::clamp(at.x(part_->from), at.left, at.right),
               to = std::clamp(at.x(part_->to), at.left, at.right);
  painter.fillRect(QRectF(at.left, kRuler, from - at.left, height() - kRuler), veil);
  painter.fillRect(QRectF(to, kRuler, at.right - to, height() - kRuler), veil);
  painter.setPen(QPen(theme.selection, 2));
  for (const auto& [x, side] : {std::pair(from, 5.0), std::pair(to, -5.0)}) {
    painter.drawLine(QPointF(x, 16), QPointF(x, height()));
    painter.drawLine(QPointF(x, 16), QPointF(x + side, 16));
    painter.drawLine(QPointF(x, kRuler - 1), QPointF(x + side, kRuler - 1));
  }
}

void TimeBar::paintCursor(QPainter& painter) const {
  const Theme& theme = themeOf(palette());
  const TimeAxis at = axis();
  const double x = recorded_ ? at.x(*recorded_) : at.x(time_);
  if (x < at.left - 1 || x > at.right + 1) return;
  painter.fillRect(QRectF(x - 0.75, 18, 1.5, height() - 18), theme.text1);
  const QRect box(static_cast<int>(x) - 26, 1, 52, 18);
  drawBox(&painter, box, theme.text1, theme.text1, 3);
  painter.setFont(textFont(TextRole::kSection));
  painter.setPen(theme.dock);
  painter.drawText(box, Qt::AlignCenter, QString::number(recorded_.value_or(time_), 'f', 2));
}

void TimeBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme& theme = themeOf(palette());
  painter.setFont(textFont(TextRole::kText));
  paintRuler(painter);
  painter.save();
  painter.setClipRect(QRect(0, kRuler, width(), height() - kRuler));
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (rowRect(row).bottom() > kRuler && rowRect(row).top() < height()) paintRow(painter, row);
  if (recorded_) {
    const QRect rect = rowRect(rows_.size());
    const TimeAxis at = axis();
    painter.setPen(theme.text1);
    painter.drawText(QRect(32, rect.top(), kNames - 60, rect.height()), Qt::AlignVCenter, tr("recording"));
    painter.setBrush(theme.contact);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPointF(kNames - 22, rect.center().y() + 0.5), 5, 5);
    const QRect bar(static_cast<int>(at.x(0.0)), rect.top() + 4, static_cast<int>(at.x(*recorded_) - at.x(0.0)),
                    kRow - 8);
    drawBox(&painter, bar, theme.selected_row, theme.selection, 2);
  }
  painter.restore();
  if (rows_.empty() && !recorded_) {
    painter.setPen(theme.text2);
    painter.drawText(QRect(kNames, kRuler, width() - kNames - kRightRoom, height() - kRuler),
                     Qt::AlignCenter | Qt::TextWordWrap,
                     tr("No motion yet. Press R, move an entity, press R again; or import one."));
  }
  paintPart(painter);
  paintCursor(painter);
  if (hasFocus()) {
    painter.setPen(QPen(theme.selection, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
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
  if (place.x() < 30) return shown.played ? tr("Played; click to leave it out") : tr("Click to play it");
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
