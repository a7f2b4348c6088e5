// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>

#include "mannequin/posture/posture.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class Host;

/// The mannequin that the panels of this folder and of the ergonomics show: the selected one, else the one that was
/// selected last, else the first of the cell. GUI thread.
class MannequinContext : public QObject {
  Q_OBJECT
 public:
  explicit MannequinContext(Host& host, QObject* parent = nullptr);

  Host& host() const { return host_; }
  /// The mannequin of the document; null without a mannequin.
  const workcell::Entity* entity() const;
  /// The present posture, including a running hold or a played motion. Only valid if there is a mannequin.
  mannequin::Posture posture() const;
  /// The solid or robot selected last, at which the mannequin looks. Null if there is no such entity.
  const workcell::Entity* target() const;
  bool isHeld() const;
  /// False while it is held or locked, when nothing may be set.
  bool isFree() const;

 signals:
  void mannequinChanged();  ///< Another mannequin, or its size, name or lock changed.
  void documentChanged();   ///< Anything in the document.

 private:
  void follow();
  Host& host_;
  workcell::EntityId id_ = 0, target_ = 0;
  std::shared_ptr<const workcell::Entity> seen_;
};

}  // namespace hapticell::app
