// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/gl.h"

#include <QDebug>
#include <QFile>

namespace hapticell::app {
namespace {

struct PixelLayout {
  GLenum format;
  GLenum type;
  bool integer;
};

PixelLayout layoutOf(GLenum internal) {
  switch (internal) {
    case GL_R32UI:
      return {GL_RED_INTEGER, GL_UNSIGNED_INT, true};
    case GL_R8:
      return {GL_RED, GL_UNSIGNED_BYTE, false};
    case GL_RGBA16F:
      return {GL_RGBA, GL_HALF_FLOAT, false};
    case GL_RGBA32F:
      return {GL_RGBA, GL_FLOAT, false};
    default:
      return {GL_RGBA, GL_UNSIGNED_BYTE, false};
  }
}

}  // namespace

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char* vertex, const char* fragment,
                                                  const std::vector<const char*>& switches) {
  const auto source = [&switches](const QString& name) {
    QFile file(":/hapticell/shaders/" + name);
    if (!file.open(QIODevice::ReadOnly)) return QByteArray();
    QByteArray text = file.readAll();
    QByteArray defines;
    for (const char* one : switches) defines += QByteArray("#define ") + one + " 1\n";
    return text.insert(text.indexOf('\n') + 1, defines);  // Behind the line with the version.
  };
  auto program = std::make_unique<QOpenGLShaderProgram>();
  const bool good = program->addShaderFromSourceCode(QOpenGLShader::Vertex, source(QString(vertex) + ".vert")) &&
                    program->addShaderFromSourceCode(QOpenGLShader::Fragment, source(QString(fragment) + ".frag")) &&
                    program->link();
  if (good) return program;
  qCritical().noquote() << "Shader" << vertex << fragment << program->log();
  return nullptr;
}

QOpenGLShaderProgram* ProgramFamily::of(unsigned set) {
  auto& program = programs_[set];
  if (!program) {
    std::vector<const char*> on;
    for (std::size_t i = 0; i < switches_.size(); ++i)
      if (set >> i & 1u) on.push_back(switches_[i]);
    program = loadProgram(vertex_, fragment_, on);
  }
  return program.get();
}

void setMatrix(Gl& gl, QOpenGLShaderProgram& program, const char* name, const glm::dmat4& value) {
  const glm::mat4 single(value);
  gl.glUniformMatrix4fv(program.uniformLocation(name), 1, GL_FALSE, glm::value_ptr(single));
}

RenderTarget::~RenderTarget() {
  release();
}

void RenderTarget::release() {
  if (framebuffer_) gl_.glDeleteFramebuffers(1, &framebuffer_);
  if (!colors_.empty()) gl_.glDeleteTextures(static_cast<GLsizei>(colors_.size()), colors_.data());
  if (depth_) gl_.glDeleteTextures(1, &depth_);
  colors_.clear();
  framebuffer_ = depth_ = 0;
}

bool RenderTarget::resize(int width, int height) {
  if (width == width_ && height == height_ && framebuffer_) return false;
  release();
  width_ = width;
  height_ = height;
  gl_.glGenFramebuffers(1, &framebuffer_);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  std::vector<GLenum> buffers;
  const auto setUp = [this](GLuint texture, bool linear) {
    gl_.glBindTexture(GL_TEXTURE_2D, texture);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  };
  for (const GLenum internal : format_.colors) {
    GLuint texture = 0;
    gl_.glGenTextures(1, &texture);
    const PixelLayout layout = layoutOf(internal);
    setUp(texture, format_.linear && !layout.integer);
    gl_.glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), width, height, 0, layout.format, layout.type,
                     nullptr);
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(colors_.size());
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
    colors_.push_back(texture);
    buffers.push_back(attachment);
  }
  if (format_.depth) {
    gl_.glGenTextures(1, &depth_);
    setUp(depth_, format_.depth_compare);
    if (format_.stencil)
      gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, width, height, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                       nullptr);
    else
      gl_.glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width, height, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                       nullptr);
    if (format_.depth_compare) {
      gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
      gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, format_.stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                               GL_TEXTURE_2D, depth_, 0);
  }
  if (buffers.empty()) {
    gl_.glDrawBuffer(GL_NONE);
    gl_.glReadBuffer(GL_NONE);
  } else {
    gl_.glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  }
  if (gl_.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    qCritical() << "A frame buffer is not complete";
  return true;
}

void RenderTarget::bind() {
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.glViewport(0, 0, width_, height_);
}

ScreenTriangle::ScreenTriangle(Gl& gl) : gl_(gl) {
  gl_.glGenVertexArrays(1, &vertex_array_);
}
ScreenTriangle::~ScreenTriangle() {
  gl_.glDeleteVertexArrays(1, &vertex_array_);
}

void ScreenTriangle::draw() {
  gl_.glBindVertexArray(vertex_array_);
  gl_.glDrawArrays(GL_TRIANGLES, 0, 3);
  gl_.glBindVertexArray(0);
}

void bindTexture(Gl& gl, QOpenGLShaderProgram& program, const char* name, int unit, GLuint texture) {
  gl.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.glBindTexture(GL_TEXTURE_2D, texture);
  program.setUniformValue(name, unit);
}

}  // namespace hapticell::app
