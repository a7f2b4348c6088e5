// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "app/trajectory/docks/time_axis.h"
#include "app/trajectory/motions/track_rows.h"

namespace hapticell::app {

struct Theme;

/// Motions as rows over one time axis, with the cursor, frames as dots and findings of checks. A drag scrubs; a click
/// on a row makes its motion the current one, a click on its circle at the left switches its playing; Ctrl and the
/// wheel zoom, the wheel scrolls; dragging the brackets in the ruler selects a section. Left and right step by frame.
class TimeBar : public QWidget {
  Q_OBJECT
 public:
  explicit TimeBar(QWidget* parent = nullptr);

  /// Widths of the names on the left and of the free space on the right, in pixels; the curves below use the same.
  static constexpr int kNames = 196, kRightRoom = 60;
  static constexpr int kRuler = 30, kRow = 24;

  void setRows(std::vector<TrackRow> rows);
  const std::vector<TrackRow>& rows() const { return rows_; }
  void setTime(double t);
  /// The selected section, in seconds; empty: all.
  struct Part {
    double from = 0.0, to = 0.0;
  };
  void setPart(const std::optional<Part>& part);
  const std::optional<Part>& part() const { return part_; }
  /// Sets the seconds recorded so far, during a recording: the axis grows with it.
  void setRecorded(std::optional<double> seconds);
  /// Sets the frame that is being edited; empty: none.
  void setFrame(std::optional<std::size_t> frame);

  TimeAxis axis() const;
  /// Shows the whole of the motions again.
  void showAll();
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {480, kRuler + 2 * kRow}; }

 signals:
  void scrubbed(double t);
  void stepped(int direction);
  void rowChosen(const QString& name);
  void playedToggled(const QString& name, bool played);
  void partChanged();
  void frameChosen(std::size_t frame);  ///< Of the current row.
  void axisChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRect rowRect(std::size_t row) const;
  int rowAt(int y) const;
  const TrackRow* currentRow() const;
  void paintRuler(QPainter& painter) const;
  void paintRow(QPainter& painter, std::size_t row) const;
  void paintDots(QPainter& painter, const TrackRow& row, const QRect& bar) const;
  void paintCursor(QPainter& painter) const;
  void paintPart(QPainter& painter) const;
  QString toolTipAt(const QPoint& place) const;

  std::vector<TrackRow> rows_;
  double time_ = 0.0;
  std::optional<Part> part_;
  std::optional<double> recorded_;
  std::optional<std::size_t> frame_;
  double begin_ = 0.0, end_ = 1.0;  ///< The shown range.
  bool zoomed_ = false;
  int first_row_ = 0;
  enum class Drag { kNone, kScrub, kFrom, kTo } drag_ = Drag::kNone;
};

/// The colour of a mark.
QColor colorOf(CheckMark mark, const Theme& theme);

}  // namespace hapticell::app
