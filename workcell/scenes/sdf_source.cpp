// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/sdf_source.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

#include "geometry/system/scratch_folder.h"
#include "workcell/scenes/import_process.h"
#include "workcell/scenes/sdf_exchange.h"
#include "workcell/scenes/sdf_files.h"
#include "workcell/scenes/sdf_tidier.h"
#include "workcell/scenes/sdf_xml.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

void reportComplaints(const std::vector<std::string>& told, std::vector<Text>& warnings) {
  // Messages of sdformat that are shown; the rest is counted. Half, twice: shorter or longer lists.
  constexpr std::size_t kMost = 8;
  for (std::size_t k = 0; k < std::min(told.size(), kMost); ++k) warnings.emplace_back("sdformat: " + told[k]);
  if (told.size() > kMost) warnings.push_back(Text("sdformat: %1 more messages", told.size() - kMost));
}

/// What the library makes of a tidied text.
Expected<SdfContent> resolved(const std::string& text, const fs::path& file, ImportMonitor* monitor) {
  ImporterCall call;
  call.file = file.string();
  call.arguments = {"resolve-sdf", fs::absolute(file).string()};
  call.scene = text;
  call.monitor = monitor;
  const Expected<std::string> bytes = callImporter(call);
  HAPTICELL_TRY(bytes);
  auto content = sdfFromBytes(*bytes);
  if (content) return content;
  Error error = content.error();
  error.file = file.string();
  return makeError(std::move(error));
}

bool isSolid(const TiXmlElement& link) {
  for (const char* kind : {"visual", "collision"}) {
    for (const TiXmlElement* shape = link.FirstChildElement(kind); shape; shape = shape->NextSiblingElement(kind)) {
      const TiXmlElement* geometry = shape->FirstChildElement("geometry");
      const TiXmlElement* first = geometry ? geometry->FirstChildElement() : nullptr;
      if (first && first->ValueStr() != "plane" && first->ValueStr() != "empty") return true;
    }
  }
  return false;
}

/// What a model is, looked at from outside.
struct ModelOutline {
  bool solid = false, jointed = false, grouped = false;
};

class Outliner {
 public:
  /// All models and includes that stand in `parent`.
  std::vector<ModelOutline> modelsIn(const TiXmlElement& parent, const fs::path& file, int depth) {
    std::vector<ModelOutline> all;
    // Models within models and files: guards the stack, as kFilesDeep of sdf_tidier.cpp. Half, twice: no effect on real
    // files.
    constexpr int kDeepest = 20;
    for (const TiXmlElement* child = parent.FirstChildElement(); child && depth < kDeepest;
         child = child->NextSiblingElement()) {
      if (child->ValueStr() == "model") all.push_back(outlineOfModel(*child, file, depth));
      if (child->ValueStr() != "include") continue;
      const fs::path taken = findSdfModel(textOf(child, "uri"), file);
      const auto [known, is_new] = of_file_.try_emplace(taken.string());
      if (is_new) {
        TiXmlDocument document;
        const auto root = taken.empty() ? Expected<TiXmlElement*>(makeError({})) : parseSdf(taken, document);
        const TiXmlElement* model = root ? (*root)->FirstChildElement("model") : nullptr;
        // A file that takes itself in finds no model there, as where it is read.
        if (model) of_file_[taken.string()] = outlineOfModel(*model, taken, depth + 1);
      }
      if (const auto& model = of_file_[taken.string()]) all.push_back(*model);
    }
    return all;
  }

 private:
  std::map<std::string, std::optional<ModelOutline>> of_file_;  // Each is read once, however often it is taken in.

  ModelOutline outlineOfModel(const TiXmlElement& model, const fs::path& file, int depth) {
    ModelOutline outline;
    const bool moves = hasMovingJoint(model);
    const TiXmlElement* const own_link = model.FirstChildElement("link");
    for (const TiXmlElement* link = own_link; link; link = link->NextSiblingElement("link")) {
      outline.solid = outline.solid || isSolid(*link);
    }
    const std::vector<ModelOutline> inside = modelsIn(model, file, depth + 1);
    int jointed = 0, others = 0;
    for (const ModelOutline& part : inside) {
      outline.solid = outline.solid || part.solid;
      jointed += part.jointed ? 1 : 0;
      others += !part.jointed && part.solid ? 1 : 0;
      outline.grouped = outline.grouped || part.grouped;
    }
    const bool has_models = model.FirstChildElement("model") || model.FirstChildElement("include");
    if (own_link || !has_models) {
      outline.jointed = moves || (own_link && jointed > 0);
    } else {
      outline.grouped = outline.grouped || moves;
      outline.jointed = !moves && jointed == 1 && others == 0;
    }
    return outline;
  }
};

}  // namespace

std::optional<SdfOutline> outlineOf(const fs::path& file) {
  TiXmlDocument document;
  const auto root = parseSdf(file, document);
  if (!root) return std::nullopt;
  SdfOutline outline;
  const TiXmlElement* const world = (*root)->FirstChildElement("world");
  outline.world = world != nullptr;
  for (const ModelOutline& model : Outliner().modelsIn(world ? *world : **root, file, 0)) {
    outline.models += model.solid || model.jointed ? 1 : 0;
    outline.jointed += model.jointed ? 1 : 0;
    outline.grouped = outline.grouped || model.grouped;
  }
  outline.world = outline.world || (*root)->FirstChildElement("include");
  if ((*root)->FirstChildElement("model") && !world) outline.models = std::max(outline.models, 1);
  return outline;
}

Expected<SdfSource> SdfSource::load(const fs::path& file, ImportMonitor* monitor) {
  // Where the copies of models that are taken in stand while the library reads them.
  const auto folder = ScratchFolder::make();
  if (!folder) {
    return makeError({.file = file.string(),
                      .found = "no folder for temporary files can be created",
                      .expected = "free space in the folder TMPDIR"});
  }
  SdfTidier tidier(folder->path());
  const Expected<std::string> text = tidier.tidy(file);
  HAPTICELL_TRY(text);
  Expected<SdfContent> content = resolved(*text, file, monitor);
  HAPTICELL_TRY(content);
  SdfSource source;
  source.content_ = std::move(*content);
  source.warnings_ = tidier.warnings();
  source.meshes_ = std::move(tidier.meshes());
  if (source.models().empty()) {
    if (const std::string& first = source.content_.first_complaint; !first.empty())
      return makeError({.file = file.string(), .found = first, .expected = "valid SDF"});
    if (!source.content_.has_world)
      return makeError({.file = file.string(), .found = "the file has no model", .expected = "<model name=\"…\">"});
  }
  reportComplaints(source.content_.complaints, source.warnings_);
  return source;
}

const SdfMeshFile& SdfSource::meshFile(const SdfShape& mesh) const {
  static const SdfMeshFile kNone;
  const auto number = static_cast<std::size_t>(std::strtoul(mesh.uri.c_str(), nullptr, 10));
  return number < meshes_.size() ? meshes_[number] : kNone;
}

}  // namespace hapticell::workcell
