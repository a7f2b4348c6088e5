// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

/// The order in which a picture at rest is refined, piece by piece, so that the window stays responsive: for each
/// sample first the shadows, then horizontal bands, both in as many pieces as they need. Bands cost time (parts at a
/// border are drawn in both bands), but they shorten what cannot be divided otherwise; their number depends on that. No
/// OpenGL.
class RestPicture {
 public:
  struct Piece {
    bool shadows = false;  ///< A piece of the sample's shadow map; else a band of the sample.
    int sample = 0, band = 0, bands = 1;
  };
  /// `most_samples`: the picture is finished after so many; `piece_s`: longest time of a piece.
  RestPicture(int most_samples, double piece_s) : most_samples_(most_samples), piece_s_(piece_s) {}

  /// At least 1; for the present picture too.
  void setMostSamples(int most_samples) { most_samples_ = most_samples; }
  /// Starts another picture with its first sample. Keeps the number of bands.
  void begin();
  Piece next() const;
  /// The result of a piece.
  struct Done {
    double seconds = 0.0;
    bool whole = true;           ///< The shadows, or the band, are finished.
    double longest_least = 0.0;  ///< Seconds of what could not be divided.
  };
  /// Reports the result of a piece. True at the end of a sample, when there is something new to show.
  bool took(const Done& done);
  /// True if all samples are done, or enough for a slow renderer.
  bool isFinished() const;

 private:
  /// s; total time for refining one picture (docs/dev/window.md). Half: slow machines show steps in shadows; twice:
  /// twice the time with a noisy fan.
  static constexpr double kRestSeconds = 6.0;
  /// Minimum number of samples. Half: edges are rough; twice: slow machines take longer than 6 s.
  static constexpr int kLeastSamples = 4;
  int most_samples_;
  double piece_s_;
  int sample_ = 0, band_ = 0, bands_ = 6;
  bool shadows_whole_ = false;
  double longest_least_ = 0.0, work_s_ = 0.0;
};

}  // namespace hapticell::app
