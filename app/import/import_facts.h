// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QString>

#include "app/import/import_choices.h"
#include "workcell/import/imported_entities.h"

namespace hapticell::app {

/// Facts of a file after reading, and its preview.
struct ImportFacts {
  QString format;                       ///< "STEP AP214", "STL" ...
  qint64 bytes = 0;                     ///< Of the file.
  dvec3 size{0.0};                      ///< Metres along x, y and z, as placed in the cell.
  double metres_per_unit = 1.0;         ///< As used for reading.
  bool unit_is_stated = false;          ///< The file states its unit.
  double likely_metres_per_unit = 1.0;  ///< Guessed from the size if the file states no unit.
  bool unit_is_open = false;            ///< The file states no unit, and the size does not suggest one.
  workcell::UpAxis up_axis = workcell::UpAxis::kZ;
  std::size_t parts = 0, triangles = 0;
  bool can_be_cut_finer = false;                   ///< STEP and IGES; other formats contain triangles.
  double chord = 0.0;                              ///< Chord error, metres.
  QImage picture;                                  ///< Transparent background.
  bool robot = false;                              ///< Unit, up axis and tree are defined by its format.
  bool incomplete = false;                         ///< A xacro that cannot be read until an argument has a value.
  std::vector<xacro::DeclaredArgument> arguments;  ///< Of a xacro.
};

/// Determines size and picture of an import. `picture_size` in device pixels. Any thread; 0.1 s per million triangles.
ImportFacts factsOf(const workcell::ImportResult& result, const QString& path, QSize picture_size);

/// "STEP AP214" from the header of a STEP file, else the format's name in capitals.
QString formatText(const std::string& format, const QString& path);

}  // namespace hapticell::app
