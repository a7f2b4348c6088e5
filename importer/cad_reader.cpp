// SPDX-License-Identifier: Apache-2.0
#include "importer/cad_reader.h"

#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "importer/cad_document.h"
#include "importer/library_fault.h"
#include "importer/shape_mesher.h"

namespace hapticell::importer {

namespace {

// Of the progress, the rest is meshing; by trial. Half, twice: the bar moves unevenly.
constexpr double kReading = 0.6;

using workcell::ImportedScene;
using workcell::SceneNode;

constexpr XCAFDoc_ColorType kColorTypes[] = {XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv};

/// Walks an OpenCASCADE document and builds the scene.
class CadSceneBuilder {
 public:
  CadSceneBuilder(const CadDocument& cad, const Reading& reading, ParentLink& parent)
      : reading_(reading),
        parent_(parent),
        shapes_(XCAFDoc_DocumentTool::ShapeTool(cad.document->Main())),
        colors_(XCAFDoc_DocumentTool::ColorTool(cad.document->Main())) {
    scene_.format = cad.format;
    scene_.warnings = cad.warnings;
    scene_.unit_is_stated = cad.unit_is_stated;
    scene_.metres_per_unit = reading.metres_per_unit.value_or(cad.metres_per_unit);
    factor_ = scene_.metres_per_unit / cad.metres_per_unit;
    tessellation_ = reading.tessellation;
    const double diagonal = 1e-3 * factor_ * diagonalOfAll();
    if (reading.relative_chord > 0.0 && diagonal > 0.0) tessellation_.chord = reading.relative_chord * diagonal;
    scene_.chord = tessellation_.chord;
  }

  Expected<ImportedScene> build(const CadDocument& cad) {
    const std::vector<CadNode> tree = treeOf(cad, reading_.file.stem().string());
    const auto at_top = std::count_if(tree.begin(), tree.end(), [](const CadNode& node) { return node.parent < 0; });
    total_ = countParts();
    tellAssumedNames(tree);
    for (const CadNode& node : tree) {
      if (scene_.format == "iges" && at_top > 1 && isLoose(node)) {
        gather(node);
      } else {
        place_.push_back(static_cast<int>(scene_.nodes.size()));
        add(node);
        continue;
      }
      place_.push_back(-1);
    }
    if (loose_shapes_ > 0) addLoose();
    warnOfMissingShapes();
    if (scene_.meshes.empty() && !first_fault_.empty())
      return makeError({.found = first_fault_,
                        .expected = "at least one part that can be read",
                        .fix = "Export it again, or in another format (STEP, glTF, STL)."});
    return std::move(scene_);
  }

 private:
  void tellAssumedNames(const std::vector<CadNode>& tree) {
    std::set<std::string> told;
    for (const CadNode& node : tree) {
      if (!node.replaced.empty() && told.insert(node.replaced).second)
        scene_.warnings.push_back(
            Text("the name '%1' says nothing; that of the file, '%2', is assumed", node.replaced, node.name));
    }
  }

  double diagonalOfAll() const {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    Bnd_Box box;
    for (const TDF_Label& root : roots) BRepBndLib::AddClose(XCAFDoc_ShapeTool::GetShape(root), box);
    return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
  }

  int countParts() const {
    TDF_LabelSequence all;
    shapes_->GetShapes(all);
    int parts = 0;
    for (const TDF_Label& label : all) parts += XCAFDoc_ShapeTool::IsSimpleShape(label) ? 1 : 0;
    return parts;
  }

  std::optional<std::array<float, 3>> colorOf(const TDF_Label& label) const {
    Quantity_Color color;
    for (XCAFDoc_ColorType type : kColorTypes) {
      if (colors_->GetColor(label, type, color)) return plainColor(color);
    }
    return std::nullopt;
  }

  /// Colours the faces of a coloured sub-shape, unless they have a colour of their own.
  void bindColors(const TDF_Label& label) {
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetSubShapes(label, parts);
    parts.Append(label);
    for (const bool faces_only : {true, false}) {
      for (const TDF_Label& part : parts) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
        Quantity_Color color;
        if (shape.IsNull() || (shape.ShapeType() == TopAbs_FACE) != faces_only) continue;
        for (XCAFDoc_ColorType type : kColorTypes) {
          if (!colors_->GetColor(part, type, color)) continue;
          for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
            if (!face_colors_.IsBound(faces.Current())) face_colors_.Bind(faces.Current(), color);
          }
          break;
        }
      }
    }
  }

  /// A surface at the top that belongs to no solid: IGES files may have thousands.
  static bool isLoose(const CadNode& node) {
    return node.parent < 0 && !node.assembly &&
           !TopExp_Explorer(XCAFDoc_ShapeTool::GetShape(node.label), TopAbs_SOLID).More();
  }

