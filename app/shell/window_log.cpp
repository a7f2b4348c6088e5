// SPDX-License-Identifier: Apache-2.0
#include "app/shell/window_log.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QStringList>
#include <utility>

#include "app/import/file_work.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

using config::LogLevel;

namespace {

QString openGlWords(ViewportWidget& viewport) {
  viewport.makeCurrent();
  QStringList words;
  for (const GLenum name : {GL_VERSION, GL_RENDERER, GL_VENDOR}) {
    const GLubyte* text = viewport.context() ? viewport.context()->functions()->glGetString(name) : nullptr;
    if (text != nullptr) words << QString::fromUtf8(reinterpret_cast<const char*>(text));
  }
  viewport.doneCurrent();
  return words.join(QStringLiteral(", "));
}

LogLevel logLevelOf(Severity severity) {
  if (severity == Severity::kProblem) return LogLevel::kError;
  return severity == Severity::kWarning ? LogLevel::kWarning : LogLevel::kInfo;
}

}  // namespace

WindowLog::WindowLog(std::unique_ptr<config::ProgramLog> log, const std::string& program) : log_(std::move(log)) {
  write(LogLevel::kInfo, QString::fromStdString(program).replace('\n', QStringLiteral("; ")));
}

WindowLog::~WindowLog() {
  write(LogLevel::kInfo, QStringLiteral("hapticell ends"));
}

void WindowLog::follow(ViewportWidget& viewport) {
  connect(
      &viewport, &QOpenGLWidget::frameSwapped, this,
      [this, &viewport] { write(LogLevel::kInfo, "OpenGL: " + openGlWords(viewport)); }, Qt::SingleShotConnection);
}

void WindowLog::follow(FileWork& files) {
  connect(&files, &FileWork::opened, this, [this](const QString& path, bool done) {
    write(LogLevel::kInfo, (done ? "opened: " : "not opened: ") + path);
  });
  connect(&files, &FileWork::imported, this, [this](const QString& path, bool done) {
    write(LogLevel::kInfo, (done ? "imported: " : "not imported: ") + path);
  });
}

void WindowLog::follow(MessageLog& messages) {
  for (const Message& message : messages.messages()) noteMessage(message);
  connect(&messages, &MessageLog::told, this, &WindowLog::noteMessage);
}

void WindowLog::noteSaved(const QString& path) {
  write(LogLevel::kInfo, "saved: " + path);
}

void WindowLog::noteDevice(const QString& text, bool works) {
  QString state = text.isEmpty() ? QStringLiteral("none") : text;
  if (!text.isEmpty() && !works) state += QStringLiteral(" (does not work)");
  if (std::exchange(device_, state) != state) write(LogLevel::kInfo, "device: " + state);
}

void WindowLog::noteAction(const QString& name) {
  write(LogLevel::kDebug, "action: " + name);
}

void WindowLog::noteMessage(const Message& message) {
  const QString& text = message.english.isEmpty() ? message.text : message.english;
  write(logLevelOf(message.severity), "message: " + message.title + (text.isEmpty() ? QString() : " | " + text));
}

void WindowLog::write(LogLevel level, const QString& sentence) {
  log_->write(level, sentence.toStdString());
}

}  // namespace hapticell::app
