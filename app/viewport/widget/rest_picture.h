// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::app {

/// In which order a picture at rest is refined, piece by piece, so that the window answers in between: each sample is
/// first its shadows, then horizontal bands; both in as many pieces as they need. Bands cost time (parts of a band are
/// drawn again for the next), but what cannot be cut otherwise gets shorter by them: their number follows that. No
/// OpenGL.
class RestPicture {
 public:
  struct Piece {
    bool shadows = false;  ///< A piece of the sample's shadow map; else a band of the sample.
    int sample = 0, band = 0, bands = 1;
  };
  /// `most_samples`: after so many the picture is finished; `piece_s`: what a piece may take at most.
  RestPicture(int most_samples, double piece_s) : most_samples_(most_samples), piece_s_(piece_s) {}

  /// Another picture: from the first sample on. The number of bands is kept.
  void begin();
  Piece next() const;
  /// What became of a piece.
  struct Done {
    double seconds = 0.0;
    bool whole = true;           ///< The shadows, or the band, are finished.
    double longest_least = 0.0;  ///< Seconds of what could not be cut.
  };
  /// Tells it. True at the end of a sample: now there is something new to be shown.
  bool took(const Done& done);
  /// All samples are there; or enough for a renderer that is so slow.
  bool isFinished() const;

 private:
  /// s that refining one picture may take in all (docs/dev/window.md). Half: slow machines show steps in shadows;
  /// twice: twice the fan.
  static constexpr double kRestSeconds = 6.0;
  /// But so many samples it has. Half: edges are rough; twice: slow machines take longer than 6 s.
  static constexpr int kLeastSamples = 4;
  int most_samples_;
  double piece_s_;
  int sample_ = 0, band_ = 0, bands_ = 6;
  bool shadows_whole_ = false;
  double longest_least_ = 0.0, work_s_ = 0.0;
};

}  // namespace hapticell::app
