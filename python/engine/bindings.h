// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace hapticell::python {

// Each adds what Python sees of one subject to the module. In this order: later ones name classes of earlier ones.

void bindMeshes(pybind11::module_& module);
void bindScenes(pybind11::module_& module);
void bindRobots(pybind11::module_& module);
void bindTrajectories(pybind11::module_& module);
void bindWorkcells(pybind11::module_& module);
void bindJointChecks(pybind11::module_& module);
void bindFigures(pybind11::module_& module);
void bindSessions(pybind11::module_& module);
void bindClients(pybind11::module_& module);
void bindCommands(pybind11::module_& module);

}  // namespace hapticell::python
