// SPDX-License-Identifier: Apache-2.0
#include "trajectory/editing/editing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trajectory/motion/number_text.h"

namespace hapticell::trajectory {

namespace {

// m a rad, to compare turning with moving: a hand-sized tool, as in retiming's options. Half: joined turns are twice as
// fast; twice: half as fast.
constexpr double kMetresPerRadian = 0.1;
// s between two frames: a frame of a 1000 Hz loop. Half: frames denser than any recording; twice: two frames of such a
// recording cannot be joined without a change of time.
constexpr double kLeastTime = 1e-3;

Error wrong(Text place, Text found, Text expected) {
  return {.place = std::move(place), .found = std::move(found), .expected = std::move(expected)};
}

/// Without joints and channels: what is left when frames are put elsewhere.
Trajectory posesOnly(const Trajectory& trajectory) {
  Trajectory copy = trajectory.emptyCopy();
  copy.joint_names.clear();
  return copy;
}

/// Appends frame `i`, `shift` seconds later.
void append(Trajectory& to, const Trajectory& from, std::size_t i, double shift) {
  Trajectory::Frame frame = from[i];
  frame.t += shift;
  const bool same_joints = to.joint_names.size() == from.joint_names.size();
  const bool same_channels = to.channel_names == from.channel_names;
  to.addFrame(frame, same_joints ? from.joints(i) : std::span<const double>(),
              same_channels ? from.channels(i) : std::span<const double>());
}

/// Adds the place at `t`, `shift` seconds later, unless a frame stands there.
void appendPlace(Trajectory& to, const Trajectory& from, double t, double shift) {
  const auto joints = from.jointsAt(t);
  to.addFrame({t + shift, from.poseAt(t), false, 0.0, nullptr, from.hasJoints() && from.has_poses}, joints);
}

Expected<void> checkFrame(const Trajectory& trajectory, std::size_t i) {
  if (i < trajectory.size()) return {};
  return makeError(wrong(Text("frame %1", i), Text("this frame does not exist"),
                         Text("a frame number from 0 to less than %1", trajectory.size())));
}

Expected<void> checkWay(const Trajectory& trajectory, const StraightWay& way) {
  if (trajectory.empty()) return makeError(wrong(Text("frames"), Text("none"), Text("a motion")));
  if (!(way.length > 0.0) || !(way.speed > 0.0) || !(glm::length(way.direction_T) > 1e-9)) {
    return makeError(
        wrong(Text("approach or retract"), Text("a length, speed or direction that is zero"), Text("values above 0")));
  }
  return {};
}

Pose farEnd(const Pose& X_WT, const StraightWay& way) {
  return {X_WT.p + X_WT.rotate(way.length * glm::normalize(way.direction_T)), X_WT.q};
}

}  // namespace

Expected<Trajectory> trimmed(const Trajectory& trajectory, double t0, double t1) {
  if (trajectory.empty()) return makeError(wrong(Text("frames"), Text("none"), Text("a motion")));
  const double first = std::max(t0, trajectory[0].t), last = std::min(t1, trajectory.frames().back().t);
  if (!(first <= last)) {
    return makeError(wrong(Text("times"), Text("%1 s to %2 s", shortestText(t0), shortestText(t1)),
                           Text("a range within %1 s to %2 s", shortestText(trajectory[0].t),
                                shortestText(trajectory.frames().back().t))));
  }
  Trajectory result = trajectory.emptyRecording();
  const auto isFrame = [&](double t) {
    return std::any_of(trajectory.frames().begin(), trajectory.frames().end(), [t](const auto& f) { return f.t == t; });
  };
  if (!isFrame(first)) appendPlace(result, trajectory, first, -first);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (trajectory[i].t >= first && trajectory[i].t <= last) append(result, trajectory, i, -first);
  }
  if (!isFrame(last)) appendPlace(result, trajectory, last, -first);
  for (Trajectory::Touch touch : trajectory.touches) {
    if (touch.t_out < first || touch.t_in > last) continue;
    touch.t_in = std::max(touch.t_in, first) - first;
    touch.t_out = std::min(touch.t_out, last) - first;
    result.touches.push_back(touch);
  }
  return result;
}

