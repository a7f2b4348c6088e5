// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/motion_export.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <limits>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/kit/file_dialog.h"
#include "app/style/library_text.h"
#include "app/style/units.h"
#include "app/trajectory/motions/motion_list.h"
#include "exchange/recordings/recording_reader.h"
#include "geometry/system/scratch_folder.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/checks/program_configuration.h"
#include "manipulation/manipulators/arm_configuration.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/files/ros_trajectory.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {
namespace {

using trajectory::ProgramFile;
using trajectory::ProgramFormat;
using trajectory::Trajectory;

// Moves from which simplifying is offered: programs of more are slow to load and edit. Our choice. Half, twice: asked
// more or less often.
constexpr std::size_t kManyMoves = 500;

ProgramFormat programFormat(const QString& word) {
  if (word == "krl") return ProgramFormat::kKrl;
  if (word == "rapid") return ProgramFormat::kRapid;
  if (word == "fanuc") return ProgramFormat::kFanuc;
  if (word == "urscript") return ProgramFormat::kUrScript;
  return word == "inform" ? ProgramFormat::kInform : ProgramFormat::kVal3;
}

Expected<std::vector<ProgramFile>> filesOf(const Trajectory& given, const QString& format, const QString& path,
                                           const trajectory::ProgramOptions& options, std::vector<Text>& notes) {
  const std::string wanted = path.toStdString();
  if (format == "csv") return std::vector<ProgramFile>{{wanted, trajectory::toCsvText(given)}};
  if (format == "json") return std::vector<ProgramFile>{{wanted, trajectory::toJsonText(given)}};
  if (format == "ros") {
    auto text = trajectory::toRosText(given);
    HAPTICELL_TRY(text);
    return std::vector<ProgramFile>{{wanted, std::move(*text)}};
  }
  auto files = trajectory::exportProgram(given, programFormat(format), options, &notes);
  HAPTICELL_TRY(files);
  return trajectory::placedProgram(*files, programFormat(format), wanted);
}

/// Reads a written file back before it takes its place: a table is measured as a motion; a program was measured as text
/// (exportProgram), so the file must hold that text.
workcell::FileCheck readBackCheck(const Trajectory& motion, const QString& format, const ProgramFile& file) {
  const bool is_ros = format == "ros";
  if (is_ros || format == "csv" || format == "json") {
    return [&motion, &file, is_ros](const std::filesystem::path& written) -> Expected<void> {
      const auto promises = trajectory_checks::copyPromises(motion, !is_ros, is_ros ? 1e-9 : 0.0, written);
      HAPTICELL_TRY(promises);
      if (!promises->areKept()) return makeError(promises->missed(file.name));
      return {};
    };
  }
  return [&file](const std::filesystem::path& written) -> Expected<void> {
    const auto content = workcell::readFileContent(written);
    HAPTICELL_TRY(content);
    if (*content == file.content) return {};
    return makeError({.file = file.name,
                      .found = "the file differs from what was written",
                      .expected = "the program as written",
                      .fix = "Save it to another disk."});
  };
}

/// Of a table; empty of a program.
QString tableExtension(const QString& format) {
  if (format == "csv") return ".csv";
  if (format == "json") return ".htraj";
  return format == "ros" ? ".yaml" : "";
}

/// Readers know tables by their extensions: under another name a copy with the right one is read first.
Expected<void> writeChecked(const Trajectory& motion, const QString& format, const ProgramFile& file) {
  const workcell::FileCheck check = readBackCheck(motion, format, file);
  const QString extension = tableExtension(format);
  const QString name = QString::fromStdString(file.name);
  const bool is_known = extension.isEmpty() || name.endsWith(extension, Qt::CaseInsensitive) ||
                        (format == "json" && name.endsWith(".json", Qt::CaseInsensitive)) ||
                        (format == "ros" && name.endsWith(".yml", Qt::CaseInsensitive));
  if (is_known) return workcell::writeFileChecked(file.name, file.content, check);
  const auto folder = ScratchFolder::make();
  HAPTICELL_TRY(folder);
  const std::filesystem::path trial = folder->path() / ("motion" + extension.toStdString());
  if (auto kept = workcell::writeFileChecked(trial, file.content, check); !kept) return kept;
  return workcell::writeFileAtomically(file.name, file.content);
}

using Entities = std::vector<std::shared_ptr<const workcell::Entity>>;

/// The only robot of the cell that has all these joints; empty: none, or several.
std::string robotWithJoints(const Entities& entities, const std::vector<std::string>& joints) {
  std::string found;
  for (const auto& entity : entities) {
    if (!entity->robot() || joints.empty()) continue;
    const auto has = [&](const std::string& joint) { return entity->robot()->findJoint(joint) >= 0; };
    if (!std::all_of(joints.begin(), joints.end(), has)) continue;
    if (!found.empty()) return {};
    found = entity->name;
  }
  return found;
}

/// With an entity and with poses, as the cell needs it.
Expected<void> fitToCell(Trajectory& motion, const Entities& entities, const std::string& entity, const std::string& file) {
  if (motion.entity.empty()) motion.entity = entity;
  if (motion.entity.empty()) motion.entity = robotWithJoints(entities, motion.joint_names);
  if (motion.has_poses) return {};
  const auto moved =
      std::find_if(entities.begin(), entities.end(), [&](const auto& one) { return one->name == motion.entity; });
  if (moved == entities.end() || !(*moved)->robot()) {
    return makeError({.file = file,
                      .found = "joint values without poses",
                      .expected = "the robot of these joints",
                      .fix = "Choose the robot in the cell, then import the motion again."});
  }
  auto posed = manipulation::posesFromJoints(**moved, motion);
  HAPTICELL_TRY(posed);
  motion = std::move(*posed);
  return {};
}

/// The motions of a file, those of a recording all. A stylus is no entity of the cell and gets none.
Expected<std::vector<Trajectory>> motionsOf(const std::string& file, const Entities& entities, const std::string& entity,
                                            std::vector<Text>& notes) {
  std::vector<Trajectory> motions;
  if (exchange::isMcapFile(file)) {
    auto read = exchange::readMcapMotions(file, notes);
    HAPTICELL_TRY(read);
    if (read->is_stylus) return std::move(read->motions);
    motions = std::move(read->motions);
  } else {
    auto read = trajectory::readTrajectory(file, &notes);
    HAPTICELL_TRY(read);
    motions.push_back(std::move(*read));
  }
  for (Trajectory& motion : motions) HAPTICELL_TRY(fitToCell(motion, entities, entity, file));
  return motions;
}

}  // namespace

