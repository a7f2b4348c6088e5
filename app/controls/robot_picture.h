// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/drawing/picture_renderer.h"

namespace hapticell::app {

/// Small pictures of robots for lists, by a renderer that is made with the first picture. GUI thread.
class RobotPicture {
 public:
  /// The entities alone, seen from the front right above. `size` in device pixels. A null image where there is no
  /// OpenGL 3.3.
  /// `nearer`: times as near as a ball about all of it would have it; a wide picture of an arm bears more than 1.
  QImage draw(std::vector<workcell::Entity> entities, const QSize& size, const Theme& theme, double nearer = 1.0);

 private:
  std::optional<PictureRenderer> renderer_;
  bool tried_ = false;
};

}  // namespace hapticell::app
