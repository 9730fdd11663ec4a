"""Work of the compiled part in threads that Python does not wait for: it is ended before the interpreter is.

Such work comes back to the interpreter's lock when it is done. Where the interpreter has ended by then, the process is aborted.
"""

from __future__ import annotations

import atexit
import contextlib
import os
import threading
from collections.abc import Callable, Iterator

_Progress = Callable[[float, str], object]

_ending = threading.Event()
#: One look at a time: pieces of work under way in threads that are not the first.
_done = threading.Condition()
_under_way = 0

#: Longest time, s, that the end of the program waits for work: what tells no progress, such as an export, cannot be ended.
_PATIENCE = 60.0


@contextlib.contextmanager
def watched(progress: _Progress | None = None) -> Iterator[_Progress | None]:
    """Gives the function that work is to tell its progress; work of other threads ends when the program does."""
    global _under_way
    # The first thread is the one that ends the interpreter.
    if threading.current_thread() is threading.main_thread():
        yield progress
        return

    def told(done: float, text: str) -> None:
        if _ending.is_set():
            # What threading says nothing about.
            raise SystemExit
        if progress is not None:
            progress(done, text)

    with _done:
        if _ending.is_set():
            raise SystemExit
        _under_way += 1
    try:
        yield told
    finally:
        with _done:
            _under_way -= 1
            _done.notify_all()


def _end() -> None:
    with _done:
        _ending.set()
        _done.wait_for(lambda: _under_way == 0, _PATIENCE)


def _forked() -> None:
    """In a child the threads of the parent are none, and a lock that one of them held is held for ever."""
    global _done, _under_way
    _done, _under_way = threading.Condition(), 0


atexit.register(_end)
if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_child=_forked)
