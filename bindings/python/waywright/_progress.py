"""Progress bars for ``progress=True``."""

from __future__ import annotations

from collections.abc import Callable


def _no_bar(done: int, total: int) -> None:
    """Shows nothing: tqdm is not installed."""


def bar() -> Callable[[int, int], None]:
    """Returns a function that shows a bar of tqdm, or nothing if tqdm is not installed."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _no_bar
    shown = tqdm(total=100, unit="%", bar_format="{percentage:3.0f}%|{bar}| {elapsed}<{remaining}")

    def show(done: int, total: int) -> None:
        shown.n = 100 * done // max(total, 1)
        shown.refresh()
        if done == total:
            shown.close()

    return show
