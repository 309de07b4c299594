"""The parts of a request in words: what is to be reached, kept, avoided or done.

The robot speaks: what was asked of it as "never enter line 3 while the box is full" is said back as
"I keep out of line 3 while the box is full".
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from plainspoken.logic.english import say
from plainspoken.logic.formula import And, Atom, Constant, Formula, Not, Or
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    Exactly,
    FutureAvoidance,
    GlobalAvoidance,
    InstantaneousReaction,
    Maintenance,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    Remaining,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
    negated,
)
from plainspoken.logic.recognition import is_boolean, recognised, sequel
from plainspoken.questions.clause import Tense
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.morphology import a, listed, progressive, times
from plainspoken.questions.narration import facts_together
from plainspoken.world.domain import GroundAtom
from plainspoken.world.symbol import ActionSymbol, AtomSymbol, resolve


class Aim(StrEnum):
    """What a part of a request wants."""

    REACH = "reach"
    """Facts to be so at some point."""
    KEEP = "keep"
    """Facts to be so all the time."""
    AVOID = "avoid"
    """Facts never to be so."""
    DO = "do"
    """An action at some point."""
    PROMISE = "promise"
    """What `bare` says: `call the support robot as soon as the box is full`."""
    OTHER = "other"


@dataclass(frozen=True, slots=True)
class Wish:
    """One part of a request.

    atoms:  the facts to be reached, kept or avoided
    action: the symbol of the action it is about
    bare:   what I am to do, as a verb phrase; "" where the facts say it
    """

    aim: Aim
    said: Pattern | Formula
    atoms: tuple[GroundAtom, ...] = ()
    action: ActionSymbol | None = None
    bare: str = ""


def wish_of(said: Pattern | Formula, lexicon: Lexicon) -> Wish:
    """What a part of the request wants, as far as there are natural words for it."""
    match said:
        case Visit((place,)):
            facts = _facts(place, lexicon)
            if facts and not are_my_places(facts, lexicon):
                return Wish(Aim.REACH, said, facts)
            action = _action(place, lexicon)
            if action is not None:
                return Wish(Aim.DO, said, action=action, bare=action_words(action, lexicon))
            if facts:
                return Wish(Aim.REACH, said, facts)
        case Maintenance((kept,)) if facts := _facts(kept, lexicon):
            return Wish(Aim.KEEP, said, facts)
        case GlobalAvoidance((avoided,)) if facts := _options(avoided, lexicon):
            return Wish(Aim.AVOID, said, facts, bare=_keep_out(facts, lexicon))
        case _:
            pass
    try:
        bare = _Phrases(lexicon).bare(said)
    except _NoWords:
        return Wish(Aim.OTHER, said)
    return Wish(Aim.PROMISE, said, bare=bare)


def _facts(formula: Formula, lexicon: Lexicon) -> tuple[GroundAtom, ...]:
    """The atoms that a formula is a conjunction of; none where it is anything else."""
    parts = formula.operands if isinstance(formula, And) else (formula,)
    return _atoms(parts, lexicon)


def _options(formula: Formula, lexicon: Lexicon) -> tuple[GroundAtom, ...]:
    """The atoms that a formula is a disjunction of: none of them is to be."""
    parts = formula.operands if isinstance(formula, Or) else (formula,)
    return _atoms(parts, lexicon)


def _atoms(parts: Sequence[Formula], lexicon: Lexicon) -> tuple[GroundAtom, ...]:
    symbols = [resolve(p.name, lexicon.problem) for p in parts if isinstance(p, Atom)]
    facts = tuple(symbol.atom for symbol in symbols if isinstance(symbol, AtomSymbol))
    return facts if len(facts) == len(parts) else ()


def _action(formula: Formula, lexicon: Lexicon) -> ActionSymbol | None:
    if isinstance(formula, Atom):
        symbol = resolve(formula.name, lexicon.problem)
        return symbol if isinstance(symbol, ActionSymbol) else None
    return None


def are_my_places(facts: Sequence[GroundAtom], lexicon: Lexicon) -> bool:
    """Whether facts say where the robot that speaks is, all of them."""
    return bool(facts) and all(
        lexicon.clause(atom).subject == "I" and lexicon.place_clause(atom) for atom in facts
    )


def _keep_out(facts: Sequence[GroundAtom], lexicon: Lexicon) -> str:
    """`keep out of line 3`, where the facts are all about where the robot is."""
    if not are_my_places(facts, lexicon):
        return ""
    return f"keep out of {listed([lexicon.object_words(atom.split()[-1]) for atom in facts])}"


_SEE = "see to it that"


class _NoWords(Exception):
    """There are no natural words for a formula."""


class _Phrases:
    """Patterns as verb phrases behind `I`."""

    def __init__(self, lexicon: Lexicon) -> None:
        self._lexicon = lexicon

    def bare(self, said: Pattern | Formula) -> str:
        """`go to line 1, then call the support robot`."""
        match said:
            case Visit(places):
                return listed([self.do(place) for place in places])
            case SequencedVisit(places):
                return self._then(places)
            case OrderedVisit(places) | StrictOrderedVisit(places):
                return f"{self._then(places)}, in this order"
            case Patrolling(places):
                return f"{listed([self.do(place) for place in places])} again and again"
            case Maintenance(kept):
                return f"see to it that {listed([self.that(each) for each in kept])} all the time"
            case Remaining(kept):
                return f"see to it that {listed([self.that(e) for e in kept])} for good in the end"
            case GlobalAvoidance(avoided):
                return listed([self.avoid(each) for each in avoided])
            case AtLeast(place, number):
                return f"{self.do(place)} at least {times(number)}"
            case AtMost(place, number):
                return f"{self.do(place)} {times(number)} at most"
            case Exactly(place, number):
                return f"{self.do(place)} exactly {times(number)}"
            case Or(options) if not is_boolean(said):
                return "either " + listed([self._option(each) for each in options], "or")
            case PastAvoidance() | FutureAvoidance() | Wait() | InstantaneousReaction():
                return self._within(said)
            case (
                DelayedReaction()
                | PromptReaction()
                | PromptPrecedence()
                | BoundReaction()
                | BoundDelay()
            ):
                return self._reaction(said)
            case _:
                raise _NoWords

    def _option(self, formula: Formula) -> str:
        found = recognised(formula)
        return listed([self.bare(each) for each in found])

    def _then(self, places: Sequence[Formula]) -> str:
        return ", then ".join(self.do(place) for place in places)

    def _within(self, said: PastAvoidance | FutureAvoidance | Wait | InstantaneousReaction) -> str:
        match said:
            case PastAvoidance(avoided, until):
                if action := _action(avoided, self._lexicon):
                    verb, _, rest = action_words(action, self._lexicon).partition(" ")
                    doing = f"{progressive(verb)} {rest}".strip()
                    return f"wait until {self.that(until)} before {doing}"
                return f"{self.avoid(avoided)} until {self.that(until)}"
            case FutureAvoidance(after, avoided):
                return f"{self.avoid(avoided)} once {self.that(after)}"
            case Wait(kept, until):
                return f"{self._stay(kept)} until {self.that(until)}"
            case InstantaneousReaction(trigger, Not(avoided)) if not _facts(
                avoided, self._lexicon
            ) or _keep_out(_facts(avoided, self._lexicon), self._lexicon):
                return f"{self.avoid(avoided)} while {self.that(trigger)}"
            case InstantaneousReaction(trigger, response) if self._goes(trigger):
                return f"{self.do(trigger)} only while {self.that(response)}"
            case InstantaneousReaction(trigger, response):
                return f"{self._stay(response)} whenever {self.that(trigger)}"

    def _reaction(
        self,
        said: DelayedReaction | PromptReaction | PromptPrecedence | BoundReaction | BoundDelay,
    ) -> str:
        response = self._then(sequel(said.response))
        trigger = self.that(said.trigger)
        if (fact := response.removeprefix(f"{_SEE} ")) != response:
            word = "as soon as" if isinstance(said, PromptReaction | BoundDelay) else "whenever"
            late = "sooner or later " if isinstance(said, DelayedReaction) else ""
            return f"{_SEE}, {word} {trigger}, {late}{fact}"
        match said:
            case DelayedReaction():
                return f"{response}, sooner or later, whenever {trigger}"
            case PromptReaction():
                return f"{response} as soon as {trigger}"
            case PromptPrecedence():
                return f"{response} only right after the moment when {trigger}"
            case BoundReaction():
                return f"{response} exactly while {trigger}"
            case BoundDelay():
                return f"{response} as soon as {trigger}, and at no other time"

    # -- operands ------------------------------------------------------------------------------

    def _goes(self, formula: Formula) -> bool:
        facts = _facts(formula, self._lexicon)
        return bool(are_my_places(facts, self._lexicon) or _action(formula, self._lexicon))

    def do(self, formula: Formula) -> str:
        """`go to line 1`, `call the support robot`, `see to it that line 1 is cleared`."""
        if action := _action(formula, self._lexicon):
            return action_words(action, self._lexicon)
        facts = _facts(formula, self._lexicon)
        if len(facts) == 1 and are_my_places(facts, self._lexicon):
            return f"go to {self._lexicon.object_words(facts[0].split()[-1])}"
        if isinstance(formula, Not) and (bare := self._negated(formula.operand)):
            return bare
        return f"{_SEE} {self.that(formula)}"

    def _negated(self, operand: Formula) -> str:
        return self.avoid(operand) if self._goes(operand) else ""

    def _stay(self, formula: Formula) -> str:
        facts = _facts(formula, self._lexicon)
        if len(facts) == 1 and are_my_places(facts, self._lexicon):
            return f"stay {self._lexicon.clause(facts[0]).complement}"
        return self.do(formula)

    def avoid(self, formula: Formula) -> str:
        """`keep out of line 3`, `never call the support robot`."""
        facts = _options(formula, self._lexicon)
        if facts and (bare := _keep_out(facts, self._lexicon)):
            return bare
        if action := _action(formula, self._lexicon):
            return f"never {action_words(action, self._lexicon)}"
        return f"never let it be that {self.that(formula)}"

    def that(self, formula: Formula, tense: Tense = "now") -> str:
        """`the box is full`, `I'm at line 1`, `I call the support robot`."""
        match formula:
            case Atom(name) | Not(Atom(name)):
                negative = isinstance(formula, Not)
                symbol = resolve(name, self._lexicon.problem)
                if isinstance(symbol, AtomSymbol):
                    return self._lexicon.clause(symbol.atom).said(tense, negative=negative)
                words = action_words(symbol, self._lexicon)
                return f"I {'do not ' if negative else ''}{words}"
            case And(operands):
                return listed([self.that(each, tense) for each in operands])
            case Or(operands) if all(isinstance(each, Atom | Not) for each in operands):
                return listed([self.that(each, tense) for each in operands], "or")
            case Constant() | _:
                raise _NoWords


def action_words(symbol: ActionSymbol, lexicon: Lexicon) -> str:
    """The words for any action that a symbol means: `wash a mug`, `check mug 1`."""
    given = list(symbol.arguments)
    if not given and (one := lexicon.landmarks.get(symbol.id)) is not None:
        return one.description.removeprefix("to ")
    template = lexicon.template(symbol.action)
    schema = lexicon.problem.action(symbol.action)[0]
    words = [template.verb]
    for part in template.parts:
        if isinstance(part, str):
            words.append(part)
            continue
        parameter = schema.parameters[part]
        fitting = lexicon.problem.objects_for(parameter)
        fits = [name for name in given if name in fitting]
        if fits:
            words.append(lexicon.object_words(fits[0]))
        elif len(fitting) == 1:
            words.append(lexicon.object_words(fitting[0]))
        else:
            words.append(a(" ".join(parameter.types[0].split("-"))))
    return " ".join(words)


def wanted(wish: Wish, lexicon: Lexicon) -> str:
    """The wish after `you want`: `line 1 to be cleared`, `me to keep out of line 3`."""
    if wish.bare:
        verb = wish.bare
        return (
            f"me {verb.replace('never ', 'never to ', 1) if verb[:6] == 'never ' else 'to ' + verb}"
        )
    facts = listed([_infinitive(lexicon, atom) for atom in wish.atoms])
    merged = facts_together(lexicon, wish.atoms)
    if len(wish.atoms) > 1 and len(merged) == 1 and " are " in merged[0].text:
        clause = lexicon.clause(wish.atoms[0])
        subject = merged[0].text.split(" are ")[0]
        facts = f"{subject} to {clause.verb} {clause.complement}"
    match wish.aim:
        case Aim.REACH:
            return facts
        case Aim.KEEP:
            return f"{facts} all the time"
        case Aim.AVOID:
            return facts.replace(" to ", " never to ")
        case _:
            return f"this: {plain(wish.said, lexicon)}"


def desired(wish: Wish, lexicon: Lexicon) -> str:
    """The wish after `you want`, at its shortest: `line 1 cleared`, `me to keep out of line 3`."""
    words = wanted(wish, lexicon)
    return words.replace(" to be ", " ") if wish.aim is Aim.REACH and not wish.bare else words


def _infinitive(lexicon: Lexicon, atom: GroundAtom) -> str:
    clause = lexicon.clause(atom)
    subject = "me" if clause.subject == "I" else clause.subject
    return f"{subject} to {clause.verb} {clause.complement}".strip()


def outcome_words(wish: Wish, lexicon: Lexicon, *, reached: bool) -> str:
    """A state of things asked for, as reached or as still missing: `the box wasn't full`."""
    if not isinstance(wish.said, Visit):
        return ""
    phrases = _Phrases(lexicon)
    try:
        said = [
            phrases.that(place, "was") if reached else phrases.that(negated(place))
            for place in wish.said.places
        ]
    except _NoWords:
        return ""
    return f"{listed(said)} at some point" if reached else listed(said, "or")


def standing(wish: Wish, lexicon: Lexicon) -> str:
    """The wish as what I do: `I keep out of line 3`, `the box is never full`."""
    if wish.bare:
        return f"I {wish.bare}"
    match wish.aim:
        case Aim.AVOID:
            return listed([lexicon.clause(atom).said(negative=True) for atom in wish.atoms])
        case Aim.KEEP:
            return f"{listed([lexicon.clause(atom).said() for atom in wish.atoms])} all the time"
        case _:
            return plain(wish.said, lexicon)


def plain(said: Pattern | Formula, lexicon: Lexicon) -> str:
    """A part that has no words of its own, in the formula's English, quoted as one sentence."""
    formula = said.executable if isinstance(said, Pattern) else said
    text = say(formula, lexicon.landmarks).strip().rstrip(".").replace(". ", ", and ")
    text = text.replace("there is a next step, and in it ", "in the next step ")
    text = text.replace("if there is a next step, in it ", "in any next step ")
    return f"“{text.replace('(', '').replace(')', '')}”"
