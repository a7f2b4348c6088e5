# SPDX-License-Identifier: Apache-2.0
"""Every command of hapticell-cli as a function of the same name, made from the program's own grammar.

A command runs in this process by the same code, without the interpreter's lock; Ctrl+C ends it.
"""
import inspect
import json
import keyword
import os
import pathlib
import tempfile

from . import _engine
from ._results import Result

#: Header lines of tables that are given as arrays, by the number of their columns.
_COLUMNS = {
    7: "x,y,z,qw,qx,qy,qz",
    8: "t,x,y,z,qw,qx,qy,qz",
    9: "t,x,y,z,qw,qx,qy,qz,button",
}


def python_name(option):
    """"--collision-free" -> "collision_free", "--from" -> "from_"."""
    name = option.lstrip("-").replace("-", "_")
    return name + "_" if keyword.iskeyword(name) else name


def _number(value):
    return repr(float(value)) if isinstance(value, float) or hasattr(value, "dtype") and value.dtype.kind == "f" else str(value)


class _Scratch:
    """Files for values that a command reads as a file; they are gone after it."""

    def __init__(self):
        self._folder = None
        self._count = 0

    def path(self, ending):
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="hapticell-")
        self._count += 1
        return pathlib.Path(self._folder.name) / f"{self._count}{ending}"

    def close(self):
        if self._folder is not None:
            self._folder.cleanup()

    def table(self, header, rows):
        path = self.path(".csv")
        lines = (",".join(_number(value) for value in row) for row in rows)
        path.write_text("\n".join([header, *lines]) + "\n", encoding="utf-8")
        return str(path)

    def json(self, value):
        path = self.path(".json")
        path.write_text(json.dumps(value, default=_plain), encoding="utf-8")
        return str(path)


def _plain(value):
    return value.tolist() if hasattr(value, "tolist") else dict(value)


def _is_sequence(value):
    return isinstance(value, (list, tuple)) or hasattr(value, "dtype") and getattr(value, "ndim", 0) > 0


def _as_file(option, value, scratch):
    """The path of a file that stands for `value`, or None where it needs none."""
    if isinstance(value, _engine.Workcell):
        path = scratch.path(".hcell")
        value._write_copy(path)
        return str(path)
    if isinstance(value, _engine.Trajectory):
        path = scratch.path(".htraj")
        value.save(path)
        return str(path)
    if isinstance(value, _engine.Mesh):
        path = scratch.path(".obj")
        value.save(path)
        return str(path)
    if option["kind"] == "JSON" and isinstance(value, (dict, list)):
        return scratch.json(value)
    if isinstance(value, dict):
        return scratch.table(",".join(value), zip(*value.values()))
    if getattr(getattr(value, "dtype", None), "names", None):
        return scratch.table(",".join(value.dtype.names), value)
    if _is_sequence(value) and len(value) > 0 and _is_sequence(value[0]):
        width = len(value[0])
        if width not in _COLUMNS:
            raise _error(option, f"an array of {width} columns",
                         "a dict or a structured array, whose names are the columns")
        return scratch.table(_COLUMNS[width], value)
    return None


def _error(option, found, expected):
    from ._errors import Error

    return Error(place=option["name"], found=found, expected=expected,
                 message=f"{option['name']}: {found}; expected {expected}.")


def _word(option, value, scratch):
    file = _as_file(option, value, scratch)
    if file is not None:
        return file
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if _is_sequence(value):
        return ",".join(_number(one) for one in value)
    return _number(value)


def _values(option, value, scratch):
    """The words that `value` stands for."""
    many = option["repeated"] or option["values"][1] != 1
    if many and isinstance(value, dict) and option["name"] == "--set":
        return [f"{key}={_setting(one)}" for key, one in value.items()]
    if many and isinstance(value, (list, tuple)):
        return [_word(option, one, scratch) for one in value]
    if many and option["separator"] and _is_sequence(value):
        return [",".join(_number(one) for one in value)]
    return [_word(option, value, scratch)]


def _setting(value):
    return {True: "on", False: "off"}[value] if isinstance(value, bool) else _number(value) if not isinstance(value, str) else value


