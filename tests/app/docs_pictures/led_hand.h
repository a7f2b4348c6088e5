// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "haptic/devices/hand_path.h"
#include "haptic/server/force_loop.h"

namespace hapticell::app {

/// The hand at a simulated stylus, led by positions or along a recorded path in real time. While it leads, nothing else
/// may lead that stylus.
class LedHand {
 public:
  explicit LedHand(haptic::ForceLoop& loop) : loop_(loop) {}
  ~LedHand() { end(); }
  LedHand(const LedHand&) = delete;
  LedHand& operator=(const LedHand&) = delete;

  /// At this place of the device frame (m); not while a path is followed.
  void put(const dvec3& p_DH, bool button = false) {
    loop_.submit(haptic::HandTarget{.holding = true, .X_DH = Pose::translation(p_DH), .buttons = button ? 1u : 0u});
  }
  /// Begins to follow the path until its time `end_s`, where the hand then stays.
  void follow(const haptic::HandPath& path, double end_s) {
    end();
    follows_ = true;
    thread_ = std::thread([this, path, end_s] {
      const auto start = std::chrono::steady_clock::now();
      double t = 0.0;
      while (follows_ && t < end_s) {
        t = std::min(end_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        const haptic::HandSample sample = path.at(t);
        loop_.submit(haptic::HandTarget{.holding = true, .X_DH = sample.X_DH, .buttons = sample.buttons});
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
      }
      follows_ = false;
    });
  }
  bool isFollowing() const { return follows_; }

 private:
  void end() {
    follows_ = false;
    if (thread_.joinable()) thread_.join();
  }
  haptic::ForceLoop& loop_;
  std::atomic<bool> follows_{false};
  std::thread thread_;
};

}  // namespace hapticell::app
