"""`wraparc choose`: the example, its outputs, and input that cannot be used."""

import csv
import re
import shutil
from pathlib import Path

import pytest

from cli.running import drive_file, wraparc
from judgement.rows import BASE

pytestmark = pytest.mark.usefixtures("solved_once")

EXAMPLES = Path(__file__).parents[2] / "examples" / "wet-season"


@pytest.fixture
def file(tmp_path: Path) -> Path:
    for name in ("choose.toml", "wet-season-drive.toml"):
        shutil.copy(EXAMPLES / name, tmp_path)
    path = tmp_path / "choose.toml"
    # one load case and one lagging less: quick
    text = path.read_text("utf-8").replace('"medium-ceramic", ', "")
    text = text.replace("rating_share.start = 1.4", "").replace('slack_tensions = "least"', "")
    path.write_text(text, "utf-8")
    drive = tmp_path / "wet-season-drive.toml"
    drive.write_text(drive.read_text("utf-8").partition("[[load_case]]")[0], "utf-8")
    return path


def test_the_example_chooses_and_says_why_not() -> None:
    ran = wraparc("choose", EXAMPLES / "choose.toml", "--full")
    assert ran.code == 0, ran.err
    lines = [
        "ATTENTION Lowest cost: full-ceramic with T2 23.2 kN, 12,843 AUD in 10 years.",
        "Action Test lagging full-ceramic wet.",
        "Also full-ceramic not tested wet: dry friction times 0.882 used (head, design).",
    ]
    assert " ".join(lines) in ran.words
    assert (
        "diamond-rubber the creep limit: 10.8 mm, max 6.35 mm (70 % over) [start, wet]" in ran.words
    )
    assert "ratio of constant design values applied to the whole law" in ran.words
    assert "diamond-rubber, wet: friction factor 0.78, calibrated" in ran.words
    assert "currency not stated there, AUD assumed" in ran.words


def test_no_feasible_candidate_names_the_limit_and_the_miss(file: Path) -> None:
    ran = wraparc("choose", file)
    assert ran.code == 0, ran.out
    ran = wraparc("choose", file, "--set", "limits.creep=0.5 mm", "--full")
    assert ran.code == 1
    assert (
        "FAILS No candidate passes. Closest: full-ceramic, creep 3.50 of 0.5 mm (design, wet). "
        "Action Add candidates against what most miss, the creep limit." in ran.words
    )
    assert "- Missed: the creep limit (2 of 2)." in ran.words
    assert (
        "- Closest: the creep limit: 3.50 mm, max 0.5 mm (600 % over) [design, wet]." in ran.words
    )


