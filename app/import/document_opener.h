// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "workcell/format/document_io.h"

namespace hapticell::app {

/// The result of opening a document.
struct OpenedDocument {
  Expected<workcell::Document> document;
  Diagnostics notes;
  std::vector<std::filesystem::path> missing;  ///< Files that were not found; their entities are kept without a shape.
  std::vector<workcell::UnloadedEntity> unloaded;  ///< All entities that are kept without a shape, for any reason.
  std::string content =
      {};  ///< Content name (contentName()) of its file, or of the file that it is a copy of; empty: unknown.
};

/// Reads workcell documents with all their meshes in the background. One at a time: opening another one cancels the
/// first. GUI thread.
class DocumentOpener : public QObject {
  Q_OBJECT
 public:
  using Locate = std::function<std::optional<std::filesystem::path>(const std::filesystem::path&)>;

  explicit DocumentOpener(QObject* parent = nullptr);
  ~DocumentOpener() override;

  /// Reads the file at `path`. Calls `locate` (may be empty), in another thread, for files that are not where the
  /// document says.
  void open(const QString& path, const Locate& locate = {});
  /// Reads the recovery copy of the document at `path`; the result is unsaved and has that path.
  void openCopy(const QString& copy, const QString& path);
  /// Reads a state again from its text, as if its file were in `folder`.
  void openText(const std::string& text, const std::filesystem::path& folder, const QString& name,
                const Locate& locate);
  bool isBusy() const { return run_ != nullptr; }
  QString name() const;
  workcell::ImportProgress progress() const;
  /// Cancels within a second; ended() reports it like a failure.
  void cancel();

 signals:
  void began();
  void progressed();
  void ended(const std::shared_ptr<hapticell::app::OpenedDocument>& opened, const QString& path);

 private:
  struct Run;
  using Read = std::function<Expected<workcell::Document>(Diagnostics&, const workcell::LoadOptions&)>;
  using Content = std::function<std::string()>;
  void start(const QString& path, const Locate& locate, const Content& content, Read read);
  void end(const std::shared_ptr<Run>& run);

  std::shared_ptr<Run> run_;
  QTimer poll_;
  QThreadPool readers_;  // Two threads: a cancelled one may still be reading when the next begins.
};

}  // namespace hapticell::app