Expected<std::pair<Trajectory, Trajectory>> splitAt(const Trajectory& trajectory, double t) {
  if (trajectory.size() < 2 || !(t > trajectory[0].t) || !(t < trajectory.frames().back().t)) {
    return makeError(
        wrong(Text("time"), Text("%1 s", shortestText(t)), Text("a time between the first and the last frame")));
  }
  auto before = trimmed(trajectory, trajectory[0].t, t), after = trimmed(trajectory, t, trajectory.frames().back().t);
  HAPTICELL_TRY(before);
  HAPTICELL_TRY(after);
  return std::pair{std::move(*before), std::move(*after)};
}

Expected<Trajectory> joined(std::span<const Trajectory> parts, double speed) {
  if (parts.size() < 2) return makeError(wrong(Text("motions"), Text("%1", parts.size()), Text("two or more")));
  if (!(speed > 0.0))
    return makeError(wrong(Text("speed"), Text("%1 m/s", shortestText(speed)), Text("a value above 0")));
  Trajectory result = parts.front().emptyRecording();
  double shift = parts.front().empty() ? 0.0 : -parts.front()[0].t;
  for (const Trajectory& part : parts) {
    if (part.entity != parts.front().entity || part.joint_names != parts.front().joint_names) {
      return makeError(wrong(Text("motion '%1'", part.name), Text("another entity or other joints"),
                             Text("the same as in the first")));
    }
    if (part.empty()) continue;
    if (!result.empty()) {
      const auto& end = result.frames().back();
      const PoseDistance way = distanceBetween(end.X_WT, part[0].X_WT);
      const double time = (way.position + kMetresPerRadian * way.angle) / speed;
      shift = end.t + std::max(time, kLeastTime) - part[0].t;
    }
    for (std::size_t i = 0; i < part.size(); ++i) append(result, part, i, shift);
    for (Trajectory::Touch touch : part.touches) {
      touch.t_in += shift;
      touch.t_out += shift;
      result.touches.push_back(touch);
    }
  }
  return result;
}

Expected<Trajectory> resampled(const Trajectory& trajectory, double step) {
  if (trajectory.empty()) return makeError(wrong(Text("frames"), Text("none"), Text("a motion")));
  if (!(step > 0.0) || trajectory.duration() / step > 1e7) {
    return makeError(wrong(Text("step"), Text("%1 s", shortestText(step)),
                           Text("a step above 0 that gives at most 10 million frames")));
  }
  std::vector<double> times;
  const double begin = trajectory[0].t, end = trajectory.frames().back().t;
  const auto count = static_cast<std::size_t>((end - begin) / step + 1e-9);
  for (std::size_t i = 0; i <= count; ++i) times.push_back(begin + step * static_cast<double>(i));
  Trajectory result = trajectory.emptyCopy();
  std::size_t next = 0;
  const auto keep = [&](std::size_t i) { return trajectory[i].isSet() || i + 1 == trajectory.size(); };
  for (const double t : times) {
    for (; next < trajectory.size() && trajectory[next].t <= t; ++next) {
      if (keep(next)) append(result, trajectory, next, -begin);
    }
    const bool given = next > 0 && trajectory[next - 1].t == t;
    const bool apart = given ? trajectory[next - 1].is_pose_apart : trajectory.hasJoints() && trajectory.has_poses;
    result.addFrame({t - begin, trajectory.poseAt(t), false, 0.0, nullptr, apart}, trajectory.jointsAt(t));
  }
  for (; next < trajectory.size(); ++next) {
    if (keep(next)) append(result, trajectory, next, -begin);
  }
  return result;
}

Trajectory reversed(const Trajectory& trajectory) {
  Trajectory result = trajectory.emptyRecording();
  if (trajectory.empty()) return result;
  const double last = trajectory.frames().back().t;
  result.reserve(trajectory.size());
  for (std::size_t i = trajectory.size(); i-- > 0;) {
    Trajectory::Frame frame = trajectory[i];
    frame.t = last - frame.t;
    result.addFrame(frame, trajectory.joints(i), trajectory.channels(i));
  }
  for (auto touch = trajectory.touches.rbegin(); touch != trajectory.touches.rend(); ++touch) {
    result.touches.push_back({last - touch->t_out, last - touch->t_in, touch->first, touch->second, touch->max_force});
  }
  return result;
}

