// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "haptic/rendering/force_renderer.h"

namespace hapticell::feel {

/// One way to make forces of constraint sets: ours, or the classic one that it is measured against.
class RenderingWay {
 public:
  virtual ~RenderingWay() = default;
  virtual void reset(const Pose& X_DS) = 0;
  /// The pose about which the client looks for what can be met.
  virtual Pose lookedAt() const = 0;
  /// What of the exact set the client sends.
  virtual haptic::ConstraintSet sent(const haptic::ConstraintSet& exact) const = 0;
  /// `age`: seconds since the set was made.
  virtual void offer(const haptic::ConstraintSet& set, double age) = 0;
  virtual haptic::RenderResult tick(const Pose& X_DS, double dt) = 0;
  virtual void noteApplied(const dvec3& force_D, const dvec3& torque_D) = 0;
  /// N that the motors may give now.
  virtual void setForceLimit(double newtons) = 0;
};

/// The renderer of this program: the proxy is looked at and the whole set is sent.
class ProxyWay final : public RenderingWay {
 public:
  explicit ProxyWay(const haptic::RendererOptions& options) : renderer_(options) {}
  void reset(const Pose& X_DS) override { renderer_.reset(X_DS); }
  Pose lookedAt() const override { return renderer_.proxy(); }
  haptic::ConstraintSet sent(const haptic::ConstraintSet& exact) const override { return exact; }
  void offer(const haptic::ConstraintSet& set, double age) override { renderer_.adopt(set, age); }
  haptic::RenderResult tick(const Pose& X_DS, double dt) override { return renderer_.tick(X_DS, dt); }
  void noteApplied(const dvec3& force_D, const dvec3& torque_D) override { renderer_.noteApplied(force_D, torque_D); }
  void setForceLimit(double newtons) override { renderer_.setForceLimit(newtons); }

 private:
  haptic::ForceRenderer renderer_;
};

/// The classic way (Y. Adachi et al., 1995, "intermediate representation"): the client sends the one tangent plane that
/// is nearest to the stylus, the force loop pushes the stylus out of it; a new plane replaces the old one.
class ClassicWay final : public RenderingWay {
 public:
  explicit ClassicWay(const haptic::RendererOptions& options) : options_(haptic::limitedByDelay(options)) {}
  void reset(const Pose& X_DS) override;
  Pose lookedAt() const override { return X_DS_; }
  haptic::ConstraintSet sent(const haptic::ConstraintSet& exact) const override;
  void offer(const haptic::ConstraintSet& set, double age) override;
  haptic::RenderResult tick(const Pose& X_DS, double dt) override;
  void noteApplied(const dvec3&, const dvec3&) override {}
  void setForceLimit(double) override {}

 private:
  haptic::RendererOptions options_;
  haptic::ConstraintSet plane_;
  bool has_plane_ = false;
  Pose X_DS_;
  dvec3 v_DS_{0.0};
};

}  // namespace hapticell::feel
