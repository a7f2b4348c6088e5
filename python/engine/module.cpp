// SPDX-License-Identifier: Apache-2.0
#include "python/engine/bindings.h"

PYBIND11_MODULE(_engine, module) {
  namespace python = hapticell::python;
  module.doc() = "HaptiCell's engine. Use it as `import hapticell`.";
  module.attr("__version__") = HAPTICELL_VERSION;
  python::bindMeshes(module);
  python::bindScenes(module);
  python::bindRobots(module);
  python::bindTrajectories(module);
  python::bindWorkcells(module);
  python::bindJointChecks(module);
  python::bindFigures(module);
  python::bindSessions(module);
  python::bindClients(module);
  python::bindCommands(module);
}
