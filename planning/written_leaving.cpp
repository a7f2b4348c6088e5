// SPDX-License-Identifier: Apache-2.0
#include "planning/written_leaving.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "manipulation/checks/joint_check.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::planning {

namespace {

using manipulation::NearPair;
using manipulation::PlacedPair;
using trajectory::Trajectory;

/// m: what is not free after such a shift counts as this deep: four times what may be left. Half, twice: only that
/// number changes.
constexpr double kDeepestTold = 4.0 * LeavingRule::kDeepest;
/// Halvings of a depth, to a thousandth of it. Half: to 3 %; twice: twice the queries.
constexpr int kHalvings = 10;
/// m by which a gap may be below the clearance and count as clear: rounding of the file. Half, twice: as good.
constexpr double kRounding = 1e-6;

/// m: what of a mannequin moves no farther stands: feet are in place within a third of it. Half: passes as well; twice: a
/// foot that creeps is not measured.
constexpr double kStays = 1e-3;

/// The parts of what moved at the frames of a motion.
class MeasuredMotion {
 public:
  virtual ~MeasuredMotion() = default;
  virtual void nearer(std::size_t frame, double limit, std::vector<NearPair>& near) = 0;
  virtual PlacedPair placed(std::size_t frame, std::uint32_t pair) = 0;
  /// Names of parts that stay and are left out.
  virtual std::vector<std::string> still() const { return {}; }
};

class JointMotion final : public MeasuredMotion {
 public:
  JointMotion(manipulation::JointCheck check, const Trajectory& fine, const std::vector<std::size_t>& columns)
      : check_(std::move(check)), fine_(fine), columns_(columns), joints_(check_.entity().joints()) {}
  void nearer(std::size_t frame, double limit, std::vector<NearPair>& near) override {
    check_.nearer(jointsAt(frame), limit, near);
  }
  PlacedPair placed(std::size_t frame, std::uint32_t pair) override { return check_.placed(jointsAt(frame), pair); }

 private:
  const std::vector<double>& jointsAt(std::size_t frame) {
    for (std::size_t j = 0; j < columns_.size(); ++j) joints_[columns_[j]] = fine_.joints(frame)[j];
    return joints_;
  }

  manipulation::JointCheck check_;
  const Trajectory& fine_;
  const std::vector<std::size_t>& columns_;
  std::vector<double> joints_;
};

/// A solid by its poses, or a mannequin by its poses and its joints.
class PlacedMotion final : public MeasuredMotion {
 public:
  PlacedMotion(std::unique_ptr<manipulation::HeldEntity> held, const workcell::Entity& entity, const Trajectory& fine,
               const std::vector<std::size_t>& columns)
      : held_(std::move(held)), entity_(entity), fine_(fine), columns_(columns), joints_(entity.joints()) {
    const manipulation::FreeMotion& motion = held_->motion();
    for (const auto& part : motion.parts()) cell_.addPart({}, part);
    for (const auto& obstacle : motion.obstacles()) cell_.addPart({}, obstacle.collider, obstacle.X_WO);
    const auto first = static_cast<std::uint32_t>(motion.parts().size());
    const std::vector<bool> stays = staying();
    for (std::uint32_t i = 0; i < motion.pairs().size(); ++i) {
      const manipulation::MotionPair& pair = motion.pairs()[i];
      if (pair.blocks && pair.other_part < 0 && !stays[pair.part]) cell_.addPair(pair.part, first + pair.obstacle, i);
    }
  }
  void nearer(std::size_t frame, double limit, std::vector<NearPair>& near) override {
    place(frame);
    cell_.pairsWithin(limit, found_);
    near.clear();
    for (const auto& one : found_) near.push_back({one.pair, one.result.distance});
    found_.clear();
  }
  PlacedPair placed(std::size_t frame, std::uint32_t pair) override {
    place(frame);
    const manipulation::MotionPair& words = held_->motion().pairs()[cell_.tag(pair)];
    const auto a = cell_.moved(pair), b = cell_.environment(pair);
    return {cell_.sharedCollider(a), cell_.sharedCollider(b), cell_.pose(a), cell_.pose(b),
            held_->nameOf(*held_->movedParts()[words.part].part), held_->nameOf(*held_->obstacleParts()[words.obstacle])};
  }
  std::vector<std::string> still() const override { return still_; }

