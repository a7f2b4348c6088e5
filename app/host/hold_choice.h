// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <string>

#include "manipulation/engine/manipulation_command.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// What the hand takes of an entity (its tool centre point, its base, its origin ...): one choice for all panels and
/// for the module that moves. It holds for the entity taken next. GUI thread.
class HoldChoice : public QObject {
  Q_OBJECT
 public:
  using Kind = manipulation::MovedBy::Kind;
  using QObject::QObject;
  Kind kind() const { return kind_; }
  /// What is taken where nobody has chosen: of a mannequin its right hand, where its arrows are.
  static Kind usual(const workcell::Entity& entity) { return entity.figure ? Kind::kRightHand : Kind::kDefault; }
  /// What of a mannequin is taken: what was chosen where that is a mannequin's, else the usual.
  Kind kindFor(const workcell::Entity& mannequin) const { return kind_ < Kind::kWhole ? usual(mannequin) : kind_; }
  const std::string& frame() const { return frame_; }  ///< For kFrame: its name.
  /// What else counts for a robot.
  struct Robot {
    bool keep_tcp = false;       ///< By its base: the tool stays where it is.
    bool with_axes = false;      ///< By its tool: what it stands on goes along.
    std::string at_singularity;  ///< As `robot.at_singularity`; empty: as configured.
    bool operator==(const Robot&) const = default;
  };
  const Robot& robot() const { return robot_; }
  /// What of a mannequin does not move while a hand or the head is drawn.
  struct Locks {
    bool trunk = false, pelvis = false, seat = false;
    bool feet = true;          ///< False: they may step.
    bool hands_apart = false;  ///< Of both hands: each goes its own way, else they hold one thing.
    bool operator==(const Locks&) const = default;
  };
  const Locks& locks() const { return locks_; }
  void setLocks(const Locks& locks) {
    if (locks == locks_) return;
    locks_ = locks;
    emit changed();
  }
  void set(Kind kind, const std::string& frame = {}) {
    if (kind == kind_ && frame == frame_) return;
    kind_ = kind;
    frame_ = frame;
    emit changed();
  }
  void set(Kind kind, const Robot& robot) {
    if (kind == kind_ && robot == robot_) return;
    kind_ = kind;
    robot_ = robot;
    frame_.clear();
    emit changed();
  }
  /// All of it, as the manipulation loop takes it.
  manipulation::MovedBy movedBy() const {
    manipulation::MovedBy moved_by{.kind = kind_,
                                   .frame = frame_,
                                   .keep_tcp = robot_.keep_tcp,
                                   .with_axes = robot_.with_axes,
                                   .at_singularity = robot_.at_singularity};
    // Anything else has no trunk to lock and is refused with one.
    if (kind_ < Kind::kWhole) return moved_by;
    moved_by.lock_trunk = locks_.trunk;
    moved_by.lock_pelvis = locks_.pelvis;
    moved_by.on_seat = locks_.seat;
    moved_by.hands_apart = locks_.hands_apart;
    moved_by.may_step = !locks_.feet;
    return moved_by;
  }

  /// As it is where nobody has chosen.
  void forget() {
    kind_ = Kind::kDefault;
    frame_.clear();
    robot_ = {};
    locks_ = {};
    emit changed();
  }

  /// Whoever holds something lets it go; it stays where it is.
  void letGo() { emit letGoWanted(); }

 signals:
  void changed();
  void letGoWanted();

 private:
  Kind kind_ = Kind::kDefault;
  std::string frame_;
  Robot robot_;
  Locks locks_;
};

}  // namespace hapticell::app
