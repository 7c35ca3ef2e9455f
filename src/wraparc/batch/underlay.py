"""What lies below the compiled kernels: bare memory, and operations without branches.

Imported only when something is compiled; it needs numba.
"""

# mypy: ignore-errors
# (numba's decorators replace what they decorate: types say nothing true here)

from __future__ import annotations

import operator
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils, codegen
from numba.core.compiler_lock import global_compiler_lock
from numba.core.typing import signature
from numba.extending import (
    intrinsic,
    lower_builtin,
    models,
    overload,
    register_model,
    type_callable,
)

from wraparc.arc.kernel import quantities
from wraparc.batch import elementwise, series
from wraparc.batch.elementwise import LANES

LOOKED_UP = "tables"  # memory read one number at a time: gathers are slow on many processors


class FloatsType(types.Type):
    """Numbers in memory that somebody else owns: an address and a length.

    An array would be counted at every call it is passed to, which made the scalar kernel more than
    twice as slow. Memory of one kind does not overlap memory of another: told so, LLVM needs no
    checks before it works on several lanes at once.
    """

    def __init__(self, kind: str) -> None:
        self.kind = kind
        super().__init__(name=f"Floats({kind})")


@register_model(FloatsType)
class _FloatsModel(models.StructModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        members = [("data", types.CPointer(types.float64)), ("size", types.intp)]
        super().__init__(manager, kind, members)


def _parts(context: Any, builder: Any, kind: Any, value: Any = None) -> Any:
    return cgutils.create_struct_proxy(kind)(context, builder, value=value)


def _tag(builder: Any, kind: FloatsType, instruction: Any) -> None:
    """Say which kind of memory an instruction touches (LLVM's type-based alias analysis)."""
    module = builder.module
    root = module.add_metadata(["wraparc"])
    own = module.add_metadata([kind.kind, root, ir.Constant(ir.IntType(64), 0)])
    tag = module.add_metadata([own, own, ir.Constant(ir.IntType(64), 0)])
    instruction.set_metadata("tbaa", tag)


@intrinsic(prefer_literal=True)
def _of_array(typing: Any, array: Any, kind: Any) -> Any:
    made_type = FloatsType(kind.literal_value)

    def build(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        source = context.make_array(signature.args[0])(context, builder, args[0])
        made = _parts(context, builder, made_type)
        made.data, made.size = source.data, source.nitems
        return made._getvalue()

    return made_type(array, kind), build


def _address(context: Any, builder: Any, signature: Any, args: Any) -> Any:
    """Address of a place: a position, or a slot and a lane."""
    kind, place = signature.args[0], args[1]
    if isinstance(signature.args[1], types.UniTuple):
        slot, lane = cgutils.unpack_tuple(builder, place, 2)
        place = builder.add(builder.mul(slot, slot.type(LANES)), lane)
    return builder.gep(_parts(context, builder, kind, args[0]).data, [place], inbounds=True)


def _is_place(place: Any) -> bool:
    return isinstance(place, types.Integer) or (
        isinstance(place, types.BaseTuple)
        and len(place) == 2
        and all(isinstance(t, types.Integer) for t in place)
    )


def _place_type(place: Any) -> Any:
    return types.intp if isinstance(place, types.Integer) else types.UniTuple(types.intp, 2)


@type_callable(operator.getitem)
def _type_getitem(context: Any) -> Any:
    def typer(buffer: Any, place: Any) -> Any:
        if isinstance(buffer, FloatsType) and _is_place(place):
            return signature(types.float64, buffer, _place_type(place))
        return None

    return typer


@type_callable(operator.setitem)
def _type_setitem(context: Any) -> Any:
    def typer(buffer: Any, place: Any, value: Any) -> Any:
        if isinstance(buffer, FloatsType) and _is_place(place):
            return signature(types.none, buffer, _place_type(place), types.float64)
        return None

    return typer


@lower_builtin(operator.getitem, FloatsType, types.Any)
def _getitem(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    address = _address(context, builder, sig, args)
    if sig.args[0].kind == LOOKED_UP:
        return builder.load_atomic(address, "unordered", 8)
    loaded = builder.load(address)
    _tag(builder, sig.args[0], loaded)
    return loaded


@lower_builtin(operator.setitem, FloatsType, types.Any, types.Float)
def _setitem(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    stored = builder.store(args[2], _address(context, builder, sig, args))
    _tag(builder, sig.args[0], stored)
    return context.get_dummy_value()


@intrinsic
def _size(typing: Any, buffer: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return _parts(context, builder, buffer, args[0]).size

    return types.intp(buffer), build


@intrinsic
def _part(typing: Any, buffer: Any, first: Any, size: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        made = _parts(context, builder, buffer, args[0])
        made.data, made.size = builder.gep(made.data, [args[1]]), args[2]
        return made._getvalue()

    return buffer(buffer, types.intp, types.intp), build


@overload(operator.getitem, strict=False)
def _slice(buffer: Any, place: Any) -> Any:
    if not isinstance(buffer, FloatsType) or not isinstance(place, types.SliceType):
        return None

    def part(buffer: Any, place: Any) -> Any:
        bounds = place.indices(len(buffer))
        return _part(buffer, bounds[0], max(bounds[1] - bounds[0], 0))

    return part


@overload(len, strict=False)
def _len(buffer: Any) -> Any:
    def size(buffer: Any) -> Any:
        return _size(buffer)

    return size if isinstance(buffer, FloatsType) else None


@overload(elementwise.memory, strict=False, prefer_literal=True)
def _memory(array: Any, kind: Any) -> Any:
    def memory(array: Any, kind: Any) -> Any:
        return _of_array(array, kind)

    return memory


def _kind(a: Any, b: Any) -> Any:
    whole = isinstance(a, types.Integer) and isinstance(b, types.Integer)
    return types.int64 if whole else types.float64


@type_callable(elementwise.lower)
@type_callable(elementwise.upper)
def _type_of_two(context: Any) -> Any:
    return lambda a, b: signature(types.float64, types.float64, types.float64)


@type_callable(elementwise.select)
def _type_select(context: Any) -> Any:
    def typer(condition: Any, a: Any, b: Any) -> Any:
        kind = _kind(a, b)
        return signature(kind, types.boolean, kind, kind)

    return typer


@lower_builtin(elementwise.lower, types.Any, types.Any)
def _lower(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return builder.select(builder.fcmp_ordered("<", *args), *args)


@lower_builtin(elementwise.upper, types.Any, types.Any)
def _upper(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return builder.select(builder.fcmp_ordered(">", *args), *args)


@lower_builtin(elementwise.select, types.Any, types.Any, types.Any)
def _select(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return builder.select(*args)


@type_callable(elementwise.anywhere)
def _type_anywhere(context: Any) -> Any:
    return lambda condition: signature(types.boolean, types.boolean)


@lower_builtin(elementwise.anywhere, types.Any)
def _anywhere(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return args[0]


@type_callable(elementwise.root)
def _type_root(context: Any) -> Any:
    return lambda a: signature(types.float64, types.float64)


@lower_builtin(elementwise.root, types.Any)
def _root(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return builder.call(builder.module.declare_intrinsic("llvm.sqrt", [args[0].type]), args)


@type_callable(elementwise.lanes)
def _type_lanes(context: Any) -> Any:
    return lambda: signature(types.intp)


@lower_builtin(elementwise.lanes)
def _lanes(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    return context.get_constant(types.intp, LANES)


@type_callable(elementwise.index)
def _type_index(context: Any) -> Any:
    return lambda a: signature(types.int64, types.float64)


@lower_builtin(elementwise.index, types.Any)
def _index(context: Any, builder: Any, sig: Any, args: Any) -> Any:
    shifted = builder.fadd(args[0], args[0].type(series.MAGIC))
    bits = builder.bitcast(shifted, ir.IntType(64))
    return builder.sub(bits, bits.type(series.MAGIC_BITS))


@overload(quantities.zeros, strict=False)
def _room(size: Any) -> Any:
    def zeros(size: Any) -> Any:
        return np.zeros(size)

    return zeros


@contextmanager
def optimised_once(entry: str) -> Iterator[None]:
    """While an entry is compiled, leave all optimisation to the end, when it holds everything.

    numba optimises each function together with all that it calls, and makes machine code of it:
    deep in a kernel the same code again and again, half of the time of compiling. Should numba's
    inner parts be named otherwise one day, it goes its own way.
    """
    library, generator = codegen.CPUCodeLibrary, codegen.JITCPUCodegen
    names = ("_optimize_final_module", "_finalize_final_module")
    if not all(hasattr(library, n) for n in names) or not hasattr(generator, "set_env"):
        yield
        return
    # every way into the compiler takes this lock: nobody else compiles or loads meanwhile
    with global_compiler_lock:
        optimise, finish = library._optimize_final_module, library._finalize_final_module
        set_env = generator.set_env

        def optimise_entry(self: Any) -> None:
            if self.name == entry:
                optimise(self)

        def finish_entry(self: Any) -> None:
            if self.name == entry:
                finish(self)
            else:
                self._finalize_dynamic_globals()
                self._finalized = True

        def set_known_env(self: Any, name: str, env: Any) -> None:
            if self._engine.is_symbol_defined(name):
                set_env(self, name, env)

        library._optimize_final_module = optimise_entry
        library._finalize_final_module = finish_entry
        generator.set_env = set_known_env
        try:
            yield
        finally:
            library._optimize_final_module = optimise
            library._finalize_final_module = finish
            generator.set_env = set_env


#: functions that are not compiled from their source
REPLACED = frozenset(
    {
        quantities.zeros,
        elementwise.memory,
        elementwise.lower,
        elementwise.upper,
        elementwise.select,
        elementwise.root,
        elementwise.anywhere,
        elementwise.index,
        elementwise.ln,
        elementwise.ex,
        elementwise.full_ln,
        elementwise.full_ex,
        elementwise.lanes,
    }
)
