// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/viewport/frame.h"
#include "app/viewport/gl.h"
#include "app/viewport/gpu_mesh.h"
#include "app/viewport/instance_buffer.h"

namespace hapticell::app {

/// The scene seen from the key light, as depth.
class ShadowPass {
 public:
  explicit ShadowPass(Gl& gl);
  /// Draws the map anew. In samples after the first the light stands a little aside each time, which makes soft
  /// borders.
  void draw(const Frame& frame, GpuMeshCache& meshes);
  bool ready() const { return ready_; }
  /// Metres of the cell that a texel of the map covers.
  double texel() const { return texel_; }
  GLuint map() const { return target_.depth(); }
  const glm::dmat4& lightFromWorld() const { return light_from_world_; }

 private:
  Gl& gl_;
  std::unique_ptr<QOpenGLShaderProgram> program_;
  RenderTarget target_;
  InstanceBuffer uses_;
  glm::dmat4 light_from_world_{1.0};
  double texel_ = 0.0;
  bool ready_ = false;
};

}  // namespace hapticell::app
