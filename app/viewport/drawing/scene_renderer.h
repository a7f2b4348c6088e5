// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/viewport/drawing/draw_share.h"
#include "app/viewport/drawing/frame.h"
#include "app/viewport/drawing/gl.h"
#include "app/viewport/drawing/gpu_mesh.h"

namespace hapticell::app {

/// What is under a pixel.
struct PickedPoint {
  workcell::EntityId entity = 0;  ///< 0: the drawn stylus.
  int link = -1;                  ///< For robots: index of the link.
  dvec3 p_WQ{0.0};
};

/// Draws the scene. Needs a current OpenGL 3.3 core context during its whole life; uses no widgets.
///
/// A picture at rest is refined: each call with the next Frame::sample adds a sample with shifted pixels and light to
/// the mean, which smooths lines, shadows and occlusion without multisampling.
class SceneRenderer {
 public:
  /// Calls `on_mesh_ready` in another thread whenever a missing part can be drawn.
  SceneRenderer(Gl& gl, std::function<void()> on_mesh_ready);
  ~SceneRenderer();

  struct PieceDone {
    bool whole = false;          ///< The shadows, or the band, are finished.
    double longest_least = 0.0;  ///< Seconds of what could not be divided: only narrower bands shorten it.
  };
  /// Draws for about `seconds` the shadows of the refined sample `frame`, or its band, which follows them, and shows
  /// nothing yet. Call it until the piece is whole. Neither the scene nor the frame's size may change in between, nor
  /// from one sample to the next. Drawing anything else in between discards the piece.
  PieceDone drawPiece(const Frame& frame, bool shadows, double seconds);
  /// Draws one sample, or a band of it, without showing it.
  void draw(const Frame& frame);
  /// Draws the same, and shows the picture in `framebuffer`.
  void render(const Frame& frame, GLuint framebuffer);
  /// Shows the last picture again: the refined mean once its first sample is whole, before that the quick picture.
  void present(int width, int height, GLuint framebuffer);
  /// True if present() shows a picture at rest.
  bool showsRest() const;
  /// What the last frame shows at a pixel (device pixels, origin top left); empty over background and floor.
  std::optional<PickedPoint> pick(int x, int y);
  /// Number of parts that are not drawn yet because their edges and normals are still being computed.
  std::size_t missingParts() const;
  /// Sets how long one frame may prepare new parts, so that a newly opened cell causes no long frame; negative (the
  /// default): no limit.
  void setFrameMilliseconds(int most);
  /// Waits until no part is missing.
  void waitForParts();
  /// What the last call of draw() drew: calls, triangles of faces, uses of meshes.
  DrawCount lastCount() const;
  /// Number of samples of a finished picture at rest (docs/dev/window.md). Half: soft shadows show steps; twice: twice
  /// the time with a noisy fan.
  static constexpr int kSamples = 24;

 private:
  struct Passes;
  void drawShadows(const Frame& frame);
  void drawScene(const Frame& frame, DrawShare& share);
  void composite(const Frame& frame, DrawShare& share);
  void drawOcclusion(const Frame& frame);
  void compositeBand(const Frame& frame, bool occluded);
  void keepForPicking(const Frame& frame);
  Gl& gl_;
  std::unique_ptr<Passes> passes_;
  Frame last_;
};

}  // namespace hapticell::app
