// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/viewport/drawing/frame.h"
#include "app/viewport/drawing/gl.h"
#include "app/viewport/drawing/gpu_mesh.h"
#include "app/viewport/drawing/surface_pass.h"

namespace hapticell::app {

/// The caps of the section plane: a hatched face in the plane where it cuts a closed part. The stencil buffer counts
/// the part's faces behind the plane; where more leave than enter, the plane is inside the part.
class CapPass {
 public:
  explicit CapPass(Gl& gl);
  ~CapPass();
  /// Draws after the faces, into the same target, which needs a stencil buffer. Draws nothing without a section plane.
  void draw(const DrawContext& context);

 private:
  bool cuts(const DrawContext& context, const RenderItem& item) const;
  void count(const Frame& frame, const FrameView& view, const RenderItem& item, GpuMesh& mesh);
  void fill(const Frame& frame, const FrameView& view, const RenderItem& item, std::uint32_t id);
  Gl& gl_;
  std::unique_ptr<QOpenGLShaderProgram> counter_, cap_;
  GLuint vertex_array_ = 0;
};

}  // namespace hapticell::app
