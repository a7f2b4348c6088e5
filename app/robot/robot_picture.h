// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <memory>
#include <vector>

#include "app/style/theme.h"
#include "app/viewport/frame_colors.h"
#include "app/viewport/scene_model.h"
#include "app/viewport/scene_renderer.h"

namespace hapticell::app {

/// Draws small pictures of robots beside the window's scene, in an OpenGL context of its own that is made with the
/// first picture. GUI thread.
class RobotPicture {
 public:
  RobotPicture();
  ~RobotPicture();

  /// The entities alone, with ghosts of them where they are given, seen from the front right above. `size` in device
  /// pixels. A null image where there is no OpenGL 3.3.
  QImage draw(std::vector<workcell::Entity> entities, const std::vector<GhostPose>& ghosts, const QSize& size,
              const Theme& theme);

 private:
  bool begin();
  QOffscreenSurface surface_;
  QOpenGLContext context_;
  Gl gl_;
  std::unique_ptr<SceneRenderer> renderer_;
  bool tried_ = false;
};

}  // namespace hapticell::app
