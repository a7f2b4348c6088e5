// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/viewport/drawing/draw_share.h"
#include "app/viewport/drawing/frame.h"
#include "app/viewport/drawing/gl.h"
#include "app/viewport/drawing/gpu_mesh.h"
#include "app/viewport/drawing/instance_buffer.h"
#include "app/viewport/drawing/shadow_pass.h"

namespace hapticell::app {

/// The view of a frame: matrices in double precision, shared by the passes.
struct FrameView {
  glm::dmat4 clip_from_world{1.0};
  glm::dmat4 view_from_world{1.0};
  glm::dmat4 clip_from_view{1.0};
  glm::dmat4 band_from_world{1.0};  ///< As clip_from_world, but -1 to 1 is the present band with its margin.
};

constexpr int kBandRoom = 6;  ///< Pixels drawn beyond a band: outlines use neighbouring pixels.

/// The view from the frame's camera, shifted to the sample's position within the pixel.
FrameView viewOf(const Frame& frame);

/// The input of all passes of a frame.
struct DrawContext {
  const Frame& frame;
  const FrameView& view;
  GpuMeshCache& meshes;
  DrawShare& share;
};

/// Faces: matte, two-sided, lit by sky and ground, key light with shadow, weak light at the eye; contact is hatched.
class SurfacePass {
 public:
  explicit SurfacePass(Gl& gl);
  void draw(const DrawContext& context, const ShadowPass* shadow);

 private:
  void drawGhosts(const DrawContext& context);
  void prepare(QOpenGLShaderProgram& program, const Frame& frame, const FrameView& view, const ShadowPass* shadow);
  void drawBatches(QOpenGLShaderProgram& program, const std::vector<ItemBatch>& batches, const DrawContext& context,
                   bool hatched);
  void fill(const std::vector<ItemBatch>& batches, const DrawContext& context);
  Gl& gl_;
  ProgramFamily programs_;
  InstanceBuffer uses_;
};

/// Edges as quads of constant width: creases, and silhouettes, where a face turns away from the eye.
class EdgePass {
 public:
  explicit EdgePass(Gl& gl);
  void draw(const DrawContext& context, bool creases_only);

 private:
  void drawItem(const DrawContext& context, const RenderItem& item, GpuMesh& mesh, bool creases_only);
  void prepareItem(const DrawContext& context, const RenderItem& item, const GpuMesh& mesh);
  Gl& gl_;
  std::unique_ptr<QOpenGLShaderProgram> program_;
};

/// The floor at z = 0: a grid that fades out, and the shadows on it.
class FloorPass {
 public:
  explicit FloorPass(Gl& gl);
  ~FloorPass();
  void draw(const DrawContext& context, const ShadowPass* shadow);

 private:
  Gl& gl_;
  ProgramFamily programs_;
  GLuint vertex_array_ = 0;
};

}  // namespace hapticell::app
