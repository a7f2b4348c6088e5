// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "app/studies/study_draft.h"

namespace hapticell::app {

class Host;

/// The rectangles of the floor in which things may stand (StudyDraft::floorRanges), drawn in the scene with a handle at
/// each corner and one in the middle. A drag of a handle changes the study when it ends; Escape ends it without a change.
/// GUI thread.
class FloorArea : public QObject {
  Q_OBJECT
 public:
  FloorArea(Host& host, StudyDraft& draft, QObject* parent = nullptr);
  ~FloorArea() override;
  /// Draws them, or not, and follows drags only while drawn.
  void setShown(bool on);
  /// The middle and the corners of a rectangle on the floor, m.
  static std::array<dvec3, 5> handlesOf(const FloorRange& range);
  /// The rectangle with a handle (as above) put to a point: a corner, with the opposite one kept, or the middle.
  static FloorRange dragged(const FloorRange& range, std::size_t handle, const dvec3& p_W);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Drag {
    FloorRange range;
    std::size_t handle = 0;
  };
  bool isOfOpenCell() const;
  std::optional<Drag> handleAt(const QPointF& place) const;
  void draw();

  Host& host_;
  StudyDraft& draft_;
  std::vector<FloorRange> ranges_;
  std::optional<Drag> drag_;
  bool shown_ = false;
};

}  // namespace hapticell::app
