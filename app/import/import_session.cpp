// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_session.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "workcell/import/entity_source.h"
#include "workcell/robots/robot_reader.h"
#include "workcell/scenes/scene_exchange.h"

namespace hapticell::app {
namespace {

// ms between two looks at the importer: a bar moves smoothly at 20 Hz. Half: twice the wake-ups; twice: small files
// appear 0.1 s later.
constexpr int kPollMilliseconds = 50;

/// A xacro may have arguments; other robots have nothing to choose.
bool mayHaveArguments(const std::string& what) {
  return !workcell::isBuiltIn(what) && workcell::robotFormatOf(what) == workcell::RobotFormat::kXacro;
}

bool hasChoices(const QString& path) {
  const std::string what = path.toStdString();
  return !workcell::isBuiltIn(what) && (!workcell::looksLikeRobot(what) || mayHaveArguments(what));
}

/// What is known of a xacro that could not be read: its arguments, of which one has no value.
std::optional<ImportFacts> factsWithoutRobot(const QString& path, const ImportChoices& choices) {
  if (!mayHaveArguments(path.toStdString())) return std::nullopt;
  ImportFacts facts;
  facts.arguments = workcell::robotArguments(path.toStdString(), choices.arguments);
  const auto open = [](const xacro::DeclaredArgument& one) { return !one.otherwise && one.value.empty(); };
  if (std::none_of(facts.arguments.begin(), facts.arguments.end(), open)) return std::nullopt;
  facts.format = formatText("xacro", path);
  facts.bytes = QFileInfo(path).size();
  facts.unit_is_stated = facts.robot = facts.incomplete = true;
  return facts;
}

}  // namespace

ImportSession::ImportSession(QObject* parent) : QObject(parent) {
  painters_.setMaxThreadCount(1);
  painters_.setThreadPriority(QThread::LowPriority);
  poll_.setInterval(kPollMilliseconds);
  connect(&poll_, &QTimer::timeout, this, &ImportSession::poll);
  importer_ = std::make_unique<workcell::Importer>([this](workcell::ImportId job) {
    QMetaObject::invokeMethod(
        this, [this, job] { takeEnded(job); }, Qt::QueuedConnection);
  });
}

ImportSession::~ImportSession() {
  importer_.reset();
  painters_.clear();
  painters_.waitForDone();
}

FileImport* ImportSession::get(int id) {
  const auto found = std::find_if(files_.begin(), files_.end(), [id](const FileImport& f) { return f.id == id; });
  return found == files_.end() ? nullptr : &*found;
}

const FileImport* ImportSession::find(int id) const {
  return const_cast<ImportSession*>(this)->get(id);
}

ImportSession::Work* ImportSession::workOf(int id) {
  const auto found = std::find_if(works_.begin(), works_.end(), [id](const Work& w) { return w.file == id; });
  return found == works_.end() ? nullptr : &*found;
}

bool ImportSession::isBusy() const {
  return std::any_of(files_.begin(), files_.end(),
                     [](const FileImport& file) { return file.stage != FileImport::Stage::kReady; });
}

std::vector<int> ImportSession::add(const QStringList& paths, bool ask) {
  std::vector<int> ids;
  for (const QString& path : paths) {
    FileImport file;
    file.id = ++last_id_;
    file.path = path;
    file.asks = ask && hasChoices(path);
    if (!file.asks) file.stage = FileImport::Stage::kImporting;
    files_.push_back(file);
    works_.push_back({file.id, 0, {}, {}});
    start(files_.back());
    ids.push_back(file.id);
  }
  emit changed();
  return ids;
}

void ImportSession::start(FileImport& file) {
  Work& work = *workOf(file.id);
  workcell::ImportRequest request;
  request.what = file.path.toStdString();
  if (!workcell::isBuiltIn(request.what)) request.what = QFileInfo(file.path).absoluteFilePath().toStdString();
  if (hasChoices(file.path)) {
    request.options = optionsOf(file.choices);
    request.options.warn_about_unit = file.stage == FileImport::Stage::kImporting;  // Who is asked sees the size.
  }
  file.examined_with = file.choices;
  file.progress = {};
  work.job = importer_->start(std::move(request));
  work.clock.start();
  poll_.start();
}

void ImportSession::poll() {
  bool any = false, moved = false;
  for (FileImport& file : files_) {
    Work& work = *workOf(file.id);
    if (work.job == 0) continue;
    any = true;
    const workcell::ImportStatus status = importer_->status(work.job);
    const bool queued = status.state == workcell::ImportStatus::State::kQueued;
    if (queued) work.clock.restart();  // It has not begun.
    file.elapsed = static_cast<double>(work.clock.elapsed()) * 1e-3;
    moved = moved || queued != file.queued || status.progress.share != file.progress.share ||
            status.progress.stage != file.progress.stage;
    file.queued = queued;
    file.progress = status.progress;
  }
  if (!any) poll_.stop();
  if (moved) emit progressed();
}

void ImportSession::takeEnded(workcell::ImportId job) {
  auto taken = importer_->take(job);
  const auto work = std::find_if(works_.begin(), works_.end(), [job](const Work& w) { return w.job == job; });
  if (!taken || work == works_.end()) return;  // It was given up.
  work->job = 0;
  FileImport& file = *get(work->file);
  file.seconds = static_cast<double>(work->clock.elapsed()) * 1e-3;
  auto result = std::make_shared<Expected<workcell::ImportResult>>(std::move(*taken));
  // Wanted before it was read, it may yet turn out that nobody knows its unit.
  const bool unit_unknown = *result && file.asks && !file.facts && !(*result)->report.unit_is_stated;
  if (*result && (file.stage == FileImport::Stage::kExamining || unit_unknown))
    return examined(file.id, std::move(result));
  if (!*result && file.asks && mayHaveArguments(file.path.toStdString()))
    return examineArguments(file.id, std::move(result));
  finish(file.id, std::move(result));
}

void ImportSession::finish(int id, Result result) {
  const QString path = find(id)->path;
  remove(id);
  emit finished(path, result);
}

void ImportSession::examineArguments(int id, Result result) {
  const FileImport& file = *find(id);
  painters_.start([this, id, path = file.path, choices = file.choices, result = std::move(result)] {
    auto facts = factsWithoutRobot(path, choices);
    QMetaObject::invokeMethod(
        this,
        [this, id, facts = std::move(facts), result]() mutable {
          FileImport* asked = get(id);
          if (!asked) return;
          if (!facts) return finish(id, result);
          asked->facts = std::move(facts);
          asked->stage = FileImport::Stage::kReady;
          emit changed();
        },
        Qt::QueuedConnection);
  });
}

void ImportSession::examined(int id, Result result) {
  workOf(id)->result = std::move(result);
  paint(id);
}

void ImportSession::paint(int id) {
  const FileImport& file = *find(id);
  // A copy: what is painted may be handed over and changed meanwhile. Meshes are shared.
  auto shown = std::make_shared<workcell::ImportResult>(**workOf(id)->result);
  const workcell::UpAxis read = file.examined_with.up_axis.value_or(shown->report.up_axis);
  const Pose X =
      workcell::turnedUp(file.choices.up_axis.value_or(shown->report.up_axis)) * workcell::turnedUp(read).inverse();
  for (workcell::Entity& entity : shown->entities) entity.X_WE = X * entity.X_WE;
  painters_.start([this, id, path = file.path, shown, size = picture_size_] {
    ImportFacts facts = factsOf(*shown, path, size);
    QMetaObject::invokeMethod(
        this, [this, id, facts = std::move(facts)]() mutable { showFacts(id, std::move(facts)); },
        Qt::QueuedConnection);
  });
}

void ImportSession::showFacts(int id, ImportFacts facts) {
  FileImport* file = get(id);
  if (!file) return;
  const bool first = !file->facts;
  const double likely = facts.likely_metres_per_unit;
  const bool other_unit = first && !facts.unit_is_stated && likely != facts.metres_per_unit;
  file->facts = std::move(facts);
  // A xacro without arguments has nothing to choose.
  const bool plain = first && file->asks && file->facts->robot && file->facts->arguments.empty();
  const bool wanted = plain || (first && file->stage == FileImport::Stage::kImporting);
  if (file->stage == FileImport::Stage::kExamining || wanted) file->stage = FileImport::Stage::kReady;
  if (first && file->facts->unit_is_open && !file->choices.metres_per_unit) {
    file->choices.metres_per_unit = said_unit_;
    file->unit_is_open = !said_unit_;
  }
  if (other_unit && !file->choices.metres_per_unit && !file->unit_is_open) file->choices.metres_per_unit = likely;
  if (wanted && !file->unit_is_open) return import(id);
  emit changed();
}

void ImportSession::choose(int id, const ImportChoices& choices) {
  FileImport* file = get(id);
  if (!file || file->stage == FileImport::Stage::kImporting || file->choices == choices) return;
  const bool turned = file->choices.up_axis != choices.up_axis;
  file->choices = choices;
  if (file->unit_is_open && choices.metres_per_unit) {
    said_unit_ = choices.metres_per_unit;
    for (FileImport& other : files_) {
      if (!std::exchange(other.unit_is_open, false) || other.id == id) continue;
      other.choices.metres_per_unit = said_unit_;
    }
  }
  if (turned && workOf(id)->result) paint(id);
  emit changed();
}

void ImportSession::import(int id) {
  FileImport* file = get(id);
  if (!file || file->stage == FileImport::Stage::kImporting || file->unit_is_open) return;
  Work& work = *workOf(id);
  const bool fits = file->choices == file->examined_with;
  file->stage = FileImport::Stage::kImporting;
  if (work.result && fits) {
    finish(id, work.result);
    return;
  }
  if (!fits || work.job == 0) {
    if (work.job != 0) importer_->cancel(work.job);
    work.result.reset();
    start(*file);
  }
  emit changed();
}

void ImportSession::cancel(int id) {
  if (!find(id)) return;
  if (const workcell::ImportId job = workOf(id)->job; job != 0) {
    importer_->cancel(job);
    importer_->take(job);
  }
  remove(id);
}

void ImportSession::cancelAll() {
  while (!files_.empty()) cancel(files_.back().id);
}

void ImportSession::remove(int id) {
  std::erase_if(works_, [id](const Work& work) { return work.file == id; });
  std::erase_if(files_, [id](const FileImport& file) { return file.id == id; });
  if (files_.empty()) said_unit_.reset();
  emit changed();
}

ImportEstimate ImportSession::estimateOf(const FileImport& file) {
  if (!file.facts) return {};
  const ImportEstimate known{file.facts->chord, static_cast<double>(file.facts->triangles), file.seconds};
  if (!file.facts->can_be_cut_finer) return known;
  ImportEstimate wanted = estimate(known, file.examined_with.quality, file.choices.quality);
  wanted.chord *= file.choices.metres_per_unit.value_or(file.facts->metres_per_unit) / file.facts->metres_per_unit;
  return wanted;
}

}  // namespace hapticell::app
