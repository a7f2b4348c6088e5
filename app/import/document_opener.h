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

/// What an opening ended with.
struct OpenedDocument {
  Expected<workcell::Document> document;
  Diagnostics notes;
  std::vector<std::filesystem::path> missing;  ///< Files that were not found; their entities are kept without a shape.
  std::vector<workcell::UnloadedEntity> unloaded;  ///< Entities that are kept without a shape, for any reason.
  std::string content =
      {};  ///< What its file held (contentName()), or the one that a copy is a copy of; empty: unknown.
};

/// Reads workcell documents, with all the meshes they name, in the background. One at a time: another begins by giving
/// the first one up. GUI thread.
class DocumentOpener : public QObject {
  Q_OBJECT
 public:
  using Locate = std::function<std::optional<std::filesystem::path>(const std::filesystem::path&)>;

  explicit DocumentOpener(QObject* parent = nullptr);
  ~DocumentOpener() override;

  /// Reads the file at `path`. `locate` (may be empty) is asked in another thread for files that are not where the
  /// document says.
  void open(const QString& path, const Locate& locate = {});
  /// Reads the copy of the document at `path` that a crash left: what is read is unsaved, and has that path.
  void openCopy(const QString& copy, const QString& path);
  /// Reads a state again from its text, as it would stand in `folder`.
  void openText(const std::string& text, const std::filesystem::path& folder, const QString& name,
                const Locate& locate);
  bool isBusy() const { return run_ != nullptr; }
  QString name() const;
  workcell::ImportProgress progress() const;
  /// Ends it within a second; ended() reports it like a failure.
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
  QThreadPool readers_;  // Two: one that was given up may still be reading when the next begins.
};

}  // namespace hapticell::app
