// SPDX-License-Identifier: Apache-2.0
#include "agents/task/agent_task.h"

#include <set>
#include <utility>

#include "agents/task/section_reader.h"
#include "geometry/system/nesting_limit.h"
#include "geometry/system/regular_file.h"

namespace hapticell::agents {

namespace fs = std::filesystem;

struct AgentTask::Tree {
  toml::table root;
};

AgentTask::AgentTask() = default;
AgentTask::AgentTask(const AgentTask&) = default;
AgentTask::AgentTask(AgentTask&&) noexcept = default;
AgentTask& AgentTask::operator=(const AgentTask&) = default;
AgentTask& AgentTask::operator=(AgentTask&&) noexcept = default;
AgentTask::~AgentTask() = default;

namespace {

/// Bytes; a task is written by hand. Half: still thousands of lines; twice: more to read in vain.
constexpr std::uintmax_t kLargestTask = 200'000;

}  // namespace

/// Fills a task from its tables.
class AgentTaskReader {
 public:
  explicit AgentTaskReader(AgentTask& task) : task_(task) {}

  Expected<void> read(const toml::table& root) {
    SectionReader reader(root, "", task_.file);
    workcell::TomlFields& fields = reader.fields();
    std::string cell;
    fields.read("name", task_.name);
    fields.read("note", task_.note);
    for (const char* key : {"cell", "entity", "goal"}) fields.require(key);
    fields.read("cell", cell);
    fields.read("entity", task_.entity);
    fields.read("moved_by", task_.moved_by);
    fields.read("clearance", task_.clearance, 1.0, 1e-4, 0.5);
    fields.read("time", task_.time_limit, 1.0, 0.1, 3600.0);
    const toml::table* goal = fields.table("goal");
    const toml::table* spread = fields.table("spread");
    const toml::array* agents = fields.tables("agent");
    HAPTICELL_TRY(reader.end());
    if (task_.name.empty()) task_.name = task_.file.stem().string();
    task_.cell = (task_.file.parent_path() / cell).lexically_normal();
    HAPTICELL_TRY(readGoal(*goal));
    if (spread != nullptr) HAPTICELL_TRY(readSpread(*spread));
    return readAgents(agents);
  }

 private:
  Expected<void> readGoal(const toml::table& table) {
    SectionReader reader(table, "goal", task_.file);
    workcell::TomlFields& fields = reader.fields();
    AgentGoal& goal = task_.goal;
    Pose X_WG;
    fields.require("position");
    const bool turned = fields.has("quaternion") || fields.has("rpy");
    if (turned) {
      fields.readPose(X_WG, 1.0);
      goal.q_WG = X_WG.q;
    } else {
      fields.readPoint("position", X_WG.p, 1.0);
    }
    goal.p_WG = X_WG.p;
    fields.read("tolerance", goal.tolerance, 1.0, 1e-4, 1.0);
    fields.read("angle_tolerance", goal.angle_tolerance, kDegree, 0.01, 180.0);
    fields.read("look_at", goal.look_at);
    fields.read("seen", goal.seen, 1.0, 0.0, 1.0);
    return reader.end();
  }

  Expected<void> readSpread(const toml::table& table) {
    SectionReader reader(table, "spread", task_.file);
    reader.fields().read("start_angle", task_.spread.start_angle, kDegree, 0.0, 45.0);
    reader.fields().read("start_offset", task_.spread.start_offset, 1.0, 0.0, 1.0);
    reader.fields().read("goal_offset", task_.spread.goal_offset, 1.0, 0.0, 1.0);
    return reader.end();
  }

  /// Only what all kinds have; the kind reads the rest.
  Expected<void> readAgents(const toml::array* tables) {
    std::set<std::string> kinds;
    for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i) {
      const toml::table& table = *tables->get(i)->as_table();
      SectionReader reader(table, "agent", task_.file);
      AgentSection section;
      section.table = std::make_shared<const AgentTable>(AgentTable{table});
      section.file = task_.file;
      reader.fields().require("what");
      reader.fields().read("what", section.kind);
      reader.fields().read("weight", section.weight, 1.0, 0.0, 100.0);
      reader.fields().read("enabled", section.enabled);
      if (!kinds.insert(section.kind).second)
        reader.fields().fail(&table, Text("a second agent '%1'", section.kind), Text("each agent once"));
      HAPTICELL_TRY(reader.check());
      task_.agents.push_back(std::move(section));
    }
    if (!task_.agents.empty()) return {};
    return makeError({.file = task_.file.string(),
                      .found = Text("no agents"),
                      .expected = Text("at least one table [[agent]]")});
  }

  AgentTask& task_;
};

Expected<AgentTask> AgentTask::read(const fs::path& file) {
  auto text = geometry::readRegularFile(file, kLargestTask);
  HAPTICELL_TRY(text);
  return parse(*text, file);
}

Expected<AgentTask> AgentTask::parse(const std::string& text, const fs::path& file) {
  AgentTask task;
  task.file = fs::absolute(file).lexically_normal();
  HAPTICELL_TRY(geometry::checkNesting(text, geometry::NestedText::kToml, file.string()));
  auto tree = std::make_shared<Tree>();
  try {
    tree->root = toml::parse(text);
  } catch (const toml::parse_error& problem) {
    return makeError({.file = file.string(),
                      .place = Text("line %1", problem.source().begin.line),
                      .found = Text("text that is not TOML (%1)", problem.description()),
                      .expected = "a task for agents"});
  }
  task.tree_ = tree;
  HAPTICELL_TRY(AgentTaskReader(task).read(tree->root));
  return task;
}

}  // namespace hapticell::agents