 private:
  void place(std::size_t frame) {
    for (std::size_t j = 0; j < columns_.size(); ++j) joints_[columns_[j]] = fine_.joints(frame)[j];
    if (entity_.robot()) kinematics::forwardKinematics(*entity_.robot(), joints_, X_EL_);
    for (std::uint32_t i = 0; i < held_->movedParts().size(); ++i) {
      const manipulation::MovedPart& part = held_->movedParts()[i];
      const Pose X_EL = entity_.robot() ? X_EL_[static_cast<std::size_t>(std::max(0, part.link))] : Pose::identity();
      cell_.setPose(i, fine_[frame].X_WT * X_EL * part.X_LP);
    }
  }

  /// Which parts no point of which leaves its place by kStays.
  std::vector<bool> staying() {
    const std::size_t count = held_->movedParts().size();
    std::vector<bool> stays(count, entity_.figure() != nullptr);
    std::vector<Pose> first(count);
    for (std::size_t frame = 0; frame < fine_.size() && entity_.figure() != nullptr; ++frame) {
      place(frame);
      for (std::uint32_t i = 0; i < count; ++i) {
        const Pose& now = cell_.pose(i);
        if (frame == 0) first[i] = now;
        const collision::MeshCollider& shape = *held_->motion().parts()[i];
        const auto apart = trajectory::distanceBetween(now, first[i]);
        const double size = glm::length(shape.center()) + shape.radius();
        if (apart.position + size * apart.angle > kStays) stays[i] = false;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (stays[i]) still_.push_back(held_->nameOf(*held_->movedParts()[i].part));
    }
    return stays;
  }

  std::unique_ptr<manipulation::HeldEntity> held_;
  const workcell::Entity& entity_;
  const Trajectory& fine_;
  const std::vector<std::size_t>& columns_;
  std::vector<double> joints_;
  std::vector<Pose> X_EL_;
  collision::Scene cell_;
  std::vector<collision::PairDistance> found_;
  std::vector<std::string> still_;
};

/// How far A is moved along a direction until it is free of B: doubled, then halved.
double depthAlong(const PlacedPair& pair, const dvec3& direction) {
  const auto collides = [&](double shift) {
    return collision::distance(pair.a, {pair.X_WA.p + shift * direction, pair.X_WA.q}, pair.b, pair.X_WB).colliding;
  };
  double stuck = 0.0, free = kRounding;
  while (free < kDeepestTold && collides(free)) {
    stuck = free;
    free *= 2.0;
  }
  if (free >= kDeepestTold) return kDeepestTold;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (stuck + free);
    (collides(middle) ? stuck : free) = middle;
  }
  return free;
}

/// `opened_W`: the line of the nearest points where the two were apart.
double depthOf(const PlacedPair& pair, const dvec3& opened_W) {
  double least = depthAlong(pair, opened_W);
  for (int i = 0; i < 6; ++i) {
    dvec3 axis(0.0);
    axis[i % 3] = i < 3 ? 1.0 : -1.0;
    least = std::min(least, depthAlong(pair, axis));
  }
  return least;
}

/// The gaps of one pair at all frames, up to the look.
using Gaps = std::vector<double>;

class Judge {
 public:
  Judge(const Trajectory& fine, MeasuredMotion& motion, const LeavingLook& look)
      : fine_(fine), motion_(motion), look_(look) {}

  Leaving run() {
    std::vector<NearPair> near;
    for (std::size_t i = 0; i < fine_.size(); ++i) {
      motion_.nearer(i, look_.look, near);
      for (const NearPair& one : near) {
        gaps_.try_emplace(one.pair, fine_.size(), look_.look).first->second[i] = one.distance;
      }
    }
    result_.least = look_.look;
    for (auto& [pair, gaps] : gaps_) judge(pair, gaps);
    return std::move(result_);
  }

 private:
  bool isClear(double gap) const { return gap >= look_.clearance - kRounding && gap > 0.0; }

