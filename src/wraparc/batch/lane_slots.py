"""Where the lane kernel keeps a lane's numbers: slots of `w`, and what nodes and traces hold."""

from __future__ import annotations

from wraparc.batch.lane_law import CELL

MESHES = (32, 96)  # steps of the mesh: at first, and where that is not enough
MOST_STEPS = 96
NODE = 13  # numbers of a node, see `lay_nodes` and, where friction falls, `lay_tail`
TRACE = 5  # numbers recorded at the ends of every step: s, x, ds by step, shear stress, its change
SMALLEST = 1e-30

# slots: the arc that is marched ...
(
    ROW,  # place of its law in the table
    LOW,  # first edge of the law [Pa]
    HIGH,  # last edge [Pa]
    BUCKETS_PER_PASCAL,
    RADIUS,  # R [m]
    LENGTH,  # L [m]
    SHEAR,  # h/G [m/Pa]
    P1,  # wrap pressure at the entry [Pa]
    RATIO,  # T1 C [-]
    KICK,  # creep at the entry [m]
    PEAK_SLIP,  # of the law at the entry [m]
    PEAK_FRICTION,  # of the law at the entry [-]
    END,  # Q [-]
    G,  # entry creep ratio [-]
    G_Z,  # dg/dz [-]
    # ... where it is, with derivatives by z ...
    Q0,
    X,
    S,
    X_Z,
    S_Z,
    # ... the stages of a step ...
    AT,
    AT_Z,
    SUM_X,
    SUM_S,
    SUM_XZ,
    SUM_SZ,
    # ... where the pressure passes HIGH and LOW, in steps of the finest mesh ...
    PASS_HIGH,
    PASS_LOW,
    # ... and the law at a pressure: where it is asked, what was fetched, what follows
    PRESSURE,
    INSIDE,
    BUCKET,
    BEND,  # h/(G R) [1/Pa]
    CELL_AT,
) = range(33)
FETCHED = CELL_AT + CELL
SLIP_AT, FRICTION_AT, FRICTION_P, SLIP_P = range(FETCHED, FETCHED + 4)
SHARE = FETCHED + 4  # of a node that lies inside the law's range, see `lay_nodes`
MARCH_SLOTS = FETCHED + 5

(
    WIDTH,  # B [m]
    COMPLIANCE,  # 1/EA' [1/N]
    KICK_GIVEN,  # overrun that is given [m]
    KICK_FORMULA,  # overrun per p1^1.5 [m/Pa^1.5]
    TENSION,  # T1 [N]
    GAMMA,  # x_c / l
    Z,
    MISS,  # ln(s/L)
    EXIT_X,  # slip at the exit [m]
    P_WORK,  # of the guess: pressures, and the law there
    SLIP_WORK,
    FRICTION_WORK,
    P_EXIT,
    SLIP_EXIT,
    FRICTION_EXIT,
    WORK_0,  # int mu dx of the kick [m]
    SLOPE_Z,  # d ln s/dz and dx/dz at the exit
    EXIT_X_Z,
    GOAL,  # creep or slip at the exit [m]
    PULL,  # T1 - T2 [N]
    GOAL_MISS,  # ln(creep or slip / GOAL)
    # derivatives of both misses by z, by END and by ln T2
    S_BY_Z,
    S_BY_Q,
    S_BY_T,
    V_BY_Z,
    V_BY_Q,
    V_BY_T,
    DETERMINANT,
    KEPT,
    KEPT_GOAL,
    KEPT_SZ,
    KEPT_VZ,
    COARSE_X,  # exit slip by the mesh of half the steps [m]
    CHANGE,  # of the exit slip by the mesh of all steps, relative
) = range(MARCH_SLOTS, MARCH_SLOTS + 34)
SOLVE_SLOTS = MARCH_SLOTS + 34

(
    SLIP_MAX,  # largest tested slip, 1e300 without a tested range [m]
    EXIT_STRESS,
    ENTRY_STRESS,
    EXIT_CREEP,
    PEAK_STRESS,  # largest shear stress [Pa] and where [m]
    PEAK_AT,
    ACTIVE,  # length of the active arc [m]
    OUTSIDE,  # share of the arc outside the tested range
    STEEPEST,  # largest x/x_pk along the arc
    PEAK_NODE,  # number of the step at whose beginning the stress is largest
    SLIP_STEPS,  # number of steps that begin within the largest tested slip
) = range(SOLVE_SLOTS, SOLVE_SLOTS + 11)
READ_SLOTS = SOLVE_SLOTS + 11

(
    CENTRE,  # of a scan in ln g
    BEST,  # largest ln(T1/T2), where, and beside it
    BEST_AT,
    LAST,
    RISEN,
    FALLEN,
    CREST,  # second derivative of ln(T1/T2) by z
    CARRIED,  # ln(T1/T2) of a march
    S_LAST,  # s and ds at the beginning of a step
    S_RATE,
) = range(READ_SLOTS, READ_SLOTS + 10)
GROSS_SLOTS = READ_SLOTS + 10

