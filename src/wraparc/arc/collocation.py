"""The wrap arc as a two-point problem: creep u and tension T by Gauss collocation of sixth order.

With the arc length s from the entry, C = 1/EA', the width B, the entry creep ratio g and the one
free number K = g + C T(0),

    u' = K - C T,    T' = -B tau(u, T),    u(0) = x_c(T(0)),

and two more conditions at the ends, one for each question that an arc is asked (`Ends`). Unknown
are u and T at the ends of elements, three stage tensions in each and K; all equations are solved at
once by Newton's method. Nothing is marched from one end, so that nothing grows like exp(L/l) along
an arc much longer than its shear-lag length l.

U. Ascher, R. Mattheij, R. Russell, *Numerical Solution of Boundary Value Problems for Ordinary
Differential Equations*, chapters 5 and 9 (collocation, condensation of stages, mesh selection).

One source runs in the interpreter and translated for the page: plain floats, lists, named tuples.
"""

from __future__ import annotations

from math import ceil, exp, inf, log, nan, sqrt
from typing import NamedTuple

from wraparc.arc.quantities import LEAST_COMPLIANCE, Geometry
from wraparc.arc.traction import (
    LEAST_CREEP,
    Traction,
    branch_at,
    creep_of_slip,
    plateau_stress,
    stress_of_slip,
    traction,
)
from wraparc.arrays import Number
from wraparc.friction.compact import CompactLaw, segment_of

# Gauss's method of three stages: places, weights of the stages and of the end
_Q = sqrt(15.0)
_S = 3.0 * sqrt(0.6)
C0, C1, C2 = 0.5 - _Q / 10.0, 0.5, 0.5 + _Q / 10.0
A00, A01, A02 = 5.0 / 36.0, 2.0 / 9.0 - _Q / 15.0, 5.0 / 36.0 - _Q / 30.0
A10, A11, A12 = 5.0 / 36.0 + _Q / 24.0, 2.0 / 9.0, 5.0 / 36.0 - _Q / 24.0
A20, A21, A22 = 5.0 / 36.0 + _Q / 30.0, 2.0 / 9.0 + _Q / 15.0, 5.0 / 36.0
B0, B1, B2 = 5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0
# denominators of the cubic through the start and the stages
D0 = C0 * (C0 - C1) * (C0 - C2)
D1, D2 = C1 * (C1 - C0) * (C1 - C2), C2 * (C2 - C0) * (C2 - C1)
# slopes of that cubic at the start and at the end of an element
F0, F1, F2 = C1 * C2 / D0, C0 * C2 / D1, C0 * C1 / D2
L0 = ((1.0 - C1) * (1.0 - C2) + 2.0 - C1 - C2) / D0
L1 = ((1.0 - C0) * (1.0 - C2) + 2.0 - C0 - C2) / D1
L2 = ((1.0 - C0) * (1.0 - C1) + 2.0 - C0 - C1) / D2

#: Conditions at the exit.
TENSION, CREEP, SLIP = range(3)
FIRST_ELEMENTS, GRADING = 8, 2.0  # of the first mesh: s = L (i/n)^2, the slip begins at the entry
MOST_ELEMENTS = 400
LEAST_PART, MOST_PART = 1.0, 8.0  # elements for one, as its misfit asks
#: Largest change of a tension, of the pull, that ends Newton's method, and that on a mesh not yet
#: judged; one that may be rounding; a pull that is next to none, of the tension.
NEWTON, COARSELY, ROUNDING, LEAST_PULL = 1e-9, 1e-4, 1e-5, 1e-5
FARTHEST = 1e6  # change of a tension, of the pull, after which nothing is found
LEAST_LEFT, MOST_STRETCH = 0.2, 0.5  # of a tension, of a length, after one step
FIRST_STEPS, LATER_STEPS, MOST_ROUNDS, KINK_ROUNDS = 15, 20, 14, 2
MOST_USED = 0.95  # of the plateau of friction, of the mean friction of a first guess
SMALL, MOST_KINKS = 1e-5, 60  # creep without a sign, of the largest; kinks of one course
TURN = 1e-3  # of the arc: an element so short needs no grading towards a turn of the creep
FREELY = 1e-10  # of a change of K behind a rest arc that its start does not take back
KINK = 1e-4  # of an element: how near to a kink an element has to end
AMPLIFIED = 10.0  # by how much creep may answer to a misfit of tension on the usual mesh
MOST_AMPLIFIED = 100.0  # how much finer a mesh gets for it: finer ones end in rounding
MESH = 1e-6  # misfit of an element, of the largest change of tension, that is let stand
LONGEST = 2.0  # slide behind a rest arc that is followed, of the wrap
ROUGH = 1e-3  # misfit that is let stand on the way
#: Continuation in what shears: shear-lag lengths of the softest arc, shear of one that has none, of
#: the softest; how much softer than the law; first factor of a step, least one, and most steps.
SOFTEST, SOFTER, LEAST_SHEAR, FIRST_SOFTER, LEAST_SOFTER, MOST_SOFTENED = (
    3.0,
    10.0,
    1e-9,
    1.0 / 16.0,
    0.97,
    60,
)


