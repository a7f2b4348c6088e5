// SPDX-License-Identifier: Apache-2.0
// Scenes made of others: drifting on a conveyor, seen through a motion scale.
#include <utility>

#include "feel/feel_session.h"
#include "feel/scene.h"
#include "manipulation/holding/motion_mapping.h"

namespace hapticell::feel {

namespace {

// s of a session until the hand moves and until it slides: begin() and touchAndSlide() of feel_session.cpp. Other
// numbers would put the drifting scene beside the hand.
constexpr double kHandBegins = 1.2, kSlideBegins = 1.7;

class Drifting final : public FeelScene {
 public:
  Drifting(std::unique_ptr<FeelScene> scene, const dvec3& velocity, double duration)
      : scene_(std::move(scene)), velocity_(velocity), middle_(kSlideBegins + 0.5 * duration) {}
  std::string name() const override { return scene_->name() + ", moving"; }
  ConstraintSet setAt(const Pose& X_DP, double t) const override {
    ConstraintSet set = scene_->setAt(back(X_DP, t), t);
    set.X_DR.p += velocity_ * (t - middle_);
    for (std::size_t i = 0; i < set.count; ++i) set.constraints[i].velocity_D += velocity_;
    return set;
  }
  double penetration(const Pose& X_DP, double t) const override { return scene_->penetration(back(X_DP, t), t); }
  dvec3 handAt(double t, double press) const override {
    return scene_->handAt(t, press) + velocity_ * (t + kSlideBegins - middle_);
  }
  dvec3 start() const override { return scene_->start() + velocity_ * (kHandBegins - middle_); }
  dvec3 drift() const override { return velocity_; }

 private:
  Pose back(const Pose& X_DP, double t) const { return {X_DP.p - velocity_ * (t - middle_), X_DP.q}; }
  std::unique_ptr<FeelScene> scene_;
  dvec3 velocity_;
  double middle_;
};

class Scaled final : public FeelScene {
 public:
  Scaled(std::unique_ptr<FeelScene> cell, std::unique_ptr<FeelScene> hand, double scale)
      : cell_(std::move(cell)), hand_(std::move(hand)) {
    mapping_.setScale(scale);
    mapping_.anchor(Pose::identity(), Pose::identity());
  }
  std::string name() const override { return cell_->name() + " at scale " + std::to_string(mapping_.scale()); }
  ConstraintSet setAt(const Pose& X_DP, double t) const override {
    ConstraintSet set = cell_->setAt(mapping_.toCell(X_DP), t);
    set.X_DR = mapping_.toDevice(set.X_DR, X_DP);
    for (std::size_t i = 0; i < set.count; ++i) mapping_.toDevice(set.constraints[i]);
    return set;
  }
  double penetration(const Pose& X_DP, double t) const override {
    return cell_->penetration(mapping_.toCell(X_DP), t) / mapping_.scale();
  }
  dvec3 handAt(double t, double press) const override { return hand_->handAt(t, press); }
  dquat turnAt(double t) const override { return hand_->turnAt(t); }
  dvec3 start() const override { return hand_->start(); }
  dvec3 rest() const override { return hand_->rest(); }
  dvec3 pressDirection() const override { return hand_->pressDirection(); }

 private:
  std::unique_ptr<FeelScene> cell_, hand_;
  manipulation::MotionMapping mapping_;
};

}  // namespace

std::unique_ptr<FeelScene> driftingScene(std::unique_ptr<FeelScene> scene, const dvec3& velocity, double duration) {
  return std::make_unique<Drifting>(std::move(scene), velocity, duration);
}

std::unique_ptr<FeelScene> scaledScene(std::unique_ptr<FeelScene> cell, std::unique_ptr<FeelScene> hand, double scale) {
  return std::make_unique<Scaled>(std::move(cell), std::move(hand), scale);
}

}  // namespace hapticell::feel
