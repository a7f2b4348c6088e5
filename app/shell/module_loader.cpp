// SPDX-License-Identifier: Apache-2.0
#include "app/shell/module_loader.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibrary>
#include <QPluginLoader>

#include "app/style/library_text.h"
#include "config/user_folders.h"

namespace hapticell::app {

ModuleLoader::ModuleLoader() = default;

ModuleLoader::~ModuleLoader() {
  for (Module* module : modules_) module->stop();
}

QStringList ModuleLoader::defaultFolders() {
  const QDir program(QCoreApplication::applicationDirPath());
  return {program.filePath("modules"), program.filePath("../" HAPTICELL_LIBRARY_FOLDER "/hapticell/modules")};
}

void ModuleLoader::load(const QStringList& folders) {
  QStringList seen;
  for (const QString& folder : folders) {
    const QDir directory(folder);
    for (const QFileInfo& file : directory.entryInfoList({"*hapticell-module-*"}, QDir::Files, QDir::Name)) {
      if (!QLibrary::isLibrary(file.fileName()) || seen.contains(file.fileName())) continue;
      seen << file.fileName();
      if (const auto trusted = config::checkPlugIn(file.absoluteFilePath().toStdString()); !trusted) {
        problems_ << QCoreApplication::translate("ModuleLoader", "The module %1 was not loaded. %2")
                         .arg(file.fileName(), shownText(trusted.error()));
        continue;
      }
      auto loader = std::make_unique<QPluginLoader>(file.absoluteFilePath());
      Module* module = qobject_cast<Module*>(loader->instance());
      if (!module) {
        problems_ << QCoreApplication::translate("ModuleLoader", "The module %1 was not loaded. %2")
                         .arg(file.fileName(), loader->errorString());
        continue;
      }
      modules_.push_back(module);
      loaders_.push_back(std::move(loader));
    }
  }
}

}  // namespace hapticell::app
