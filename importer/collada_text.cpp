// SPDX-License-Identifier: Apache-2.0
#include "importer/collada_text.h"

#include <algorithm>
#include <iterator>
#include <pugixml.hpp>
#include <set>
#include <unordered_map>

#include "geometry/system/nesting_limit.h"
#include "geometry/system/unfolding.h"
#include "importer/collada_holes.h"
#include "workcell/text/content_rules.h"
#include "workcell/text/file_content.h"
#include "workcell/text/text_cursor.h"

namespace hapticell::importer {

namespace {

using workcell::UpAxis;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

bool holdsSomething(pugi::xml_node library) {
  const auto counts = [](pugi::xml_node one) {
    const std::string_view name = one.name();
    return one.type() == pugi::node_element && name != "asset" && name != "extra";
  };
  return std::any_of(library.begin(), library.end(), counts);
}

class ColladaTidier {
 public:
  ColladaTidier(pugi::xml_node root, ColladaText& result) : root_(root), result_(result), report_("Collada") {}

  bool run() {
    readAsset();
    dropWhatPlaysNoPart();
    for (pugi::xml_node library : root_.children("library_effects")) tidyColors(library);
    for (const char* name : {"library_visual_scenes", "library_nodes"}) {
      for (pugi::xml_node library : root_.children(name)) tidyNodes(library, 0);
    }
    for (pugi::xml_node library : root_.children("library_geometries")) {
      for (pugi::xml_node geometry : library.children("geometry")) tidyGeometry(geometry);
    }
    report_.tell(result_.warnings);
    return changed_;
  }

 private:
  /// Only the file's own <asset> counts; others stand in its libraries.
  void readAsset() {
    const pugi::xml_node asset = root_.child("asset");
    const auto metres = workcell::parseNumber(trimmed(asset.child("unit").attribute("meter").value()));
    result_.unit_is_stated = metres && *metres > 0.0 && *metres < 1e12;
    if (result_.unit_is_stated) result_.metres_per_unit = *metres;
    const std::string up = trimmed(asset.child("up_axis").text().get());
    if (up == "Z_UP") result_.up = UpAxis::kZ;
    if (up == "X_UP") result_.up = UpAxis::kX;
  }

  void dropWhatPlaysNoPart() {
    cameras_ = dropSeveral("library_cameras", "camera");
    lights_ = dropSeveral("library_lights", "light");
    // Exporters write these libraries even where they hold nothing.
    const auto meet = [&](const char* element) {
      for (const pugi::xml_node library : root_.children(element)) {
        if (holdsSomething(library)) return static_cast<void>(report_.meet(element, {}));
      }
    };
    for (const char* element : {"library_animations", "library_controllers", "library_kinematics_models",
                                "library_physics_models", "library_articulated_systems"}) {
      meet(element);
    }
  }

  /// One camera or light by itself does no harm, and a text that stays as it is need not be written again.
  bool dropSeveral(const char* library, const char* kind) {
    std::ptrdiff_t count = 0;
    for (const pugi::xml_node one : root_.children(library)) {
      count += std::distance(one.children(kind).begin(), one.children(kind).end());
    }
    while (count > 1 && root_.remove_child(library)) changed_ = true;
    return count > 1;
  }

  void tidyColors(pugi::xml_node parent) {
    for (pugi::xml_node child : parent.children()) {
      const std::string text = child.text().get();
      const bool blank = !text.empty() && std::string_view(" \t\r\n").find(text[0]) != std::string_view::npos;
      if (blank && (std::string_view(child.name()) == "color" || std::string_view(child.name()) == "float")) {
        child.text().set(trimmed(text).c_str());
        changed_ = true;
      }
      tidyColors(child);
    }
  }

  void tidyNodes(pugi::xml_node parent, int depth) {
    // Levels of nodes, as kDeepest of assimp_reader.cpp.
    constexpr int kDeepest = 500;
    if (depth > kDeepest) return;
    for (pugi::xml_node node : parent.children()) {
      if (std::string_view(node.name()) == "visual_scene") tidyNodes(node, depth + 1);
      if (std::string_view(node.name()) != "node") continue;
      while (cameras_ && node.remove_child("instance_camera")) changed_ = true;
      while (lights_ && node.remove_child("instance_light")) changed_ = true;
      nameById(node);
      splitTwice(node);
      tidyNodes(node, depth + 1);
    }
  }

  void nameById(pugi::xml_node node) {
    if (*node.attribute("name").value() != '\0') return;
    const char* id = node.attribute("id").value();
    if (*id == '\0') id = node.attribute("sid").value();
    if (*id == '\0') return;
    if (!node.attribute("name")) node.append_attribute("name");
    node.attribute("name").set_value(id);
    changed_ = true;
  }

  /// assimp does not take a geometry that stands twice at one node: each further one gets a node of its own.
  void splitTwice(pugi::xml_node node) {
    std::set<std::string> seen;
    std::vector<pugi::xml_node> again;
    for (pugi::xml_node instance : node.children("instance_geometry")) {
      if (!seen.insert(instance.attribute("url").value()).second) again.push_back(instance);
    }
    for (std::size_t k = 0; k < again.size(); ++k) {
      pugi::xml_node own = node.append_child("node");
      const std::string name = std::string(node.attribute("name").value()) + " " + std::to_string(k + 2);
      own.append_attribute("name").set_value(name.c_str());
      own.append_move(again[k]);
      changed_ = true;
    }
  }

