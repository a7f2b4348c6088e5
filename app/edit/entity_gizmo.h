// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>
#include <optional>
#include <vector>

#include "app/edit/moved_entities.h"
#include "app/edit/snap.h"
#include "app/viewport/tools/gizmo.h"
#include "app/viewport/tools/pointer_tool.h"

namespace hapticell::app {

class Host;

/// Steps of a drag; 0: none.
struct EditSteps {
  double length = 0.0;  ///< m
  double angle = 0.0;   ///< rad
};

/// Moves and turns the selection by mouse, along and about the axes of the world, the parent, the entity itself or a
/// frame of the cell; the gizmo's origin is where the hand would take the entity (HoldChoice). Selected entities move
/// together. A drag is one undo step; Escape reverts it. What a module holds is not moved. GUI thread.
class EntityGizmo final : public QObject, public PointerTool {
  Q_OBJECT
 public:
  enum class Mode { kSelect, kMove, kRotate };

  explicit EntityGizmo(Host& host, QObject* parent = nullptr);
  ~EntityGizmo() override;

  Mode mode() const { return mode_; }
  void setMode(Mode mode);
  EditAxes axes() const { return axes_; }
  /// `R_WF`: the axes for EditAxes::kFrame.
  void setAxes(EditAxes axes, const dquat& R_WF = {1.0, 0.0, 0.0, 0.0});
  void setSteps(const EditSteps& steps) { steps_ = steps; }
  /// Whether drags snap to corners, edges, faces and frames under the pointer; Ctrl inverts it while held.
  void setSnapping(bool on) { snapping_ = on; }
  bool snapping() const { return snapping_; }

  /// The gizmo's present frame; empty if nothing that may be moved is selected.
  std::optional<Pose> pose_W() const;
  /// Moves by x, y, z (m) and a rotation vector (rad) along and about the gizmo's axes; turns first. One undo step.
  void moveBy(const Twist& motion_G);
  /// Applies this motion, given in W, to everything that is selected; one undo step with this text.
  void applyMotion(const Pose& M_W, const QString& text);
  /// Draws the gizmo at the present pose of its entities.
  void showNow();
  /// Reverts a drag; false if nothing is dragged.
  bool cancel();

  bool press(const PointerEvent& event) override;
  bool move(const PointerEvent& event) override;
  bool release(const PointerEvent& event) override;
  bool wheel(const PointerEvent&) override { return false; }
  QString hint() const override;

 signals:
  void modeChanged();
  /// Emitted during a drag: motion along x, y, z (m) and about them (rad) since it began.
  void dragged(const hapticell::Twist& motion_G);

 private:
  struct Drag {
    Gizmo gizmo;
    Gizmo::Handle handle;
    double from = 0.0;   // Value at the start, or the
    dvec3 p_WFrom{0.0};  // point where the middle handle was taken.
    std::vector<workcell::EntityId> ids;
    std::vector<Pose> X_WE;  // Of each entity, at the start.
    QString number;          // The distance or angle so far, as text.
    std::optional<SnapPoint> snap;
  };
  Gizmo gizmoAt(const Pose& X_WG, const Camera& camera, const ViewSize& view) const;
  std::vector<workcell::EntityId> moved() const;
  bool isShownElsewhere(const std::vector<workcell::EntityId>& ids) const;  ///< Held or carried by a hand, or played.
  Pose dragPose(const PointerEvent& event);
  double valueNow(const PointerEvent& event, double otherwise);
  double snappedValue(double value) const;
  void follow(const Pose& M_W);
  QString stepText(bool turns) const;

  Host& host_;
  Mode mode_ = Mode::kSelect;
  EditAxes axes_ = EditAxes::kWorld;
  dquat R_WF_{1.0, 0.0, 0.0, 0.0};
  EditSteps steps_;
  bool snapping_ = false;
  std::optional<Gizmo::Handle> over_;
  std::optional<Drag> drag_;
};

}  // namespace hapticell::app