def _words_of(option, value, scratch):
    if value is None or (option["flag"] and value is False):
        return []
    if option["flag"]:
        if value is not True:
            raise _error(option, repr(value), "True or False")
        return [option["name"]]
    words = _values(option, value, scratch)
    if option["positional"]:
        return words
    if option["repeated"] or len(words) == 1:
        return [f"{option['name']}={word}" if option["name"].startswith("--") else word for word in words]
    if option["separator"]:
        return [option["name"] + "=" + option["separator"].join(words)]
    return [option["name"], *words]


def _signature(options):
    """Positional words first, then options by name; those that must be given have no default."""
    parameter, kinds = inspect.Parameter, inspect.Parameter
    made, seen_optional = [], False
    for option in options:
        if not option["positional"]:
            continue
        seen_optional = seen_optional or not option["required"]
        default = None if seen_optional else kinds.empty
        made.append(parameter(python_name(option["name"]), kinds.POSITIONAL_OR_KEYWORD, default=default))
    for option in options:
        if option["positional"]:
            continue
        default = kinds.empty if option["required"] else False if option["flag"] else None
        made.append(parameter(python_name(option["name"]), kinds.KEYWORD_ONLY, default=default))
    made.append(parameter("progress", kinds.KEYWORD_ONLY, default=None))
    return inspect.Signature(made)


def _documentation(path, command):
    lines = [command["description"] + ".", "", f"The command `hapticell-cli {' '.join(path)}`: see docs/user/command-line.md for "
             "units, frames and the result.", "", "Args:"]
    for option in command["options"]:
        choices = f" One of {', '.join(option['choices'])}." if option["choices"] else ""
        lines.append(f"    {python_name(option['name'])}: {option['description']}.{choices}")
    lines += ["    progress: Called as progress(share, stage) while it runs; share is negative where it is not known.", "",
              "A Workcell, Trajectory or Mesh may stand for a file; an array, a dict of columns or a structured array for a",
              "CSV; a dict for a JSON file.", "", "Returns:",
              "    The values of the JSON result as a Result: lists of numbers are arrays. `exit_status` is 1 if a check that",
              "    was asked for found something.", "", "Raises:",
              "    Error: with the sentence of the command; nothing was written."]
    return "\n".join(lines)


class Command:
    """A command of hapticell-cli: call it, or one of its own commands, its attributes."""

    def __init__(self, path, grammar):
        self._path = path
        self._options = [option for option in grammar["options"] if option["name"] not in ("--json", "--version")]
        self._runs = grammar["runs"]
        self._commands = {}
        self.__name__ = python_name(path[-1])
        self.__qualname__ = ".".join(python_name(word) for word in path)
        self.__module__ = "hapticell"
        self.__doc__ = _documentation(path, grammar)
        self.__signature__ = _signature(self._options)
        for below in grammar["commands"]:
            name = python_name(below["name"])
            self._commands[name] = Command([*path, below["name"]], below)
            setattr(self, name, self._commands[name])

    def __call__(self, *args, **kwargs):
        if not self._runs:
            raise TypeError(f"hapticell.{self.__qualname__} is not a command: call one of {', '.join(self._commands)}")
        given = self.__signature__.bind(*args, **kwargs).arguments
        scratch = _Scratch()
        try:
            words = list(self._path)
            positional = []
            for option in self._options:
                said = _words_of(option, given.get(python_name(option["name"])), scratch)
                (positional if option["positional"] else words).extend(said)
            # Options first: one that takes any number of words would take the positional ones as well.
            at = len(self._path)
            words = words[:at] + positional + words[at:]
            status, results, text = _engine.run_command([*words, "--json=-"], given.get("progress"))
        finally:
            scratch.close()
        if not results:
            return text or None
        result = results[-1]
        if isinstance(result, Result):
            result.exit_status = status
        return result

    def __repr__(self):
        return f"<command hapticell.{self.__qualname__}{self.__signature__ if self._runs else ''}>"


def all_commands():
    """The commands by their names in Python."""
    return {python_name(one["name"]): Command([one["name"]], one) for one in json.loads(_engine.command_grammar())}


def runnable(commands=None):
    """Every command that can be called, those of commands too: for tests and stubs."""
    for command in (commands or all_commands()).values():
        if command._runs:
            yield command
        yield from runnable(command._commands) if command._commands else ()
