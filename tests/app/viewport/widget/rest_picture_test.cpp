// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/rest_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/viewport/drawing/draw_share.h"

namespace hapticell::app {
namespace {

/// A renderer on which shadows take so many pieces, and a sample so much that bands shorten and so much that they do
/// not.
struct Renderer {
  int shadow_pieces = 1, band_pieces = 1;
  double sample_seconds = 0.1;
};

struct Refined {
  std::vector<RestPicture::Piece> pieces;
  double slowest_late_band = 0.0;  ///< Of the samples from the fourth on.
};

Refined refine(RestPicture& picture, const Renderer& renderer) {
  Refined result;
  int shadows_drawn = 0, of_band = 0;
  while (!picture.isFinished() && result.pieces.size() < 20000) {
    const RestPicture::Piece piece = picture.next();
    result.pieces.push_back(piece);
    if (piece.shadows) {
      picture.took({0.015, ++shadows_drawn % renderer.shadow_pieces == 0, 0.0});
      continue;
    }
    const double took = renderer.sample_seconds / piece.bands;
    if (piece.sample >= 3) result.slowest_late_band = std::max(result.slowest_late_band, took);
    picture.took({took, ++of_band % renderer.band_pieces == 0, took});
  }
  return result;
}

TEST(RestPicture, EverySampleHasItsShadowsFirstAndThenEveryBand) {
  RestPicture picture(6, 0.03);
  picture.begin();
  const Refined refined = refine(picture, {3, 2, 0.1});
  ASSERT_LT(refined.pieces.size(), 20000u);
  int band_pieces = 0, shadows = 0, rounds = 0, sample = 0;
  for (const RestPicture::Piece& piece : refined.pieces) {
    EXPECT_GE(piece.sample, sample);
    sample = piece.sample;
    if (piece.shadows) {
      EXPECT_EQ(band_pieces, 0) << "shadows change only between samples";
      ++shadows;
      continue;
    }
    EXPECT_EQ(piece.band, band_pieces / 2) << "two pieces of each";
    band_pieces = (band_pieces + 1) % (2 * piece.bands);
    if (band_pieces == 0) ++rounds;
  }
  EXPECT_EQ(sample, 5);
  EXPECT_EQ(rounds, 7) << "six samples and the round that does not count";
  EXPECT_EQ(shadows, 6 * 3) << "that round and the first sample share theirs";
}

TEST(RestPicture, BandsBecomeAsManyAsWhatCannotBeCutAsksFor) {
  RestPicture slow(24, 0.03);
  slow.begin();
  EXPECT_LE(refine(slow, {1, 1, 0.6}).slowest_late_band, 0.03);
  RestPicture quick(24, 0.03);
  quick.begin();
  EXPECT_EQ(refine(quick, {1, 1, 0.005}).pieces.back().bands, 1);
}

TEST(RestPicture, HeavyPartsThatCanBeCutAskForNoBands) {
  RestPicture picture(4, 0.03);
  picture.begin();
  while (!picture.isFinished()) picture.took({0.015, true, 0.001});
  EXPECT_EQ(picture.next().bands, 1);
}

TEST(RestPicture, GoesOnWithTheSamePictureWhenMoreSamplesAreWanted) {
  RestPicture picture(24, 0.03);
  picture.setMostSamples(1);
  picture.begin();
  EXPECT_EQ(refine(picture, {1, 1, 0.005}).pieces.back().sample, 0);
  EXPECT_TRUE(picture.isFinished());
  picture.setMostSamples(3);
  EXPECT_FALSE(picture.isFinished());
  const Refined more = refine(picture, {1, 1, 0.005});
  EXPECT_EQ(more.pieces.front().sample, 1);
  EXPECT_EQ(more.pieces.back().sample, 2);
}

TEST(RestPicture, ASlowRendererIsDoneWithFewSamples) {
  RestPicture picture(24, 0.03);
  picture.begin();
  const Refined refined = refine(picture, {20, 1, 2.0});
  EXPECT_TRUE(picture.isFinished());
  EXPECT_EQ(refined.pieces.back().sample, 3);
  picture.begin();
  EXPECT_TRUE(picture.next().shadows) << "another picture has other shadows";
}

/// A renderer in virtual time that notes what is drawn of each use.
class Noted {
 public:
  explicit Noted(std::vector<DrawLoad> loads, double per_unit) : loads_(std::move(loads)), per_unit_(per_unit) {
    for (const DrawLoad& load : loads_) drawn_.emplace_back(load.uses, 0);
  }
  /// One go; true when nothing is left.
  bool draw(DrawProgress& progress, double seconds) {
    DrawShare share(progress, seconds, {[this] { return now_; }});
    share.once(5, [this] { ++first_, now_ += 0.001; });
    for (std::size_t i = 0; i < loads_.size(); ++i)
      share.offer(loads_[i], [this, i](const DrawPart& part) { note(i, part); });
    share.once(1, [this] { ++last_; });
    return share.isWhole();
  }
  void note(std::size_t load, const DrawPart& part) {
    ++calls;
    const double took = per_unit_ * static_cast<double>(part.units * part.uses);
    now_ += took;
    longest_late = calls > 12 ? std::max(longest_late, took) : 0.0;
    for (std::size_t use = part.first_use; use < part.first_use + part.uses; ++use) {
      EXPECT_EQ(drawn_[load].at(use), part.first_unit);
      drawn_[load].at(use) += part.units;
    }
  }
  void expectAllOnce() const {
    EXPECT_EQ(first_, 1);
    EXPECT_EQ(last_, 1);
    for (std::size_t i = 0; i < loads_.size(); ++i)
      for (const std::size_t units : drawn_[i]) EXPECT_EQ(units, loads_[i].units);
  }
  int calls = 0;
  double longest_late = 0.0;

