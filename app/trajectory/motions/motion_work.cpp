// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/motion_work.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/style/library_text.h"
#include "app/style/units.h"
#include "app/trajectory/motions/track_rows.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/editing/smoothing.h"

namespace hapticell::app {
namespace {

using trajectory::PoseDistance;
using trajectory::Trajectory;

constexpr double kDegrees = 57.29577951308232;
// s, where nobody gives an acceleration; as kTimeToSpeed of cli/trajectory/trajectory_robot.cpp.
constexpr double kTimeToSpeed = 0.25;

QString distanceText(const PoseDistance& distance) {
  return lengthText(distance.position, 2) + QStringLiteral(", %1°").arg(kDegrees * distance.angle, 0, 'f', 2);
}

std::function<bool(double)> progressOf(workcell::ImportMonitor& monitor, const Text& stage) {
  return [&monitor, stage](double share) {
    monitor.report(stage, share);
    return !monitor.isCancelled();
  };
}

Expected<manipulation::PathCheckOptions> optionsFor(const Trajectory& trajectory,
                                                    const std::vector<std::shared_ptr<const Trajectory>>& take,
                                                    workcell::ImportMonitor& monitor) {
  manipulation::PathCheckOptions options;
  options.axes = take;
  if (!trajectory.moved.empty()) {
    auto moved_by = manipulation::parseMovedBy(trajectory.moved);
    HAPTICELL_TRY(moved_by);
    options.hold.moved_by = std::move(*moved_by);
  }
  options.progress = progressOf(monitor, Text("checking"));
  return options;
}

QString retimingLine(const trajectory::RetimingReport& report, trajectory::TimingMode mode) {
  QString line = MotionWork::tr("%1 s → %2 s; at most %3 from the path")
                     .arg(report.duration_before, 0, 'f', 2)
                     .arg(report.duration_after, 0, 'f', 2)
                     .arg(distanceText(report.max_deviation));
  if (mode == trajectory::TimingMode::kTimeOptimal)
    line += MotionWork::tr("; of the limits: speed %1 %, acceleration %2 %")
                .arg(100.0 * report.use.velocity, 0, 'f', 0)
                .arg(100.0 * report.use.acceleration, 0, 'f', 0);
  return line;
}

}  // namespace

trajectory::MotionLimits limitsOf(const workcell::Entity& entity, const Trajectory& trajectory) {
  trajectory::MotionLimits limits;
  if (!trajectory.hasJoints()) {
    limits.velocity = {0.5, 0.5, 0.5, 2.0, 2.0, 2.0};
  } else {
    const auto columns = manipulation::jointColumns(entity, trajectory);
    for (std::size_t j = 0; j < trajectory.joint_names.size(); ++j) {
      double speed = 0.0;
      if (columns && entity.robot()) {
        const int joint = entity.robot()->moving[(*columns)[j]];
        speed = entity.robot()->joints[static_cast<std::size_t>(joint)].velocity;
      }
      limits.velocity.push_back(speed > 0.0 ? speed : std::numbers::pi);
    }
  }
  for (const double speed : limits.velocity) limits.acceleration.push_back(speed / kTimeToSpeed);
  return limits;
}

MotionWork::MotionWork(Host& host, MotionList& list, QObject* parent) : QObject(parent), host_(host), list_(list) {}

void MotionWork::tell(const QString& line, bool careful) {
  line_ = line;
  emit told(line, careful);
}

std::shared_ptr<const MotionWork::Cell> MotionWork::cell() const {
  const workcell::Document& document = host_.documentModel().document();
  auto cell = std::make_shared<Cell>();
  cell->entities = document.state().entities;
  cell->configuration = host_.configuration();
  cell->source = manipulation::sourceOf(document, manipulation::pairDefaults(cell->configuration));
  cell->scenes = host_.scenes();
  const Motion* current = list_.current();
  for (const Motion& motion : list_.motions()) {
    const bool together = current && current->trajectory && motion.trajectory && motion.name != current->name &&
                          !motion.trajectory->take.empty() && motion.trajectory->take == current->trajectory->take;
    if (together) cell->take.push_back(motion.trajectory);
  }
  return cell;
}

void MotionWork::run(const QString& word, Work work, bool in_place) {
  const Motion* motion = list_.current();
  if (!motion || !motion->trajectory) return tell(tr("Choose a motion first."), true);
  const std::string name = motion->name;
  const QString step = tr("%1: %2").arg(word, QString::fromStdString(name));
  list_.work().start(
      step,
      [this, given = motion->trajectory, cell = cell(), name, word, step, in_place,
       number = host_.documentModel().number(),
       work = std::move(work)](workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
        auto result = work(given, *cell, monitor);
        HAPTICELL_TRY(result);
        auto done = std::make_shared<Result>(std::move(*result));
        return BackgroundWork::Then([this, done, given, name, word, step, number, in_place] {
          if (number != host_.documentModel().number()) return;
          if (in_place && done->motions.size() == 1) {
            const Motion* now = list_.find(name);
            if (!now || now->trajectory != given)
              return tell(tr("%1 was changed in the meantime, so nothing was done").arg(QString::fromStdString(name)),
                          true);
            if (!list_.replace(step, name, std::move(done->motions.front()), false)) return;
          } else if (!done->motions.empty()) {
            std::vector<std::pair<std::string, Trajectory>> named;
            const QString marked = done->missed ? tr("%1, target missed").arg(word) : word;
            for (Trajectory& made : done->motions)
              named.emplace_back(name + ", " + marked.toStdString(), std::move(made));
            if (!list_.add(step, std::move(named))) return;
            if (done->check && list_.current()) list_.setCheck(list_.current()->name, done->check);
          } else if (done->check) {
            list_.setCheck(name, done->check);
          }
          tell(done->line, done->careful);
          if (done->missed) emit missed();
        });
      },
      [this, number = host_.documentModel().number()](const Error& error) {
        if (number == host_.documentModel().number()) tell(shownText(error), true);
      });
}

void MotionWork::measure(Result& result, const MeasureMotion& measure) {
  const auto missed = missedPromise(result.motions.back(), measure);
  if (!missed) return;
  result.missed = result.careful = true;
  result.line = tr("Missed: %1 is %2, requested %3 (%4). %5")
                    .arg(QString::fromStdString(missed->name))
                    .arg(missed->measured, 0, 'g', 4)
                    .arg(missed->asked, 0, 'g', 4)
                    .arg(missed->unit.empty() ? tr("share of the limit") : QString::fromStdString(missed->unit))
                    .arg(result.line);
}

void MotionWork::takeKept(manipulation::KeptFree kept, Result& result) {
  for (const auto& nearer : kept.nearer)
    result.line += tr(". Closer to the recording from %1 to %2 s, to avoid collisions")
                       .arg(nearer.t_in, 0, 'f', 2)
                       .arg(nearer.t_out, 0, 'f', 2);
  result.check = std::move(kept.check);
  result.motions.push_back(std::move(kept.trajectory));
}

void MotionWork::simplify(const trajectory::PathTolerance& tolerance) {
  run(tr("simplified"), [tolerance](const auto& given, const Cell&, auto&) -> Expected<Result> {
    Result result;
    result.motions.push_back(trajectory::simplified(*given, tolerance));
    const Trajectory& few = result.motions.front();
    const trajectory::Deviation deviation = trajectory::largestDeviation(*given, few);
    result.careful = deviation.shareOf(tolerance) > 1.001;
    result.line = tr("%1 of %2 frames; at most %3 from the recording")
                      .arg(few.size())
                      .arg(given->size())
                      .arg(distanceText(deviation.pose));
    measure(result, [&](const auto& file) { return trajectory_checks::simplifyPromises(*given, tolerance, file); });
    return result;
  });
}

void MotionWork::smooth(const trajectory::PathTolerance& tolerance, bool keep_free) {
  run(tr("smoothed"),
      [tolerance, keep_free](const auto& given, const Cell& cell,
                             workcell::ImportMonitor& monitor) -> Expected<Result> {
        const auto entity = std::find_if(cell.entities.begin(), cell.entities.end(),
                                         [&](const auto& e) { return e->name == given->entity; });
        // The joints of a robot that is moved by its tool are found for the smoothed poses.
        trajectory::PathTolerance asked = tolerance;
        const bool by_tool = entity != cell.entities.end() && workcell::isMachine(**entity) &&
                             (given->moved.empty() || given->moved == "tcp");
        if (by_tool) asked.joint = std::numeric_limits<double>::infinity();
        auto smooth = trajectory::smoothed(*given, {asked});
        const auto& report = smooth.report;
        Result result;
        result.line = tr("At most %1 from the recording; jerk %2 → %3 m/s³")
                          .arg(distanceText(report.max_deviation))
                          .arg(report.rms_jerk_before, 0, 'f', 1)
                          .arg(report.rms_jerk_after, 0, 'f', 1);
        if (report.tremor_exceeds_tolerance) {
          result.careful = true;
          result.line += tr(". Hand tremor (%1) is larger than the tolerance, so much of it remains")
                             .arg(lengthText(report.tremor.position, 2));
        }
        if (entity != cell.entities.end()) {
          auto consistent = manipulation::jointsFromPoses(**entity, smooth.trajectory);
          HAPTICELL_TRY(consistent);
          smooth.trajectory = std::move(*consistent);
        }
        if (keep_free && entity != cell.entities.end() && !(*entity)->locked) {
          auto options = optionsFor(*given, cell.take, monitor);
          HAPTICELL_TRY(options);
          auto kept = manipulation::keptFree(cell.scenes->prepare(cell.source), *given, smooth.trajectory, *options,
                                             cell.configuration);
          HAPTICELL_TRY(kept);
          if (monitor.isCancelled()) return makeError({.found = "cancelled"});
          takeKept(std::move(*kept), result);
        } else {
          result.motions.push_back(std::move(smooth.trajectory));
        }
        trajectory_checks::PosesByJoints placed;
        if (entity != cell.entities.end())
          placed = [&](const Trajectory& motion) { return manipulation::posesFromJoints(**entity, motion); };
        measure(result,
                [&](const auto& file) { return trajectory_checks::smoothPromises(*given, asked, file, placed); });
        return result;
      });
}

void MotionWork::retime(trajectory::RetimingOptions options, bool keep_free) {
  run(tr("retimed"),
      [options, keep_free](const auto& given, const Cell& cell,
                           workcell::ImportMonitor& monitor) mutable -> Expected<Result> {
        const auto entity = std::find_if(cell.entities.begin(), cell.entities.end(),
                                         [&](const auto& e) { return e->name == given->entity; });
        if (options.limits.velocity.empty()) {
          const auto jerk = options.limits.jerk;
          options.limits = limitsOf(entity == cell.entities.end() ? workcell::Entity{} : **entity, *given);
          if (!jerk.empty())
            for (const double a : options.limits.acceleration) options.limits.jerk.push_back(a / jerk.front());
        }
        trajectory_checks::PosesByJoints placed;
        if (entity != cell.entities.end())
          placed = [&](const Trajectory& motion) { return manipulation::posesFromJoints(**entity, motion); };
        const bool by_tool = manipulation::posesFollowJoints(*given, placed);
        Result result;
        if (keep_free && entity != cell.entities.end() && !(*entity)->locked) {
          auto check = optionsFor(*given, cell.take, monitor);
          HAPTICELL_TRY(check);
          auto free =
              manipulation::retimedFree(cell.scenes->prepare(cell.source), *given, options, *check, cell.configuration);
          HAPTICELL_TRY(free);
          if (monitor.isCancelled()) return makeError({.found = "cancelled"});
          result.line = retimingLine(free->report, options.mode);
          const bool passes = free->kept.nearer.empty();
          takeKept(std::move(free->kept), result);
          measure(result, [&](const auto& file) {
            return trajectory_checks::retimePromises(*given, options, {passes, by_tool}, file);
          });
          return result;
        }
        auto timed = manipulation::retimedByJoints(*given, options, placed);
        HAPTICELL_TRY(timed);
        result.line = retimingLine(timed->report, options.mode);
        result.motions.push_back(std::move(timed->trajectory));
        measure(result, [&](const auto& file) {
          return trajectory_checks::retimePromises(*given, options, {true, by_tool}, file);
        });
        return result;
      });
}

void MotionWork::check() {
  run(tr("checked"), [](const auto& given, const Cell& cell, workcell::ImportMonitor& monitor) -> Expected<Result> {
    auto options = optionsFor(*given, cell.take, monitor);
    HAPTICELL_TRY(options);
    auto check =
        manipulation::checkPath(cell.scenes->prepare(cell.source), given->entity, *given, *options, cell.configuration);
    HAPTICELL_TRY(check);
    Result result;
    result.line = checkLine(*check);
    result.careful = !check->findings.empty();
    result.check = std::move(*check);
    return result;
  });
}

void MotionWork::edit(const QString& word, Edit edit) {
  run(word, workOf(tr("Saved as a copy: %1. The recording is unchanged").arg(word), std::move(edit)));
}

void MotionWork::editPoints(const QString& word, Edit edit) {
  const Motion* motion = list_.current();
  if (!motion || !motion->trajectory || !motion->trajectory->isTaught()) return this->edit(word, std::move(edit));
  const QString line = tr("Done: %1").arg(word);
  // At once where no joints have to be found: the next edit counts the points as they are then.
  auto made = edit(*motion->trajectory);
  if (!made) return tell(shownText(made.error()), true);
  if (made->size() != 1 || made->front().hasJoints() != motion->trajectory->hasJoints())
    return run(word, workOf(line, std::move(edit)), true);
  const QString step = tr("%1: %2").arg(word, QString::fromStdString(motion->name));
  if (list_.replace(step, motion->name, std::move(made->front()), false)) tell(line, false);
}

MotionWork::Work MotionWork::workOf(const QString& line, Edit edit) {
  return [edit = std::move(edit), line](const std::shared_ptr<const Trajectory>& given, const Cell& cell,
                                        workcell::ImportMonitor&) -> Expected<Result> {
    auto made = edit(*given);
    HAPTICELL_TRY(made);
    Result result;
    result.motions = std::move(*made);
    result.line = line;
    // An edit of poses needs a robot's joints again, from where it stood.
    for (Trajectory& motion : result.motions) {
      if (!given->hasJoints() || motion.hasJoints() || motion.empty()) continue;
      std::vector<double> start;
      if (const auto entity = std::find_if(cell.entities.begin(), cell.entities.end(),
                                           [&](const auto& e) { return e->name == given->entity; });
          entity != cell.entities.end()) {
        const auto columns = manipulation::jointColumns(**entity, *given);
        start = (*entity)->joints();
        for (std::size_t j = 0; columns && j < columns->size(); ++j) start[(*columns)[j]] = given->joints(0)[j];
      }
      auto replay = manipulation::MotionReplay::create(cell.entities, given->entity,
                                                       std::make_shared<const Trajectory>(motion), start);
      HAPTICELL_TRY(replay);
      motion = replay->withJoints();
      const PoseDistance off = replay->offPose();
      if (off.position > 1e-4 || off.angle > 1e-3) {
        result.careful = true;
        result.line += tr(". The robot cannot reach all of it: up to %1 away").arg(distanceText(off));
      }
    }
    return result;
  };
}

void MotionWork::join(const std::vector<std::string>& names) {
  std::vector<Trajectory> parts;
  for (const std::string& name : names)
    if (const Motion* motion = list_.find(name); motion && motion->trajectory) parts.push_back(*motion->trajectory);
  edit(tr("joined"), [parts](const Trajectory&) -> Expected<std::vector<Trajectory>> {
    auto all = trajectory::joined(parts);
    HAPTICELL_TRY(all);
    return std::vector<Trajectory>{std::move(*all)};
  });
}

}  // namespace hapticell::app
