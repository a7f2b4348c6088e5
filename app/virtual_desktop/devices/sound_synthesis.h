// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "manipulation/engine/scene_snapshot.h"

namespace hapticell::app {

/// The sounds to play now.
struct SoundCue {
  bool contact = false;
  bool limit = false;
  bool near_miss = false;
  double nearness = 0.0;        ///< 0 at the near-miss distance, 1 at contact.
  double approach_speed = 0.0;  ///< m/s at which the clearance shrinks.
  double sliding_speed = 0.0;   ///< m/s in the cell during contact.
};

/// A sound that is played once.
enum class SoundEvent {
  kFault,        ///< Forces went off without a request: a falling third, 300 ms.
  kRecordStart,  ///< A high tick.
  kRecordStop,   ///< A low one.
};

/// The cue of a snapshot; `before` gives the speeds. Ticks are for the nearest pair that is a near miss, and begin at
/// that pair's near-miss distance.
SoundCue soundCue(const manipulation::SceneSnapshot& now, const manipulation::SceneSnapshot& before);

/// Makes the samples: ticks of 1.2 kHz at -24 dB, 2 to 12 per second by nearness; one knock of 180 Hz and 60 ms when
/// contact begins, louder with the speed of approach; a faint noise by the speed of sliding; two low knocks when a
/// limit is reached; SoundEvents. Independent of sound devices; one thread.
class SoundSynthesis {
 public:
  explicit SoundSynthesis(double sample_rate = 48000.0) : rate_(sample_rate) {}
  void setCue(const SoundCue& cue);
  void strike(SoundEvent event);
  /// Writes `count` samples in -1 to 1; overwrites what is in the buffer, without mixing.
  void render(float* samples, std::size_t count);
  /// True if nothing is audible now or soon.
  bool isSilent() const { return voices_.empty() && !cue_.near_miss && noise_ < 1e-4 && noiseWanted() <= 0.0; }

 private:
  struct Voice {
    double frequency = 0.0, amplitude = 0.0, decay_s = 0.0;
    double start_s = 0.0;  ///< From now, seconds; negative while it sounds.
  };
  float next();
  double noiseWanted() const;
  double noise();
  double rate_;
  SoundCue cue_;
  std::vector<Voice> voices_;
  double to_next_tick_s_ = 0.0;
  double noise_ = 0.0;  ///< Present amplitude; follows noiseWanted().
  double low_ = 0.0, lower_ = 0.0;
  std::uint32_t random_ = 1;
};

}  // namespace hapticell::app
