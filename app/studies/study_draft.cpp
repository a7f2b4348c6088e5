// SPDX-License-Identifier: Apache-2.0
#include "app/studies/study_draft.h"

#include <QFileInfo>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "app/studies/study_fields.h"
#include "geometry/system/atomic_file.h"
#include "geometry/system/regular_file.h"
#include "mannequin/shape/figure_model.h"
#include "studies/document/study_document.h"
#include "studies/workplace/workplace_text.h"

namespace hapticell::app {

namespace fs = std::filesystem;
using studies::StudyPlace;
using studies::StudyValue;

namespace {

/// Bytes, as StudyDocument reads them. Half: still ten thousand lines; twice: what it refuses.
constexpr std::uintmax_t kLargestStudy = 1'000'000;
/// m to each side, and places along it, of a rectangle that begins: what stands on a floor's free place. Half: is soon
/// dragged larger; twice: reaches into the neighbours.
constexpr double kFirstHalf = 0.5;
constexpr double kFirstSteps = 7.0;
/// m: as fine as a pointer shows. Half and twice: more or fewer digits in the document.
constexpr double kRounding = 0.001;

double roundedLength(double metres) {
  return std::round(metres / kRounding) * kRounding;
}

std::optional<double> numberAt(const studies::StudyText& text, const StudyPlace& place, const char* key) {
  const StudyValue value = text.value(place, key);
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

bool isYes(const studies::StudyText& text, const StudyPlace& place, const char* key) {
  const StudyValue value = text.value(place, key);
  const auto* yes = std::get_if<bool>(&value);
  return yes != nullptr && *yes;
}

/// A word that may be a name in a study.
std::string nameFrom(const std::string& words) {
  std::string name;
  for (const char c : words) {
    const bool good = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    name += good ? c : '_';
  }
  return name.substr(0, 40);
}

/// A path as a study in `folder` names it: relative where it lies below.
std::string namedFrom(const fs::path& folder, const fs::path& file) {
  const fs::path relative = file.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return below ? relative.generic_string() : file.generic_string();
}

}  // namespace

QString StudyDraft::title() const {
  return file_.isEmpty() ? tr("New study") : QFileInfo(file_).completeBaseName();
}

QString StudyDraft::cell() const {
  if (file_.isEmpty()) return cell_;
  const std::string named = text_.word({}, "cell");
  if (named.empty()) return {};
  return QString::fromStdString((fs::path(file_.toStdString()).parent_path() / named).lexically_normal().string());
}

std::optional<Error> StudyDraft::fault() const {
  const auto read = studies::StudyDocument::parse(text_.text(), file_.isEmpty() ? "new.hstudy" : file_.toStdString());
  if (read) return std::nullopt;
  Error error = read.error();
  error.file.clear();  // The one that is shown.
  return error;
}

void StudyDraft::begin(const QString& cell) {
  text_ = {};
  file_.clear();
  cell_ = cell;
  changed_ = false;
  // Only the name: where the study will lie is not known before it is saved.
  take(text_.set({}, "cell", fs::path(cell.toStdString()).filename().string()));
}

Expected<void> StudyDraft::open(const QString& file) {
  auto text = geometry::readRegularFile(file.toStdString(), kLargestStudy);
  HAPTICELL_TRY(text);
  auto read = studies::StudyText::parse(std::move(*text), file.toStdString());
  HAPTICELL_TRY(read);
  text_ = std::move(*read);
  file_ = QFileInfo(file).absoluteFilePath();
  cell_.clear();
  changed_ = false;
  emit changed();
  return {};
}

Expected<void> StudyDraft::save(const QString& file) {
  const QString target = QFileInfo(file).absoluteFilePath();
  studies::StudyText text = text_;
  if (target != file_) {
    // What it names lies where it lay; only its own folder is another one.
    const fs::path from = file_.isEmpty() ? fs::path(cell_.toStdString()).parent_path()
                                          : fs::path(file_.toStdString()).parent_path();
    const fs::path to = fs::path(target.toStdString()).parent_path();
    const auto move = [&](const StudyPlace& place, const char* key) -> Expected<void> {
      const std::string named = text.word(place, key);
      if (named.empty() || fs::path(named).is_absolute()) return {};
      return text.set(place, key, namedFrom(to, (from / named).lexically_normal()));
    };
    HAPTICELL_TRY(move({}, "cell"));
    for (std::size_t i = 0; i < text.count("ask"); ++i) {
      HAPTICELL_TRY(move({"ask", i}, "targets"));
    }
  }
  HAPTICELL_TRY(writeFileAtomically(target.toStdString(), text.text()));
  text_ = std::move(text);
  file_ = target;
  changed_ = false;
  emit changed();
  return {};
}

void StudyDraft::clear() {
  text_ = {};
  file_.clear();
  cell_.clear();
  changed_ = false;
  emit changed();
}

void StudyDraft::take(const Expected<void>& done) {
  if (!done) {
    emit refused(done.error());
  } else {
    changed_ = true;
  }
  emit changed();
}

void StudyDraft::set(const StudyPlace& place, const char* key, const StudyValue& value) {
  setAll(place, {{key, value}});
}

void StudyDraft::setAll(const StudyPlace& place, const std::vector<std::pair<const char*, StudyValue>>& values) {
  studies::StudyText text = text_;
  for (const auto& [key, value] : values) {
    const auto done = text.set(place, key, value);
    if (!done) return take(done);
  }
  if (text.text() == text_.text()) return;
  text_ = std::move(text);
  take({});
}

std::size_t StudyDraft::add(const std::string& table, const std::vector<std::pair<std::string, StudyValue>>& keys) {
  take(text_.add(table, keys));
  return text_.count(table) - 1;
}

void StudyDraft::remove(const StudyPlace& place) {
  take(text_.remove(place));
}

void StudyDraft::addFloorRange(const std::string& entity) {
  studies::StudyText text = text_;
  for (const char* axis : {"x", "y"}) {
    const auto done = text.add("vary", {{"what", std::string("position")},
                                        {"name", freeName("vary", nameFrom(entity) + "_" + axis)},
                                        {"entity", entity},
                                        {"axis", std::string(axis)},
                                        {"from", -kFirstHalf},
                                        {"to", kFirstHalf},
                                        {"steps", kFirstSteps}});
    if (!done) return take(done);
  }
  text_ = std::move(text);
  take({});
}

void StudyDraft::addWorkplace(const workcell::Entity& mannequin, const std::vector<std::string>& station) {
  const auto posture = mannequin::toPosture(*mannequin.figure(), {mannequin.X_WE, mannequin.joints()});
  const dvec3 ahead = posture.X_WR.rotate({1.0, 0.0, 0.0});
  const dvec3 level = glm::normalize(dvec3(ahead.x, ahead.y, 0.0));
  studies::WorkplaceTables tables;
  tables.mannequin = mannequin.name;
  tables.station = station;
  tables.ahead_W = level;
  tables.height = {{"from", -0.2}, {"to", 0.2}, {"steps", 11.0}};
  tables.distance = {{"from", -0.16}, {"to", 0.16}, {"steps", 9.0}};
  tables.methods = {"rula", "comfort"};
  studies::StudyText text = text_;
  const auto done = studies::addWorkplaceTables(
      text, tables,
      {freeName("vary", "stance"), freeName("vary", "height"), freeName("vary", "distance"), freeName("ask", "posture")});
  if (done) text_ = std::move(text);
  take(done);
}

std::string StudyDraft::method() const {
  if (text_.count("search") > 0) return "search";
  const std::string method = text_.word({"sampling", 0}, "method");
  return method.empty() ? "grid" : method;
}

void StudyDraft::setMethod(const std::string& method) {
  if (method == this->method()) return;
  studies::StudyText text = text_;
  const auto change = [&]() -> Expected<void> {
    for (const char* table : {"sampling", "search"}) {
      if (text.count(table) == 0) continue;
      HAPTICELL_TRY(text.remove({table, 0}));
    }
    if (method == "search") return text.set({"search", 0}, "method", std::string("nelder-mead"));
    if (method == "grid") return {};
    HAPTICELL_TRY(text.set({"sampling", 0}, "method", method));
    if (method != "list") HAPTICELL_TRY(text.set({"sampling", 0}, "samples", 100.0));
    return {};
  };
  const auto done = change();
  if (done) text_ = std::move(text);
  take(done);
}

std::vector<FloorRange> StudyDraft::floorRanges(const workcell::DocumentState& cell) const {
  std::vector<FloorRange> ranges;
  const std::size_t count = text_.count("vary");
  const auto axisOf = [&](std::size_t i) {
    const StudyPlace place{"vary", i};
    const bool ranged = numberAt(text_, place, "from") && numberAt(text_, place, "to");
    return text_.word(place, "what") == "position" && ranged ? text_.word(place, "axis") : std::string();
  };
  for (std::size_t x = 0; x < count; ++x) {
    if (axisOf(x) != "x") continue;
    const std::string name = text_.word({"vary", x}, "entity");
    const workcell::Entity* entity = cell.findByName(name);
    for (std::size_t y = 0; entity != nullptr && y < count; ++y) {
      if (axisOf(y) != "y" || text_.word({"vary", y}, "entity") != name) continue;
      const auto ends = [&](std::size_t i, double base) {
        const double from = isYes(text_, {"vary", i}, "absolute") ? 0.0 : base;
        return std::pair(from + *numberAt(text_, {"vary", i}, "from"), from + *numberAt(text_, {"vary", i}, "to"));
      };
      const auto along_x = ends(x, entity->X_WE.p.x), along_y = ends(y, entity->X_WE.p.y);
      ranges.push_back({name, x, y, along_x.first, along_x.second, along_y.first, along_y.second});
      break;
    }
  }
  return ranges;
}

void StudyDraft::setFloorRange(const FloorRange& range, const workcell::DocumentState& cell) {
  const workcell::Entity* entity = cell.findByName(range.entity);
  if (entity == nullptr) return;
  studies::StudyText text = text_;
  const auto write = [&](std::size_t i, double base, double from, double to) -> Expected<void> {
    const StudyPlace place{"vary", i};
    const double zero = isYes(text_, place, "absolute") ? 0.0 : base;
    HAPTICELL_TRY(text.set(place, "from", roundedLength(from - zero)));
    return text.set(place, "to", roundedLength(to - zero));
  };
  const auto along_x = write(range.x, entity->X_WE.p.x, range.x_from, range.x_to);
  const auto along_y = write(range.y, entity->X_WE.p.y, range.y_from, range.y_to);
  if (!along_x || !along_y) return take(along_x ? along_y : along_x);
  if (text.text() == text_.text()) return;
  text_ = std::move(text);
  take({});
}

std::string StudyDraft::nameOf(const StudyPlace& place) const {
  const std::string name = text_.word(place, "name");
  return name.empty() ? text_.word(place, "what") : name;
}

std::vector<std::string> StudyDraft::resultNames() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text_.count("ask"); ++i) {
    const StudyPlace place{"ask", i};
    const StudyKind* kind = studyKind("ask", text_.word(place, "what"));
    if (kind == nullptr) continue;
    for (const char* column : kind->columns) names.push_back(nameOf(place) + "." + column);
    if (std::string("posture") != kind->name) continue;
    const StudyValue methods = text_.value(place, "methods");
    const auto* chosen = std::get_if<std::vector<std::string>>(&methods);
    // Those of a question without the key: all but the last.
    for (const char* method : postureMethods().first(postureMethods().size() - (chosen != nullptr ? 0 : 1))) {
      const bool asked = chosen == nullptr || std::find(chosen->begin(), chosen->end(), method) != chosen->end();
      if (asked) names.push_back(nameOf(place) + "." + method);
    }
  }
  return names;
}

std::vector<std::string> StudyDraft::unknownKeys(const StudyPlace& place) const {
  std::vector<std::string> unknown;
  const StudyKind* kind = studyKind(place.table, text_.word(place, "what"));
  for (const std::string& key : text_.keys(place)) {
    if (key == "what" || key == "name") continue;
    const auto isKnown = [&](const StudyField& field) {
      if (field.edit != StudyEdit::kRange) return key == field.key;
      return std::any_of(rangeKeys().begin(), rangeKeys().end(), [&](const char* one) { return key == one; });
    };
    if (kind != nullptr && std::any_of(kind->fields.begin(), kind->fields.end(), isKnown)) continue;
    unknown.push_back(key);
  }
  return unknown;
}

std::string StudyDraft::freeName(const std::string& table, const std::string& wanted) const {
  const auto isTaken = [&](const std::string& name) {
    for (std::size_t i = 0; i < text_.count(table); ++i) {
      if (nameOf({table, i}) == name) return true;
    }
    return false;
  };
  std::string name = wanted;
  for (int i = 2; isTaken(name); ++i) name = wanted + "_" + std::to_string(i);
  return name;
}

}  // namespace hapticell::app
