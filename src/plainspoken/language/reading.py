"""Items read left to right as clauses: where one ends, what it does, and to what."""

from __future__ import annotations

from collections.abc import Sequence

from plainspoken.language.clause import CONNECTORS, Clause
from plainspoken.language.draft import Draft
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.lookahead import FLAGS, POINTERS, VERBS
from plainspoken.language.operand import BEING
from plainspoken.language.reference import Form
from plainspoken.language.turning import Turns

_LINKS = frozenset((Kind.AND, Kind.OR, Kind.BUT, Kind.COMMA, Kind.THEN, Kind.ONLY_THEN))

_RETURNS = frozenset(["revisit", "revisiting", "return", "returning", "reenter"])

_BACK = frozenset(["come", "coming", "go", "going", "get", "getting"])

_ONWARD = frozenset(["proceed", "continue", "finish", "end", "conclude", "wind", "round"])
_ONWARDS = ("go on", "move on", "carry on", "press on", "push on", "head on", "end up")
"""Verbs that lead on from the place before."""

_SEQUELS = frozenset((Kind.AFTER_THAT, Kind.LATER_ON))

_DENIALS = frozenset(("not", "never", "no"))

_PASSED = FLAGS | {Kind.NOT, Kind.NEVER}
"""What may stand between "it is" and what it is."""


def _is_past(item: Item) -> bool:
    verb = item.text.split()[0]
    return verb.endswith("ed") or verb in ("been", "gone", "had", "have", "seen", "went")


def clauses(found: Sequence[Item]) -> tuple[Clause, ...]:
    """Read items as clauses, in the order in which they are said."""
    return _Reader(found).clauses()


