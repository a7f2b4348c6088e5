// SPDX-License-Identifier: Apache-2.0
#include "workcell/format/document_format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "geometry/system/regular_file.h"
#include "workcell/document/command.h"
#include "workcell/document/command_checks.h"
#include "workcell/document/perform_command.h"
#include "workcell/format/document_io.h"
#include "workcell/format/entity_format.h"
#include "workcell/format/guide_format.h"
#include "workcell/format/mechanism_format.h"
#include "workcell/format/source_format.h"
#include "workcell/format/work_task_format.h"
#include "workcell/import/entity_source.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFormat = "hapticell-workcell";
constexpr int kVersion = 1;
// Levels: guards the stack and time. Of CAD files it is 500. Half, twice: other documents are refused with a message.
constexpr int kDeepestParents = 1000;
// Entities that hang on each other in a row: guards time of a motion. Half, twice: other documents are refused with a
// message.
constexpr int kMostCarriers = 200;

Json jsonFromPairSet(const PairSet& set) {
  Json json;
  json["name"] = set.name;
  json["enabled"] = set.enabled;
  json["first"] = set.first;
  json["second"] = set.second;
  json["safety_distance"] = set.safety_distance;
  json["near_miss"] = set.near_miss;
  if (set.on_contact) json["on_contact"] = wordOf(*set.on_contact);
  if (set.contact_color) json["contact_color"] = *set.contact_color;
  if (set.near_miss_color) json["near_miss_color"] = *set.near_miss_color;
  return json;
}

Json jsonFromPairRule(const PairRule& rule) {
  Json json;
  json["first"] = rule.first;
  if (!rule.first_part.empty()) json["first_link"] = rule.first_part;
  json["second"] = rule.second;
  if (!rule.second_part.empty()) json["second_link"] = rule.second_part;
  json["checked"] = rule.checked;
  if (rule.on_contact) json["on_contact"] = wordOf(*rule.on_contact);
  return json;
}

/// m and rad: what is written with all digits and read again is nearer than this. Half: documents of other programs
/// with seven digits warn; twice: 2 um off is not noted.
constexpr double kSamePlace = 1e-6;

/// What is wrong with how names stand above each other.
struct Levels {
  std::unordered_set<std::string> in_circle;  ///< One name of each circle.
  std::string too_deep;                       ///< A name with more than so many above it; empty: none.
};

/// `above`: the one above each name, where there is one. Linear: each name is looked at once.
Levels levelsOf(const std::unordered_map<std::string, std::string>& above, int most) {
  Levels result;
  std::unordered_map<std::string, int> levels;  // 0: on the way that is gone.
  for (const auto& [name, ignored] : above) {
    std::vector<const std::string*> way;
    const std::string* at = &name;
    while (above.contains(*at) && levels.try_emplace(*at, 0).second) {
      way.push_back(at);
      at = &above.find(*at)->second;
    }
    const auto known = levels.find(*at);
    if (known != levels.end() && known->second == 0) result.in_circle.insert(*at);
    int level = known == levels.end() ? 0 : known->second;
    for (auto step = way.rbegin(); step != way.rend(); ++step) levels[**step] = ++level;
    if (level > most) result.too_deep = name;
  }
  return result;
}

class StateReader {
 public:
  StateReader(const fs::path& folder, Diagnostics& diagnostics, const LoadOptions& options)
      : folder_(folder), loader_(folder, true, options.monitor), diagnostics_(diagnostics), options_(options) {
    if (options.known == nullptr) return;
    for (const auto& entity : options.known->entities) {
      if (entity->unloaded) continue;
      Json json = jsonFromEntity(*entity, folder);
      known_shapes_.try_emplace(shapeKey(json), entity.get());
      known_.try_emplace(std::move(json), entity.get());
    }
  }

  Expected<DocumentState> read(const Json& json) {
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
    if (!error_) hangUp();
    for (std::size_t k = 0; sets && k < sets->size() && !error_; ++k) readPairSet((*sets)[k], k);
    for (std::size_t k = 0; rules && k < rules->size() && !error_; ++k) readPairRule((*rules)[k], k);
    for (std::size_t k = 0; guides && k < guides->size() && !error_; ++k) readGuide((*guides)[k], k);
    for (std::size_t k = 0; tasks && k < tasks->size() && !error_; ++k) readWorkTask((*tasks)[k], k);
    if (error_) return makeError(*error_);
    return std::move(state_);
  }

 private:
  /// What the shape of an entity comes of; empty: nothing that could be known.
  static std::string shapeKey(const Json& json) {
    std::string key;
    for (const char* part : {"kind", "source", "mechanism"}) {
      if (const auto found = json.find(part); found != json.end()) key += found->dump() + "\n";
    }
    return key;
  }

