// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <string>

#include "manipulation/manipulation_command.h"

namespace hapticell::app {

/// What the hand takes of an entity (its tool centre point, its base, its origin ...): one choice for all panels and
/// for the module that moves. It holds for the entity taken next. GUI thread.
class HoldChoice : public QObject {
  Q_OBJECT
 public:
  using Kind = manipulation::MovedBy::Kind;
  using QObject::QObject;
  Kind kind() const { return kind_; }
  const std::string& frame() const { return frame_; }  ///< For kFrame: its name.
  void set(Kind kind, const std::string& frame = {}) {
    if (kind == kind_ && frame == frame_) return;
    kind_ = kind;
    frame_ = frame;
    emit changed();
  }

 signals:
  void changed();

 private:
  Kind kind_ = Kind::kDefault;
  std::string frame_;
};

}  // namespace hapticell::app
