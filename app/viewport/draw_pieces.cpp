// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/draw_pieces.h"

#include <algorithm>
#include <utility>

namespace hapticell::app {

DrawPieces::DrawPieces(std::vector<DrawLoad> loads, double seconds, std::size_t triangles)
    : loads_(std::move(loads)), seconds_(seconds), triangles_(std::max(triangles, kLeast)) {}

std::optional<DrawPieces::Piece> DrawPieces::next() {
  while (load_ < loads_.size() && (use_ == loads_[load_].uses || loads_[load_].triangles == 0)) {
    before_ += loads_[load_].uses;
    ++load_;
    use_ = 0;
  }
  if (load_ == loads_.size()) return std::nullopt;
  const DrawLoad& load = loads_[load_];
  Piece piece{load_, before_ + use_, 1, triangle_, 0};
  if (triangle_ == 0 && load.triangles <= triangles_) {
    piece.uses = std::min(load.uses - use_, triangles_ / load.triangles);
    piece.triangles = load.triangles;
  } else {
    piece.triangles = std::min(load.triangles - triangle_, triangles_);
  }
  drawn_ = piece.uses * piece.triangles;
  triangle_ += piece.triangles;
  if (triangle_ == load.triangles) {
    use_ += piece.uses;
    triangle_ = 0;
  }
  return piece;
}

void DrawPieces::took(double seconds) {
  if (seconds > seconds_) {
    triangles_ = std::max(triangles_ / 2, kLeast);
  } else if (seconds < 0.5 * seconds_ && 2 * drawn_ >= triangles_) {  // A small remainder says nothing.
    triangles_ = std::min(2 * triangles_, std::size_t{1} << 30);
  }
}

}  // namespace hapticell::app
