// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

/// In which pieces a picture at rest is refined, so that the window answers between them: each sample is first its
/// shadows, in as many pieces as they need, then horizontal bands, whose number follows the time they take. No OpenGL.
class RestPicture {
 public:
  struct Piece {
    bool shadows = false;  ///< A piece of the sample's shadow map; else a band of the sample.
    int sample = 0, band = 0, bands = 1;
  };
  /// `most_samples`: after so many the picture is finished; `piece_s`: what a piece may take.
  RestPicture(int most_samples, double piece_s) : most_samples_(most_samples), piece_s_(piece_s) {}

  /// Another picture: from the first sample on. The number of bands is kept.
  void begin();
  Piece next() const;
  /// Tells what the last piece took and, of shadows, whether they are whole now. True at the end of a sample: now there
  /// is something new to be shown.
  bool took(double seconds, bool shadows_whole);
  /// All samples are there; or enough for a renderer that is so slow.
  bool isFinished() const;
  /// Bands of it have been drawn, but not one everywhere yet: elsewhere there is still another picture.
  bool isInFirstRound() const { return band_ > 0 && !covered_; }

 private:
  static constexpr double kRestSeconds = 6.0;  // What refining one picture may take in all,
  static constexpr int kLeastSamples = 4;      // but so many samples it has.
  int most_samples_;
  double piece_s_;
  int sample_ = 0, band_ = 0, bands_ = 6;
  bool shadows_whole_ = false, covered_ = false;
  double slowest_band_s_ = 0.0, work_s_ = 0.0;
};

}  // namespace hapticell::app
