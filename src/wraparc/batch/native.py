"""Compile the scalar kernel of :mod:`wraparc.arc` and the lane kernel as they are, with numba.

No second source exists: every plain function that an entry calls, however deep, is handed to numba
as it stands. What lies below the functions differs, see :mod:`wraparc.batch.underlay`.

Compiled code is kept on disk in a folder named by a hash of everything it was made from, so that
code of an edited kernel is never served: numba itself looks at the file of the entry alone.
"""

from __future__ import annotations

import gc
import hashlib
import os
import platform
import shutil
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, nullcontext, suppress
from functools import cache
from pathlib import Path
from threading import Lock
from types import CodeType, FunctionType, ModuleType
from typing import Any

from wraparc.errors import MissingExtraError

_KEPT = 105  # folders of compiled code, the newest: five states of the 21 entries there are
_PLAIN = (int, float, str, bool, type(None))
#: The one switch of what reaches into numba's private parts (`underlay.optimised_once`): set this
#: variable to 1, and numba compiles in its own way, to the same numbers in twice the time.
AS_IT_IS = "WRAPARC_NUMBA_AS_IT_IS"
_OF_LANES = ("wraparc.batch.lane_", "wraparc.batch.sixth")
_SETTING = Lock()  # of numba's one place for code on disk


def available() -> bool:
    """Whether numba can be imported."""
    try:
        import numba  # noqa: F401
    except ImportError:
        return False
    return True


@cache
def compiled(entry: FunctionType, *, contract: bool = False) -> Callable[..., Any]:
    """Return an entry compiled, running without the interpreter's lock; from disk if it is there.

    Parameters
    ----------
    entry
        A plain function. It and all that it calls in its own top-level package are compiled.
    contract
        Whether a product and a sum may be rounded once (a fused operation) in functions of the
        lanes. Without, results are bit for bit those of the interpreter.

    Raises
    ------
    MissingExtraError
        If numba is not installed.
    """
    try:
        import numba
    except ImportError:
        raise MissingExtraError("numba", "fast") from None
    from numba.extending import register_jitable

    from wraparc.batch import underlay

    functions = tuple(called(entry))
    replaced = set(map(id, underlay.REPLACED))
    for function in functions[1:]:
        if id(function) not in replaced:
            own = _options(contract and contracts(function))
            register_jitable(**own, no_cfunc_wrapper=True, no_cpython_wrapper=True)(function)
    options = _options(contract)
    name = fingerprint(functions, options)
    dispatcher = _cached(entry, {"nogil": True, **options}, name)

    ready = False

    def run(*arguments: Any) -> Any:
        nonlocal ready
        if not ready and not dispatcher.nopython_signatures:
            own_way = nullcontext() if _as_it_is() else underlay.optimised_once(entry.__qualname__)
            with _alone(name), own_way, _uncollected():
                if not dispatcher.nopython_signatures:  # another thread may have been first
                    with suppress(OSError):  # a full disk: it is compiled, and not kept
                        dispatcher.compile(tuple(map(numba.typeof, arguments)))
        ready = True  # to ask the dispatcher takes longer than a short kernel
        return dispatcher(*arguments)

    return run


def contracts(function: Callable[..., Any]) -> bool:
    """Whether a function is one of the lanes.

    Those of the scalar kernel stay as they are in every entry: a function is handed to numba once
    for all entries of a process.
    """
    return function.__module__.startswith(_OF_LANES)


def _options(contract: bool) -> dict[str, Any]:
    return {"error_model": "numpy", "fastmath": {"contract"} if contract else False}


def pays(rows: int, few: int) -> bool:
    """Whether rows of a chunk are worth compiled code: more than a few are.

    By the chunk alone, not by what is compiled or on disk already: the interpreter differs in the
    last bits, and the same study is to have the same bits whenever and wherever it runs.
    """
    return rows > few


@contextmanager
def _alone(name: str) -> Iterator[None]:
    """One process compiles a state of the kernel; the others wait, then find it on disk.

    The lock ends with its process, however that ends. Where there is none (Windows, some network
    drives), each process compiles for itself.
    """
    folder = _folder(name)
    with ExitStack() as stack:
        if folder is not None:
            with suppress(ImportError, OSError):
                import fcntl

                lock = stack.enter_context(open(folder / "lock", "ab"))
                fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@contextmanager
