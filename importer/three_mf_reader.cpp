// SPDX-License-Identifier: Apache-2.0
#include "importer/three_mf_reader.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <sstream>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/unfolding.h"
#include "importer/damaged_file.h"
#include "importer/model_package.h"
#include "workcell/text/content_rules.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::importer {

namespace {

// Levels of components: guards the stack. Half, twice: no effect on real files.
constexpr int kDeepestComponent = 100;
// Guards time and memory, as kMostNodes of gltf_reader.cpp.
constexpr std::size_t kMostUses = 200'000;

/// A name without the prefix of its namespace.
std::string_view localName(const char* name) {
  const char* const colon = std::strrchr(name, ':');
  return colon ? colon + 1 : name;
}

bool isNamed(const pugi::xml_node& node, std::string_view name) {
  return localName(node.name()) == name;
}

pugi::xml_node childNamed(const pugi::xml_node& parent, std::string_view name) {
  for (const pugi::xml_node child : parent.children()) {
    if (isNamed(child, name)) return child;
  }
  return {};
}

/// Attributes may stand in the namespace of an extension ("p:path").
std::string attributeNamed(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute attribute : node.attributes()) {
    if (localName(attribute.name()) == name) return attribute.value();
  }
  return {};
}

double metresOfUnit(const std::string& unit) {
  static const std::map<std::string, double> kUnits = {{"micron", 1e-6}, {"millimeter", 1e-3}, {"centimeter", 1e-2},
                                                       {"inch", 0.0254}, {"foot", 0.3048},     {"meter", 1.0}};
  const auto found = kUnits.find(unit);
  return found == kUnits.end() ? 0.0 : found->second;
}

std::optional<double> numberOf(const pugi::xml_node& node, const char* name) {
  const std::string text = attributeNamed(node, name);
  const auto number = workcell::parseNumber(std::string_view(text));
  return number && workcell::isUsable(*number) ? number : std::nullopt;
}

/// Twelve numbers, row vectors: x' = x m00 + y m10 + z m20 + m30.
std::optional<aiMatrix4x4> transformOf(const pugi::xml_node& node) {
  const std::string text = attributeNamed(node, "transform");
  if (text.empty()) return aiMatrix4x4();
  std::istringstream words(text);
  std::vector<float> m;
  for (std::string word; words >> word;) {
    const auto number = workcell::parseNumber(word);
    if (!number || !workcell::isUsable(*number)) return std::nullopt;
    m.push_back(static_cast<float>(*number));
  }
  if (m.size() != 12) return std::nullopt;
  return aiMatrix4x4(m[0], m[3], m[6], m[9], m[1], m[4], m[7], m[10], m[2], m[5], m[8], m[11], 0, 0, 0, 1);
}

std::optional<aiColor4D> colorOfText(const std::string& text) {
  if (text.size() < 7 || text[0] != '#') return std::nullopt;
  const auto part = [&](std::size_t at) {
    return static_cast<float>(std::strtoul(text.substr(at, 2).c_str(), nullptr, 16)) / 255.0f;
  };
  return aiColor4D(part(1), part(3), part(5), 1.0f);
}

class ThreeMfReader {
 public:
  explicit ThreeMfReader(ModelPackage package) : package_(std::move(package)), report_("3MF") {}

  Expected<ThreeMfModel> read() {
    const std::string root = rootPart();
    const auto document = part(root);
    HAPTICELL_TRY(document);
    const pugi::xml_node model = childNamed(**document, "model");
    HAPTICELL_TRY(checkRequired(model));
    ThreeMfModel result;
    if (const std::string unit = attributeNamed(model, "unit"); !unit.empty()) {
      result.metres_per_unit = metresOfUnit(unit);
      if (result.metres_per_unit == 0.0) {
        result.metres_per_unit = 1e-3;
        result.model.warnings.push_back(Text("the unit '%1' is not known; millimetres are assumed", unit));
      }
    }
    readSlicerNames();
    std::vector<std::unique_ptr<aiNode>> items;
    const pugi::xml_node build = childNamed(model, "build");
    HAPTICELL_TRY(checkComponents(build, root));
    for (const pugi::xml_node item : build.children()) {
      if (!isNamed(item, "item")) continue;
      auto node = use(item, root, 0);
      HAPTICELL_TRY(node);
      items.push_back(std::move(*node));
    }
    if (items.empty()) return makeError(damagedFile(root, Text("<build> has no <item>"), Text("objects to be built")));
    auto top = newNode("3MF");
    giveChildren(*top, std::move(items));
    if (materials_.empty()) materials_.push_back(std::make_unique<aiMaterial>());
    result.model.scene = std::make_unique<aiScene>();
    fillScene(*result.model.scene, std::move(top), std::move(meshes_), std::move(materials_));
    report_.tell(result.model.warnings);
    return result;
  }

