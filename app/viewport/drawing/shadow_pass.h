// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/viewport/drawing/draw_share.h"
#include "app/viewport/drawing/frame.h"
#include "app/viewport/drawing/gl.h"
#include "app/viewport/drawing/gpu_mesh.h"
#include "app/viewport/drawing/instance_buffer.h"
#include "app/viewport/drawing/item_batches.h"

namespace hapticell::app {

/// The scene seen from the key light, as depth.
class ShadowPass {
 public:
  explicit ShadowPass(Gl& gl);
  // For samples after the first, the light is shifted slightly each time, which gives soft borders.

  /// Draws a share of a new map; true once it is whole. Until then, map() is the previous one. The scene must not
  /// change between the shares of a map: if it does, call giveUp().
  bool draw(const Frame& frame, GpuMeshCache& meshes, DrawShare& share);
  /// Drops an unfinished map.
  void giveUp() { begun_.reset(); }
  bool ready() const { return ready_; }
  /// Metres of the cell that a texel of the map covers.
  double texel() const { return shown_.texel; }
  GLuint map() const { return targets_[shown_target_].depth(); }
  const glm::dmat4& lightFromWorld() const { return shown_.light_from_world; }

 private:
  /// The light's view of the scene.
  struct View {
    glm::dmat4 light_from_world{1.0};
    double texel = 0.0;
  };
  struct Begun {
    View view;
    std::vector<ItemBatch> batches;
  };
  static View viewOf(const Frame& frame);
  void begin(const Frame& frame, GpuMeshCache& meshes);
  bool canDraw(const Frame& frame);
  void prepare(const Frame& frame);
  void endDrawing();
  void show();

  Gl& gl_;
  std::unique_ptr<QOpenGLShaderProgram> program_;
  std::array<RenderTarget, 2> targets_;  ///< The shown map and the one that is being drawn.
  std::size_t shown_target_ = 0;
  InstanceBuffer uses_;
  View shown_;
  std::optional<Begun> begun_;
  bool ready_ = false;
};

}  // namespace hapticell::app
