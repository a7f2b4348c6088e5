// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/moved_by.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "geometry/system/overloaded.h"

namespace hapticell::manipulation {

namespace {

constexpr std::string_view kNamedFrame = "frame:";

}  // namespace

tl::unexpected<Error> unknownWord(const std::string& key, const std::string& text, Text choices) {
  return makeError({.place = key, .found = "'" + text + "'", .expected = std::move(choices)});
}

bool isSameWay(const MovedBy& a, const MovedBy& b) {
  if (a.index() != b.index()) return false;
  const auto* hand = std::get_if<by::Hand>(&a);
  return hand == nullptr || hand->side == std::get<by::Hand>(b).side;
}

bool isOfBody(const MovedBy& moved_by) {
  return std::visit(Overloaded{
                        [](const by::Default&) { return false; },
                        [](const by::Tool&) { return false; },
                        [](const by::Base&) { return false; },
                        [](const by::Origin&) { return false; },
                        [](const by::Center&) { return false; },
                        [](const by::Frame&) { return false; },
                        [](const by::Whole&) { return true; },
                        [](const by::Hand&) { return true; },
                        [](const by::BothHands&) { return true; },
                        [](const by::Head&) { return true; },
                    },
                    moved_by);
}

std::string frameOf(const MovedBy& moved_by) {
  const auto* frame = std::get_if<by::Frame>(&moved_by);
  return frame == nullptr ? std::string() : frame->name;
}

const by::Tool* toolOf(const MovedBy& moved_by) {
  if (const auto* usual = std::get_if<by::Default>(&moved_by)) return &usual->tool;
  return std::get_if<by::Tool>(&moved_by);
}

by::Tool* toolOf(MovedBy& moved_by) {
  return const_cast<by::Tool*>(toolOf(std::as_const(moved_by)));
}

const BodyLocks* locksOf(const MovedBy& moved_by) {
  return std::visit(
      [](const auto& way) -> const BodyLocks* {
        if constexpr (requires { way.locks; }) {
          return &way.locks;
        } else {
          return nullptr;
        }
      },
      moved_by);
}

BodyLocks* locksOf(MovedBy& moved_by) {
  return const_cast<BodyLocks*>(locksOf(std::as_const(moved_by)));
}

Expected<MovedBy> parseMovedBy(const std::string& text) {
  using mannequin::Side;
  const std::pair<const char*, MovedBy> words[] = {{"tcp", by::Tool{}},
                                                   {"tcp_with_axes", by::Tool{.with_axes = true}},
                                                   {"base", by::Base{}},
                                                   {"base_keeping_tcp", by::Base{.keeps_tool = true}},
                                                   {"self_origin", by::Origin{}},
                                                   {"geometric_center", by::Center{}},
                                                   {"whole", by::Whole{}},
                                                   {"left_hand", by::Hand{Side::kLeft}},
                                                   {"right_hand", by::Hand{Side::kRight}},
                                                   {"both_hands", by::BothHands{}},
                                                   {"head", by::Head{}}};
  for (const auto& [word, moved_by] : words) {
    if (text == word) return moved_by;
  }
  if (text.starts_with(kNamedFrame) && text.size() > kNamedFrame.size()) {
    return by::Frame{.name = text.substr(kNamedFrame.size())};
  }
  return unknownWord(
      "moved_by", text,
      Text("tcp, tcp_with_axes, base, base_keeping_tcp, self_origin, geometric_center, frame:NAME, whole, left_hand, "
           "right_hand, both_hands or head"));
}

Expected<BodyLocks> parseLock(const std::string& text) {
  BodyLocks locks;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (word == "trunk") {
      locks.trunk = true;
    } else if (word == "pelvis") {
      locks.pelvis = true;
    } else if (word == "seat") {
      locks.seat = true;
    } else if (word != "feet" && word != "none") {
      return unknownWord("lock", word, Text("trunk, feet, pelvis, seat or none"));
    }
    begin = end + 1;
  }
  return locks;
}

Expected<void> setLocks(MovedBy& moved_by, const BodyLocks& locks) {
  if (BodyLocks* own = locksOf(moved_by)) {
    *own = locks;
  } else if (locks.any() && !isOfBody(moved_by)) {
    std::string lock = locks.pelvis ? "pelvis" : "seat";
    if (locks.trunk) lock = "trunk";
    return unknownWord("lock", lock, Text("no lock, because %1 moves no part of a mannequin", wordOf(moved_by, false)));
  }
  return {};
}

std::string wordOf(const MovedBy& moved_by, bool is_robot) {
  return std::visit(Overloaded{
                        [&](const by::Default&) { return std::string(is_robot ? "tcp" : "self_origin"); },
                        [](const by::Tool& tool) { return std::string(tool.with_axes ? "tcp_with_axes" : "tcp"); },
                        [](const by::Base& base) { return std::string(base.keeps_tool ? "base_keeping_tcp" : "base"); },
                        [](const by::Origin&) { return std::string("self_origin"); },
                        [](const by::Center&) { return std::string("geometric_center"); },
                        [](const by::Frame& frame) { return std::string(kNamedFrame) + frame.name; },
                        [](const by::Whole&) { return std::string("whole"); },
                        [](const by::Hand& hand) {
                          return std::string(hand.side == mannequin::Side::kLeft ? "left_hand" : "right_hand");
                        },
                        [](const by::BothHands&) { return std::string("both_hands"); },
                        [](const by::Head&) { return std::string("head"); },
                    },
                    moved_by);
}

}  // namespace hapticell::manipulation
