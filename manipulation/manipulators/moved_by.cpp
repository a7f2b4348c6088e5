// SPDX-License-Identifier: Apache-2.0
#include "manipulation/manipulators/moved_by.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace hapticell::manipulation {

namespace {

constexpr std::string_view kNamedFrame = "frame:";

tl::unexpected<Error> unknownWord(const std::string& key, const std::string& text, const std::string& choices) {
  return makeError({.file = {}, .place = key, .found = "'" + text + "'", .expected = choices, .fix = {}});
}

}  // namespace

Expected<MovedBy> parseMovedBy(const std::string& text) {
  using Kind = MovedBy::Kind;
  const std::pair<const char*, Kind> words[] = {{"tcp", Kind::kTcp},
                                                {"base", Kind::kBase},
                                                {"self_origin", Kind::kSelfOrigin},
                                                {"geometric_center", Kind::kGeometricCenter},
                                                {"whole", Kind::kWhole},
                                                {"left_hand", Kind::kLeftHand},
                                                {"right_hand", Kind::kRightHand},
                                                {"both_hands", Kind::kBothHands},
                                                {"head", Kind::kHead}};
  for (const auto& [word, kind] : words) {
    if (text == word) return MovedBy{kind};
  }
  if (text == "tcp_with_axes") return MovedBy{.kind = Kind::kTcp, .with_axes = true};
  if (text == "base_keeping_tcp") return MovedBy{.kind = Kind::kBase, .keep_tcp = true};
  if (text.starts_with(kNamedFrame) && text.size() > kNamedFrame.size()) {
    return MovedBy{Kind::kFrame, text.substr(kNamedFrame.size())};
  }
  return unknownWord(
      "moved_by", text,
      "tcp, tcp_with_axes, base, base_keeping_tcp, self_origin, geometric_center, frame:NAME, whole, left_hand, "
      "right_hand, both_hands or head");
}

Expected<void> parseLock(const std::string& text, MovedBy& moved_by) {
  MovedBy locked = moved_by;
  locked.lock_trunk = locked.lock_pelvis = locked.on_seat = false;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (word == "trunk") {
      locked.lock_trunk = true;
    } else if (word == "pelvis") {
      locked.lock_pelvis = true;
    } else if (word == "seat") {
      locked.on_seat = true;
    } else if (word != "feet" && word != "none") {
      return unknownWord("lock", word, "trunk, feet, pelvis, seat or none");
    }
    begin = end + 1;
  }
  moved_by = locked;
  return {};
}

std::string wordOf(const MovedBy& moved_by, bool is_robot) {
  switch (moved_by.kind) {
    case MovedBy::Kind::kDefault:
      return is_robot ? "tcp" : "self_origin";
    case MovedBy::Kind::kTcp:
      return moved_by.with_axes ? "tcp_with_axes" : "tcp";
    case MovedBy::Kind::kBase:
      return moved_by.keep_tcp ? "base_keeping_tcp" : "base";
    case MovedBy::Kind::kSelfOrigin:
      return "self_origin";
    case MovedBy::Kind::kGeometricCenter:
      return "geometric_center";
    case MovedBy::Kind::kFrame:
      return "frame:" + moved_by.frame;
    case MovedBy::Kind::kWhole:
      return "whole";
    case MovedBy::Kind::kLeftHand:
      return "left_hand";
    case MovedBy::Kind::kRightHand:
      return "right_hand";
    case MovedBy::Kind::kHead:
      return "head";
    case MovedBy::Kind::kBothHands:
      return "both_hands";
  }
  return {};
}

}  // namespace hapticell::manipulation
