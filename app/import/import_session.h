// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/import/import_facts.h"
#include "workcell/import/importer.h"

namespace hapticell::app {

/// One file that is being imported.
struct FileImport {
  enum class Stage {
    kExamining,  ///< Being read with the present choices, so that the user sees what it is.
    kReady,      ///< Waits for the user's confirmation.
    kImporting,  ///< The user has confirmed.
  };
  int id = 0;
  QString path;
  Stage stage = Stage::kExamining;
  ImportChoices choices;
  workcell::ImportProgress progress;
  double elapsed = 0.0;              ///< Seconds since reading began.
  bool queued = false;               ///< Waits while another file is being read.
  std::optional<ImportFacts> facts;  ///< From the examination.
  bool asks = false;                 ///< Waits for the user's confirmation after reading.
  bool unit_is_open = false;         ///< The unit is unknown: the user has to choose it (choose()) before import().
  ImportChoices examined_with;
  double seconds = 0.0;  ///< Duration of the examination.
};

/// Files that are being imported: each is read in the background (workcell::Importer), shown, and imported when the
/// user confirms; several wait for each other. Nothing here reads a file in the caller's thread. GUI thread.
class ImportSession : public QObject {
  Q_OBJECT
 public:
  using Result = std::shared_ptr<Expected<workcell::ImportResult>>;

  explicit ImportSession(QObject* parent = nullptr);
  ~ImportSession() override;

  /// Starts with these files. `ask`: each waits for import(); else it is imported as soon as it is read. Robots and
  /// built-in parts are imported without asking, because there is nothing to choose, except for a xacro with arguments.
  /// Returns the new ids.
  std::vector<int> add(const QStringList& paths, bool ask);
  const std::vector<FileImport>& files() const { return files_; }
  const FileImport* find(int id) const;
  bool isBusy() const;

  /// A chosen unit applies to all other files with an unknown unit, present and future, until no file is left.
  void choose(int id, const ImportChoices& choices);
  /// Does nothing for a file whose unit is unknown. Hands over what was read if the choices are still the same; else
  /// reads the file again first.
  void import(int id);
  /// Cancels a file; reading ends within a second.
  void cancel(int id);
  void cancelAll();
  /// Size of FileImport::facts.picture in pixels.
  void setPictureSize(QSize size) { picture_size_ = size; }
  /// Estimate of an import with the present choices.
  static ImportEstimate estimateOf(const FileImport& file);

 signals:
  void changed();  ///< A file was added, removed or changed its stage.
  void progressed();
  /// A file was read and confirmed. The receiver may move from the result.
  void finished(const QString& path, const hapticell::app::ImportSession::Result& result);

 private:
  struct Work {
    int file = 0;
    workcell::ImportId job = 0;
    QElapsedTimer clock;
    Result result;  ///< From the examination.
  };
  FileImport* get(int id);
  Work* workOf(int id);
  void start(FileImport& file);
  void takeEnded(workcell::ImportId job);
  void examined(int id, Result result);
  void examineArguments(int id, Result result);
  void finish(int id, Result result);
  void paint(int id);
  void showFacts(int id, ImportFacts facts);
  void remove(int id);
  void poll();

  int last_id_ = 0;
  std::optional<double> said_unit_;  ///< Metres per unit that the user chose for one of these files.
  QSize picture_size_{560, 300};
  std::vector<FileImport> files_;
  std::vector<Work> works_;
  QTimer poll_;
  QThreadPool painters_;
  std::unique_ptr<workcell::Importer> importer_;  // Last: its thread calls this object.
};

}  // namespace hapticell::app