class Interface(NamedTuple):
    """Traction between belt and shell.

    Attributes
    ----------
    law, shear
        The friction law, and h/G [m/Pa], or more on the way to it.
    slides
        0; or the way (+1, -1) that the belt slides all along under a law that jumps: traction is
        that of slip, however small.
    rests
        Whether it slides behind a rest arc: then creep and K at the start of the slide follow from
        the tension there (`start_at`), and the length is free instead.
    """

    law: CompactLaw
    shear: float
    slides: float
    rests: bool


class Ends(NamedTuple):
    """What is asked at the ends of an arc.

    Attributes
    ----------
    at_entry, at_exit, tension
        at_entry T(0) + at_exit T(L) = tension [-, -, N].
    kind, goal
        TENSION: T(L) [N]; CREEP: u(L) [m]; SLIP: the slip at the exit [m].
    """

    at_entry: float
    at_exit: float
    tension: float
    kind: int
    goal: float


class Slopes(NamedTuple):
    """How the tensions at the ends answer to the free number Z, K or ln(length), and to the goal.

    Attributes
    ----------
    first, last
        dT(0)/dZ and dT(L)/dZ, the condition at the exit held [N].
    first_goal, last_goal
        By the goal at the exit, Z held.
    """

    first: float
    last: float
    first_goal: float
    last_goal: float


class Course(NamedTuple):
    """Creep and tension along an arc.

    Attributes
    ----------
    place, creep, tension
        Of the ends of elements, from the entry to the exit: s [m], u [m], T [N].
    stage
        Tensions at the three stages of each element [N].
    ratio
        K = g + C T(0) [-].
    """

    place: list[float]
    creep: list[float]
    tension: list[float]
    stage: list[float]
    ratio: float


class Solved(NamedTuple):
    """What Newton's method ended with.

    Attributes
    ----------
    done
        Whether it settled.
    course
        The course.
    slopes
        How its ends answer, nan where there was no step.
    """

    done: bool
    course: Course
    slopes: Slopes


NO_SLOPES = Slopes(nan, nan, nan, nan)


def between_tensions(entry: float, leaving: float) -> Ends:
    """Both tensions given [N]: the operating point."""
    return Ends(1.0, 0.0, entry, TENSION, leaving)


def compliance_of(arc: Geometry) -> float:
    """C = 1/EA' [1/N]."""
    return max(arc.compliance, LEAST_COMPLIANCE)


def overrun_at(arc: Geometry, tension: float) -> tuple[float, float]:
    """Overrun x_c at an entry tension [m], and its slope by that [m/N]."""
    area = arc.width * arc.radius
    grown = arc.overrun_coefficient * (tension / area) ** 1.5
    return arc.overrun_constant + grown, 1.5 * grown / tension


def first_course(arc: Geometry, length: float, entry: float, leaving: float, end: float) -> Course:
    """A first guess on a mesh graded to the entry: ln T falls evenly, creep grows to `end` [m]."""
    n, fall = FIRST_ELEMENTS, log(entry / leaving)
    start = overrun_at(arc, entry)[0]
    shares = [(i / n) ** GRADING for i in range(n + 1)]
    stage = []
    for i in range(n):
        h = shares[i + 1] - shares[i]
        stage += [entry * exp(-fall * (shares[i] + c * h)) for c in (C0, C1, C2)]
    return Course(
        [length * share for share in shares],
        [start + (end - start) * share for share in shares],
        [entry * exp(-fall * share) for share in shares],
        stage,
        (end - start) / length + compliance_of(arc) * 0.5 * (entry + leaving),
    )


def mean_creep(
    face: Interface, arc: Geometry, entry: float, leaving: float, used: float = MOST_USED
) -> float:
    """Creep at which the mean friction of an arc is used at its mean tension [m].

    At most the share `used` of the largest friction there is.
    """
    area, fall = arc.width * arc.radius, abs(log(entry / leaving))
    p = sqrt(entry * leaving) / area
    stress = min(fall / arc.wrap_angle * p, used * plateau_stress(face.law, p))
    if stress <= 0.0:
        return 0.0
    high = 1e-9
    while traction(face.law, face.shear, p, high).stress < stress and high < 1e3:
        high *= 4.0
    low = 0.25 * high
    for _ in range(12):
        middle = sqrt(low * high)
        if traction(face.law, face.shear, p, middle).stress < stress:
            low = middle
        else:
            high = middle
    return arc.side * high


def traction_at(face: Interface, pressure: float, creep: float) -> Traction:
    """Traction of an interface at a wrap pressure [Pa] and a creep [m]."""
    if face.slides != 0.0:
        return _sliding(face, pressure, creep)
    return traction(face.law, face.shear, pressure, creep)


def _sliding(face: Interface, pressure: float, creep: float) -> Traction:
    """Traction of a belt that slides one way, at a creep that way or at the least that slides."""
    held, by_pressure = stress_of_slip(face.law, pressure, LEAST_CREEP)
    if face.slides * creep > face.shear * held + LEAST_CREEP:
        return traction(face.law, face.shear, pressure, creep)
    return Traction(face.slides * held, 0.0, face.slides * by_pressure, 0.0)


