// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_tidier.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "workcell/scenes/sdf_files.h"
#include "workcell/scenes/sdf_population.h"
#include "workcell/scenes/sdf_values.h"
#include "workcell/text/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

constexpr int kNewestMinor = 9;  // Of SDF 1.x that the library reads.
constexpr int kOldestListed = 4;
// Files within files: guards against circles. Half, twice: no effect on real files.
constexpr int kFilesDeep = 20;
// Guards time: elements with all that is included. Half, twice: other files are refused with a message.
constexpr std::size_t kMostElements = 200'000;

int minorOf(const TiXmlElement& root) {
  int minor = -1;
  return std::sscanf(attributeOf(root, "version").c_str(), "1.%d", &minor) == 1 ? minor : -1;
}

/// What a place is called in a warning: the nearest name from the element upwards.
Text nameFor(const TiXmlElement* element) {
  for (; element; element = element->Parent() ? element->Parent()->ToElement() : nullptr) {
    const std::string own = attributeOf(*element, "name");
    if (!own.empty()) return Text("'" + own + "'");
    if (const std::string named = textOf(element, "name"); !named.empty()) return Text("'" + named + "'");
  }
  return Text("the file");
}

/// True where the text means the same in all versions from 1.4: no joints, no frames in the manner of 1.6, no names
/// that stand for models inside models.
bool isPlain(const TiXmlElement& element) {
  if (element.ValueStr() == "joint" || element.Attribute("frame")) return false;
  if (attributeOf(element, "name").find("::") != std::string::npos) return false;
  for (const TiXmlElement* child = element.FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (!isPlain(*child)) return false;
  }
  return true;
}

/// The model itself where an <include> names it, with that one's name and place: the library takes a tenth of a second
/// for each file that it reads.
void putInPlace(TiXmlElement& parent, TiXmlElement& include, const TiXmlElement& model, const std::string& name) {
  TiXmlElement* const own = parent.InsertBeforeChild(&include, model)->ToElement();
  own->SetAttribute("name", name);
  const TiXmlElement* const pose = include.FirstChildElement("pose");
  if (pose) {
    while (TiXmlElement* known = own->FirstChildElement("pose")) own->RemoveChild(known);
    own->InsertEndChild(*pose);
  }
  if (const std::string frame = textOf(&include, "placement_frame"); !frame.empty()) {
    own->SetAttribute("placement_frame", frame);
  }
}

}  // namespace

Expected<std::string> SdfTidier::tidy(const fs::path& file) {
  TiXmlDocument document;
  const auto root = parseSdf(file, document);
  HAPTICELL_TRY(root);
  open_.insert(fs::absolute(file).lexically_normal().string());
  const Place place = placeOf(**root, {file, 0, false});
  arrangeTop(**root, place);
  tidyChildren(**root, place);
  if (refused_) return makeError(*refused_);
  TiXmlPrinter printer;
  printer.SetStreamPrinting();
  (*root)->Accept(&printer);
  return printer.Str();
}

std::pair<int, std::vector<Text>> SdfTidier::listed(const std::map<std::string, Missing>& missing) {
  std::pair<int, std::vector<Text>> all;
  for (const auto& [name, one] : missing) {
    all.first += one.times;
    all.second.push_back(one.times > 1 ? Text("%1 (%2 times)", one.shown, one.times) : one.shown);
  }
  return all;
}

std::vector<Text> SdfTidier::warnings() const {
  std::vector<Text> all = told_;
  report_.tell(all);
  if (auto [count, names] = listed(missing_models_); count > 0)
    all.push_back(Text("%1 models were not found and are left out: %2", count, std::move(names)));
  if (auto [count, names] = listed(missing_meshes_); count > 0)
    all.push_back(Text("%1 meshes were not found and are left out: %2", count, std::move(names)));
  return all;
}

