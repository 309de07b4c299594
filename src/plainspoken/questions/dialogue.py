"""Questions in a row: "Why?", "And after that?", "And mug 2?" speak of what went before.

    dialogue = Dialogue()
    first, dialogue = dialogue.ask("What did you do last?", moment)
    second, dialogue = dialogue.ask("Why?", moment)

A dialogue is a value: it holds the last turn, and asking gives a new one.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from plainspoken.questions.answer import answer_at
from plainspoken.questions.claim import ActionClaim, Answer
from plainspoken.questions.doubt import asks_how_known
from plainspoken.questions.kind import Kind
from plainspoken.questions.length import Length
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment
from plainspoken.questions.question import Question, Span, question_of
from plainspoken.questions.referent import Referents
from plainspoken.questions.spelling import normal

_WHY = re.compile(r"^(?:(?:and|but|ok|okay|so|oh) )*(?:why|how come|what for)(?: (?:is|was) \w+)?$")
_WHY_THAT = re.compile(r"^(?:(?:and|but|so) )*(?:why|how come|what for)\b.*\b(?:that|this|it|so)$")
_NEXT = re.compile(
    r"^(?:(?:and|so|ok|okay|what) )*(?:(?:then|next|afterwards)(?: what)?"
    r"|(?:what )?(?:comes |do you do |happens |will you do )?(?:is )?after (?:that|this|it))$"
)
_EARLIER = re.compile(r"^(?:and |what )*(?:(?:did you do |was |came )?before (?:that|this|it))$")
_WHEN = re.compile(
    r"^(?:(?:and|so) )*(?:(?:since )?when|at what time|how long ago)"
    r"(?: (?:was|is|will|did) (?:that|this|it)(?: be| happen)?)?$"
)
_PRONOUN = re.compile(r"\b(?:it|them|they|that one|this one|there|its|he|she|him|her)\b")
_GENERAL_WORDS = """
    and but or so ok okay then well what whats what's why how when for from did do does done doing
    was were is are be been being will would won't can could may might should has have had it its
    it's that that's this these those them they there not you your i me my the a an of to at in on
    by about up out off over with come came happen happened happens cause caused causes made make
    reason reasons purpose point sense good use aim goal bring brought lead led leads many often
    much times time ever exactly please again go going gone get got forbidden allowed supposed
    which mean behind
