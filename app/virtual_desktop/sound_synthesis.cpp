// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/sound_synthesis.h"

#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;
constexpr double kTickAmplitude = 0.0631;  // -24 dB.
constexpr double kLoudSpeed = 0.2;         // m/s of approach that knocks loudest.
constexpr double kLasts = 5.0;             // Decay times until a voice is dropped: below -43 dB of itself.

}  // namespace

SoundCue soundCue(const manipulation::SceneSnapshot& now, const manipulation::SceneSnapshot& before, double near_miss) {
  SoundCue cue;
  cue.limit = !now.limits.empty();
  if (now.pairs.empty() || !(near_miss > 0.0)) return cue;
  const auto& pair = now.pairs.front();
  cue.contact = pair.contact;
  cue.near_miss = pair.near_miss && !pair.contact;
  cue.nearness = std::clamp(1.0 - pair.distance / near_miss, 0.0, 1.0);
  const double seconds = now.time_s - before.time_s;
  if (!before.pairs.empty() && seconds > 0.0)
    cue.approach_speed = std::max(0.0, (before.pairs.front().distance - pair.distance) / seconds);
  return cue;
}

void SoundSynthesis::setCue(const SoundCue& cue) {
  if (cue.contact && !cue_.contact) {
    const double loudness = 0.12 + 0.38 * std::min(1.0, cue.approach_speed / kLoudSpeed);
    voices_.push_back({180.0, loudness, 0.060 / kLasts, 0.0});
  }
  if (cue.limit && !cue_.limit) {
    voices_.push_back({110.0, 0.2, 0.070 / kLasts, 0.0});
    voices_.push_back({110.0, 0.2, 0.070 / kLasts, 0.110});
  }
  if (cue.near_miss && !cue_.near_miss) to_next_tick_s_ = 0.0;
  cue_ = cue;
}

float SoundSynthesis::next() {
  const double step = 1.0 / rate_;
  if (cue_.near_miss) {
    if (to_next_tick_s_ <= 0.0) {
      voices_.push_back({1200.0, kTickAmplitude, 0.004, 0.0});
      to_next_tick_s_ += 1.0 / (2.0 + 10.0 * cue_.nearness);
    }
    to_next_tick_s_ -= step;
  }
  double sum = 0.0;
  for (Voice& voice : voices_) {
    const double age = -voice.start_s;
    if (age >= 0.0) sum += voice.amplitude * std::exp(-age / voice.decay_s) * std::sin(kTwoPi * voice.frequency * age);
    voice.start_s -= step;
  }
  std::erase_if(voices_, [](const Voice& voice) { return -voice.start_s > kLasts * voice.decay_s; });
  return static_cast<float>(std::clamp(sum, -1.0, 1.0));
}

void SoundSynthesis::render(float* samples, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) samples[i] = next();
}

}  // namespace hapticell::app
