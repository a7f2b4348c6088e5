// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "app/viewport/frame.h"
#include "app/viewport/gl.h"

namespace hapticell::app {

/// What lies under a pixel.
struct PickedPoint {
  workcell::EntityId entity = 0;  ///< 0: the drawn stylus.
  int link = -1;                  ///< Robots: index of the link.
  dvec3 p_WQ{0.0};
};

/// Draws the scene. Needs a current OpenGL 3.3 core context from its making to its end; knows no widgets.
///
/// A still picture is refined: each call with the next Frame::sample adds a sample with shifted pixels and light to the
/// mean, which smooths lines, shadows and occlusion without multisampling.
class SceneRenderer {
 public:
  explicit SceneRenderer(Gl& gl);
  ~SceneRenderer();

  /// Draws one sample and shows the mean in `framebuffer`.
  void render(const Frame& frame, GLuint framebuffer);
  /// Shows the last picture again.
  void present(int width, int height, GLuint framebuffer);
  /// What the last frame shows at a pixel (device pixels, origin top left); nothing over background and floor.
  std::optional<PickedPoint> pick(int x, int y);
  static constexpr int kSamples = 24;  ///< After so many a still picture is finished.

 private:
  struct Passes;
  void drawScene(const Frame& frame);
  void composite(const Frame& frame);
  Gl& gl_;
  std::unique_ptr<Passes> passes_;
  Frame last_;
};

}  // namespace hapticell::app
