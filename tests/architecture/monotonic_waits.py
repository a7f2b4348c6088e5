#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Nothing waits by a clock that can be set: a wait that ends at a time of day lasts for ever once the day is set back.

usage: monotonic_waits.py PROJECT | --self-test
"""
import pathlib
import re
import sys

FOLDERS = ("agents", "app", "bench", "cli", "collision", "config", "examples", "feel", "geometry", "haptic", "importer", "kinematics",
           "manipulation", "mannequin", "studies", "tests", "trajectory", "workcell", "xacro")
# What waits by CLOCK_REALTIME, or is asked to, and what to take instead.
FORBIDDEN = {
    r"\bCLOCK_REALTIME(_COARSE|_ALARM)?\b": "CLOCK_MONOTONIC",
    r"\bCLOCK_TAI\b": "CLOCK_MONOTONIC",
    r"\bTIME_UTC\b": "CLOCK_MONOTONIC",
    r"\bsem_timedwait\b": "sem_clockwait(.., CLOCK_MONOTONIC, ..)",
    r"\bpthread_cond_timedwait\b": "pthread_cond_clockwait",
    r"\bpthread_mutex_timedlock\b": "pthread_mutex_clocklock",
    r"\bpthread_rwlock_timed(rd|wr)lock\b": "pthread_rwlock_clockrdlock, pthread_rwlock_clockwrlock",
    r"\bpthread_timedjoin_np\b": "pthread_clockjoin_np",
    r"\bmq_timed(send|receive)\b": "poll() on the queue",
    r"\b(cnd_timedwait|mtx_timedlock)\b": "std::condition_variable with a time from now on",
    r"\bsystem_clock\b": "std::chrono::steady_clock (for a wait), QDateTime or std::time (for a date that is shown)",
    r"\b(utc|tai|gps|file)_clock::now\b": "std::chrono::steady_clock",
    r"\b(system_timer|deadline_timer)\b": "steady_timer",
    r"\bhigh_resolution_clock\b": "std::chrono::steady_clock: this one may be either",
    r"\bgettimeofday\b": "std::chrono::steady_clock",
    r"\bitimerspec\b": "a steady_timer",
}
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def offences(text):
    plain = COMMENT.sub(lambda comment: "\n" * comment.group().count("\n"), text)
    return [(plain.count("\n", 0, found.start()) + 1, found.group(), instead)
            for pattern, instead in FORBIDDEN.items() for found in re.finditer(pattern, plain)]


def self_test():
    assert [line for line, _, _ in offences("int a;\nsem_timedwait(&due, &until);")] == [2]
    assert offences("lock.wait_until(std::chrono::system_clock::now() + 1s)") and offences("asio::system_timer timer;")
    assert offences("pthread_cond_timedwait(&c, &m, &t)") and offences("clock_gettime(CLOCK_REALTIME, &t)")
    assert not offences("sem_clockwait(&due, CLOCK_MONOTONIC, &until); // unlike sem_timedwait\n/* CLOCK_REALTIME\n */")


if sys.argv[1] == "--self-test":
    self_test()
    sys.exit(0)
project, looked_at, found = pathlib.Path(sys.argv[1]), 0, []
for folder in FOLDERS:
    for source in sorted((project / folder).rglob("*")):
        if source.suffix in (".h", ".cpp"):
            looked_at += 1
            found += [f"{source.relative_to(project)}:{line}: {word} may wait by a clock that can be set: take {instead}"
                      for line, word, instead in offences(source.read_text(errors="replace"))]
print("\n".join(found))
assert looked_at > 500, f"only {looked_at} sources were found"
sys.exit(1 if found else 0)
