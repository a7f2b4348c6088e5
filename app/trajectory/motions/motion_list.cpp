// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/motion_list.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/style/library_text.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/recordings.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {

using trajectory::Trajectory;

namespace {

/// The name with a '-' for each run of characters that some file systems refuse.
QString fileStem(const QString& name) {
  QString stem;
  for (const QChar c : name) {
    const bool plain = c.isLetterOrNumber() || QStringLiteral("_.-").contains(c);
    if (plain || !stem.endsWith(QLatin1Char('-'))) stem += plain ? c : QChar('-');
  }
  return stem;
}

}  // namespace

MotionList::MotionList(Host& host, QObject* parent) : QObject(parent), host_(host) {
  connect(&host_.documentModel(), &DocumentModel::changed, this, &MotionList::takeDocument);
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    work_.cancel();
    motions_.clear();
    current_.clear();
    read_.clear();
    unreadable_.clear();
    emit changed();
    emit currentChanged();
  });
  connect(&host_.documentModel(), &DocumentModel::recordingsMoved, this, [this](const auto& places) {
    for (const auto& [from, to] : places) {
      for (Motion& motion : motions_)
        if (motion.path == from) motion.path = to;
      if (const auto known = read_.find(from); known != read_.end()) read_[to] = known->second;
    }
  });
  takeDocument();
}

const Motion* MotionList::find(const std::string& name) const {
  const auto found = std::find_if(motions_.begin(), motions_.end(), [&](const Motion& m) { return m.name == name; });
  return found == motions_.end() ? nullptr : &*found;
}

void MotionList::setCurrent(const std::string& name) {
  if (name == current_) return;
  current_ = name;
  emit currentChanged();
}

void MotionList::setPlayed(const std::string& name, bool played) {
  for (Motion& motion : motions_) {
    if (motion.name != name || motion.played == played) continue;
    // An entity can only be in one place: its other motions rest.
    for (Motion& other : motions_)
      if (played && other.trajectory && motion.trajectory && other.trajectory->entity == motion.trajectory->entity)
        other.played = false;
    motion.played = played;
    emit changed();
  }
}

void MotionList::setCheck(const std::string& name, std::optional<manipulation::PathCheckResult> check) {
  const auto motion = std::find_if(motions_.begin(), motions_.end(), [&](const Motion& m) { return m.name == name; });
  if (motion != motions_.end()) motion->check = std::move(check);
  emit changed();
  if (name == current_) emit currentChanged();
}

QString MotionList::folder() const {
  const auto& path = host_.documentModel().document().path();
  if (!path.empty()) {
    return QString::fromStdString(workcell::recordingsFolder(path).string());
  }
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
      .filePath(QStringLiteral("trajectories"));
}

std::string MotionList::uniqueName(const std::string& wanted) const {
  const auto& state = host_.documentModel().document().state();
  if (!state.findTrajectory(wanted)) return wanted;
  for (int number = 2;; ++number) {
    const std::string name = wanted + " " + std::to_string(number);
    if (!state.findTrajectory(name)) return name;
  }
}

/// The motion in a file that does not exist yet.
workcell::TrajectoryReference MotionList::fileFor(Trajectory motion) {
  const QDir folder(this->folder());
  const QString stem = fileStem(QString::fromStdString(motion.name));
  QString file = folder.filePath(stem + QStringLiteral(".htraj"));
  const auto isTaken = [&](const QString& name) {
    return QFileInfo::exists(name) || read_.contains(name.toStdString());
  };
  for (int k = 2; isTaken(file); ++k) file = folder.filePath(QStringLiteral("%1-%2.htraj").arg(stem).arg(k));
  workcell::TrajectoryReference reference{motion.name, file.toStdString(), {}};
  reference.motion = std::make_shared<const Trajectory>(std::move(motion));
  read_[reference.path] = reference.motion;
  return reference;
}

bool MotionList::add(const QString& step, std::vector<std::pair<std::string, Trajectory>> motions) {
  std::vector<workcell::Command> commands;
  std::vector<workcell::TrajectoryReference> added;
  for (auto& [wanted, trajectory] : motions) {
    trajectory.name = uniqueName(wanted);
    for (int k = 2;
         std::any_of(added.begin(), added.end(), [&t = trajectory](const auto& a) { return a.name == t.name; }); ++k)
      trajectory.name = uniqueName(wanted + " " + std::to_string(k));
    workcell::TrajectoryReference reference = fileFor(std::move(trajectory));
    commands.push_back(workcell::AddTrajectory{reference});
    added.push_back(std::move(reference));
  }
  if (added.empty() || !host_.documentModel().executeAll(step, commands)) return false;
  for (const auto& reference : added) write(reference.path, reference.motion);
  for (Motion& motion : motions_)
    motion.played = std::any_of(added.begin(), added.end(), [&](const auto& a) { return a.name == motion.name; });
  current_ = added.back().name;
  emit changed();
  emit currentChanged();
  return true;
}

