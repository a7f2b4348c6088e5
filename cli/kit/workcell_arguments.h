// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"
#include "workcell/entity/entity.h"
#include "workcell/entity/import_options.h"
#include "workcell/meshes/length_unit.h"

namespace hapticell::cli {

/// One `--add WHAT[,name=N][,unit=mm][,up=y][,tree=keep|merge][,chord=M][,angle=RAD][,on=NAME[:LINK]]
/// [,pose=x,y,z,qw,qx,qy,qz]`.
struct Addition {
  std::string what;
  std::string name;                 ///< Empty: by the file.
  workcell::ImportOptions options;  ///< Unit, up axis, tree or one solid, tessellation.
  Pose X_WE;
  std::string on;  ///< What it is attached to: an entity, or NAME:LINK; empty: nothing.
};

/// WHAT and names may contain commas, as long as no part begins with a known option; a quaternion need only be nearly
/// of length 1. An error names the wrong part.
Expected<Addition> parseAddition(const std::string& text);

/// One `--on FILE[,link=L][,pose=x,y,z,qw,qx,qy,qz]`: what carries something, and where on it.
struct Mounting {
  std::string what;
  std::string link;  ///< Empty: not given.
  Pose X_LE;
};

/// `option` is its name in errors: "--on".
Expected<Mounting> parseMounting(const std::string& option, const std::string& text);

/// Reads one `--check A+B:C+D[,near_miss=M][,safety=M]`; an empty side means everything. The set has no name yet.
Expected<workcell::PairSet> parseCheck(const std::string& text);

}  // namespace hapticell::cli
