"""The commands by name, each imported only when it is called: start-up stays short."""

from importlib import import_module
from typing import Any, NamedTuple

import click

from wraparc.cli.pipe import NoReaderError, has_left
from wraparc.errors import InputError, Problem, nearest, shown


class Command(NamedTuple):
    """Where a command is, and what it is for."""

    where: str
    help: str


#: Every command, in the order of the help: name -> (module:function, one line of help).
COMMANDS: dict[str, Command] = {
    "solve": Command("wraparc.cli.solve:solve", "Check a drive: the answer on one screen."),
    "trim": Command("wraparc.cli.trim:trim", "Find the speed trim of drives on one belt."),
    "run": Command("wraparc.cli.motion:run", "Simulate an event: start, stop, load step, splice."),
    "stability": Command(
        "wraparc.cli.motion:stability", "Check drives for self-excited oscillation."
    ),
    "report": Command(
        "wraparc.cli.report:report", "Write the calculation report: PDF, Excel, Markdown."
    ),
    "check": Command("wraparc.cli.solve:check", "Validate a drive file."),
    "laggings": Command("wraparc.cli.catalogue:laggings", "List the laggings of the catalogue."),
    "lagging": Command("wraparc.cli.catalogue:lagging", "Show a lagging and its friction law."),
    "belts": Command("wraparc.cli.catalogue:belts", "List the belts of the catalogue."),
    "read": Command(
        "wraparc.cli.shear_test:read", "Show columns and units of a test machine's file."
    ),
    "fit": Command("wraparc.cli.shear_test:fit", "Fit a friction law to shear tests."),
    "rig": Command("wraparc.cli.shear_test:rig", "Simulate shear tests of a known friction law."),
    "choose": Command("wraparc.cli.choose:choose", "Rank laggings, belts and take-ups by cost."),
    "study": Command(
        "wraparc.cli.study:study", "Solve many variants: grid, Monte Carlo, sensitivity."
    ),
    "what-if": Command("wraparc.cli.what_if:what_if", "Compare a drive before and after changes."),
    "seek": Command("wraparc.cli.seek:seek", "Find the input that gives a wanted result."),
    "profile": Command(
        "wraparc.cli.profile:profile", "Read a profile measured across a pulley face."
    ),
    "import": Command(
        "wraparc.cli.import_table:import_table", "Read load cases from a table of tensions."
    ),
    "family": Command(
        "wraparc.cli.family:family", "Compare creep along the wrap over tension ratios."
    ),
    "overlay": Command(
        "wraparc.cli.calibrate:overlay", "Compare measurements of a drive with predictions."
    ),
    "calibrate": Command(
        "wraparc.cli.calibrate:calibrate", "Calibrate a lagging to a measured drive."
    ),
    "learn": Command(
        "wraparc.cli.learn:learn", "Learn friction, zero and alarms from a plant's trend logs."
    ),
    "virtual-record": Command(
        "wraparc.cli.calibrate:virtual_record", "Simulate the record of an instrumented pulley."
    ),
    "field": Command(
        "wraparc.cli.field:field", "Show normal slip, alarm levels and wear of a drive."
    ),
    "serve": Command("wraparc.cli.serve:serve", "Open the calculator in the browser."),
    "page": Command("wraparc.cli.page:page", "Write the calculator as one HTML file."),
    "demo": Command("wraparc.cli.demo:demo", "Copy all examples to a folder and solve one."),
}


_ONCE = "Leave all but one out."


def _refuse_repeated(ctx: click.Context, args: list[str]) -> None:
    """Refuse an option given twice that takes one value: the first would be lost unsaid."""
    try:
        values, _, order = ctx.command.make_parser(ctx).parse_args(list(args))
    except click.UsageError:  # told when the command reads them
        return
    once = [
        p for p in order if isinstance(p, click.Option) and not (p.multiple or p.is_flag or p.count)
    ]
    keys = [text.partition("=")[0].strip() for text in values.get("settings") or ()]
    for key in keys:
        if keys.count(key) > 1:
            raise InputError(
                Problem(
                    message=f"given {keys.count(key)} times",
                    remedy=_ONCE,
                    key=f"--set {shown(key)[1:-1]}",
                )
            )
    for option in once:
        if once.count(option) > 1:
            times = f"given {once.count(option)} times, and has one value"
            raise InputError(Problem(message=times, remedy=_ONCE, key=option.opts[0]))


class LazyGroup(click.Group):
    """A group whose commands are imported when they are called."""

    def invoke(self, ctx: click.Context) -> Any:
        """Run a command; a reader who goes away is left to `wraparc.cli.run`."""
        try:
            return super().invoke(ctx)
        except OSError as error:
            if not has_left(error):
                raise
            raise NoReaderError from error

    def make_context(self, *args: Any, **extra: Any) -> click.Context:
        """Read the arguments, which prints the help if they ask for it."""
        try:
            return super().make_context(*args, **extra)
        except OSError as error:
            if not has_left(error):
                raise
            raise NoReaderError from error

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the commands."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import and return a command."""
        if cmd_name not in COMMANDS:
            return None
        module, _, function = COMMANDS[cmd_name].where.partition(":")
        command: click.Command = getattr(import_module(module), function)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command that the arguments begin with; a near miss is told."""
        try:
            name, command, rest = super().resolve_command(ctx, args)
            if command is not None:
                _refuse_repeated(click.Context(command, ctx, name), rest)
            return name, command, rest
        except click.UsageError:
            if args[0] in COMMANDS or args[0].startswith("-"):
                raise
            remedy = nearest(args[0], COMMANDS) or "See wraparc --help."
            raise InputError(
                Problem(message="no such command", remedy=remedy, value=shown(args[0]))
            ) from None

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands without importing any."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, command.help) for name, command in COMMANDS.items()])