bool MotionList::replace(const QString& step, std::string name, Trajectory motion, bool same_way) {
  const Motion* known = find(name);
  if (!known) return false;
  const bool played = known->played;
  auto check = same_way ? known->check : std::nullopt;
  motion.name = name;
  const workcell::TrajectoryReference reference = fileFor(std::move(motion));
  if (!host_.documentModel().executeAll(step, {workcell::SetTrajectory{name, reference}})) return false;
  write(reference.path, reference.motion);
  for (Motion& now : motions_) {
    if (now.name != name) continue;
    now.played = played;
    now.check = std::move(check);
  }
  emit changed();
  emit currentChanged();
  return true;
}

void MotionList::write(const std::string& path, std::shared_ptr<const Trajectory> trajectory) {
  work_.start(
      tr("Writing %1").arg(QString::fromStdString(trajectory->name)),
      [path, trajectory](workcell::ImportMonitor&) -> Expected<BackgroundWork::Then> {
        QDir().mkpath(QFileInfo(QString::fromStdString(path)).path());
        auto written = workcell::writeFileAtomically(path, trajectory::toJsonText(*trajectory));
        HAPTICELL_TRY(written);
        return BackgroundWork::Then([] {});
      },
      [this](const Error& error) {
        host_.messages().tell(
            Severity::kWarning, tr("A trajectory is not saved"),
            shownText(error) + ' ' + tr("It stays in the cell until you quit. Export it to keep it."));
      });
}

bool MotionList::rename(const std::string& name, const QString& new_name) {
  const std::string wanted = new_name.trimmed().toStdString();
  if (wanted == name) return true;
  for (Motion& motion : motions_)
    if (motion.name == name) motion.name = wanted;  // Keeps what is known of it.
  const bool was_current = current_ == name;
  if (was_current) current_ = wanted;
  if (host_.documentModel().execute(workcell::RenameTrajectory{name, wanted})) return true;
  for (Motion& motion : motions_)
    if (motion.name == wanted) motion.name = name;
  if (was_current) current_ = name;
  return false;
}

bool MotionList::remove(const std::string& name) {
  return host_.documentModel().execute(workcell::RemoveTrajectory{name});
}

std::shared_ptr<const workcell::Entity> MotionList::entityOf(const Trajectory& trajectory) const {
  for (const auto& entity : host_.documentModel().document().state().entities)
    if (entity->name == trajectory.entity) return entity;
  return nullptr;
}

void MotionList::makeReplay(Motion& motion) {
  const auto entity = entityOf(*motion.trajectory);
  if (entity == motion.entity && (motion.replay || !motion.problem.isEmpty())) return;
  motion.entity = entity;
  motion.replay = nullptr;
  motion.problem.clear();
  auto replay = manipulation::MotionReplay::create(host_.documentModel().document().state().entities,
                                                   motion.trajectory->entity, motion.trajectory);
  if (replay) {
    motion.replay = std::make_shared<const manipulation::MotionReplay>(std::move(*replay));
  } else {
    motion.problem = shownText(replay.error());
  }
}

void MotionList::takeDocument() {
  std::vector<Motion> fresh;
  for (const workcell::TrajectoryReference& reference : host_.documentModel().document().state().trajectories) {
    Motion motion;
    if (const Motion* known = find(reference.name)) motion = *known;
    if (motion.path != reference.path) motion = {};
    motion.name = reference.name;
    motion.path = reference.path;
    if (reference.motion) read_[reference.path] = reference.motion;
    const auto content = read_.find(reference.path);
    if (content == read_.end()) {
      read(reference.path);
    } else if (content->second) {
      motion.trajectory = content->second;
      makeReplay(motion);
    }
    if (const auto why = unreadable_.find(reference.path); why != unreadable_.end()) motion.problem = why->second;
    fresh.push_back(std::move(motion));
  }
  motions_ = std::move(fresh);
  if (!find(current_)) {
    current_ = motions_.empty() ? std::string() : motions_.back().name;
    // What a cell was left with last can be played at once.
    if (!motions_.empty()) motions_.back().played = true;
    emit changed();
    emit currentChanged();
    return;
  }
  emit changed();
}

void MotionList::read(const std::string& path) {
  read_[path] = nullptr;
  work_.start(
      tr("Reading %1").arg(QFileInfo(QString::fromStdString(path)).fileName()),
      [this, path](workcell::ImportMonitor&) -> Expected<BackgroundWork::Then> {
        auto trajectory = trajectory::readTrajectory(path);
        HAPTICELL_TRY(trajectory);
        auto shared = std::make_shared<const Trajectory>(std::move(*trajectory));
        return BackgroundWork::Then([this, path, shared] {
          read_[path] = shared;
          takeDocument();
          emit currentChanged();
        });
      },
      [this, path](const Error& error) {
        unreadable_[path] = shownText(error);
        host_.messages().tell(Severity::kWarning, tr("A trajectory of the cell cannot be read"), unreadable_[path]);
        takeDocument();
      });
}

}  // namespace hapticell::app