def lag_length(arc: Geometry) -> float:
    """Shear-lag length l = sqrt(c EA'/B) of a lagging that holds the belt [m]."""
    return sqrt(arc.shear / (arc.width * compliance_of(arc)))


def start_at(face: Interface, arc: Geometry, tension: float) -> tuple[float, float]:
    """Creep at the start of a course by the tension there [m], and its slope by that [m/N].

    The overrun at the entry; behind a rest arc the creep that a held belt is let go at.
    """
    if not face.rests:
        return overrun_at(arc, tension)
    area = arc.width * arc.radius
    held, by_pressure = stress_of_slip(face.law, tension / area, LEAST_CREEP)
    return face.slides * face.shear * held, face.slides * face.shear * by_pressure / area


def held_stiffness(arc: Geometry) -> float:
    """Tension per creep that is taken up at the end of a held belt much longer than l, B l/c [N/m].

    c is the compliance of what shears.
    """
    return arc.width * lag_length(arc) / arc.shear


def entry_of_rest(face: Interface, arc: Geometry, tension: float) -> float:
    """Entry tension of a rest arc, much longer than l, by that at its end [N].

    Creep u = x_c e^(-s/l) + u_r e^((s - r)/l) over its length r is held by u/c.
    """
    if arc.shear == 0.0:
        return tension
    end, taken = start_at(face, arc, tension)[0], held_stiffness(arc)
    entry = tension
    for _ in range(4):  # an overrun by formula grows with the entry tension: Newton's method
        overrun, by_tension = overrun_at(arc, entry)
        change = (entry - tension - taken * (overrun + end)) / (1.0 - taken * by_tension)
        entry = max(entry - change, LEAST_LEFT * entry)
    return entry


def ratio_behind_rest(face: Interface, arc: Geometry, tension: float) -> tuple[float, float]:
    """K behind a rest arc much longer than l, u' = u_r/l at its end [-], and its slope [1/N]."""
    creep, by_tension = start_at(face, arc, tension)
    c, lag = compliance_of(arc), lag_length(arc)
    if lag == 0.0:
        return c * tension, c
    return c * tension + creep / lag, c + by_tension / lag


def stage_creeps(h: float, ratio: float, c: float, u: float, k: list[float]) -> list[float]:
    """Creeps at the stages of an element of length h that begins at the creep u [m]."""
    k0, k1, k2 = k
    return [
        u + h * (C0 * ratio - c * (A00 * k0 + A01 * k1 + A02 * k2)),
        u + h * (C1 * ratio - c * (A10 * k0 + A11 * k1 + A12 * k2)),
        u + h * (C2 * ratio - c * (A20 * k0 + A21 * k1 + A22 * k2)),
    ]


def stage_matrix(
    hb: Number, hc: Number, v: tuple[Number, ...], w: tuple[Number, ...]
) -> tuple[tuple[Number, ...], tuple[Number, ...], Number]:
    """Slopes of the stage stresses by the stage tensions, d tau_j = w_j dT_j - v_j h C sum A dT.

    Parameters
    ----------
    hb, hc
        h B and h C of an element.
    v, w
        Slopes of the stresses by creep and by tension.

    Returns
    -------
    The nine slopes J, and the adjugate and the determinant of 1 + h B A J, row by row.
    """
    v0, v1, v2 = v
    w0, w1, w2 = w
    j00, j01, j02 = w0 - v0 * hc * A00, -v0 * hc * A01, -v0 * hc * A02
    j10, j11, j12 = -v1 * hc * A10, w1 - v1 * hc * A11, -v1 * hc * A12
    j20, j21, j22 = -v2 * hc * A20, -v2 * hc * A21, w2 - v2 * hc * A22
    m00 = 1.0 + hb * (A00 * j00 + A01 * j10 + A02 * j20)
    m01 = hb * (A00 * j01 + A01 * j11 + A02 * j21)
    m02 = hb * (A00 * j02 + A01 * j12 + A02 * j22)
    m10 = hb * (A10 * j00 + A11 * j10 + A12 * j20)
    m11 = 1.0 + hb * (A10 * j01 + A11 * j11 + A12 * j21)
    m12 = hb * (A10 * j02 + A11 * j12 + A12 * j22)
    m20 = hb * (A20 * j00 + A21 * j10 + A22 * j20)
    m21 = hb * (A20 * j01 + A21 * j11 + A22 * j21)
    m22 = 1.0 + hb * (A20 * j02 + A21 * j12 + A22 * j22)
    a00, a01, a02 = m11 * m22 - m12 * m21, m02 * m21 - m01 * m22, m01 * m12 - m02 * m11
    a10, a11, a12 = m12 * m20 - m10 * m22, m00 * m22 - m02 * m20, m02 * m10 - m00 * m12
    a20, a21, a22 = m10 * m21 - m11 * m20, m01 * m20 - m00 * m21, m00 * m11 - m01 * m10
    return (
        (j00, j01, j02, j10, j11, j12, j20, j21, j22),
        (a00, a01, a02, a10, a11, a12, a20, a21, a22),
        m00 * a00 + m01 * a10 + m02 * a20,
    )


