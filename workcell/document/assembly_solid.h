// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/shapes/triangle_mesh.h"
#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// The state in which the assembly `name` and all solids below it are one solid of that name, so that it can be held as
/// one body. The unchanged state if `name` is not an assembly, or one with robots or mechanisms below it.
DocumentState withAssemblyAsSolid(const DocumentState& state, const std::string& name);

/// One mesh made of an entity and everything below it in the tree (without robots), in the entity's frame: the shape of
/// an assembly while it is held. Empty if there is no mesh at all.
geometry::TriangleMesh mergedMesh(const DocumentState& state, EntityId id);

}  // namespace hapticell::workcell
