// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <string>

#include "manipulation/manipulators/moved_by.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

namespace by = manipulation::by;

/// What of an entity the hand takes (its tool centre point, its base, its origin and so on): one choice for all panels
/// and for the module that moves entities. It applies to the entity taken next. Options of each way are kept while
/// another way is chosen. GUI thread.
class HoldChoice : public QObject {
  Q_OBJECT
 public:
  using MovedBy = manipulation::MovedBy;
  using QObject::QObject;

  /// The choice with its options, as the manipulation loop takes it.
  const MovedBy& movedBy() const { return moved_by_; }
  /// True if this way is chosen, whatever its options.
  template <typename Way>
  bool is() const {
    return std::holds_alternative<Way>(moved_by_);
  }
  /// The name of the frame if a frame is chosen; else empty.
  std::string frame() const { return manipulation::frameOf(moved_by_); }

  /// What a solid turns about, as an index into the panels' list: 0 its origin, 1 its centre, 2 a frame.
  int turnsAbout() const {
    if (is<by::Center>()) return 1;
    return is<by::Frame>() ? 2 : 0;
  }

  /// The default: a mannequin's right hand, where its arrows are; the usual for all other entities.
  static MovedBy usual(const workcell::Entity& entity) {
    return entity.figure() ? MovedBy(by::Hand{mannequin::Side::kRight}) : MovedBy(by::Default{});
  }
  /// How a mannequin is taken: the chosen way if it is one for mannequins, else the default.
  MovedBy movedByFor(const workcell::Entity& mannequin) const {
    return manipulation::isOfBody(moved_by_) ? moved_by_ : withOptions(usual(mannequin));
  }

  /// Chooses a way (and its frame), with the options that were chosen for it before.
  void set(const MovedBy& way) { change(withOptions(way)); }

  /// For a robot that is held by its tool: what moves along, what yields.
  const by::Tool& tool() const { return tool_; }
  void setTool(const by::Tool& tool) {
    tool_ = tool;
    change(withOptions(moved_by_));
  }
  /// For a robot that is held by its base: whether the tool keeps its pose.
  bool keepsTool() const { return keeps_tool_; }
  /// Chooses the base, with this option.
  void setBase(bool keeps_tool) {
    keeps_tool_ = keeps_tool;
    set(by::Base{});
  }

  /// For a mannequin that is moved by a hand, both hands, or the head: what stays in place, and how both hands move.
  const by::BothHands& hands() const { return hands_; }
  void setHands(const by::BothHands& hands) {
    if (hands == hands_) return;
    hands_ = hands;
    moved_by_ = withOptions(moved_by_);
    emit changed();
  }

  /// Resets everything to the defaults.
  void forget() {
    moved_by_ = {};
    tool_ = {};
    keeps_tool_ = false;
    hands_ = {};
    emit changed();
  }

  /// Asks for the release of held entities; the choice does not change.
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