def condensed(
    face: Interface, arc: Geometry, h: float, c: float, at: Course, i: int
) -> tuple[list[float], list[float]]:
    """An element made linear, its stages eliminated.

    Returns
    -------
    stages
        Changes of the three stage tensions: constant, and by du, dT at the start and dZ; 3 x 4.
        Behind a rest arc also by dK.
    end
        du and dT at the end, the same way; 2 x 4. The constants are what is missing.
    """
    area, hb, hc = arc.width * arc.radius, h * arc.width, h * c
    u, tension, ratio = at.creep[i], at.tension[i], at.ratio
    k0, k1, k2 = k = at.stage[3 * i : 3 * i + 3]
    u0, u1, u2 = stage_creeps(h, ratio, c, u, k)
    f0, v0, w0, _ = traction_at(face, k0 / area, u0)
    f1, v1, w1, _ = traction_at(face, k1 / area, u1)
    f2, v2, w2, _ = traction_at(face, k2 / area, u2)
    j, a, det = stage_matrix(hb, hc, (v0, v1, v2), (w0 / area, w1 / area, w2 / area))
    j00, j01, j02, j10, j11, j12, j20, j21, j22 = j
    a00, a01, a02, a10, a11, a12, a20, a21, a22 = a
    stages, end = [], []
    shrunk = ratio - c * (B0 * k0 + B1 * k1 + B2 * k2)  # mean growth of creep
    x0, x1, x2, grown = v0 * C0, v1 * C1, v2 * C2, 0.0
    if face.rests:  # by ln(length)
        x0, x1, x2, grown = v0 * (u0 - u) / h, v1 * (u1 - u) / h, v2 * (u2 - u) / h, hb
    columns = [
        (
            tension - k0 - hb * (A00 * f0 + A01 * f1 + A02 * f2),
            tension - k1 - hb * (A10 * f0 + A11 * f1 + A12 * f2),
            tension - k2 - hb * (A20 * f0 + A21 * f1 + A22 * f2),
            f0,
            f1,
            f2,
        ),
        (
            -hb * (A00 * v0 + A01 * v1 + A02 * v2),
            -hb * (A10 * v0 + A11 * v1 + A12 * v2),
            -hb * (A20 * v0 + A21 * v1 + A22 * v2),
            v0,
            v1,
            v2,
        ),
        (1.0, 1.0, 1.0, 0.0, 0.0, 0.0),
        (
            -hb * h * (A00 * x0 + A01 * x1 + A02 * x2) - grown * (A00 * f0 + A01 * f1 + A02 * f2),
            -hb * h * (A10 * x0 + A11 * x1 + A12 * x2) - grown * (A10 * f0 + A11 * f1 + A12 * f2),
            -hb * h * (A20 * x0 + A21 * x1 + A22 * x2) - grown * (A20 * f0 + A21 * f1 + A22 * f2),
            h * x0,
            h * x1,
            h * x2,
        ),
    ]
    if face.rests:  # and by K
        x0, x1, x2 = h * v0 * C0, h * v1 * C1, h * v2 * C2
        columns.append(
            (
                -hb * (A00 * x0 + A01 * x1 + A02 * x2),
                -hb * (A10 * x0 + A11 * x1 + A12 * x2),
                -hb * (A20 * x0 + A21 * x1 + A22 * x2),
                x0,
                x1,
                x2,
            )
        )
    for q0, q1, q2, g0, g1, g2 in columns:
        y0 = (a00 * q0 + a01 * q1 + a02 * q2) / det
        y1 = (a10 * q0 + a11 * q1 + a12 * q2) / det
        y2 = (a20 * q0 + a21 * q1 + a22 * q2) / det
        stages += [y0, y1, y2]
        end.append(-hc * (B0 * y0 + B1 * y1 + B2 * y2))
        end.append(
            -hb
            * (
                B0 * (g0 + j00 * y0 + j01 * y1 + j02 * y2)
                + B1 * (g1 + j10 * y0 + j11 * y1 + j12 * y2)
                + B2 * (g2 + j20 * y0 + j21 * y1 + j22 * y2)
            )
        )
    end[0] += u + h * shrunk - at.creep[i + 1]
    end[1] += tension - at.tension[i + 1]
    end[2] += 1.0
    end[5] += 1.0
    end[6] += h * shrunk if face.rests else h
    end[7] -= grown * (B0 * f0 + B1 * f1 + B2 * f2)
    if face.rests:
        end[8] += h
    return stages, end


