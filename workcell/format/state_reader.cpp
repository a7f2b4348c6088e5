// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/state_reader.h"

#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>

#include "geometry/system/regular_file.h"
#include "workcell/document/command.h"
#include "workcell/document/command_checks.h"
#include "workcell/document/perform_command.h"
#include "workcell/format/document_format.h"
#include "workcell/format/entity_format.h"
#include "workcell/format/guide_format.h"
#include "workcell/format/mechanism_format.h"
#include "workcell/format/name_levels.h"
#include "workcell/format/pair_format.h"
#include "workcell/format/work_task_format.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

// Levels: guards the stack and time. Of CAD files it is 500. Half, twice: other documents are refused with a message.
constexpr int kDeepestParents = 1000;

}  // namespace

StateReader::StateReader(const fs::path& folder, Diagnostics& diagnostics, const LoadOptions& options)
    : folder_(folder),
      loader_(folder, true, options.monitor),
      diagnostics_(diagnostics),
      options_(options),
      known_(options.known, folder) {}

Expected<DocumentState> StateReader::read(const Json& json) {
  FieldReader fields(json, Text("the document"), error_);
  readHead(fields);
  const Json* entities = fields.array("entities");
  const Json* sets = fields.array("pair_sets");
  const Json* rules = fields.array("pair_rules");
  const Json* guides = fields.array("guides");
  const Json* tasks = fields.array("work_tasks");
  readView(fields);
  readTrajectories(fields);
  if (!error_) fields.warnAboutOthers(diagnostics_);
  if (entities && !error_) checkParents(*entities);
  for (std::size_t k = 0; entities && k < entities->size() && !error_; ++k) {
    reportEntity(k, entities->size());
    if (!error_) readEntity((*entities)[k], k);
  }
  if (!error_) refuseCancelled();
  if (!error_) attachAll();
  for (std::size_t k = 0; sets && k < sets->size() && !error_; ++k) readPairSet((*sets)[k], k);
  for (std::size_t k = 0; rules && k < rules->size() && !error_; ++k) readPairRule((*rules)[k], k);
  for (std::size_t k = 0; guides && k < guides->size() && !error_; ++k) readGuide((*guides)[k], k);
  for (std::size_t k = 0; tasks && k < tasks->size() && !error_; ++k) readWorkTask((*tasks)[k], k);
  if (error_) return makeError(*error_);
  return std::move(state_);
}

void StateReader::readHead(FieldReader& fields) {
  std::string format;
  double version = 0.0;
  fields.read("format", format);
  fields.read("version", version);
  if (error_) return;
  if (format != kDocumentFormat) {
    error_ = Error{
        .found = format.empty() ? Text("\"%1\" is missing", "format") : Text("the format \"%1\"", format.substr(0, 60)),
        .expected = "\"" + std::string(kDocumentFormat) + "\""};
  } else if (version != std::floor(version) || version < 1.0) {
    fields.fail("version", Text("the version number is missing"), "1");
  } else if (version > kDocumentVersion) {
    char number[32];
    std::snprintf(number, sizeof number, "%.0f", version);
    fields.fail("version", std::string(number), Text("at most 1, the newest version that this program can read"));
    error_->fix = Text("Open the document with a newer HaptiCell.");
  }
}

/// How deep the tree is, before one of its entities is made. Those in a circle are told, and stand at the top.
void StateReader::checkParents(const Json& entities) {
  std::unordered_map<std::string, std::string> parents;
  for (const Json& entity : entities) {
    if (!entity.is_object() || !entity.contains("name") || !entity["name"].is_string()) continue;
    if (entity.contains("parent") && entity["parent"].is_string())
      parents.emplace(entity["name"].get<std::string>(), entity["parent"].get<std::string>());
  }
  Levels levels = levelsOf(parents, kDeepestParents);
  in_circle_ = std::move(levels.in_circle);
  if (levels.too_deep.empty()) return;
  error_ = Error{.place = Text("entity '%1'", levels.too_deep),
                 .found = Text("more than %1 nested assemblies", kDeepestParents),
                 .expected = Text("at most %1 levels", kDeepestParents),
                 .fix = "Correct \"parent\" in the document."};
}

