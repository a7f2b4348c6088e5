// SPDX-License-Identifier: Apache-2.0
#include "app/import/document_opener.h"

#include <QFileInfo>
#include <exception>

#include "workcell/files/autosave.h"
#include "workcell/files/content_name.h"
#include "workcell/import/background_thread.h"

namespace hapticell::app {

struct DocumentOpener::Run {
  QString path;
  workcell::ImportMonitor monitor;
  std::shared_ptr<OpenedDocument> result;  // Set by the thread before it tells.
};

namespace {

/// Nothing may leave the thread: what a library throws becomes a sentence.
Expected<workcell::Document> guarded(const std::function<Expected<workcell::Document>()>& read, const QString& path) {
  try {
    return read();
  } catch (const std::exception& exception) {
    return makeError({.file = path.toStdString(), .found = Text("it cannot be read: %1", exception.what())});
  }
}

}  // namespace

DocumentOpener::DocumentOpener(QObject* parent) : QObject(parent) {
  readers_.setMaxThreadCount(2);
  poll_.setInterval(50);
  connect(&poll_, &QTimer::timeout, this, &DocumentOpener::progressed);
}

DocumentOpener::~DocumentOpener() {
  if (run_) run_->monitor.cancel();
  readers_.waitForDone();
}

QString DocumentOpener::name() const {
  return run_ ? QFileInfo(run_->path).fileName() : QString();
}

workcell::ImportProgress DocumentOpener::progress() const {
  return run_ ? run_->monitor.progress() : workcell::ImportProgress{};
}

void DocumentOpener::cancel() {
  if (run_) run_->monitor.cancel();
}

void DocumentOpener::open(const QString& path, const Locate& locate) {
  // Before it is read: what another program writes meanwhile is then noticed.
  const auto content = [file = path.toStdString()] { return workcell::contentNameOf(file); };
  start(path, locate, content, [file = path.toStdString()](Diagnostics& notes, const workcell::LoadOptions& options) {
    return workcell::loadDocument(file, notes, options);
  });
}

void DocumentOpener::openCopy(const QString& copy, const QString& path) {
  const auto read = [from = copy.toStdString(), to = path.toStdString()](
                        Diagnostics& notes, const workcell::LoadOptions& options) -> Expected<workcell::Document> {
    auto document = workcell::loadDocument(from, notes, options);
    if (!document) return document;
    document->setPath(to);
    document->markUnsaved();
    return document;
  };
  const auto base = [run = std::filesystem::path(copy.toStdString()).parent_path()] {
    return workcell::copyFactsIn(run).base;
  };
  start(path, {}, base, read);
}

void DocumentOpener::openText(const std::string& text, const std::filesystem::path& folder, const QString& name,
                              const Locate& locate) {
  start(name, locate, {}, [=](Diagnostics& notes, const workcell::LoadOptions& options) {
    return workcell::parseDocument(text, folder, name.toStdString(), notes, options);
  });
}

void DocumentOpener::start(const QString& path, const Locate& locate, const Content& content, Read read) {
  cancel();
  auto run = std::make_shared<Run>();
  run->path = path;
  run_ = run;
  readers_.start([this, run, locate, content, read = std::move(read)] {
    workcell::lowerThreadPriority();
    Diagnostics notes;
    std::vector<std::filesystem::path> missing;
    workcell::LoadOptions options;
    options.keep_unloaded = true;
    std::vector<workcell::UnloadedEntity> unloaded;
    options.unloaded = &unloaded;
    options.monitor = &run->monitor;
    options.locate = [&](const std::filesystem::path& file) {
      auto place = locate ? locate(file) : std::nullopt;
      if (!place) missing.push_back(file);
      return place;
    };
    std::string held = content ? content() : std::string();
    auto document = guarded([&] { return read(notes, options); }, run->path);
    run->result = std::make_shared<OpenedDocument>(OpenedDocument{
        std::move(document), std::move(notes), std::move(missing), std::move(unloaded), std::move(held)});
    QMetaObject::invokeMethod(
        this, [this, run] { end(run); }, Qt::QueuedConnection);
  });
  poll_.start();
  emit began();
}

void DocumentOpener::end(const std::shared_ptr<Run>& run) {
  if (run != run_) return;  // Another one was begun since.
  run_.reset();
  poll_.stop();
  emit ended(run->result, run->path);
}

}  // namespace hapticell::app
