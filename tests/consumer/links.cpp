// SPDX-License-Identifier: Apache-2.0
// Nothing of its own: what it is linked with is the test.
int main() {}