 private:
  std::vector<DrawLoad> loads_;
  double per_unit_;
  std::vector<std::vector<std::size_t>> drawn_;
  double now_ = 0.0;
  int first_ = 0, last_ = 0;
};

TEST(DrawShare, EveryUnitOfEveryUseIsDrawnOnceInHoweverManyGoes) {
  const std::vector<DrawLoad> loads{{100000, 1}, {12, 500}, {0, 3}, {5000, 7}, {7, 0}, {1, 1}};
  for (const double per_unit : {1e-9, 1e-6, 1e-4}) {
    for (const double seconds : {0.0, 0.01, 100.0}) {
      Noted renderer(loads, per_unit);
      DrawProgress progress;
      int goes = 1;
      while (!renderer.draw(progress, seconds)) ASSERT_LT(++goes, 100000);
      renderer.expectAllOnce();
      if (seconds == 100.0) {
        EXPECT_EQ(goes, 1);
      }
    }
  }
}

TEST(DrawShare, WithoutALimitEveryLoadIsOneCall) {
  DrawShare all;
  int calls = 0;
  for (const std::size_t uses : {std::size_t{1}, std::size_t{40}})
    all.offer({2000000, uses}, [&](const DrawPart& part) {
      ++calls;
      EXPECT_EQ(part.uses, uses);
      EXPECT_EQ(part.units, 2000000u);
    });
  EXPECT_EQ(calls, 2);
  EXPECT_TRUE(all.isWhole());
}

TEST(DrawShare, CallsBecomeAsLongAsWanted) {
  Noted slow({{2000000, 2}}, 1e-5);
  DrawProgress progress;
  while (!slow.draw(progress, 0.015)) ASSERT_LT(slow.calls, 100000);
  EXPECT_LE(slow.longest_late, DrawShare::kCallSeconds);
  Noted quick({{2000000, 2}}, 1e-12);
  DrawProgress fresh;
  while (!quick.draw(fresh, 0.015)) ASSERT_LT(quick.calls, 100000);
  EXPECT_LE(quick.calls, 20) << "a graphics card is not slowed down by many small calls";
}

}  // namespace
}  // namespace hapticell::app
