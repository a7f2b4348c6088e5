// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/body/clearances.h"
#include "agents/wishes/agent.h"

namespace hapticell::agents {

/// What an agent wanted in the last step, for an arrow and a bar.
struct ShownWish {
  std::string name;
  double weight = 1.0;
  bool enabled = true;
  dvec3 p_W{0.0};      ///< Where the arrow begins, m.
  dvec3 arrow_W{0.0};  ///< m/s, times the weight.
  double strength =
      0.0;  ///< Of the fastest variable's greatest speed, times the weight; above 1: more than is possible.
};

/// Sums the wishes of agents and moves the entity by them, step by step. One thread.
///
/// The sum is bent along what is near (velocity dampers, Faverjon and Tournassoud 1987), cut to the greatest speeds,
/// and made only as far as the exact distances prove that no pair comes into contact; after the step every pair keeps
/// the clearance, or the distance that it had where that was less.
class AgentLoop {
 public:
  /// s of a step. Half: twice the work; twice: longer steps are cut more often near obstacles.
  static constexpr double kStep = 0.02;

  /// `clearance`: m that are kept to the cell; a millimetre at most between the entity's own parts.
  AgentLoop(std::unique_ptr<MovedBody> body, Clearances clearances, std::vector<WeightedAgent> agents, AgentGoal goal,
            double clearance, workcell::EntityId looked_at);

  /// One step. False: nothing could move.
  bool step();
  /// From now on steps go back along the way that it came, until the moved frame is `far` (m) from where it is now, or the
  /// way is at its end; agents wish nothing meanwhile, and a way that was followed is given up.
  void drawBack(double far);
  bool isDrawingBack() const { return back_.has_value(); }

  const MovedBody& body() const { return *body_; }
  double t() const { return t_; }
  const AgentGoal& goal() const { return goal_; }
  void setGoal(const AgentGoal& goal) { goal_ = goal; }
  /// From now on the goal agent follows this way; at its end it goes straight to the goal again. An empty one ends it.
  void setWay(FollowedWay way) { way_ = std::move(way); }
  /// The way that is followed; null: none.
  const FollowedWay* way() const { return way_.isDone() ? nullptr : &way_; }
  std::vector<WeightedAgent>& agents() { return agents_; }
  /// One an agent, of the last step.
  const std::vector<ShownWish>& wishes() const { return wishes_; }
  /// Pairs near at the present configuration, nearest first.
  std::span<const NearPair> near() const { return clearances_.near(); }
  const Clearances& clearances() const { return clearances_; }
  /// m to the nearest obstacle, at most kLook.
  double nearestObstacle() const;
  /// m to the goal, a radian counting 0.25 m where the goal has an orientation.
  double remaining() const;
  bool hasArrived() const;
  /// Asks the enabled agents in their order to resolve a deadlock; returns the name of the first that does, or empty.
  std::string handOverDeadlock();

 private:
  /// Where drawing back began, and how far it goes, m.
  struct Back {
    dvec3 p_WM{0.0};
    double far = 0.0;
  };
  bool stepBack();
  std::vector<double> sumOfWishes();
  void bendAlong(std::vector<double>& v) const;
  void cutToSpeeds(std::vector<double>& v) const;
  bool makeStep(std::vector<double> v);
  double clearanceOf(const NearPair& pair) const;
  AgentView view() const { return {*body_, clearances_.near(), goal_, lines_, t_, kStep, way()}; }

  std::unique_ptr<MovedBody> body_;
  Clearances clearances_;
  LineOfSight lines_;
  std::vector<WeightedAgent> agents_;
  AgentGoal goal_;
  FollowedWay way_;
  std::deque<std::unique_ptr<MovedBody>> came_;  ///< Where it was, oldest first.
  std::optional<Back> back_;
  double clearance_;
  double t_ = 0.0;
  std::vector<ShownWish> wishes_;
};

}  // namespace hapticell::agents
