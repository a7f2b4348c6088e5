// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/viewport/frame.h"
#include "app/viewport/gl.h"
#include "app/viewport/gpu_mesh.h"
#include "app/viewport/instance_buffer.h"
#include "app/viewport/shadow_pass.h"

namespace hapticell::app {

/// Where a frame is looked from: matrices in double precision, shared by the passes.
struct FrameView {
  glm::dmat4 clip_from_world{1.0};
  glm::dmat4 view_from_world{1.0};
  glm::dmat4 clip_from_view{1.0};
};

/// Looked from the frame's camera, shifted to the sample's place within the pixel.
FrameView viewOf(const Frame& frame);

/// Faces: matte, two-sided, sky and ground light, key light with shadow, a weak light at the eye; contact is hatched.
class SurfacePass {
 public:
  explicit SurfacePass(Gl& gl);
  void draw(const Frame& frame, const FrameView& view, const ShadowPass* shadow, GpuMeshCache& meshes);

 private:
  void drawGhosts(const Frame& frame, const FrameView& view, GpuMeshCache& meshes);
  void prepare(QOpenGLShaderProgram& program, const Frame& frame, const FrameView& view, const ShadowPass* shadow);
  void drawBatches(QOpenGLShaderProgram& program, const std::vector<ItemBatch>& batches, const Frame& frame,
                   const FrameView& view, bool hatched);
  Gl& gl_;
  ProgramFamily programs_;
  InstanceBuffer uses_;
};

/// Edges as quads of constant width: creases, and where a face turns away from the eye.
class EdgePass {
 public:
  explicit EdgePass(Gl& gl);
  void draw(const Frame& frame, const FrameView& view, bool creases_only, GpuMeshCache& meshes);

 private:
  Gl& gl_;
  std::unique_ptr<QOpenGLShaderProgram> program_;
};

/// The floor at z = 0: a grid that fades out, and the shadows on it.
class FloorPass {
 public:
  explicit FloorPass(Gl& gl);
  ~FloorPass();
  void draw(const Frame& frame, const FrameView& view, const ShadowPass* shadow);

 private:
  Gl& gl_;
  ProgramFamily programs_;
  GLuint vertex_array_ = 0;
};

}  // namespace hapticell::app
