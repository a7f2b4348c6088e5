// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <optional>

#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/pointer_tool.h"
#include "kinematics/model/jog.h"

namespace hapticell::app {

class JointMover;
class RobotContext;

/// Drags the robot's tool centre point with the mouse, along or about the axes of base, tool, world or a frame. The arm
/// follows in its configuration, stops at obstacles, and shows which limit stops it. One drag is one undo step; Escape
/// reverts it.
class TcpGizmo final : public QObject, public PointerTool {
  Q_OBJECT
 public:
  TcpGizmo(RobotContext& context, JointMover& mover, QObject* parent = nullptr);
  ~TcpGizmo() override;

  /// Visible and active only while on.
  void setOn(bool on);
  /// `R_WF`: the axes, if a given frame's.
  void setFrame(kinematics::JogFrame frame, const dquat& R_WF);
  /// Draws the gizmo at the present pose of the tool.
  void showNow();
  /// Reverts a drag; false if nothing is dragged.
  bool cancel();

  bool press(const PointerEvent& event) override;
  bool move(const PointerEvent& event) override;
  bool release(const PointerEvent& event) override;
  bool wheel(const PointerEvent&) override { return false; }
  QString hint() const override;

 signals:
  /// What limits the arm while it is dragged; empty: nothing.
  void held(const QString& why);

 private:
  Gizmo gizmoNow(const Camera& camera, const ViewSize& view) const;
  void follow(const Pose& X_WT);
  RobotContext& context_;
  JointMover& mover_;
  bool on_ = false;
  kinematics::JogFrame frame_ = kinematics::JogFrame::kBase;
  dquat R_WF_{1.0, 0.0, 0.0, 0.0};
  std::optional<Gizmo::Handle> over_;
  struct Drag {
    Gizmo gizmo;
    Gizmo::Handle handle;
    double from = 0.0;
    Pose X_WT;
    std::vector<double> joints;
  };
  std::optional<Drag> drag_;
  QString why_;
};

}  // namespace hapticell::app
