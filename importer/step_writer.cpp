// SPDX-License-Identifier: Apache-2.0
#include "importer/step_writer.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <gp_Quaternion.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <unordered_map>

#include "importer/cad_document.h"
#include "importer/faceted_shape.h"
#include "importer/shape_mesher.h"
#include "workcell/scenes/placeholder_name.h"
#include "workcell/scenes/scene_exchange.h"

namespace hapticell::importer {

namespace {

using workcell::SceneNode;

/// The parts of one opened source by their paths (as workcell::partPaths() makes them).
class SourceParts {
 public:
  SourceParts(CadDocument cad, const std::string& stem) : cad_(std::move(cad)) {
    const std::vector<CadNode> tree = treeOf(cad_, stem);
    workcell::ImportedScene names;
    for (const CadNode& node : tree) {
      SceneNode named;
      named.name = node.name;
      named.parent = node.parent;
      names.nodes.push_back(std::move(named));
    }
    const std::vector<std::string> paths = workcell::partPaths(names);
    for (std::size_t k = 0; k < paths.size(); ++k) parts_[paths[k]] = tree[k].definition;
  }

  double metresPerUnit() const { return cad_.metres_per_unit; }

  /// The shape of a part in its own frame; of everything where `path` is empty. Null if there is no shape.
  TopoDS_Shape find(const std::string& path) const {
    if (path.empty()) return whole();
    const auto found = parts_.find(path);
    return found == parts_.end() ? TopoDS_Shape() : XCAFDoc_ShapeTool::GetShape(found->second);
  }

  /// The coloured faces, shells and solids within a part.
  std::vector<std::pair<TopoDS_Shape, Quantity_Color>> coloredParts(const std::string& path) const {
    std::vector<std::pair<TopoDS_Shape, Quantity_Color>> result;
    const auto found = parts_.find(path);
    if (found == parts_.end()) return result;
    const Handle(XCAFDoc_ColorTool) colors = XCAFDoc_DocumentTool::ColorTool(cad_.document->Main());
    TDF_LabelSequence below;
    XCAFDoc_ShapeTool::GetSubShapes(found->second, below);
    for (const TDF_Label& label : below) {
      Quantity_Color color;
      const bool colored =
          colors->GetColor(label, XCAFDoc_ColorSurf, color) || colors->GetColor(label, XCAFDoc_ColorGen, color);
      if (colored) result.emplace_back(XCAFDoc_ShapeTool::GetShape(label), color);
    }
    return result;
  }

 private:
  TopoDS_Shape whole() const {
    TDF_LabelSequence roots;
    XCAFDoc_DocumentTool::ShapeTool(cad_.document->Main())->GetFreeShapes(roots);
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    for (const TDF_Label& root : roots) {
      const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(root);
      if (!shape.IsNull()) builder.Add(all, shape);
    }
    return all;
  }

