"""Words of general English that stand near a word: opposites, near synonyms, nouns of a verb.

No word of any domain stands here: a domain brings its own names. A near synonym is worth less
than the word itself, so where both are names of a domain they are never mixed up.
"""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from functools import cache

from plainspoken.language.word import is_known

_ANTONYMS = """full empty; open closed; open shut; locked unlocked; ripe unripe; on off;
    clean dirty; busy free; busy idle; hot cold; wet dry; occupied free; occupied vacant;
    present absent; awake asleep; visible hidden; available unavailable; lit dark; known unknown;
    alive dead; intact broken; safe dangerous; safe unsafe; enabled disabled; active inactive;
    full drained; charged drained; charged flat; loaded unloaded; blocked clear; blocked free;
    tidy untidy; tidy messy; finished unfinished; ready unready; clear cluttered; high low;
    occupied unoccupied; covered uncovered; connected disconnected; plugged unplugged;
    certain doubtful; certain uncertain; damaged intact; damaged undamaged; readable unreadable"""
_ALIKE = """full fill; full filled; full topped; empty emptied; call summon; call fetch; call ring;
    call page; call phone; call contact; drop place; drop put; drop deposit;
    put place; pick grab; pick collect; get fetch; get collect; human person;
    human worker; human someone; robot machine; start begin; finish complete; clean tidy;
    clean wash; repair fix; mend fix; ask query; ask consult; ask bother; ask question;
    closed shut; close shut; big large; small little; bring deliver; deliver carry; carry bring;
    trash rubbish; trash garbage; photo picture; photograph picture; support help; help assist;
    support helper; support assist; support assistance; helper robot; hand gripper; load fill;
    see spot; notify alert; notify warn; alert warn; tell inform; notify tell; notify inform;
    reset restart; hold carry; stock store; dock charge; refill fill; buy purchase;
    send dispatch; release free; seal close; look inspect; throw discard; activate enable;
    activate start; deactivate disable; unload empty; charge recharge; turn switch; open unlatch;
    stuck jammed; jammed wedged; damaged broken; damaged harmed; store stash; low flat;
    lift raise; lower bring; cut chop; stir mix; wipe clean; rinse wash; season salt; cook boil;
    hold grip; hold grasp; carried held; taste try; water irrigate; fold crease;
    sterile sterilized; sterilize disinfect; move drive; sick ill; unknown undetermined;
    unknown unclear; doubtful uncertain; readable legible; unreadable illegible; present there;
    here there; here arrived"""
_ALIKE_IN_CLASSES = """check inspect examine verify test;
    pick gather; remove withdraw; dirty soiled filthy grubby; wet damp soaked slippery;
    broken faulty defective; busy engaged; finished done complete; ready prepared"""
_NOUN_ENDINGS = ("al", "ance", "ence", "ment", "ation", "ion", "tion", "y", "ery", "ure", "age")
"""What makes the noun of an act from its verb; "-er" makes the one who acts."""


def _pairs(text: str) -> dict[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for entry in text.split(";"):
        members = entry.split()
        for one in members:
            found[one] = found.get(one, frozenset()) | (frozenset(members) - {one})
    return found


_OPPOSITE = _pairs(_ANTONYMS)
_NEAR = _pairs(f"{_ALIKE};{_ALIKE_IN_CLASSES}")


def alike(stems: AbstractSet[str]) -> frozenset[str]:
    """Words that mean nearly the same as a word, and the nouns made from them."""
    near = {other for stem in stems for other in _NEAR.get(stem, ())}
    nouns = {noun for word in near for noun in nouns_of(word)}
    return frozenset((near | nouns) - set(stems))


def nouns(stems: AbstractSet[str]) -> frozenset[str]:
    """The nouns made from a word: "removal" of "removed"."""
    return frozenset(noun for stem in stems for noun in nouns_of(stem)) - set(stems)


def opposites(stems: AbstractSet[str]) -> frozenset[str]:
    """Words that say that what a word says is not so."""
    found: set[str] = set()
    for stem in stems:
        found |= _OPPOSITE.get(stem, frozenset())
        found |= {"un" + stem} if not stem.startswith("un") else {stem[2:]}
    return frozenset(found)


@cache
def nouns_of(verb: str) -> frozenset[str]:
    """The nouns of doing what a verb says: "inspect" has "inspection"."""
    if len(verb) < 4 or not verb.isascii() or not verb.isalpha() or not is_known(verb):
        return frozenset()
    heads = {verb, verb[:-1]} if verb[-1] in "ey" else {verb}
    made = {head + ending for head in heads for ending in _NOUN_ENDINGS}
    if verb.endswith("ify"):
        made.add(verb[:-1] + "ication")
    return frozenset(noun for noun in made - {verb} if is_known(noun))


def verbs_of(noun: str) -> frozenset[str]:
    """The verbs that a noun is made from: "announcement" has "announce"."""
    heads = {noun.removesuffix(ending) for ending in _NOUN_ENDINGS if noun.endswith(ending)}
    verbs = {head + end for head in heads - {noun} for end in ("", "e", "y")}
    return frozenset(verb for verb in verbs if noun in nouns_of(verb))
