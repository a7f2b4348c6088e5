// SPDX-License-Identifier: Apache-2.0
#include "xacro/macro.h"

#include <cctype>

namespace hapticell::xacro {

namespace {

bool isBlank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

class ParameterReader {
 public:
  explicit ParameterReader(const std::string& text) : text_(text) {}

  bool skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
    return at_ < text_.size();
  }

  MacroParameter next() {
    MacroParameter parameter;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !isBlank(text_[at_]) && text_[at_] != '=' && text_[at_] != ':') ++at_;
    parameter.name = text_.substr(begin, at_ - begin);
    if (!takeAssignment()) {
      while (at_ < text_.size() && !isBlank(text_[at_])) ++at_;
      parameter.name = text_.substr(begin, at_ - begin);
      return parameter;
    }
    skipBlanks();
    if (at_ < text_.size() && text_[at_] == '^') {
      parameter.forwarded = true;
      at_ += text_.compare(at_, 2, "^|") == 0 ? 2 : 1;
    }
    std::string otherwise = value();
    if (!otherwise.empty()) parameter.otherwise = std::move(otherwise);
    return parameter;
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;

  /// "=" or ":=", with blanks around.
  bool takeAssignment() {
    std::size_t at = at_;
    while (at < text_.size() && isBlank(text_[at])) ++at;
    if (text_.compare(at, 2, ":=") == 0)
      at_ = at + 2;
    else if (text_.compare(at, 1, "=") == 0)
      at_ = at + 1;
    else
      return false;
    return true;
  }

  bool endsWord(std::size_t at) const { return at >= text_.size() || isBlank(text_[at]); }

  std::string value() {
    const std::size_t begin = at_;
    for (const auto& [open, close] : {std::pair("${", '}'), std::pair("$(", ')')}) {
      if (text_.compare(at_, 2, open) != 0) continue;
      for (std::size_t end = text_.find(close, at_); end != std::string::npos; end = text_.find(close, end + 1)) {
        if (!endsWord(end + 1)) continue;
        at_ = end + 1;
        return text_.substr(begin, at_ - begin);
      }
    }
    while (!endsWord(at_)) {
      const char c = text_[at_++];
      if (c != '\'' && c != '"') continue;
      const std::size_t end = text_.find(c, at_);
      if (end == std::string::npos)
        throw Fault{.found = "a default value without closing quote in params", .expected = std::string(1, c)};
      at_ = end + 1;
    }
    return text_.substr(begin, at_ - begin);
  }
};

}  // namespace

std::vector<MacroParameter> parametersOf(const std::string& text) {
  std::vector<MacroParameter> parameters;
  ParameterReader reader(text);
  while (reader.skipBlanks()) parameters.push_back(reader.next());
  return parameters;
}

void MacroScope::set(Macro macro) {
  const std::string name = macro.name;
  macros_[name] = std::make_shared<const Macro>(std::move(macro));
}

const Macro* MacroScope::find(const std::string& name) const {
  for (const MacroScope* scope = this; scope; scope = scope->parent_) {
    if (const auto found = scope->macros_.find(name); found != scope->macros_.end()) return found->second.get();
  }
  return nullptr;
}

MacroScope* MacroScope::findSpace(const std::string& name) const {
  for (const MacroScope* scope = this; scope; scope = scope->parent_) {
    if (const auto found = scope->spaces_.find(name); found != scope->spaces_.end()) return found->second;
  }
  return nullptr;
}

}  // namespace hapticell::xacro
