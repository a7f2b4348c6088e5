// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/system/error.h"
#include "xacro/budget.h"
#include "xacro/expand.h"
#include "xacro/interpreter.h"
#include "xacro/scope.h"
#include "xacro/source_files.h"
#include "xacro/xml_node.h"

namespace hapticell::xacro {

/// Evaluates the texts of a description: the interpreter with the substitutions $(…), the arguments of the expansion,
/// and warnings at the current element. Throws Fault.
class Evaluator : public Surroundings {
 public:
  Evaluator(const Arguments& arguments, SourceFiles& sources, std::vector<DeclaredArgument>& declared,
            Diagnostics& diagnostics, Budget& budget);

  Value value(const std::string& text, Scope& scope) { return interpreter_.evaluateText(text, scope); }
  std::string text(const std::string& text, Scope& scope) { return interpreter_.textOfText(text, scope); }
  bool truth(const std::string& text, Scope& scope) { return conditionOf(value(text, scope), text); }
  /// The value of an attribute; a Fault gets its place.
  Value valueOf(const XmlNode::Attribute& attribute, const XmlNode& node, Scope& scope);
  Interpreter& interpreter() { return interpreter_; }
  Scopes& scopes() { return scopes_; }

  /// Takes an argument's value, or its default, unless it is known. One without either is reported where it is used.
  void declare(const std::string& name, const XmlNode& node, Scope& scope);
  void report(const std::string& file, const Text& place, const Text& sentence);

  Value substitution(const std::string& words, Scope& scope) override;
  std::string readText(const std::string& reference, std::string& file) override {
    return sources_.textOf(reference, file);
  }
  std::string absoluteName(const std::string& reference) override { return sources_.absoluteName(reference); }
  Value argument(const std::string& name) override;
  void warn(const Text& sentence) override;

  /// The element that is worked on, for as long as this lives.
  class At {
   public:
    At(Evaluator& evaluator, const XmlNode* node) : at_(evaluator.at_), before_(std::exchange(at_, node)) {}
    ~At() { at_ = before_; }
    At(const At&) = delete;
    At& operator=(const At&) = delete;

   private:
    const XmlNode*& at_;
    const XmlNode* before_;
  };

 private:
  const DeclaredArgument* findArgument(const std::string& name) const;
  Value environment(const std::string& words, bool optional);
  Value expression(const std::string& text, Scope& scope);

  Arguments arguments_;
  SourceFiles& sources_;
  std::vector<DeclaredArgument>& declared_;
  Diagnostics& diagnostics_;
  Budget& budget_;
  Interpreter interpreter_;
  Scopes scopes_;
  const XmlNode* at_ = nullptr;
};

}  // namespace hapticell::xacro
