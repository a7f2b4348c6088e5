// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/contact_log.h"

#include <algorithm>
#include <charconv>

namespace hapticell::app {
namespace {

std::string number(double value, int decimals) {
  char text[48];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  return {text, end};
}

/// As RFC 4180 wants it.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

const char* eventWord(ContactEvent::Kind kind) {
  switch (kind) {
    case ContactEvent::Kind::kNearMissBegan:
      return "near_miss_began";
    case ContactEvent::Kind::kContactBegan:
      return "contact_began";
    case ContactEvent::Kind::kContactEnded:
      return "contact_ended";
    case ContactEvent::Kind::kNearMissEnded:
      break;
  }
  return "near_miss_ended";
}

}  // namespace

std::string eventName(ContactEvent::Kind kind) {
  switch (kind) {
    case ContactEvent::Kind::kNearMissBegan:
      return "Near miss began";
    case ContactEvent::Kind::kContactBegan:
      return "Contact began";
    case ContactEvent::Kind::kContactEnded:
      return "Contact ended";
    case ContactEvent::Kind::kNearMissEnded:
      break;
  }
  return "Near miss ended";
}

void ContactLog::add(ContactEvent event) {
  events_.push_back(std::move(event));
  if (events_.size() <= kMost) return;
  events_.pop_front();
  ++dropped_;
}

void ContactLog::clear() {
  events_.clear();
  dropped_ = 0;
}

void ContactLog::follow(Tracker& tracker, const Key& key, const Now& now, const Namer& name_of,
                        ContactEvent::Kind began) {
  const manipulation::PairState& pair = *now.pair;
  const auto [interval, begins] = tracker.see(key, now.time_s);
  State& state = interval.data;
  if (begins) {
    state = {name_of(pair.moved, pair.moved_part), name_of(pair.other, pair.other_part), pair.distance,
             now.force_n};
    add({began, now.time_s, state.moved, state.other, pair.distance, now.force_n, 0.0});
  }
  state.least_distance = std::min(state.least_distance, pair.distance);
  state.greatest_force = std::max(state.greatest_force, now.force_n);
}

void ContactLog::endThose(Tracker& tracker, double time_s, bool all, ContactEvent::Kind ended) {
  const auto end = [&](const Tracker::Interval& interval) {
    const State& state = interval.data;
    add({ended, interval.seen, state.moved, state.other, state.least_distance, state.greatest_force,
         interval.seen - interval.began});
  };
  if (all)
    tracker.endAll(end);
  else
    tracker.endOlder(time_s, kPause, end);
}

void ContactLog::take(const manipulation::SceneSnapshot& snapshot, const Namer& name_of) {
  if (snapshot.time_s == last_s_) return;
  const bool new_loop = snapshot.time_s < last_s_;
  endThose(touching_, last_s_, new_loop, ContactEvent::Kind::kContactEnded);
  endThose(near_, last_s_, new_loop, ContactEvent::Kind::kNearMissEnded);
  last_s_ = snapshot.time_s;
  for (const manipulation::PairState& pair : snapshot.pairs) {
    const Key key{pair.moved, pair.moved_part, pair.other, pair.other_part};
    const Now now{&pair, snapshot.time_s, snapshot.stylus.force_n};
    if (pair.near_miss || pair.contact) follow(near_, key, now, name_of, ContactEvent::Kind::kNearMissBegan);
    if (pair.contact) follow(touching_, key, now, name_of, ContactEvent::Kind::kContactBegan);
  }
  const bool released = snapshot.stylus.held == 0;
  endThose(touching_, snapshot.time_s, released, ContactEvent::Kind::kContactEnded);
  endThose(near_, snapshot.time_s, released, ContactEvent::Kind::kNearMissEnded);
}

std::string ContactLog::csv() const {
  std::string text = "t,event,moved,against,distance,force,duration\n";
  for (const ContactEvent& event : events_)
    text += number(event.time_s, 3) + "," + eventWord(event.kind) + "," + quoted(event.moved) + "," +
            quoted(event.other) + "," + number(event.distance, 6) + "," + number(event.force_n, 3) + "," +
            number(event.duration_s, 3) + "\n";
  return text;
}

}  // namespace hapticell::app