  /// An entity with the shape that this one comes of; null: it must be read.
  const Entity* knownShape(const Json& json) const {
    if (options_.known == nullptr) return nullptr;
    const auto found = known_shapes_.find(shapeKey(json));
    return found == known_shapes_.end() ? nullptr : found->second;
  }

  /// Only what comes of its source: the rest is in the text.
  static Entity asRead(const Entity& known) {
    Entity fresh;
    fresh.source = known.source;
    fresh.body = known.body;
    if (known.mesh()) fresh.editSolid().proxy = {};
    if (known.robot()) {
      Jointed& jointed = fresh.editJointed();
      jointed.tools.clear();
      jointed.tool.clear();
      jointed.named_poses.clear();
    }
    return fresh;
  }

  struct Hanging {
    std::size_t index;  ///< Among the entities.
    Attachment attachment;
    bool placed;  ///< Its place on the carrier is written.
  };

  void readHead(FieldReader& fields) {
    std::string format;
    double version = 0.0;
    fields.read("format", format);
    fields.read("version", version);
    if (error_) return;
    if (format != kFormat) {
      error_ = Error{.found = format.empty() ? Text("\"%1\" is missing", "format")
                                             : Text("the format \"%1\"", format.substr(0, 60)),
                     .expected = "\"" + std::string(kFormat) + "\""};
    } else if (version != std::floor(version) || version < 1.0) {
      fields.fail("version", Text("the version number is missing"), "1");
    } else if (version > kVersion) {
      char number[32];
      std::snprintf(number, sizeof number, "%.0f", version);
      fields.fail("version", std::string(number), Text("at most 1, the newest version that this program can read"));
      error_->fix = Text("Open the document with a newer HaptiCell.");
    }
  }

