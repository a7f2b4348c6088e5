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

/// Moves and turns what is selected by the mouse, along and about the axes of world, parent, the entity itself or a
/// frame of the cell, at the place that the hand would take it by (HoldChoice). Several go together. A drag is one step
/// of undo; Escape takes it back. Nothing that a module holds is moved. GUI thread.
class EntityGizmo final : public QObject, public PointerTool {
  Q_OBJECT
 public:
  enum class Mode { kSelect, kMove, kRotate };

  explicit EntityGizmo(Host& host, QObject* parent = nullptr);
  ~EntityGizmo() override;

  Mode mode() const { return mode_; }
  void setMode(Mode mode);
  EditAxes axes() const { return axes_; }
  /// `R_WF`: the axes for kFrame.
  void setAxes(EditAxes axes, const dquat& R_WF = {1.0, 0.0, 0.0, 0.0});
  void setSteps(const EditSteps& steps) { steps_ = steps; }
  /// Whether drags go to corners, edges, faces and frames under the pointer; Ctrl turns it round while held.
  void setSnapping(bool on) { snapping_ = on; }
  bool snapping() const { return snapping_; }

  /// The frame that it stands in now; nothing where nothing that may be moved is selected.
  std::optional<Pose> pose_W() const;
  /// Moves by these numbers along and about its axes, turned first: x, y, z (m), and a rotation vector (rad). One step.
  void moveBy(const Twist& motion_G);
  /// The same motion for all that is selected, given in W; one step with this text.
  void applyMotion(const Pose& M_W, const QString& text);
  /// Draws it where its entities stand now.
  void showNow();
  /// Takes a drag back; false where none is.
  bool cancel();

  bool press(const PointerEvent& event) override;
  bool move(const PointerEvent& event) override;
  bool release(const PointerEvent& event) override;
  bool wheel(const PointerEvent&) override { return false; }
  QString hint() const override;

 signals:
  void modeChanged();
  /// While a drag goes on: how far along x, y, z (m) and about them (rad) since it began.
  void dragged(const hapticell::Twist& motion_G);

 private:
  struct Drag {
    Gizmo gizmo;
    Gizmo::Handle handle;
    double from = 0.0;   // Value, or
    dvec3 p_WFrom{0.0};  // point where the free middle was taken.
    std::vector<workcell::EntityId> ids;
    std::vector<Pose> X_WE;  // As it began, of each.
    QString number;          // How far it is by now.
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
