# SPDX-License-Identifier: Apache-2.0
"""What commands return: the same values as the JSON of hapticell-cli, as objects and arrays."""


class Result(dict):
    """A JSON object: result["distance"] or result.distance. Lists of numbers are numpy arrays.

    Of a command's result, `exit_status` is 0, or 1 if a check that was asked for found something.
    """

    exit_status = 0

    def __getattr__(self, name):
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"the result has no {name!r}; it has {', '.join(self)}") from None

    def __dir__(self):
        return [*super().__dir__(), *(key for key in self if key.isidentifier())]

    def __repr__(self):
        return "<Result " + ", ".join(f"{key}={_short(value)}" for key, value in self.items()) + ">"


class Records(list):
    """A list of JSON objects. records["distance"] is that value of each of them, as an array where all are numbers."""

    def __getitem__(self, key):
        if not isinstance(key, str):
            return super().__getitem__(key)
        import numpy

        column = [one[key] for one in self]
        plain = all(isinstance(value, (bool, int, float, numpy.ndarray)) for value in column)
        if plain and len({getattr(value, "shape", None) for value in column}) == 1:
            return numpy.array(column)
        return column

    def __repr__(self):
        return f"<Records: {len(self)} of {', '.join(self[0]) if self else 'nothing'}>"


def _short(value):
    if isinstance(value, Result):
        return "{" + ", ".join(value) + "}"
    if hasattr(value, "shape") and getattr(value, "size", 0) > 7:
        return f"array{value.shape}"
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."