def exit_row(face: Interface, arc: Geometry, ends: Ends, at: Course) -> tuple[float, float, float]:
    """Condition at the exit made linear: by_creep du + by_tension dT = missing."""
    u, tension = at.creep[-1], at.tension[-1]
    if ends.kind == TENSION:
        return 0.0, 1.0, ends.goal - tension
    if ends.kind == CREEP:
        return 1.0, 0.0, ends.goal - u
    area = arc.width * arc.radius
    size = abs(ends.goal)
    sign = 1.0 if ends.goal > 0.0 else -1.0
    by_pressure = stress_of_slip(face.law, tension / area, size)[1]
    creep = sign * creep_of_slip(face.law, face.shear, tension / area, size)
    return 1.0, -sign * face.shear * by_pressure / area, creep - u


def improved(
    face: Interface, arc: Geometry, ends: Ends, at: Course
) -> tuple[Course, float, Slopes]:
    """One Newton step; the course after it, and the largest change of a tension of the largest.

    Creep is carried from the entry, du = r + d dZ - b dT, tension read from the exit: with friction
    that rises neither grows, whatever the length of the arc.
    """
    n, c = len(at.place) - 1, compliance_of(arc)
    start, by_tension = start_at(face, arc, at.tension[0])
    b, r, d, dk = -by_tension, start - at.creep[0], 0.0, 0.0
    elements, back = [], []
    for i in range(n):
        stages, end = condensed(face, arc, at.place[i + 1] - at.place[i], c, at, i)
        s0, z0, s1, z1, s2, z2, s3, z3 = end[:8]
        pt = z2 - z1 * b
        rt, zt = (z0 + z1 * r) / pt, (z3 + z1 * d) / pt
        kt = (end[9] + z1 * dk) / pt if face.rests else 0.0
        elements.append(stages)
        back.append((r, d, b, rt, zt, 1.0 / pt, dk, kt))
        turn = s2 - s1 * b
        if face.rests:
            dk = end[8] + s1 * dk - turn * kt
        b, r, d = -turn / pt, s0 + s1 * r - turn * rt, s3 + s1 * d - turn * zt
    by_creep, by_exit, missing = exit_row(face, arc, ends, at)
    free = by_exit - by_creep * b
    if free == 0.0:
        return at, inf, NO_SLOPES
    last, last_z, last_goal = (missing - by_creep * r) / free, -by_creep * d / free, 1.0 / free
    first, first_z, first_goal = last, last_z, last_goal
    last_k = first_k = -by_creep * dk / free
    for i in range(n - 1, -1, -1):
        _, _, _, rt, zt, over, _, kt = back[i]
        first, first_z, first_goal = over * first - rt, over * first_z - zt, over * first_goal
        first_k = over * first_k - kt
    exit_z = last_z
    drop = entry_of_rest(face, arc, at.tension[0]) - at.tension[0] if face.rests else 0.0
    short = ends.tension - ends.at_entry * (at.tension[0] + drop) - ends.at_exit * at.tension[n]
    short -= ends.at_entry * first + ends.at_exit * last
    slope, k = ends.at_entry * first_z + ends.at_exit * last_z, 0.0
    det, dz = slope, short
    if face.rests:  # K follows from the tension at the start: two equations for dZ and dK
        wanted, steep = ratio_behind_rest(face, arc, at.tension[0])
        part, lack = 1.0 - steep * first_k, wanted - at.ratio + steep * first
        by_k = ends.at_entry * first_k + ends.at_exit * last_k
        det = part * slope + steep * first_z * by_k
        dz, k = part * short - by_k * lack, lack * slope + steep * first_z * short
        # under traction that no pressure changes, tension shifts freely along the arc
        part = steep / (part if abs(part) > FREELY else FREELY)
        last_z, last_goal = last_z + last_k * part * first_z, last_goal + last_k * part * first_goal
        first_z, first_goal = first_z * (1.0 + first_k * part), first_goal * (1.0 + first_k * part)
    if det == 0.0:
        return at, inf, NO_SLOPES
    dz, k = dz / det, k / det
    moved = last + exit_z * dz + last_k * k
    end_row = (r + dk * k, d, b)
    new, change = _moved(face, at, elements, back, end_row, moved, (dz, k))
    if face.rests:
        stretch = 1.0 + max(min(dz, MOST_STRETCH), -MOST_STRETCH)
        new = new._replace(place=[stretch * place for place in at.place])
        change = max(change, abs(dz))
    return new, change, Slopes(first_z, last_z, first_goal, last_goal)


def _moved(
    face: Interface,
    at: Course,
    elements: list[list[float]],
    back: list[tuple[float, float, float, float, float, float, float, float]],
    end: tuple[float, float, float],
    dt: float,
    free: tuple[float, float],
) -> tuple[Course, float]:
    """Apply a Newton step, from the exit to the entry; `end` ties du at the exit to dT and dZ."""
    n, (dz, dk) = len(elements), free
    creep, tension, stage = at.creep[:], at.tension[:], at.stage[:]
    largest, top = abs(dt), max(at.tension[0], at.tension[n])
    scale = max(abs(at.tension[0] - at.tension[n]), LEAST_PULL * top)
    creep[n] += end[0] + end[1] * dz - end[2] * dt
    tension[n] = max(tension[n] + dt, LEAST_LEFT * tension[n])
    for i in range(n - 1, -1, -1):
        r, d, b, rt, zt, over, rk, kt = back[i]
        dt = over * dt - rt - zt * dz - kt * dk
        du = r + d * dz + rk * dk - b * dt
        y = elements[i]
        for j in range(3):
            change = y[j] + y[3 + j] * du + y[6 + j] * dt + y[9 + j] * dz
            if face.rests:
                change += y[12 + j] * dk
            k = stage[3 * i + j]
            stage[3 * i + j] = max(k + change, LEAST_LEFT * k)
            largest = max(largest, abs(change))
        creep[i] += du
        tension[i] = max(tension[i] + dt, LEAST_LEFT * tension[i])
        largest = max(largest, abs(dt))
    return Course(
        at.place, creep, tension, stage, at.ratio + (dk if face.rests else dz)
    ), largest / scale