"""
_GENERAL = frozenset(_GENERAL_WORDS.split())
_BACK = re.compile(r"\b(?:it|its|that|this|them|they|there|those|these)\b")
_OF_SOMETHING = frozenset((Kind.WHY_NOT, Kind.WHY_HAPPENED, Kind.COUNT_HISTORY))
"""Kinds of questions that are about something, be it left unsaid."""
_ALSO = re.compile(r"^(?:(?:and|or) )?(?:what about|how about|and|or)\b")


@dataclass(frozen=True, slots=True)
class Turn:
    """A question and what was answered."""

    question: Question
    answer: Answer


@dataclass(frozen=True, slots=True)
class Dialogue:
    """What has been spoken of; nothing yet where there is no turn."""

    turn: Turn | None = None

    def ask(
        self, text: str, moment: Moment, *, length: Length = Length.BRIEF
    ) -> tuple[Answer, Dialogue]:
        """Answer a question in the light of the one before; also the dialogue after it."""
        question = question_of(text, moment.lexicon)
        if self.turn is not None:
            question = follow_up(question, self.turn, moment.lexicon)
        found = answer_at(question, moment, length=length)
        return found, Dialogue(Turn(question, found))


def follow_up(question: Question, before: Turn, lexicon: Lexicon) -> Question:
    """The question with what it leaves unsaid filled in from the turn before it."""
    plain = normal(question.text)
    bare = not question.referents.objects and not question.referents.actions
    spoken = _spoken_of(before)
    if bare and (_WHY.match(plain) or _WHY_THAT.match(plain)):
        return _why(question, before, spoken, lexicon)
    if not question.referents.objects and asks_how_known(question):
        return _how_known(question, before)
    if bare and _NEXT.match(plain) and spoken is not None and spoken.certainty != "was":
        about = _about(spoken, question.referents, lexicon)
        return replace(question, kind=Kind.FUTURE, span=Span.AFTER, referents=about)
    if bare and _EARLIER.match(plain) and spoken is not None and spoken.certainty == "was":
        about = _about(spoken, question.referents, lexicon)
        return replace(question, kind=Kind.PAST, span=Span.BEFORE, referents=about)
    if bare and _WHEN.match(plain):
        return _when(question, before, spoken, lexicon)
    if _ALSO.match(plain) and question.referents.objects:
        return _same_of_another(question, before.question, lexicon)
    if not question.referents.objects and _PRONOUN.search(plain):
        named = _with_names(question, before, spoken, lexicon)
        if named is not question:
            return named
    if bare and _leaves_unsaid(question, plain):
        return _of_the_same(question, before, spoken, lexicon)
    return question


def _leaves_unsaid(question: Question, plain: str) -> bool:
    """Whether a question names nothing of its own, and is about something: "For what reason?"."""
    if not _GENERAL.issuperset(plain.split()):
        return False
    if question.kind in _OF_SOMETHING:
        return True
    if question.kind is Kind.WHY_ACTION:
        return "now" not in plain.split()
    return question.kind in (Kind.FUTURE, Kind.CONSTRAINT, Kind.WHEN) and bool(_BACK.search(plain))


def _of_the_same(
    question: Question, before: Turn, spoken: ActionClaim | None, lexicon: Lexicon
) -> Question:
    """The question about what the one before was about, or about the action that was told."""
    asked = before.question
    if question.kind in (Kind.WHY_ACTION, Kind.WHY_HAPPENED):
        reason = _why(question, before, spoken, lexicon)
        if reason is not question:
            return reason
    about = asked.referents
    if not (about.objects or about.actions or about.atoms):
        if spoken is None:
            return question
        about = _about(spoken, question.referents, lexicon)
    return replace(question, referents=about)


def _spoken_of(turn: Turn) -> ActionClaim | None:
    """The action that an answer ended with: the last one done, or the last one told ahead."""
    done = [claim for claim in turn.answer.actions if claim.certainty == "was"]
    if turn.question.kind in (Kind.PAST, Kind.WHEN, Kind.COUNT_HISTORY, Kind.WHY_HAPPENED):
        return done[-1] if done else None
    ahead = [claim for claim in turn.answer.actions if claim.certainty != "was"]
    sure = [claim for claim in ahead if claim.certainty == "will"]
    if turn.question.kind is Kind.FUTURE and turn.question.span is not Span.AFTER:
        return _last_told(turn, sure, ahead)
    if turn.question.kind is Kind.FUTURE:
        return ahead[-1] if ahead else done[-1] if done else None
    return ahead[0] if ahead else done[-1] if done else None


def _last_told(turn: Turn, sure: list[ActionClaim], ahead: list[ActionClaim]) -> ActionClaim | None:
    """The last sure action of a plan that was told; behind a fork, the first of the ways on."""
    if not sure:
        return ahead[0] if ahead else None
    ways = [claim for claim in ahead if claim.at == sure[-1].at + 1]
    return ways[0] if ways and " if " in turn.answer.text else sure[-1]


def _about(claim: ActionClaim, known: Referents, lexicon: Lexicon) -> Referents:
    """Referents that mean one ground action."""
    name, *arguments = claim.action.split()
    objects = tuple(each for each in arguments if each != lexicon.me)
    goals = tuple(each for each in known.goals if each[0] != name)
    return Referents(objects, actions=(name,), verbs=known.verbs, goals=goals)


def _why(
    question: Question, before: Turn, spoken: ActionClaim | None, lexicon: Lexicon
) -> Question:
    """`Why?` after a fact asks what made it so, after an action what it is for."""
    asked = before.question
    if asked.kind is Kind.STATE and asked.referents.atoms:
        return replace(question, kind=Kind.WHY_HAPPENED, referents=asked.referents)
    if asked.kind is Kind.STATE and before.answer.claims:
        atoms = tuple(claim.fluent for claim in before.answer.claims[:1])
        return replace(
            question, kind=Kind.WHY_HAPPENED, referents=replace(asked.referents, atoms=atoms)
        )
    if asked.kind is Kind.WHY_ACTION:
        # Why of a why: the last action named is what the first one is for.
        ahead = [claim for claim in before.answer.actions if claim.certainty != "was"]
        spoken = ahead[-1] if ahead else spoken
    if spoken is None:
        return question
    about = _about(spoken, question.referents, lexicon)
    return replace(question, kind=Kind.WHY_ACTION, referents=about)


def _how_known(question: Question, before: Turn) -> Question:
    """`How do you know?`: of the fact that was asked about, or that was told first."""
    about = before.question.referents
    told = (*before.answer.claims, *before.answer.denied)
    atoms = about.atoms[:1] if about.objects else tuple(claim.fluent for claim in told[:1])
    if not atoms:
        return question
    objects = tuple(atoms[0].split()[1:])
    return replace(question, referents=replace(about, objects=objects, atoms=atoms))


def _when(
    question: Question, before: Turn, spoken: ActionClaim | None, lexicon: Lexicon
) -> Question:
    """`When was that?`: the time of what was asked about, or of the action told."""
    asked = before.question
    about = asked.referents
    if not (about.atoms or about.actions):
        if spoken is None:
            return question
        about = _about(spoken, question.referents, lexicon)
    ahead = asked.kind is Kind.FUTURE or (spoken is not None and spoken.certainty != "was")
    text = "when will that be" if ahead else "when was that"
    return replace(question, kind=Kind.WHEN, text=text, referents=about)


def _same_of_another(question: Question, before: Question, lexicon: Lexicon) -> Question:
    """`And mug 2?`: the question before, asked of another thing of the kind."""
    text = before.text
    for new in question.referents.objects:
        for old in before.referents.objects:
            if set(lexicon.types_of(new)) & set(lexicon.types_of(old)):
                text = _renamed(text, old, new, lexicon)
                break
    return question_of(text, lexicon) if text != before.text else question


def _renamed(text: str, old: str, new: str, lexicon: Lexicon) -> str:
    for words in sorted(lexicon.synonyms(old), key=len, reverse=True):
        changed = re.sub(
            rf"(?<![\w-])(?:the )?{re.escape(words)}(?![\w-])",
            lexicon.object_words(new),
            text,
            flags=re.IGNORECASE,
        )
        if changed != text:
            return changed
    return text


def _with_names(
    question: Question, before: Turn, spoken: ActionClaim | None, lexicon: Lexicon
) -> Question:
    """`Is it clean?`: the pronoun named, where the turn before leaves one thing it can mean."""
    names = before.question.referents.objects
    if not names and spoken is not None:
        names = tuple(each for each in spoken.action.split()[1:] if each != lexicon.me)
    for name in names:
        words = lexicon.object_words(name)
        text = _PRONOUN.sub(words, normal(question.text), count=1)
        named = question_of(text + ("?" if question.text.endswith("?") else ""), lexicon)
        # A pronoun means what can be said of the thing: a mug is clean, a place is not.
        if named.referents.atoms or named.referents.actions:
            return named
    return question
