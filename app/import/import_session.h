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

/// One file on its way into the cell.
struct FileImport {
  enum class Stage {
    kExamining,  ///< Is read with the choices as they are, so that the user sees what it is.
    kReady,      ///< Waits for the user's yes.
    kImporting,  ///< The user has said yes.
  };
  int id = 0;
  QString path;
  Stage stage = Stage::kExamining;
  ImportChoices choices;
  workcell::ImportProgress progress;
  double elapsed = 0.0;              ///< Seconds since its reading began.
  bool queued = false;               ///< Another file is being read before it.
  std::optional<ImportFacts> facts;  ///< Of the examination.
  bool asks = false;                 ///< Waits for the user's yes once it was read.
  bool unit_is_open = false;         ///< Nobody knows its unit yet: the user has to say it (choose()) before import().
  ImportChoices examined_with;
  double seconds = 0.0;  ///< That the examination took.
};

/// Files that are being imported: each is read in the background (workcell::Importer), shown, and imported when the
/// user confirms; several wait for each other. Nothing here reads a file in the caller's thread. GUI thread.
class ImportSession : public QObject {
  Q_OBJECT
 public:
  using Result = std::shared_ptr<Expected<workcell::ImportResult>>;

  explicit ImportSession(QObject* parent = nullptr);
  ~ImportSession() override;

  /// Begins with these files. `ask`: each waits for import(); else it goes into the cell as soon as it is read. Robots
  /// and built-in things are never asked about: there is nothing to choose, but the arguments of a xacro that has some.
  /// Gives the new ids.
  std::vector<int> add(const QStringList& paths, bool ask);
  const std::vector<FileImport>& files() const { return files_; }
  const FileImport* find(int id) const;
  bool isBusy() const;

  /// A unit that is said counts for all other files, present and to come until all are gone, whose unit is open.
  void choose(int id, const ImportChoices& choices);
  /// Nothing for a file whose unit is open. Hands over what was read where the choices are still those it was read
  /// with; else reads it again first.
  void import(int id);
  /// Gives one up; its reading ends within a second.
  void cancel(int id);
  void cancelAll();
  /// Pixels of FileImport::facts.picture.
  void setPictureSize(QSize size) { picture_size_ = size; }
  /// What an import with the present choices will make.
  static ImportEstimate estimateOf(const FileImport& file);

 signals:
  void changed();  ///< A file came, went or changed its stage.
  void progressed();
  /// A file was read and wanted. The result may be moved out of.
  void finished(const QString& path, const hapticell::app::ImportSession::Result& result);

 private:
  struct Work {
    int file = 0;
    workcell::ImportId job = 0;
    QElapsedTimer clock;
    Result result;  ///< Of the examination.
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
  std::optional<double> said_unit_;  ///< Metres per unit that the user said for one of these files.
  QSize picture_size_{560, 300};
  std::vector<FileImport> files_;
  std::vector<Work> works_;
  QTimer poll_;
  QThreadPool painters_;
  std::unique_ptr<workcell::Importer> importer_;  // Last: its thread calls us.
};

}  // namespace hapticell::app