void StateReader::refuseCancelled() {
  if (options_.monitor && options_.monitor->isCancelled()) {
    error_ = Error{.found = "the opening was cancelled"};
  }
}

void StateReader::reportEntity(std::size_t index, std::size_t count) {
  refuseCancelled();
  if (!options_.monitor) return;
  const double n = static_cast<double>(count), k = static_cast<double>(index);
  options_.monitor->setRange(k / n, (k + 1.0) / n);
  options_.monitor->report(Text("reading part %1 of %2", index + 1, count), 0.0);
}

void StateReader::readEntity(const Json& json, std::size_t index) {
  Entity head;
  int kind = -1;
  FieldReader naming(json, Text("entity %1", index + 1), error_);
  naming.require("name");
  naming.read("name", head.name);
  const Text place("entity '%1'", head.name);
  FieldReader fields(json, place, error_);
  fields.read("name", head.name);
  fields.readWord("kind", entityKindWords(), kind);
  const Json* mechanism = fields.object("mechanism");
  const bool assembly = kind == static_cast<int>(EntityKind::kAssembly);
  if (!mechanism && !assembly) fields.require("source");
  if (const Json* source = fields.object("source")) sources_.read(*source, place, head.source);
  if (error_) return;
  if (const Entity* same = known_.same(json)) return addHanging(fields, place, *same);
  if (assembly) {
    head.body = Assembly{};
    if (!head.source.path.empty()) head.source.path = (folder_ / head.source.path).lexically_normal().string();
    if (head.source.scale == 0.0) head.source.scale = 1.0;
    return addEntity(fields, place, std::move(head));
  }
  const auto load = [&]() -> Expected<Entity> {
    if (auto known = known_.withSameShape(json)) return std::move(*known);
    if (mechanism) return mechanismFromJson(*mechanism, head.name, place, context_, sources_);
    return loader_.loadSource(head.source, diagnostics_);
  };
  Expected<Entity> loaded = load();
  if (!loaded && options_.keep_unloaded) return keepUnloaded(json, fields, place, head, loaded.error());
  if (!loaded) return context_.failIn(place, loaded.error());
  loaded->name = head.name;
  if (kind >= 0 && kind != static_cast<int>(loaded->kind())) {
    const std::string& is = entityKindWords()[static_cast<std::size_t>(loaded->kind())];
    return fields.fail("kind", entityKindWords()[static_cast<std::size_t>(kind)], Text("%1, like its file", is));
  }
  addEntity(fields, place, std::move(*loaded));
}

/// The entity stays in the document as it is written there; what can be known without its file is read.
void StateReader::keepUnloaded(const Json& json, FieldReader& fields, const Text& place, Entity entity,
                               const Error& cause) {
  error_.reset();
  const Text remark("%1 is kept without its shape: %2", place, cause.text());
  diagnostics_.warn(remark);
  if (options_.unloaded != nullptr) options_.unloaded->push_back({entity.name, cause, remark});
  entity.unloaded = std::make_shared<const std::string>(json.dump());
  readEntityFields(fields, place, context_, entity);
  if (error_) return;
  add(place, std::move(entity));
}

bool StateReader::add(const Text& place, Entity entity) {
  if (in_circle_.contains(entity.name)) {
    diagnostics_.warn(
        Text("%1 contains itself through '%2'; it is moved to the top of the tree", place, entity.parent));
    entity.parent.clear();
  }
  const std::string name = entity.name;
  const bool is_new = index_.try_emplace(name, state_.entities.size()).second;
  StateEdit edit(state_, state_.entities.size() + 1);
  const auto added = is_new ? addNewlyNamed(entity, edit) : Expected<EntityId>(makeError(taken(name)));
  if (!added) context_.failIn(place, added.error());
  return added.has_value();
}

const Entity* StateReader::named(const std::string& name) const {
  const auto found = index_.find(name);
  return found == index_.end() || found->second >= state_.entities.size() ? nullptr
                                                                          : state_.entities[found->second].get();
}

void StateReader::addEntity(FieldReader& fields, const Text& place, Entity entity) {
  readEntityFields(fields, place, context_, entity);
  if (error_) return;
  fields.warnAboutOthers(diagnostics_);
  if (const auto near = checkReach(entity); !near) diagnostics_.warn(near.error().text());
  addHanging(fields, place, std::move(entity));
}