def converged(
    face: Interface, arc: Geometry, ends: Ends, at: Course, most: int, near: float
) -> Solved:
    """Newton's method on one mesh, until a step changes no tension by `near` of the pull."""
    slopes, before = NO_SLOPES, inf
    for _ in range(most):
        if spent(arc, at):
            return Solved(False, at, slopes)
        at, change, slopes = improved(face, arc, ends, at)
        if not change < FARTHEST:
            return Solved(False, at, slopes)
        # what no longer shrinks, where steps shrink as squares, is rounding
        if change < near or (change < ROUNDING and change > 0.5 * before):
            return Solved(True, at, slopes)
        before = change
    return Solved(False, at, slopes)


def spent(arc: Geometry, at: Course) -> bool:
    """Count a step over a mesh, or as much work; whether there are none left."""
    if arc.left is None:
        return False
    arc.left[0] -= len(at.place) - 1
    return arc.left[0] < 0.0


def weights_at(c: Number) -> tuple[Number, Number, Number]:
    """Integrals from 0 to c of the parabolas that are 1 at one stage of an element each."""
    x = 2.0 * c - 1.0
    linear, square = 0.25 * (x * x - 1.0), 0.25 * (x * x * x - x)  # Legendre's, integrated
    return (
        B0 * (c - _S * linear + 2.0 * square),
        B1 * (c - 2.5 * square),
        B2 * (c + _S * linear + 2.0 * square),
    )


def state_at(arc: Geometry, at: Course, i: int, c: float) -> tuple[float, float]:
    """Creep [m] and tension [N] at a fraction c of element i, by its polynomials."""
    h, k, t, compliance = at.place[i + 1] - at.place[i], at.stage, at.tension[i], compliance_of(arc)
    w0, w1, w2 = weights_at(c)
    d0, d1, d2 = k[3 * i] - t, k[3 * i + 1] - t, k[3 * i + 2] - t  # all 0 in a belt at rest
    change = w0 * d0 + w1 * d1 + w2 * d2
    u = at.creep[i] + h * (c * (at.ratio - compliance * t) - compliance * change)
    # the cubic through the tensions at the start and the stages
    c0, c1, c2 = c - C0, c - C1, c - C2
    return u, t + c * (d0 * c1 * c2 / D0 + d1 * c0 * c2 / D1 + d2 * c0 * c1 / D2)


def misfits(face: Interface, arc: Geometry, at: Course, kind: int) -> list[float]:
    """How far the traction at the ends of each element is from that of its polynomial [-].

    The slope of the cubic through the tensions at its start and stages is -B tau at the stages,
    and misses it at the ends. As a tension, times the length: of the change of tension where both
    are given (`kind` TENSION), of the change of the logarithm of tension where one is found.
    """
    n, area, k, tension = len(at.place) - 1, arc.width * arc.radius, at.stage, at.tension
    size = 1e-7 * tension[0]
    for one in tension:
        size = max(size, abs(one - tension[0]))
    fall = max(abs(log(tension[0] / tension[n])), LEAST_PULL)
    taken = [
        arc.width * traction_at(face, tension[i] / area, at.creep[i]).stress for i in range(n + 1)
    ]
    found = []
    for i in range(n):
        h, t = at.place[i + 1] - at.place[i], tension[i]
        d0, d1, d2 = k[3 * i] - t, k[3 * i + 1] - t, k[3 * i + 2] - t
        first = abs(d0 * F0 + d1 * F1 + d2 * F2 + h * taken[i])
        last = abs(d0 * L0 + d1 * L1 + d2 * L2 + h * taken[i + 1])
        of = size if kind == TENSION else fall * min(t, tension[i + 1])
        found.append(max(first, last) / of)
    return found


def piece_code(
    face: Interface, arc: Geometry, state: tuple[float, float], least: float
) -> tuple[int, int, int]:
    """The piece of a law that holds at a place: sign of the creep, segment, branch.

    A creep below `least` [m] has no sign: on the way to an arc at rest it is rounding.
    """
    u, tension = state
    p = tension / (arc.width * arc.radius)
    segment = segment_of(face.law, p)
    branch = branch_at(face.law, segment, face.shear, p, max(abs(u), LEAST_CREEP))
    return (0 if abs(u) < least else 1 if u > 0.0 else -1), segment, branch


