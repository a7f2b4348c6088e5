// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/pose.h"
#include "geometry/system/error.h"

namespace hapticell::agents {

struct AgentSection;

/// Where the moved frame is to arrive.
struct AgentGoal {
  dvec3 p_WG{0.0};                ///< m
  std::optional<dquat> q_WG;      ///< Empty: any orientation.
  double tolerance = 0.01;        ///< m
  double angle_tolerance = 0.0872664625997165;  ///< rad, where an orientation is wanted.
  std::string look_at;            ///< Entity that the eyes must see at the end; empty: none.
  double seen = 0.5;              ///< Least visible share of it, 0 to 1.
};

/// What differs from run to run, drawn evenly from the seed.
struct RunSpread {
  double start_angle = 0.0;  ///< rad, of each joint, either way.
  double start_offset = 0.0;  ///< m, of a solid, along each axis either way.
  double goal_offset = 0.0;  ///< m, along each axis either way.
};

/// A task for agents as its file says it (TOML, docs/user/agents.md): cell, entity, goal, and the agents with their
/// weights. A value; copies share the tables of the file.
class AgentTask {
 public:
  /// Errors name the file, the line and the key.
  static Expected<AgentTask> read(const std::filesystem::path& file);
  static Expected<AgentTask> parse(const std::string& text, const std::filesystem::path& file);

  std::filesystem::path file;
  std::string name, note;
  std::filesystem::path cell;    ///< Absolute.
  std::string entity;
  std::string moved_by;          ///< "tcp", "right_hand", "left_hand", "self_origin"; empty: as usual for the entity.
  AgentGoal goal;
  RunSpread spread;
  double clearance = 0.003;      ///< m that are kept to everything.
  double time_limit = 60.0;      ///< s of a run.
  std::vector<AgentSection> agents;

  AgentTask();
  AgentTask(const AgentTask&);
  AgentTask(AgentTask&&) noexcept;
  AgentTask& operator=(const AgentTask&);
  AgentTask& operator=(AgentTask&&) noexcept;
  ~AgentTask();

 private:
  friend class AgentTaskReader;
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace hapticell::agents
