// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>
#include <vector>

#include "studies/document/study_section.h"
#include "studies/variants/placed_entities.h"
#include "studies/variants/variation_kinds.h"

namespace hapticell::studies {

namespace {

using workcell::Entity;
using workcell::EntityId;

/// Of a direction as it is written. Half and twice: only what is refused as a slip.
constexpr double kShortest = 1e-6;

const std::vector<std::string> kAxisWords{"x", "y", "z"};

dvec3 axisOf(int axis) {
  dvec3 unit(0.0);
  unit[axis] = 1.0;
  return unit;
}

/// What a section moves: entities by name, or everything in a folder of that name. What is attached to another one of
/// them, or below it in the tree, moves with that.
Expected<std::vector<EntityId>> movedEntities(const StudySection& section, const std::vector<std::string>& names,
                                              const StudyInputs& inputs) {
  const workcell::DocumentState& state = inputs.cell.state();
  std::vector<EntityId> all;
  for (const std::string& name : names) {
    if (const Entity* entity = state.findByName(name)) {
      all.push_back(entity->id);
      continue;
    }
    const std::size_t before = all.size();
    for (const auto& entity : state.entities) {
      if (entity->parent == name) all.push_back(entity->id);
    }
    if (all.size() > before) continue;
    const auto missing = inputs.entityNamed(section, name);
    HAPTICELL_TRY(missing);
  }
  std::vector<EntityId> moved;
  for (const EntityId id : all) {
    const bool carried = std::any_of(all.begin(), all.end(), [&](EntityId other) {
      if (other == id) return false;
      const auto family = workcell::familyOf(state, other);
      return workcell::isCarriedBy(state, *state.find(id), other) ||
             std::find(family.begin(), family.end(), id) != family.end();
    });
    if (!carried && std::find(moved.begin(), moved.end(), id) == moved.end()) moved.push_back(id);
  }
  return moved;
}

/// What both kinds read.
struct Placed {
  std::vector<EntityId> entities;
  dvec3 along{0.0, 0.0, 1.0};  ///< Unit, in the cell.
  bool is_axis = true;         ///< It is one of the cell's axes.
};

Expected<Placed> readPlaced(SectionReader& reader, const StudySection& section, const StudyInputs& inputs) {
  std::string entity;
  std::vector<std::string> names;
  Placed placed;
  reader.fields().read("entity", entity);
  reader.fields().readList("entities", names);
  int axis = 2;
  std::vector<double> direction;
  reader.fields().readWord("axis", kAxisWords, axis);
  reader.fields().readList("direction", direction);
  placed.along = axisOf(axis);
  placed.is_axis = direction.empty();
  if (reader.fields().has("axis") == reader.fields().has("direction"))
    reader.fields().fail(nullptr, Text("no single direction"), Text("axis = \"z\", or direction = [x, y, z]"));
  if (!direction.empty()) {
    const dvec3 given = direction.size() == 3 ? dvec3(direction[0], direction[1], direction[2]) : dvec3(0.0);
    if (glm::length(given) < kShortest) {
      reader.fields().failKey("direction", Text("no direction"), Text("three numbers, not all 0"));
    } else {
      placed.along = glm::normalize(given);
    }
  }
  if (!entity.empty()) names.push_back(entity);
  if (names.empty())
    reader.fields().fail(nullptr, Text("nothing that is moved"), Text("entity = \"...\" or entities = [...]"));
  HAPTICELL_TRY(reader.check());
  auto moved = movedEntities(section, names, inputs);
  HAPTICELL_TRY(moved);
  placed.entities = std::move(*moved);
  return placed;
}

class Position : public Variation {
 public:
  Position(std::string name, ValueRange range, Placed placed, bool absolute)
      : Variation(std::move(name), std::move(range)), placed_(std::move(placed)), absolute_(absolute) {}

  std::string unit() const override { return "m"; }
  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    const double number = std::get<double>(value);
    const double now = glm::dot(cell.document.find(placed_.entities.front())->X_WE.p, placed_.along);
    const double way = absolute_ ? number - now : number;
    for (const EntityId id : placed_.entities) {
      Pose X_WE = cell.document.find(id)->X_WE;
      X_WE.p += way * placed_.along;
      HAPTICELL_TRY(place(cell.document, id, X_WE));
    }
    return {};
  }

 private:
  Placed placed_;
  bool absolute_;
};

class Rotation : public Variation {
 public:
  Rotation(std::string name, ValueRange range, Placed placed)
      : Variation(std::move(name), std::move(range)), placed_(std::move(placed)) {}

  std::string unit() const override { return "deg"; }
  Expected<void> apply(const Value& value, VariantCell& cell) const override {
    const dquat turn = glm::angleAxis(std::get<double>(value) * std::numbers::pi / 180.0, placed_.along);
    const dvec3 pivot = cell.document.find(placed_.entities.front())->X_WE.p;
    for (const EntityId id : placed_.entities) {
      Pose X_WE = cell.document.find(id)->X_WE;
      X_WE.p = pivot + turn * (X_WE.p - pivot);
      X_WE.q = glm::normalize(turn * X_WE.q);
      HAPTICELL_TRY(place(cell.document, id, X_WE));
    }
    return {};
  }

 private:
  Placed placed_;
};

}  // namespace

MadeVariation makePosition(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  bool absolute = false;
  reader.fields().read("absolute", absolute);
  auto placed = readPlaced(reader, section, inputs);
  HAPTICELL_TRY(placed);
  auto range = ValueRange::numbers(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<Position>(section.name, std::move(*range), std::move(*placed), absolute);
}

MadeVariation makeRotation(const StudySection& section, StudyInputs& inputs) {
  SectionReader reader(section);
  auto placed = readPlaced(reader, section, inputs);
  HAPTICELL_TRY(placed);
  auto range = ValueRange::numbers(reader);
  HAPTICELL_TRY(range);
  HAPTICELL_TRY(reader.end());
  return std::make_unique<Rotation>(section.name, std::move(*range), std::move(*placed));
}

}  // namespace hapticell::studies
