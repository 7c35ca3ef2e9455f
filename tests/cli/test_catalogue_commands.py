"""``wraparc laggings``, ``lagging`` and ``belts``: everything there, with its source."""

from pathlib import Path

import pytest

from cli.running import wraparc
from wraparc import catalogue, load_lagging


def test_laggings_lists_all_with_their_origin() -> None:
    ran = wraparc("laggings")
    assert ran.code == 0
    for name in catalogue.lagging_names():
        mu = float(load_lagging(name).law.friction(6.35e-3, 207e3))
        assert f"{name} dry" in ran.words
        assert f" {mu:.2f} illustrative [1]" in ran.words
    assert "An illustrative lagging describes no real product." in ran.words


def test_lagging_shows_law_coefficients_and_design_values() -> None:
    """Expected A and b: A = -mu_pk/x_pk, b = A (1 + ln x_pk) of the knot 1.24, 16.5 mm."""
    ran = wraparc("lagging", "full-ceramic", "--full")
    assert ran.code == 0
    assert "A [1/mm] b [1/mm] x_pk [mm] mu_pk m [1/mm] mu_res" in ran.words
    assert "207 kPa -0.07515 -0.28583 16.5 1.240 0 1.240" in ran.words
    assert "CEMA 0.5 published [3], dimpled ceramic" in ran.words
    assert "Illustrative: it describes no product." in ran.words


def test_lagging_in_us_units() -> None:
    """A_in = 25.4 A_mm; 16.5 mm = 0.6496 in."""
    ran = wraparc("lagging", "full-ceramic", "--units", "us", "--full")
    assert f"30.0 psi {-1.24 / 16.5 * 25.4:.5f}" in ran.words
    assert "A [1/in] b [1/in] x_pk [in]" in ran.words
    assert "0.650" in ran.words


def test_lagging_of_a_file(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(
        'format = 1\nname = "mine"\nthickness = "0 mm"\n[[law]]\nkind = "constant"\n'
        'friction = 0.4\n[[law]]\ncondition = "wet"\nkind = "constant"\nfriction = 0.25\n',
        "utf-8",
    )
    ran = wraparc("lagging", path, "--full")
    assert ran.code == 0
    assert "Lagging (dry)" in ran.out
    assert "Friction mu(x, p) (wet)" in ran.out
    assert "0.250 0.250" in ran.words


def test_lagging_draws(tmp_path: Path) -> None:
    ran = wraparc("lagging", "diamond-rubber", "--plot", tmp_path / "a.pdf")
    assert (ran.code, ran.err) == (0, f"Wrote {tmp_path / 'a.pdf'}\n")
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["diamond-ruber"], ('Error: the catalogue has no lagging of this name, '
                             'got "diamond-ruber". Did you mean "diamond-rubber"?\n')),
        (["diamond-rubber", "--plot", "x.gif"], ("Error: --plot: must end in .svg or .png or "
                                                 '.pdf, got "x.gif". Write for example '
                                                 '"x.svg".\n')),
        (["x.toml"], "Error: x.toml: file not found.\n"),
    ],
)  # fmt: skip
def test_bad_names(arguments: list[str], sentence: str) -> None:
    assert wraparc("lagging", *arguments) == (2, "", sentence)


def test_belts_lists_all_by_kind() -> None:
    ran = wraparc("belts")
    assert ran.code == 0
    for belt in catalogue.belts():
        assert belt.name in ran.out
    assert "Flexsteel ST2000 300 kN/m 144000 kN/m not stated 1000 mm" in ran.words
    assert "Plylon Plus 1000/4 175 kN/m 12960 kN/m not stated -" in ran.words
    assert "[1] Goodyear EP conveyor belt catalogue, 2012" in ran.words
    assert "Standard names are read too: EP 630/3, EP 1000/4 6+3 Y, NN 500/4, ST 2000" in ran.words


def test_a_belt_by_its_standard_name_shows_every_number_with_its_source() -> None:
    ran = wraparc("belts", "EP 1000/4 6+3 Y", "ST 7500")
    assert ran.code == 0
    assert "Belt EP 1000/4 6+3 Y" in ran.words
    assert "Breaking strength 1000 kN/m" in ran.words
    assert "Modulus M 7500 kN/m published [2], estimated: 7.5 times the strength" in ran.words
    assert "Published moduli 5000 to 12000 kN/m" in ran.words
    assert "Carrying cover 6 mm" in ran.words
    for absent in ("Cord diameter", "Cord pitch", "Minimum drive pulley", "Carrying cover"):
        assert f"{absent} not available" in ran.words  # of ST 7500


def test_a_belt_with_a_typing_slip_is_asked() -> None:
    code, out, err = wraparc("belts", "EP 6300/3")
    assert (code, out) == (2, "")
    assert 'Did you mean "EP 630/3"' in err
