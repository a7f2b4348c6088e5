// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <string>

#include "manipulation/manipulators/moved_by.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

namespace by = manipulation::by;

/// What the hand takes of an entity (its tool centre point, its base, its origin ...): one choice for all panels and
/// for the module that moves. It holds for the entity taken next. What can be chosen of each way is kept while another
/// one is chosen. GUI thread.
class HoldChoice : public QObject {
  Q_OBJECT
 public:
  using MovedBy = manipulation::MovedBy;
  using QObject::QObject;

  /// All of it, as the manipulation loop takes it.
  const MovedBy& movedBy() const { return moved_by_; }
  /// The chosen way is this one, whatever is chosen of it.
  template <typename Way>
  bool is() const {
    return std::holds_alternative<Way>(moved_by_);
  }
  /// The name of the frame where one is chosen; else empty.
  std::string frame() const { return manipulation::frameOf(moved_by_); }

  /// What a solid turns about, in the order that panels offer: 0 its origin, 1 its centre, 2 a frame.
  int turnsAbout() const {
    if (is<by::Center>()) return 1;
    return is<by::Frame>() ? 2 : 0;
  }

  /// What is taken where nobody has chosen: of a mannequin its right hand, where its arrows are.
  static MovedBy usual(const workcell::Entity& entity) {
    return entity.figure() ? MovedBy(by::Hand{mannequin::Side::kRight}) : MovedBy(by::Default{});
  }
  /// How a mannequin is taken: as was chosen where that is a mannequin's way, else as usual.
  MovedBy movedByFor(const workcell::Entity& mannequin) const {
    return manipulation::isOfBody(moved_by_) ? moved_by_ : withOptions(usual(mannequin));
  }

  /// Chooses a way (and its frame), with what was chosen of it before.
  void set(const MovedBy& way) { change(withOptions(way)); }

  /// Of a robot that is held by its tool: what goes along, what yields.
  const by::Tool& tool() const { return tool_; }
  void setTool(const by::Tool& tool) {
    tool_ = tool;
    change(withOptions(moved_by_));
  }
  /// Of a robot that is held by its base: whether the tool stays where it is.
  bool keepsTool() const { return keeps_tool_; }
  /// By its base, so.
  void setBase(bool keeps_tool) {
    keeps_tool_ = keeps_tool;
    set(by::Base{});
  }

  /// Of a mannequin that is drawn by a hand, both, or the head: what of it does not move, and how both hands go.
  const by::BothHands& hands() const { return hands_; }
  void setHands(const by::BothHands& hands) {
    if (hands == hands_) return;
    hands_ = hands;
    moved_by_ = withOptions(moved_by_);
    emit changed();
  }

  /// As it is where nobody has chosen.
  void forget() {
    moved_by_ = {};
    tool_ = {};
    keeps_tool_ = false;
    hands_ = {};
    emit changed();
  }

  /// Held entities are released; it stays where it is.
  void letGo() { emit letGoWanted(); }

 signals:
  void changed();
  void letGoWanted();

 private:
  MovedBy withOptions(const MovedBy& way) const;
  void change(const MovedBy& moved_by) {
    if (moved_by == moved_by_) return;
    moved_by_ = moved_by;
    emit changed();
  }

  MovedBy moved_by_;
  by::Tool tool_;
  bool keeps_tool_ = false;
  by::BothHands hands_;
};

}  // namespace hapticell::app
