// SPDX-License-Identifier: Apache-2.0
#include "importer/cad_document.h"

#include <unistd.h>

#include <IGESCAFControl_Reader.hxx>
#include <IGESData_BasicEditor.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Check.hxx>
#include <Interface_Static.hxx>
#include <Message_ProgressIndicator.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TDataStd_Name.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cctype>
#include <gp_Quaternion.hxx>
#include <gp_Trsf.hxx>
#include <map>

#include "geometry/system/regular_file.h"
#include "geometry/system/text_case.h"
#include "geometry/system/unfolding.h"
#include "importer/step_text.h"
#include "workcell/scenes/placeholder_name.h"
#include "workcell/scenes/scene_exchange.h"

namespace hapticell::importer {

namespace {

class Indicator : public Message_ProgressIndicator {
 public:
  explicit Indicator(CadProgress progress) : progress_(std::move(progress)) {}

  void setStage(Text stage) {
    stage_ = std::move(stage);
    progress_(GetPosition(), stage_);
  }

 protected:
  void Show(const Message_ProgressScope&, Standard_Boolean) override { progress_(GetPosition(), stage_); }

 private:
  CadProgress progress_;
  Text stage_ = "reading";
};

/// Metres per unit by its name in a STEP file; 0 where it is not known.
double metresOf(const TCollection_AsciiString& name) {
  static const std::map<std::string, double> kUnits = {
      {"millimetre", 1e-3}, {"millimeter", 1e-3}, {"metre", 1.0},   {"meter", 1.0},       {"centimetre", 1e-2},
      {"centimeter", 1e-2}, {"inch", 0.0254},     {"foot", 0.3048}, {"micrometre", 1e-6}, {"kilometre", 1e3},
      {"mm", 1e-3},         {"m", 1.0},           {"cm", 1e-2},     {"in", 0.0254},       {"decimetre", 0.1}};
  TCollection_AsciiString lower(name);
  lower.LowerCase();
  const auto found = kUnits.find(lower.ToCString());
  return found == kUnits.end() ? 0.0 : found->second;
}

bool looksLikeStep(const std::filesystem::path& file) {
  if (beginsAsStep(geometry::headOfFile(file, 65536))) return true;
  const std::string extension = lowerExtension(file);
  return extension == ".stpz" || extension == ".step" || extension == ".stp" || extension == ".p21";
}

Error unreadable(const char* format) {
  return {.found = Text("the file cannot be read as %1", format),
          .expected = Text("an undamaged %1 file", format),
          .fix = "Export it again."};
}

/// Entries of a STEP file's shapes that the library did not understand as they stand there: "#12". Of others, such as
/// styles, it also complains where nothing is amiss.
std::vector<std::string> damagedEntries(const Handle(StepData_StepModel) & model) {
  std::vector<std::string> found;
  if (model.IsNull()) return found;
  constexpr Standard_Boolean kAsRead = Standard_True;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->Check(i, kAsRead)->HasFailed()) continue;
    const Handle(Standard_Transient) entity = model->Value(i);
    const std::string_view type = entity->DynamicType()->Name();
    if (!type.starts_with("StepGeom_") && !type.starts_with("StepShape_")) continue;
    found.push_back("#" + std::to_string(model->IdentLabel(entity)));
  }
  return found;
}

Expected<CadDocument> openStep(const std::string& name, const Message_ProgressRange& range, Indicator& indicator) {
  STEPCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(false);
  reader.SetPropsMode(false);
  Message_ProgressScope scope(range, "reading", 1.0);
  if (reader.ReadFile(name.c_str()) != IFSelect_RetDone) return makeError(unreadable("STEP"));
  CadDocument result = newCadDocument();
  result.format = "step";
  if (const auto damaged = damagedEntries(reader.ChangeReader().StepModel()); !damaged.empty()) {
    const Text which = damaged.size() == 1
                           ? Text("1 damaged entry (%1)", damaged.front())
                           : Text("%1 damaged entries (the first: %2)", damaged.size(), damaged.front());
    // Where the library breaks down at them, this is the place that is named.
    indicator.setStage(Text("reading %1", which));
    result.warnings.push_back(
        Text("The file has %1; parts made from it can be missing or wrong. Export the file again.", which));
  }
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) {
    if (const double metres = metresOf(lengths.First()); metres > 0.0) {
      result.metres_per_unit = metres;
      result.unit_is_stated = true;
    }
  }
  if (!reader.Transfer(result.document, scope.Next())) {
    return makeError(
        {.found = "it contains no shape that can be built", .expected = "a STEP file with solids or surfaces"});
  }
  return result;
}

Expected<CadDocument> openIges(const std::string& name, const Message_ProgressRange& range) {
  IGESCAFControl_Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  reader.SetLayerMode(false);
  Message_ProgressScope scope(range, "reading", 1.0);
  if (reader.ReadFile(name.c_str()) != IFSelect_RetDone) return makeError(unreadable("IGES"));
  CadDocument result = newCadDocument();
  result.format = "iges";
  if (const auto model = reader.IGESModel(); !model.IsNull()) {
    const double millimetres = model->GlobalSection().UnitValue();
    if (millimetres > 0.0) {
      result.metres_per_unit = millimetres * 1e-3;
      result.unit_is_stated = true;
    }
  }
  if (!reader.Transfer(result.document, scope.Next())) {
    return makeError({.found = "it contains no shape that can be built", .expected = "an IGES file with surfaces"});
  }
  return result;
}

