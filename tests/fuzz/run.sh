#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs fuzz targets one after the other until each has had SECONDS (60) of a processor: tests/fuzz/run.sh [-s SECONDS] [TARGET...]
# May be ended and called again: what a target has run is kept beside its corpus, and only the rest is run. The processor's
# seconds are counted, not the clock's: beside other work it takes longer, and is worth as much.
# Seeds: tests/fuzz/corpus/TARGET and tests/importer/malformed. What is found new stays in build/fuzz/corpus/TARGET; what
# crashes, in build/fuzz/findings. A finding takes the target back to none. Ends with 1 when something was found.
set -u
root=$(cd "$(dirname "$0")/../.." && pwd)
seconds=60
if [ "${1:-}" = -s ]; then seconds=$2; shift 2; fi
build=$root/build/fuzz
[ $# -gt 0 ] || set -- $(cd "$build/bin" && ls -1 | sed -n 's/_fuzzer$//p')
mkdir -p "$build/findings"
# Readers of files get theirs in memory where the system has such a place.
[ -d /dev/shm ] && TMPDIR=${TMPDIR:-/dev/shm} && export TMPDIR
piece=300  # Seconds at a stretch, so that little is lost when the whole is ended.
found=0
times=$build/findings/times.$$
# Processor's seconds of what has run until `times` was written last.
used() { tail -n 1 "$times" | tr 'ms' '  ' | awk '{ printf "%d\n", 60 * ($1 + $3) + $2 + $4 }'; }
for target in "$@"; do
  mkdir -p "$build/corpus/$target"
  seeds=$root/tests/fuzz/corpus/$target
  [ -d "$seeds" ] || seeds=
  log=$build/findings/$target.log
  run=$build/corpus/$target.seconds
  ran=$(cat "$run" 2>/dev/null || echo 0)
  while [ "$ran" -lt "$seconds" ]; do
    now=$((seconds - ran < piece ? seconds - ran : piece))
    times >"$times"
    before=$(used)
    if nice "$build/bin/${target}_fuzzer" -max_total_time="$now" -max_len=8192 -timeout=60 -rss_limit_mb=2048 \
        -artifact_prefix="$build/findings/$target-" "$build/corpus/$target" $seeds "$root/tests/importer/malformed" \
        >"$log" 2>&1; then
      times >"$times"
      ran=$((ran + $(used) - before + 1))
      echo "$ran" >"$run"
    else
      found=1
      rm -f "$run"
      echo "$target: $(grep -m1 -E 'ERROR|SUMMARY|runtime error' "$log"), see $log"
      continue 2
    fi
  done
  echo "$target: ${ran}s, $(find "$build/corpus/$target" -type f | wc -l) inputs kept, nothing found"
done
rm -f "$times"
exit $found
