#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No program or library has an empty entry in its unwind table at the address of a piece of code.

An exception that is thrown in that piece ends the program: the unwinder finds the empty entry and goes no further.

usage: unwind_entries.py FILE...
"""
import re
import subprocess
import sys


def entries(file):
    text = subprocess.run(["readelf", "--debug-dump=frames", "--wide", file], check=True, capture_output=True, text=True).stdout
    return [(int(low, 16), int(high, 16)) for low, high in re.findall(r" FDE .* pc=([0-9a-f]+)\.\.([0-9a-f]+)", text)]


failed = False
for file in sys.argv[1:]:
    found = entries(file)
    if not found:
        sys.exit(f"{file}: no unwind entries were found")
    taken = {low for low, high in found if low < high}
    empty = sorted({low for low, high in found if low == high} & taken)
    if empty:
        failed = True
        print(f"{file}: empty unwind entries at " + ", ".join(f"{low:#x}" for low in empty[:10]))
sys.exit(1 if failed else 0)
