// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>

#include "app/style/value_field.h"

class QCheckBox;

namespace hapticell::app {

/// A number with a check box that says whether it is known. GUI thread.
class KnownField : public QWidget {
  Q_OBJECT
 public:
  /// The field gets the object name `name`, the box `name` plus "Known"; `words` for screen readers.
  KnownField(const char* name, const QString& words, const ValueField::Format& format, QWidget* parent = nullptr);
  /// Sets the value, unless the user is typing into the field.
  void setValue(const std::optional<double>& value);
  ValueField& field() { return *field_; }

 signals:
  void edited(const std::optional<double>& value);

 private:
  ValueField* field_;
  QCheckBox* known_;
};

}  // namespace hapticell::app
