// SPDX-License-Identifier: Apache-2.0
#include "agents/runner/agent_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/runner/planned_way.h"
#include "agents/task/agent_section.h"
#include "agents/wishes/seeded_numbers.h"
#include "manipulation/checks/mannequin_sight.h"
#include "mannequin/ergonomics/scores/posture_scores.h"
#include "mannequin/posture/support_polygon.h"

namespace hapticell::agents {

namespace {

/// Steps between two looks at posture and sight: a fifth of a second. Half: twice the work; twice: a bad posture may be
/// missed.
constexpr int kStepsPerLook = 10;
/// Starts that are tried until one is free. Half: tight cells begin at the cell's own start more often; twice: slower.
constexpr int kStartTries = 50;
/// s that an operator may take to draw back and choose another way before the next deadlock counts.
constexpr double kOperatorTime = 2.0;
/// s in which agents get going along a way before the next deadlock counts.
constexpr double kWayTime = 0.5;
/// Deadlocks of a run that the operator takes before the planner is asked. Half: a person is hardly asked; twice: tries
/// for long what does not help.
constexpr int kOperatorTries = 2;

std::uint64_t seedOf(const RunOptions& options, std::uint64_t number, std::uint64_t use) {
  SeededNumbers mixed(options.seed * 0x9E3779B97F4A7C15u + number * 8u + use);
  return mixed.next();
}

AgentGoal goalOf(const AgentCell& cell, std::uint64_t seed) {
  AgentGoal goal = cell.task().goal;
  SeededNumbers random(seed);
  for (int k = 0; k < 3; ++k) goal.p_WG[k] += random.within(cell.task().spread.goal_offset);
  return goal;
}

/// A start near that of the cell which keeps the clearance; the cell's own where none is found.
std::unique_ptr<MovedBody> startOf(const AgentCell& cell, std::uint64_t seed) {
  const RunSpread& spread = cell.task().spread;
  const MovedBody& own = cell.start();
  Clearances clearances = cell.clearances().fresh();
  SeededNumbers random(seed);
  for (int i = 0; i < kStartTries && (spread.start_angle > 0.0 || spread.start_offset > 0.0); ++i) {
    std::vector<double> step(own.size(), 0.0);
    for (std::size_t v = 0; v < step.size(); ++v) {
      const bool stays = own.figure() != nullptr && v < 6;
      const double most = own.screws()[v].slides ? spread.start_offset : spread.start_angle;
      step[v] = stays || own.speed(v) <= 0.0 ? 0.0 : random.within(most);
    }
    auto there = own.moved(step);
    if (there && clearances.look(there->configuration(), cell.task().clearance).empty()) return there;
  }
  return own.placed(own.configuration());
}

std::vector<WeightedAgent> agentsOf(const AgentCell& cell, RunMode mode, const RunOptions& options,
                                    std::uint64_t seed) {
  std::vector<WeightedAgent> agents;
  for (const AgentSection& section : cell.task().agents) {
    const AgentMaking making{section, cell.task(), cell.start(), cell.lookAt(), cell.clearances().obstacles(), seed};
    auto agent = makeAgent(making);
    if (!agent) continue;  // AgentCell has made each of them once.
    const bool is_operator = agent->name == "operator";
    if (const auto given = options.weights.find(agent->name); given != options.weights.end()) {
      agent->weight = given->second;
      agent->enabled = given->second > 0.0;
    }
    if (mode != RunMode::kBoth && is_operator != (mode == RunMode::kOperator)) agent->enabled = false;
    agents.push_back(std::move(*agent));
  }
  return agents;
}

AgentLoop loopOf(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options) {
  return AgentLoop(startOf(cell, seedOf(options, number, 1)), cell.clearances().fresh(),
                   agentsOf(cell, mode, options, seedOf(options, number, 3)),
                   goalOf(cell, seedOf(options, number, 2)), cell.task().clearance, cell.lookAt());
}

}  // namespace

AgentRun::AgentRun(const AgentCell& cell, std::uint64_t number, RunMode mode, const RunOptions& options)
    : cell_(cell),
      mode_(mode),
      seed_(seedOf(options, number, 4)),
      planner_(options.planner && mode != RunMode::kOperator),
      loop_(loopOf(cell, number, mode, options)) {
  result_.number = number;
  result_.mode = mode;
  result_.clearance_m = loop_.nearestObstacle();
  result_.balance_m = 1.0;
  look();
}

bool AgentRun::step() {
  if (over_) return false;
  const dvec3 before = loop_.body().handle().p;
  loop_.step();
  ++steps_;
  result_.way_m += glm::length(loop_.body().handle().p - before);
  result_.clearance_m = std::min(result_.clearance_m, loop_.nearestObstacle());
  for (const ShownWish& wish : loop_.wishes()) result_.strengths[wish.name] += wish.strength;
  if (steps_ % kStepsPerLook == 0) look();
  judge();
  return !over_;
}

double AgentRun::remaining() const {
  if (loop_.way() != nullptr) return loop_.way()->remaining(loop_.body());
  if (!loop_.hasArrived()) return loop_.remaining();
  return loop_.goal().tolerance * (2.0 - result_.seen);  // Only sight is missing.
}

void AgentRun::judge() {
  if (loop_.hasArrived() && (cell_.lookAt() == 0 || steps_ % kStepsPerLook == 0)) {
    over_ = result_.solved = cell_.lookAt() == 0 || result_.seen >= loop_.goal().seen;
    if (over_) return;
  }
  if (loop_.t() >= cell_.task().time_limit) {
    over_ = true;
    result_.reason = Text("not there after %1 s, %2 from the goal",
                          static_cast<int>(std::lround(cell_.task().time_limit)), Text::Length{loop_.remaining()});
    return;
  }
  if (loop_.isDrawingBack()) return;
  if (std::exchange(drew_back_, false)) return askPlanner();
  if (on_way_ != (loop_.way() != nullptr)) {
    on_way_ = loop_.way() != nullptr;
    watch_.restart(loop_.t(), remaining(), kWayTime);
  }
  if (watch_.update(loop_.t(), loop_.body().handle().p, remaining())) onDeadlock();
}

void AgentRun::onDeadlock() {
  ++result_.deadlocks;
  left_ = {loop_.remaining()};
  nearest_ = Text("nothing is near");
  for (const NearPair& pair : loop_.near()) {
    // What is near of the cell; its own parts only where nothing of the cell is.
    if (pair.other_link >= 0 && !nearest_.arguments().empty()) continue;
    nearest_ = Text("nearest: %1, %2", loop_.clearances().wordsOf(pair), Text::Length{pair.distance});
    if (pair.other_link < 0) break;
  }
  if ((!planner_ || result_.deadlocks <= kOperatorTries) && giveToAgent()) return;
  if (!planner_) return giveUp({});
  if (plans_asked_ >= kMostPlans) return giveUp(Text("it was asked %1 times", plans_asked_));
  const double back = backBeforePlan(loop_.body(), plans_asked_);
  drew_back_ = back > 0.0;
  if (!drew_back_) return askPlanner();
  loop_.drawBack(back);
}

bool AgentRun::giveToAgent() {
  const std::string taken_by = loop_.handOverDeadlock();
  if (taken_by.empty()) return false;
  result_.handed_over.push_back(Text("no progress, %1 from the goal (%2); handed to the %3", left_, nearest_, taken_by));
  watch_.restart(loop_.t(), remaining(), kOperatorTime);
  return true;
}

void AgentRun::askPlanner() {
  Text why;
  if (!followPlan(why)) return giveUp(why);
  result_.handed_over.push_back(
      Text("no progress, %1 from the goal (%2); handed to the planner, whose way is followed", left_, nearest_));
}

/// An agent may still take it; else the run ends. `why` the planner finds no way; empty: it is not asked.
void AgentRun::giveUp(const Text& why) {
  if (giveToAgent()) return;
  over_ = true;
  result_.reason =
      why.empty() ? Text("no progress, %1 from the goal (%2); lead it by hand from here, or plan a path", left_, nearest_)
                  : Text("no progress, %1 from the goal (%2), and the planner finds no way: %3; lead it by hand from here",
                         left_, nearest_, why);
  result_.handed_over.push_back(result_.reason);
}

bool AgentRun::followPlan(Text& why) {
  PlannedWay planned =
      planWay(cell_, loop_.body(), loop_.goal(), seed_ + static_cast<std::uint64_t>(plans_asked_++));
  if (!planned.way) {
    why = std::move(planned.why);
    return false;
  }
  ++result_.plans;
  loop_.setWay(std::move(*planned.way));
  on_way_ = loop_.way() != nullptr;
  watch_.restart(loop_.t(), remaining(), kWayTime);
  return true;
}

void AgentRun::look() {
  const FigureView* figure = loop_.body().figure();
  if (figure == nullptr) return;
  const auto scores = ergonomics::scorePosture(figure->figure, figure->posture, figure->pose, {});
  result_.rula = scores.rula();
  result_.reba = scores.reba();
  result_.rula_worst = std::max(result_.rula_worst, scores.rula());
  result_.comfort = scores.comfort;
  const std::array<mannequin::SegmentPlace, 2> feet{figure->pose[mannequin::Segment::kLeftFoot],
                                                    figure->pose[mannequin::Segment::kRightFoot]};
  const dvec3 p_WCom = mannequin::centerOfMass(figure->figure, figure->pose);
  const auto support = mannequin::supportPolygon(figure->figure, feet);
  result_.balance_m = std::min(result_.balance_m, support.margin(glm::dvec2(p_WCom)));
  if (cell_.lookAt() == 0) return;
  const auto sight = manipulation::sightOfTarget(*cell_.scene(), cell_.entity(), figure->posture, cell_.lookAt());
  result_.seen = sight.zone == mannequin::VisionZone::kOutside ? 0.0 : sight.seen;
}

RunResult AgentRun::finish() {
  look();
  RunResult result = result_;
  if (loop_.body().figure() == nullptr) result.balance_m = 0.0;
  result.time_s = loop_.t();
  result.remaining_m = loop_.remaining();
  for (auto& [name, strength] : result.strengths) strength /= std::max(1, steps_);
  return result;
}

}  // namespace hapticell::agents