  void judge(std::uint32_t pair, Gaps& gaps) {
    std::size_t first = 0, last = gaps.size();  // The clearance holds from first to before last.
    const bool is_left = !isClear(gaps.front()), is_reached = !isClear(gaps.back());
    if (is_left || is_reached) measureDepths(pair, gaps);
    if (is_left) first = opened(pair, gaps, 0, 1);
    if (is_reached) last = opened(pair, gaps, gaps.size() - 1, -1) + 1;
    for (std::size_t i = first; i < last; ++i) {
      if (gaps[i] >= result_.least) continue;
      result_.least = std::max(0.0, gaps[i]);
      result_.t_least = fine_[i].t;
    }
  }

  /// From an end on in steps of `step`: the frame at which the pair is clear, or where it is no longer near that end.
  std::size_t opened(std::uint32_t pair, const Gaps& gaps, std::size_t end, std::ptrdiff_t step) {
    const PlacedPair begin = motion_.placed(end, pair);
    const Text words("%1 and %2", begin.first, begin.second);
    double best = gaps[end];
    std::size_t at = end;
    const auto lastFrame = [&] { return step > 0 ? at + 1 == gaps.size() : at == 0; };
    while (!isClear(gaps[at]) && !lastFrame()) {
      at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + step);
      const PlacedPair now = motion_.placed(at, pair);
      const dvec3 p_AC = now.a->center();
      if (glm::distance(now.X_WA * p_AC, begin.X_WA * p_AC) > LeavingRule::nearness(look_.clearance)) break;
      if (best - gaps[at] > result_.closing) {
        result_.closing = best - gaps[at];
        result_.where_closing = words;
      }
      best = std::max(best, gaps[at]);
    }
    if (-gaps[end] > result_.deepest) {
      result_.deepest = -gaps[end];
      result_.where_deepest = words;
    }
    result_.tight.push_back({begin.first, begin.second, gaps[end], fine_[at].t, step < 0});
    return at;
  }

  /// Contacts get their depths, as gaps below 0.
  void measureDepths(std::uint32_t pair, Gaps& gaps) {
    dvec3 opened_W(0.0, 0.0, 1.0);
    const auto apart = std::find_if(gaps.begin(), gaps.end(), [](double gap) { return gap > 0.0; });
    if (apart != gaps.end()) {
      const PlacedPair there = motion_.placed(static_cast<std::size_t>(apart - gaps.begin()), pair);
      opened_W = collision::distance(there.a, there.X_WA, there.b, there.X_WB).nhat_BA_W;
    }
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (gaps[i] <= 0.0) gaps[i] = -depthOf(motion_.placed(i, pair), opened_W);
    }
  }

  const Trajectory& fine_;
  MeasuredMotion& motion_;
  const LeavingLook look_;
  std::map<std::uint32_t, Gaps> gaps_;
  Leaving result_;
};

Expected<std::unique_ptr<MeasuredMotion>> motionOf(const Trajectory& fine, const std::vector<std::size_t>& columns,
                                                   const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                                   const workcell::Entity& entity, bool with_axes,
                                                   const config::Configuration& configuration) {
  if (!columns.empty() && entity.figure() == nullptr) {
    auto check = manipulation::JointCheck::create(scene, entity.id, configuration,
                                                  manipulation::RestContacts::kLeaveOutLasting, with_axes);
    HAPTICELL_TRY(check);
    return std::make_unique<JointMotion>(std::move(*check), fine, columns);
  }
  manipulation::HoldOptions hold;
  hold.on_contact = entity.contact.on_contact;
  hold.force_class = entity.contact.force_class;
  hold.joints_move = entity.figure() != nullptr;
  auto held = manipulation::HeldEntity::take(scene, entity.id, {}, hold, configuration);
  HAPTICELL_TRY(held);
  return std::make_unique<PlacedMotion>(std::move(*held), entity, fine, columns);
}

}  // namespace

Expected<Leaving> measuredLeaving(const Trajectory& fine, const std::vector<std::size_t>& columns,
                                  const std::shared_ptr<const manipulation::PreparedScene>& scene,
                                  const workcell::Entity& entity, const LeavingLook& look,
                                  const config::Configuration& configuration) {
  const auto motion = motionOf(fine, columns, scene, entity, look.with_axes, configuration);
  HAPTICELL_TRY(motion);
  Leaving leaving = Judge(fine, **motion, look).run();
  leaving.still = (*motion)->still();
  return leaving;
}

}  // namespace hapticell::planning
