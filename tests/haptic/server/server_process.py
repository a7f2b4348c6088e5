# SPDX-License-Identifier: Apache-2.0
"""Runs hapticell-haptic-server for a test and tells the port it chose."""
import re
import signal
import subprocess


class Server:
    def __init__(self, program, *options, environment=None):
        self.process = subprocess.Popen([program, "--port", "0", "--no-real-time", *options], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True, env=environment)
        self.line = self.process.stdout.readline()
        found = re.search(r"listens on (.*):(\d+): (.*) at (\S+) Hz", self.line)
        if not found:
            raise AssertionError(f"no port told: {self.line!r} {self.process.communicate()[1]!r}")
        self.port = int(found.group(2))

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def end(self, number=signal.SIGTERM):
        """Ends it by a signal; its exit status and what it wrote to standard error."""
        self.process.send_signal(number)
        return self.finish()

    def finish(self):
        errors = self.process.communicate(timeout=60)[1]
        return self.process.returncode, errors
