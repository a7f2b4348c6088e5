# SPDX-License-Identifier: Apache-2.0
"""The interpreter behind the window's Python console: a process of its own that the window starts.

Both talk in lines of JSON. The window says "run", "script" or "complete"; before the first two it says the cell, if it has
changed. The interpreter says what was printed, and at the end of each the cell, if that has changed: the window then makes it
one step of undo. Whatever happens here cannot take the cell of the window.
"""
import ast
import builtins
import codeop
import faulthandler
import json
import linecache
import os
import pathlib
import queue
import re
import rlcompleter
import signal
import sys
import threading
import time
import traceback

#: Letters in one message. Half: more messages; twice: the window shows them in larger pieces.
_PIECE = 1 << 15
#: Messages that wait to be sent; then whoever prints waits. Half, twice: as well.
_WAITING = 16
#: Seconds after a full piece, so that endless printing leaves the window time. Half, twice: more or less of it is shown.
_PAUSE = 0.02
#: Completions that are offered.
_MOST_WORDS = 200


class _Line:
    """Sends messages from a thread of its own, so that Ctrl+C never cuts one in two.

    What KeyboardInterrupt may break into has no lock of Python's: the queue is C, and waiting is sleeping.
    """

    def __init__(self, file):
        self._file = file
        self._queue = queue.SimpleQueue()
        self._thread = threading.Thread(target=self._send, daemon=True)
        self._thread.start()

    def say(self, **message):
        while self._queue.qsize() > _WAITING:
            time.sleep(_PAUSE / 10)
        self._queue.put(message)

    def end(self):
        """Waits until all is sent."""
        self._queue.put(None)
        self._thread.join()

    def _send(self):
        message = self._queue.get()
        while message is not None:
            following = None
            # What is printed in small pieces goes in one.
            while message["say"] in ("out", "err") and len(message["text"]) < _PIECE:
                try:
                    following = self._queue.get_nowait()
                except queue.Empty:
                    break
                if following is None or following["say"] != message["say"]:
                    break
                message["text"] += following["text"]
                following = None
            self._write(message)
            message = following if following is not None else self._queue.get()

    def _write(self, message):
        try:
            self._file.write(json.dumps(message) + "\n")
            self._file.flush()
        except OSError:
            os._exit(0)  # The window is gone.
        if len(message.get("text", "")) >= _PIECE:
            time.sleep(_PAUSE)


class _Printed:
    """sys.stdout or sys.stderr."""

    encoding = "utf-8"
    errors = "replace"

    def __init__(self, line, what):
        self._line = line
        self._what = what

    def write(self, text):
        if not isinstance(text, str):
            raise TypeError(f"write() takes a str, not {type(text).__name__}")
        for begin in range(0, len(text), _PIECE):
            self._line.say(say=self._what, text=text[begin:begin + _PIECE])
        return len(text)

    def writelines(self, lines):
        for line in lines:
            self.write(line)

    def flush(self):
        pass

    def isatty(self):
        return False

    def writable(self):
        return True


def is_complete(source):
    """False if more lines must follow. Text with an error counts as complete: running it says what is wrong."""
    try:
        return codeop.compile_command(source, "<console>", "single") is not None
    except (SyntaxError, ValueError, OverflowError):
        return True


def run_source(source, name, namespace):
    """Runs statements; the value of an expression at the end is shown, as Python's own console does."""
    linecache.cache[name] = (len(source), None, [line + "\n" for line in source.split("\n")], name)
    statements = ast.parse(source, name).body
    last = statements.pop() if statements and isinstance(statements[-1], ast.Expr) else None
    if statements:
        exec(compile(ast.Module(statements, []), name, "exec"), namespace)
    if last is not None:
        exec(compile(ast.Interactive([last]), name, "single"), namespace)


def complete(text, namespace, cell):
    """(where the completed word begins, its completions) for the text before the cursor."""
    quoted = re.search(r"""[\[(]\s*["']([^"'\n]*)$""", text)
    if quoted:
        return quoted.start(1), [name for name in cell.names if name.startswith(quoted[1])][:_MOST_WORDS]
    start = re.search(r"[A-Za-z_0-9.]*$", text).start()
    word = text[start:]
    if not word:
        return start, []
    words, completer = [], rlcompleter.Completer(namespace)
    for state in range(_MOST_WORDS):
        found = completer.complete(word, state)
        if found is None:
            break
        if found.rstrip("( ") not in [one.rstrip("( ") for one in words]:
            words.append(found)
    return start, words


