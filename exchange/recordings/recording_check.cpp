// SPDX-License-Identifier: Apache-2.0
#include "exchange/recordings/recording_check.h"

#include <algorithm>
#include <cmath>

#include "exchange/recordings/recording_reader.h"

namespace hapticell::exchange {

namespace {

using trajectory::Trajectory;

/// s: half a nanosecond and the rounding of a double at 1e9 s.
constexpr double kClockRounding = 0.6e-9;

bool isEqual(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q == b.q;
}

/// Times of 1e9 s have steps of 0.1 us as doubles.
bool isSameTime(double a, double b) {
  return std::abs(a - b) <= kClockRounding + 1e-15 * std::abs(a);
}

bool isEqual(const Trajectory::Frame& a, const Trajectory::Frame& b, bool with_pose) {
  return isSameTime(a.t, b.t) && (!with_pose || isEqual(a.X_WT, b.X_WT)) && a.by_hand == b.by_hand &&
         a.dwell == b.dwell && a.nameText() == b.nameText() && a.is_pose_apart == b.is_pose_apart;
}

bool isEqual(const Trajectory::Touch& a, const Trajectory::Touch& b) {
  return a == b;
}

template <typename T>
bool areEqual(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return isEqual(x, y); });
}

Expected<void> differs(const std::filesystem::path& file, Text where) {
  return makeError({file.string(), std::move(where), "something else in the written file", "what was recorded",
                    "This is a bug. Please report it."});
}

bool hasSameHead(const Trajectory& a, const Trajectory& b) {
  return a.name == b.name && a.entity == b.entity && a.moved == b.moved && a.take == b.take &&
         a.joint_names == b.joint_names && a.channel_names == b.channel_names && a.has_poses == b.has_poses &&
         a.size() == b.size() && areEqual(a.touches, b.touches);
}

Expected<void> compareMotion(const Trajectory& wanted, const Trajectory& read, const std::filesystem::path& file) {
  if (!hasSameHead(wanted, read)) return differs(file, Text("motion '%1'", wanted.name));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const bool same = isEqual(wanted[i], read[i], wanted.has_poses) && std::ranges::equal(wanted.joints(i), read.joints(i)) &&
                      std::ranges::equal(wanted.channels(i), read.channels(i));
    if (!same) return differs(file, Text("frame %1", i));
  }
  return {};
}

}  // namespace

bool StylusSample::operator==(const StylusSample& other) const {
  return isSameTime(t, other.t) && isEqual(X_DS, other.X_DS) && isEqual(X_DP, other.X_DP) && force_D == other.force_D &&
         torque_D == other.torque_D && buttons == other.buttons && contact == other.contact &&
         isEqual(X_WM, other.X_WM);
}

Expected<void> checkRecording(const Recording& wanted, const std::filesystem::path& written) {
  const auto read = readMcapRecording(written);
  HAPTICELL_TRY(read);
  if (read->motions.size() != wanted.motions.size()) return differs(written, "motions");
  for (std::size_t m = 0; m < wanted.motions.size(); ++m)
    HAPTICELL_TRY(compareMotion(wanted.motions[m], read->motions[m], written));
  if (wanted.stylus.size() != read->stylus.size()) return differs(written, "samples of the stylus");
  for (std::size_t i = 0; i < wanted.stylus.size(); ++i) {
    StylusSample sample = wanted.stylus[i];
    if (!wanted.has_moved_frame) sample.X_WM = Pose::identity();
    if (!(sample == read->stylus[i])) return differs(written, Text("sample %1", i));
  }
  if (!areEqual(wanted.contacts, read->contacts)) return differs(written, "contacts");
  if (wanted.files != read->files) return differs(written, "attached files");
  const auto same_training = [](const auto& a, const auto& b) { return toJsonText(a) == toJsonText(b); };
  if (!std::ranges::equal(wanted.trainings, read->trainings, same_training)) return differs(written, "scores");
  return {};
}

}  // namespace hapticell::exchange
