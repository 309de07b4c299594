"""What somebody wants changed of a mission, in words, becomes clauses over what is left of it.

    change = wanted("skip line 3", mission, lexicon)
    change.clauses   # each with the instant that it counts from

What is left untouched keeps its instant, and so what its automaton has seen; what is new counts
from now on. Nothing that happened is rewritten.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from plainspoken.automata.verdict import Verdict
from plainspoken.language.dialogue import Dialogue
from plainspoken.language.extracted import Extraction, Status, patterns_of
from plainspoken.language.extraction import extract
from plainspoken.language.follow_up import FollowUp, Wish, follow_ups
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.refinement import added, demanded, put_first, put_last, replaced, without
from plainspoken.language.refusal import LONGEST
from plainspoken.language.sentence import reading_of
from plainspoken.logic.english import say
from plainspoken.logic.formula import Atom, Formula, conjunction
from plainspoken.logic.pattern import Pattern, Visit
from plainspoken.logic.syntax import unparse
from plainspoken.mission.mission import Mission
from plainspoken.mission.request import Clause
from plainspoken.questions.breaking_off import done_with
from plainspoken.questions.left import Left, Patterns, done_already, left_over, single
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.referent import MOTION, referents_of
from plainspoken.questions.spelling import normal
from plainspoken.world.symbol import ActionSymbol, AtomSymbol, SymbolId, flat, resolve

Translate = Callable[[str, Vocabulary], Extraction]


@dataclass(frozen=True, slots=True)
class Wanted:
    """What may be meant: the words to choose it by, what it comes to in English, the clauses."""

    answer: str
    english: str
    clauses: tuple[Clause, ...]


@dataclass(frozen=True, slots=True)
class ChangeOfMind:
    """What became of the words: one thing (ok), several to choose from (clarify), or a refusal."""

    text: str
    status: Status
    meant: Wanted | None = None
    question: str | None = None
    choices: tuple[Wanted, ...] = ()
    reason: str | None = None

    def settled_on(self, choice: Wanted) -> ChangeOfMind:
        return ChangeOfMind(self.text, Status.OK, choice)

    def to_json(self) -> dict[str, Any]:
        """What `missions change --json` prints, without what became of it."""
        clauses = self.meant.clauses if self.meant else ()
        return {
            "text": self.text,
            "status": str(self.status),
            "english": self.meant.english if self.meant else None,
            "clauses": [{"since": each.since, "goal": unparse(each.goal)} for each in clauses],
            "question": self.question,
            "choices": [{"answer": each.answer, "english": each.english} for each in self.choices],
            "reason": self.reason,
        }


_OF_THINGS = (Wish.SKIP, Wish.FIRST, Wish.LAST, Wish.ADD, Wish.REPLACE)


_STOP = re.compile(r"(?:please |ok |okay )*(?:stop|halt|quit|abort|wait|pause)(?: now| please)*")
_STOP_AFTER = re.compile(
    r"(?:please |and |then |ok |okay |just )*(?:stop|finish|end|quit|that is enough|call it a day)"
    r"(?: here| now| working| it)? (?:after|when you are (?:done|finished|through) with"
    r"|once you (?:are (?:done|finished) with|have (?:done|finished)))(?: with)? (?P<what>.+)"
)
_NO_MORE = re.compile(
    r"(?:please |and |but |ok |okay )*(?:you )?(?:do not|need not|no need to|stop)"
    r"(?: have to| need to)? (?!forget|worry|mind|bother)(?P<what>.+?)"
    r"(?: any ?more| any longer| after all)?"
)
_ANEW = re.compile(
    r"(?:please |ok |okay )*(?:forget|drop|scrap|cancel|leave|never ?mind) (?:about )?(?:that|it"
    r"|this|everything|all (?:of )?(?:that|this|it)|the (?:whole |rest|mission|plan|others?).*?)"
    r"[,;:. ]+(?:and |then |instead )*(?P<what>\w.*)",
    re.IGNORECASE,
)
_INSTEAD = re.compile(r"^(?:instead|rather)\b[\s,:]*|[\s,]*\binstead[.!]?$", re.IGNORECASE)
_ALSO = re.compile(
    r"^(?:and|also|in addition|additionally|besides|plus|then|afterwards)\b"
    r"|\b(?:too|as well)[.!]?$",
    re.IGNORECASE,
)


def wanted(
    text: str,
    mission: Mission,
    lexicon: Lexicon,
    *,
    instead: bool | None = None,
    translate: Translate = extract,
) -> ChangeOfMind:
    """Understand what somebody wants changed.

    instead: whether a whole new request takes the place of the old one, or comes beside it; None
             where the words have to say so
    """
    if not text.strip() or len(text) > LONGEST:
        reason = "Nothing is said." if not text.strip() else "That is too long."
        return ChangeOfMind(text, Status.REJECT, reason=reason)
    return _Mind(mission, lexicon, translate).heard(text, instead=instead)


class _Mind:
    """One mission's request, and what words make of it."""

    def __init__(self, mission: Mission, lexicon: Lexicon, translate: Translate) -> None:
        self._mission = mission
        self._lexicon = lexicon
        self._translate = translate
        self._vocabulary = Vocabulary.of(lexicon.landmarks)
        self._parts = tuple(left_over(mission))
        self._clauses: dict[Pattern, Clause] = {}
        for each in self._parts:
            for pattern in each.patterns:
                self._clauses.setdefault(pattern, each.clause)

    # -- what is said --------------------------------------------------------------------------

    def heard(self, text: str, *, instead: bool | None) -> ChangeOfMind:
        plain = normal(text)
        if text.rstrip().endswith("?"):
            reason = "That is a question: `plainspoken ask` answers it."
            return ChangeOfMind(text, Status.REJECT, reason=reason)
        if _STOP.fullmatch(plain):
            reason = "To stop now, pause the mission, or cancel it: `plainspoken missions`."
            return ChangeOfMind(text, Status.REJECT, reason=reason)
        if stop := _STOP_AFTER.fullmatch(plain):
            return self._stopped_after(text, stop["what"])
        if anew := _ANEW.fullmatch(text.strip()):
            return self._anew(text, anew["what"])
        for wished in follow_ups(text):
            found = self._of_things(text, wished)
            if found is not None:
                return found
        if no_more := _NO_MORE.fullmatch(plain):
            found = self._no_more(text, no_more["what"])
            if found is not None:
                return found
        if instead or (instead is None and _INSTEAD.search(text.strip())):
            return self._anew(text, _INSTEAD.sub("", text.strip()))
        whole = follow_ups(text)[0]
        if whole.wish is Wish.RESTART:
            reason = "That gives the mission up: `plainspoken missions cancel` does."
            return ChangeOfMind(text, Status.REJECT, reason=reason)
        found = self._said_further(text)
        if whole.bare or instead is False or _ALSO.search(text.strip()):
            return found
        return self._besides_or_instead(text, found)

    def _of_things(self, text: str, wished: FollowUp) -> ChangeOfMind | None:
        """A follow-up about things by name: what is asked of them is skipped, or comes first."""
        if not wished.bare or wished.wish not in _OF_THINGS:
            return None
        plain = normal(wished.what)
        things = referents_of(plain, self._lexicon).objects
        goes = {word for word in plain.split() if word in MOTION}
        if not things or goes or not self._only_names(plain, things):
            return None
        patterns = self._patterns()
        symbols = self._asked_of(things, patterns)
        match wished.wish:
            case Wish.SKIP:
                if not symbols:
                    return self._not_asked(text, things)
                for symbol in symbols:
                    patterns = without(patterns, symbol)
            case Wish.REPLACE:
                return self._in_place_of(text, wished.old, things[0], patterns)
            case Wish.ADD if not symbols:
                alike = [each for name in things for each in self._alike(name, patterns)]
                if not alike:
                    return None
                patterns = added(patterns, tuple(Visit((Atom(each),)) for each in alike))
            case Wish.FIRST | Wish.LAST if symbols:
                for symbol in reversed(symbols) if wished.wish is Wish.FIRST else symbols:
                    put = put_first if wished.wish is Wish.FIRST else put_last
                    patterns = put(patterns, Atom(symbol))
            case _:
                return None
        return self._agreed(text, patterns)

    def _in_place_of(
        self, text: str, old: str, new: str, patterns: Patterns
    ) -> ChangeOfMind | None:
        """What is asked of one thing, or of the last of its kind, asked of another one instead."""
        was = referents_of(normal(old), self._lexicon).objects
        kinds = set(self._lexicon.types_of(new)) - {"object"}
        if not was:
            named = [n for s in demanded(patterns) for n in self._arguments(s)]
            was = tuple(n for n in named if kinds & set(self._lexicon.types_of(n)))[-1:]
        symbols = self._asked_of(was[:1], patterns)
        for symbol in symbols:
            other = self._about(symbol, was[0], new)
            if other is None:
                return None
            patterns = replaced(patterns, symbol, other)
        return self._agreed(text, patterns) if symbols else None

    def _about(self, symbol: SymbolId, old: str, new: str) -> SymbolId | None:
        """The symbol that says of one thing what this one says of another."""
        meant = resolve(symbol, self._lexicon.problem)
        if not isinstance(meant, AtomSymbol):
            return None
        found = flat(" ".join(new if each == old else each for each in meant.atom.split()))
        return found if found in self._lexicon.landmarks else None

    def _only_names(self, plain: str, things: Sequence[str]) -> bool:
        """Whether some words are names and nothing else."""
        rest = plain
        for words in sorted(
            (each for name in things for each in self._lexicon.synonyms(name)),
            key=len,
            reverse=True,
        ):
            rest = re.sub(rf"(?<![\w-]){re.escape(words)}(?![\w-])", " ", rest)
        return not set(re.sub(r"\b\d+\b", " ", rest).split()) - {
            "the", "a", "and", "or", "lines", "all", "both", "that", "please", "of"
        }  # fmt: skip

    def _no_more(self, text: str, what: str) -> ChangeOfMind | None:
        """`You need not clear line 3`: what that asks for is skipped, where it is asked for."""
        name = re.sub(r"^(?:do|go to|visit|handle|deal with|look at) ", "", what)
        by_name = self._of_things(text, FollowUp(Wish.SKIP, name))
        if by_name is not None and by_name.status is Status.OK:
            return by_name
        found = self._translate(what, self._vocabulary)
        if found.reading is None:
            return None
        patterns = self._patterns()
        asked_for = set(demanded(patterns))
        symbols = [each for each in demanded(patterns_of(found.reading)) if each in asked_for]
        if not symbols:
            return None
        for symbol in symbols:
            patterns = without(patterns, symbol)
        return self._agreed(text, patterns)

    def _said_further(self, text: str) -> ChangeOfMind:
        """What a conversation about what is left makes of it."""
        patterns = self._patterns()
        agreed = None
        if patterns:
            reading = reading_of(patterns, self._vocabulary, 1.0)
            agreed = Extraction("", Status.OK, reading, confidence=1.0)
        dialogue = Dialogue(self._vocabulary, mission=agreed, translate=self._translate)
        turn = dialogue.say(text)
        found = turn.extraction
        match found.status:
            case Status.OK if found.reading is not None:
                return self._agreed(text, patterns_of(found.reading))
            case Status.CLARIFY:
                choices = []
                for each in found.alternatives:
                    then = turn.dialogue.say(each.answer or "yes").extraction
                    if then.reading is not None and then.status is Status.OK:
                        meant = self._meant(patterns_of(then.reading))
                        choices.append(replace(meant, answer=each.answer or each.english))
                return ChangeOfMind(
                    text, Status.CLARIFY, question=found.question, choices=tuple(choices)
                )
            case _:
                reason = found.reason or "That changes nothing that I understand."
                return ChangeOfMind(text, Status.REJECT, reason=reason)

    def _anew(self, text: str, what: str) -> ChangeOfMind:
        """A whole new request in the place of everything that was asked for."""
        found = self._translate(what, self._vocabulary)
        readings = [found.reading] if found.reading and found.status is Status.OK else []
        if found.status is Status.CLARIFY:
            readings = list(found.alternatives)
        meant = tuple(
            Wanted(
                each.answer or each.english,
                f"Only this: {each.english}",
                (Clause(each.formula, self._mission.instant),),
            )
            for each in readings
        )
        if found.status is Status.OK and meant:
            return ChangeOfMind(text, Status.OK, meant[0])
        if meant:
            return ChangeOfMind(text, Status.CLARIFY, question=found.question, choices=meant)
        return ChangeOfMind(text, Status.REJECT, reason=found.reason or "That is no mission.")

    def _besides_or_instead(self, text: str, besides: ChangeOfMind) -> ChangeOfMind:
        """A question where a whole sentence may be more of the mission, or another one."""
        instead = self._anew(text, text)
        if besides.status is Status.REJECT and instead.status is not Status.OK:
            return besides
        if besides.meant is None or instead.meant is None:
            return besides if besides.status is Status.CLARIFY else instead
        return ChangeOfMind(
            text,
            Status.CLARIFY,
            question="Besides what was asked for, or instead of it?",
            choices=(
                replace(besides.meant, answer="besides"),
                replace(instead.meant, answer="instead"),
            ),
        )

    def _stopped_after(self, text: str, what: str) -> ChangeOfMind:
        """End the mission once something is done: a thing that is asked for, or is worked on."""
        kept = [each for each in self._parts if each.verdict is not Verdict.OPEN]
        now = self._mission.instant
        if re.fullmatch(r"(?:this|that|the current|it)(?: (?:one|action|step|task))?", what):
            return self._ended(text, kept, None)
        thing = self._thing(what)
        if thing is None:
            reason = f'I do not know what "{what}" is.'
            return ChangeOfMind(text, Status.REJECT, reason=reason)
        symbols = self._asked_of((thing,), self._patterns())
        if symbols:
            goals = conjunction(*(Visit((Atom(each),)).executable for each in symbols))
            return self._ended(text, kept, Clause(goals, now))
        goal = done_with(self._mission, thing)
        if goal is None:
            name = self._lexicon.object_words(thing)
            reason = f"Nothing that I am going to do has to do with {name}."
            return ChangeOfMind(text, Status.REJECT, reason=reason)
        return self._ended(text, kept, Clause(goal, now))

    def _thing(self, what: str) -> str | None:
        """The object that words name, or point to: `this mug` is the one that is worked on."""
        named = referents_of(what, self._lexicon).objects
        if named:
            return named[0]
        mission = self._mission
        actions = [mission.in_flight.action] if mission.in_flight else []
        if mission.policy is not None and mission.node is not None:
            actions.append(mission.policy.node(mission.node).action or "")
        actions.append(mission.led_by or "")
        kind = re.sub(r"^(?:this|that|the current|the) ", "", what)
        for action in actions:
            for name in action.split()[1:]:
                kinds = {" ".join(each.split("-")) for each in self._lexicon.types_of(name)}
                if kind in kinds | {self._lexicon.type_words(name)}:
                    return name
        return None

    def _ended(self, text: str, kept: Sequence[Left], last: Clause | None) -> ChangeOfMind:
        clauses = tuple(each.clause for each in kept) + ((last,) if last else ())
        rules = [each.rest for each in kept if each.verdict is Verdict.HOLDS_SO_FAR]
        after = self._say(last.goal) if last else "The action under way is the last one."
        english = " ".join(["Stop after this:", after, *map(self._say, rules)])
        if not clauses:
            clauses = (Clause(conjunction(), self._mission.instant),)
        return ChangeOfMind(text, Status.OK, Wanted("", english, clauses))

    # -- what is left --------------------------------------------------------------------------

    def _patterns(self) -> Patterns:
        """What is left of the request, the visits as one: what comes first, comes before all."""
        places: list[Formula] = []
        others: list[Pattern] = []
        for each in self._parts:
            for pattern in each.patterns:
                if isinstance(pattern, Visit):
                    places += pattern.places
                else:
                    others.append(pattern)
        return (*((Visit(tuple(places)),) if places else ()), *others)

    def _agreed(self, text: str, patterns: Patterns) -> ChangeOfMind:
        if set(single(patterns)) == set(single(self._patterns())):
            return ChangeOfMind(text, Status.REJECT, reason="That is what is asked for already.")
        if not patterns and not any(each.verdict is Verdict.SATISFIED for each in self._parts):
            reason = "Nothing would be left of the mission: `plainspoken missions cancel` ends it."
            return ChangeOfMind(text, Status.REJECT, reason=reason)
        return ChangeOfMind(text, Status.OK, self._meant(patterns))

    def _meant(self, patterns: Patterns) -> Wanted:
        """Patterns as clauses: those that were there before as they are, others from now on."""
        each_alone = single(patterns)
        fixed = [each for each in self._parts if not each.patterns]
        clauses = {each.clause: None for each in fixed}
        for each in each_alone:
            clauses[self._clauses.get(each, Clause(each.executable, self._mission.instant))] = None
        open_ones = [each.rest for each in fixed if each.verdict is not Verdict.SATISFIED]
        goal = conjunction(*(each.executable for each in patterns), *open_ones)
        english = self._say(goal) if each_alone or open_ones else "Nothing more."
        return Wanted("", english, tuple(clauses))

    def _say(self, goal: Formula) -> str:
        return say(goal, self._lexicon.landmarks)

    def _asked_of(self, things: Iterable[str], patterns: Patterns) -> tuple[SymbolId, ...]:
        """The symbols asked for that are about some things."""
        return tuple(
            symbol
            for name in things
            for symbol in demanded(patterns)
            if name in self._arguments(symbol)
        )

    def _arguments(self, symbol: SymbolId) -> tuple[str, ...]:
        match resolve(symbol, self._lexicon.problem):
            case AtomSymbol(atom=atom):
                return tuple(atom.split()[1:])
            case ActionSymbol(arguments=arguments):
                return arguments

    def _alike(self, name: str, patterns: Patterns) -> list[SymbolId]:
        """What is asked of other things of its kind, asked of this one."""
        kinds = set(self._lexicon.types_of(name)) - {"object"}
        for symbol in reversed(demanded(patterns)):
            alike = [n for n in self._arguments(symbol) if kinds & set(self._lexicon.types_of(n))]
            found = self._about(symbol, alike[0], name) if len(alike) == 1 else None
            if found is not None:
                return [found]
        return []

    def _not_asked(self, text: str, things: Sequence[str]) -> ChangeOfMind:
        done = self._asked_of(things, done_already(self._mission))
        names = " and ".join(self._lexicon.object_words(each) for each in things)
        reason = f"What was asked of {names} is done." if done else f"Nothing is asked of {names}."
        return ChangeOfMind(text, Status.REJECT, reason=reason)
