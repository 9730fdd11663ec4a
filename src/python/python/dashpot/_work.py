"""Stop of the extension module's work in secondary threads before the interpreter ends.

Finished work acquires the interpreter lock again. If the interpreter has ended, this aborts the process.
"""

from __future__ import annotations

import atexit
import contextlib
import os
import threading
from collections.abc import Callable, Iterator

_Progress = Callable[[float, str], object]

_ending = threading.Event()
#: Guards `_under_way`, the number of running tasks outside the main thread.
_done = threading.Condition()
_under_way = 0

#: Longest time, s, that the end of the program waits for running tasks. A task without progress reports, such as an export, cannot be stopped.
_PATIENCE = 60.0


@contextlib.contextmanager
def watched(progress: _Progress | None = None) -> Iterator[_Progress | None]:
    """Context of a task. Yields the function to which the task reports its progress.

    Outside the main thread, this function stops the task by an exception when the program ends.
    """
    global _under_way
    # The main thread ends the interpreter, so its task is always complete before that.
    if threading.current_thread() is threading.main_thread():
        yield progress
        return

    def told(done: float, text: str) -> None:
        if _ending.is_set():
            # `threading` prints no traceback of a SystemExit.
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
    """Resets the state in a forked child.

    The child has no threads of its parent, so a lock that such a thread held would never be released.
    """
    global _done, _under_way
    _done, _under_way = threading.Condition(), 0


atexit.register(_end)
if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_child=_forked)