Trajectory mirrored(const Trajectory& trajectory, const dvec3& p_W, const dvec3& nhat_W) {
  const dvec3 n = glm::normalize(nhat_W);
  const dmat3 reflection = dmat3(1.0) - 2.0 * glm::outerProduct(n, n);
  const dmat3 own(dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1));
  Trajectory result = posesOnly(trajectory);
  result.reserve(trajectory.size());
  for (const Trajectory::Frame& frame : trajectory.frames()) {
    Trajectory::Frame copy = frame;
    copy.X_WT.p = p_W + reflection * (frame.X_WT.p - p_W);
    copy.X_WT.q = glm::normalize(glm::quat_cast(reflection * glm::mat3_cast(frame.X_WT.q) * own));
    result.addFrame(copy);
  }
  return result;
}

Trajectory transformed(const Trajectory& trajectory, const Pose& X_WN) {
  Trajectory result = posesOnly(trajectory);
  result.reserve(trajectory.size());
  for (const Trajectory::Frame& frame : trajectory.frames()) {
    Trajectory::Frame copy = frame;
    copy.X_WT = X_WN * frame.X_WT;
    result.addFrame(copy);
  }
  return result;
}

Expected<Trajectory> withFrame(const Trajectory& trajectory, double t, const Pose& X_WT) {
  for (const Trajectory::Frame& frame : trajectory.frames()) {
    if (std::abs(frame.t - t) >= kLeastTime) continue;
    return makeError(
        wrong(Text("time"), Text("there is a frame at %1 s", shortestText(frame.t)), Text("a time without a frame")));
  }
  Trajectory result = posesOnly(trajectory);
  bool added = false;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!added && trajectory[i].t > t) added = result.addFrame({t, X_WT, true});
    append(result, trajectory, i, 0.0);
  }
  if (!added) result.addFrame({t, X_WT, true});
  return result;
}

Expected<Trajectory> withFrameAt(const Trajectory& trajectory, std::size_t i, const Pose& X_WT, double reach) {
  HAPTICELL_TRY(checkFrame(trajectory, i));
  const Twist way_W = difference(X_WT, trajectory[i].X_WT);
  Trajectory result = posesOnly(trajectory);
  result.reserve(trajectory.size());
  for (std::size_t k = 0; k < trajectory.size(); ++k) {
    Trajectory::Frame frame = trajectory[k];
    double away = k == i ? 0.0 : 1.0;
    if (reach > 0.0) away = std::abs(frame.t - trajectory[i].t) / reach;
    const double share = away < 1.0 ? std::pow(1.0 - away * away, 2) : 0.0;
    frame.X_WT = displaced(frame.X_WT, Twist{share * way_W.linear, share * way_W.angular});
    if (k == i) frame.by_hand = true;
    result.addFrame(frame);
  }
  return result;
}

Expected<Trajectory> withoutFrames(const Trajectory& trajectory, std::size_t first, std::size_t last) {
  for (const std::size_t i : {first, last}) {
    HAPTICELL_TRY(checkFrame(trajectory, i));
  }
  if (first > last || last - first + 1 >= trajectory.size()) {
    return makeError(
        wrong(Text("frames"), Text("%1 to %2", first, last), Text("a range that leaves at least one frame")));
  }
  Trajectory result = trajectory.emptyRecording();
  result.touches = trajectory.touches;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (i < first || i > last) append(result, trajectory, i, 0.0);
  }
  return result;
}

Expected<Trajectory> withDwell(const Trajectory& trajectory, std::size_t i, double seconds) {
  HAPTICELL_TRY(checkFrame(trajectory, i));
  if (!(seconds >= 0.0) || !std::isfinite(seconds)) {
    return makeError(wrong(Text("dwell"), Text("%1 s", shortestText(seconds)), Text("a time of 0 s or more")));
  }
  Trajectory result = trajectory.emptyRecording();
  result.touches = trajectory.touches;
  for (std::size_t k = 0; k < trajectory.size(); ++k) {
    Trajectory::Frame frame = trajectory[k];
    if (k == i) {
      frame.dwell = seconds;
      frame.by_hand = true;
    }
    result.addFrame(frame, trajectory.joints(k), trajectory.channels(k));
  }
  return result;
}

