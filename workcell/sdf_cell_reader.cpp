// SPDX-License-Identifier: Apache-2.0
#include "workcell/sdf_cell_reader.h"

#include <tinyxml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <string_view>

#include "geometry/shapes.h"
#include "workcell/file_content.h"
#include "workcell/imported_entities.h"
#include "workcell/package_path.h"
#include "workcell/scene_batch.h"
#include "workcell/text_cursor.h"
#include "workcell/xml_text.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

constexpr int kDeepest = 200;

/// Elements open at once at the deepest place; the XML library would recurse that far.
int depthOf(std::string_view text) {
  int depth = 0, deepest = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const char next = at + 1 < text.size() ? text[at + 1] : '\0';
    if (next == '!' || next == '?') continue;
    const std::size_t end = text.find('>', at);
    const bool closed = end != std::string_view::npos && text[end - 1] == '/';
    depth += next == '/' ? -1 : closed ? 0 : 1;
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

/// The root element <sdf> of a parsed file.
Expected<TiXmlElement*> parse(const fs::path& file, TiXmlDocument& document) {
  const auto content = readFileContent(file);
  if (!content) return makeError(content.error());
  if (depthOf(*content) > kDeepest || content->find('\0') != std::string::npos) {
    return makeError({file.string(), "", "XML nested deeper than 200, or bytes that are no text", "SDF", ""});
  }
  document.Parse(soundXmlText(*content).text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    return makeError({file.string(), "line " + std::to_string(document.ErrorRow()), document.ErrorDesc(), "XML", ""});
  }
  TiXmlElement* root = document.RootElement();
  if (!root || root->ValueStr() != "sdf") return makeError({file.string(), "", "no <sdf>", "an SDF file", ""});
  return root;
}

std::string textOf(const TiXmlElement* parent, const char* name) {
  const TiXmlElement* element = parent ? parent->FirstChildElement(name) : nullptr;
  const char* text = element ? element->GetText() : nullptr;
  std::string result = text ? text : "";
  const std::size_t first = result.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return result.substr(first, result.find_last_not_of(" \t\r\n") - first + 1);
}

std::string attributeOf(const TiXmlElement& element, const char* name) {
  const char* text = element.Attribute(name);
  return text ? text : "";
}

std::vector<double> numbersOf(const std::string& text) {
  std::vector<double> numbers;
  TextCursor cursor(text);
  while (cursor.nextLine()) {
    for (std::string_view word = cursor.nextWord(); !word.empty(); word = cursor.nextWord()) {
      const std::optional<double> number = parseNumber(word);
      if (!number || !isUsable(*number)) return numbers;
      numbers.push_back(*number);
    }
  }
  return numbers;
}

bool moves(const TiXmlElement& model) {
  for (const TiXmlElement* joint = model.FirstChildElement("joint"); joint;
       joint = joint->NextSiblingElement("joint")) {
    if (attributeOf(*joint, "type") != "fixed") return true;
  }
  return false;
}

class CellReader {
 public:
  /// With `ahead` no mesh is read: the files that would be are added there. `scenes` are those read so.
  CellReader(ImportMonitor* monitor, const SceneBatch& scenes, std::vector<fs::path>* ahead)
      : monitor_(monitor), scenes_(scenes), ahead_(ahead) {
    scene_.format = "sdf";
    scene_.unit_is_stated = true;
  }

  Expected<ImportedScene> read(const fs::path& file) {
    TiXmlDocument document;
    const auto root = parse(file, document);
    if (!root) return makeError(root.error());
    const TiXmlElement* world = (*root)->FirstChildElement("world");
    const TiXmlElement* from = world ? world : *root;
    for (const TiXmlElement* child = from->FirstChildElement(); child; child = child->NextSiblingElement()) {
      if (monitor_ && monitor_->isCancelled())
        return makeError({file.string(), "", "the import was cancelled", "", ""});
      addModelOrInclude(*child, {file, -1, 0});
    }
    tellMissing("models that it names are not there", missing_models_);
    tellMissing("meshes that it names are not there or not readable", missing_meshes_);
    return std::move(scene_);
  }

 private:
  /// Where a piece of XML stands: its file, the node above, how many files deep.
  struct Place {
    fs::path file;
    int parent = -1;
    int depth = 0;
  };

  void addModelOrInclude(const TiXmlElement& element, const Place& place) {
    if (element.ValueStr() == "model") {
      addModel(element, attributeOf(element, "name"), poseOf(&element, attributeOf(element, "name")), place);
    } else if (element.ValueStr() == "include") {
      addInclude(element, place);
    }
  }

  void addInclude(const TiXmlElement& include, const Place& place) {
    const std::string uri = textOf(&include, "uri");
    std::string name = textOf(&include, "name");
    const fs::path model_file = findModel(uri, place.file);
    constexpr int kFilesDeep = 20;
    if (model_file.empty() || place.depth > kFilesDeep) {
      ++missing_models_[uri];
      return;
    }
    TiXmlDocument document;
    const auto root = parse(model_file, document);
    const TiXmlElement* model = root ? (*root)->FirstChildElement("model") : nullptr;
    if (!model) {
      ++missing_models_[uri + (root ? " (no model in it)" : " (" + root.error().found + ")")];
      return;
    }
    if (name.empty()) name = attributeOf(*model, "name");
    const bool placed = include.FirstChildElement("pose") != nullptr;
    addModel(*model, name, poseOf(placed ? &include : model, name), {model_file, place.parent, place.depth + 1});
  }

  void addModel(const TiXmlElement& model, const std::string& name, const Pose& X_PM, const Place& place) {
    SceneNode node;
    node.name = name.empty() ? "model" : name;
    node.parent = place.parent;
    node.X_PN = X_PM;
    const Place inside{place.file, add(std::move(node)), place.depth};
    if (moves(model)) scene_.warnings.push_back("'" + name + "' has joints that move; it is read as a solid body");
    int links = 0;
    for (const TiXmlElement* link = model.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
      ++links;
    }
    for (const TiXmlElement* child = model.FirstChildElement(); child; child = child->NextSiblingElement()) {
      if (child->ValueStr() == "link") {
        addLink(*child, links > 1, inside);
      } else {
        addModelOrInclude(*child, inside);
      }
    }
  }

  void addLink(const TiXmlElement& link, bool own_node, const Place& model) {
    const std::string name = attributeOf(link, "name");
    const Pose X_ML = poseOf(&link, name);
    Place place = model;
    if (own_node) {
      SceneNode node;
      node.name = name;
      node.parent = model.parent;
      node.X_PN = X_ML;
      place.parent = add(std::move(node));
    }
    const char* kind = link.FirstChildElement("visual") ? "visual" : "collision";
    for (const TiXmlElement* shape = link.FirstChildElement(kind); shape; shape = shape->NextSiblingElement(kind)) {
      const std::string shape_name = attributeOf(*shape, "name");
      const Pose X_LS = poseOf(shape, shape_name);
      SceneNode node;
      node.name = shape_name.empty() ? name : shape_name;
      node.parent = place.parent;
      node.X_PN = own_node ? X_LS : X_ML * X_LS;
      node.color = colorOf(shape->FirstChildElement("material"));
      addShape(shape->FirstChildElement("geometry"), std::move(node), place.file);
    }
  }

  void addShape(const TiXmlElement* geometry, SceneNode node, const fs::path& file) {
    if (!geometry) return;
    if (const TiXmlElement* mesh = geometry->FirstChildElement("mesh")) return addMesh(*mesh, std::move(node), file);
    const auto sizes = [&](const char* shape, const char* key) {
      return numbersOf(textOf(geometry->FirstChildElement(shape), key));
    };
    const auto positive = [](const std::vector<double>& numbers, std::size_t count) {
      return numbers.size() == count && std::all_of(numbers.begin(), numbers.end(), [](double n) { return n > 0.0; });
    };
    if (const auto size = sizes("box", "size"); positive(size, 3)) {
      addSolid(geometry::makeBox({size[0], size[1], size[2]}), std::move(node));
    } else if (const auto radius = sizes("sphere", "radius"); positive(radius, 1)) {
      addSolid(geometry::makeSphere(radius[0]), std::move(node));
    } else if (const auto round = sizes("cylinder", "radius"), length = sizes("cylinder", "length");
               positive(round, 1) && positive(length, 1)) {
      addSolid(geometry::makeCylinder(round[0], length[0]), std::move(node));
    } else {
      const TiXmlElement* first = geometry->FirstChildElement();
      scene_.warnings.push_back("'" + node.name + "' is left out: a shape <" + (first ? first->ValueStr() : "") +
                                "> without size or of a kind that is not read");
    }
  }

  void addSolid(geometry::TriangleMesh mesh, SceneNode node) {
    node.mesh = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(mesh));
    add(std::move(node));
  }

  /// One file may be used by many models: it is read once a scale.
  void addMesh(const TiXmlElement& mesh, SceneNode node, const fs::path& file) {
    const std::string uri = textOf(&mesh, "uri");
    std::vector<double> scale = numbersOf(textOf(&mesh, "scale"));
    if (scale.size() != 3) scale = {1.0, 1.0, 1.0};
    const fs::path path = findFile(uri, file);
    const std::string key = path.string() + "|" + textOf(&mesh, "scale");
    auto [known, is_new] = meshes_.try_emplace(key, -1);
    if (ahead_) return ahead_->push_back(path);
    if (is_new && !path.empty()) {
      Diagnostics notes;
      ImportOptions options = scenes_.options();
      if (!holdsScene(path)) options.metres_per_unit = 1.0;  // Gazebo reads no unit out of a mesh file.
      if (auto read = readWholeMesh(path, options, notes, &scenes_)) {
        for (dvec3& v : read->vertices) v *= dvec3(scale[0], scale[1], scale[2]);
        known->second = static_cast<int>(scene_.meshes.size());
        scene_.meshes.push_back(std::move(*read));
      }
      if (monitor_) monitor_->report("reading meshes", 1.0 - 1.0 / (1.0 + 0.1 * static_cast<double>(meshes_.size())));
    }
    if (known->second < 0) {
      ++missing_meshes_[uri];
      return;
    }
    node.mesh = known->second;
    add(std::move(node));
  }

  int add(SceneNode node) {
    scene_.nodes.push_back(std::move(node));
    return static_cast<int>(scene_.nodes.size()) - 1;
  }

  /// <pose>x y z roll pitch yaw</pose>: R = Rz(yaw) Ry(pitch) Rx(roll).
  Pose poseOf(const TiXmlElement* element, const std::string& name) {
    const TiXmlElement* pose = element->FirstChildElement("pose");
    const std::string text = textOf(element, "pose");
    if (!pose || text.empty()) return {};
    std::vector<double> n = numbersOf(text);
    if (n.size() != 6) {
      scene_.warnings.push_back("'" + name + "': the pose '" + text + "' has " + std::to_string(n.size()) +
                                " numbers instead of 6; the others are taken as 0");
      n.resize(6, 0.0);
    }
    const double unit = attributeOf(*pose, "degrees") == "true" ? std::numbers::pi / 180.0 : 1.0;
    const auto turn = [unit](double angle, const dvec3& axis) { return glm::angleAxis(unit * angle, axis); };
    const dquat q = turn(n[5], {0, 0, 1}) * turn(n[4], {0, 1, 0}) * turn(n[3], {1, 0, 0});
    return {{n[0], n[1], n[2]}, glm::normalize(q)};
  }

  static std::optional<std::array<float, 3>> colorOf(const TiXmlElement* material) {
    for (const char* key : {"diffuse", "ambient"}) {
      const std::vector<double> n = numbersOf(textOf(material, key));
      if (n.size() < 3) continue;
      const auto part = [&](std::size_t k) { return static_cast<float>(std::clamp(n[k], 0.0, 1.0)); };
      return std::array<float, 3>{part(0), part(1), part(2)};
    }
    return std::nullopt;
  }

  /// The folders that may hold models: from the file upwards, each with its "models", then those of the environment.
  static std::vector<fs::path> modelFolders(const fs::path& file) {
    std::vector<fs::path> folders;
    for (fs::path at = fs::absolute(file).parent_path();; at = at.parent_path()) {
      folders.push_back(at);
      folders.push_back(at / "models");
      if (at == at.parent_path()) break;
    }
    for (const char* variable : {"GZ_SIM_RESOURCE_PATH", "GAZEBO_MODEL_PATH", "SDF_PATH"}) {
      const char* value = std::getenv(variable);
      std::string rest = value ? value : "";
      while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        folders.emplace_back(rest.substr(0, colon));
        rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
      }
    }
    return folders;
  }

  static fs::path findFile(const std::string& uri, const fs::path& file) {
    std::error_code ignored;
    if (leavesPackage(uri)) return {};
    if (uri.starts_with("model://")) {
      for (const fs::path& folder : modelFolders(file)) {
        if (fs::path found = folder / uri.substr(8); fs::exists(found, ignored)) return found;
      }
      return {};
    }
    return resolveMeshPath(uri, file.parent_path()).value_or(fs::path());
  }

  static fs::path findModel(const std::string& uri, const fs::path& file) {
    std::error_code ignored;
    fs::path found = uri.starts_with("model://") ? findFile(uri, file) : file.parent_path() / uri;
    if (uri.empty() || found.empty() || !fs::exists(found, ignored)) return {};
    if (!fs::is_directory(found, ignored)) return found;
    return fs::exists(found / "model.sdf", ignored) ? found / "model.sdf" : fs::path();
  }

  void tellMissing(const std::string& what, const std::map<std::string, int>& missing) {
    if (missing.empty()) return;
    std::string names;
    int count = 0;
    for (const auto& [name, times] : missing) {
      names += (names.empty() ? "" : ", ") + name + (times > 1 ? " (" + std::to_string(times) + " times)" : "");
      count += times;
    }
    scene_.warnings.push_back(std::to_string(count) + " " + what + " and were left out: " + names);
  }

  ImportMonitor* monitor_;
  const SceneBatch& scenes_;
  std::vector<fs::path>* ahead_;
  ImportedScene scene_;
  std::map<std::string, int> meshes_;
  std::map<std::string, int> missing_models_, missing_meshes_;
};

}  // namespace

bool isSdfCell(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  if (extension != ".sdf" && extension != ".world") return false;
  TiXmlDocument document;
  const auto root = parse(file, document);
  if (!root) return false;
  if ((*root)->FirstChildElement("world")) return true;
  const TiXmlElement* model = (*root)->FirstChildElement("model");
  if (!model || !moves(*model)) return model != nullptr;
  // Joints between models inside a model that has no link of its own make no robot: the whole is a group of bodies.
  const bool group = model->FirstChildElement("model") || model->FirstChildElement("include");
  return group && !model->FirstChildElement("link");
}

Expected<ImportedScene> readSdfCell(const fs::path& file, ImportMonitor* monitor) {
  ImportOptions options;  // Collada without its up axis, as Gazebo does.
  options.up_axis = UpAxis::kZ;
  options.weld = false;
  options.warn_about_unit = false;
  SceneBatch scenes(options, monitor);
  std::vector<fs::path> files;
  if (auto named = CellReader(nullptr, scenes, &files).read(file); !named) return named;
  scenes.readAhead(files);
  return CellReader(monitor, scenes, nullptr).read(file);
}

}  // namespace hapticell::workcell
