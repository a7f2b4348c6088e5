// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/pointer_tool.h"
#include "manipulation/engine/manipulation_command.h"

namespace hapticell::app {

class FigureDrag;
class MannequinContext;

/// Drags the chosen part of the mannequin (a hand, both, the head, all of it) with the mouse, along or about the axes
/// of the cell. The body follows; if the target is out of reach, it says by how many millimetres. Escape reverts a
/// drag.
class HandGizmo final : public QObject, public PointerTool {
  Q_OBJECT
 public:
  HandGizmo(MannequinContext& context, FigureDrag& drag, QObject* parent = nullptr);
  ~HandGizmo() override;

  void setOn(bool on);
  void showNow();
  bool cancel();

  bool press(const PointerEvent& event) override;
  bool move(const PointerEvent& event) override;
  bool release(const PointerEvent& event) override;
  bool wheel(const PointerEvent&) override { return false; }
  QString hint() const override;

 private:
  manipulation::MovedBy held() const;
  Pose frame_W() const;
  bool isReady() const;
  Gizmo gizmoNow(const Camera& camera, const ViewSize& view) const;
  MannequinContext& context_;
  FigureDrag& figure_;
  bool on_ = false;
  std::optional<Gizmo::Handle> over_;
  struct Drag {
    Gizmo gizmo;
    Gizmo::Handle handle;
    double from = 0.0;
    Pose X_WM;
  };
  std::optional<Drag> drag_;
};

/// "Right hand is 62 mm short of the target", "Right hand touches Bench"; empty if it is at the target.
QString reachText(const FigureDrag& drag, const manipulation::MovedBy& held);
/// "Right hand".
QString nameOfHeld(const manipulation::MovedBy& held);

}  // namespace hapticell::app
