"""Progress on a terminal or in a notebook."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Any, Callable, Optional, Union

#: True for a bar where somebody watches, False for none, or a function of what is done and the whole.
Progress = Union[bool, Callable[[float, float], object]]

_WIDTH = 40
#: Time between redrawings of a bar in a notebook, s.
_REDRAW_S = 0.5


class Bar:
    """A bar on standard error while that is a terminal, or in the page of a notebook."""

    def __init__(self, whole: float, unit: str, progress: Progress) -> None:
        self._whole = whole
        self._unit = unit
        self._began = time.monotonic()
        self._drawn = float("-inf")
        self._call = progress if callable(progress) else None
        self._page = None if self._call is not None or not progress else _notebook()
        self._terminal = bool(progress) and self._call is None and self._page is None and _is_terminal()
        self._shown = False

    def __enter__(self) -> Bar:
        return self

    def __exit__(
        self, kind: Optional[type[BaseException]], value: Optional[BaseException], trace: Optional[TracebackType]
    ) -> None:
        if self._terminal and self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()
        if self._page is not None and self._shown:
            self._page.update({"text/plain": ""}, raw=True)

    def __call__(self, done: float) -> None:
        """Shows how much is done."""
        if self._call is not None:
            self._call(done, self._whole)
        elif self._terminal or self._page is not None:
            now = time.monotonic()
            if self._page is None or now - self._drawn >= _REDRAW_S:
                self._drawn = now
                self._draw(done, now - self._began)

    def _draw(self, done: float, elapsed: float) -> None:
        share = min(max(done / self._whole, 0.0), 1.0) if self._whole > 0 else 0.0
        left = f"{elapsed * (1 - share) / share:.0f} s left" if share > 0 else ""
        filled = int(share * _WIDTH)
        line = f"{'█' * filled}{'░' * (_WIDTH - filled)} {done:.6g}/{self._whole:.6g} {self._unit} {left}"
        self._shown = True
        if self._page is not None:
            self._page.update({"text/plain": line}, raw=True)
        else:
            sys.stderr.write(f"\r\x1b[K{line}")
            sys.stderr.flush()


def _is_terminal() -> bool:
    return sys.stderr is not None and sys.stderr.isatty()


def _notebook() -> Optional[Any]:
    """A place in the page of a notebook, where this is one."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    if shell is None or type(shell).__name__ != "ZMQInteractiveShell":
        return None
    import IPython.display

    show: Any = IPython.display.display
    return show({"text/plain": ""}, raw=True, display_id=True)