/// Sets a version that the library reads.
SdfTidier::Place SdfTidier::placeOf(TiXmlElement& root, const Place& place) {
  const int minor = minorOf(root);
  if (minor < 0 && attributeOf(root, "version").empty()) root.SetAttribute("version", "1.6");
  if (minor > kNewestMinor) root.SetAttribute("version", "1.9");
  return {place.file, place.depth, minor >= 0 && minor < kOldestListed};
}

/// One world, or one model without a world.
void SdfTidier::arrangeTop(TiXmlElement& root, const Place& place) {
  int models = 0, includes = 0, worlds = 0;
  for (TiXmlElement* child = root.FirstChildElement(); child;) {
    TiXmlElement* const next = child->NextSiblingElement();
    models += child->ValueStr() == "model" ? 1 : 0;
    includes += child->ValueStr() == "include" ? 1 : 0;
    if (child->ValueStr() == "world" && worlds++ > 0) {
      tell(*child, place, Text("a second world is left out"));
      root.RemoveChild(child);
    }
    child = next;
  }
  if (worlds > 0 || (models == 1 && includes == 0) || models + includes == 0) return;
  auto* const world = new TiXmlElement("world");  // The root owns it.
  world->SetAttribute("name", "world_of_models");
  for (TiXmlElement* child = root.FirstChildElement(); child;) {
    TiXmlElement* const next = child->NextSiblingElement();
    world->InsertEndChild(*child);
    root.RemoveChild(child);
    child = next;
  }
  root.LinkEndChild(world);
}

void SdfTidier::tell(const TiXmlElement& of, const Place& place, Text what) {
  told_.push_back(place.depth > 0 ? Text("%1 (%2): %3", nameFor(&of), place.file.filename().string(), std::move(what))
                                  : Text("%1: %2", nameFor(&of), std::move(what)));
}

void SdfTidier::tidyChildren(TiXmlElement& parent, const Place& place) {
  Names names;
  for (TiXmlElement* child = parent.FirstChildElement(); child;) {
    TiXmlElement* const next = child->NextSiblingElement();
    if (!keep(parent, *child, names, place)) parent.RemoveChild(child);
    child = next;
  }
  const bool empty = parent.ValueStr() == "model" && !parent.FirstChildElement("link") &&
                     !parent.FirstChildElement("model") && !parent.FirstChildElement("include");
  if (!empty) return;
  auto* const link = new TiXmlElement("link");  // The model owns it.
  link->SetAttribute("name", kNoLink);
  parent.LinkEndChild(link);
}

std::string SdfTidier::Siblings::own(const std::string& wanted) {
  if (names.insert(wanted).second) return wanted;
  int& number = last.try_emplace(wanted, 1).first->second;
  std::string name;
  do {
    name = wanted + "_" + std::to_string(++number);
  } while (!names.insert(name).second);
  return name;
}

bool SdfTidier::count(std::size_t elements, const Place& place) {
  elements_ += elements;
  if (elements_ > kMostElements && !refused_)
    refused_ =
        Error{.file = place.file.string(),
              .found = "more than 200 000 elements, including all included files",
              .expected = "fewer",
              .fix = "Check for models that include each other several times, or split the world into several files."};
  return !refused_;
}

bool SdfTidier::keep(TiXmlElement& parent, TiXmlElement& child, Names& names, const Place& place) {
  if (!count(1, place)) return false;
  const std::string kind = child.ValueStr(), element = parent.ValueStr() + "/" + kind;
  if (!place.lenient || report_.rule(element)) {
    const Text name = nameFor(&child);
    const Text where = place.depth == 0 ? Text("%1 in line %2", name, child.Row()) : name;
    if (report_.meet(element, where) != Treatment::kUsed) return false;
  }
  if (kind == "include") return keepInclude(parent, child, names, place);
  if (kind == "population") {
    settle(parent, child, names, place);
    return false;
  }
  static const std::set<std::string> kNamed = {"model", "link", "joint", "frame", "visual", "collision", "world"};
  if (kNamed.contains(kind)) giveName(child, names, place);
  return keepByKind(parent, child, place);
}

