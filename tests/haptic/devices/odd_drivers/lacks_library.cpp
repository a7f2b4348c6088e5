// SPDX-License-Identifier: Apache-2.0
// A driver whose library is not installed.
extern "C" void* a_function_that_nobody_has();
extern "C" void* hapticell_driver(unsigned) {
  return a_function_that_nobody_has();
}