  CadDocument cad_;
  std::unordered_map<std::string, TDF_Label> parts_;
};

gp_Trsf transformOf(const Pose& X) {
  gp_Trsf transform;
  transform.SetRotation(gp_Quaternion(X.q.x, X.q.y, X.q.z, X.q.w));
  transform.SetTranslationPart(gp_Vec(1e3 * X.p.x, 1e3 * X.p.y, 1e3 * X.p.z));
  return transform;
}

class StepBuilder {
 public:
  StepBuilder(const workcell::ImportedScene& scene, ParentLink& parent)
      : scene_(scene),
        parent_(parent),
        cad_(newCadDocument()),
        shapes_(XCAFDoc_DocumentTool::ShapeTool(cad_.document->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(cad_.document->Main())),
        children_(scene.nodes.size()) {
    for (std::size_t k = 0; k < scene.nodes.size(); ++k) {
      const int above = scene.nodes[k].parent;
      (above < 0 ? roots_ : children_[static_cast<std::size_t>(above)]).push_back(k);
    }
    for (const SceneNode& node : scene.nodes) {
      if (!node.instance.empty()) with_named_uses_.insert(shapeKeyOf(node));
    }
    for (const SceneNode& node : scene.nodes) {
      if (node.mesh < 0) continue;
      const auto [known, is_new] = part_names_.try_emplace(keyOf(node), node.name);
      if (!is_new && known->second != node.name && !known->second.starts_with(kSharedPart))
        known->second = kSharedPart + known->second;
    }
  }

  Expected<CadDocument> build() {
    // A root that is moved needs something to stand in; so do several of them, and one whose name other files would not
    // mean.
    const bool plain = roots_.size() == 1 && isIdentity(scene_.nodes[roots_[0]].X_PN) &&
                       !workcell::saysNothing(scene_.nodes[roots_[0]].name);
    if (plain) {
      HAPTICELL_TRY(define(roots_[0]));
    } else {
      const TDF_Label top = shapes_->NewShape();
      setName(top, workcell::kWorkcellRoot);
      for (std::size_t root : roots_) {
        HAPTICELL_TRY(use(root, top));
      }
    }
    shapes_->UpdateAssemblies();
    return cad_;
  }

 private:
  static bool isIdentity(const Pose& X) { return glm::length(X.p) < 1e-12 && glm::length(rotationVector(X.q)) < 1e-12; }

  static void setName(const TDF_Label& label, const std::string& name) {
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
  }

  /// Nodes of one shape and colour are uses of one part. Their names may differ, as each use carries its own, but not
  /// where a use has a name of its own beside the part's.
  using ShapeKey = std::tuple<int, bool, std::array<float, 3>>;
  using Key = std::pair<ShapeKey, std::string>;
  static ShapeKey shapeKeyOf(const SceneNode& node) {
    const auto color = node.color.value_or(std::array<float, 3>{-1.0f, -1.0f, -1.0f});
    return {node.mesh, node.origin.has_value(), color};
  }
  Key keyOf(const SceneNode& node) const {
    const ShapeKey shape = shapeKeyOf(node);
    return {shape, with_named_uses_.contains(shape) ? node.name : std::string()};
  }

  void setColor(const TDF_Label& label, const SceneNode& node) {
    if (!node.color) return;
    const auto [r, g, b] = *node.color;
    colors_->SetColor(
        label,
        Quantity_Color(static_cast<double>(r), static_cast<double>(g), static_cast<double>(b), Quantity_TOC_sRGB),
        XCAFDoc_ColorSurf);
  }

  /// The part or assembly that a node is, without its placement.
  Expected<TDF_Label> define(std::size_t index) {
    const SceneNode& node = scene_.nodes[index];
    if (node.mesh >= 0 && children_[index].empty()) return definePart(node);
    const TDF_Label label = shapes_->NewShape();
    setName(label, node.name);
    if (node.mesh >= 0) {  // A solid with others below it: it becomes the first among them.
      auto own = definePart(node);
      if (!own) return own;
      setName(shapes_->AddComponent(label, *own, TopLoc_Location()), node.name);
    }
    for (std::size_t child : children_[index]) {
      HAPTICELL_TRY(use(child, label));
    }
    return label;
  }

  Expected<bool> use(std::size_t index, const TDF_Label& assembly) {
    const SceneNode& node = scene_.nodes[index];
    auto definition = define(index);
    HAPTICELL_TRY(definition);
    const TDF_Label component = shapes_->AddComponent(assembly, *definition, TopLoc_Location(transformOf(node.X_PN)));
    setName(component, node.instance.empty() ? node.name : node.instance);
    return true;
  }

  Expected<TDF_Label> definePart(const SceneNode& node) {
    const Key key = keyOf(node);
    if (const auto known = parts_.find(key); known != parts_.end()) return known->second;
    auto shape = shapeOf(node);
    HAPTICELL_TRY(shape);
    const TDF_Label label = shapes_->AddShape(*shape, false);
    setName(label, part_names_.at(key));
    setColor(label, node);
    if (node.origin) keepFaceColors(label, node);
    parts_[key] = label;
    parent_.progress(0.8 * static_cast<double>(parts_.size()) / static_cast<double>(scene_.nodes.size()),
                     Text("collecting"));
    return label;
  }

  Expected<TopoDS_Shape> shapeOf(const SceneNode& node) {
    if (node.origin) return exactShape(node);
    const geometry::TriangleMesh& mesh = scene_.meshes[static_cast<std::size_t>(node.mesh)];
    // Triangles as STEP faces: each is some lines of text, slow in any CAD program. Half, twice: other meshes are
    // refused with a message.
    constexpr std::size_t kMostFaces = 200'000;
    if (mesh.triangles.size() > kMostFaces) {
      return makeError({.place = "'" + node.name + "'",
                        .found = Text("%1 triangles", mesh.triangles.size()),
                        .expected = "at most 200000 as STEP faces",
                        .fix = "Export it as glTF or STL, or make the mesh coarser first."});
    }
    const TopoDS_Shape shape = facetedShape(mesh);
    if (shape.IsNull())
      return makeError({.place = "'" + node.name + "'", .found = "all triangles have zero area", .expected = "a mesh"});
    return shape;
  }

  Expected<TopoDS_Shape> exactShape(const SceneNode& node) {
    auto& source = sources_[node.origin->file];
    if (!source) {
      auto cad = openCad(node.origin->file, [](double, const Text&) {});
      if (!cad) {
        Error error = cad.error();
        error.place = node.origin->file;
        return makeError(error);
      }
      source = std::make_unique<SourceParts>(std::move(*cad), std::filesystem::path(node.origin->file).stem().string());
    }
    TopoDS_Shape shape = source->find(node.origin->part);
    if (shape.IsNull()) {
      return makeError({.place = "'" + node.name + "'",
                        .found = Text("no part '%1' in %2", node.origin->part, node.origin->file),
                        .expected = "the imported file, unchanged",
                        .fix = "Import it again."});
    }
    const double factor =
        node.origin->metres_per_unit > 0.0 ? node.origin->metres_per_unit / source->metresPerUnit() : 1.0;
    // Rounding of two units' quotient; 1 nm of a part of 1 m. Half, twice: no effect.
    constexpr double kSame = 1e-9;
    if (std::abs(factor - 1.0) < kSame) return copied(shape);
    gp_Trsf scaling;
    scaling.SetScale(gp_Pnt(), factor);
    return BRepBuilderAPI_Transform(shape, scaling, true).Shape();
  }

  /// The same shape as an object of its own, of the same faces: two parts of different names must not become one.
  static TopoDS_Shape copied(const TopoDS_Shape& shape) {
    TopoDS_Shape copy = shape.EmptyCopied();
    const BRep_Builder builder;
    for (TopoDS_Iterator below(shape, false, false); below.More(); below.Next()) builder.Add(copy, below.Value());
    copy.Closed(shape.Closed());
    return copy;
  }

  /// Faces keep colours of their own, unless the part was given another colour than any of them has.
  void keepFaceColors(const TDF_Label& label, const SceneNode& node) {
    const auto colored = sources_.at(node.origin->file)->coloredParts(node.origin->part);
    const auto isNodes = [&](const auto& part) { return plainColor(part.second) == node.color; };
    if (colored.size() < 2 || std::none_of(colored.begin(), colored.end(), isNodes)) return;
    for (const auto& [shape, color] : colored) {
      const TDF_Label below = shapes_->AddSubShape(label, shape);
      if (!below.IsNull()) colors_->SetColor(below, color, XCAFDoc_ColorSurf);
    }
  }

  const workcell::ImportedScene& scene_;
  ParentLink& parent_;
  CadDocument cad_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  std::vector<std::size_t> roots_;
  std::vector<std::vector<std::size_t>> children_;
  std::set<ShapeKey> with_named_uses_;
  std::map<Key, std::string> part_names_;
  std::map<Key, TDF_Label> parts_;
  std::map<std::string, std::unique_ptr<SourceParts>> sources_;
};

}  // namespace

Expected<void> writeStep(const workcell::ImportedScene& scene, const std::filesystem::path& file, ParentLink& parent) {
  const auto cad = StepBuilder(scene, parent).build();
  HAPTICELL_TRY(cad);
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  writer.SetLayerMode(false);
  writer.SetPropsMode(false);
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  parent.progress(0.85, Text("writing"));
  if (!writer.Transfer(cad->document, STEPControl_AsIs)) {
    return makeError({.found = "the parts cannot be written as STEP"});
  }
  if (writer.Write(file.c_str()) != IFSelect_RetDone) {
    return makeError({.found = "the file cannot be written", .expected = "free space and permission to write"});
  }
  return {};
}

}  // namespace hapticell::importer