const std::vector<MotionFormat>& motionFormats() {
  static const std::vector<MotionFormat> kFormats{
      {"krl", QObject::tr("KUKA KRL (.src, .dat)"), ".src", true},
      {"rapid", QObject::tr("ABB RAPID (.mod)"), ".mod", true},
      {"fanuc", QObject::tr("FANUC (.ls)"), ".ls", true},
      {"urscript", QObject::tr("Universal Robots script (.script)"), ".script", true},
      {"val3", QObject::tr("Stäubli VAL3 (folder)"), "", true},
      {"inform", QObject::tr("Yaskawa Motoman INFORM (.jbi)"), ".jbi", true},
      {"ros", QObject::tr("ROS 2 JointTrajectory (.yaml)"), ".yaml", false},
      {"csv", QObject::tr("Table (.csv)"), ".csv", false},
      {"json", QObject::tr("HaptiCell trajectory (.htraj)"), ".htraj", false}};
  return kFormats;
}

MotionExport::MotionExport(Host& host, MotionList& list, QObject* parent) : QObject(parent), host_(host), list_(list) {}

MotionExport::Moves MotionExport::askMoves(std::size_t moves, const trajectory::PathTolerance& tolerance) {
  QMessageBox question(QMessageBox::Question, tr("Export motion"), tr("The program would have %1 moves.").arg(moves),
                       QMessageBox::NoButton, &host_.window());
  question.setObjectName("askSimplify");
  question.setInformativeText(
      tr("Controllers load such a long program slowly or not at all, and run short moves unevenly. Simplify keeps only "
         "the moves needed within %1 and %2. The motion itself is unchanged.")
          .arg(lengthText(tolerance.position), angleText(tolerance.angle)));
  QPushButton* simplify = question.addButton(tr("Simplify first"), QMessageBox::AcceptRole);
  QPushButton* all = question.addButton(tr("Write all moves"), QMessageBox::DestructiveRole);
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(simplify);
  question.exec();
  if (question.clickedButton() == simplify) return Moves::kNeeded;
  return question.clickedButton() == all ? Moves::kAll : Moves::kNone;
}

void MotionExport::askExport(const QString& word, const trajectory::ProgramOptions& options,
                             const trajectory::PathTolerance& tolerance) {
  const auto format =
      std::find_if(motionFormats().begin(), motionFormats().end(), [&](const auto& f) { return f.word == word; });
  if (format == motionFormats().end() || !list_.current()) return;
  const std::size_t moves = list_.current()->trajectory ? list_.current()->trajectory->size() : 0;
  std::optional<trajectory::PathTolerance> simplify;
  if (format->is_program && moves > kManyMoves) {
    const Moves wanted = askMoves(moves, tolerance);
    if (wanted == Moves::kNone) return;
    if (wanted == Moves::kNeeded) simplify = tolerance;
  }
  const QString name = QString::fromStdString(list_.current()->name).replace(' ', '-').remove(',');
  const QString path = askToSave(&host_.window(), tr("Export motion"), name + format->extension, format->name);
  if (!path.isEmpty()) exportTo(path, word, options, simplify);
}

