// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/sound_synthesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hapticell::app {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
// -24 dB: faint, as it goes on near contacts. Half: not heard beside a fan; twice: louder than knocks of slow contacts.
constexpr double kTickAmplitude = 0.0631;
// m/s of approach that knocks loudest, a quick hand. Half: all knocks are alike; twice: usual ones are faint.
constexpr double kLoudSpeed = 0.2;
// -28 dB: faint, as it lasts. Half: not heard; twice: it covers the ticks.
constexpr double kNoiseAmplitude = 0.04;
// m/s: a held hand trembles. Half: resting contacts hiss; twice: slow sliding is silent.
constexpr double kSlowestSlide = 0.001;
// s: no click where sliding begins. Half: clicks; twice: it lags behind the hand.
constexpr double kNoiseFollows = 0.03;
// Above it the noise is cut: rubbing, not hissing. Half: dull; twice: sharp.
constexpr double kNoiseHertz = 1500.0;
// Decay times until a voice is dropped: below -43 dB of itself. Half: -22 dB, a click at its end; twice: sounds of the
// same length fade sooner.
constexpr double kLasts = 5.0;

}  // namespace

SoundCue soundCue(const manipulation::SceneSnapshot& now, const manipulation::SceneSnapshot& before) {
  SoundCue cue;
  cue.limit = !now.limits.empty();
  const auto in_contact = [](const auto& pair) { return pair.contact; };
  cue.contact = std::any_of(now.pairs.begin(), now.pairs.end(), in_contact);
  const auto near = std::find_if(now.pairs.begin(), now.pairs.end(),
                                 [](const auto& pair) { return pair.near_miss && !pair.contact; });
  if (near != now.pairs.end() && near->near_miss_distance > 0.0) {
    cue.near_miss = true;
    cue.nearness = std::clamp(1.0 - near->distance / near->near_miss_distance, 0.0, 1.0);
  }
  const double seconds = now.time_s - before.time_s;
  if (now.pairs.empty() || before.pairs.empty() || !(seconds > 0.0)) return cue;
  cue.approach_speed = std::max(0.0, (before.pairs.front().distance - now.pairs.front().distance) / seconds);
  if (cue.contact && std::any_of(before.pairs.begin(), before.pairs.end(), in_contact) &&
      now.stylus.held == before.stylus.held)
    cue.sliding_speed = glm::distance(now.stylus.X_WStylus.p, before.stylus.X_WStylus.p) / seconds;
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

void SoundSynthesis::strike(SoundEvent event) {
  switch (event) {
    case SoundEvent::kFault:
      // 5 : 4, the second note a third below the first.
      voices_.push_back({660.0, 0.25, 0.150 / kLasts, 0.0});
      voices_.push_back({528.0, 0.25, 0.150 / kLasts, 0.150});
      break;
    case SoundEvent::kRecordStart:
      voices_.push_back({1800.0, 0.15, 0.030 / kLasts, 0.0});
      break;
    case SoundEvent::kRecordStop:
      voices_.push_back({900.0, 0.15, 0.030 / kLasts, 0.0});
      break;
  }
}

double SoundSynthesis::noiseWanted() const {
  if (!cue_.contact || cue_.sliding_speed < kSlowestSlide) return 0.0;
  return kNoiseAmplitude * std::min(1.0, cue_.sliding_speed / kLoudSpeed);
}

/// White noise through two low passes: a rub, not a hiss.
double SoundSynthesis::noise() {
  noise_ += (noiseWanted() - noise_) / (kNoiseFollows * rate_);
  if (noise_ < 1e-4 && noiseWanted() <= 0.0) return noise_ = low_ = lower_ = 0.0;
  random_ = random_ * 1664525u + 1013904223u;  // Numerical Recipes' generator.
  const double white = static_cast<double>(random_ >> 8) / 8388608.0 - 1.0;
  const double share = std::min(1.0, kTwoPi * kNoiseHertz / rate_);
  low_ += share * (white - low_);
  lower_ += share * (low_ - lower_);
  return 3.0 * noise_ * lower_;
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
  double sum = noise();
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
