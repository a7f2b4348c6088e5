// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "trajectory/programs/writing/program_export.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::app {

class Host;
class MotionList;

/// A format for writing motions.
struct MotionFormat {
  QString word;       ///< As in `trajectory export --to`: "krl".
  QString name;       ///< "KUKA KRL (.src, .dat)"
  QString extension;  ///< With the dot; empty: a folder.
  bool is_program = false;
};
const std::vector<MotionFormat>& motionFormats();

/// Writes the current motion to a file or as a robot's program, and reads motions from files, in the background; a
/// message reports the result. GUI thread.
class MotionExport : public QObject {
  Q_OBJECT
 public:
  MotionExport(Host& host, MotionList& list, QObject* parent = nullptr);

  /// Asks for a file. If a program would have very many moves, first asks whether to write only those that are needed
  /// within `tolerance`.
  void askExport(const QString& format, const trajectory::ProgramOptions& options,
                 const trajectory::PathTolerance& tolerance);
  /// `simplify`: writes only the frames needed within this tolerance; the motion itself does not change.
  void exportTo(const QString& path, const QString& format, const trajectory::ProgramOptions& options,
                const std::optional<trajectory::PathTolerance>& simplify = {});
  void askImport();
  /// Reads .htraj, .json, .csv, .yaml, robot programs and recordings (.mcap) with all their motions; notes become
  /// messages. A motion that names no entity is assigned to `entity`, or to the only robot that has its joints.
  void importFrom(const QStringList& paths, const std::string& entity);

 signals:
  void told(const QString& line, bool careful);
  void finished(const QString& path, bool done);

 private:
  enum class Moves { kAll, kNeeded, kNone };
  Moves askMoves(std::size_t moves, const trajectory::PathTolerance& tolerance);
  Host& host_;
  MotionList& list_;
};

}  // namespace hapticell::app
