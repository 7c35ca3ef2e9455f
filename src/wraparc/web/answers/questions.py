"""What is asked beside the answer: before and after changes, and what to expect on site."""

from wraparc.answer.field_sheet import field_sheet
from wraparc.answer.what_if_sheet import what_if_sheet
from wraparc.answer.words import whole_verdict
from wraparc.arc import Distributed
from wraparc.calibrate.on_site import OnSite, on_site
from wraparc.choose.named_changes import Named, changes_of
from wraparc.choose.what_if import what_if
from wraparc.drive import Drive
from wraparc.errors import input_error
from wraparc.files.conditions import refuse_several
from wraparc.train.as_drive import nearest_drive
from wraparc.train.whole import by_pulley, solved
from wraparc.web.answers.documents import asked_for, read
from wraparc.web.answers.shown import Sheet, sheet
from wraparc.web.asked import OnSiteRequest, WhatIfRequest


def changed(asked: WhatIfRequest) -> Sheet:
    """A pulley before and after changes, with reasons, as `wraparc what-if` tells it."""
    thing = read(asked.document)
    drive = thing if isinstance(thing, Drive) else nearest_drive(thing)
    refuse_several(drive, "what-if changes")
    pulley, _ = asked_for(drive, asked.pulley, asked.load_case)
    named = Named(
        other_carcass=asked.other_carcass,
        belts=tuple(asked.belts),
        laggings=tuple(asked.laggings),
        thicknesses=tuple(asked.thicknesses),
        worn=tuple(asked.worn),
        wet=asked.wet,
        bare=asked.bare,
    )
    changes = list(changes_of(thing, drive, pulley.name, named, allow_paths=False))
    if not changes:
        raise input_error(message="nothing is to be changed", remedy="Name a change.")
    found = what_if(thing, pulley.name, asked.load_case, changes, method=Distributed())
    title = drive.title or "What if"
    return Sheet(**sheet(what_if_sheet(found, title)))


def expected(asked: OnSiteRequest) -> Sheet:
    """Speeds to measure, alarm levels and wear of a drive, as `wraparc field` tells them."""
    whole = solved(read(asked.document), Distributed())
    drive = by_pulley(whole).drive
    pulley, _ = asked_for(drive, asked.pulley, None)
    known = OnSite(**asked.model_dump(exclude={"document", "pulley"}))
    found, source = on_site(whole, pulley.name, known)
    told, title = whole_verdict(whole), drive.title or "Drive"
    return Sheet(**sheet(field_sheet(found, told, title, pulley.name, source)))
