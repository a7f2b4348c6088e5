// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPoint>
#include <array>
#include <optional>

#include "app/viewport/tools/picked_feature.h"

class QAction;
class QMenu;

namespace hapticell::app {

class MannequinContext;

/// Moves the mannequin's hands to a part: one hand to the picked point, both to the two opposite sides of the part
/// there; or seats it on a part that supports it from below (a chair, a stool). The posture of the whole body is
/// computed in a separate thread and respects what is locked; one undo step. A message says what is not reached and by
/// how much. GUI thread.
class HandsToPart : public QObject {
  Q_OBJECT
 public:
  enum class Hands { kLeft, kRight, kBoth };
  /// Makes the menu entries: those of `menu` ask for a pick in the scene; those of the scene's own menu (found by their
  /// names, actionLeftHandHere and so on) use the point that was clicked.
  HandsToPart(MannequinContext& context, QMenu& menu, QObject* parent = nullptr);
  /// Asks for the point by a pick.
  void pick(Hands hands);
  void send(Hands hands, const PickedFeature& place);
  /// Seats the mannequin on a chair's or stool's seat, or at the picked point of a face that looks up.
  void sit(const PickedFeature& place);
  bool isBusy() const { return busy_; }

 private:
  void remember(workcell::EntityId entity, const QPoint& global);
  void showActions();
  void told(Hands hands, const QString& part, const std::array<double, 2>& short_m);
  MannequinContext& context_;
  std::array<QAction*, 3> here_{}, to_{};
  QAction* sit_ = nullptr;
  std::optional<PickedFeature> place_;  ///< Where the scene's menu was opened.
  bool busy_ = false;
};

}  // namespace hapticell::app
