// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/graphics_probe.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace hapticell::app {

namespace {

QString wordOf(QOpenGLContext& context, GLenum name) {
  const GLubyte* const text = context.functions()->glGetString(name);
  return text != nullptr ? QString::fromUtf8(reinterpret_cast<const char*>(text)) : QString();
}

bool isSoftware(const QString& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"})
    if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) return true;
  return false;
}

QJsonObject probe() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QOffscreenSurface surface;
  surface.setFormat(format);
  surface.create();
  QOpenGLContext context;
  context.setFormat(format);
  if (!surface.isValid() || !context.create() || !context.makeCurrent(&surface))
    return {{"problem", "this display has no OpenGL 3.3"}};
  const QString renderer = wordOf(context, GL_RENDERER), version = wordOf(context, GL_VERSION);
  const QString vendor = wordOf(context, GL_VENDOR);
  const QSurfaceFormat given = context.format();
  context.doneCurrent();
  if (given.version() < qMakePair(3, 3)) return {{"problem", "OpenGL " + version + ", 3.3 is needed"}};
  return {
      {"version", "OpenGL " + version}, {"renderer", renderer}, {"vendor", vendor}, {"software", isSoftware(renderer)}};
}

}  // namespace

QByteArray probeGraphics() {
  return QJsonDocument(probe()).toJson(QJsonDocument::Compact);
}

}  // namespace hapticell::app
