// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/rest_picture.h"

#include <algorithm>

namespace hapticell::app {
namespace {

// Pieces of one sample. Half: longer pauses on slow machines; twice: more to set up than to draw.
constexpr int kMostBands = 32;

}  // namespace

void RestPicture::begin() {
  // Occlusion looks beyond the band that is drawn: a first round, which does not count, puts something there.
  sample_ = bands_ > 1 ? -1 : 0;
  band_ = 0;
  shadows_whole_ = false;
  longest_least_ = work_s_ = 0.0;
}

RestPicture::Piece RestPicture::next() const {
  return {!shadows_whole_, std::max(sample_, 0), band_, bands_};
}

bool RestPicture::took(const Done& done) {
  work_s_ += done.seconds;
  if (!shadows_whole_) {
    shadows_whole_ = done.whole;
    return false;
  }
  longest_least_ = std::max(longest_least_, done.longest_least);
  if (!done.whole || ++band_ < bands_) return false;
  band_ = 0;
  ++sample_;
  shadows_whole_ = sample_ == 0;  // The first sample stands in the same light as the round that does not count.
  if (longest_least_ > piece_s_)
    bands_ = std::min(2 * bands_, kMostBands);
  else if (longest_least_ < 0.3 * piece_s_)
    bands_ = std::max(bands_ / 2, 1);
  longest_least_ = 0.0;
  return true;
}

bool RestPicture::isFinished() const {
  return sample_ >= most_samples_ || (sample_ >= kLeastSamples && work_s_ > kRestSeconds);
}

}  // namespace hapticell::app
