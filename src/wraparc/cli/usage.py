"""A wrong call of a command, told as any other bad input: what, got which value, what to write."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import click

from wraparc.errors import Problem, did_you_mean, near, shown

_NUMBERS = {click.INT.name: "a whole number", click.FLOAT.name: "a number"}


def usage_problem(error: click.UsageError, arguments: Sequence[str]) -> Problem:
    """Return what is wrong with a call.

    Parameters
    ----------
    error
        What the command raised as it read its arguments.
    arguments
        All arguments, that of the command first.
    """
    ctx = error.ctx
    call = ctx.command_path if ctx else "wraparc"
    usage = " ".join([call, *(ctx.command.collect_usage_pieces(ctx) if ctx else ())])
    help_of, message = f"See {call} --help.", shown(error.message.rstrip("."))[1:-1]
    if isinstance(error, click.NoSuchOption):
        options = [name for p in _parameters(ctx) for name in (*p.opts, *p.secondary_opts)]
        known = {name.lstrip("-"): name for name in options if name.startswith("--")}
        known.pop("help", None)  # like too many words, and pointed to where nothing is near
        meant = [shown(known[word]) for word in near(error.option_name.lstrip("-"), known)]
        remedy = did_you_mean(meant) or help_of
        return Problem(
            message=f"{call} has no such option", remedy=remedy, key=shown(error.option_name)[1:-1]
        )
    if isinstance(error, click.BadOptionUsage):
        return Problem(message="value missing", remedy=help_of, key=error.option_name)
    if isinstance(error, click.MissingParameter) and error.param is not None:
        name, remedy = _name(error.param), f"Write {usage}."
        if isinstance(error.param, click.Option):
            value = error.param.make_metavar(ctx).rstrip(",.") if ctx else ""
            remedy = f"Add {name} {value}".rstrip() + "."
        return Problem(message="missing", remedy=remedy, key=name)
    if isinstance(error, click.BadParameter) and error.param is not None:
        allowed = _allowed(error.param.type)
        values = _values(error.param, ctx, arguments) if allowed else ()
        if allowed and values:
            return Problem(
                message=f"must be {allowed}", value=shown(values[0]), key=_name(error.param)
            )
        return Problem(message=message, remedy=help_of, key=_name(error.param))
    if ctx is not None and not isinstance(ctx.command, click.Group):
        return Problem(message=message, remedy=f"Write {usage}.")
    return Problem(message=message, remedy=help_of)


def _parameters(ctx: click.Context | None) -> list[click.Parameter]:
    return ctx.command.get_params(ctx) if ctx else []


def _name(param: click.Parameter) -> str:
    """Return how a parameter is written: the long name of an option, an argument in capitals."""
    if isinstance(param, click.Option):
        return max(param.opts, key=len)
    return param.human_readable_name


def _allowed(kind: click.ParamType[Any]) -> str:
    """Return which values a type takes, in words; nothing where it has words of its own."""
    if isinstance(kind, click.Choice):
        names = [c if c.isalnum() else shown(c) for c in map(str, kind.choices)]
        return " or ".join(filter(None, (", ".join(names[:-1]), names[-1])))
    if isinstance(kind, click.IntRange | click.FloatRange):
        number = _NUMBERS[click.INT.name if isinstance(kind, click.IntRange) else click.FLOAT.name]
        ends = [f"{end:,g}" if end is not None else "" for end in (kind.min, kind.max)]
        if all(ends):
            return f"{number} from {ends[0]} to {ends[1]}"
        return f"{number} of {ends[0]} or more" if ends[0] else f"{number} up to {ends[1]}"
    return _NUMBERS.get(kind.name, "")


def _values(
    param: click.Parameter, ctx: click.Context | None, arguments: Sequence[str]
) -> tuple[str, ...]:
    """Return the values of a parameter that its type does not take, as typed."""
    if ctx is None or param.name is None:
        return ()
    rest = list(arguments)[list(arguments).index(ctx.info_name or "") + 1 :]
    values, _, _ = ctx.command.make_parser(ctx).parse_args(rest)
    typed = values.get(param.name)
    if not isinstance(typed, str | list | tuple):  # not on the line: of the environment
        typed = param.value_from_envvar(ctx)
    every = (typed,) if isinstance(typed, str) else tuple(typed or ())
    return tuple(_refused(param, ctx, every))


def _refused(param: click.Parameter, ctx: click.Context, values: Sequence[str]) -> Iterator[str]:
    for value in values:
        try:
            param.type.convert(value, param, ctx)
        except click.BadParameter:
            yield value
