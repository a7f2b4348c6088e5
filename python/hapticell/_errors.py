# SPDX-License-Identifier: Apache-2.0
"""Errors and warnings of the package."""


class Error(ValueError):
    """An error in what came from outside: a file, a value, a device. Nothing was changed or half-written.

    Attributes, each a str and empty where there is nothing to say:
        file: The file or address.
        place: Where in it, or which value: "line 12", "joint 'A3'", "--pose".
        found: What was found there.
        expected: What should have been there.
        fix: What you can do about it, a sentence.

    >>> import hapticell
    >>> try:
    ...     hapticell.Robot.load("library:none")
    ... except hapticell.Error as error:
    ...     print(error.found)
    the library has no robot of this name
    """

    def __init__(self, file="", place="", found="", expected="", fix="", message=""):
        super().__init__(message or found)
        self.file = file
        self.place = place
        self.found = found
        self.expected = expected
        self.fix = fix

    def __reduce__(self):
        return type(self), (self.file, self.place, self.found, self.expected, self.fix, str(self))


class Notice(UserWarning):
    """What a reader noticed without failing: a guessed unit, a tag that is not known."""
