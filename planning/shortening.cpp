// SPDX-License-Identifier: Apache-2.0
#include "planning/shortening.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "planning/standing_figure.h"

namespace hapticell::planning {

namespace {

using Path = std::vector<EntityConfiguration>;

/// Random shortcuts that are tried. Half: paths 5 % longer; twice: twice the time, 2 % shorter.
constexpr int kShortcuts = 40;
/// How often all corners are cut. Half: sharper corners, at which the motion nearly rests; twice: twice the checks.
constexpr int kCornerRounds = 2;
/// Share of the time that a shortcut saves at least. Half: more pieces for little; twice: longer paths.
constexpr double kWorthwhile = 1e-3;

/// A place on a path: on the piece that begins at waypoint `piece`.
struct Place {
  std::size_t piece = 0;
  double share = 0.0;
};

class Shortening {
 public:
  Shortening(FreeSpace& space, Path path, std::uint64_t seed) : space_(space), path_(std::move(path)), random_(seed) {
    for (std::size_t i = 0; i < path_.size(); ++i) names_.push_back(next_name_++);
  }

  Path run() {
    leaveOut();
    for (int i = 0; i < kShortcuts && path_.size() > 2; ++i) tryShortcut();
    leaveOut();
    for (int i = 0; i < kCornerRounds; ++i) cutCorners();
    return std::move(path_);
  }

 private:
  double time(const EntityConfiguration& from, const EntityConfiguration& to) const {
    return leastTime(space_, from, to);
  }

  /// From each waypoint straight to the farthest one that can be reached so.
  void leaveOut() {
    Path kept{path_.front()};
    std::vector<std::size_t> names{names_.front()};
    for (std::size_t at = 0; at + 1 < path_.size();) {
      std::size_t next = path_.size() - 1;
      while (next > at + 1 && !reaches(at, next)) --next;
      kept.push_back(path_[next]);
      names.push_back(names_[next]);
      at = next;
    }
    path_ = std::move(kept);
    names_ = std::move(names);
  }

  /// What was found to be in the way once is so again: the second leaveOut() does not ask.
  bool reaches(std::size_t from, std::size_t to) {
    const std::pair<std::size_t, std::size_t> ends(names_[from], names_[to]);
    if (blocked_.contains(ends)) return false;
    if (space_.isFree(path_[from], path_[to])) return true;
    blocked_.insert(ends);
    return false;
  }

  Place placeAt(double t) const {
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
      const double piece = time(path_[i], path_[i + 1]);
      if (t <= piece && piece > 0.0) return {i, t / piece};
      t -= piece;
    }
    return {path_.size() - 2, 1.0};
  }

  void tryShortcut() {
    double whole = 0.0;
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) whole += time(path_[i], path_[i + 1]);
    const auto unit = [&] { return static_cast<double>(random_() >> 11) * 0x1.0p-53; };
    const double a = whole * unit(), b = whole * unit();
    const Place from = placeAt(std::min(a, b)), to = placeAt(std::max(a, b));
    if (from.piece == to.piece) return;
    const EntityConfiguration begin = space_.between(path_[from.piece], path_[from.piece + 1], from.share);
    const EntityConfiguration end = space_.between(path_[to.piece], path_[to.piece + 1], to.share);
    if (time(begin, end) > std::abs(b - a) - kWorthwhile * whole || !space_.isFree(begin, end)) return;
    Path path(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(from.piece) + 1);
    path.push_back(begin);
    path.push_back(end);
    path.insert(path.end(), path_.begin() + static_cast<std::ptrdiff_t>(to.piece) + 1, path_.end());
    path_ = std::move(path);
    const auto first = names_.begin() + static_cast<std::ptrdiff_t>(from.piece) + 1;
    const auto last = names_.begin() + static_cast<std::ptrdiff_t>(to.piece) + 1;
    const auto place = names_.erase(first, last);
    names_.insert(place, {next_name_, next_name_ + 1});
    next_name_ += 2;
  }

  /// Each corner is replaced by two blunter ones, as far out as the way between them is free.
  void cutCorners() {
    Path cut{path_.front()};
    for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
      bool is_cut = false;
      for (const double share : {0.4, 0.2, 0.1}) {
        EntityConfiguration before = space_.between(path_[i], path_[i - 1], share);
        EntityConfiguration after = space_.between(path_[i], path_[i + 1], share);
        if (!space_.isFree(before, after)) continue;
        cut.push_back(std::move(before));
        cut.push_back(std::move(after));
        is_cut = true;
        break;
      }
      if (!is_cut) cut.push_back(path_[i]);
    }
    cut.push_back(path_.back());
    path_ = std::move(cut);
  }

  FreeSpace& space_;
  Path path_;
  std::vector<std::size_t> names_;  ///< Of the waypoints, until corners are cut.
  std::size_t next_name_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> blocked_;  ///< Names of waypoints with something between them.
  std::mt19937_64 random_;
};

}  // namespace

double leastTime(const FreeSpace& space, const EntityConfiguration& from, const EntityConfiguration& to) {
  if (space.figure() != nullptr) return space.figure()->leastTime(from, to);
  if (!space.hasJoints()) {
    const Twist way = difference(to.X_WE, from.X_WE);
    return std::max(glm::length(way.linear) / kSolidSpeed, glm::length(way.angular) / kSolidTurn);
  }
  const kinematics::RobotModel& robot = *space.entity().robot();
  double longest = 0.0;
  for (std::size_t i = 0; i < robot.dof(); ++i) {
    const double speed = kinematics::greatestSpeed(robot.joints[static_cast<std::size_t>(robot.moving[i])]);
    longest = std::max(longest, std::abs(to.joints[i] - from.joints[i]) / speed);
  }
  return longest;
}

std::vector<EntityConfiguration> shortened(FreeSpace& space, std::vector<EntityConfiguration> path,
                                           std::uint64_t seed) {
  if (path.size() < 3) return path;
  return Shortening(space, std::move(path), seed).run();
}

}  // namespace hapticell::planning
