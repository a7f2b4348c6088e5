// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>
#include <memory>

#include "app/style/theme.h"
#include "app/viewport/scene/camera.h"
#include "app/viewport/scene/scene_model.h"
#include "geometry/system/error.h"

namespace hapticell::app {

/// Finished pictures of a scene without a window, of any size, for files, reports and previews. Has its own OpenGL
/// context. GUI thread; make it after the QApplication.
class PictureRenderer {
 public:
  /// Error: the platform has no OpenGL 3.3 (no display, no driver).
  static Expected<PictureRenderer> make();
  PictureRenderer(PictureRenderer&&) noexcept;
  PictureRenderer& operator=(PictureRenderer&&) noexcept;
  ~PictureRenderer();

  struct Look {
    bool edges = true;
    bool floor = true;  ///< The grid and the shadows on it.
    int samples = 24;   ///< Averaged for smooth lines and soft shadows; 1 is quick and rough.
  };

  /// All samples of the picture, no labels. Sides of 1 to 16384 pixels; larger pictures are scaled down.
  QImage draw(const SceneModel& scene, const Camera& camera, const QSize& size, const Theme& theme, const Look& look);

 private:
  struct Context;
  explicit PictureRenderer(std::unique_ptr<Context> context);
  std::unique_ptr<Context> context_;
};

}  // namespace hapticell::app
