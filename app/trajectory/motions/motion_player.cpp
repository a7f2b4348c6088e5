// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/motion_player.h"

#include <algorithm>

#include "app/controls/robot_ghosts.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/viewport/widget/viewport_widget.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::app {
namespace {

// ms a picture, that of a screen at 60 Hz. Half: pictures that nobody sees; twice: it moves less smoothly.
constexpr int kFrameMilliseconds = 16;
// s of the user's time from picture to picture, the window's guaranteed 10 Hz: below that it plays slower in place of
// leaping farther. Half: slower on slow machines; twice: leaps.
constexpr double kLongestStep = 0.1;
// s of that until it is said: one slow picture is no reason. Half: said when a part appears; twice: one wonders.
constexpr double kSlowAfter = 1.0;
// Of one motion's swept volume. Half: gaps are seen; twice: drawing twice as slow, nothing is distinguished.
constexpr std::size_t kMostGhosts = 12;
// m between two of them, at least. Half, twice: short motions have more or fewer.
constexpr double kGhostApart = 0.02;
// Frames of a motion that steps stop at: guards time. Half, twice: long motions are stepped in every second frame
// sooner or later.
constexpr std::size_t kMostStops = 100000;

void addTimes(const trajectory::Trajectory& motion, std::vector<double>& times) {
  const std::size_t stride = 1 + motion.size() / kMostStops;
  for (std::size_t i = 0; i < motion.size(); i += stride) times.push_back(motion[i].t);
  if (!motion.empty()) times.push_back(motion.frames().back().t);
}

/// What lasts less than a picture and must not be missed: the touches of a recording, what a check found to collide.
void addTouches(const Motion& motion, std::vector<double>& times) {
  for (const auto& touch : motion.trajectory->touches) times.push_back(0.5 * (touch.t_in + touch.t_out));
  if (!motion.check) return;
  for (const manipulation::PathFinding& finding : motion.check->findings)
    if (finding.kind == manipulation::PathFinding::Kind::kCollision)
      times.push_back(0.5 * (finding.t_in + finding.t_out));
}

/// How many entities carry it, one on the other.
std::size_t carriersOf(const workcell::DocumentState& state, workcell::EntityId id) {
  const workcell::Entity* at = state.find(id);
  std::size_t count = 0;
  while (at != nullptr && !at->attachment.to.empty() && count < state.entities.size()) {
    at = state.findByName(at->attachment.to);
    ++count;
  }
  return count;
}

/// Turning in place needs room too.
double wayBetween(const Pose& a, const Pose& b) {
  // m a rad, as metres_per_radian of trajectory/timing/retiming.h. Half: fewer ghosts where a part only turns; twice:
  // more.
  constexpr double kMetresARadian = 0.1;
  const trajectory::PoseDistance distance = trajectory::distanceBetween(a, b);
  return distance.position + kMetresARadian * distance.angle;
}

/// Times at which the swept volume shows the motion: evenly along its way, so that a rest does not use them up and a
/// motion of few frames is whole.
std::vector<double> sweptTimes(const trajectory::Trajectory& frames) {
  std::vector<double> times;
  if (frames.empty()) return times;
  double way = 0.0;
  for (std::size_t i = 1; i < frames.size(); ++i) way += wayBetween(frames[i - 1].X_WT, frames[i].X_WT);
  const double apart = std::max(kGhostApart, way / static_cast<double>(kMostGhosts - 1));
  times.push_back(frames[0].t);
  double walked = 0.0, next = apart;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double length = wayBetween(frames[i - 1].X_WT, frames[i].X_WT);
    for (; length > 0.0 && next <= walked + length; next += apart)
      times.push_back(frames[i - 1].t + (next - walked) / length * (frames[i].t - frames[i - 1].t));
    walked += length;
  }
  if (times.back() < frames.frames().back().t) times.push_back(frames.frames().back().t);
  return times;
}

}  // namespace

MotionPlayer::MotionPlayer(Host& host, MotionList& list, QObject* parent) : QObject(parent), host_(host), list_(list) {
  timer_.setInterval(kFrameMilliseconds);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &MotionPlayer::tick);
  connect(&list_, &MotionList::changed, this, &MotionPlayer::takeMotions);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    setSwept(false);
    setShown(false);
    playback_.seek(0.0);
  });
  takeMotions();
}

MotionPlayer::~MotionPlayer() = default;

