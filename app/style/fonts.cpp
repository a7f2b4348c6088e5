// SPDX-License-Identifier: Apache-2.0
#include "app/style/fonts.h"

#include <QStringList>

namespace hapticell::app {

QFont textFont(TextRole role) {
  struct Size {
    int pixels;
    QFont::Weight weight;
  };
  const auto size = [role]() -> Size {
    switch (role) {
      case TextRole::kText:
        return {13, QFont::Normal};
      case TextRole::kSecond:
        return {12, QFont::Normal};
      case TextRole::kKeyCap:
        return {11, QFont::Normal};
      case TextRole::kDockTitle:
      case TextRole::kSection:
        return {13, QFont::Medium};
      case TextRole::kNumberOverScene:
        return {15, QFont::Bold};
      case TextRole::kPanelState:
        return {16, QFont::Bold};
      case TextRole::kPanelNumber:
        return {20, QFont::Bold};
      case TextRole::kScore:
        return {30, QFont::Bold};
    }
    return {13, QFont::Normal};
  }();
  QFont result;
  result.setFamilies({"Roboto", "Noto Sans", "DejaVu Sans"});
  result.setPixelSize(size.pixels);
  result.setWeight(size.weight);
  result.setHintingPreference(QFont::PreferVerticalHinting);
  return result;
}

}  // namespace hapticell::app