  void tidyGeometry(pugi::xml_node geometry) {
    nameById(geometry);
    pugi::xml_node mesh = geometry.child("mesh");
    const std::string name = geometry.attribute("name").value();
    for (const char* kind : {"spline", "brep"}) {
      if (geometry.child(kind)) report_.meet(std::string("geometry/") + kind, "'" + name + "'");
    }
    std::vector<pugi::xml_node> holed;
    for (pugi::xml_node polygons : mesh.children("polygons")) {
      if (polygons.child("ph")) holed.push_back(polygons);
    }
    for (pugi::xml_node polygons : holed) {
      const int lost = cutPolygonsWithHoles(mesh, polygons);
      changed_ = true;
      if (lost > 0) {
        result_.warnings.push_back(
            Text("'%1': %2 polygons with holes could not be cut into triangles and are missing", name, lost));
      }
    }
  }

  pugi::xml_node root_;
  ColladaText& result_;
  workcell::ContentReport report_;
  bool changed_ = false, cameras_ = false, lights_ = false;
};

/// What the nodes of the scenes unfold to by <instance_node>, before assimp unfolds them. Nesting was looked at before.
class NodeGraph {
 public:
  explicit NodeGraph(pugi::xml_node root) {
    for (const pugi::xml_node library : root.children("library_nodes")) add(library, nullptr);
    for (const pugi::xml_node library : root.children("library_visual_scenes")) {
      for (const pugi::xml_node scene : library.children("visual_scene")) add(scene, &roots_);
    }
    for (const auto& [node, id] : uses_) {
      if (const auto target = by_id_.find(id); target != by_id_.end()) below_[node].push_back(target->second);
    }
  }

  Expected<void> check() const {
    return geometry::checkUnfolding(below_, roots_, {},
                                    [this](std::uint32_t node) { return Text("node '%1'", ids_[node]); });
  }

 private:
  void add(pugi::xml_node parent, std::vector<std::uint32_t>* siblings) {
    for (const pugi::xml_node node : parent.children("node")) {
      const auto number = static_cast<std::uint32_t>(below_.size());
      if (siblings) siblings->push_back(number);
      below_.emplace_back();
      ids_.emplace_back(node.attribute("id").value());
      for (const char* name : {"id", "sid", "name"}) by_id_.try_emplace(node.attribute(name).value(), number);
      for (const pugi::xml_node use : node.children("instance_node")) {
        const std::string url = use.attribute("url").value();
        uses_.emplace_back(number, url.substr(url.find('#') == std::string::npos ? 0 : url.find('#') + 1));
      }
      std::vector<std::uint32_t> inside;
      add(node, &inside);
      below_[number].insert(below_[number].end(), inside.begin(), inside.end());
    }
  }

  std::vector<std::vector<std::uint32_t>> below_;
  std::vector<std::string> ids_;
  std::vector<std::uint32_t> roots_;
  std::unordered_map<std::string, std::uint32_t> by_id_;
  std::vector<std::pair<std::uint32_t, std::string>> uses_;
};

/// Into a text, without the way through a stream.
class TextWriter : public pugi::xml_writer {
 public:
  explicit TextWriter(std::string& text) : text_(text) {}
  void write(const void* data, std::size_t size) override { text_.append(static_cast<const char*>(data), size); }

 private:
  std::string& text_;
};

}  // namespace

Expected<ColladaText> readColladaText(const std::filesystem::path& file) {
  auto content = workcell::readFileContent(file);
  HAPTICELL_TRY(content);
  if (auto flat = geometry::checkNesting(*content, geometry::NestedText::kXml, ""); !flat)
    return makeError(flat.error());
  pugi::xml_document document;
  // In place, and with all escapes as they stand: nothing that is looked at here has any, and it is twice as fast.
  const auto parsed =
      document.load_buffer_inplace(content->data(), content->size(), pugi::parse_minimal | pugi::parse_cdata);
  const pugi::xml_node root = document.child("COLLADA");
  if (!parsed || !root) {
    const auto end = content->begin() + std::clamp<std::ptrdiff_t>(parsed.offset, 0, std::ssize(*content));
    const auto line = 1 + std::count(content->begin(), end, '\n');
    return makeError({.place = parsed ? Text() : Text("line %1", line),
                      .found = parsed ? Text("no <COLLADA>") : Text(std::string(parsed.description())),
                      .expected = "the content of a Collada file",
                      .fix = "Export it again."});
  }
  HAPTICELL_TRY(NodeGraph(root).check());
  ColladaText result;
  if (ColladaTidier(root, result).run()) {
    TextWriter writer(result.text);
    document.save(writer, "", pugi::format_raw | pugi::format_no_escapes);
  }
  return result;
}

}  // namespace hapticell::importer
