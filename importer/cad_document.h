// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Message_ProgressRange.hxx>
#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "geometry/shapes/pose.h"

namespace hapticell::importer {

/// An OpenCASCADE document (shapes, names, colours as a tree; millimetres inside) and what its file said.
struct CadDocument {
  Handle(TDocStd_Document) document;
  std::string format;              ///< "step" or "iges".
  double metres_per_unit = 0.001;  ///< Of the file.
  bool unit_is_stated = false;
  std::vector<std::string> warnings;  ///< What was left out or assumed before the library read it.
};

/// A new empty document.
CadDocument newCadDocument();

/// Is given the share that is done, from 0 to 1, and what is going on.
using CadProgress = std::function<void(double, const std::string&)>;

/// Reads STEP or IGES, told by the content. Errors in words; may throw.
Expected<CadDocument> openCad(const std::filesystem::path& file, const CadProgress& progress);

/// A node of the tree in such a document: a part or an assembly, or the use of one.
struct CadNode {
  TDF_Label label;       ///< The use.
  TDF_Label definition;  ///< What is used; `label` itself at the top.
  std::string name;      ///< Of the part; where it has none that of the use, else a made-up one.
  std::string instance;  ///< Of the use, where it differs.
  int parent = -1;
  bool assembly = false;
};

/// Counted before it is walked through: assemblies that stand in each other many times over, or in themselves.
Expected<void> checkTree(const CadDocument& cad);

/// All nodes, parents first. The assembly that our own STEP files may have around everything is left out. `stem` names
/// a nameless part at the top.
std::vector<CadNode> treeOf(const CadDocument& cad, const std::string& stem);

/// The name on a label; empty where there is none or one that some library made up.
std::string nameOf(const TDF_Label& label);

/// Metres and unit quaternion of a placement in millimetres times `factor`.
Pose poseOf(const TopLoc_Location& location, double factor);

}  // namespace hapticell::importer
