// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "workcell/document/command.h"

class QCheckBox;
class QComboBox;
class QVBoxLayout;
class QWidget;

namespace hapticell::app {

class Host;
class Segmented;
class SwatchRow;
class ValueField;

/// How the selected entity feels and looks, whether it is checked and locked. Each choice is a command of the document.
/// GUI thread.
class EntityChoices : public QObject {
  Q_OBJECT
 public:
  /// The host must outlive it.
  EntityChoices(Host& host, QVBoxLayout& all, QObject* parent = nullptr);
  /// Shows the choices of the document.
  void show();

 private:
  void connectChoices();
  void execute(workcell::SetProperties change);
  const workcell::Entity* entity() const;

  Host& host_;
  QWidget* feel_;  ///< How the entity feels and looks; hidden for frames.
  Segmented *on_contact_, *force_class_;
  QComboBox* material_;
  ValueField* mass_;
  SwatchRow* swatches_;
  QCheckBox *checked_, *locked_;
};

}  // namespace hapticell::app
