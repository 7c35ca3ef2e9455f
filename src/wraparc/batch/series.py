"""Logarithms and exponentials without branches, put under the names of `elementwise` by numba.

Imported only when something is compiled, by :mod:`wraparc.batch.underlay`.
"""

# mypy: ignore-errors
# (numba's decorators replace what they decorate: types say nothing true here)

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic, overload

from wraparc.batch import elementwise

# A double plus this has the number, rounded to an integer, in its low bits.
MAGIC = 6755399441055744.0
MAGIC_BITS = 0x4338000000000000
_SQRT_HALF_BITS = 0x3FE6A09E667F3BCD
_LN_2 = 0.6931471805599453
# ln(1 + f)/f on [1/sqrt 2 - 1, sqrt 2 - 1], Chebyshev, 4e-9; exp on [-ln 2/2, ln 2/2], 1e-12
_L0, _L1, _L2, _L3, _L4 = (
    1.0000000000182159,
    -0.49999988294141795,
    0.33333324023637767,
    -0.2500158512305343,
    0.20002071674838445,
)
_L5, _L6, _L7, _L8, _L9 = (
    -0.16609126504813404,
    0.14180078717929895,
    -0.13240842693674715,
    0.12914170328095773,
    -0.07638592455375161,
)
_E0, _E1, _E2, _E3, _E4 = (
    1.000000000000013,
    0.9999999999797655,
    0.4999999999943775,
    0.16666666891203025,
    0.04166666704102245,
)
_E5, _E6, _E7, _E8 = (
    0.008333266067429653,
    0.0013888801671667536,
    0.00019915883532914026,
    2.488449845564141e-05,
)


@intrinsic
def _bits(typing: Any, number: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.IntType(64))

    return types.int64(types.float64), build


@intrinsic
def _number(typing: Any, bits: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.DoubleType())

    return types.float64(types.int64), build


@overload(elementwise.ln, strict=False)
def _ln(a: Any) -> Any:
    def ln(a: Any) -> Any:
        bits = _bits(a)
        power = (bits - _SQRT_HALF_BITS) >> 52
        f = _number(bits - (power << 52)) - 1.0
        g = f * f
        h = g * g
        p = ((_L0 + _L1 * f) + g * (_L2 + _L3 * f)) + h * (
            ((_L4 + _L5 * f) + g * (_L6 + _L7 * f)) + h * (_L8 + _L9 * f)
        )
        return f * p + (_number(power + MAGIC_BITS) - MAGIC) * _LN_2

    return ln


@overload(elementwise.ex, strict=False)
def _ex(a: Any) -> Any:
    def ex(a: Any) -> Any:
        shifted = a * (1.0 / _LN_2) + MAGIC
        f = a - (shifted - MAGIC) * _LN_2
        g = f * f
        h = g * g
        p = ((_E0 + _E1 * f) + g * (_E2 + _E3 * f)) + h * (
            ((_E4 + _E5 * f) + g * (_E6 + _E7 * f)) + h * _E8
        )
        return p * _number((_bits(shifted) - MAGIC_BITS + 1023) << 52)

    return ex


_LN_2_HIGH, _LN_2_LOW = 0.6931471803691238, 1.9082149292705877e-10  # 32 bits, and the rest


@overload(elementwise.full_ln, strict=False)
def _full_ln(a: Any) -> Any:
    def full_ln(a: Any) -> Any:
        bits = _bits(a)
        power = (bits - _SQRT_HALF_BITS) >> 52
        f = _number(bits - (power << 52)) - 1.0
        # ln(1 + f) = 2 artanh(f/(2 + f)), its series
        s = f / (2.0 + f)
        g = s * s
        h = g * g
        p = ((2.0 / 3.0 + 2.0 / 5.0 * g) + h * (2.0 / 7.0 + 2.0 / 9.0 * g)) + (h * h) * (
            ((2.0 / 11.0 + 2.0 / 13.0 * g) + h * (2.0 / 15.0 + 2.0 / 17.0 * g))
            + (h * h) * (2.0 / 19.0 + 2.0 / 21.0 * g)
        )
        n = _number(power + MAGIC_BITS) - MAGIC
        return n * _LN_2_HIGH + (2.0 * s + (s * g * p + n * _LN_2_LOW))

    return full_ln


@overload(elementwise.full_ex, strict=False)
def _full_ex(a: Any) -> Any:
    def full_ex(a: Any) -> Any:
        shifted = a * (1.0 / _LN_2) + MAGIC
        n = shifted - MAGIC
        f = (a - n * _LN_2_HIGH) - n * _LN_2_LOW
        # its series
        g = f * f
        h = g * g
        p = ((1.0 / 2.0 + 1.0 / 6.0 * f) + g * (1.0 / 24.0 + 1.0 / 120.0 * f)) + h * (
            ((1.0 / 720.0 + 1.0 / 5040.0 * f) + g * (1.0 / 40320.0 + 1.0 / 362880.0 * f))
            + h * ((1.0 / 3628800.0 + 1.0 / 39916800.0 * f) + g * (1.0 / 479001600.0))
        )
        return (1.0 + (f + g * p)) * _number((_bits(shifted) - MAGIC_BITS + 1023) << 52)

    return full_ex
