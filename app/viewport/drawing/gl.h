// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

namespace hapticell::app {

/// OpenGL 3.3 core. All classes that take it are used on one thread with one current context, and are destroyed before
/// the context.
using Gl = QOpenGLFunctions_3_3_Core;

/// Compiles shaders/NAME.vert and shaders/NAME.frag from the resources. If that fails, which is a bug of the program,
/// writes it to the log and returns null.
/// Each of `switches` is defined as 1.
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char* vertex, const char* fragment,
                                                  const std::vector<const char*>& switches = {});

/// One program for each set of switches, compiled on first use. Software renderers run both branches of every `if`, so
/// what a frame does not need is left out when compiling, not when drawing.
class ProgramFamily {
 public:
  ProgramFamily(const char* vertex, const char* fragment, std::vector<const char*> switches)
      : vertex_(vertex), fragment_(fragment), switches_(std::move(switches)), programs_(1u << switches_.size()) {}
  /// Bit i of `set` turns the i-th switch on. Null if it does not compile.
  QOpenGLShaderProgram* of(unsigned set);

 private:
  const char* vertex_;
  const char* fragment_;
  std::vector<const char*> switches_;
  std::vector<std::unique_ptr<QOpenGLShaderProgram>> programs_;
};

void setMatrix(Gl& gl, QOpenGLShaderProgram& program, const char* name, const glm::dmat4& value);

/// A frame buffer with textures.
class RenderTarget {
 public:
  struct Format {
    std::vector<GLenum> colors;  ///< Internal formats of the colour attachments.
    bool depth = false;
    bool stencil = false;        ///< Requires depth: also a stencil buffer.
    bool depth_compare = false;  ///< For sampler2DShadow.
    bool linear = false;
  };
  RenderTarget(Gl& gl, Format format) : gl_(gl), format_(std::move(format)) {}
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;

  /// Makes new textures if the size has changed; returns true then.
  bool resize(int width, int height);
  void bind();  ///< Binds it for drawing, with the viewport set to its size.
  GLuint color(std::size_t index) const { return colors_[index]; }
  GLuint depth() const { return depth_; }
  GLuint framebuffer() const { return framebuffer_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void release();
  Gl& gl_;
  Format format_;
  GLuint framebuffer_ = 0, depth_ = 0;
  std::vector<GLuint> colors_;
  int width_ = 0, height_ = 0;
};

/// A triangle that covers the screen, for passes over pixels.
class ScreenTriangle {
 public:
  explicit ScreenTriangle(Gl& gl);
  ~ScreenTriangle();
  void draw();

 private:
  Gl& gl_;
  GLuint vertex_array_ = 0;
};

void bindTexture(Gl& gl, QOpenGLShaderProgram& program, const char* name, int unit, GLuint texture);

}  // namespace hapticell::app
