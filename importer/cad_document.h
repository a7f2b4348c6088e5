// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Message_ProgressRange.hxx>
#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <filesystem>
#include <functional>
#include <string>

#include "geometry/error.h"
#include "geometry/pose.h"

namespace hapticell::importer {

/// An OpenCASCADE document (shapes, names, colours as a tree; millimetres inside) and what its file said.
struct CadDocument {
  Handle(TDocStd_Document) document;
  std::string format;              ///< "step" or "iges".
  double metres_per_unit = 0.001;  ///< Of the file.
  bool unit_is_stated = false;
};

/// A new empty document.
CadDocument newCadDocument();

/// Reads STEP or IGES, told by the content. `progress` is given shares from 0 to 1. Errors in words; may throw.
Expected<CadDocument> openCad(const std::filesystem::path& file, const std::function<void(double)>& progress);

/// The name on a label; empty where there is none or one that some library made up.
std::string nameOf(const TDF_Label& label);

/// Metres and unit quaternion of a placement in millimetres times `factor`.
Pose poseOf(const TopLoc_Location& location, double factor);

}  // namespace hapticell::importer