  void gather(const CadNode& node) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(node.label);
    if (shape.IsNull()) return;
    const BRep_Builder builder;
    if (loose_shapes_++ == 0) builder.MakeCompound(loose_);
    builder.Add(loose_, shape);
    bindColors(node.label);
  }

  void add(const CadNode& source) {
    SceneNode node;
    node.name = source.name;
    node.instance = source.instance;
    node.parent = source.parent < 0 ? -1 : place_[static_cast<std::size_t>(source.parent)];
    node.X_PN = poseOf(XCAFDoc_ShapeTool::GetLocation(source.label), factor_);
    node.color = colorOf(source.label);
    if (!node.color) node.color = colorOf(source.definition);
    if (!node.color && node.parent >= 0) node.color = scene_.nodes[static_cast<std::size_t>(node.parent)].color;
    if (!source.assembly) useMesh(source.definition, node);
    scene_.nodes.push_back(std::move(node));
  }

  void useMesh(const TDF_Label& definition, SceneNode& node) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(definition);
    if (shape.IsNull() || !TopExp_Explorer(shape, TopAbs_FACE).More()) {
      ++without_shape_;
      if (first_without_shape_.empty()) first_without_shape_ = node.name;
      return;
    }
    auto [known, is_new] = meshes_.try_emplace(definition.Tag());
    if (is_new) {
      bindColors(definition);
      known->second = addMesh(shape, node.name);
    }
    if (known->second.mesh < 0) return;
    node.mesh = known->second.mesh;
    if (!node.color || known->second.several_colors) {
      if (known->second.color) node.color = known->second.color;
    }
  }

  struct Known {
    int mesh = -1;
    std::optional<std::array<float, 3>> color;
    bool several_colors = false;
  };

  /// Nothing where the part is one at which the libraries give up; the others are there without it.
  std::optional<MeshedShape> meshedPart(const TopoDS_Shape& shape, const std::string& name) {
    const int number = ++done_, all = std::max(total_, done_);
    parent_.progress(kReading + (1.0 - kReading) * (number - 1) / all,
                     Text("meshing part %1 of %2, %3", number, all, name));
    Error fault{.found = "content that makes the reader crash"};
    if (!reading_.skipped.contains(number)) {
      parent_.beginPart(number);
      try {
        return meshShape(shape, factor_, tessellation_, face_colors_);
      } catch (const Standard_Failure& failure) {
        fault = libraryFault(failure.DynamicType()->Name());
      } catch (const std::bad_alloc&) {
        throw;
      } catch (const std::exception& failure) {
        fault = libraryFault(failure.what());
      }
    }
    scene_.warnings.push_back(Text("'%1' is left out: %2", name, fault.found));
    if (first_fault_.empty()) first_fault_ = fault.found;
    return std::nullopt;
  }

  Known addMesh(const TopoDS_Shape& shape, const std::string& name) {
    std::optional<MeshedShape> part = meshedPart(shape, name);
    if (!part) return {};
    MeshedShape& meshed = *part;
    if (meshed.missing_faces > 0) {
      scene_.warnings.push_back(Text("'%1': %2 of %3 faces could not be cut into triangles and are missing", name,
                                     meshed.missing_faces, meshed.faces));
    }
    if (meshed.several_colors) {
      scene_.warnings.push_back(
          Text("'%1' has faces of several colours; it is shown in the colour with the largest area", name));
    }
    Known known{-1, meshed.color, meshed.several_colors};
    if (meshed.mesh.triangles.empty()) return known;
    known.mesh = static_cast<int>(scene_.meshes.size());
    scene_.meshes.push_back(std::move(meshed.mesh));
    return known;
  }

  void addLoose() {
    SceneNode node;
    node.name = reading_.file.stem().string();
    const Known known = addMesh(loose_, node.name);
    node.mesh = known.mesh;
    node.color = known.color;
    scene_.nodes.push_back(std::move(node));
    scene_.warnings.push_back(Text("%1 surfaces that belong to no solid were put into one part", loose_shapes_));
  }

  void warnOfMissingShapes() {
    if (without_shape_ == 0) return;
    scene_.warnings.push_back(Text(
        "%1 parts have no shape (the first is '%2'): a file that they refer to is missing, or they contain only lines",
        without_shape_, first_without_shape_));
  }

  const Reading& reading_;
  ParentLink& parent_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  ImportedScene scene_;
  double factor_ = 1.0;
  workcell::Tessellation tessellation_;
  FaceColors face_colors_;
  std::vector<int> place_;  // Where in the scene each node of the document is.
  TopoDS_Compound loose_;
  int loose_shapes_ = 0;
  std::map<int, Known> meshes_;  // By the tag of the part's label.
  int total_ = 0;
  int done_ = 0;
  int without_shape_ = 0;
  std::string first_without_shape_;
  Text first_fault_;  ///< Why the first of the parts that are left out is.
};

}  // namespace

Expected<ImportedScene> readCad(const Reading& reading, ParentLink& parent) {
  parent.progress(0.02, Text("reading"));
  const auto cad =
      openCad(reading.file, [&](double share, const Text& stage) { parent.progress(kReading * share, stage); });
  HAPTICELL_TRY(cad);
  HAPTICELL_TRY(checkTree(*cad));
  return CadSceneBuilder(*cad, reading, parent).build(*cad);
}

}  // namespace hapticell::importer