void MotionExport::exportTo(const QString& path, const QString& format, const trajectory::ProgramOptions& given,
                            const std::optional<trajectory::PathTolerance>& simplify) {
  const Motion* motion = list_.current();
  if (!motion || !motion->trajectory) return;
  trajectory::ProgramOptions options = given;
  if (options.name.empty()) options.name = QFileInfo(path).completeBaseName().toStdString();
  if (motion->entity)
    if (auto chain = manipulation::sixAxisChain(*motion->entity))
      options.configuration = manipulation::programConfiguration(
          std::make_shared<const kinematics::Chain>(std::move(*chain)), programFormat(format));
  list_.work().start(
      tr("Exporting %1").arg(QFileInfo(path).fileName()),
      [this, trajectory = motion->trajectory, format, path, options,
       simplify](workcell::ImportMonitor&) -> Expected<BackgroundWork::Then> {
        // A program's moves are lines of the tool, so what joints do between them is the controller's.
        trajectory::PathTolerance lines = simplify.value_or(trajectory::PathTolerance{});
        lines.joint = std::numeric_limits<double>::infinity();
        const Trajectory written = simplify ? trajectory::simplified(*trajectory, lines) : *trajectory;
        std::vector<Text> notes;
        auto files = filesOf(written, format, path, options, notes);
        HAPTICELL_TRY(files);
        QStringList names;
        for (const ProgramFile& file : *files) {
          const QFileInfo place(QString::fromStdString(file.name));
          QDir().mkpath(place.path());
          HAPTICELL_TRY(writeChecked(written, format, file));
          names << place.fileName();
        }
        return BackgroundWork::Then([this, names, path, notes, frames = written.size()] {
          for (const Text& note : notes)
            host_.messages().reportCause(Severity::kInformation, tr("Exported program"), note);
          const QString line =
              tr("Saved: %1; frames: %2. Tool, base and safety settings are those of the controller. Check them there")
                  .arg(names.join(QStringLiteral(", ")))
                  .arg(frames);
          host_.messages().tell(Severity::kInformation, line, QFileInfo(path).absolutePath());
          emit told(line, false);
          emit finished(path, true);
        });
      },
      [this, path](const Error& error) {
        host_.messages().reportCause(Severity::kWarning, tr("The motion was not exported"), error);
        emit told(shownText(error), true);
        emit finished(path, false);
      });
}

void MotionExport::askImport() {
  const QStringList paths =
      askToOpenSeveral(&host_.window(), tr("Import motions"), {},
                       tr("Trajectories (*.htraj *.json *.csv *.yaml *.yml);;Recordings (*.mcap);;Robot programs: KRL, RAPID, FANUC, "
                          "URScript, INFORM (*.src *.mod *.modx *.prg *.ls *.script *.urscript *.jbi)"));
  if (paths.isEmpty()) return;
  const auto* entity = host_.documentModel().document().find(host_.selection().current());
  importFrom(paths, entity ? entity->name : std::string());
}

void MotionExport::importFrom(const QStringList& paths, const std::string& entity) {
  list_.work().start(
      tr("Reading motions"),
      [this, paths, entity, entities = host_.documentModel().document().state().entities,
       number = host_.documentModel().number()](workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
        auto motions = std::make_shared<std::vector<std::pair<std::string, Trajectory>>>();
        auto remarks = std::make_shared<QStringList>();
        for (const QString& path : paths) {
          std::vector<Text> notes;
          auto read = motionsOf(path.toStdString(), entities, entity, notes);
          HAPTICELL_TRY(read);
          for (Trajectory& motion : *read) {
            const std::string name = motion.name.empty() ? QFileInfo(path).completeBaseName().toStdString() : motion.name;
            motions->emplace_back(name, std::move(motion));
          }
          for (const Text& note : notes) *remarks << QFileInfo(path).fileName() + ": " + shownText(note);
          const auto place = static_cast<double>(paths.indexOf(path) + 1);
          monitor.report(path.toStdString(), place / static_cast<double>(paths.size()));
        }
        return BackgroundWork::Then([this, motions, remarks, paths, number] {
          if (number != host_.documentModel().number()) return;
          for (const QString& note : *remarks)
            host_.messages().tell(Severity::kInformation, tr("Imported motion"), note);
          const auto count = static_cast<int>(motions->size());
          const bool done = list_.add(tr("Import motions"), std::move(*motions));
          if (done) emit told(tr("Motions imported: %1").arg(count), false);
          emit finished(paths.front(), done);
        });
      },
      [this, paths](const Error& error) {
        host_.messages().reportCause(Severity::kWarning, tr("The motion was not imported"), error);
        emit told(shownText(error), true);
        emit finished(paths.front(), false);
      });
}

}  // namespace hapticell::app
