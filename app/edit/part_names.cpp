// SPDX-License-Identifier: Apache-2.0
#include "app/edit/part_names.h"

#include <QCoreApplication>
#include <map>
#include <string_view>

namespace hapticell::app {
namespace {

/// Words of the workcell library, in the language of the window; what is not there is shown as it is.
QString translated(const std::map<std::string_view, const char*>& words, const char* word) {
  const auto found = words.find(word);
  return found == words.end() ? QString::fromLatin1(word) : QCoreApplication::translate("BuiltInPart", found->second);
}

}  // namespace

QString partName(const workcell::BuiltInPart& part) {
  static const std::map<std::string_view, const char*> names{
      {"box", QT_TRANSLATE_NOOP("BuiltInPart", "Box")},
      {"cylinder", QT_TRANSLATE_NOOP("BuiltInPart", "Cylinder")},
      {"sphere", QT_TRANSLATE_NOOP("BuiltInPart", "Sphere")},
      {"cone", QT_TRANSLATE_NOOP("BuiltInPart", "Cone")},
      {"pipe", QT_TRANSLATE_NOOP("BuiltInPart", "Pipe")},
      {"table", QT_TRANSLATE_NOOP("BuiltInPart", "Table")},
      {"bench", QT_TRANSLATE_NOOP("BuiltInPart", "Adjustable bench")},
      {"shelf", QT_TRANSLATE_NOOP("BuiltInPart", "Shelf")},
      {"cabinet", QT_TRANSLATE_NOOP("BuiltInPart", "Cabinet")},
      {"stool", QT_TRANSLATE_NOOP("BuiltInPart", "Stool")},
      {"chair", QT_TRANSLATE_NOOP("BuiltInPart", "Chair")},
      {"pallet", QT_TRANSLATE_NOOP("BuiltInPart", "Pallet")},
      {"fence", QT_TRANSLATE_NOOP("BuiltInPart", "Fence")},
      {"conveyor", QT_TRANSLATE_NOOP("BuiltInPart", "Conveyor")},
      {"gripper", QT_TRANSLATE_NOOP("BuiltInPart", "Gripper")},
  };
  return translated(names, part.scheme);
}

QString sizeName(const workcell::PartSize& size) {
  static const std::map<std::string_view, const char*> names{
      {"length", QT_TRANSLATE_NOOP("BuiltInPart", "Length")},
      {"width", QT_TRANSLATE_NOOP("BuiltInPart", "Width")},
      {"depth", QT_TRANSLATE_NOOP("BuiltInPart", "Depth")},
      {"height", QT_TRANSLATE_NOOP("BuiltInPart", "Height")},
      {"seat height", QT_TRANSLATE_NOOP("BuiltInPart", "Seat height")},
      {"radius", QT_TRANSLATE_NOOP("BuiltInPart", "Radius")},
      {"outer radius", QT_TRANSLATE_NOOP("BuiltInPart", "Outer radius")},
      {"inner radius", QT_TRANSLATE_NOOP("BuiltInPart", "Inner radius")},
      {"opening", QT_TRANSLATE_NOOP("BuiltInPart", "Opening")},
  };
  return translated(names, size.name);
}

}  // namespace hapticell::app
