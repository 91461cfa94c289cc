"""The exceptions of the package."""

from __future__ import annotations


class WaywrightError(Exception):
    """An error of the library: the call changed nothing.

    ``code`` is the name of the kind of error, such as 'out-of-domain'. ``message`` says what is wrong. ``index`` is the
    index of the refused element in its list (of an item, a point, a query or a change), or a line number. ``item`` is the
    id that caused the error, or 0.

    >>> try:
    ...     world.insert_point((200, 5))
    ... except waywright.WaywrightError as error:
    ...     print(error.code)
    out-of-domain
    """

    def __init__(self, code: str, message: str, index: int = 0, item: int = 0) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.index = index
        self.item = item

    def __str__(self) -> str:
        return self.message

    def __reduce__(self):
        return type(self), (self.code, self.message, self.index, self.item)


class BadValueError(WaywrightError, ValueError):
    """An argument has a value that the library does not accept, for example a point outside the domain."""


class IdInUseError(WaywrightError, ValueError):
    """A live item has this id already."""


class UnknownIdError(WaywrightError, KeyError):
    """No live item has this id."""


class LimitError(WaywrightError):
    """The operation would make too many vertices."""


class NotSupportedError(WaywrightError):
    """This version or this world does not support the request: for example, the world does not keep its bridges."""


class TickError(WaywrightError):
    """The world has no history, or its history does not contain the tick."""


class FileError(WaywrightError, OSError):
    """A file cannot be opened, read or written."""

    def __init__(self, code: str, message: str, index: int = 0, item: int = 0) -> None:
        OSError.__init__(self, message)
        WaywrightError.__init__(self, code, message, index, item)


CLASSES = {
    "coordinate-range": BadValueError,
    "out-of-domain": BadValueError,
    "id-in-use": IdInUseError,
    "unknown-id": UnknownIdError,
    "bad-radius": BadValueError,
    "bad-distance": BadValueError,
    "bad-id": BadValueError,
    "bad-domain": BadValueError,
    "bad-shape": BadValueError,
    "too-large": LimitError,
    "too-many-vertices": LimitError,
    "world-gone": WaywrightError,
    "not-supported": NotSupportedError,
    "no-bridges": NotSupportedError,
    "no-history": TickError,
    "old-tick": TickError,
    "unknown-tick": TickError,
    "unreadable": FileError,
    "malformed": BadValueError,
    "unwritable": FileError,
}

for _class in {WaywrightError, *CLASSES.values()}:
    _class.__module__ = "waywright"


def exception_of(code: str, message: str, index: int, item: int) -> WaywrightError:
    """Returns the exception for an error of the library."""
    return CLASSES.get(code, WaywrightError)(code, message, index, item)
