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

/// Sends the mannequin's hands to a part: one hand to the place that is picked, both to the two opposite sides of the
/// part there; or seats it on a part that bears it from below (a chair, a stool). The whole body finds its posture in a
/// thread of its own, with what is locked; one step of undo. What is not reached is said in a message, with by how
/// much. GUI thread.
class HandsToPart : public QObject {
  Q_OBJECT
 public:
  enum class Hands { kLeft, kRight, kBoth };
  /// Makes the entries: those of `menu` ask for a place in the scene, those of the scene's own menu (found by their
  /// names, actionLeftHandHere and so on) take the place of its click.
  HandsToPart(MannequinContext& context, QMenu& menu, QObject* parent = nullptr);
  /// Asks for the place by a pick.
  void pick(Hands hands);
  void send(Hands hands, const PickedFeature& place);
  /// On a chair's or stool's seat, or at the picked place of a face that looks up.
  void sit(const PickedFeature& place);
  bool isBusy() const { return busy_; }

 private:
  void remember(workcell::EntityId entity, const QPoint& global);
  void showActions();
  void told(Hands hands, const QString& part, const std::array<double, 2>& short_m);
  MannequinContext& context_;
  std::array<QAction*, 3> here_{}, to_{};
  QAction* sit_ = nullptr;
  std::optional<PickedFeature> place_;  ///< Of the scene's menu.
  bool busy_ = false;
};

}  // namespace hapticell::app
