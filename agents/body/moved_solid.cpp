// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "agents/body/moved_body.h"

namespace hapticell::agents {

namespace {

/// m/s and rad/s of a solid in agents' hands: a calm hand. Half: runs take twice as long; twice: more steps are cut near
/// obstacles.
constexpr double kSolidSpeed = 0.25, kSolidTurnSpeed = 0.8;

class MovedSolid final : public MovedBody {
 public:
  MovedSolid(const manipulation::EntityConfiguration& at, const dvec3& p_EM) : at_(at), p_EM_(p_EM) {
    handle_ = {at.X_WE * p_EM, at.X_WE.q};
    for (std::size_t k = 0; k < 6; ++k) {
      screws_[k].axis_W[static_cast<int>(k % 3)] = 1.0;
      screws_[k].p_WO = handle_.p;
      screws_[k].slides = k < 3;
    }
  }

  const manipulation::EntityConfiguration& configuration() const override { return at_; }
  const Pose& handle() const override { return handle_; }
  int handleLink() const override { return 0; }
  std::span<const Screw> screws() const override { return screws_; }
  bool carries(std::size_t, int) const override { return true; }
  bool isFixed(int) const override { return false; }
  Room room(std::size_t) const override { return {}; }
  double speed(std::size_t variable) const override { return variable < 3 ? kSolidSpeed : kSolidTurnSpeed; }
  double readiness(std::size_t) const override { return 1.0; }
  std::string nameOf(std::size_t variable) const override {
    static constexpr std::array kNames{"x", "y", "z", "turn about x", "turn about y", "turn about z"};
    return kNames[variable];
  }

  std::unique_ptr<MovedBody> moved(std::span<const double> step) const override {
    const Twist motion{{step[0], step[1], step[2]}, {step[3], step[4], step[5]}};
    const Pose X_WM = displaced(handle_, motion);
    return placed({X_WM * Pose::translation(-p_EM_), {}});
  }
  std::unique_ptr<MovedBody> placed(const manipulation::EntityConfiguration& at) const override {
    return std::make_unique<MovedSolid>(at, p_EM_);
  }

 private:
  manipulation::EntityConfiguration at_;
  dvec3 p_EM_;
  Pose handle_;
  std::array<Screw, 6> screws_{};
};

}  // namespace

std::unique_ptr<MovedBody> makeMovedSolid(const workcell::Entity& entity) {
  return std::make_unique<MovedSolid>(manipulation::EntityConfiguration{entity.X_WE, {}},
                                      entity.mesh()->bounds().center());
}

}  // namespace hapticell::agents
