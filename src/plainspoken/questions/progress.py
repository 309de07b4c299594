"""How far the request is: each part done, open, kept so far or lost, and what is left to do."""

from __future__ import annotations

import re

from plainspoken.automata.verdict import Part, Verdict
from plainspoken.questions.claim import Draft
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.morphology import counted, listed
from plainspoken.questions.narration import facts_together
from plainspoken.questions.present import tell_end
from plainspoken.questions.question import Question
from plainspoken.questions.wish import Aim, Wish, standing, wanted, wish_of
from plainspoken.world.domain import GroundAtom


def tell_progress(draft: Draft, question: Question) -> None:
    """Answer how far the request is."""
    moment = draft.moment
    draft.evidence.update({moment.steps[0], moment.steps[-1]})
    if moment.ended is not None:
        tell_end(draft)
    elif question.yes_no:
        draft.say(_yes_or_no(draft, question))
    if re.search(r"\b(?:i|goal|mission|objective|request|aim)\b", question.text.lower()):
        wishes = [wish_of(part.formula, moment.lexicon) for part in moment.parts]
        reach = [atom for wish in wishes if wish.aim is Aim.REACH for atom in wish.atoms]
        said = [wanted(Wish(Aim.REACH, moment.parts[0].formula, tuple(reach)), moment.lexicon)]
        said += [wanted(wish, moment.lexicon) for wish in wishes if wish.aim is not Aim.REACH]
        draft.say(f"You want {listed([each for each in said if each])}")
    _tell_parts(draft)
    if moment.ended is None:
        _tell_left(draft)


def _yes_or_no(draft: Draft, question: Question) -> str:
    """`Not yet`, or whether all is on its way."""
    moment = draft.moment
    if re.search(
        r"\b(?:done|finish\w*|ready|complete\w*|over|there|achieved)\b", question.text.lower()
    ):
        return "Not yet"
    if any(part.verdict is Verdict.VIOLATED for part in moment.parts):
        return "No"
    if moment.node is None or moment.policy is None:
        return "I can't say at the moment"
    draft.node(moment.node.id)
    return "Yes, my plan gets there whatever happens"


def _tell_parts(draft: Draft) -> None:
    moment = draft.moment
    lexicon = moment.lexicon
    reached: list[GroundAtom] = []
    once: list[GroundAtom] = []
    missing: list[GroundAtom] = []
    others: dict[str, list[str]] = {"done": [], "open": [], "kept": [], "lost": []}
    for part in moment.parts:
        wish = wish_of(part.formula, lexicon)
        if wish.aim is Aim.REACH:
            for atom in wish.atoms:
                if atom in moment.state:
                    reached.append(atom)
                elif part.verdict is Verdict.SATISFIED:
                    once.append(atom)
                else:
                    missing.append(atom)
        else:
            others[_standing(part)].append(standing(wish, lexicon))
    draft.now([*reached, *missing])
    for atom in once:
        runs = moment.runs.get(atom)
        if runs:
            draft.was(atom, runs[-1][0])
    done = [s.text for s in facts_together(lexicon, reached)]
    done += [s.text for s in facts_together(lexicon, once, "was")] + others["done"]
    still = [s.text for s in facts_together(lexicon, missing, negative=True)] + others["open"]
    if done:
        draft.say(f"Done: {listed(done)}")
    if still:
        opening = "Still open" if done else "Nothing is done yet"
        draft.say(f"{opening}: {listed(still)}")
    if others["kept"]:
        draft.say(f"Kept so far: {listed(others['kept'])}")
    if others["lost"]:
        draft.say(f"Broken, and not to be mended: {listed(others['lost'])}")


def _standing(part: Part) -> str:
    return {
        Verdict.SATISFIED: "done",
        Verdict.OPEN: "open",
        Verdict.HOLDS_SO_FAR: "kept",
        Verdict.VIOLATED: "lost",
    }[part.verdict]


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
        return
    draft.say(f"That takes {remaining_words(ahead, draft)}")


def tell_constraint(draft: Draft, question: Question) -> None:
    """Answer whether what is to be kept or avoided has been."""
    moment = draft.moment
    lexicon = moment.lexicon
    draft.evidence.update({moment.steps[0], moment.steps[-1]})
    kept: list[str] = []
    lost: list[str] = []
    asked = set(question.referents.objects)
    about_asked = False
    for part in moment.parts:
        if part.verdict is Verdict.OPEN:
            continue
        wish = wish_of(part.formula, lexicon)
        if wish.aim in (Aim.REACH, Aim.DO):
            continue
        about = asked & {word for atom in wish.atoms for word in atom.split()[1:]}
        about |= asked & set(wish.action.arguments if wish.action else ())
        if asked and wish.aim is not Aim.OTHER and not about:
            continue
        about_asked = about_asked or bool(about)
        draft.now(wish.atoms)
        (lost if part.verdict is Verdict.VIOLATED else kept).append(standing(wish, lexicon))
    if asked and not about_asked:
        draft.known = False
        draft.say("You asked for nothing about that, as far as I know")
    elif lost:
        draft.say(f"No: this has been broken: {listed(lost)}")
    elif kept:
        plan = "" if moment.policy is None else ", and my plan does so whatever happens"
        draft.say(
            f"{'Yes. ' if question.yes_no else ''}I've kept to this so far{plan}: {listed(kept)}"
        )
        if moment.chosen:
            draft.evidence.add(moment.chosen_step)
    else:
        draft.known = False
        draft.say("You gave me nothing to keep to or to avoid")
