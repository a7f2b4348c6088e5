// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <map>
#include <string>
#include <vector>

#include "xacro/expand.h"

class QLineEdit;
class QVBoxLayout;

namespace hapticell::app {

/// A field for each argument of a xacro file: its name, its default as the field's hint, and the user's value. Hidden
/// if the file has no arguments.
class ArgumentFields : public QWidget {
  Q_OBJECT
 public:
  explicit ArgumentFields(QWidget* parent = nullptr);
  /// Makes the fields again if the file or its arguments have changed.
  void setArguments(int file, const std::vector<xacro::DeclaredArgument>& arguments,
                    const std::map<std::string, std::string>& values);

 signals:
  /// The values of the fields that are not empty.
  void changed(const std::map<std::string, std::string>& values);

 private:
  void fill(const std::vector<xacro::DeclaredArgument>& arguments);
  std::map<std::string, std::string> values() const;

  int file_ = 0;
  QWidget* rows_ = nullptr;
  std::map<std::string, QLineEdit*> fields_;
};

}  // namespace hapticell::app
