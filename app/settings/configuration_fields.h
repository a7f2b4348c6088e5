// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "config/configuration.h"

namespace hapticell::app {

/// A setting of hapticell.toml as the window shows it.
struct ConfigurationField {
  std::string key;      ///< "manipulation.near_miss"
  QString name;         ///< In plain words and the window's language.
  QString unit;         ///< As shown; empty: none.
  double per_si = 1.0;  ///< Factor from the file's number to the shown number.
  int decimals = 1;
};

struct ConfigurationGroup {
  QString title;
  std::vector<ConfigurationField> fields;
};

/// All settings except those of the page Appearance, in the order of the page; offers the existing materials.
std::vector<ConfigurationGroup> configurationGroups(const config::Configuration& configuration);

/// "keep_position" in plain words.
QString choiceWords(const QString& choice);

}  // namespace hapticell::app
