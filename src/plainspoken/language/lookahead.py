"""The clause that is being read, and what the items around it show."""

from __future__ import annotations

from collections.abc import Sequence

from plainspoken.language.clause import Clause
from plainspoken.language.draft import Draft
from plainspoken.language.expression import Shape
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form, Reference

FLAGS = frozenset(
    (
        Kind.NEXT, Kind.NEXT_INSTANT, Kind.LATER, Kind.NOW, Kind.ALWAYS, Kind.NO_OTHER,
        Kind.AGAIN_AND_AGAIN, Kind.ANY_ORDER, Kind.SEQUENCE, Kind.IN_ORDER, Kind.NO_RETURN,
        Kind.FIRST, Kind.BEFORE_THAT, Kind.AFTER_THAT, Kind.RIGHT_AFTER_THAT,
        Kind.RIGHT_BEFORE_THAT, Kind.ONLY, Kind.AGAIN, Kind.ALREADY, Kind.NTH,
        Kind.LATER_ON, Kind.ALTERNATE,
    )
)  # fmt: skip

VERBS = frozenset((Kind.GO, Kind.STAY, Kind.LEAVE, Kind.AVOID, Kind.PATROL))

POINTERS = frozenset(("it", "them", "there", "that", "this", "these", "those", "one", "both"))

_MOVES = frozenset(
    (Kind.BEFORE_THAT, Kind.AFTER_THAT, Kind.LATER_ON, Kind.RIGHT_AFTER_THAT, Kind.FIRST)
)


class Lookahead:
    """Items read so far as clauses, and questions about those that follow."""

    def __init__(self, found: Sequence[Item]) -> None:
        # Fillers shape nothing, but for words that point back ("there"), and what these point at.
        self._items = [
            each for each in found
            if each.kind not in (Kind.FILLER, Kind.UNKNOWN, Kind.RELATIVE) or each.text in POINTERS
            or each.reference is not None
        ]  # fmt: skip
        self._done: list[Clause] = []
        self._draft = Draft()
        self._link: Kind | None = None
        self._pause = False
        self._last: list[Reference] = []
        self._nor = False

    def _take_link(self) -> None:
        """The clause that begins here is joined by what stands before it."""
        self._draft.link, self._draft.pause = self._link, self._pause or self._draft.pause
        self._link, self._pause = None, False

    def _asks(self) -> bool:
        """Whether a question tells a situation: "Tank full? Call ..."."""
        draft = self._draft
        return (
            draft.connector is None
            and draft.verb is None
            and draft.modality is None
            and bool(draft.operands)
            and all(each.reference.form is Form.FINITE for each in draft.operands)
        )

    def _begins(self, index: int) -> bool:
        """Whether the item after this one begins a clause of its own."""
        moves = self._items[index].kind in _MOVES
        for item in self._items[index + 1 :]:
            if item.kind in FLAGS or (moves and item.kind is Kind.COMMA):
                continue
            if item.kind in VERBS:
                return item.form is Form.BASE
            if item.kind is Kind.REFERENCE:
                return item.form in (Form.BASE, Form.FINITE)
            return item.kind in (
                Kind.MUST, Kind.MAY, Kind.NOT, Kind.NEVER, Kind.ENSURE, Kind.SUBJECT,
            )  # fmt: skip
        return False

    def _is_passive(self, index: int) -> bool:
        """Whether what follows is "(not) be visited", said of the operands before."""
        for item in self._items[index + 1 :]:
            if item.kind in FLAGS or item.kind in (
                Kind.NOT, Kind.NEVER, Kind.BE, Kind.MUST, Kind.MAY, Kind.ENSURE,
            ):  # fmt: skip
                continue
            if item.kind is Kind.THEN and item.text.startswith("followed"):
                return True
            return item.kind is Kind.OCCUR or (
                item.kind in VERBS and item.form is Form.FINITE and item.text != "visits"
            ) or item.kind in (Kind.COUNT, Kind.LEADS, Kind.PRECEDED)  # fmt: skip
        return False

    def _forbids(self, index: int) -> bool:
        """Whether a "not" begins a prohibition: "... and do not go there"."""
        before = self._items[index - 1] if index else None
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        return (
            following is not None
            and following.form is Form.BASE
            and not (before is not None and before.kind is Kind.SUBJECT)
        )

    def _is_last(self, index: int) -> bool:
        """Whether a "not" or "never" stands behind what it denies: "a yes, b never"."""
        if self._link is not None:
            return False
        for item in self._items[index + 1 :]:
            if item.kind is Kind.ALWAYS:
                continue
            return item.kind in (Kind.COMMA, Kind.STOP, Kind.BUT) or (
                item.kind is Kind.AND and self._items[index].kind is Kind.NEVER
            )
        return True

    def _goes_on(self, index: int) -> bool:
        """Whether a reference follows, and nothing that would begin a clause before it."""
        for item in self._items[index + 1 :]:
            if item.kind in FLAGS or item.kind is Kind.COMMA or item.kind in VERBS:
                continue
            return item.kind is Kind.REFERENCE
        return False

    def _obliged(self) -> bool:
        """Whether what was said of the operands so far is that they must ..."""
        draft = self._draft
        return bool(draft.operands) and draft.modality is Kind.MUST and draft.connector is None

    def _acts(self) -> bool:
        return any(each.reference.shape is Shape.ACT for each in self._draft.operands)

    def _inverted(self, index: int) -> bool:
        """Whether a "should" begins a condition: "should the tank be full, ..."."""
        before = self._items[index - 1] if index else None
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        begins = before is None or before.kind in (Kind.STOP, Kind.COMMA, Kind.AND, Kind.BUT)
        return (
            begins
            and (self._draft.is_blank or self._link is not None)
            and following is not None
            and following.kind in (Kind.REFERENCE, Kind.SUBJECT, Kind.ALWAYS)
        )

    def _ends_list(self, index: int) -> bool:
        """Whether no "and" or "or" follows that would make this a list."""
        for item in self._items[index + 1 : index + 4]:
            if item.kind in (Kind.AND, Kind.OR, Kind.STOP):
                return item.kind is Kind.STOP
        return True

    def _is_setting(self, reference: Reference) -> bool:
        """Whether a place only says where the act before it is done."""
        return (
            reference.form is Form.NOUN
            and self._link is None
            and bool(self._draft.operands)
            and self._draft.operands[-1].reference.shape is Shape.ACT
        )