class Console:
    """Answers the window."""

    def __init__(self, line):
        import hapticell

        self._line = line
        self._engine = hapticell
        self._cell = hapticell.Workcell()
        self._revision = self._cell._revision
        self._folder = "/"
        self._names = {"__name__": "__main__", "__builtins__": builtins, "hapticell": hapticell}
        self._put_names([])

    def answer(self, message):
        kind = message["do"]
        if kind == "complete":
            start, words = self._completed(message["text"])
            return self._line.say(say="words", id=message["id"], start=start, words=words)
        if kind == "run" and not is_complete(message["source"]):
            return self._line.say(say="more", id=message["id"])
        self._line.say(say="begin", id=message["id"])
        if "cell" in message:
            self._take(message["cell"])
        self._put_names(message.get("selection", []))
        if kind == "script":
            self._guarded(lambda: self._run_script(message["file"]))
        else:
            self._guarded(lambda: run_source(message["source"], f"<console {message['id']}>", self._names))
        self._finish(message["id"])
        return None

    def _take(self, cell):
        self._folder = cell["folder"]
        self._cell._take_document(cell["text"], cell["folder"], cell["path"])
        self._revision = self._cell._revision
        if cell["path"]:
            try:
                os.chdir(cell["folder"])
            except OSError:
                pass

    def _put_names(self, selection):
        if self._names.get("cell", self._cell) is not self._cell:
            self._line.say(say="err", text="`cell` is the cell of the window again.\n")
        self._names["cell"] = self._cell
        self._names["selection"] = selection

    def _completed(self, text):
        try:
            return complete(text, self._names, self._cell)
        except Exception:  # A property that raises: there is nothing to offer.
            return len(text), []

    def _run_script(self, file):
        names = {"__name__": "__main__", "__builtins__": builtins, "__file__": file, "hapticell": self._engine,
                 "cell": self._cell, "selection": self._names["selection"]}
        source = pathlib.Path(file).read_bytes()
        exec(compile(source, file, "exec"), names)

    def _guarded(self, work):
        """Runs it; Ctrl+C counts only here."""
        try:
            try:
                signal.signal(signal.SIGINT, signal.default_int_handler)
                work()
            finally:
                signal.signal(signal.SIGINT, signal.SIG_IGN)
        except SystemExit as end:
            if end.code not in (None, 0):
                self._line.say(say="err", text=f"{end.code if isinstance(end.code, str) else f'exit status {end.code}'}\n")
        except KeyboardInterrupt:
            self._line.say(say="err", text="KeyboardInterrupt\n")
        except BaseException as error:  # noqa: BLE001: whatever a user's text raises is the user's to see.
            self._line.say(say="err", text=_words_of(error))

    def _finish(self, number):
        """Says the cell, if it is another now."""
        if self._cell._in_step:
            self._cell._cancel_step()
        changed = None
        if self._cell._revision != self._revision:
            self._revision = self._cell._revision
            steps = self._cell.history
            changed = {"text": self._cell._document_text(self._folder), "step": steps[0] if len(steps) == 1 else ""}
        self._line.say(say="done", id=number, cell=changed)


def _words_of(error):
    """The traceback without the frames of this file."""
    trace = error.__traceback__
    while trace is not None and trace.tb_frame.f_code.co_filename == __file__:
        trace = trace.tb_next
    return "".join(traceback.format_exception(type(error), error, trace))


def main():
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # The line to the window is this module's alone: what others print goes to standard error, and they read nothing.
    heard = os.fdopen(os.dup(0), "r", encoding="utf-8", newline="\n")
    told = os.fdopen(os.dup(1), "w", encoding="utf-8", newline="\n")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    faulthandler.enable(os.fdopen(os.dup(2), "w"))
    line = _Line(told)
    sys.stdout, sys.stderr = _Printed(line, "out"), _Printed(line, "err")
    console = Console(line)
    line.say(say="ready", version=".".join(map(str, sys.version_info[:3])))
    for text in heard:
        try:
            console.answer(json.loads(text))
        except Exception as error:  # A text that cannot be read here: the window must hear of it.
            line.say(say="err", text=_words_of(error))
            line.say(say="done", id=-1, cell=None)
    line.end()


if __name__ == "__main__":
    main()