def _uncollected() -> Iterator[None]:
    """Without the collector of cycles: it looks in vain through all that a compiler holds.

    A sixth of the time of compiling, for 150 MB more meanwhile.
    """
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def _as_it_is() -> bool:
    return os.environ.get(AS_IT_IS, "") not in ("", "0")


def _cached(entry: FunctionType, options: dict[str, Any], name: str) -> Any:
    """Dispatcher of an entry that keeps its code in the folder of a name, if there can be one."""
    import numba
    from numba.core import config as numba_config

    config: Any = numba_config

    folder = _folder(name)
    with _SETTING:
        before = config.CACHE_DIR
        try:
            if folder is not None:
                config.CACHE_DIR = str(folder)
                return numba.njit(cache=True, **options)(entry)
        except RuntimeError:
            pass  # numba finds no place for it
        finally:
            config.CACHE_DIR = before
    return numba.njit(**options)(entry)


def called(entry: Callable[..., Any]) -> Iterator[FunctionType]:
    """Yield a function and every plain function of its package that it calls, each once."""
    package = entry.__module__.partition(".")[0]
    waiting: list[Any] = [entry]
    seen = {entry}
    while waiting:
        function = waiting.pop(0)
        yield function
        for value in _globals(function).values():
            if (
                isinstance(value, FunctionType)
                and value not in seen
                and value.__module__.partition(".")[0] == package
            ):
                seen.add(value)
                waiting.append(value)


def _globals(function: FunctionType) -> dict[str, Any]:
    """Global names that a function uses, and names it may use of modules."""
    names = function.__code__.co_names
    found = {name: function.__globals__[name] for name in names if name in function.__globals__}
    for module in [value for value in found.values() if isinstance(value, ModuleType)]:
        found |= {
            f"{module.__name__}.{name}": getattr(module, name)
            for name in names
            if hasattr(module, name)
        }
    return found


def fingerprint(functions: tuple[FunctionType, ...], options: object = None) -> str:
    """Hash of functions as they are loaded, of the constants they use, and of the compiler."""
    import llvmlite  # type: ignore[import-untyped]
    import numba

    from wraparc.batch import series, underlay

    digest = hashlib.sha256()
    for below in (underlay, series):
        digest.update(Path(str(below.__file__)).read_bytes())
    about = (
        numba.__version__,
        llvmlite.__version__,
        sys.version,
        platform.machine(),
        _OF_LANES,
        options,
    )
    digest.update(repr((about, _as_it_is())).encode())
    for function in functions:
        constants = {k: v for k, v in _globals(function).items() if _is_plain(v)}
        # of a named tuple the order of its fields
        constants |= {k: v._fields for k, v in _globals(function).items() if hasattr(v, "_fields")}
        parts = (function.__module__, function.__qualname__, sorted(constants.items()))
        digest.update(repr((parts, _code(function.__code__))).encode())
    return digest.hexdigest()[:20]


def _is_plain(value: object) -> bool:
    if isinstance(value, tuple):
        return all(map(_is_plain, value))
    return isinstance(value, _PLAIN)


def _code(code: CodeType) -> tuple[object, ...]:
    constants = tuple(_code(c) if isinstance(c, CodeType) else c for c in code.co_consts)
    return (code.co_code, repr(constants), code.co_names, code.co_varnames, code.co_freevars)


def _folder(name: str) -> Path | None:
    """Folder of one state of the kernel, the older ones cleared away; None if none can be made."""
    root = kept_in()
    if root is None:
        return None
    folder = root / name
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        os.utime(folder)
        others = sorted(folder.parent.iterdir(), key=lambda p: p.stat().st_mtime, reverse=True)
        for old in others[_KEPT:]:
            shutil.rmtree(old, ignore_errors=True)
    except OSError:
        return None
    return folder if os.access(folder, os.W_OK) else None


def kept_in() -> Path | None:
    """Folder of all compiled code, made if there is none; None if it cannot be written."""
    given = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("WRAPARC_CACHE_DIR")
    try:
        folder = (Path(given) if given else _user_cache() / "wraparc") / "compiled"
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    except (OSError, RuntimeError):  # RuntimeError: a user without a home
        return None
    return folder if os.access(folder, os.W_OK) else None


def _user_cache() -> Path:
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
