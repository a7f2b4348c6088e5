// SPDX-License-Identifier: Apache-2.0
#include "app/controls/robot_picture.h"

namespace hapticell::app {

QImage RobotPicture::draw(std::vector<workcell::Entity> entities, const QSize& size, const Theme& theme) {
  if (!tried_) {
    tried_ = true;
    if (auto made = PictureRenderer::make()) renderer_.emplace(std::move(*made));
  }
  if (!renderer_) return {};
  SceneModel scene;
  scene.setEntities(std::move(entities));
  const ViewSize view{static_cast<double>(size.width()), static_cast<double>(size.height())};
  Camera camera;
  camera.azimuth = 0.7;
  camera.elevation = 0.3;
  camera = camera.fitted(scene.corners_W(), view);
  constexpr int kSamples = 4;  // Enough for a small picture.
  return renderer_->draw(scene, camera, size, theme, {.edges = true, .floor = false, .samples = kSamples});
}

}  // namespace hapticell::app
