// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "app/host/module.h"

class QPluginLoader;

namespace hapticell::app {

/// Finds and keeps the modules. Its destructor stops them, but does not unload them.
class ModuleLoader {
 public:
  ModuleLoader();
  ~ModuleLoader();
  /// Loads every hapticell-module-* of the folders; problems() lists those that cannot be loaded.
  void load(const QStringList& folders);
  /// The folders to search: `modules` next to the program, then hapticell/modules in the lib folder of the
  /// installation.
  static QStringList defaultFolders();
  const std::vector<Module*>& modules() const { return modules_; }
  const QStringList& problems() const { return problems_; }

 private:
  std::vector<std::unique_ptr<QPluginLoader>> loaders_;
  std::vector<Module*> modules_;
  QStringList problems_;
};

}  // namespace hapticell::app