class TreeWalker {
 public:
  /// `stem` names what has no name at the top; names that say nothing count as none there, but in our own files.
  TreeWalker(std::string stem, bool is_own_file) : stem_(std::move(stem)), is_own_file_(is_own_file) {}

  void add(const TDF_Label& label, int parent) {
    CadNode node;
    node.label = node.definition = label;
    node.parent = parent;
    XCAFDoc_ShapeTool::GetReferredShape(label, node.definition);
    node.assembly = XCAFDoc_ShapeTool::IsAssembly(node.definition);
    const std::string instance = node.definition == label ? "" : nameOf(label);
    node.name = nameOf(node.definition);
    if (node.name.empty() || (node.name.starts_with(kSharedPart) && !instance.empty())) node.name = instance;
    if (instance != node.name) node.instance = instance;
    if (parent < 0 && !is_own_file_ && !node.name.empty() && workcell::saysNothing(node.name)) node.replaced.swap(node.name);
    if (node.name.empty() && parent < 0) node.name = stem_;
    if (node.name.empty()) node.name = node.assembly ? "assembly" : "part";
    const auto index = static_cast<int>(nodes.size());
    const TDF_Label definition = node.definition;
    const bool assembly = node.assembly;
    nodes.push_back(std::move(node));
    if (!assembly) return;
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(definition, components);
    for (const TDF_Label& component : components) add(component, index);
  }

  std::vector<CadNode> nodes;

 private:
  std::string stem_;
  bool is_own_file_;
};

}  // namespace

std::vector<CadNode> treeOf(const CadDocument& cad, const std::string& stem) {
  TDF_LabelSequence roots;
  XCAFDoc_DocumentTool::ShapeTool(cad.document->Main())->GetFreeShapes(roots);
  const bool is_own_file = roots.Length() == 1 && nameOf(roots.First()) == workcell::kWorkcellRoot;
  if (is_own_file) {
    const TDF_Label around = roots.First();
    roots.Clear();
    XCAFDoc_ShapeTool::GetComponents(around, roots);
  }
  TreeWalker walker(stem, is_own_file);
  for (const TDF_Label& root : roots) walker.add(root, -1);
  return std::move(walker.nodes);
}

Expected<void> checkTree(const CadDocument& cad) {
  std::map<std::string, std::uint32_t> numbers;  // By the label's entry.
  std::vector<TDF_Label> labels;
  const auto numberOf = [&](const TDF_Label& label) {
    TDF_Label definition = label;
    XCAFDoc_ShapeTool::GetReferredShape(label, definition);
    TCollection_AsciiString entry;
    TDF_Tool::Entry(definition, entry);
    const auto [known, is_new] = numbers.try_emplace(entry.ToCString(), static_cast<std::uint32_t>(labels.size()));
    if (is_new) labels.push_back(definition);
    return known->second;
  };
  TDF_LabelSequence free;
  XCAFDoc_DocumentTool::ShapeTool(cad.document->Main())->GetFreeShapes(free);
  std::vector<std::uint32_t> roots;
  for (const TDF_Label& root : free) roots.push_back(numberOf(root));
  std::vector<std::vector<std::uint32_t>> below;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    below.emplace_back();
    if (!XCAFDoc_ShapeTool::IsAssembly(labels[k])) continue;
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(labels[k], components);
    for (const TDF_Label& component : components) below.back().push_back(numberOf(component));
  }
  return geometry::checkUnfolding(below, roots, {},
                                  [&](std::uint32_t node) -> Text { return "'" + nameOf(labels[node]) + "'"; });
}

CadDocument newCadDocument() {
  CadDocument result;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", result.document);
  return result;
}

Expected<CadDocument> openCad(const std::filesystem::path& file, const CadProgress& progress) {
  // References to other files are relative to the file, but the library looks for them from where the process is.
  if (::chdir(file.parent_path().c_str()) != 0) return makeError({.found = "the folder of the file cannot be opened"});
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Handle(Indicator) indicator = new Indicator(progress);
  const std::string name = file.filename().string();
  if (!looksLikeStep(file)) return openIges(name, indicator->Start());
  const auto text = StepText::open(file);
  HAPTICELL_TRY(text);
  auto opened = openStep(text->name(), indicator->Start(), *indicator);
  if (opened) opened->warnings.insert(opened->warnings.begin(), text->warnings().begin(), text->warnings().end());
  return opened;
}

std::string nameOf(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) return {};
  const TCollection_ExtendedString& wide = attribute->Get();
  std::string name(static_cast<std::size_t>(wide.LengthOfCString()), '\0');
  if (!name.empty()) {
    char* begin = name.data();
    wide.ToUTF8CString(begin);
  }
  while (!name.empty() && name.back() == '\0') name.pop_back();
  const bool made_up = name.starts_with("=>[") || name.starts_with("NAUO") || name == "NONE" || name == "COMPOUND" ||
                       name == "SOLID" || name == "SHELL" || name == "ASSEMBLY" ||
                       name.starts_with("Open CASCADE STEP translator");
  return made_up ? std::string() : name;
}

Pose poseOf(const TopLoc_Location& location, double factor) {
  const gp_Trsf transform = location.Transformation();
  const gp_XYZ p = transform.TranslationPart();
  const gp_Quaternion q = transform.GetRotation();
  Pose X{dvec3(p.X(), p.Y(), p.Z()) * (1e-3 * factor), dquat(q.W(), q.X(), q.Y(), q.Z())};
  X.q = glm::normalize(X.q);
  return X;
}

}  // namespace hapticell::importer
