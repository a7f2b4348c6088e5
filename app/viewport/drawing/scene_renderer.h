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
  /// `on_mesh_ready` is called in another thread whenever a part that was missing can be drawn.
  SceneRenderer(Gl& gl, std::function<void()> on_mesh_ready);
  ~SceneRenderer();

  struct PieceDone {
    bool whole = false;          ///< The shadows, or the band, are finished.
    double longest_least = 0.0;  ///< Seconds of what could not be cut: only narrower bands make it shorter.
  };
  /// Draws for about `seconds` at the shadows of the refined sample `frame`, or at its band, which comes after them,
  /// and shows nothing yet. To be called until it is whole; neither the scene nor the frame's size may change in
  /// between, nor from one sample to the next. What else is drawn in between loses what was begun.
  PieceDone drawPiece(const Frame& frame, bool shadows, double seconds);
  /// Draws one sample, or a band of it, and shows nothing yet.
  void draw(const Frame& frame);
  /// The same, and shows the picture in `framebuffer`.
  void render(const Frame& frame, GLuint framebuffer);
  /// Shows the last picture again: the mean of a refined one once its first sample is whole, before that the quick one.
  void present(int width, int height, GLuint framebuffer);
  /// present() shows a picture at rest.
  bool showsRest() const;
  /// What the last frame shows at a pixel (device pixels, origin top left); nothing over background and floor.
  std::optional<PickedPoint> pick(int x, int y);
  /// Parts that are not drawn yet because their edges and normals are still being worked out.
  std::size_t missingParts() const;
  /// What one frame may spend on new parts, so that a cell that was just read does not make one long frame; negative,
  /// as it begins: without limit.
  void setFrameMilliseconds(int most);
  /// Waits until none is missing.
  void waitForParts();
  /// What the last call of draw() drew: calls, triangles of faces, uses of meshes.
  DrawCount lastCount() const;
  /// After so many a still picture is finished (docs/dev/window.md). Half: soft shadows show steps; twice: twice the
  /// time of a fan.
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
