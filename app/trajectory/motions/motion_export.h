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

/// A format that motions can be written in.
struct MotionFormat {
  QString word;       ///< As `trajectory export --to` has it: "krl".
  QString name;       ///< "KUKA KRL (.src, .dat)"
  QString extension;  ///< With the dot; empty: a folder.
  bool is_program = false;
};
const std::vector<MotionFormat>& motionFormats();

/// Writes the current motion as a file or a robot's program and reads motions from files, in the background; a message
/// reports the result. GUI thread.
class MotionExport : public QObject {
  Q_OBJECT
 public:
  MotionExport(Host& host, MotionList& list, QObject* parent = nullptr);

  /// Asks for the place; before that, where a program would have very many moves, whether only those are written that
  /// are needed within `tolerance`.
  void askExport(const QString& format, const trajectory::ProgramOptions& options,
                 const trajectory::PathTolerance& tolerance);
  /// `simplify`: only the frames that are needed within it; the motion itself stays as it is.
  void exportTo(const QString& path, const QString& format, const trajectory::ProgramOptions& options,
                const std::optional<trajectory::PathTolerance>& simplify = {});
  void askImport();
  /// .htraj, .json, .csv, .yaml and robots' programs, whose notes become messages; a motion that names no entity is
  /// that of `entity`.
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
