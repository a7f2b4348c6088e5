// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace hapticell::xacro {

/// Keeps an entry on a stack during its own lifetime, also when an exception is thrown.
template <class T>
class Pushed {
 public:
  Pushed(std::vector<T>& stack, T value) : stack_(stack) { stack_.push_back(std::move(value)); }
  ~Pushed() { stack_.pop_back(); }
  Pushed(const Pushed&) = delete;
  Pushed& operator=(const Pushed&) = delete;

 private:
  std::vector<T>& stack_;
};

}  // namespace hapticell::xacro
