"""The command line: reads arguments, calls the library, shows what comes back.

Exit codes: 0 OK or ATTENTION, 1 FAILS, 2 bad input, 3 internal error,
130 interrupted. A reader of the output who goes away is no error.
"""

import os
import sys
from collections.abc import Sequence
from typing import NoReturn

import click

from wraparc.cli.group import LazyGroup
from wraparc.cli.pipe import reader_may_leave
from wraparc.cli.usage import usage_problem
from wraparc.errors import InputError, MissingExtraError
from wraparc.version import __version__

BAD_INPUT, FAULT, INTERRUPTED = 2, 3, 130

_EXIT_CODES = """\b
Exit codes:
  0  OK or ATTENTION
  1  FAILS: gross slip, or a mandatory limit exceeded
  2  bad input: nothing solved
  3  internal error"""


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog=_EXIT_CODES,
)
@click.version_option(__version__, prog_name="wraparc", message="%(prog)s %(version)s")
@click.option("--debug", is_flag=True, help="Show the traceback of an internal error.")
def wraparc(debug: bool) -> None:
    """Belt-conveyor drive pulleys: creep, slip, lagging shear and traction capacity."""


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run the command line and leave with its exit code."""
    sys.exit(run(sys.argv[1:] if arguments is None else arguments))


def run(arguments: Sequence[str]) -> int:
    """Run the command line; return its exit code.

    Whatever goes wrong is told in a sentence on the error stream; a traceback is shown only with
    ``--debug``.
    """
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:  # closed by whoever started it, or a program without a console
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
        elif hasattr(stream, "reconfigure"):  # a console that lacks a letter shows another instead
            stream.reconfigure(errors="replace")
    return _invoke(list(arguments))


def _invoke(arguments: list[str]) -> int:
    returned = None  # that counts when the reader leaves
    try:
        with reader_may_leave():
            returned = wraparc.main(args=arguments, prog_name="wraparc", standalone_mode=False)
        return returned if isinstance(returned, int) else 0
    except click.UsageError as error:
        click.echo(f"Error: {InputError(usage_problem(error, arguments))}", err=True)
        return error.exit_code
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (click.Abort, KeyboardInterrupt) as error:
        click.echo("\n".join(("Interrupted.", *_kept(error))), err=True)
        return INTERRUPTED
    except (InputError, MissingExtraError) as error:
        click.echo(f"Error: {error}", err=True)
        return BAD_INPUT
    except Exception as error:
        if "--debug" in arguments:
            raise
        _tell_fault(error)
        return FAULT


def _kept(error: BaseException) -> list[str]:
    """What the command that was interrupted says it has kept; most write at their end."""
    interrupt = error.__cause__ or error
    return getattr(interrupt, "__notes__", None) or ["Nothing was written."]


def _tell_fault(error: Exception) -> None:
    from wraparc.errors import shown

    what = f"{type(error).__name__}: {shown(str(error))[1:-1]}"
    click.echo(
        f"Internal error in wraparc {__version__} ({what}). Please report it with the input and "
        "the output of the same command after `wraparc --debug`.",
        err=True,
    )