class _Reader(Turns):
    def clauses(self) -> tuple[Clause, ...]:
        for index, item in enumerate(self._items):
            self._read(index, item)
        self._close(None)
        return tuple(self._done)

    def _read(self, index: int, item: Item) -> None:
        kind = item.kind
        if kind is Kind.STOP:
            if item.text == "?" and self._asks():
                self._draft.connector = Kind.WHEN
                self._with_what_is_asked()
                self._close(Kind.COMMA)
            elif not self._draft.is_blank:
                self._close(Kind.STOP)
        elif kind is Kind.THEN and item.text.startswith("followed") and (
            self._obliged() or self._draft.being
        ) and (
            self._link is None
        ):  # fmt: skip
            self._leads()
        elif kind in _LINKS:
            self._linked(kind)
            one_of = item.text.endswith((" of", " from")) or " of " in item.text
            if kind is Kind.OR and one_of and not self._draft.operands:
                self._either_of()
        elif kind is Kind.OTHERWISE:
            self._otherwise()
        elif kind is Kind.ELSEWHERE and not self._acts():
            self._draft.verb = Kind.AVOID
        elif kind is Kind.MUST and item.text == "should" and self._inverted(index):
            self._connected(index, Kind.WHEN)
        elif kind in CONNECTORS:
            self._connected(index, kind)
            self._draft.denied = not _DENIALS.isdisjoint(item.text.split())
        else:
            self._read_within(index, item)

    def _read_within(self, index: int, item: Item) -> None:
        """Read what adds to a clause, or turns it, and by itself neither ends nor joins one."""
        kind = item.kind
        if kind in VERBS:
            self._verb(index, item)
        elif kind is Kind.REFERENCE and item.reference is not None:
            self._referred(index, item)
        elif kind in FLAGS:
            self._flagged(index, kind)
        elif kind in (Kind.MUST, Kind.MAY, Kind.ENSURE):
            self._modal(index, kind)
            self._draft.wished |= kind is Kind.ENSURE
            if item.text.endswith(" that"):
                self._draft.assured = True
        elif kind in (Kind.NOT, Kind.NEVER):
            self._negation(index, kind)
        elif kind is Kind.FORBIDDEN:
            self._forbidden()
        elif kind is Kind.BE:
            # "as long as you have not been there" tells of the past.
            past = item.text == "been" and self._draft.connector is not None
            self._draft.being |= not past
        elif kind is Kind.COUNT and item.count is not None:
            behind = self._items[index + 1 : index + 2]
            if behind and behind[0].reference and self._names_again(index):
                self._close(self._link)  # "a then b, with exactly one visit to a before b"
            self._draft.counts.append(item.count)
            self._draft.counted = bool(self._draft.operands)
        elif kind is Kind.CEASE:
            self._ceased()
        elif kind is Kind.BOTH:
            self._all_of(index, item)
        elif kind is Kind.LEADS:
            self._leads()
        elif kind is Kind.BARS:
            self._bars()
        elif kind is Kind.RELEASES:
            self._releases()
        elif kind is Kind.PRECEDED:
            self._preceded()
        elif kind is Kind.OCCUR:
            self._draft.complete = True
        elif kind is Kind.IT_HAPPENS:
            ahead = (each for each in self._items[index + 1 :] if each.kind not in _PASSED)
            said = next(ahead, None)
            if said is None or said.kind not in (*VERBS, Kind.REFERENCE):
                self._pointed(situation=True)
        elif item.reference is not None:
            self._last.append(item.reference)  # it is only mentioned
        elif kind in (Kind.SUBJECT, Kind.FILLER, Kind.RELATIVE):
            self._subject(index, item)

    def _linked(self, kind: Kind) -> None:
        self._pause |= kind is Kind.COMMA
        if self._draft.verb is Kind.LEAVE and self._draft.link and not self._draft.operands:
            self._draft.verb = None  # "go there, then leave, and ..."
        draft = self._draft
        if draft.pronoun and draft.being and draft.verb and not draft.operands and (
            draft.connector is None
        ):  # fmt: skip
            self._pointed(situation=False)  # "it has to be visited, and ..."
        strength = (None, Kind.COMMA, Kind.AND, Kind.OR, Kind.BUT, Kind.THEN, Kind.ONLY_THEN)
        if strength.index(kind) > strength.index(self._link):
            self._link = kind

    def _connected(self, index: int, kind: Kind) -> None:
        draft = self._draft
        if draft.connector is not None and not draft.operands:
            if self._items[index].text.startswith("having"):
                draft.flags.add(Kind.ALREADY)  # "without having been to a"
            elif not (draft.connector is Kind.PROMPTLY and kind in (Kind.WHENEVER, Kind.WHEN)):
                draft.connector = kind
            return
        if (
            draft.connector is None
            and not draft.operands
            and draft.verb is None
            and not draft.counts
        ):
            if draft.negations % 2 and self._done:
                self._close(None, kind)  # "..., yet never while"
                return
            # "and immediately after ..., not while ...": what was said so far belongs to the main
            # clause that follows the subordinate one.
            self._carry(kind)
            return
        self._close(self._link, kind)

    def _carry(self, kind: Kind) -> None:
        link = self._link if self._link is not None else self._draft.link
        kept = self._draft
        self._draft = Draft(connector=kind, link=link, negations=0)
        self._draft.flags |= kept.flags & {Kind.NEXT}
        self._link = None

    def _verb(self, index: int, item: Item) -> None:
        draft = self._draft
        if self._nor and draft.operands:
            return  # "neither go to a nor enter b"
        listed = draft.lists and self._link in (Kind.AND, Kind.OR)
        before = self._items[index - 1] if index else None
        if draft.operands and listed and before is not None and (
            before.kind in (Kind.SUBJECT, Kind.NOT)
        ):  # fmt: skip
            return
        if draft.operands:
            passive = item.form is Form.FINITE and self._link is None and not draft.subject
            if passive or (item.form is Form.FINITE and before and before.kind is Kind.BE):
                draft.complete = True
                if item.kind is not Kind.GO:
                    draft.verb = item.kind
                return
            turned = item.kind is Kind.AVOID and draft.verb in (None, Kind.GO) and not (
                draft.negations
            )  # fmt: skip
            if item.form is Form.GERUND and self._link in (Kind.AND, Kind.OR, Kind.COMMA) and not (
                turned or self._names_again(index)
            ):  # fmt: skip
                return
            self._close(self._link)
            draft = self._draft
        elif self._link is not None and draft.is_blank:
            self._take_link()
        linked, self._link = self._link, None
        first, *more = item.text.split()
        onward = first in _ONWARD or item.text.startswith(_ONWARDS)
        if onward and self._done and draft.connector is None and not draft.negations and (
            draft.link in (Kind.COMMA, Kind.AND, Kind.STOP)
        ):  # fmt: skip
            draft.link = Kind.THEN  # "go on to b", "finish up at c"
        if first in _RETURNS or (first in _BACK and more == ["back"]):
            draft.flags.add(Kind.AGAIN)
        if item.text.split()[0] in BEING:
            draft.flags.add(Kind.BE)
        if draft.connector is not None and item.form is Form.FINITE and _is_past(item):
            draft.flags.add(Kind.ALREADY)
        if draft.verb is Kind.GO and item.kind is Kind.LEAVE and not draft.operands and (
            linked in (Kind.AND, Kind.THEN)
        ):  # fmt: skip
            return  # "visit and then leave it" is a visit
        if draft.verb is None or (draft.verb is Kind.GO and item.kind is not Kind.GO):
            draft.verb = item.kind
        elif draft.verb is Kind.AVOID and item.kind is Kind.LEAVE:
            draft.verb, draft.negations = Kind.STAY, draft.negations
        elif draft.verb is Kind.STAY and item.kind is Kind.AVOID:
            draft.verb = Kind.AVOID
        elif draft.verb is Kind.STAY and item.kind is Kind.GO and item.form is Form.GERUND:
            draft.verb = Kind.PATROL

    def _names_again(self, index: int) -> bool:
        """Whether what follows speaks, behind a pause or "and", of an operand once more."""
        named = next((each.reference for each in self._items[index:] if each.reference), None)
        return (
            self._link in (Kind.AND, Kind.COMMA)
            and named is not None
            and any(each.reference.symbol == named.symbol for each in self._draft.operands)
        )

    def _modal(self, index: int, kind: Kind) -> None:
        draft = self._draft
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        if draft.operands and kind is Kind.MAY and self._link is None and self._acts() and (
            draft.connector is None and following is not None and following.form is Form.NOUN
        ):  # fmt: skip
            draft.modality = kind  # "doing a is permitted at b"
            return
        if draft.operands:
            # "a visit to a must be followed by ..." has a verb that is a noun
            nominal = draft.verb is None or (
                draft.verb is Kind.GO and not draft.subject and self._link is None
            )
            if self._is_passive(index) and (nominal or draft.connector is not None):
                if draft.connector is None:
                    self._link = None
                    draft.modality = kind if kind is not Kind.ENSURE else draft.modality
                    return
                if draft.complete or len(draft.operands) > 1:
                    self._split()
                    self._draft.modality = kind
                    return
            self._close(self._link)
        elif draft.is_blank and self._link is not None:
            self._take_link()
        if kind is not Kind.ENSURE:
            self._draft.modality = kind

    def _negation(self, index: int, kind: Kind) -> None:
        draft = self._draft
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        bare = self._items[index].text.split()[0] == "no" and (
            following is not None and following.form in (Form.NOUN, Form.GERUND)
        )
        if draft.lists and draft.flipped and draft.operands and self._items[index].text == "nor":
            self._link, self._nor = Kind.AND, True  # "if it is neither a nor b"
            return
        if draft.lists and kind is Kind.NOT and not (bare and draft.operands) and (
            not draft.operands
            or (self._link in (Kind.AND, Kind.OR) and not self._forbids(index))
        ):  # fmt: skip
            draft.flipped = not draft.flipped if not draft.operands else True
            draft.shared = False
            return
        if draft.operands and draft.negations % 2 and (
            following is None or following.kind is Kind.STOP
        ):  # fmt: skip
            return  # "never a or b, not even once"
        if draft.operands and self._is_last(index):
            self._behind()
            return
        if draft.operands and self._items[index].text == "nor" and draft.negations % 2:
            self._link, self._nor, draft.apart = Kind.AND, True, True
            return
        if draft.operands:
            listed = draft.verb is None and self._link is Kind.COMMA
            if (self._link is None or listed) and self._is_passive(index):
                self._link = None
                draft.negations += 1
                return
            if draft.negations % 2 and self._link in (Kind.OR, Kind.AND, Kind.COMMA, None):
                following = self._items[index + 1] if index + 1 < len(self._items) else None
                if following is not None and following.kind is Kind.REFERENCE and (
                    following.form is Form.NOUN or draft.verb is None
                ):  # fmt: skip
                    return  # "neither a nor b", "never a, never b"
            self._close(self._link)
        elif draft.is_blank and self._link is not None:
            self._take_link()
        if kind is Kind.NEVER and self._draft.negations:
            return  # "do not ever", "never not": one negation
        self._draft.negations += 1

    def _flagged(self, index: int, kind: Kind) -> None:
        draft = self._draft
        behind = kind is Kind.AGAIN and draft.negations % 2 and self._link is Kind.COMMA
        if draft.operands and self._link is not None and not behind:
            if self._begins(index):
                self._close(self._link)
            elif kind in _SEQUELS and draft.connector is None and self._goes_on(index):
                self._link = Kind.THEN  # "a, and later b"
                return
            elif draft.connector is None and self._goes_on(index) and (
                kind is Kind.BEFORE_THAT or (kind is Kind.FIRST and self._link is Kind.BUT)
            ):  # fmt: skip
                self._close(self._link)  # "a, and before that b", "a, but first b"
                kind = Kind.BEFORE_THAT
        after = kind is Kind.LATER and self._items[index].text.endswith(" after")
        if after and Kind.ALWAYS in self._draft.flags:
            kind = Kind.AGAIN_AND_AGAIN  # "at any point you must visit it at least once after"
        self._draft.flags.add(kind)

    def _subject(self, index: int, item: Item) -> None:
        draft = self._draft
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        if item.text in POINTERS and not draft.operands and draft.verb is not None:
            self._pointed(situation=False)
            return
        if item.kind is not Kind.SUBJECT:
            return
        begins = following is not None and (
            following.kind in (Kind.MUST, Kind.MAY, Kind.NOT, Kind.NEVER, Kind.ENSURE)
            or following.kind in VERBS
            or (following.kind is Kind.REFERENCE and following.form is not Form.NOUN)
        )
        listed = draft.lists and self._link in (Kind.AND, Kind.OR)
        if listed:
            draft.flipped = draft.shared = False
        if listed and begins and following is not None and following.kind in (
            *VERBS, Kind.REFERENCE, Kind.NOT,
        ):  # fmt: skip
            return  # "when the one is so and you visit the other"
        if draft.operands and begins:
            self._close(self._link)
        elif not draft.operands and draft.is_blank and self._link is not None:
            self._take_link()
        if not self._draft.operands:
            self._draft.subject = True
            self._draft.pronoun = item.text in ("it", "they")
