// SPDX-License-Identifier: Apache-2.0
#include "app/studies/variant_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "app/studies/result_table.h"
#include "geometry/shapes/shapes.h"
#include "studies/document/study_text.h"

namespace hapticell::app {

using studies::StudyPlace;

namespace {

/// m: a cell along an axis that does not vary, and the thickness of all. Half: a line that is hard to see; twice: hides
/// what it stands on.
constexpr double kSingle = 0.1, kThickness = 0.004;
/// m above the floor: what is drawn on it does not flicker. Half: flickers from afar; twice: floats.
constexpr double kAboveFloor = 0.004;
/// Share of the distance of neighbours that a cell fills. Half: dots; twice: cells overlap.
constexpr double kFilled = 0.92;
/// Values of one axis from which on they are samples, not a grid. Half: fine grids become coarse cells; twice: samples
/// become slivers.
constexpr std::size_t kMostOfGrid = 120;
/// Of the third part of a unit direction that counts as level: 1 degree. Half and twice: as well.
constexpr double kLevel = 0.02;

struct MapAxis {
  int axis = 0;     ///< Of the cells.
  int column = -1;  ///< Of the results.
  double base = 0.0;  ///< What a value of 0 is away from the given place.
};

dvec3 turned(double yaw, const dvec3& p) {
  return {std::cos(yaw) * p.x - std::sin(yaw) * p.y, std::sin(yaw) * p.x + std::cos(yaw) * p.y, p.z};
}

struct Places {
  dvec3 origin_W{0.0};
  double yaw = 0.0;
  std::vector<MapAxis> axes;
  bool has(int axis) const {
    return std::any_of(axes.begin(), axes.end(), [&](const MapAxis& one) { return one.axis == axis; });
  }
};

std::string entityOf(const studies::StudyText& text, const StudyPlace& place) {
  const std::string name = text.word(place, "entity");
  if (!name.empty()) return name;
  const studies::StudyValue list = text.value(place, "entities");
  const auto* names = std::get_if<std::vector<std::string>>(&list);
  return names != nullptr && !names->empty() ? names->front() : std::string();
}

std::optional<dvec3> directionOf(const studies::StudyText& text, const StudyPlace& place) {
  const studies::StudyValue value = text.value(place, "direction");
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (numbers == nullptr || numbers->size() != 3) return std::nullopt;
  const dvec3 along((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  return glm::length(along) > 0.0 ? std::optional(glm::normalize(along)) : std::nullopt;
}

/// By an entity of its name, else by the first in a folder of its name.
const workcell::Entity* standingAt(const workcell::DocumentState& cell, const std::string& name) {
  if (const workcell::Entity* entity = cell.findByName(name)) return entity;
  for (const auto& entity : cell.entities)
    if (entity->parent == name) return entity.get();
  return nullptr;
}

Places placesOf(const ResultTable& table, const workcell::DocumentState& cell) {
  Places places;
  const auto text = studies::StudyText::parse(table.head().study, "");
  if (!text) return places;
  for (std::size_t i = 0; i < text->count("vary"); ++i) {
    const StudyPlace place{"vary", i};
    const std::string what = text->word(place, "what"), name = text->word(place, "name");
    const workcell::Entity* entity = standingAt(cell, entityOf(*text, place));
    const int column = table.columnNamed(name.empty() ? what : name);
    if (entity == nullptr || column < 0) continue;
    int axis = -1;
    double base = 0.0;
    const auto slanted = what == "position" ? directionOf(*text, place) : std::nullopt;
    if (slanted) {
      // Along the floor or upright; other directions have no plane of their own.
      const bool level = std::abs(slanted->z) < kLevel, upright = std::abs(slanted->z) > 1.0 - kLevel;
      if (!level && !upright) continue;
      axis = level ? 0 : 2;
      if (level) places.yaw = std::atan2(slanted->y, slanted->x);
    } else if (what == "position") {
      axis = static_cast<int>(std::string("xyz").find(text->word(place, "axis")));
      const studies::StudyValue absolute = text->value(place, "absolute");
      const auto* yes = std::get_if<bool>(&absolute);
      // From the place in the given cell.
      if (axis >= 0 && axis < 3 && yes != nullptr && *yes) base = -entity->X_WE.p[axis];
    } else if (what == "size" && text->word(place, "size") == "height") {
      axis = 2;
      base = -entity->X_WE.p.z;
    }
    if (axis < 0 || axis > 2 || places.has(axis)) continue;
    // What moves along the floor is where the map stands; a height alone is at its part.
    if (places.axes.empty() || (what == "position" && !places.has(0) && !places.has(1))) places.origin_W = entity->X_WE.p;
    places.axes.push_back({axis, column, base});
  }
  return places;
}

/// How far apart neighbours are along an axis.
double cellSize(std::set<double> values, std::size_t variants) {
  if (values.size() < 2) return kSingle;
  const double extent = *values.rbegin() - *values.begin();
  if (values.size() > kMostOfGrid) return extent / std::max(1.0, std::sqrt(static_cast<double>(variants)));
  double least = extent;
  for (auto at = std::next(values.begin()); at != values.end(); ++at) least = std::min(least, *at - *std::prev(at));
  return std::max(least, extent / static_cast<double>(kMostOfGrid));
}

/// Of two variants at one place the better one: feasible, then by the value, then by the number.
bool isBetter(const MapCell& a, const MapCell& b, bool greater) {
  const auto rank = [greater](const MapCell& cell) {
    const double value = (greater ? -1.0 : 1.0) * cell.value.value_or(0.0);
    return std::tuple(!cell.feasible, !cell.value.has_value(), value, cell.number);
  };
  return rank(a) < rank(b);
}

void measure(VariantMap& map) {
  const bool any = std::any_of(map.cells.begin(), map.cells.end(), [](const auto& c) { return c.feasible && c.value; });
  bool first = true;
  for (const MapCell& cell : map.cells) {
    if (!cell.value || (any && !cell.feasible)) continue;
    map.least = first ? *cell.value : std::min(map.least, *cell.value);
    map.greatest = first ? *cell.value : std::max(map.greatest, *cell.value);
    first = false;
  }
}

std::array<float, 3> rgb(const QColor& color) {
  return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()), static_cast<float>(color.blueF())};
}

}  // namespace

QColor heatColor(double share) {
  // Five colours of viridis (Smith and van der Walt 2015), which are told apart by everybody and in grey.
  static const std::array<QColor, 5> kColors{QColor("#440154"), QColor("#3b528b"), QColor("#21918c"), QColor("#5ec962"),
                                             QColor("#fde725")};
  const double at = std::clamp(share, 0.0, 1.0) * 4.0;
  const auto low = static_cast<std::size_t>(std::min(3.0, std::floor(at)));
  const double part = at - static_cast<double>(low);
  const auto mixed = [&](int a, int b) { return static_cast<int>(std::lround(a + part * (b - a))); };
  const QColor &from = kColors[low], &to = kColors[low + 1];
  return {mixed(from.red(), to.red()), mixed(from.green(), to.green()), mixed(from.blue(), to.blue())};
}

std::optional<double> VariantMap::shareOf(const MapCell& cell) const {
  if (!cell.value) return std::nullopt;
  if (greatest <= least) return 1.0;
  const double share = (*cell.value - least) / (greatest - least);
  return greater_is_better ? share : 1.0 - share;
}

const MapCell* VariantMap::at(const dvec3& p_W) const {
  for (const MapCell& cell : cells) {
    const dvec3 off = glm::abs(turned(-yaw, p_W - cell.p_W)) - 0.5 * size;
    if (off.x <= 0.0 && off.y <= 0.0 && off.z <= kAboveFloor) return &cell;
  }
  return nullptr;
}

std::vector<RenderItem> VariantMap::items() const {
  if (cells.empty()) return {};
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(geometry::makeBox(size));
  std::vector<RenderItem> items;
  for (const MapCell& cell : cells) {
    RenderItem item;
    item.mesh = mesh;
    item.X_WM = Pose(cell.p_W, glm::angleAxis(yaw, dvec3(0.0, 0.0, 1.0)));
    const auto share = shareOf(cell);
    item.color = rgb(cell.feasible && share ? heatColor(*share) : QColor("#7a7f85"));
    item.pattern = cell.feasible ? 0 : 1;
    item.casts_shadow = false;
    items.push_back(std::move(item));
  }
  return items;
}

VariantMap mapOf(const ResultTable& table, const workcell::DocumentState& cell, int column) {
  VariantMap map;
  const Places places = placesOf(table, cell);
  if (places.axes.empty() || table.isEmpty()) return map;
  const bool on_floor = !places.has(2);
  map.greater_is_better = table.isGreaterBetter(column).value_or(true);
  std::map<std::tuple<double, double, double>, MapCell> best;
  std::array<std::set<double>, 3> values;
  for (std::size_t row = 0; row < table.rows().size(); ++row) {
    MapCell one;
    one.number = table.rows()[row].number;
    one.feasible = table.rows()[row].feasible;
    one.value = table.number(row, column);
    dvec3 away(0.0);
    for (const MapAxis& axis : places.axes) {
      const double value = table.number(row, axis.column).value_or(0.0);
      away[axis.axis] = axis.base + value;
      values[static_cast<std::size_t>(axis.axis)].insert(value);
    }
    one.p_W = places.origin_W + turned(places.yaw, away);
    if (on_floor) one.p_W.z = kAboveFloor;
    const auto key = std::tuple(one.p_W.x, one.p_W.y, one.p_W.z);
    const auto there = best.find(key);
    if (there == best.end()) {
      best.emplace(key, one);
    } else if (isBetter(one, there->second, map.greater_is_better)) {
      there->second = one;
    }
  }
  map.yaw = places.yaw;
  map.size = dvec3(kSingle);
  if (on_floor) map.size.z = kThickness;
  for (const MapAxis& axis : places.axes)
    map.size[axis.axis] = kFilled * cellSize(values[static_cast<std::size_t>(axis.axis)], best.size());
  // Upright at the station: thin across.
  if (!on_floor) map.size[places.has(0) ? 1 : 0] = kThickness;
  for (const auto& entry : best) map.cells.push_back(entry.second);
  measure(map);
  return map;
}

}  // namespace hapticell::app