bool SdfTidier::keepByKind(TiXmlElement& parent, TiXmlElement& child, const Place& place) {
  const std::string kind = child.ValueStr();
  const TellSdf say = [&](Text what) { tell(parent, place, std::move(what)); };
  if (kind == "pose") return keepSdfPose(child, say);
  if (sdfNumbersOf(kind) > 0 && !child.FirstChildElement()) return keepSdfNumbers(child, say);
  if (kind == "center" || kind == "use_parent_model_frame") return keepSdfWord(child);
  if (kind == "mesh" && parent.ValueStr() == "geometry") {
    tidyChildren(child, place);
    return keepMesh(child, place);
  }
  tidyChildren(child, place);
  if (kind == "geometry") return keepSdfShape(child, say);
  const bool shape = kind == "visual" || kind == "collision";
  return !shape || child.FirstChildElement("geometry") != nullptr;
}

/// Every sibling has a name, and its own.
void SdfTidier::giveName(TiXmlElement& element, Names& names, const Place& place) {
  const std::string kind = element.ValueStr();
  const std::string written = attributeOf(element, "name");
  std::string wanted = written.empty() ? kind : written;
  for (std::size_t at = wanted.find("::"); at != std::string::npos && !place.lenient; at = wanted.find("::")) {
    const TiXmlElement* root = element.GetDocument() ? element.GetDocument()->RootElement() : nullptr;
    if (root && minorOf(*root) < 8) break;  // Older files write models inside models so; the library takes them apart.
    wanted.replace(at, 2, "_");
  }
  if ((wanted == "world" && kind != "world") || (wanted.starts_with("__") && wanted.ends_with("__"))) wanted += "_";
  const std::string name = names[kind].own(wanted);
  if (name == written) return;
  if (!written.empty()) {
    tell(element, place, Text("the name is used twice or not allowed; this <%1> is renamed '%2'", kind, name));
  }
  element.SetAttribute("name", name);
}

bool SdfTidier::keepInclude(TiXmlElement& parent, TiXmlElement& include, Names& names, const Place& place) {
  const std::string uri = textOf(&include, "uri");
  const fs::path file = findSdfModel(uri, place.file);
  const Taken taken = file.empty() ? Taken{} : take(file, place);
  if (taken.file.empty()) {
    Missing& missing = missing_models_[uri + english(taken.why)];
    missing.shown = taken.why.empty() ? Text(uri) : Text("%1 (%2)", uri, taken.why);
    ++missing.times;
    return false;
  }
  if (!count(taken.elements, place)) return false;
  tidyChildren(include, place);
  TiXmlElement* name = include.FirstChildElement("name");
  if (!name) name = include.InsertEndChild(TiXmlElement("name"))->ToElement();
  const std::string written = textOf(*name), wanted = written.empty() ? taken.name : written;
  const std::string own = names["model"].own(wanted);
  if (own != wanted && !written.empty()) tell(include, place, Text("the name is used twice; it is renamed '%1'", own));
  setText(*name, own);
  setText(*include.FirstChildElement("uri"), taken.file.string());
  if (include.FirstChildElement("placement_frame") && !include.FirstChildElement("pose")) {
    include.InsertEndChild(TiXmlElement("pose"));
  }
  if (!taken.model || !attributeOf(include, "merge").empty()) return true;
  putInPlace(parent, include, *taken.model, own);
  return false;
}