 private:
  using Key = std::pair<std::string, std::string>;  // Part of the package, id in it.

  struct Object {
    std::vector<unsigned> meshes;
    std::string name;
  };

  /// Of the package's relations the model; else the usual name, else the only one.
  std::string rootPart() const {
    if (const auto relations = package_.parts.find("/_rels/.rels"); relations != package_.parts.end()) {
      pugi::xml_document document;
      document.load_string(relations->second.c_str());
      for (const pugi::xml_node relation : document.document_element().children()) {
        if (!std::string(relation.attribute("Type").value()).ends_with("/3dmodel")) continue;
        const std::string target = relation.attribute("Target").value();
        return target.starts_with('/') ? target : "/" + target;
      }
    }
    for (const auto& [name, content] : package_.parts) {
      if (name == "/3D/3dmodel.model") return name;
    }
    for (const auto& [name, content] : package_.parts) {
      if (name.ends_with(".model")) return name;
    }
    return "/3D/3dmodel.model";
  }

  Expected<const pugi::xml_document*> part(const std::string& name) {
    auto& known = documents_[name];
    if (known) return known.get();
    auto content = package_.parts.find(name);
    if (content == package_.parts.end()) {
      return makeError(damagedFile(name, Text("this part is not in the package"), Text("a part of the package")));
    }
    if (auto flat = geometry::checkNesting(content->second, geometry::NestedText::kXml, ""); !flat)
      return makeError(
          damagedFile(Text("%1, %2", name, flat.error().place), flat.error().found, flat.error().expected));
    auto document = std::make_unique<pugi::xml_document>();
    const auto parsed = document->load_buffer(content->second.data(), content->second.size());
    if (!parsed) {
      return makeError(
          damagedFile(Text("%1, byte %2", name, parsed.offset), Text(std::string(parsed.description())), "XML"));
    }
    if (!childNamed(*document, "model")) return makeError(damagedFile(name, Text("no <model>"), Text("a 3MF model")));
    content->second.clear();
    content->second.shrink_to_fit();
    known = std::move(document);
    return known.get();
  }

  Expected<void> checkRequired(const pugi::xml_node& model) {
    std::istringstream words(attributeNamed(model, "requiredextensions"));
    for (std::string prefix; words >> prefix;) {
      const std::string space = model.attribute(("xmlns:" + prefix).c_str()).value();
      std::string name = space;  // ".../production/2015/06": the word before the date.
      for (int k = 0; k < 2 && name.find('/') != std::string::npos; ++k) name.resize(name.rfind('/'));
      name = name.substr(name.rfind('/') + 1);
      const auto* const rule = report_.rule(name);
      using workcell::Treatment;
      if (rule && (rule->treatment == Treatment::kUsed || rule->treatment == Treatment::kNoted)) continue;
      return makeError(
          {.place = "requiredextensions",
           .found = Text("the extension '%1' (%2), which is not supported", name.empty() ? prefix : name, space),
           .expected = "extensions that docs/user/formats.md lists",
           .fix = "Export it without this extension."});
    }
    return {};
  }

  /// BambuStudio, OrcaSlicer and PrusaSlicer keep the objects' names in a file of their own.
  void readSlicerNames() {
    for (const auto& [name, content] : package_.parts) {
      if (!name.ends_with(".config")) continue;
      pugi::xml_document document;
      if (!document.load_string(content.c_str())) continue;
      for (const pugi::xml_node object : document.document_element().children("object")) {
        keepSlicerName(object);
        for (const pugi::xml_node piece : object.children("part")) keepSlicerName(piece);
      }
    }
  }

  void keepSlicerName(const pugi::xml_node& node) {
    for (const pugi::xml_node data : node.children("metadata")) {
      if (std::string(data.attribute("key").value()) != "name") continue;
      slicer_names_.try_emplace(node.attribute("id").value(), data.attribute("value").value());
    }
  }