def _differ(one: tuple[int, int, int], other: tuple[int, int, int]) -> bool:
    """Whether two places lie in different pieces of the law, or creep turns between them."""
    return one[0] * other[0] < 0 or one[1] != other[1] or one[2] != other[2]


def kinks(face: Interface, arc: Geometry, at: Course) -> list[tuple[float, bool]]:
    """Places where the course passes into another piece of the law [m], and whether creep turns."""
    found: list[tuple[float, bool]] = []
    largest, lowest = max(at.creep), min(at.creep)
    least = SMALL * max(largest, -lowest)
    c, n, k = compliance_of(arc), len(at.place) - 1, at.stage
    code = (0, 0, 0)
    for i in range(n):
        h = at.place[i + 1] - at.place[i]
        u0, u1, u2 = stage_creeps(h, at.ratio, c, at.creep[i], k[3 * i : 3 * i + 3])
        states = [(C0, u0, k[3 * i]), (C1, u1, k[3 * i + 1]), (C2, u2, k[3 * i + 2])]
        if i + 1 < n:
            states.append((1.0, at.creep[i + 1], at.tension[i + 1]))
        low = 0.0
        for high, u, t in states:
            now = piece_code(face, arc, (u, t), least)
            if i == 0 and high == C0:
                code = now
            elif _differ(now, code):
                share, turns = _change(face, arc, at, i, (low, high), code)
                found.append((at.place[i] + share * h, turns))
            code = now if now[0] != 0 else (code[0], now[1], now[2])
            low = high
    return found[:MOST_KINKS]


def _change(
    face: Interface,
    arc: Geometry,
    at: Course,
    i: int,
    within: tuple[float, float],
    code: tuple[int, int, int],
) -> tuple[float, bool]:
    """Fraction of an element at which a piece of the law ends, and whether creep turns there."""
    low, high = within
    turns = False
    while high - low > 0.1 * KINK:
        middle = 0.5 * (low + high)
        now = piece_code(face, arc, state_at(arc, at, i, middle), 0.0)
        if _differ(now, code):
            high, turns = middle, now[0] != code[0]
        else:
            low = middle
    return high, turns


def meshed(
    face: Interface, arc: Geometry, at: Course, kind: int, tol: float
) -> tuple[bool, bool, Course]:
    """The course on a mesh that spreads the misfit evenly and ends elements at kinks.

    With whether a finer mesh is needed, else the course is as it was; and whether the misfit asks
    for it, not a kink alone.
    """
    places, misses = at.place, misfits(face, arc, at, kind)
    spent(arc, at)
    needed = [(miss / tol) ** 0.25 for miss in misses]
    needed[0] = needed[0] ** 2  # creep begins there with the steepest slope of a law
    ends = kinks(face, arc, at)
    far = False
    for where, _ in ends:
        far = far or _misses(places, where)
    over = max(needed) > 1.0
    if not far and not over:
        return False, False, at
    new = _spread(places, [min(max(part, LEAST_PART), MOST_PART) for part in needed])
    for where, turns in ends:
        _end_at(new, where, turns)
    return True, over, _carried_over(arc, at, new)


def _misses(places: list[float], where: float) -> bool:
    """Whether no element ends at a kink."""
    i = 0
    while places[i + 1] < where:
        i += 1
    h = places[i + 1] - places[i]
    return min(where - places[i], places[i + 1] - where) > KINK * h


def _spread(places: list[float], parts: list[float]) -> list[float]:
    """Ends of elements of which each has the same share of the parts that were asked for."""
    total = sum(parts)
    n = min(max(ceil(total), FIRST_ELEMENTS), MOST_ELEMENTS)
    new, i, done = [0.0], 0, 0.0
    for j in range(1, n):
        goal = total * j / n
        while done + parts[i] < goal:
            done += parts[i]
            i += 1
        new.append(places[i] + (places[i + 1] - places[i]) * (goal - done) / parts[i])
    new.append(places[-1])
    return new


def _end_at(places: list[float], where: float, turns: bool) -> None:
    """Let an element end at a kink: by a node that is moved, or by a new one."""
    i = 0
    while places[i + 1] < where:
        i += 1
    h = places[i + 1] - places[i]
    near = i if where - places[i] < 0.5 * h else i + 1
    if 0 < near < len(places) - 1 and abs(where - places[near]) < 0.3 * h:
        places[near] = where
        i = near
    else:
        i += 1
        places.insert(i, where)
    for _ in range(4 if turns and h > TURN * places[-1] else 0):
        # the slope of a law that rises like a logarithm is infinite there
        places.insert(i, where - (where - places[i - 1]) * 0.25)
        i += 1
        places.insert(i + 1, where + (places[i + 1] - where) * 0.25)


