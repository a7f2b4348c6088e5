// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "agents/task/agent_task.h"
#include "config/configuration.h"
#include "geometry/system/error.h"
#include "manipulation/scene/prepared_scene.h"

namespace hapticell::agents {

/// Who moves the entity in a run.
enum class RunMode {
  kOperator,  ///< The operator alone; what is near still bends and stops the motion.
  kAgents,    ///< All agents but the operator.
  kBoth,      ///< All.
};
/// "operator", "agents", "both".
const char* toString(RunMode mode);

class Clearances;
class MovedBody;

/// A task with its cell ready to run. Immutable; any thread.
class AgentCell {
 public:
  /// Errors name the file: the task's, the cell's, what an agent lacks.
  static Expected<std::shared_ptr<const AgentCell>> load(const std::filesystem::path& task,
                                                         const config::Configuration& configuration);
  /// The same over a cell that is prepared already; `task.cell` is not read.
  static Expected<std::shared_ptr<const AgentCell>> create(AgentTask task,
                                                           std::shared_ptr<const manipulation::PreparedScene> scene,
                                                           const config::Configuration& configuration);
  ~AgentCell();

  const AgentTask& task() const { return task_; }
  const std::shared_ptr<const manipulation::PreparedScene>& scene() const { return scene_; }
  const workcell::Entity& entity() const { return *entity_; }
  /// The entity of the goal's look_at; 0: none.
  workcell::EntityId lookAt() const { return look_at_; }
  const MovedBody& start() const { return *start_; }
  const Clearances& clearances() const { return *clearances_; }
  /// What was noticed while loading, in sentences.
  const std::vector<Text>& notes() const { return notes_; }

 private:
  AgentCell();
  Expected<void> prepare(const config::Configuration& configuration);
  Expected<void> tryAgents() const;

  AgentTask task_;
  std::shared_ptr<const manipulation::PreparedScene> scene_;
  const workcell::Entity* entity_ = nullptr;
  workcell::EntityId look_at_ = 0;
  std::unique_ptr<const MovedBody> start_;
  std::unique_ptr<const Clearances> clearances_;
  std::vector<Text> notes_;
};

}  // namespace hapticell::agents
