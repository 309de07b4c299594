"""How far the request is: each part done, open, kept so far or lost, and what is left to do."""

from __future__ import annotations

import re
from collections.abc import Sequence

from plainspoken.automata.verdict import Verdict
from plainspoken.logic.formula import atoms
from plainspoken.logic.pattern import Visit
from plainspoken.questions.breach import tell_breach, tell_hopeless
from plainspoken.questions.claim import Draft
from plainspoken.questions.clause import enumerated
from plainspoken.questions.demand import Demand
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import counted, listed, participle
from plainspoken.questions.narration import facts_together
from plainspoken.questions.present import tell_end
from plainspoken.questions.question import Question
from plainspoken.questions.wish import (
    Aim,
    Wish,
    are_my_places,
    outcome_words,
    standing,
    wanted,
    wish_of,
)
from plainspoken.world.domain import GroundAtom
from plainspoken.world.symbol import AtomSymbol

_OF_TIME = re.compile(
    r"\b(?:how (?:much )?long(?:er)?|how much (?:more|is left)|how many|when|take|much left)\b"
)
"""Questions that want to know how much is left, and no more."""


def tell_progress(draft: Draft, question: Question) -> None:
    """Answer how far the request is."""
    moment = draft.moment
    draft.evidence.update({moment.steps[0], moment.steps[-1]})
    if moment.ended is not None:
        tell_end(draft)
        if question.yes_no:
            first = draft.sentences[0]
            draft.sentences[0] = f"{'Yes' if moment.ended.satisfied else 'No'}, {first}"
    elif question.yes_no and not _OF_TIME.search(question.text.lower()):
        draft.say(_yes_or_no(draft, question))
    if re.search(r"\b(?:i|goal|mission|objective|request|aim)\b", question.text.lower()):
        wishes = [wish_of(demand.said, moment.lexicon) for demand in moment.demands]
        reach = [atom for wish in wishes if wish.aim is Aim.REACH for atom in wish.atoms]
        said = [wanted(Wish(Aim.REACH, moment.demands[0].said, tuple(reach)), moment.lexicon)]
        said += [wanted(wish, moment.lexicon) for wish in wishes if wish.aim is not Aim.REACH]
        want = "You want" if moment.ended is None else "You wanted"
        draft.say(f"{want} {_series([each for each in said if each])}")
        _tell_parts(draft, promises=False)
        return
    if moment.ended is None and _OF_TIME.search(question.text.lower()):
        _tell_left(draft)
        return
    _tell_parts(draft, promises=not question.yes_no or moment.ended is not None)
    if moment.ended is None:
        _tell_left(draft)


def _yes_or_no(draft: Draft, question: Question) -> str:
    """`Not yet`, or whether all is on its way."""
    moment = draft.moment
    if re.search(
        r"\b(?:done|finish\w*|ready|complete\w*|over|there|achieved)\b", question.text.lower()
    ):
        return "Not yet"
    if any(demand.verdict is Verdict.VIOLATED for demand in moment.demands):
        return "No"
    if moment.node is None or moment.policy is None:
        return "I can't say at the moment"
    draft.node(moment.node.id)
    return "Yes, my plan gets there whatever happens"


def _tell_parts(draft: Draft, *, promises: bool = True) -> None:
    """Each part as done, open, kept or lost; `promises`: also those that are kept so far."""
    moment = draft.moment
    lexicon = moment.lexicon
    groups: dict[Verdict, list[str]] = {verdict: [] for verdict in Verdict}
    reached: list[GroundAtom] = []
    once: list[GroundAtom] = []
    missing: list[GroundAtom] = []
    for demand in moment.demands:
        wish = wish_of(demand.said, lexicon)
        if wish.aim is not Aim.REACH:
            groups[_standing(demand, wish)].append(_said(demand, wish, lexicon))
            continue
        for atom in wish.atoms:
            met = demand.verdict is Verdict.SATISFIED
            (reached if atom in moment.state else once if met else missing).append(atom)
    draft.now([*reached, *missing])
    for atom in once:
        runs = moment.runs.get(atom)
        if runs:
            draft.was(atom, runs[-1][0])
    done = _reached(draft, reached, once) + groups[Verdict.SATISFIED]
    still = _missing(draft, missing) + groups[Verdict.OPEN]
    if done:
        draft.say(f"Done: {listed(done)}")
    if still:
        opening = "Still open" if done else "Nothing is done yet"
        draft.say(f"{opening}: {listed(still)}")
    kept = groups[Verdict.HOLDS_SO_FAR]
    if kept and promises:
        draft.say(f"Kept {'so far' if moment.ended is None else 'to the end'}: {_series(kept)}")
    if lost := groups[Verdict.VIOLATED]:
        draft.say(f"Broken, and not to be mended: {_series(lost)}")
        tell_breach(draft, moment.demands)
    else:
        tell_hopeless(draft)


def _series(parts: Sequence[str]) -> str:
    """A list whose items may hold commas themselves."""
    if len(parts) > 1 and any("," in part for part in parts):
        return f"{'; '.join(parts[:-1])}; and {parts[-1]}"
    return listed(parts)