def _carried_over(arc: Geometry, at: Course, places: list[float]) -> Course:
    """A course on another mesh of the same length."""
    creep, tension, stage = [at.creep[0]], [at.tension[0]], []
    i = 0
    for j in range(len(places) - 1):
        h = places[j + 1] - places[j]
        for c in (C0, C1, C2, 1.0):
            s = places[j] + c * h
            while i + 2 < len(at.place) and at.place[i + 1] < s:
                i += 1
            share = (s - at.place[i]) / (at.place[i + 1] - at.place[i])
            u, t = state_at(arc, at, i, min(share, 1.0))
            # between rough points the cubic of a tension may fall below 0
            t = max(t, LEAST_LEFT * min(at.tension[i], at.tension[i + 1]))
            if c < 1.0:
                stage.append(t)
        creep.append(u)
        tension.append(t)
    last = len(places) - 1
    creep[last], tension[last] = at.creep[-1], at.tension[-1]
    return Course(places, creep, tension, stage, at.ratio)


def softened(face: Interface, arc: Geometry, ends: Ends, at: Course, tol: float) -> Solved:
    """Continuation in what shears: from a lagging so soft that the arc is a few l long.

    There the law gives way less than the lagging, and an overrun is held. Every arc on the way has
    all of the friction, and creep and tension that change over lengths which the mesh of the one
    before resolves.
    """
    length, entry, leaving = at.place[-1], at.tension[0], at.tension[-1]
    mean = sqrt(entry * leaving) / (arc.width * arc.radius)
    creep = mean_creep(face, arc, entry, leaving) + overrun_at(arc, entry)[0]
    gives = SOFTER * abs(creep) / plateau_stress(face.law, mean)
    least = max((length / SOFTEST) ** 2 * compliance_of(arc) * arc.width, gives)
    soft = face._replace(shear=max(face.shear, least), slides=0.0)
    creep = at.creep[-1]
    if ends.kind == TENSION:
        creep = 2.0 * mean_creep(soft, arc, entry, leaving)
    first = first_course(arc, length, entry, leaving, creep)
    found = converged(soft, arc, ends, first, FIRST_STEPS, COARSELY)
    if not found.done:
        return found
    least, step = max(face.shear, LEAST_SHEAR * soft.shear), FIRST_SOFTER
    at = meshed(soft, arc, found.course, ends.kind, ROUGH)[2]
    for _ in range(MOST_SOFTENED):
        if step > LEAST_SOFTER:
            break
        shear = max(step * soft.shear, least)
        now = soft._replace(shear=shear) if shear > least else face
        found = converged(now, arc, ends, at, FIRST_STEPS, COARSELY)
        if not found.done:
            step = sqrt(step)
            continue
        soft, step = now, step * sqrt(step)
        at = meshed(soft, arc, found.course, ends.kind, max(ROUGH, tol))[2]
        if shear == least:
            return converged(face, arc, ends, at, LATER_STEPS, COARSELY)
    return Solved(False, at, NO_SLOPES)


def solved(face: Interface, arc: Geometry, ends: Ends, start: Course, tol: float = MESH) -> Solved:
    """Meet the end conditions from a first guess, on meshes that adapt until nothing misses."""
    found = _refined(face, arc, ends, start, tol)
    if not found.done or ends.kind != TENSION or face.rests:
        return found
    answers = amplification(found)
    if answers <= AMPLIFIED:
        return found
    finer = _refined(face, arc, ends, found.course, tol / answers)
    return finer if finer.done else found


def _refined(face: Interface, arc: Geometry, ends: Ends, start: Course, tol: float) -> Solved:
    """The course on meshes that adapt until no element misses by more."""
    found = converged(face, arc, ends, start, FIRST_STEPS, COARSELY)
    kept = 0
    for _ in range(MOST_ROUNDS):
        if face.rests and found.course.place[-1] > LONGEST * arc.radius * arc.wrap_angle:
            return Solved(False, found.course, found.slopes)
        if not found.done:
            return found
        finer, over, new = meshed(face, arc, found.course, ends.kind, tol)
        kept = 0 if over else kept + 1
        if not finer or kept > KINK_ROUNDS:  # kinks may come and go with the mesh
            break
        found = converged(face, arc, ends, new, LATER_STEPS, COARSELY)
    return converged(face, arc, ends, found.course, LATER_STEPS, NEWTON)


def amplification(found: Solved) -> float:
    """How many times the relative error of tension that of creep is, tensions given, from 1 [-].

    L |dK/dT| |T(0) - T(L)| / max|u|, T at the end where it counts more: large where more creep
    hardly brings more friction.
    """
    at, slopes = found.course, found.slopes
    pull = abs(at.tension[0] - at.tension[-1])
    moves = at.place[-1] * max(abs(slopes.first_goal), 1.0) * pull
    size = abs(slopes.first) * max([abs(creep) for creep in at.creep])
    return min(moves / size, MOST_AMPLIFIED) if moves > size else 1.0


def solved_or_softened(
    face: Interface, arc: Geometry, ends: Ends, start: Course, tol: float = MESH
) -> Solved:
    """`solved`, by continuation in what shears where Newton's method alone does not get there."""
    found = solved(face, arc, ends, start, tol)
    if found.done:
        return found
    found = softened(face, arc, ends, start, tol)
    return solved(face, arc, ends, found.course, tol) if found.done else found
