"""What the name of a load case says of its kind, in six languages."""

from __future__ import annotations

#: Words of a name that say that the belt starts or stops, by the kind of such a load case:
#: English, German, Spanish, French, Portuguese, Italian; without accents.
_SAYS = {
    "starting": (
        "start", "starts", "starting", "startup", "restart", "restarting", "acceleration",
        "accelerating", "anlauf", "anfahren", "anfahrt", "hochlauf", "beschleunigung", "arranque",
        "aceleracion", "demarrage", "partida", "aceleracao", "avviamento", "avvio",
        "accelerazione",
    ),
    "braking": (
        "stop", "stops", "stopping", "estop", "brake", "brakes", "braking", "deceleration",
        "decelerating", "bremsen", "bremsung", "notaus", "nothalt", "verzogerung", "frenado",
        "parada", "desaceleracion", "freinage", "arret", "frenagem", "desaceleracao", "frenata",
        "frenatura", "arresto",
    ),
}  # fmt: skip
#: Words with which it runs nevertheless: held back all the time, before or after, or not at all.
_RUNS = (
    "running", "runs", "steady", "continuous", "downhill", "regenerative", "regenerating",
    "generating", "after", "before", "between", "no", "non", "not", "without", "released", "off",
    "betrieb", "nach", "vor", "ohne", "sin", "despues", "sans", "apres", "sem", "depois", "senza",
    "dopo",
)  # fmt: skip
_LETTERS = "abcdefghijklmnopqrstuvwxyz"
_ACCENTS = str.maketrans("äáàâãåéèêëíìîïöóòôõúùûüçñ", "aaaaaaeeeeiiiiooooouuuucn")


def named_kinds(name: str) -> list[str]:
    """Return the kinds that the name of a load case says: none, one, or both where in doubt.

    Whole words count, of letters alone: ``start_full``, ``E-stop 2``, but no ``standstill``.
    """
    plain = name.lower().translate(_ACCENTS)
    plain = " ".join("".join([c if c in _LETTERS else " " for c in plain]).split())
    words = plain.replace("not aus", "notaus").replace("not halt", "nothalt").split()
    if any(word in _RUNS for word in words):
        return []
    return [kind for kind, says in _SAYS.items() if any(word in says for word in words)]