def _reached(draft: Draft, now: Sequence[GroundAtom], once: Sequence[GroundAtom]) -> list[str]:
    """`line 0 is cleared`, `I've been to line 2`."""
    lexicon = draft.moment.lexicon
    been = [atom for atom in (*now, *once) if are_my_places([atom], lexicon)]
    said = [s.text for s in facts_together(lexicon, [a for a in now if a not in been])]
    said += [s.text for s in facts_together(lexicon, [a for a in once if a not in been], "was")]
    return said + ([f"I've been to {_places(been, lexicon)}"] if been else [])


def _missing(draft: Draft, atoms: Sequence[GroundAtom]) -> list[str]:
    lexicon = draft.moment.lexicon
    places = [atom for atom in atoms if are_my_places([atom], lexicon)]
    facts = [atom for atom in atoms if atom not in places]
    said = [s.text for s in facts_together(lexicon, facts, negative=True)]
    return said + ([f"I haven't been to {_places(places, lexicon)} yet"] if places else [])


def _places(atoms: Sequence[GroundAtom], lexicon: Lexicon) -> str:
    return enumerated([lexicon.object_words(atom.split()[-1]) for atom in atoms])


def _standing(demand: Demand, wish: Wish) -> Verdict:
    """A promise that asks for nothing any more has been kept, and goes on being one."""
    if demand.verdict is Verdict.SATISFIED and wish.aim in (Aim.KEEP, Aim.AVOID):
        return Verdict.HOLDS_SO_FAR
    return demand.verdict


def _said(demand: Demand, wish: Wish, lexicon: Lexicon) -> str:
    """A part as what I do, or as what is done or left to do."""
    if wish.aim is Aim.DO and demand.verdict is Verdict.SATISFIED:
        verb, _, rest = wish.bare.partition(" ")
        return f"I've {participle(verb)} {rest}".strip()
    if wish.bare and demand.verdict is Verdict.OPEN and not isinstance(wish.said, Visit):
        return f"I still have to {wish.bare}"
    if wish.aim is Aim.DO:
        return f"I still have to {wish.bare}"
    reached = demand.verdict is Verdict.SATISFIED
    return outcome_words(wish, lexicon, reached=reached) or standing(wish, lexicon)


def remaining_words(ahead: Foresight, draft: Draft) -> str:
    """`at least six more actions and at most nine`, with the reason where there is no most."""
    left = ahead.remaining
    if left.most == left.least:
        return f"{counted(left.least, 'more action')}"
    if left.most is not None:
        return f"between {left.least} and {left.most} more actions"
    words = f"at least {counted(left.least, 'more action')}"
    if left.repeated is not None:
        deed = draft.moment.lexicon.deed(left.repeated)
        words += f", and I can't say how many at most, since I may have to {deed.bare} again"
    return words


def _tell_left(draft: Draft) -> None:
    moment = draft.moment
    if moment.node is None or moment.policy is None:
        draft.say("I can't say how much is left: I'm without a plan at the moment")
        return
    ahead = Foresight(moment.policy, moment.node, moment.now)
    draft.node(moment.node.id)
    if ahead.node.action is None:
        draft.say("" if draft.sentences else "Nothing is left to do")
        return
    draft.say(f"{'That' if draft.sentences else 'It'} takes {remaining_words(ahead, draft)}")


def tell_constraint(draft: Draft, question: Question) -> bool:
    """Answer whether what is to be kept or avoided has been; False where nothing of it is asked."""
    moment = draft.moment
    lexicon = moment.lexicon
    kept: list[str] = []
    lost: list[str] = []
    asked = set(question.referents.objects)
    for demand in moment.demands:
        wish = wish_of(demand.said, lexicon)
        if demand.verdict is Verdict.OPEN or wish.aim in (Aim.REACH, Aim.DO):
            continue
        if asked and not asked & _things(demand, moment):
            continue
        draft.now(wish.atoms)
        (lost if demand.verdict is Verdict.VIOLATED else kept).append(standing(wish, lexicon))
    if asked and not kept and not lost:
        return False
    draft.evidence.update({moment.steps[0], moment.steps[-1]})
    breach = re.search(r"\b(?:br[eo]ke?n?|break|violat\w+|ignor\w+)\b", question.text.lower())
    if lost:
        yes = "Yes" if breach else "No"
        draft.say(f"{yes}, this has been broken: {_series(lost)}")
        tell_breach(draft, moment.demands)
    elif kept:
        yes = "" if not question.yes_no else "No, " if breach else "Yes, "
        it = "it" if len(kept) == 1 else "that"
        when = "so far" if moment.ended is None else "to the end"
        draft.say(f"{yes}I've kept to {it} {when}: {_series(kept)}")
        if moment.chosen and moment.ended is None:
            draft.evidence.add(moment.chosen_step)
            draft.say("My plan keeps to that whatever happens")
    else:
        draft.known = False
        draft.say("You gave me nothing to keep to or to avoid")
    return True


def _things(demand: Demand, moment: Moment) -> set[str]:
    """The objects that a part of the request speaks of."""
    formulas = [part.formula for part in demand.parts]
    ids = {name for formula in formulas for name in atoms(formula)}
    found: set[str] = set()
    for symbol in moment.letters.symbols:
        if symbol.id in ids:
            words = symbol.atom.split()[1:] if isinstance(symbol, AtomSymbol) else symbol.arguments
            found.update(words)
    return found
