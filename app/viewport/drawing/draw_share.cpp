// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/draw_share.h"

#include <algorithm>
#include <utility>

namespace hapticell::app {
namespace {

// Triangles of one call, so that doubling ends. Half, twice: no effect.
constexpr std::size_t kMostUnits = std::size_t{1} << 30;

/// From a place in the load on: the rest of a use, or as many whole uses as one call may draw.
DrawPart partFrom(std::size_t place, const DrawLoad& load, std::size_t most_units) {
  DrawPart part{place / load.units, 1, place % load.units, 0};
  if (part.first_unit > 0 || load.units > most_units) {
    part.units = std::min(load.units - part.first_unit, most_units);
  } else {
    part.units = load.units;
    part.uses = std::min(load.uses - part.first_use, most_units / load.units);
  }
  return part;
}

}  // namespace

DrawShare::DrawShare(DrawProgress& progress, double seconds, Clock clock)
    : progress_(&progress), seconds_(seconds), clock_(std::move(clock)) {
  start_ = clock_.now();
}

void DrawShare::offer(const DrawLoad& load, const Draw& draw) {
  if (load.units == 0 || load.uses == 0) return;
  if (!progress_) return draw({0, load.uses, 0, load.units});
  const std::size_t end = offered_ + load.units * load.uses;
  while (progress_->done < end && !over_)
    drawPart(partFrom(progress_->done - offered_, load, progress_->call), true, draw);
  left_over_ = left_over_ || progress_->done < end;
  offered_ = end;
}

void DrawShare::once(std::size_t units, const std::function<void()>& draw) {
  if (!progress_) return draw();
  const std::size_t end = offered_ + std::max<std::size_t>(units, 1);
  if (progress_->done < end && !over_) drawPart({0, 1, 0, end - offered_}, false, [&draw](const DrawPart&) { draw(); });
  left_over_ = left_over_ || progress_->done < end;
  offered_ = end;
}

void DrawShare::drawPart(const DrawPart& part, bool cuttable, const Draw& draw) {
  const double before = clock_.now();
  draw(part);
  if (clock_.wait) clock_.wait();
  const double after = clock_.now(), took = after - before;
  const std::size_t drawn = part.units * part.uses;
  progress_->done += drawn;
  over_ = after - start_ >= seconds_;
  if (!cuttable || drawn <= kLeastUnits) longest_least_ = std::max(longest_least_, took);
  if (!cuttable) return;
  std::size_t& call = progress_->call;
  if (took > kCallSeconds)
    call = std::max(std::min(call, drawn) / 2, kLeastUnits);
  else if (took < 0.5 * kCallSeconds && 2 * drawn >= call)  // A small remainder says nothing.
    call = std::min(2 * call, kMostUnits);
}

}  // namespace hapticell::app