void MotionPlayer::takeMotions() {
  std::vector<double> times, touches;
  for (const Motion& motion : list_.motions()) {
    if (!motion.played || !motion.replay) continue;
    addTimes(*motion.trajectory, times);
    addTouches(motion, touches);
  }
  playback_.setFrames(std::move(times));
  playback_.setStops(std::move(touches));
  if (!playback_.isPlaying()) timer_.stop();
  show();
  if (swept_) showSwept();
  emit changed();
}

void MotionPlayer::setShown(bool on) {
  if (!on) pause();
  shown_ = on;
  show();
  emit changed();
}

void MotionPlayer::play() {
  playback_.play();
  if (!playback_.isPlaying()) return;
  shown_ = true;
  slow_s_ = 0.0;
  clock_.start();
  timer_.start();
  show();
  emit changed();
}

bool MotionPlayer::isSlow() const {
  return playback_.isPlaying() && slow_s_ > kSlowAfter;
}

void MotionPlayer::pause() {
  playback_.pause();
  timer_.stop();
  emit changed();
}

void MotionPlayer::seek(double time) {
  playback_.seek(time);
  shown_ = true;
  show();
  emit changed();
}

void MotionPlayer::step(int direction) {
  playback_.step(direction);
  timer_.stop();
  shown_ = true;
  show();
  emit changed();
}

void MotionPlayer::setSpeed(double speed) {
  playback_.setSpeed(speed);
  emit changed();
}

void MotionPlayer::setLoop(bool on) {
  playback_.setLoop(on);
  emit changed();
}

void MotionPlayer::setSwept(bool on) {
  if (on == swept_) return;
  swept_ = on;
  showSwept();
  emit changed();
}

void MotionPlayer::showSwept() {
  std::vector<GhostPose> ghosts;
  const auto& state = host_.documentModel().document().state();
  for (const Motion& motion : list_.motions()) {
    if (!swept_ || !motion.played || !motion.replay) continue;
    for (const double t : sweptTimes(*motion.trajectory)) {
      const auto at = motion.replay->at(t);
      const auto with = entityGhosts(state, motion.replay->entity(), at.X_WE, at.joints);
      ghosts.insert(ghosts.end(), with.begin(), with.end());
    }
  }
  host_.viewport().scene().setGhosts("swept volume", std::move(ghosts));
  host_.viewport().refresh();
}

void MotionPlayer::tick() {
  const double since = 1e-9 * static_cast<double>(clock_.nsecsElapsed());
  clock_.restart();
  slow_s_ = since > kLongestStep ? slow_s_ + since : 0.0;
  const bool moved = playback_.advance(std::min(since, kLongestStep));
  if (!playback_.isPlaying()) timer_.stop();
  if (!moved) return;
  show();
  emit changed();
}

std::vector<GhostPose> MotionPlayer::playedAt(double time) const {
  const auto& state = host_.documentModel().document().state();
  std::vector<const Motion*> motions;
  for (const Motion& motion : list_.motions()) {
    if (motion.played && motion.replay) motions.push_back(&motion);
  }
  // What carries another comes first: a robot rides on its rail while both play.
  std::stable_sort(motions.begin(), motions.end(), [&](const Motion* a, const Motion* b) {
    return carriersOf(state, a->replay->entity()) < carriersOf(state, b->replay->entity());
  });
  std::vector<GhostPose> played, carried;
  for (const Motion* motion : motions) {
    auto at = motion->replay->at(time);
    const auto ride = std::find_if(carried.rbegin(), carried.rend(),
                                   [&](const GhostPose& pose) { return pose.entity == motion->replay->entity(); });
    if (ride != carried.rend() && !motion->replay->movesRoot()) at.X_WE = ride->X_WE;
    const auto ghosts = entityGhosts(state, motion->replay->entity(), at.X_WE, at.joints);
    if (ghosts.empty()) continue;
    played.push_back(ghosts.front());
    carried.insert(carried.end(), ghosts.begin() + 1, ghosts.end());
  }
  // What has a motion of its own is not carried; what several carry goes with the last, which rides on the others.
  for (auto pose = carried.rbegin(); pose != carried.rend(); ++pose) {
    const auto same = [&](const GhostPose& other) { return other.entity == pose->entity; };
    if (std::none_of(played.begin(), played.end(), same)) played.push_back(*pose);
  }
  return played;
}

void MotionPlayer::show() {
  host_.viewport().scene().setPlayed(shown_ ? playedAt(playback_.time()) : std::vector<GhostPose>{});
  host_.viewport().refresh();
}

}  // namespace hapticell::app
