// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QtPlugin>

namespace hapticell::app {

class Host;

/// A program part that the window finds at run time: a shared library `hapticell-module-NAME` in the folder `modules`
/// beside the program, whose Qt plug-in root object implements this. GUI thread.
class Module {
 public:
  virtual ~Module() = default;
  virtual QString name() const = 0;      ///< As the Applications menu shows it.
  virtual QString iconName() const = 0;  ///< One of the program's icons.
  virtual QString purpose() const = 0;   ///< One sentence for the tool tip.
  /// Opens its docks and starts its work. If it already runs, brings its dock to the front.
  virtual void start(Host& host) = 0;
  /// Ends its work and removes its docks. Does nothing if it does not run.
  virtual void stop() = 0;
  virtual bool isRunning() const = 0;
};

}  // namespace hapticell::app

#define HAPTICELL_MODULE_IID "org.hapticell.Module/1"
Q_DECLARE_INTERFACE(hapticell::app::Module, HAPTICELL_MODULE_IID)