void StateReader::addHanging(FieldReader& fields, const Text& place, Entity entity) {
  // What it hangs on may stand further down in the file.
  Attachment attachment;
  std::swap(attachment, entity.attachment);
  const Json* attached = fields.object("attached");
  const bool placed = attached != nullptr && attached->contains("placement");
  if (!add(place, std::move(entity))) return;
  if (!attachment.to.empty()) attachments_.add(state_.entities.size() - 1, std::move(attachment), placed);
}

void StateReader::attachAll() {
  const auto attached = attachments_.attachAll(state_, index_, diagnostics_);
  if (!attached) error_ = attached.error();
}

void StateReader::readPairSet(const Json& json, std::size_t index) {
  PairSet set = pairSetFromJson(json, index, error_, diagnostics_);
  if (error_) return;
  for (const auto* side : {&set.first, &set.second}) {
    for (const std::string& name : *side) {
      if (!named(name)) diagnostics_.warn(Text("pair set '%1' names '%2', which does not exist", set.name, name));
    }
  }
  const Text place("pair set '%1'", set.name);
  const auto added = apply(AddPairSet{std::move(set)}, state_, 0);
  if (!added) context_.failIn(place, added.error());
}

void StateReader::readPairRule(const Json& json, std::size_t index) {
  PairRule rule = pairRuleFromJson(json, index, error_, diagnostics_);
  if (error_) return;
  const std::string first = rule.first, second = rule.second;
  // As with sets: what it is about may be missing, the rest of the cell is not.
  if (const auto added = apply(SetPairRules{{std::move(rule)}, {}}, state_, 0); !added)
    diagnostics_.warn(Text("the rule for '%1' and '%2' is left out: %3", first, second, added.error().text()));
}

void StateReader::readGuide(const Json& json, std::size_t index) {
  Guide guide = guideFromJson(json, index, error_, diagnostics_);
  if (error_) return;
  const Text place("guide '%1'", guide.name);
  const auto added = apply(AddGuide{std::move(guide)}, state_, 0);
  if (!added) context_.failIn(place, added.error());
}

void StateReader::readWorkTask(const Json& json, std::size_t index) {
  ergonomics::WorkTask task = workTaskFromJson(json, index, error_, diagnostics_);
  if (error_) return;
  const Text place("task '%1'", task.name);
  if (state_.findWorkTask(task.name)) {
    error_ = Error{.place = place, .found = "the name is used twice", .expected = "unique names"};
    return;
  }
  // As with sets: who does it may be missing, the rest of the cell is not.
  if (const auto added = apply(SetWorkTask{std::move(task)}, state_, 0); !added)
    diagnostics_.warn(Text("%1 is left out: %2", place, added.error().text()));
}

void StateReader::readView(FieldReader& fields) {
  const Json* json = fields.object("view");
  if (!json) return;
  FieldReader view(*json, std::string("\"view\""), error_);
  std::vector<double> eye, target;
  if (!view.readNumbers("eye", 3, eye) || !view.readNumbers("target", 3, target)) return;
  view.warnAboutOthers(diagnostics_);
  state_.view = SavedView{{eye[0], eye[1], eye[2]}, {target[0], target[1], target[2]}};
}

void StateReader::readTrajectories(FieldReader& fields) {
  const Json* list = fields.array("trajectories");
  for (std::size_t k = 0; list && k < list->size() && !error_; ++k) {
    TrajectoryReference reference;
    FieldReader trajectory((*list)[k], Text("trajectory %1", k + 1), error_);
    trajectory.require("file");
    trajectory.read("name", reference.name);
    trajectory.read("file", reference.path);
    reference.path = (folder_ / reference.path).lexically_normal().string();
    std::error_code ignored;
    if (const auto regular = geometry::checkRegularFile(reference.path);
        !regular && fs::exists(reference.path, ignored))
      diagnostics_.warn(Text("trajectory '%1' is not read: %2", reference.name, regular.error().text()));
    state_.trajectories.push_back(std::move(reference));
  }
}

}  // namespace hapticell::workcell
