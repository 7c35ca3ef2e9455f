"""Name, symbol, dimension and meaning of every quantity that wraparc reads or reports.

Tables, pictures, forms, files and the documentation take their words from here, so that
a quantity has one name everywhere.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from wraparc.units import Dimension, System, display_unit


@dataclass(frozen=True)
class Quantity:
    """One quantity as users meet it.

    Parameters
    ----------
    name
        Key in files, results and flags.
    symbol
        Letter of the equations, in plain ASCII.
    dimension
        What it measures; values are held in its SI unit.
    title
        Short heading of a table row, an axis or a form field.
    meaning
        One sentence: what it is, with its formula where it has one.
    """

    name: str
    symbol: str
    dimension: Dimension
    title: str
    meaning: str

    def heading(self, system: System = "si") -> str:
        """Return title, symbol and unit for an axis or a column: ``Wrap pressure p [kPa]``."""
        unit, _ = display_unit(self.dimension, system)
        parts = (self.title, self.symbol, f"[{unit}]" if unit else "")
        return " ".join(part for part in parts if part)


#: What became of quantities by their old names.
RENAMED: Mapping[str, str] = MappingProxyType(
    {
        "gross_slip_margin": "Write gross_slip_safety, or extrapolated_gross_slip_margin for the "
        "former ratio."
    }
)
QUANTITIES: tuple[Quantity, ...] = (
    # the drive as described
    Quantity(
        "entry_tension", "T1", "force", "Entry tension",
        "Belt tension where the belt meets the pulley.",
    ),
    Quantity(
        "exit_tension", "T2", "force", "Exit tension",
        "Belt tension where the belt leaves the pulley.",
    ),
    Quantity(
        "effective_tension", "Te", "force", "Effective tension",
        "Peripheral force on the pulley, T1 - T2: positive when driving, negative when "
        "braking.",
    ),
    Quantity(
        "tension_ratio", "T1/T2", "number", "Tension ratio",
        "Entry tension over exit tension; below 1 on a braking pulley.",
    ),
    Quantity(
        "wrap_angle", "phi", "angle", "Wrap angle",
        "Angle over which the belt lies on the pulley, from the entry nip to the exit nip.",
    ),
    Quantity(
        "diameter", "D", "length", "Diameter over lagging",
        "Pulley diameter over the unloaded lagging.",
    ),
    Quantity(
        "belt_width", "B", "length", "Belt width",
        "Width of the belt, over which tension and friction are spread evenly.",
    ),
    Quantity(
        "belt_modulus", "M", "force_per_width", "Belt modulus",
        "Tension per unit width for unit strain of the belt.",
    ),
    Quantity(
        "axial_stiffness", "EA", "force", "Axial stiffness of the belt",
        "Tension for unit strain of the whole belt, EA = M B.",
    ),
    Quantity(
        "belt_speed", "v", "speed", "Belt speed",
        "Running speed of the belt; power and wear need it.",
    ),
    Quantity(
        "pulley_cover", "t_p", "length", "Pulley cover",
        "Thickness of the belt cover on the side of the pulleys.",
    ),
    Quantity(
        "carry_cover", "t_c", "length", "Carrying cover",
        "Thickness of the belt cover on the carrying side.",
    ),
    Quantity(
        "carcass", "t_k", "length", "Carcass",
        "Thickness of the carcass, or diameter of the cords.",
    ),
    Quantity(
        "belt_thickness", "t_b", "length", "Belt thickness",
        "Covers and carcass in all.",
    ),
    Quantity(
        "cover_shear_modulus", "G_b", "pressure", "Shear modulus of the covers",
        "Shear stress for unit tangent of the shear angle of a belt cover.",
    ),
    Quantity(
        "cord_diameter", "d_c", "length", "Cord diameter",
        "Diameter of the steel cords; that of the carcass.",
    ),
    Quantity(
        "cord_pitch", "p_c", "length", "Cord pitch",
        "Distance between the axes of neighbouring steel cords.",
    ),
    Quantity(
        "belt_mass", "m_b", "mass_per_length", "Belt mass",
        "Mass of a metre of belt; m v^2 of the tension presses on no pulley.",
    ),
    Quantity(
        "pitch_offset", "e_b", "length", "Offset of the tension member",
        "Height of the tension member over the lagging surface: the cover that meets the pulley "
        "and half of the carcass.",
    ),
    Quantity(
        "centrifugal_force", "m_b v^2", "force", "Centrifugal force",
        "Part of the belt tension that presses on no pulley.",
    ),
    Quantity(
        "lagging_thickness", "h", "length", "Lagging thickness",
        "Thickness of the lagging that shears.",
    ),
    Quantity(
        "shear_modulus", "G", "pressure", "Shear modulus of the lagging",
        "Shear stress over the gross area for unit tangent of the shear angle.",
    ),
    Quantity(
        "compression_modulus", "E_c", "pressure", "Compression modulus of the lagging",
        "Effective modulus in compression through the thickness, channels and tiles included.",
    ),
    Quantity(
        "overrun", "x_c", "length", "Entry overrun",
        "Rearward slip with which the belt starts on freshly compressed lagging at the entry "
        "nip; negative towards travel.",
    ),
    Quantity(
        "resultant_force", "R", "force", "Resultant of the belt tensions",
        "Force of the belt on shaft and bearings of the pulley, its own weight left out.",
    ),
    Quantity(
        "pulley_mass", "m_p", "mass", "Mass of the pulley",
        "With lagging and shaft; its weight bears on the bearings beside the belt tensions.",
    ),
    Quantity(
        "most_shaft_load", "R_max", "force", "Maximum load of shaft and bearings",
        "Resultant of the belt tensions and weight of the pulley, the belt pulling straight down.",
    ),
    Quantity(
        "least_shaft_load", "R_min", "force", "Minimum load of shaft and bearings",
        "Resultant of the belt tensions less the weight of the pulley, the belt pulling straight "
        "up.",
    ),
    Quantity(
        "resultant_angle", "", "angle", "Direction of the resultant",
        "From the line of the entry tension towards that of the exit tension.",
    ),
    Quantity(
        "belt_safety", "S_B", "number", "Safety factor of the belt",
        "Breaking strength of the belt over its maximum tension at the pulley.",
    ),
    Quantity(
        "creep_limit", "u_max", "length", "Creep limit",
        "Maximum accepted creep; 6.35 mm is the conservative customary value.",
    ),
    # friction of a lagging
    Quantity(
        "friction", "mu", "number", "Friction available",
        "Coefficient of friction that the lagging offers at the local slip and wrap pressure, "
        "mu(x, p).",
    ),
    Quantity(
        "friction_used", "tau/p", "number", "Friction used",
        "Shear stress over wrap pressure; less than the friction available where the belt "
        "sticks.",
    ),
    Quantity(
        "peak_friction", "mu_pk", "number", "Peak friction",
        "Maximum friction over all slips at one wrap pressure.",
    ),
    Quantity(
        "peak_slip", "x_pk", "length", "Slip at peak friction",
        "Slip at which the friction has its peak.",
    ),
    Quantity(
        "post_peak_slope", "m", "per_length", "Slope past the peak",
        "Change of friction with slip past its peak; zero or negative.",
    ),
    Quantity(
        "residual_friction", "mu_res", "number", "Residual friction",
        "Level below which friction does not fall past its peak.",
    ),
    Quantity(
        "lash", "x_0", "length", "Lash",
        "Clearance in the shear rig, by which the slip of a shear test is shifted.",
    ),
    Quantity(
        "wear_coefficient", "k_w", "wear_coefficient", "Energetic wear coefficient",
        "Volume worn off the lagging per frictional energy.",
    ),
    # along the arc
    Quantity(
        "position", "theta", "angle", "Position on the arc",
        "Angle from the entry nip (0) towards the exit nip (phi).",
    ),
    Quantity(
        "tension", "T", "force", "Belt tension",
        "Local tension of the belt.",
    ),
    Quantity(
        "wrap_pressure", "p", "pressure", "Wrap pressure",
        "Pressure of the belt on the lagging, p = 2 T/(B D).",
    ),
    Quantity(
        "creep", "u", "length", "Creep",
        "Rearward displacement of the belt against the pulley shell since the entry nip.",
    ),
    Quantity(
        "slip", "x", "length", "Slip",
        "Rearward displacement of the belt against the lagging surface, the argument of the "
        "friction law.",
    ),
    Quantity(
        "shear_stress", "tau", "pressure", "Shear stress",
        "Shear stress between belt and lagging, positive when the pulley drives the belt.",
    ),
    Quantity(
        "shear_angle", "gamma", "angle", "Shear angle of the lagging",
        "Angle by which the lagging is sheared, tan(gamma) = tau/G.",
    ),
    Quantity(
        "shear_distance", "h tan(gamma)", "length", "Shear distance of the lagging",
        "Displacement of the lagging surface against the shell, (h/G) tau: creep less slip.",
    ),
    Quantity(
        "sliding", "", "number", "Sliding",
        "Whether the belt slides on the lagging (1) or sticks to it (0).",
    ),
    # result of one pulley
    Quantity(
        "exit_creep", "u(phi)", "length", "Creep at exit",
        "Creep where the belt leaves the pulley, the sum of its three parts.",
    ),
    Quantity(
        "exit_creep_low", "", "length", "Creep at exit, low end",
        "Low end of the 95 % interval of the exit creep by the uncertainty of the fitted law, the "
        "tensions as they are.",
    ),
    Quantity(
        "exit_creep_high", "", "length", "Creep at exit, high end",
        "High end of the same interval; infinite where the friction there does not transmit "
        "the load.",
    ),
    Quantity(
        "creep_shrinkage", "u_s", "length", "Creep by belt shrinkage",
        "Part of the exit creep because the belt shortens as it sheds tension, R int (T1 - "
        "T)/EA dtheta.",
    ),
    Quantity(
        "creep_compression", "u_c", "length", "Creep by lagging compression",
        "Part of the exit creep from the entry overrun and the recovery of the compressed "
        "lagging.",
    ),
    Quantity(
        "creep_global", "u_g", "length", "Global creep",
        "Part of the exit creep in which the whole belt runs uniformly slower than the pulley "
        "surface, g R phi.",
    ),
    Quantity(
        "exit_slip", "x(phi)", "length", "Slip at exit",
        "Slip where the belt leaves the pulley.",
    ),
    Quantity(
        "peak_shear_stress", "tau_max", "pressure", "Peak shear stress",
        "Maximum magnitude of the shear stress along the arc, which the bond of the lagging "
        "has to withstand.",
    ),
    Quantity(
        "peak_shear_angle", "gamma_max", "angle", "Peak shear angle",
        "Maximum magnitude of the shear angle along the arc.",
    ),
    Quantity(
        "peak_shear_position", "theta_max", "angle", "Position of peak shear",
        "Angle from the entry nip at which the shear stress peaks.",
    ),
    Quantity(
        "entry_creep_ratio", "g", "number", "Entry creep ratio",
        "Surface speed less belt speed over surface speed at the entry nip: the steady global "
        "creep.",
    ),
    Quantity(
        "exit_creep_ratio", "g2", "number", "Exit creep ratio",
        "The same at the exit nip, where the lagging has recovered, g + (T1 - T2)/EA'; a "
        "tachometer behind the pulley shows the strain of the belt alone, without that recovery.",
    ),
    Quantity(
        "mean_friction", "mu_m", "number", "Mean friction",
        "Constant friction that would transmit the same load over the whole wrap, "
        "|ln(T1/T2)|/phi.",
    ),
    Quantity(
        "active_arc", "phi_a", "angle", "Active arc",
        "Exit part of the wrap over which 99 % of the tension change takes place.",
    ),
    Quantity(
        "k_factor", "k", "spring_rate", "Spring rate (k factor)",
        "Spring rate of the belt over its active arc, belt modulus times belt width over the "
        "length of the active arc, M B/(R phi_a).",
    ),
    Quantity(
        "stuck_arc", "phi_0", "angle", "Arc at rest",
        "Entry part of the wrap over which the belt does not slip on the lagging.",
    ),
    Quantity(
        "outside_tested_share", "", "number", "Share outside tested range",
        "Fraction of the wrap where pressure or slip lies outside the tested range of the "
        "lagging.",
    ),
    # what the pulley could carry
    Quantity(
        "creep_limit_capacity", "r_a", "number", "Capacity at the creep limit",
        "Maximum ratio of tight-side to slack-side tension at which the exit creep stays "
        "within the creep limit.",
    ),
    Quantity(
        "creep_limit_margin", "", "number", "Margin to the creep limit",
        "Capacity at the creep limit over the actual ratio of tight-side to slack-side "
        "tension.",
    ),
    Quantity(
        "equivalent_friction", "mu_eq", "number", "Equivalent friction",
        "Constant friction with the capacity at the creep limit, ln(capacity)/phi; "
        "compare it with CEMA and DIN values.",
    ),
    Quantity(
        "least_exit_tension", "T2_creep", "force", "Slack-side tension for the creep limit",
        "Minimum slack-side tension (exit side when driving, entry side when braking) that "
        "transmits the same effective tension within the creep limit.",
    ),
    Quantity(
        "largest_effective_tension", "Te_max", "force", "Maximum effective tension",
        "Maximum effective tension within the creep limit with the tight-side wrap pressure in "
        "the tested "
        "range.",
    ),
    Quantity(
        "tested_slip_capacity", "r_b", "number", "Capacity at the edge of tested slip",
        "Maximum tension ratio at which no slip exceeds the maximum slip tested.",
    ),
    Quantity(
        "tested_slip_margin", "", "number", "Margin to the edge of tested slip",
        "Capacity at the edge of tested slip over the actual ratio.",
    ),
    Quantity(
        "gross_slip_capacity", "r_c", "number", "Capacity at gross slip",
        "Tension ratio at which the friction of the whole wrap is exhausted; an extrapolation, "
        "often far outside any tested slip.",
    ),
    Quantity(
        "extrapolated_gross_slip_margin", "", "number", "Margin to gross slip, extrapolated",
        "Capacity at gross slip over the actual ratio: by the law alone, outside its tests, at "
        "constant tight-side tension; no safety factor.",
    ),
    Quantity(
        "gross_slip_safety", "", "number", "Safety against gross slip",
        "Effective tension at gross slip over the effective tension, as the take-up lets the "
        "tensions grow; the belt slips at a creep of 63.5 mm, at the end of the tested slip or "
        "where all friction is used "
        "up, whichever comes first.",
    ),
    Quantity(
        "gross_slip_creep", "", "length", "Creep at gross slip",
        "Creep at the exit at the capacity at gross slip; infinite for a law that is flat past "
        "its peak.",
    ),
    # power, energy and wear
    Quantity(
        "transmitted_power", "P", "power", "Power to the belt",
        "Effective tension times the speed of the lagging surface at the entry.",
    ),
    Quantity(
        "sliding_power", "P_x", "power", "Sliding power",
        "Heat of the belt sliding on the lagging, v_s B int tau dx.",
    ),
    Quantity(
        "shear_loss", "P_h", "power", "Released shear energy",
        "Shear energy of the lagging released at the exit less that taken in at the entry, "
        "v_s B (h/2G) (tau_exit^2 - tau_entry^2).",
    ),
    Quantity(
        "power_loss", "P_v", "power", "Power lost to creep",
        "Sliding power plus released shear energy.",
    ),
    Quantity(
        "efficiency", "eta", "number", "Efficiency",
        "Driving: power to the belt over power at the surface; braking: power at the surface "
        "over power from the belt.",
    ),
    Quantity(
        "frictional_energy", "e", "energy_per_area", "Frictional energy per pass",
        "Energy of friction per area of lagging and passage under the belt, int tau dx.",
    ),
    Quantity(
        "identity_error", "", "number", "Energy balance error",
        "Relative miss of the loss against its exact value (T1 - T2) [g + (T1 - T2)/(2 EA')], a "
        "check of the solution.",
    ),
    Quantity(
        "wear_rate", "w", "length", "Wear per million passes",
        "Depth worn off the lagging in a million passages under the belt.",
    ),
    # several drives on one belt
    Quantity(
        "share", "f", "number", "Share of the load",
        "Part of the total effective tension that a drive transmits; negative when it brakes.",
    ),
    Quantity(
        "run", "dT", "force", "Rise of tension before it",
        "Rise of belt tension over the run from the pulley before, by the resistance of that run.",
    ),
    Quantity(
        "speed_ratio", "v/v1", "number", "Surface speed to the first",
        "Speed of the loaded lagging surface at the entry nip over that of the first drive, (1 + "
        "T/EA)(1 - g1) / ((1 + T1/EA)(1 - g)).",
    ),
    Quantity(
        "contraction_term", "-(T1 - T)/EA", "number", "Speed by belt contraction",
        "First-order part of the speed ratio because the belt is shorter where its tension is "
        "lower than at the first drive.",
    ),
    Quantity(
        "creep_term", "g - g1", "number", "Speed by extra creep",
        "First-order part of the speed ratio because this drive creeps more than the first.",
    ),
    Quantity(
        "compression_term", "d/R - d1/R1", "number", "Speed by lagging compression",
        "First-order part of the ratio of pulley speeds because a lagging that is compressed "
        "less makes a larger pulley.",
    ),
    Quantity(
        "thickness_term", "(1+e_b1/R1)/(1+e_b/R)-1", "number", "Speed by belt thickness",
        "Part of the ratio of pulley speeds because the tension member runs outside the "
        "lagging surface, farther on a smaller pulley and on a thicker cover.",
    ),
    Quantity(
        "drum_ratio", "omega R/(omega1 R1)", "number", "Pulley speed to the first",
        "Ratio of the pulley speeds at equal diameter: that of the surface speeds, the "
        "compression of the laggings and the thickness of the belt.",
    ),
    Quantity(
        "surface_speed", "v_s", "speed", "Surface speed",
        "Speed of the loaded pulley at the entry nip, at the radius of the tension member.",
    ),
    Quantity(
        "rotation_speed", "omega", "rotation_speed", "Pulley speed",
        "Rotation speed of the pulley, surface speed over the radius of the tension "
        "member, R - delta + e.",
    ),
    Quantity(
        "speed_trim", "trim", "number", "Speed trim",
        "Pulley speed times nominal diameter over that of the first drive: the ratio that a speed "
        "control is set to.",
    ),
    Quantity(
        "speed_setting", "", "number", "Speed setting",
        "Speed of a motor at any torque over that of now: its set speed, gear or pole pairs "
        "changed.",
    ),
    Quantity(
        "nominal_diameter", "D_n", "length", "Nominal diameter",
        "Diameter by which the speed of a pulley is set.",
    ),
    Quantity(
        "diameter_ratio", "D/D_n", "number", "Diameter over nominal diameter",
        "Actual over nominal diameter of a pulley, below 1 where its lagging has worn.",
    ),
    Quantity(
        "load_ratio", "", "number", "Load",
        "Total effective tension over that of the load case.",
    ),
    Quantity(
        "drum_torque", "M_d", "torque", "Torque on the pulley",
        "Power at the lagging surface over pulley speed, (T1 - T2)(R - delta).",
    ),
    Quantity(
        "drum_power", "P_d", "power", "Power of the pulley",
        "Effective tension times the speed of the lagging surface.",
    ),
    Quantity(
        "motor_load", "", "number", "Motor load",
        "Torque of each motor over its rated torque.",
    ),
    Quantity(
        "motor_torque", "M_m", "torque", "Motor torque",
        "Torque on the shaft of each motor.",
    ),
    Quantity(
        "motor_speed", "n_m", "rotation_speed", "Motor speed",
        "Speed of the motor; of the pump where there is a fluid coupling.",
    ),
    Quantity(
        "motor_power", "P_m", "power", "Motor power",
        "Power on the shaft of each motor.",
    ),
    Quantity(
        "gear_speed", "n_g", "rotation_speed", "Speed into the gear",
        "Speed on the motor side of the gear; of the turbine where there is a fluid coupling.",
    ),
    Quantity(
        "electrical_power", "P_el", "power", "Electrical power",
        "Power that all motors of a pulley take from the mains, negative where they return it.",
    ),
    Quantity(
        "motor_loss", "", "power", "Lost in the motors",
        "Electrical power less shaft power of all motors of a pulley.",
    ),
    Quantity(
        "coupling_loss", "", "power", "Lost in fluid couplings",
        "Torque times the slip of pump and turbine, of all fluid couplings of a pulley.",
    ),
    Quantity(
        "gear_loss", "", "power", "Lost in the gear",
        "Power into the gear less power of the pulley.",
    ),
    Quantity(
        "share_sensitivity", "df/dtrim", "number", "Share per 0.1 % of trim",
        "Change of the share of a drive when its speed is raised by 0.1 %: how exactly the drives "
        "must be matched.",
    ),
    Quantity(
        "loss_ratio", "", "number", "Loss to creep over power",
        "Power lost to creep on all pulleys over the power at their surfaces.",
    ),
    # across the width
    Quantity(
        "across_position", "y", "length", "Position across the belt",
        "Distance from the middle of the belt, towards its right edge seen in the direction of "
        "travel.",
    ),
    Quantity(
        "width_tension", "t", "force_per_width", "Tension per unit width",
        "Belt tension of a strip over its width.",
    ),
    Quantity(
        "largest_running_tension", "t_max", "force_per_width", "Maximum tension, running",
        "Tension per unit width where the belt is tightest, in the wrap or the span before it; at "
        "an edge extrapolated linearly from the two outer strips.",
    ),
    Quantity(
        "tightest_strip_tension", "t_strip", "force_per_width", "Tightest strip, running",
        "Tension per unit width of the tightest strip, the mean over its width.",
    ),
    Quantity(
        "largest_static_tension", "t_stat", "force_per_width", "Maximum tension at standstill",
        "Tension per unit width where the belt is tightest as long as it does not creep; at an "
        "edge extrapolated linearly from the two outer strips.",
    ),
    Quantity(
        "least_tension", "t_min", "force_per_width", "Minimum tension",
        "Tension per unit width of the slackest strip in the wrap.",
    ),
    Quantity(
        "largest_pressure", "p_max", "pressure", "Maximum wrap pressure across the width",
        "Wrap pressure under the tightest strip.",
    ),
    Quantity(
        "largest_creep", "", "length", "Maximum creep across the width",
        "Creep at the exit of the strip that creeps most.",
    ),
    Quantity(
        "entry_unevenness", "", "number", "Entry tension, maximum over mean",
        "Tension per unit width of the tightest strip at the entry over the mean.",
    ),
    Quantity(
        "exit_unevenness", "", "number", "Exit tension, maximum over mean",
        "Tension per unit width of the tightest strip at the exit over the mean.",
    ),
    Quantity(
        "energy_unevenness", "", "number", "Wear, maximum over mean",
        "Frictional energy per area of the strip that has most of it, over the mean.",
    ),
    Quantity(
        "levelling_depth", "w_n", "length", "Levelling depth",
        "Mean wear over which an uneven mode of the lagging falls by 2.72; negative where it "
        "grows.",
    ),
    Quantity(
        "in_plane_shear_stiffness", "S", "force_per_width", "In-plane shear stiffness of the belt",
        "Shear force per width over shear strain in the plane of the belt.",
    ),
    Quantity(
        "yaw_moment", "", "torque", "Yaw moment",
        "Moment of the entry tension about the middle of the belt.",
    ),
    Quantity(
        "entry_guide_force", "", "force", "Guide force before the pulley",
        "Sideways force of the belt that idlers before the pulley must take.",
    ),
    Quantity(
        "exit_guide_force", "", "force", "Guide force behind the pulley",
        "Sideways force of the belt that idlers behind the pulley must take.",
    ),
    Quantity(
        "drum_number", "Gamma", "number", "Pulley number",
        "How much slower than the pulley surface the belt would run unstretched, one number for "
        "all strips.",
    ),
)  # fmt: skip

#: Every quantity by name.
GLOSSARY: Mapping[str, Quantity] = MappingProxyType({q.name: q for q in QUANTITIES})
