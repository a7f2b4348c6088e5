#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which libraries programs and shared libraries need, with all that those need (NEEDED, by ldd).

needed_libraries.py PATTERN FILE...           fails if FILE needs a library whose name matches lib(PATTERN)
needed_libraries.py --found PATTERN FILE...   the other way round: fails unless it needs one for each word of PATTERN
"""

import re
import subprocess
import sys


def needed(file):
    listed = subprocess.run(["ldd", file], capture_output=True, text=True, check=True).stdout
    return [line.split()[0].rsplit("/", 1)[-1] for line in listed.splitlines() if line.strip()]


def main(arguments):
    wanted = arguments[:1] == ["--found"]
    pattern, *files = arguments[1:] if wanted else arguments
    faults = []
    for file in files:
        libraries = needed(file)
        if not any(name.startswith("libc.so") for name in libraries):
            faults.append(f"{file}: not even libc among {libraries}")
        for word in pattern.split("|") if wanted else [pattern]:
            matching = sorted(name for name in libraries if re.match(f"lib({word})", name))
            if wanted and not matching:
                faults.append(f"{file} needs no lib{word}")
            if not wanted and matching:
                faults.append(f"{file} needs {', '.join(matching)}")
    print("\n".join(faults) or f"{len(files)} files: as they should be")
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