  static std::string ownerOf(const pugi::xml_node& use, const std::string& in_part) {
    const std::string path = attributeNamed(use, "path");
    if (path.empty()) return in_part;
    return path.starts_with('/') ? path : "/" + path;
  }

  /// What the items unfold to is counted before one of them is made; what is not there is told when it is.
  Expected<void> checkComponents(const pugi::xml_node& build, const std::string& root) {
    std::map<Key, std::uint32_t> numbers;
    std::vector<Key> keys;
    std::vector<std::vector<std::uint32_t>> below;
    const auto numberOfUse = [&](const pugi::xml_node& use, const std::string& in_part) {
      const Key key{ownerOf(use, in_part), attributeNamed(use, "objectid")};
      const auto [known, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(keys.size()));
      if (is_new) keys.push_back(key);
      return known->second;
    };
    std::vector<std::uint32_t> roots;
    for (const pugi::xml_node item : build.children()) {
      if (isNamed(item, "item")) roots.push_back(numberOfUse(item, root));
    }
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const auto [owner, id] = keys[k];
      below.emplace_back();
      const auto document = part(owner);
      if (!document) continue;
      const pugi::xml_node object = objectOf(childNamed(childNamed(**document, "model"), "resources"), owner, id);
      for (const pugi::xml_node component : childNamed(object, "components").children()) {
        if (isNamed(component, "component")) below[k].push_back(numberOfUse(component, owner));
      }
    }
    return geometry::checkUnfolding(below, roots, {kDeepestComponent, kMostUses}, [&](std::uint32_t number) {
      return Text("%1, object %2", keys[number].first, keys[number].second);
    });
  }

  /// An <item> or <component>: an object, placed.
  Expected<std::unique_ptr<aiNode>> use(const pugi::xml_node& source, const std::string& in_part, int depth) {
    const std::string id = attributeNamed(source, "objectid"), owner = ownerOf(source, in_part);
    const Text place("%1, object %2", owner, id);
    if (depth > kDeepestComponent)
      return makeError(
          damagedFile(place, Text("components that contain each other"), Text("components without cycles")));
    const auto document = part(owner);
    HAPTICELL_TRY(document);
    const pugi::xml_node resources = childNamed(childNamed(**document, "model"), "resources");
    const pugi::xml_node object = objectOf(resources, owner, id);
    if (!object)
      return makeError(damagedFile(place, Text("an object that does not exist"), Text("an object of this part")));
    const auto matrix = transformOf(source);
    if (!matrix) return makeError(damagedFile(place, Text("an invalid transform"), Text("12 numbers")));
    auto made = shapeOf(object, resources, {owner, id});
    HAPTICELL_TRY(made);
    auto node = newNode((*made)->name);
    node->mTransformation = *matrix;
    node->mNumMeshes = static_cast<unsigned>((*made)->meshes.size());
    if (node->mNumMeshes > 0) {
      node->mMeshes = new unsigned[node->mNumMeshes];
      std::copy((*made)->meshes.begin(), (*made)->meshes.end(), node->mMeshes);
    }
    std::vector<std::unique_ptr<aiNode>> parts;
    for (const pugi::xml_node component : childNamed(object, "components").children()) {
      if (!isNamed(component, "component")) continue;
      auto below = use(component, owner, depth + 1);
      HAPTICELL_TRY(below);
      parts.push_back(std::move(*below));
    }
    giveChildren(*node, std::move(parts));
    return node;
  }

  pugi::xml_node objectOf(const pugi::xml_node& resources, const std::string& owner, const std::string& id) {
    auto [known, is_new] = objects_of_.try_emplace(owner);
    if (is_new) {
      for (const pugi::xml_node child : resources.children()) {
        if (isNamed(child, "object")) known->second.try_emplace(attributeNamed(child, "id"), child);
      }
    }
    const auto found = known->second.find(id);
    return found == known->second.end() ? pugi::xml_node() : found->second;
  }

  Expected<const Object*> shapeOf(const pugi::xml_node& object, const pugi::xml_node& resources, const Key& key) {
    if (const auto known = objects_.find(key); known != objects_.end()) return &known->second;
    Object made;
    made.name = attributeNamed(object, "name");
    if (made.name.empty() && slicer_names_.contains(key.second)) made.name = slicer_names_[key.second];
    if (made.name.empty()) made.name = attributeNamed(object, "partnumber");
    if (made.name.empty()) made.name = "Object_" + key.second;
    if (const pugi::xml_node mesh = childNamed(object, "mesh")) {
      auto read = meshOf(mesh, object, resources, made.name);
      HAPTICELL_TRY(read);
      made.meshes.push_back(static_cast<unsigned>(meshes_.size()));
      meshes_.push_back(std::move(*read));
    }
    for (const pugi::xml_node child : object.children()) {
      static constexpr std::string_view kRead[] = {"mesh", "components", "metadatagroup"};
      const std::string_view name = localName(child.name());
      if (child.type() == pugi::node_element &&
          std::find(std::begin(kRead), std::end(kRead), name) == std::end(kRead)) {
        report_.meet(name, "'" + made.name + "'");
      }
    }
    return &(objects_[key] = std::move(made));
  }

  Expected<std::unique_ptr<aiMesh>> meshOf(const pugi::xml_node& mesh, const pugi::xml_node& object,
                                           const pugi::xml_node& resources, const std::string& name) {
    std::vector<float> positions;
    for (const pugi::xml_node vertex : childNamed(mesh, "vertices").children()) {
      if (!isNamed(vertex, "vertex")) continue;
      for (const char* axis : {"x", "y", "z"}) {
        const auto number = numberOf(vertex, axis);
        if (!number)
          return makeError(damagedFile(Text("object '%1'", name), Text("an invalid vertex"), Text("x, y and z")));
        positions.push_back(static_cast<float>(*number));
      }
    }
    std::vector<std::uint32_t> corners;
    std::map<Key, int> colors;
    for (const pugi::xml_node triangle : childNamed(mesh, "triangles").children()) {
      if (!isNamed(triangle, "triangle")) continue;
      for (const char* corner : {"v1", "v2", "v3"}) {
        const auto number = numberOf(triangle, corner);
        if (!number || *number < 0.0 || *number >= static_cast<double>(positions.size() / 3)) {
          return makeError(damagedFile(Text("object '%1'", name), Text("a triangle with a vertex that does not exist"),
                                       Text("vertex numbers from 0 to %1", positions.size() / 3)));
        }
        corners.push_back(static_cast<std::uint32_t>(*number));
      }
      if (triangle.attribute("pid")) ++colors[{triangle.attribute("pid").value(), triangle.attribute("p1").value()}];
    }
    if (childNamed(mesh, "beamlattice")) report_.meet("beamlattice", "'" + name + "'");
    Key color{object.attribute("pid").value(), object.attribute("pindex").value()};
    int most = static_cast<int>(corners.size() / 3);
    for (const auto& [key, count] : colors) most -= count;  // What has the object's own.
    for (const auto& [key, count] : colors) {
      if (count <= most) continue;
      most = count;
      color = key;
    }
    return newMesh(name, positions, corners, materialOf(resources, color));
  }

  /// The colour of an entry of a group of properties.
  unsigned materialOf(const pugi::xml_node& resources, const Key& key) {
    std::optional<aiColor4D> color;
    for (const pugi::xml_node group : resources.children()) {
      if (key.first.empty() || attributeNamed(group, "id") != key.first || isNamed(group, "object")) continue;
      long index = std::strtol(key.second.c_str(), nullptr, 10);
      for (const pugi::xml_node entry : group.children()) {
        if (entry.type() != pugi::node_element || index-- != 0) continue;
        color = colorOfText(attributeNamed(entry, isNamed(group, "colorgroup") ? "color" : "displaycolor"));
        break;
      }
    }
    materials_.push_back(color ? newMaterial(*color) : std::make_unique<aiMaterial>());
    return static_cast<unsigned>(materials_.size() - 1);
  }

  ModelPackage package_;
  workcell::ContentReport report_;
  std::map<std::string, std::unique_ptr<pugi::xml_document>> documents_;
  std::map<std::string, std::map<std::string, pugi::xml_node>> objects_of_;
  std::map<Key, Object> objects_;
  std::map<std::string, std::string> slicer_names_;
  std::vector<std::unique_ptr<aiMesh>> meshes_;
  std::vector<std::unique_ptr<aiMaterial>> materials_;
};

}  // namespace

Expected<ThreeMfModel> readThreeMf(const std::filesystem::path& file) {
  auto package = unpackModel(file);
  HAPTICELL_TRY(package);
  return ThreeMfReader(std::move(*package)).read();
}

}  // namespace hapticell::importer
