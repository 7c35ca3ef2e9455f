"""The equations that a note rests on: typeset, in LaTeX, and in words for who cannot see them."""

from collections.abc import Iterator, Sequence

from wraparc.arc import ArcResult
from wraparc.friction.base import Equation

_PRESSURE = Equation(
    "Wrap pressure",
    "p = (2 T) / (D B)",
    r"p = \frac{2T}{DB}",
    "p equals 2 T over D B",
)
_TENSION = Equation(
    "Equilibrium of the belt along the wrap",
    "(dif ln T) / (dif theta) = - tau / p, quad T(0) = T_1, quad T(phi) = T_2",
    r"\frac{d \ln T}{d\theta} = -\frac{\tau}{p},\quad T(0) = T_1,\quad T(\varphi) = T_2",
    "the derivative of the logarithm of T by theta equals minus tau over p, with T of 0 equal to "
    "T1 and T of phi equal to T2",
)
_CREEP = Equation(
    "Growth of creep: global creep ratio g, belt shrinkage, recovery of the lagging",
    "(dif u) / (dif theta) = R [g + (T_1 - T) / (E A')], quad "
    "1 / (E A') = 1 / (M B) + (2 h) / (B D R E_c)",
    r"\frac{du}{d\theta} = R\left[g + \frac{T_1 - T}{EA'}\right],\quad "
    r"\frac{1}{EA'} = \frac{1}{MB} + \frac{2h}{BDRE_c}",
    "the derivative of u by theta equals R times g plus T1 minus T over E A prime; one over E A "
    "prime equals one over M B plus 2 h over B D R E c",
)
_CREEP_PLAIN = Equation(
    "Growth of creep: global creep ratio g and belt shrinkage",
    "(dif u) / (dif theta) = R [g + (T_1 - T) / (M B)]",
    r"\frac{du}{d\theta} = R\left[g + \frac{T_1 - T}{MB}\right]",
    "the derivative of u by theta equals R times g plus T1 minus T over M B",
)
_SHEAR = Equation(
    "Creep is slip and shear of the lagging; where the belt slides, friction is used in full",
    "u = x + h / G tau, quad tau = mu(x, p) p, quad tan gamma = tau / G",
    r"u = x + \frac{h}{G}\tau,\quad \tau = \mu(x, p)\,p,\quad \tan\gamma = \frac{\tau}{G}",
    "u equals x plus h over G times tau; tau equals mu of x and p times p; the tangent of gamma "
    "equals tau over G",
)
_KICK = Equation(
    "Entry overrun, from the compression of the lagging",
    "u(0) = 1.25 delta sqrt(delta / R), quad delta = h p_1 / E_c",
    r"u(0) = 1.25\,\delta\sqrt{\delta/R},\quad \delta = h\,p_1/E_c",
    "u of 0 equals 1.25 delta times the square root of delta over R, with delta equal to h p1 "
    "over E c",
)
_CAPACITY = Equation(
    "Capacity at the creep limit and its equivalent friction",
    'r_a = T_"tight" / T_"slack" "at" abs(u(phi)) = u_max, quad mu_"eq" = (ln r_a) / phi',
    r"r_a = \left.\frac{T_\mathrm{tight}}{T_\mathrm{slack}}\right|_{|u(\varphi)| = u_{\max}},"
    r"\quad \mu_\mathrm{eq} = \frac{\ln r_a}{\varphi}",
    "r a equals the tight-side tension over the slack-side tension at which the magnitude "
    "of u of phi equals u max; mu eq equals the logarithm of r a over phi",
)
_LOSS = Equation(
    "Power lost to creep",
    "P_v = v_s (T_1 - T_2) [g + (T_1 - T_2) / (2 E A')]",
    r"P_v = v_s (T_1 - T_2)\left[g + \frac{T_1 - T_2}{2EA'}\right]",
    "P v equals v s times T1 minus T2 times g plus T1 minus T2 over 2 E A prime",
)
_DESIGN = Equation(
    "Design values: Euler and Eytelwein, wrap factor of CEMA",
    "T_1 / T_2 <= e^(mu phi), quad T_2 >= C_w (T_1 - T_2), quad C_w = 1 / (e^(mu phi) - 1)",
    r"\frac{T_1}{T_2} \le e^{\mu\varphi},\quad T_2 \ge C_w (T_1 - T_2),\quad "
    r"C_w = \frac{1}{e^{\mu\varphi} - 1}",
    "T1 over T2 is at most e to the mu phi; T2 is not below C w times T1 minus T2; C w equals one "
    "over e to the mu phi minus 1",
)
_PAPER = Equation(
    "The paper's integration, segment by segment from the exit; L with an index is the arc left to "
    "the entry",
    "u_i = (T_1 - T_i) L_i / (M B) + c L_i / L + u(0), quad Delta T = mu p B Delta s",
    r"u_i = (T_1 - T_i)\frac{L_i}{MB} + c\,\frac{L_i}{L} + u(0),\quad "
    r"\Delta T = \mu\,p\,B\,\Delta s",
    "u i equals T1 minus T i times L i over M B plus c times L i over L plus u of 0; the change of "
    "T equals mu p B times the change of s",
)
_TRAIN = Equation(
    "Surface speeds of drives on one belt",
    "v_i / v_1 = ((1 + T_i \\/ M B) (1 - g_1)) / ((1 + T_1 \\/ M B) (1 - g_i))",
    r"\frac{v_i}{v_1} = \frac{(1 + T_i/MB)(1 - g_1)}{(1 + T_1/MB)(1 - g_i)}",
    "v i over v 1 equals 1 plus T i over M B times 1 minus g 1, over 1 plus T 1 over M B times 1 "
    "minus g i",
)


def equations(
    arcs: Sequence[ArcResult], *, paper: bool, train: bool, design: bool
) -> tuple[Equation, ...]:
    """Return the equations that the results of some arcs rest on, in the order of the work.

    Parameters
    ----------
    arcs
        The arcs.
    paper, train, design
        Whether the paper's integration, speeds of a train, and design values are shown too.
    """
    return tuple(_chosen(arcs, paper=paper, train=train, design=design))


def _chosen(
    arcs: Sequence[ArcResult], *, paper: bool, train: bool, design: bool
) -> Iterator[Equation]:
    yield _PRESSURE
    yield _TENSION
    yield _CREEP if any(r.arc.recovery for r in arcs) else _CREEP_PLAIN
    yield _SHEAR
    yield from dict.fromkeys(r.arc.law.equation for r in arcs)
    if any(r.arc.overrun is None for r in arcs):
        yield _KICK
    yield _CAPACITY
    if any(r.arc.belt_speed for r in arcs):
        yield _LOSS
    if train:
        yield _TRAIN
    if paper:
        yield _PAPER
    if design:
        yield _DESIGN