const SdfTidier::Taken& SdfTidier::take(const fs::path& file, const Place& place) {
  const std::string key = fs::absolute(file).lexically_normal().string();
  if (const auto known = taken_.find(key); known != taken_.end()) return known->second;
  static const Taken kLoop{{}, {}, Text("it includes itself"), nullptr, 0};
  if (place.depth >= kFilesDeep || open_.contains(key)) return kLoop;
  Taken taken;
  TiXmlDocument document;
  const auto root = parseSdf(file, document);
  TiXmlElement* const model = root ? (*root)->FirstChildElement("model") : nullptr;
  if (!model) {
    taken.why = root ? Text("it has no model") : root.error().found;
    return taken_[key] = taken;
  }
  open_.insert(key);
  for (TiXmlElement* child = (*root)->FirstChildElement(); child;) {
    TiXmlElement* const next = child->NextSiblingElement();
    if (child != model) (*root)->RemoveChild(child);
    child = next;
  }
  const Place inside = placeOf(**root, {file, place.depth + 1, false});
  const std::size_t before = std::exchange(elements_, 0);
  tidyChildren(**root, inside);
  taken.elements = std::exchange(elements_, before);
  open_.erase(key);
  taken.name = attributeOf(*model, "name");
  if (!inside.lenient && isPlain(*model)) taken.model = std::make_shared<TiXmlElement>(*model);
  taken.file = folder_ / (std::to_string(taken_.size()) + ".sdf");
  TiXmlPrinter printer;
  printer.SetStreamPrinting();
  (*root)->Accept(&printer);
  if (!writeFileAtomically(taken.file, printer.Str(), {.durable = false}))
    taken = {{}, {}, Text("no free space for a copy"), nullptr, 0};
  return taken_[key] = taken;
}

bool SdfTidier::keepMesh(TiXmlElement& mesh, const Place& place) {
  const std::string uri = textOf(&mesh, "uri");
  const auto found = findSdfFile(uri, place.file);
  const fs::path file = found ? found->path : fs::path();
  std::error_code ignored;
  if (file.empty() || !fs::is_regular_file(file, ignored)) {
    Missing& missing = missing_meshes_[uri];
    missing.shown = uri.empty() ? Text("a mesh without <uri>") : Text(uri);
    ++missing.times;
    return false;
  }
  if (!found->taken_for_package.empty() && taken_packages_.insert(found->taken_for_package).second)
    tell(mesh, place, takenForPackage(uri, *found));
  const std::vector<double> scale = numbersIn(textOf(&mesh, "scale"));
  if (std::find(scale.begin(), scale.end(), 0.0) != scale.end()) {
    tell(mesh, place, Text("the mesh %1 is left out: a scale of 0", uri));
    return false;
  }
  const auto [number, is_new] = mesh_numbers_.try_emplace(uri + "|" + file.string(), static_cast<int>(meshes_.size()));
  if (is_new) meshes_.push_back({uri, file});
  setText(*mesh.FirstChildElement("uri"), std::to_string(number->second));
  return true;
}

/// Puts the models of a population where Gazebo does.
void SdfTidier::settle(TiXmlElement& world, TiXmlElement& population, Names& names, const Place& place) {
  const Population settled = populationOf(population);
  if (!settled.remark.empty()) tell(population, place, settled.remark);
  const TiXmlElement* source = population.FirstChildElement("model");
  if (!source) source = population.FirstChildElement("include");
  for (std::size_t k = 0; source && !refused_ && k < settled.positions.size(); ++k) {
    TiXmlElement* const clone = world.InsertBeforeChild(&population, *source)->ToElement();
    const std::string name = attributeOf(*source, "name") + "_clone_" + std::to_string(k);
    while (TiXmlElement* pose = clone->FirstChildElement("pose")) clone->RemoveChild(pose);
    TiXmlElement pose("pose");
    const dvec3& p = settled.positions[k];
    setText(pose, sdfTextOf({p.x, p.y, p.z, 0, 0, 0}));
    clone->InsertEndChild(pose);
    if (source->ValueStr() == "model") clone->SetAttribute("name", name);
    if (!keep(world, *clone, names, place)) world.RemoveChild(clone);
  }
}

}  // namespace hapticell::workcell
