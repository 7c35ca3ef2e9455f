def sub(p, *pairs):
    s=open(p).read()
    for a,b in pairs:
        assert a in s, (p,a)
        s=s.replace(a,b,1)
    open(p,'w').write(s)
sub('src/wraparc/choose/search.py',('''from collections.abc import Mapping
''','''from collections.abc import Callable, Mapping
'''),('''from wraparc.batch.arcs import Arcs''','''from wraparc.arc.wrap_arc import of_belt
from wraparc.batch.arcs import Arcs'''),('''from wraparc.errors import InputError, Problem
''','''from wraparc.errors import InputError, Problem
from wraparc.friction import FrictionLaw
'''))
sub('src/wraparc/glossary.py',('''    Quantity(
        "drum_ratio",''','''    Quantity(
        "thickness_term", "e1/R1 - e/R", "number", "Speed by belt thickness",
        "First-order part of the ratio of drum speeds because the tension member runs outside the "
        "lagging surface, farther on a smaller drum and on a thicker cover.",
    ),
    Quantity(
        "drum_ratio",'''),('''that of the surface speeds, and the "
        "compression of the laggings.",''','''that of the surface speeds, the "
        "compression of the laggings and the thickness of the belt.",'''),
('''        "Speed of the loaded lagging surface at the entry nip.",''','''        "Speed of the loaded drum at the entry nip, at the radius of the tension member.",'''),
('''surface speed over radius less compression.",''','''surface speed over the radius of the tension "
        "member, R - delta + e.",'''),
('''    Quantity(
        "lagging_thickness",''','''    Quantity(
        "pulley_cover", "t_p", "length", "Pulley cover",
        "Thickness of the belt cover on the side of the pulleys.",
    ),
    Quantity(
        "carry_cover", "t_c", "length", "Carry cover",
        "Thickness of the belt cover that carries the load.",
    ),
    Quantity(
        "carcass", "t_k", "length", "Carcass",
        "Thickness of the carcass, or diameter of the cords.",
    ),
    Quantity(
        "belt_thickness", "t", "length", "Belt thickness",
        "Covers and carcass in all.",
    ),
    Quantity(
        "cover_shear_modulus", "G_b", "pressure", "Shear modulus of the covers",
        "Shear stress for unit tangent of the shear angle of a belt cover.",
    ),
    Quantity(
        "belt_mass", "m", "mass_per_length", "Belt mass",
        "Mass of a metre of belt; m v^2 of the tension presses on no pulley.",
    ),
    Quantity(
        "pitch_offset", "e", "length", "Offset of the tension member",
        "Height of the tension member over the lagging surface: the cover that meets the pulley "
        "and half of the carcass.",
    ),
    Quantity(
        "centrifugal_force", "m v^2", "force", "Centrifugal force",
        "Part of the belt tension that presses on no pulley.",
    ),
    Quantity(
        "lagging_thickness",'''))
