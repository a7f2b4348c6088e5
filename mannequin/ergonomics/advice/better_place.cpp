// SPDX-License-Identifier: Apache-2.0
#include "mannequin/ergonomics/advice/better_place.h"

#include <algorithm>

namespace hapticell::ergonomics {
namespace {

using mannequin::Figure;
using mannequin::Posture;

/// m: places given in centimetres; up to about the reach of an arm, in six ways. Our choice, docs/dev/ergonomics.md.
/// Half: twice the time; twice: a change 20 mm larger than needed is reported.
constexpr double kStep = 0.01, kFarthest = 0.6;

/// Moves the targets further and further in six ways, each from the posture before it.
class PlaceSearch {
 public:
  PlaceSearch(const Figure& figure, const Posture& posture, const WorkTask& task)
      : figure_(figure), posture_(posture), task_(task), solver_(figure), now_(scoresOf(posture)) {
    last_.fill(posture);
    const dvec3 ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
    const dvec3 forward = glm::normalize(dvec3(ahead.x, ahead.y, 1e-9)), left = glm::cross(dvec3(0, 0, 1), forward);
    ways_ = {dvec3(0, 0, -1), dvec3(0, 0, 1), -forward, forward, left, -left};
  }

  BetterPlaces find(std::array<bool, kPostureMethods.size()> wanted) {
    for (const PostureMethod method : kPostureMethods) {
      bool& open = wanted[static_cast<std::size_t>(method)];
      open = open && scoreBy(now_, method).level > leastLevel(method);
    }
    BetterPlaces best;
    for (double far = kStep; far < kFarthest && isAny(wanted); far += kStep) {
      for (std::size_t way = 0; way < ways_.size(); ++way) {
        const dvec3 shift_W = far * ways_[way];
        if (solve(shift_W, last_[way])) take(shift_W, last_[way], wanted, best);
      }
      for (std::size_t i = 0; i < best.size(); ++i) wanted[i] = wanted[i] && !best[i];
    }
    return best;
  }

 private:
  static bool isAny(const std::array<bool, kPostureMethods.size()>& wanted) {
    return std::find(wanted.begin(), wanted.end(), true) != wanted.end();
  }

  PostureScores scoresOf(const Posture& posture) const {
    return scorePosture(figure_, posture, mannequin::forwardKinematics(figure_, posture), task_);
  }

  /// Hands may turn only where they cannot be held alike.
  bool solve(const dvec3& shift_W, Posture& posture) const {
    for (const bool turned_alike : {true, false}) {
      mannequin::PostureTask wanted = taskAt(figure_, posture_, figure_, shift_W);
      wanted.orientation = {turned_alike, turned_alike};
      const auto found = solver_.solve(wanted, posture);
      if (found.status != mannequin::PostureStatus::kSolved) continue;
      posture = found.posture;
      return true;
    }
    return false;
  }

  void take(const dvec3& shift_W, const Posture& posture, const std::array<bool, kPostureMethods.size()>& wanted,
            BetterPlaces& best) const {
    const PostureScores scores = scoresOf(posture);
    for (const PostureMethod method : kPostureMethods) {
      const std::size_t i = static_cast<std::size_t>(method);
      const MethodScore score = scoreBy(scores, method);
      if (!wanted[i] || score.level >= scoreBy(now_, method).level) continue;
      if (!best[i] || score.score < best[i]->score.score) best[i] = BetterPlace{shift_W, score, posture};
    }
  }

  const Figure& figure_;
  const Posture& posture_;
  const WorkTask& task_;
  const mannequin::PostureSolver solver_;
  const PostureScores now_;
  std::array<dvec3, 6> ways_{};
  std::array<Posture, 6> last_;
};

}  // namespace

BetterPlaces betterPlaces(const Figure& figure, const Posture& posture, const WorkTask& task) {
  std::array<bool, kPostureMethods.size()> all{};
  all.fill(true);
  return PlaceSearch(figure, posture, task).find(all);
}

std::optional<BetterPlace> betterPlace(const Figure& figure, const Posture& posture, const WorkTask& task,
                                       PostureMethod method) {
  std::array<bool, kPostureMethods.size()> one{};
  one[static_cast<std::size_t>(method)] = true;
  return PlaceSearch(figure, posture, task).find(one)[static_cast<std::size_t>(method)];
}

}  // namespace hapticell::ergonomics
