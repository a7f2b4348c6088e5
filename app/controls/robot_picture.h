// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/drawing/picture_renderer.h"

namespace hapticell::app {

/// Small pictures of robots for lists. The renderer is made with the first picture. GUI thread.
class RobotPicture {
 public:
  /// Draws these entities alone, seen from above, front right. `size` in device pixels. Returns a null image without
  /// OpenGL 3.3.
  QImage draw(std::vector<workcell::Entity> entities, const QSize& size, const Theme& theme);

 private:
  std::optional<PictureRenderer> renderer_;
  bool tried_ = false;
};

}  // namespace hapticell::app
