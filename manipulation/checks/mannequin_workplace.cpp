// SPDX-License-Identifier: Apache-2.0
#include "manipulation/checks/mannequin_workplace.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>
#include <tuple>

#include "collision/queries/proximity_query.h"
#include "manipulation/scene/prepared_scene.h"
#include "mannequin/ergonomics/advice/body_sizes.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::manipulation {
namespace {

using mannequin::Posture;
using workcell::Entity;
using workcell::EntityId;

/// Placements of one search, each with up to four bodies: it bounds the time. Half: some grids must be coarser; twice:
/// up to twice as long without an answer.
constexpr std::size_t kMostCells = 10000;
constexpr EntityId kBodyId = EntityId{1} << 60;  ///< Ids of the bodies that are tried: beyond any document's.

Error refusal(Text place, Text found, Text expected) {
  return {.place = std::move(place), .found = std::move(found), .expected = std::move(expected)};
}

std::vector<double> gridOf(double from, double to, double step) {
  std::vector<double> values;
  for (int i = 0; from + i * step <= to + 1e-9 && i < static_cast<int>(kMostCells); ++i)
    values.push_back(from + i * step);
  return values;
}

/// A hand, its fingers and what they hold touch the work on purpose.
bool isHand(const kinematics::RobotModel& model, int link) {
  const int body = mannequin::bodyOfLink(model, link);
  if (body < 0 || body >= static_cast<int>(mannequin::kSegmentCount)) return true;
  return body == static_cast<int>(mannequin::indexOf(mannequin::Segment::kLeftHand)) ||
         body == static_cast<int>(mannequin::indexOf(mannequin::Segment::kRightHand));
}

struct Stand {
  const ScenePart* part = nullptr;
  Pose X_WP;
  bool is_station = false;
  std::string name;
};

class Search {
 public:
  Search(const WorkplaceQuestion& question, const Entity& shown) : question_(question), shown_(shown) {
    const std::vector<EntityId> moved = movedWith(question);
    posture_ = mannequin::toPosture(*shown.figure(), {shown.X_WE, shown.joints()});
    const dvec3 ahead = posture_.X_WR.rotate({1.0, 0.0, 0.0});
    ahead_ = glm::normalize(dvec3(ahead.x, ahead.y, 0.0));
    bodies_ = mannequin::boundaryFigures();
    std::vector<Entity> entities;
    for (const Entity& entity : question.entities) {
      if (entity.id != shown.id && entity.attachment.to != shown.name && entity.visible && entity.checked)
        entities.push_back(entity);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Entity body;
      body.id = kBodyId + i;
      body.name = bodies_[i].name;
      body.body = workcell::Mannequin{{.model = mannequin::figureModel(bodies_[i].figure)},
                                      std::make_shared<const mannequin::Figure>(bodies_[i].figure)};
      body.setJoints(std::vector<double>(body.robot()->dof(), 0.0));
      entities.push_back(std::move(body));
    }
    scene_ = PreparedScene::prepare(std::move(entities), {}, {});
    for (const ScenePart& part : scene_->parts()) {
      if (part.entity >= kBodyId) continue;
      const Entity& owner = *scene_->find(part.entity);
      const bool station = std::find(moved.begin(), moved.end(), owner.id) != moved.end();
      stands_.push_back(
          {&part, PreparedScene::partPose(owner, owner.X_WE, owner.joints(), part.link), station, owner.name});
    }
  }

  void evaluate(WorkplaceCell& cell) const {
    const dvec3 shift = cell.away * ahead_ + dvec3(0.0, 0.0, cell.rise);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      cell.rula[i] = scoreBody(i, cell, shift);
      if (cell.rula[i] == 0) {
        cell.worst = 0;
        cell.postures.clear();
        return;  // One that cannot is enough.
      }
      cell.worst = std::max(cell.worst, cell.rula[i]);
    }
  }

 private:
  Posture startOf(const mannequin::Figure& figure, bool seated) const {
    if (!seated) return ergonomics::standingAt(*shown_.figure(), posture_, figure);
    Posture start = *mannequin::libraryPosture(figure, "seated");
    const double heading = std::atan2(ahead_.y, ahead_.x);
    start.X_WR.q = glm::normalize(quaternionFromRotationVector({0.0, 0.0, heading}) * start.X_WR.q);
    start.X_WR.p.x = posture_.X_WR.p.x;
    start.X_WR.p.y = posture_.X_WR.p.y;
    return start;
  }

  int scoreBody(std::size_t i, WorkplaceCell& cell, const dvec3& shift) const {
    const mannequin::Figure& figure = bodies_[i].figure;
    mannequin::PostureTask task = ergonomics::taskAt(*shown_.figure(), posture_, figure, shift);
    if (cell.is_seated) {
      task.pelvis_locked = true;
      task.balance = false;
    }
    const auto found = mannequin::PostureSolver(figure).solve(task, startOf(figure, cell.is_seated));
    char text[120];
    if (found.status != mannequin::PostureStatus::kSolved) {
      std::snprintf(text, sizeof text, "%s is %.0f mm short", bodies_[i].name.c_str(),
                    1000.0 * std::max(found.hand_position_error[0], found.hand_position_error[1]));
      cell.why = text;
      return 0;
    }
    const std::string touched = touches(i, found.posture, shift);
    if (!touched.empty()) {
      cell.why = bodies_[i].name + " would touch " + touched;
      return 0;
    }
    const auto pose = mannequin::forwardKinematics(figure, found.posture);
    cell.postures.push_back(found.posture);
    return ergonomics::scorePosture(figure, found.posture, pose, question_.task).rula();
  }

