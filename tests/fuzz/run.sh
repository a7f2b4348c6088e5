#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs fuzz targets one after the other, each for SECONDS (60): tests/fuzz/run.sh [-s SECONDS] [TARGET...]
# Seeds: tests/fuzz/corpus/TARGET and tests/importer/malformed. What is found new stays in build/fuzz/corpus/TARGET; what
# crashes, in build/fuzz/findings. Ends with 1 when something was found.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
seconds=60
if [ "${1:-}" = -s ]; then seconds=$2; shift 2; fi
build=$root/build/fuzz
[ $# -gt 0 ] || set -- $(cd "$build/bin" && ls -1 | sed -n 's/_fuzzer$//p')
mkdir -p "$build/findings"
# Readers of files get theirs in memory where the system has such a place.
[ -d /dev/shm ] && TMPDIR=${TMPDIR:-/dev/shm} && export TMPDIR
found=0
for target in "$@"; do
  mkdir -p "$build/corpus/$target"
  seeds=$root/tests/fuzz/corpus/$target
  [ -d "$seeds" ] || seeds=
  log=$build/findings/$target.log
  if nice "$build/bin/${target}_fuzzer" -max_total_time="$seconds" -max_len=8192 -timeout=10 -rss_limit_mb=2048 \
      -artifact_prefix="$build/findings/$target-" "$build/corpus/$target" $seeds "$root/tests/importer/malformed" \
      >"$log" 2>&1; then
    echo "$target: $(grep -o 'Done [0-9]* runs in [0-9]* second' "$log")s, nothing found"
  else
    found=1
    echo "$target: $(grep -m1 -E 'ERROR|SUMMARY|runtime error' "$log"), see $log"
  fi
done
exit $found
