// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/pointer_tool.h"

namespace hapticell::app {

class Host;

/// Arrows and rings at a frame of a motion, for dragging it in the scene. GUI thread.
class FrameGizmo final : public QObject, public PointerTool {
  Q_OBJECT
 public:
  explicit FrameGizmo(Host& host, QObject* parent = nullptr);
  ~FrameGizmo() override;

  /// Sets the pose of the frame; empty: hides the gizmo.
  void setFrame(const std::optional<Pose>& X_WT);
  /// Reverts a drag; false if nothing is dragged.
  bool cancel();

  bool press(const PointerEvent& event) override;
  bool move(const PointerEvent& event) override;
  bool release(const PointerEvent& event) override;
  bool wheel(const PointerEvent&) override { return false; }
  QString hint() const override;

 signals:
  void dragged(const hapticell::Pose& X_WT);  ///< During a drag.
  void dropped(const hapticell::Pose& X_WT);  ///< At the end of a drag.

 private:
  Gizmo gizmoAt(const Pose& X_WT, const Camera& camera, const ViewSize& view) const;
  void draw();
  Host& host_;
  std::optional<Pose> X_WT_;
  std::optional<Gizmo::Handle> over_;
  struct Drag {
    Gizmo gizmo;
    Gizmo::Handle handle;
    double from = 0.0;
    Pose X_WT;
  };
  std::optional<Drag> drag_;
};

}  // namespace hapticell::app