  std::string touches(std::size_t i, const Posture& posture, const dvec3& shift) const {
    const Entity& body = *scene_->find(kBodyId + i);
    const auto stands = mannequin::toModel(bodies_[i].figure, posture);
    for (const ScenePart& part : scene_->parts()) {
      if (part.entity != body.id || isHand(*body.robot(), part.link)) continue;
      const Pose X_WP = PreparedScene::partPose(body, stands.X_WE, stands.joints, part.link);
      for (const Stand& stand : stands_) {
        Pose X_WS = stand.X_WP;
        if (stand.is_station) X_WS.p += shift;
        if (collision::distance(part.mesh.collider, X_WP, stand.part->mesh.collider, X_WS, 1e-3).colliding)
          return stand.name;
      }
    }
    return {};
  }

  const WorkplaceQuestion& question_;
  const Entity& shown_;
  Posture posture_;
  dvec3 ahead_{1.0, 0.0, 0.0};
  std::vector<mannequin::NamedFigure> bodies_;
  std::shared_ptr<const PreparedScene> scene_;
  std::vector<Stand> stands_;
};

int bestOf(const std::vector<WorkplaceCell>& cells) {
  int best = -1;
  const auto key = [](const WorkplaceCell& cell) {
    int sum = 0;
    for (const int rula : cell.rula) sum += rula;
    return std::tuple(cell.worst, sum, std::abs(cell.rise) + std::abs(cell.away));
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].worst == 0) continue;
    if (best < 0 || key(cells[i]) < key(cells[static_cast<std::size_t>(best)])) best = static_cast<int>(i);
  }
  return best;
}

/// All cells, shared out among the machine's threads; false when it was cancelled.
bool evaluateAll(const Search& search, std::vector<WorkplaceCell>& cells, const std::function<void(double)>& progress,
                 const std::atomic<bool>& cancel) {
  std::atomic<std::size_t> next{0}, done{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < cells.size() && !cancel; i = next++) {
      search.evaluate(cells[i]);
      if (progress) progress(static_cast<double>(++done) / static_cast<double>(cells.size()));
    }
  };
  std::vector<std::thread> threads;
  const unsigned count = std::max(1u, std::thread::hardware_concurrency());
  for (unsigned i = 1; i < count; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return !cancel;
}

}  // namespace

std::vector<EntityId> movedWith(const WorkplaceQuestion& question) {
  const auto& all = question.entities;
  std::vector<bool> moves(all.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i)
    moves[i] = std::find(question.station.begin(), question.station.end(), all[i].id) != question.station.end();
  const auto carried = [&](const Entity& entity) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (moves[i] && all[i].name == entity.attachment.to) return true;
    return false;
  };
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (moves[i] || all[i].attachment.to.empty() || all[i].id == question.mannequin || !carried(all[i])) continue;
      moves[i] = found = true;
    }
  }
  std::vector<EntityId> ids;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (moves[i]) ids.push_back(all[i].id);
  return ids;
}

Expected<WorkplaceMap> searchWorkplace(const WorkplaceQuestion& question, const std::function<void(double)>& progress,
                                       const std::atomic<bool>& cancel) {
  const auto find = [&](EntityId id) {
    return std::find_if(question.entities.begin(), question.entities.end(),
                        [id](const Entity& e) { return e.id == id; });
  };
  const auto shown = find(question.mannequin);
  if (shown == question.entities.end() || !shown->figure())
    return makeError(
        refusal(Text("mannequin"), Text("the mannequin does not exist"), Text("one that exists in the cell")));
  if (question.station.empty())
    return makeError(
        refusal(Text("station"), Text("no parts to move"), Text("at least one part, such as a table or a fixture")));
  for (const EntityId id : question.station) {
    if (find(id) == question.entities.end() || id == question.mannequin)
      return makeError(refusal(Text("station"), Text("the part does not exist"),
                               Text("parts of the cell, not the mannequin itself")));
  }
  const bool good_steps = question.rise_step > 0.0 && question.away_step > 0.0;
  WorkplaceMap map;
  if (good_steps) {
    map.rises = gridOf(question.rise_from, question.rise_to, question.rise_step);
    map.aways = gridOf(question.away_from, question.away_to, question.away_step);
  }
  const std::size_t stances = (question.may_stand ? 1u : 0u) + (question.may_sit ? 1u : 0u);
  const std::size_t count = map.rises.size() * map.aways.size() * stances;
  if (count == 0 || count > kMostCells)
    return makeError(refusal(Text("grid"), Text("%1 placements", count), Text("1 to 10000 placements")));
  for (const bool seated : {false, true}) {
    if (!(seated ? question.may_sit : question.may_stand)) continue;
    for (const double rise : map.rises) {
      for (const double away : map.aways) map.cells.push_back({rise, away, seated, 0, {}, {}, {}});
    }
  }
  const Search search(question, *shown);
  map.is_complete = evaluateAll(search, map.cells, progress, cancel);
  map.best = bestOf(map.cells);
  return map;
}

}  // namespace hapticell::manipulation
