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

_SEQUELS = frozenset((Kind.AFTER_THAT, Kind.LATER_ON))

_DENIALS = frozenset(("not", "never", "no"))


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
                self._close(Kind.COMMA)
            elif not self._draft.is_blank:
                self._close(Kind.STOP)
        elif kind is Kind.THEN and item.text.startswith("followed") and self._obliged() and (
            self._link is None
        ):  # fmt: skip
            self._leads()
        elif kind in _LINKS:
            self._linked(kind)
            if kind is Kind.OR and " of" in item.text and not self._draft.operands:
                self._either_of()
        elif kind is Kind.ELSEWHERE and not self._acts():
            self._draft.verb = Kind.AVOID
        elif kind is Kind.MUST and item.text == "should" and self._inverted(index):
            self._connected(Kind.WHEN)
        elif kind in CONNECTORS:
            self._connected(kind)
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
            self._draft.being = True
        elif kind is Kind.COUNT and item.count is not None:
            if self._names_again(index):
                self._close(self._link)  # "a then b, with exactly one visit to a before b"
            self._draft.counts.append(item.count)
            self._draft.counted = bool(self._draft.operands)
        elif kind is Kind.CEASE:
            self._ceased()
        elif kind is Kind.BOTH:
            self._all_of(index, item)
        elif kind is Kind.LEADS:
            self._leads()
        elif kind is Kind.PRECEDED:
            self._preceded()
        elif kind is Kind.OCCUR:
            self._draft.complete = True
        elif kind is Kind.IT_HAPPENS:
            following = self._items[index + 1] if index + 1 < len(self._items) else None
            if following is None or following.kind not in (*VERBS, Kind.REFERENCE):
                self._pointed(situation=True)
        elif kind in (Kind.SUBJECT, Kind.FILLER, Kind.RELATIVE):
            self._subject(index, item)

    def _linked(self, kind: Kind) -> None:
        self._pause |= kind is Kind.COMMA
        strength = (None, Kind.COMMA, Kind.AND, Kind.OR, Kind.BUT, Kind.THEN, Kind.ONLY_THEN)
        if strength.index(kind) > strength.index(self._link):
            self._link = kind

    def _connected(self, kind: Kind) -> None:
        draft = self._draft
        if draft.connector is not None and not draft.operands:
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
            if item.form is Form.GERUND and self._link in (Kind.AND, Kind.OR, Kind.COMMA) and not (
                self._names_again(index)
            ):  # fmt: skip
                return
            self._close(self._link)
            draft = self._draft
        elif self._link is not None and draft.is_blank:
            self._take_link()
        self._link = None
        first, *more = item.text.split()
        if first in _RETURNS or (first in _BACK and more == ["back"]):
            draft.flags.add(Kind.AGAIN)
        if item.text.split()[0] in BEING:
            draft.flags.add(Kind.BE)
        if draft.connector is not None and item.form is Form.FINITE and _is_past(item):
            draft.flags.add(Kind.ALREADY)
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
            if self._is_passive(index) and (draft.verb is None or draft.connector is not None):
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
        if draft.lists and kind is Kind.NOT and not (bare and draft.operands) and (
            not draft.operands
            or (self._link in (Kind.AND, Kind.OR) and not self._forbids(index))
        ):  # fmt: skip
            draft.flipped = not draft.flipped if not draft.operands else True
            draft.shared = False
            return
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
        if draft.operands and self._link is not None:
            if self._begins(index):
                self._close(self._link)
            elif kind in _SEQUELS and draft.connector is None and self._goes_on(index):
                self._link = Kind.THEN  # "a, and later b"
                return
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