Expected<Trajectory> withName(const Trajectory& trajectory, std::size_t i, const std::string& name) {
  HAPTICELL_TRY(checkFrame(trajectory, i));
  // Bytes of a frame's name; a line of text. A limit for files, not tuned: half or twice would do.
  constexpr std::size_t kLongest = 200;
  const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
  if (name.size() > kLongest || !printable)
    return makeError(
        wrong(Text("name"), Text("'%1'", name.substr(0, 60)), Text("printable text of at most 200 characters")));
  for (std::size_t k = 0; k < trajectory.size(); ++k) {
    if (k != i && !name.empty() && trajectory[k].nameText() == name)
      return makeError(wrong(Text("name"), Text("frame %1 is called '%2'", k, name), Text("a unique name")));
  }
  Trajectory result = trajectory.emptyRecording();
  result.touches = trajectory.touches;
  result.reserve(trajectory.size());
  for (std::size_t k = 0; k < trajectory.size(); ++k) {
    Trajectory::Frame frame = trajectory[k];
    if (k == i) frame.name = name.empty() ? nullptr : std::make_shared<const std::string>(name);
    result.addFrame(frame, trajectory.joints(k), trajectory.channels(k));
  }
  return result;
}

Expected<Trajectory> withFrameMoved(const Trajectory& trajectory, std::size_t from, std::size_t to) {
  for (const std::size_t i : {from, to}) HAPTICELL_TRY(checkFrame(trajectory, i));
  std::vector<std::size_t> order(trajectory.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  order.erase(order.begin() + static_cast<std::ptrdiff_t>(from));
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(to), from);
  const auto lengthOf = [&](std::size_t a, std::size_t b) {
    const PoseDistance way = distanceBetween(trajectory[a].X_WT, trajectory[b].X_WT);
    return way.position + kMetresPerRadian * way.angle;
  };
  double length = 0.0;
  for (std::size_t k = 1; k < trajectory.size(); ++k) length += lengthOf(k - 1, k);
  // m/s, where nothing moves: a slow hand. Only frames at one place have it, so half or twice changes times only.
  constexpr double kSpeedOtherwise = 0.1;
  const double speed = length > 0.0 ? length / trajectory.duration() : kSpeedOtherwise;
  Trajectory result = trajectory.emptyCopy();
  result.reserve(trajectory.size());
  double t = trajectory[0].t;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0) {
      const std::size_t a = std::min(order[k - 1], order[k]), b = std::max(order[k - 1], order[k]);
      t += b == a + 1 ? trajectory[b].t - trajectory[a].t : std::max(lengthOf(a, b) / speed, kLeastTime);
    }
    Trajectory::Frame frame = trajectory[order[k]];
    frame.t = t;
    result.addFrame(frame, trajectory.joints(order[k]));
  }
  return result;
}

Expected<Trajectory> withApproach(const Trajectory& trajectory, const StraightWay& way) {
  HAPTICELL_TRY(checkWay(trajectory, way));
  const double time = way.length / way.speed;
  Trajectory result = posesOnly(trajectory);
  result.addFrame({0.0, farEnd(trajectory[0].X_WT, way), true});
  for (std::size_t i = 0; i < trajectory.size(); ++i) append(result, trajectory, i, time - trajectory[0].t);
  return result;
}

Expected<Trajectory> withRetract(const Trajectory& trajectory, const StraightWay& way) {
  HAPTICELL_TRY(checkWay(trajectory, way));
  Trajectory result = posesOnly(trajectory);
  for (std::size_t i = 0; i < trajectory.size(); ++i) append(result, trajectory, i, 0.0);
  const Trajectory::Frame& last = trajectory.frames().back();
  result.addFrame({last.t + way.length / way.speed, farEnd(last.X_WT, way), true});
  return result;
}

}  // namespace hapticell::trajectory
