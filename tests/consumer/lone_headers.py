#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles every installed header by itself, in parallel, and sees that it includes installed ones only.

usage: lone_headers.py INCLUDE_FOLDER COMPILER [FLAG...]

Nearly all of the time goes into a few headers that most others include. These are precompiled; a header is compiled with the
one of them that it includes anyway, so that nothing is there for it that it has not asked for.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([^">]+)[">]', re.MULTILINE)
BASES = 14
# How long a header of others takes to parse, in hundredths of a second; others of them 3, the project's own 1.
WEIGHTS = {"filesystem": 50, "functional": 25, "chrono": 25, "thread": 25, "future": 25, "condition_variable": 25, "mutex": 15,
           "memory": 15, "string": 15, "map": 10, "variant": 10, "algorithm": 25, "random": 30, "glm/glm.hpp": 40,
           "glm/gtc/quaternion.hpp": 25, "tl/expected.hpp": 10, "nlohmann/json.hpp": 100}


def closures(folder):
    """What each header includes, itself and through others; the project's folders are known by their names."""
    direct, tops = {}, {path.name for path in folder.iterdir() if path.is_dir()}
    for path in sorted(folder.rglob("*.h")):
        direct[path.relative_to(folder).as_posix()] = INCLUDE.findall(path.read_text(encoding="utf-8"))
    missing = [f"{name} includes {used}, which is not installed" for name, list_ in direct.items() for used in list_
               if used.split("/")[0] in tops and "/" in used and used not in direct]
    whole = {}
    for name in direct:
        seen, todo = set(), [name]
        while todo:
            for used in direct.get(todo.pop(), []):
                if used not in seen:
                    seen.add(used)
                    todo.append(used)
        whole[name] = seen
    return whole, missing


def chosen_bases(whole):
    """The headers whose precompilation spares most: by how much they include, and by how many include them."""
    def weight(name):
        return 1 + sum(1 if used in whole else WEIGHTS.get(used, 3) for used in whole[name])

    best = dict.fromkeys(whole, 0)
    bases = []
    for _ in range(BASES):
        gains = {base: sum(max(0, weight(base) - best[name]) for name in whole if base in whole[name])
                 for base in whole if base not in bases}
        base = max(gains, key=lambda one: (gains[one], one), default=None)
        if base is None or gains[base] == 0:
            break
        bases.append(base)
        for name in whole:
            if base in whole[name]:
                best[name] = max(best[name], weight(base))
    return bases


def main():
    folder, compiler = pathlib.Path(sys.argv[1]), sys.argv[2]
    flags = ["-std=c++20", "-DGLM_FORCE_CTOR_INIT", "-DGLM_ENABLE_EXPERIMENTAL", "-I", str(folder), *sys.argv[3:]]
    whole, bad = closures(folder)
    assert whole, f"no header in {folder}"
    bases = chosen_bases(whole)
    with tempfile.TemporaryDirectory() as work, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:

        def run(words):
            return subprocess.run([compiler, *flags, *words], capture_output=True, text=True, check=False)

        def precompile(number):
            header = pathlib.Path(work, f"base_{number}.h")
            header.write_text(f"#include <{bases[number]}>\n", encoding="utf-8")
            return run(["-x", "c++-header", str(header), "-o", f"{header}.gch"])

        def compile_alone(name):
            within = [number for number, base in enumerate(bases) if base in whole[name]]
            number = max(within, key=lambda one: len(whole[bases[one]]), default=None)  # The largest of them.
            first = [] if number is None else ["-include", f"{work}/base_{number}.h"]
            source = pathlib.Path(work, name.replace("/", "__") + ".cpp")
            source.write_text(f"#include <{name}>\n", encoding="utf-8")
            return name, run([*first, "-fsyntax-only", str(source)])

        for result in pool.map(precompile, range(len(bases))):
            bad += [result.stderr] if result.returncode else []
        for name, result in pool.map(compile_alone, whole):
            bad += [f"{name} does not compile by itself:\n{result.stderr[:2000]}"] if result.returncode else []
    print("\n".join(bad) if bad else f"{len(whole)} headers compile by themselves")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
