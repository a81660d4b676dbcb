"""One at a time: an operating system's lock on a file, which ends with its process however that ends."""

from __future__ import annotations

import os
import sys
import weakref
from contextlib import suppress
from pathlib import Path

from linkwright.model.output_files import NO_LINK, refuse_link

if sys.platform == "win32":
    import msvcrt

    def _locked(handle: int) -> bool:
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

else:
    import fcntl

    def _locked(handle: int) -> bool:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:  # a file system without locks: better unlocked than not at all
            return True
        return True


class Lock:
    """A lock file. It is removed when it is released, at the latest with the object; one that a killed process left is
    taken over."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._end: weakref.finalize[..., Lock] | None = None

    def acquire(self) -> bool:
        """Take the lock, without waiting; False where another has it. Raises :class:`ModelError` for a link in place of
        the file, OSError for one that can't be made."""
        while True:
            refuse_link(self._path)
            handle = os.open(self._path, os.O_RDWR | os.O_CREAT | NO_LINK, 0o666)
            if not _locked(handle):
                os.close(handle)
                return False
            # The one who had it may have removed the file since it was opened: then this is the lock of nothing.
            with suppress(FileNotFoundError):
                if os.path.samestat(os.fstat(handle), self._path.lstat()):
                    self._end = weakref.finalize(self, _give_back, self._path, handle, os.getpid())
                    return True
            os.close(handle)

    def release(self) -> None:
        """Give the lock back."""
        if self._end is not None:
            self._end()


def _give_back(path: Path, handle: int, process: int) -> None:
    if os.getpid() != process:  # a fork of the one that has it
        return
    if sys.platform == "win32":  # there no open file can be removed
        os.close(handle)
    with suppress(OSError):
        path.unlink()
    if sys.platform != "win32":
        os.close(handle)


_SHARED: weakref.WeakValueDictionary[Path, Lock] = weakref.WeakValueDictionary()


def shared(path: Path) -> Lock | None:
    """The lock that this process has on a file, taken now where it has none; ``None`` where another process has it. It
    ends when nothing refers to it any more. Raises as :meth:`Lock.acquire` does."""
    place = path.absolute()
    lock = _SHARED.get(place)
    if lock is None:
        lock = Lock(place)
        if not lock.acquire():
            return None
        _SHARED[place] = lock
    return lock