def test_outputs(file: Path, tmp_path: Path) -> None:
    ran = wraparc("choose", file, "--json", "-", "--csv", tmp_path / "all.csv")
    assert ran.code == 0, ran.err
    designs = ran.json["designs"]
    assert [d["name"] for d in designs] == ["diamond-rubber", "full-ceramic"]
    with open(tmp_path / "all.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for row, design in zip(rows, designs, strict=True):
        assert float(row["creep [m]"]) == pytest.approx(design["creep"], rel=1e-6)
        assert float(row["total [AUD]"]) == pytest.approx(design["cost"], rel=1e-6)
        assert (row["rank"] == "") == bool(design["broken"])


def test_the_picture(file: Path, tmp_path: Path) -> None:
    ran = wraparc("choose", file, "--plot", tmp_path / "c.svg")
    assert ran.code == 0, ran.err
    assert "Pareto front" in (tmp_path / "c.svg").read_text("utf-8")


@pytest.mark.parametrize(
    ("setting", "sentence"),
    [
        ("drive=no.toml", "file not found"),
        ("pulley=tail", 'pulley: the drive has no such pulley, got "tail". Write one of "head".'),
        ('candidates.laggings=["diamond-ruber"]', 'Did you mean "diamond-rubber"?'),
        ('candidates.belts=["ST9999"]', "no type ST 9999 is listed"),
        ('candidates.belts=["Flexsteel"]', "the catalogue has no belt of this name"),
        ("limits.rating_share={stat=1.4}", "the drive has no such load case"),
        ("cost.lagging={rubber={material=5}}", "no lagging among the candidates"),
        ("cost.lagging.full-ceramic={material=5}", "the cost is not complete"),
        ("cost.hours={}", "a tariff without hours of a load case"),
        (
            'condition=[{name="dusty"}]',
            ('condition.dusty: lagging "diamond-rubber" has no friction in this condition'),
        ),
        ('candidates.slack_tensions="lest"', "must be an array"),
        ("candidates.slack_tensions=[]", "must have 1 to 100000 entries"),
        ('candidates.diameters=["800"]', "no unit, where a length is needed"),
    ],
)
def test_bad_input_is_told_in_a_sentence(file: Path, setting: str, sentence: str) -> None:
    ran = wraparc("choose", file, "--set", setting)
    assert ran.code == 2
    assert sentence in " ".join(ran.err.split()), ran.err
    assert "Traceback" not in ran.err


def test_energy_may_cost_nothing(file: Path) -> None:
    """Own power at no price: neither hours nor a belt speed are needed, and nothing is added."""
    free = wraparc("choose", file, "--set", "cost.tariff=0", "--set", "cost.hours={}")
    assert (free.code, free.err) == (0, "")
    nothing = wraparc("choose", file, "--set", "cost.tariff=0")
    assert free.out == nothing.out


FREE = '{material=0,installation=0,area="6 m2",life_years=[10,10]}'


def test_a_currency_without_prices_is_answered_and_they_are_named(file: Path) -> None:
    """All but the lagging is counted: as with laggings that cost nothing."""
    ran = wraparc("choose", file, "--set", "cost.currency=USD")
    assert ran.code == 0, ran.err
    lines = [
        "ATTENTION Lowest cost without lagging: full-ceramic with T2 50 kN, ",
        "Action Give cost.lagging.diamond-rubber, cost.lagging.full-ceramic: material, "
        "installation, area, life_years.",
        "Also No USD price of diamond-rubber, full-ceramic, only in AUD.",
    ]
    for line in lines:
        assert line in ran.words
    assert "The lagging is left out of the cost." in ran.words
    json = wraparc("choose", file, "--set", "cost.currency=USD", "--json", "-").json
    free = wraparc(
        "choose", file, "--set", "cost.currency=USD", "--json", "-",
        "--set", f"cost.lagging.diamond-rubber={FREE}",
        "--set", f"cost.lagging.full-ceramic={FREE}",
    ).json  # fmt: skip
    assert [d["cost"] for d in json["designs"]] == [d["cost"] for d in free["designs"]]
    assert json["ranking"] == free["ranking"]
    assert free["missing_prices"] == []
    assert json["missing_prices"] == [
        {"lagging": name, "key": f"cost.lagging.{name}", "currency": "AUD"}
        for name in ("diamond-rubber", "full-ceramic")
    ]


def test_one_price_in_the_currency_is_not_compared_with_none(file: Path) -> None:
    """A lagging that is priced would look more expensive than one that nobody priced."""
    one = f"cost.lagging.full-ceramic={FREE.replace('material=0', 'material=9000')}"
    ran = wraparc("choose", file, "--set", "cost.currency=USD", "--set", one)
    assert "Also No USD price of diamond-rubber, only in AUD." in ran.words
    assert "Action Give cost.lagging.diamond-rubber: material" in ran.words
    assert "Lowest cost without lagging: full-ceramic" in ran.words


def test_without_any_cost_the_lowest_creep_leads(file: Path) -> None:
    ran = wraparc("choose", file, "--set", "cost.currency=USD", "--set", "cost.tariff=0")
    assert "Lowest creep: full-ceramic with T2 50 kN, creep 3.50 mm." in ran.words
    assert "Designs that pass, lowest creep first" in ran.words


def test_a_lagging_without_cost_is_told(file: Path, tmp_path: Path) -> None:
    from wraparc.catalogue import lagging_text

    text = lagging_text("diamond-rubber").replace('surface = "rubber"\n', "")
    (tmp_path / "own.toml").write_text(text.replace("diamond-rubber", "own"), "utf-8")
    ran = wraparc("choose", file, "--set", 'candidates.laggings=["own.toml"]',
                  "--set", 'condition=[{name="dry"}]')  # fmt: skip
    assert (ran.code, ran.err) == (0, "")
    assert "No AUD price of own. The lagging is left out of the cost." in ran.words


def test_where_no_tension_is_enough_it_says_so(tmp_path: Path) -> None:
    """D 400 mm at 400 kN: friction falls with the pressure faster than tension grows."""
    text = drive_file(tmp_path).read_text("utf-8")
    for old, new in (("150 kN", "400 kN"), ("60 kN", "160 kN"), ("800 mm", "400 mm")):
        text = text.replace(f'"{old}"', f'"{new}"')
    (tmp_path / "over.toml").write_text(text.partition("[[load_case]]")[0], "utf-8")
    search = tmp_path / "choose.toml"
    search.write_text(
        'format = 1\ndrive = "over.toml"\n[candidates]\nlaggings = ["diamond-rubber"]\n'
        '[cost]\ncurrency = "EUR"\nface_width = "1400 mm"\n[cost.lagging.diamond-rubber]\n'
        'material = 100\ninstallation = 100\narea = "1 m2"\nlife_years = [5, 5]\n',
        "utf-8",
    )
    ran = wraparc("choose", search, "--full")
    way = "Use lagging full-ceramic, diameter 967 mm and a belt rated 334 kN/m"
    way += " (creep still fails)."
    assert f"FAILS The candidate diamond-rubber does not pass. Action {way}" in ran.words
    assert f"Action {way}" in wraparc("solve", tmp_path / "over.toml").words
    assert "Also Gross slip: safety 0.465 is below 1 (head, design)." in ran.words
    assert "No T2 in the tested pressure range meets the creep limit (head, design)." in ran.words


def test_a_year_has_no_more_hours_than_that() -> None:
    ran = wraparc("choose", EXAMPLES / "choose.toml", "--set", "cost.hours.start=3000")
    assert (ran.code, ran.out) == (2, "")
    assert "cost.hours: must sum to at most 8784" in " ".join(ran.err.split())


def test_pulleys_beside_the_chosen_one_are_judged_as_solve_does(tmp_path: Path) -> None:
    # expected: what `wraparc solve` says of the drive with what was recommended
    drive = shutil.copy(EXAMPLES.parent / "tandem-fabric.toml", tmp_path)
    file = tmp_path / "choose.toml"
    file.write_text(
        """format = 1
drive = "tandem-fabric.toml"
pulley = "first"
candidates.laggings = ["full-ceramic"]
candidates.slack_tensions = "least"
cost = { currency = "AUD", years = 10, tariff = 0.2, hours.design = 6000 }
""",
        "utf-8",
    )
    chosen = wraparc("choose", file)
    changed = ("--set", "train.exit_tension={}", "--set", "pulley.first.lagging=full-ceramic")
    found = re.search("Lowest cost: full-ceramic with T2 (.*?),", chosen.words)
    assert found is not None
    assert f" {found[1].removesuffix(' kN')} " in chosen.words.partition("front full-ceramic")[2]
    solved = wraparc("solve", drive, *(part.format(found[1]) for part in changed))
    assert re.search(r"^OK  ", chosen.out, re.MULTILINE)
    assert re.search(r"^OK  ", solved.out, re.MULTILINE)
    text = file.read_text("utf-8").replace('"least"', '["16.32 kN"]')
    file.write_text(text, "utf-8")
    chosen = wraparc("choose", file)
    solved = wraparc("solve", drive, *(part.format("16.32 kN") for part in changed))
    missed = "T2 16.32 kN is below the CEMA minimum 22.0 kN (second, design)."
    assert "ATTENTION Lowest cost: full-ceramic with T2 16.32 kN," in chosen.words
    assert f"Also {missed}" in chosen.words
    assert f"ATTENTION {missed}" in solved.words


SEARCH = """format = 1
drive = "drive.toml"
[candidates]
laggings = ["diamond-rubber"]
slack_tensions = ["{slack}"]
{more}
[cost]
currency = "AUD"
tariff = 0.2
hours.design = 6000
"""


@pytest.mark.parametrize(
    ("slack", "limits"),
    [("60 kN", '[limits]\ncreep = "20 mm"'), ("150 kN", "[limits.rating_share]\ndesign = 1.5")],
    ids=["more creep than the drive allows", "more tension than the rating allows"],
)
def test_limits_of_a_search_do_not_hide_what_solve_says(
    slack: str, limits: str, tmp_path: Path
) -> None:
    # expected: verdict and exit code of `wraparc solve` of the drive with what is recommended
    drive, file = tmp_path / "drive.toml", tmp_path / "search.toml"
    drive.write_text(BASE.replace("120 kN", "165 kN"), "utf-8")
    file.write_text(SEARCH.format(slack=slack, more=limits), "utf-8")
    tight = float(slack.partition(" ")[0]) + 90.0
    ends = {"exit_tension": slack, "entry_tension": f"{tight:g} kN"}
    changed = [x for k, v in ends.items() for x in ("--set", f"pulley.head.{k}={v}")]
    solved, chosen = wraparc("solve", drive, *changed, "--json", "-"), wraparc("choose", file)
    verdict = solved.json["verdict"]
    assert verdict["level"] != "OK"
    assert f"{verdict['level']} Lowest cost: diamond-rubber with T2 {slack}," in chosen.words
    assert chosen.code == solved.code
    assert f"Also {verdict['text']}" in chosen.words
    assert "Action Search again with that limit, or with other candidates." in chosen.words


def test_a_design_that_keeps_every_check_is_named(tmp_path: Path) -> None:
    """Wet the smaller pulley creeps more than its limit, the larger one does not (`solve`)."""
    (tmp_path / "drive.toml").write_text(
        BASE.replace("120 kN", "100 kN").replace("75 kN", "40 kN"), "utf-8"
    )
    more = 'diameters = ["800 mm", "1200 mm"]'
    file = tmp_path / "search.toml"
    file.write_text(SEARCH.format(slack="40 kN", more=more), "utf-8")
    told = wraparc("choose", file).words
    assert "ATTENTION Lowest cost: diamond-rubber, D 800 mm with T2 40 kN, 26,077 AUD" in told
    assert "Action Use diamond-rubber, D 1200 mm: all 10 checks pass, 30,138 AUD." in told
    assert "Also Wet creep 6.83 mm (estimated) exceeds the 6.35 mm limit (head, design)." in told
    levels = []
    for diameter in ("800 mm", "1200 mm"):
        set_ = ("--set", f"pulley.head.diameter={diameter}", "--json", "-")
        levels.append(wraparc("solve", tmp_path / "drive.toml", *set_).json["verdict"]["level"])
    assert levels == ["ATTENTION", "OK"]


def test_a_design_that_misses_a_check_of_its_drive_is_rejected(tmp_path: Path) -> None:
    """By hand: the face pressure of 800 mm is 2 120 kN/(0.8 m 1.2 m) = 250 kPa."""
    limit = 'preset = "Plylon Plus 1000/4"\nlargest_wrap_pressure = "200 kPa"'
    (tmp_path / "drive.toml").write_text(
        BASE.replace('preset = "Plylon Plus 1000/4"', limit), "utf-8"
    )
    more = 'diameters = ["800 mm", "1200 mm"]'
    file = tmp_path / "search.toml"
    file.write_text(SEARCH.format(slack="75 kN", more=more), "utf-8")
    told = wraparc("choose", file).words
    assert "OK Lowest cost: diamond-rubber, D 1200 mm with T2 75 kN," in told
    assert "D 800 mm the pressure on the pulley face: 250 kPa, max 200 kPa (25 % over)" in told