  /// How deep the tree is, before one of its entities is made. Those in a circle are told, and stand at the top.
  void checkParents(const Json& entities) {
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

  void refuseCancelled() {
    if (options_.monitor && options_.monitor->isCancelled()) {
      error_ = Error{.found = "the opening was cancelled"};
    }
  }

  void reportEntity(std::size_t index, std::size_t count) {
    refuseCancelled();
    if (!options_.monitor) return;
    const double n = static_cast<double>(count), k = static_cast<double>(index);
    options_.monitor->setRange(k / n, (k + 1.0) / n);
    options_.monitor->report(Text("reading part %1 of %2", index + 1, count), 0.0);
  }

  void readEntity(const Json& json, std::size_t index) {
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
    if (const auto same = known_.find(json); same != known_.end()) return addHanging(fields, place, *same->second);
    if (assembly) {
      head.body = Assembly{};
      if (!head.source.path.empty()) head.source.path = (folder_ / head.source.path).lexically_normal().string();
      if (head.source.scale == 0.0) head.source.scale = 1.0;
      return addEntity(fields, place, std::move(head));
    }
    const Entity* known = knownShape(json);
    const auto load = [&]() -> Expected<Entity> {
      if (known) return asRead(*known);
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
  void keepUnloaded(const Json& json, FieldReader& fields, const Text& place, Entity entity, const Error& cause) {
    error_.reset();
    const Text remark("%1 is kept without its shape: %2", place, cause.text());
    diagnostics_.warn(remark);
    if (options_.unloaded != nullptr) options_.unloaded->push_back({entity.name, cause, remark});
    entity.unloaded = std::make_shared<const std::string>(json.dump());
    readEntityFields(fields, place, context_, entity);
    if (error_) return;
    add(place, std::move(entity));
  }

  bool add(const Text& place, Entity entity) {
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

  const Entity* named(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() || found->second >= state_.entities.size() ? nullptr
                                                                            : state_.entities[found->second].get();
  }

  void addEntity(FieldReader& fields, const Text& place, Entity entity) {
    readEntityFields(fields, place, context_, entity);
    if (error_) return;
    fields.warnAboutOthers(diagnostics_);
    if (const auto near = checkReach(entity); !near) diagnostics_.warn(near.error().text());
    addHanging(fields, place, std::move(entity));
  }

  void addHanging(FieldReader& fields, const Text& place, Entity entity) {
    // What it hangs on may stand further down in the file.
    Attachment attachment;
    std::swap(attachment, entity.attachment);
    const Json* attached = fields.object("attached");
    const bool placed = attached != nullptr && attached->contains("placement");
    if (!add(place, std::move(entity))) return;
    if (!attachment.to.empty()) attachments_.push_back({state_.entities.size() - 1, std::move(attachment), placed});
  }

  /// All entities are there: what hangs on which.
  void hangUp() {
    std::unordered_map<std::string, std::string> carriers;
    for (const Hanging& hanging : attachments_)
      carriers.emplace(state_.entities[hanging.index]->name, hanging.attachment.to);
    if (const Levels levels = levelsOf(carriers, kMostCarriers); !levels.too_deep.empty()) {
      error_ = Error{.place = Text("entity '%1'", levels.too_deep),
                     .found = Text("it is attached through a chain of more than %1 entities", kMostCarriers),
                     .expected = "fewer",
                     .fix = "Correct \"attached\" in the document."};
      return;
    }
    for (auto& [index, attachment, placed] : attachments_) {
      auto entity = std::make_shared<Entity>(*state_.entities[index]);
      const Text place("entity '%1'", entity->name);
      const Entity* carrier = named(attachment.to);
      for (const Entity* at = carrier; at; at = at->attachment.to.empty() ? nullptr : named(at->attachment.to)) {
        if (at->name == entity->name) {
          error_ = Error{.place = place,
                         .found = Text("it is attached to itself through '%1'", attachment.to),
                         .expected = "another entity"};
          return;
        }
      }
      const bool link_there = carrier && (carrier->unloaded || attachment.link.empty() ||
                                          (carrier->robot() && carrier->robot()->findLink(attachment.link) >= 0));
      if (!link_there) {
        error_ = Error{.place = place,
                       .found = carrier ? Text("it is attached to '%1', link '%2', which does not exist", attachment.to,
                                               attachment.link)
                                        : Text("it is attached to '%1', which does not exist", attachment.to),
                       .expected = "an existing entity or link"};
        return;
      }
      entity->attachment = std::move(attachment);
      state_.entities[index] = std::move(entity);
    }
    placeOnCarriers();
  }

  /// Where it hangs counts: an entity whose own placement says otherwise is put there, and that is told. Carriers come
  /// first; a chain of them may be as long as the file.
  void placeOnCarriers() {
    std::map<std::string, const Hanging*> by_name;
    for (const Hanging& hanging : attachments_) by_name[state_.entities[hanging.index]->name] = &hanging;
    std::set<const Hanging*> done;
    for (const Hanging& hanging : attachments_) {
      std::vector<const Hanging*> chain;
      for (const Hanging* at = &hanging; at != nullptr && done.insert(at).second;) {
        chain.push_back(at);
        const auto below = by_name.find(state_.entities[at->index]->attachment.to);
        at = below == by_name.end() ? nullptr : below->second;
      }
      for (auto at = chain.rbegin(); at != chain.rend(); ++at) placeOnCarrier(**at);
    }
  }

  void placeOnCarrier(const Hanging& hanging) {
    auto entity = std::make_shared<Entity>(*state_.entities[hanging.index]);
    const Entity* carrier = named(entity->attachment.to);
    if (carrier == nullptr || carrier->unloaded) return;
    const Pose X_WL = carrierPose(*carrier, entity->attachment.link);
    if (!hanging.placed) {
      entity->attachment.X_LE = X_WL.inverse() * entity->X_WE;
    } else {
      const Pose X_WE = X_WL * entity->attachment.X_LE;
      const Twist off = difference(X_WE, entity->X_WE);
      if (glm::length(off.linear) < kSamePlace && glm::length(off.angular) < kSamePlace) return;
      entity->X_WE = X_WE;
      diagnostics_.warn(
          Text("entity '%1': its \"placement\" does not match its attachment to '%2'; the attachment is used",
               entity->name, carrier->name));
    }
    state_.entities[hanging.index] = std::move(entity);
  }

  void readPairSet(const Json& json, std::size_t index) {
    PairSet set;
    int on_contact = -1;
    FieldReader fields(json, Text("pair set %1", index + 1), error_);
    fields.require("name");
    fields.read("name", set.name);
    fields.read("enabled", set.enabled);
    fields.read("first", set.first);
    fields.read("second", set.second);
    fields.read("safety_distance", set.safety_distance);
    fields.read("near_miss", set.near_miss);
    fields.readWord("on_contact", kOnContactWords, on_contact);
    readColor(fields, "contact_color", set.contact_color);
    readColor(fields, "near_miss_color", set.near_miss_color);
    if (error_) return;
    if (on_contact >= 0) set.on_contact = static_cast<OnContact>(on_contact);
    fields.warnAboutOthers(diagnostics_);
    for (const auto* side : {&set.first, &set.second}) {
      for (const std::string& name : *side) {
        if (!named(name)) diagnostics_.warn(Text("pair set '%1' names '%2', which does not exist", set.name, name));
      }
    }
    const Text place("pair set '%1'", set.name);
    const auto added = apply(AddPairSet{std::move(set)}, state_, 0);
    if (!added) context_.failIn(place, added.error());
  }

  static void readColor(FieldReader& fields, const char* key, std::optional<std::array<float, 3>>& color) {
    std::vector<double> parts;
    if (!fields.readNumbers(key, 3, parts)) return;
    color.emplace();
    for (std::size_t i = 0; i < 3; ++i) (*color)[i] = static_cast<float>(parts[i]);
  }

  void readPairRule(const Json& json, std::size_t index) {
    PairRule rule;
    int on_contact = -1;
    FieldReader fields(json, Text("pair rule %1", index + 1), error_);
    fields.require("first");
    fields.require("second");
    fields.read("first", rule.first);
    fields.read("first_link", rule.first_part);
    fields.read("second", rule.second);
    fields.read("second_link", rule.second_part);
    fields.read("checked", rule.checked);
    fields.readWord("on_contact", kOnContactWords, on_contact);
    if (error_) return;
    if (on_contact >= 0) rule.on_contact = static_cast<OnContact>(on_contact);
    fields.warnAboutOthers(diagnostics_);
    const std::string first = rule.first, second = rule.second;
    // As with sets: what it is about may be missing, the rest of the cell is not.
    if (const auto added = apply(SetPairRules{{std::move(rule)}, {}}, state_, 0); !added)
      diagnostics_.warn(Text("the rule for '%1' and '%2' is left out: %3", first, second, added.error().text()));
  }

  void readGuide(const Json& json, std::size_t index) {
    Guide guide = guideFromJson(json, index, error_, diagnostics_);
    if (error_) return;
    const Text place("guide '%1'", guide.name);
    const auto added = apply(AddGuide{std::move(guide)}, state_, 0);
    if (!added) context_.failIn(place, added.error());
  }

  void readWorkTask(const Json& json, std::size_t index) {
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

  void readView(FieldReader& fields) {
    const Json* json = fields.object("view");
    if (!json) return;
    FieldReader view(*json, std::string("\"view\""), error_);
    std::vector<double> eye, target;
    if (!view.readNumbers("eye", 3, eye) || !view.readNumbers("target", 3, target)) return;
    view.warnAboutOthers(diagnostics_);
    state_.view = SavedView{{eye[0], eye[1], eye[2]}, {target[0], target[1], target[2]}};
  }

  void readTrajectories(FieldReader& fields) {
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

  const fs::path& folder_;
  EntityLoader loader_;
  Diagnostics& diagnostics_;
  const LoadOptions& options_;
  std::optional<Error> error_;
  FormatContext context_{folder_, loader_, diagnostics_, options_, error_};
  SourceReader sources_{context_};
  DocumentState state_;
  std::vector<Hanging> attachments_;
  std::unordered_map<std::string, std::size_t> index_;  // Of the entities, by name.
  std::unordered_set<std::string> in_circle_;           // One of each circle of parents.
  std::map<Json, const Entity*> known_;                 // By their text.
  std::map<std::string, const Entity*> known_shapes_;   // By shapeKey().
};

}  // namespace

Json jsonFromState(const DocumentState& state, const fs::path& folder) {
  Json json;
  json["format"] = kFormat;
  json["version"] = kVersion;
  json["entities"] = Json::array();
  for (const auto& entity : state.entities) json["entities"].push_back(jsonFromEntity(*entity, folder));
  json["pair_sets"] = Json::array();
  for (const PairSet& set : state.pair_sets) json["pair_sets"].push_back(jsonFromPairSet(set));
  if (!state.pair_rules.empty()) json["pair_rules"] = Json::array();
  for (const PairRule& rule : state.pair_rules) json["pair_rules"].push_back(jsonFromPairRule(rule));
  if (!state.guides.empty()) json["guides"] = Json::array();
  for (const Guide& guide : state.guides) json["guides"].push_back(jsonFromGuide(guide));
  if (!state.work_tasks.empty()) json["work_tasks"] = Json::array();
  for (const auto& task : state.work_tasks) json["work_tasks"].push_back(jsonFromWorkTask(task));
  if (state.view) {
    const dvec3 eye = state.view->p_WEye, target = state.view->p_WTarget;
    json["view"] = {{"eye", {eye.x, eye.y, eye.z}}, {"target", {target.x, target.y, target.z}}};
  }
  json["trajectories"] = Json::array();
  for (const TrajectoryReference& reference : state.trajectories) {
    json["trajectories"].push_back({{"name", reference.name}, {"file", relativeName(reference.path, folder)}});
  }
  return json;
}

Expected<DocumentState> stateFromJson(const Json& json, const fs::path& folder, Diagnostics& diagnostics,
                                      const LoadOptions& options) {
  return StateReader(folder, diagnostics, options).read(json);
}

}  // namespace hapticell::workcell
