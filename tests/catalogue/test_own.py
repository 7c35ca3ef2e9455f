"""The user's own laggings and belts: by name like those that ship, their faults told."""

from pathlib import Path

import pytest
from click.testing import CliRunner

from cli.running import wraparc
from web.calculators import API, client, document
from wraparc import InputError, Kind, Provenance, solve
from wraparc.catalogue import belt, belts, lagging_names, lagging_text
from wraparc.catalogue.own import VARIABLE
from wraparc.cli.serve import serve
from wraparc.files import drive_from_document, load_lagging

EXAMPLES = Path(__file__).parents[2] / "examples"
BELTS = """
format = 1
[[belt]]
name = "ACME EP1000/4"
kind = "fabric"
rating = "180 kN/m"
modulus = "13 MN/m"
provenance = { kind = "published", source = "ACME, 2024" }
[[belt]]
name = "ACME ST1000"
kind = "steel cord"
rating = "150 kN/m"
modulus = "72 MN/m"
least_pulley_diameter = "40 in"
"""


@pytest.fixture
def own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a lagging, made from one that ships, and two belts."""
    (tmp_path / "laggings").mkdir()
    text = lagging_text("diamond-rubber").replace('"diamond-rubber"', '"acme-60"')
    (tmp_path / "laggings" / "acme-60.toml").write_text(text, "utf-8")
    (tmp_path / "belts.toml").write_text(BELTS, "utf-8")
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    return tmp_path


def test_own_laggings_and_belts_go_by_name(own: Path) -> None:
    # expected: the numbers of the file, and the answer of the lagging that it was made from
    assert lagging_names()[-1] == "acme-60"
    first, second = belts()[-2:]
    assert (first.name, first.kind, first.rating, first.modulus) == (
        "ACME EP1000/4", "fabric", 180e3, 13e6,
    )  # fmt: skip
    assert first.least_pulley_diameter is None
    assert first.provenance == Provenance(Kind.PUBLISHED, "ACME, 2024")
    assert second.least_pulley_diameter == pytest.approx(1.016)
    assert second.provenance == Provenance()
    assert belt("acme ep1000/4") is first
    given = document()
    given["belt"] = {"preset": "ACME EP1000/4", "width": "1200 mm", "speed": "3 m/s"}
    one = solve(drive_from_document(given), raise_on_failure=False)
    given["pulley"][0]["lagging"] = "acme-60"
    other = solve(drive_from_document(given), raise_on_failure=False)
    assert other.drive.belt.modulus == 13e6
    assert [a.exit_creep for a in other] == [a.exit_creep for a in one]


def test_every_door_lists_them(own: Path) -> None:
    assert "acme-60" in wraparc("laggings")[1]
    assert "ACME ST1000" in wraparc("belts")[1]
    with client() as api:
        found = api.post(f"{API}/compare", json={"document": document(), "what": "laggings"}).json()
        assert "acme-60" in [row["name"] for row in found["rows"]]
    # what is written names them
    given = document()
    given["pulley"][0]["lagging"] = "acme-60"
    with client() as api:
        text = api.post(f"{API}/toml/write", json={"document": given}).json()["toml"]
    assert 'lagging = "acme-60"' in text


def test_without_the_folder_the_name_is_unknown() -> None:
    with pytest.raises(InputError, match="no lagging of this name"):
        load_lagging("acme-60")


def test_faults_are_told_with_the_place(own: Path) -> None:
    file = own / "belts.toml"
    file.write_text(BELTS.replace('"180 kN/m"', '"180 kN"').replace("modulus", "modulos"), "utf-8")
    with pytest.raises(InputError) as caught:
        belts()
    told = str(caught.value)
    assert str(file) in told
    assert "180 kN" in told
    assert "Did you mean" in told
    # the server says so before it starts
    ran = CliRunner().invoke(serve, ["--port", "0"])
    assert isinstance(ran.exception, InputError)


def test_the_name_in_a_lagging_file_is_that_of_the_file(own: Path) -> None:
    laggings = own / "laggings"
    (laggings / "beta.toml").write_text((laggings / "acme-60.toml").read_text("utf-8"), "utf-8")
    with pytest.raises(InputError, match="is not the name of its file"):
        load_lagging("beta")


def test_a_name_that_ships_is_refused(own: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    other = tmp_path_factory.mktemp("other")
    (other / "laggings").mkdir()
    shipped = lagging_text("full-ceramic")
    (other / "laggings" / "full-ceramic.toml").write_text(shipped, "utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(VARIABLE, str(other))
        with pytest.raises(InputError, match="a lagging of this name already") as caught:
            lagging_names()
    assert caught.value.problems[0].file == str(other / "laggings" / "full-ceramic.toml")
    assert caught.value.problems[0].value == '"full-ceramic"'


def test_a_belt_that_ships_is_refused_at_its_place(own: Path) -> None:
    (own / "belts.toml").write_text(BELTS.replace("ACME ST1000", "Plylon Plus 1000/4"), "utf-8")
    with pytest.raises(InputError, match="a belt of this name already") as caught:
        belts()
    (problem,) = caught.value.problems
    assert (problem.file, problem.key) == (str(own / "belts.toml"), "belt.2.name")


def test_a_fitted_lagging_goes_into_the_catalogue_by_its_name(own: Path) -> None:
    # expected: the law of the file that -o writes, by the new name
    plan = EXAMPLES / "shear_tests" / "plan.toml"
    ran = wraparc("fit", plan, "--name", "site-b", "-o", own / "apart.toml")
    assert ran.code == 0, ran.err
    assert f"Wrote {own / 'laggings' / 'site-b.toml'}" in ran.err
    assert load_lagging("site-b").law == load_lagging(str(own / "apart.toml")).law
    assert load_lagging("site-b").name == "site-b"
    for name, told in (
        ("site-b", "delete"),
        ("diamond-rubber", "of this name already"),
        ("a/b", "is no name of a lagging"),
    ):
        ran = wraparc("fit", plan, "--name", name)
        assert ran.code == 2
        assert told in ran.err


def test_a_name_needs_a_catalogue_of_ones_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)
    ran = wraparc("fit", EXAMPLES / "shear_tests" / "plan.toml", "--name", "site-b")
    assert ran.code == 2
    assert VARIABLE in ran.err


def test_a_folder_that_is_not_there_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "/no/such/folder")
    code, _, told = wraparc("belts")
    assert code == 2
    assert "the folder of your own catalogue is not there" in told
