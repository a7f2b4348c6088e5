// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/rest_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "app/viewport/draw_pieces.h"

namespace hapticell::app {
namespace {

/// Refines until finished on a machine on which the shadows take `shadow_pieces` pieces and a sample takes so long.
struct Refined {
  std::vector<RestPicture::Piece> pieces;
  double slowest_late_band = 0.0;  ///< Of the last sample.
};

Refined refine(RestPicture& picture, int shadow_pieces, double sample_seconds, int sample_from_which_late) {
  Refined result;
  int shadows_drawn = 0;
  while (!picture.isFinished() && result.pieces.size() < 20000) {
    const RestPicture::Piece piece = picture.next();
    result.pieces.push_back(piece);
    if (piece.shadows) {
      picture.took(0.015, ++shadows_drawn % shadow_pieces == 0);
      continue;
    }
    const double took = sample_seconds / piece.bands;
    if (piece.sample >= sample_from_which_late) result.slowest_late_band = std::max(result.slowest_late_band, took);
    picture.took(took, true);
  }
  return result;
}

TEST(RestPicture, EverySampleHasItsShadowsFirstAndThenEveryBandOnce) {
  RestPicture picture(6, 0.03);
  picture.begin();
  const Refined refined = refine(picture, 3, 0.1, 4);
  ASSERT_LT(refined.pieces.size(), 20000u);
  int expected_band = 0, shadows = 0, rounds = 0, sample = 0;
  for (const RestPicture::Piece& piece : refined.pieces) {
    EXPECT_GE(piece.sample, sample);
    sample = piece.sample;
    if (piece.shadows) {
      EXPECT_EQ(expected_band, 0) << "shadows change only between samples";
      ++shadows;
      continue;
    }
    EXPECT_EQ(piece.band, expected_band);
    expected_band = (expected_band + 1) % piece.bands;
    if (expected_band == 0) ++rounds;
  }
  EXPECT_EQ(sample, 5);
  EXPECT_EQ(rounds, 7) << "six samples and the round that does not count";
  EXPECT_EQ(shadows, 6 * 3) << "that round and the first sample share theirs";
}

TEST(RestPicture, BandsBecomeAsManyAsTheirTimeAsksFor) {
  RestPicture slow(24, 0.03);
  slow.begin();
  EXPECT_LE(refine(slow, 1, 0.6, 3).slowest_late_band, 0.03);
  RestPicture quick(24, 0.03);
  quick.begin();
  const Refined refined = refine(quick, 1, 0.005, 3);
  EXPECT_EQ(refined.pieces.back().bands, 1);
}

TEST(RestPicture, ASlowRendererIsDoneWithFewSamples) {
  RestPicture picture(24, 0.03);
  picture.begin();
  const Refined refined = refine(picture, 20, 2.0, 24);
  EXPECT_TRUE(picture.isFinished());
  EXPECT_EQ(refined.pieces.back().sample, 3);
}

TEST(RestPicture, TellsWhetherThePictureCoversEverything) {
  RestPicture picture(24, 0.03);
  picture.begin();
  EXPECT_FALSE(picture.isInFirstRound());
  picture.took(0.01, true);
  picture.took(0.01, true);
  EXPECT_TRUE(picture.isInFirstRound());
  while (!picture.took(0.01, true)) {
  }
  picture.took(0.01, true);
  EXPECT_FALSE(picture.isInFirstRound());
  picture.begin();
  EXPECT_TRUE(picture.next().shadows) << "another picture has other shadows";
}

TEST(DrawPieces, EveryTriangleOfEveryUseIsDrawnOnce) {
  const std::vector<DrawLoad> loads{{100000, 1}, {12, 500}, {0, 3}, {5000, 7}, {7, 0}, {1, 1}};
  for (const double per_triangle : {1e-9, 1e-6, 1e-4}) {
    DrawPieces pieces(loads, 0.008);
    std::vector<std::size_t> wanted;
    for (const DrawLoad& load : loads)
      for (std::size_t use = 0; use < load.uses; ++use) wanted.push_back(load.triangles);
    std::vector<std::size_t> done(wanted.size(), 0);
    int calls = 0;
    while (const auto piece = pieces.next()) {
      ASSERT_LT(++calls, 100000);
      ASSERT_LE(piece->first_use + piece->uses, wanted.size());
      for (std::size_t use = piece->first_use; use < piece->first_use + piece->uses; ++use) {
        EXPECT_EQ(wanted[use], loads[piece->load].triangles) << "a use of that mesh";
        EXPECT_EQ(done[use], piece->first_triangle);
        done[use] += piece->triangles;
      }
      pieces.took(per_triangle * static_cast<double>(piece->uses * piece->triangles));
    }
    EXPECT_EQ(done, wanted) << per_triangle;
  }
}

TEST(DrawPieces, CallsBecomeAsLongAsWanted) {
  const std::vector<DrawLoad> loads{{2000000, 2}};
  DrawPieces slow(loads, 0.008);
  double longest = 0.0;
  int calls = 0;
  while (const auto piece = slow.next()) {
    const double took = 1e-5 * static_cast<double>(piece->triangles);
    if (++calls > 10) longest = std::max(longest, took);
    slow.took(took);
  }
  EXPECT_LE(longest, 0.008);
  DrawPieces quick(loads, 0.008);
  calls = 0;
  while (quick.next()) {
    quick.took(1e-6);
    ++calls;
  }
  EXPECT_LE(calls, 20) << "a graphics card is not slowed down by many small calls";
}

}  // namespace
}  // namespace hapticell::app
