// SPDX-License-Identifier: Apache-2.0
// Nothing but the owner of the tests' precompiled header (tests/CMakeLists.txt).
int main() {}