(
    SIDE,  # 1 driving, -1 braking
    GRADED_PART,  # of eta, a graded step of the kernel's mesh
    PLAIN_STEP,  # of Q, a step past the graded ones
    ETA,  # where a step begins, and Q there
    Q_AT,
    ABOVE,  # 1 where the pressure is above or below the range of the law
    BELOW,
    GRADED,  # last Q of the graded steps, 0 past them
    STEP_FROM,  # a step: eta or Q where it begins, its length, Q at its end, its weight
    STEP_BY,
    STEP_TO,
    WEIGHED_BY,
    WORK,  # of friction [J/m2]
    SUM_W,
    RATE_1,  # rates of slip of the stages
    RATE_2,
    RATE_3,
    RATE_4,
    RATE_5,
    RATE_6,
    RATE_S,  # of arc by the last stage
    X_AT_FIRST,
    STOP,  # Q that the mesh is laid to; END is where it would end
    # ... where the arc ends: 1 once it has, 1e300 or the length where it does, arc past it ...
    ENDED,
    LIMIT,
    S_PAST,
    Q_FROM,  # Q where the step begins and ends in which it ends, and the part of it
    Q_TO,
    Q_SPAN,
    PART,
    S_FROM,
    X_FROM,
    WORK_FROM,
    END_AT,
    # ... the search: g and g + x_c/l at first, the last try, slope of the miss by z
    G_AT_FIRST,
    SUM_AT_FIRST,
    Z_LAST,
    MISS_LAST,
    SLOPE,
    # ... of two unknowns, z and ln T1: the second, its first value, its miss, what they were last
    LOG_TENSION,
    LOG_AT_FIRST,
    MISS_2,
    MISS_2_LAST,
    LOG_LAST,
    J_11,
    J_12,
    J_21,
    J_22,
) = range(GROSS_SLOTS, GROSS_SLOTS + 48)
SIXTH_SLOTS = GROSS_SLOTS + 48

# the march with creep as the state, see `lane_creep`
(
    T,  # tension over T1
    U,  # creep [m]
    T_Z,  # their derivatives by z
    U_Z,
    AT_T,  # the stages of a step
    AT_U,
    AT_TZ,
    AT_UZ,
    SUM_T,
    SUM_U,
    SUM_TZ,
    SUM_UZ,
    STEP,  # length of a step [m]
    SOFT,  # h/G p, of the state [m]
    HELD,  # of the traction above the range of the law, over what it would be without
    SLIP,  # magnitude of slip [m]
    FRICTION,  # with the sign of the creep, and its derivatives by creep and by T/T1
    FRICTION_U,
    FRICTION_T,
    GONE,  # 1 where the state has left the cell of the table that was fetched
    MISSED,  # largest miss of a slip, relative to the creep
    RISES_TO,  # slip up to which friction does not fall [m]
    CREEP_GUESS,  # creep at the exit [m]
    STIFF_GUESS,  # friction per slip at small slip [1/m]
    G_MIDDLE,  # g = G_MIDDLE + G_SCALE sinh z
    G_SCALE,
    Z_LOW,  # z is between them
    Z_HIGH,
    Z_STEP,  # the last change of z, before it was limited
    U_COARSE,  # creep at the exit by the coarser mesh [m]
    LARGEST,  # slip along the arc [m]
    FASTEST,  # change of slip along the arc [-]
    A_0,  # the cubic of the fetched cell at the pressure of the state
    A_1,
    A_2,
    A_3,
    REST,  # creep past the beginning of the cell [m]
    PAST,  # slip past it, and what that is between [m]
    PAST_LOW,
    PAST_HIGH,
    AT_NODE,  # a place on the mesh, in steps
    CREST_LOW,  # between them the stress is largest, and two places within
    CREST_HIGH,
    CREST_1,
    CREST_2,
    STRESS_1,
    STRESS_2,
    U_COARSEST,  # the same by a third of the steps, and its change by all steps
    CHANGE_FIRST,
) = range(SIXTH_SLOTS, SIXTH_SLOTS + 49)
CREEP_SLOTS = SIXTH_SLOTS + 49

# the kernel's march with its steps cut, see `lane_cut`
(
    BRANCH,  # of the law: 0 the rise, 1 the line past the peak, 2 the residual
    NEXT_BRANCH,  # that a step comes to
    FRESH,  # 1 where a step of the mesh begins, 0 within one
    CUTTING,  # 0 no cut, 1 at a branch, 2 at the exit nip
    LOW_PART,  # of a step, what the cut lies between, and how far the state is beyond it there
    HIGH_PART,
    LOW_GAP,
    HIGH_GAP,
    MESH_END,  # Q where the step of the mesh ends
    ETA_END,
    GRADED_STEP,
    CUT_END,  # Q where what is cut would end
    LEAST_SLIP,  # that a march may come to [m]
    FINISHED,  # 1 at the exit nip, 2 where the march does not apply
    TRACTION,  # at the end of a step [Pa]
    SUM_S_AT,
) = range(CREEP_SLOTS, CREEP_SLOTS + 16)
SLOTS = CREEP_SLOTS + 16
