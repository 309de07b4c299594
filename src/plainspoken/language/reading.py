"""Items read left to right as clauses: where one ends, what it does, and to what."""

from __future__ import annotations

from collections.abc import Sequence

from plainspoken.language.clause import CONNECTORS, Clause, Operand
from plainspoken.language.draft import Draft
from plainspoken.language.grounding import Shape
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form, Reference

FLAGS = frozenset(
    (
        Kind.NEXT, Kind.NEXT_INSTANT, Kind.LATER, Kind.NOW, Kind.ALWAYS, Kind.NO_OTHER,
        Kind.AGAIN_AND_AGAIN, Kind.ANY_ORDER, Kind.SEQUENCE, Kind.IN_ORDER, Kind.NO_RETURN,
        Kind.FIRST, Kind.BEFORE_THAT, Kind.AFTER_THAT, Kind.RIGHT_AFTER_THAT,
        Kind.RIGHT_BEFORE_THAT, Kind.ONLY, Kind.AGAIN, Kind.ALREADY, Kind.NTH,
    )
)  # fmt: skip
_LINKS = frozenset((Kind.AND, Kind.OR, Kind.BUT, Kind.COMMA, Kind.THEN, Kind.ONLY_THEN))
_VERBS = frozenset((Kind.GO, Kind.STAY, Kind.LEAVE, Kind.AVOID, Kind.PATROL))
_RETURNS = frozenset(["revisit", "revisiting", "return", "returning", "reenter"])
_POINTERS = frozenset(("it", "them", "there", "that", "this", "these", "those", "one", "both"))


def _is_past(item: Item) -> bool:
    verb = item.text.split()[0]
    return verb.endswith("ed") or verb in ("been", "gone", "had", "have", "seen", "went")


def clauses(found: Sequence[Item]) -> tuple[Clause, ...]:
    """Read items as clauses, in the order in which they are said."""
    return _Reader(found).clauses()


class _Reader:
    def __init__(self, found: Sequence[Item]) -> None:
        # Fillers shape nothing, but for words that point back ("there").
        self._items = [
            each for each in found
            if each.kind not in (Kind.FILLER, Kind.UNKNOWN, Kind.RELATIVE) or each.text in _POINTERS
        ]  # fmt: skip
        self._done: list[Clause] = []
        self._draft = Draft()
        self._link: Kind | None = None
        self._pause = False
        self._last: list[Reference] = []

    def clauses(self) -> tuple[Clause, ...]:
        for index, item in enumerate(self._items):
            self._read(index, item)
        self._close(None)
        return tuple(self._done)

    def _close(self, link: Kind | None, connector: Kind | None = None) -> None:
        """End the clause that is being read and begin another."""
        draft = self._draft
        open_end = (draft.connector is not None and draft.verb is not None) or draft.negations > 0
        if self._draft.operands or self._draft.counts or self._draft.flags or open_end:
            self._done.append(self._draft.clause())
        elif self._draft.link is not None and connector is None and link is None:
            link = self._draft.link
        pause = self._pause or link is Kind.STOP
        self._draft = Draft(connector=connector, link=link, pause=pause)
        self._link, self._pause = None, False

    def _read(self, index: int, item: Item) -> None:
        kind = item.kind
        if kind is Kind.STOP:
            if item.text == "?" and self._asks():
                self._draft.connector = Kind.WHEN
                self._close(Kind.COMMA)
            elif not self._draft.is_blank:
                self._close(Kind.STOP)
        elif kind in _LINKS:
            self._linked(kind)
        elif kind in CONNECTORS:
            self._connected(kind)
        elif kind in _VERBS:
            self._verb(index, item)
        elif kind is Kind.REFERENCE and item.reference is not None:
            self._referred(index, item.reference)
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
            self._draft.negations += 1
        elif kind is Kind.COUNT and item.count is not None:
            self._draft.counts.append(item.count)
            self._draft.counted = bool(self._draft.operands)
        elif kind is Kind.CEASE:
            self._ceased()
        elif kind is Kind.OCCUR:
            self._draft.complete = True
        elif kind is Kind.IT_HAPPENS:
            following = self._items[index + 1] if index + 1 < len(self._items) else None
            if following is None or following.kind not in (*_VERBS, Kind.REFERENCE):
                self._pointed(situation=True)
        elif kind in (Kind.SUBJECT, Kind.FILLER, Kind.RELATIVE):
            self._subject(index, item)

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

    def _linked(self, kind: Kind) -> None:
        self._pause |= kind is Kind.COMMA
        strength = (None, Kind.COMMA, Kind.AND, Kind.OR, Kind.BUT, Kind.THEN, Kind.ONLY_THEN)
        if strength.index(kind) > strength.index(self._link):
            self._link = kind

    def _take_link(self) -> None:
        """The clause that begins here is joined by what stands before it."""
        self._draft.link, self._draft.pause = self._link, self._pause or self._draft.pause
        self._link, self._pause = None, False

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

    def _begins(self, index: int) -> bool:
        """Whether the item after this one begins a clause of its own."""
        for item in self._items[index + 1 :]:
            if item.kind in FLAGS:
                continue
            if item.kind in _VERBS:
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
            if item.kind in (Kind.NOT, Kind.NEVER, Kind.BE, Kind.MUST, Kind.ENSURE) or (
                item.kind in FLAGS
            ):
                continue
            return item.kind is Kind.OCCUR or (
                item.kind in _VERBS and item.form is Form.FINITE
            ) or item.kind is Kind.COUNT  # fmt: skip
        return False

    def _verb(self, index: int, item: Item) -> None:
        draft = self._draft
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
            if item.form is Form.GERUND and self._link in (Kind.AND, Kind.OR, Kind.COMMA):
                return
            self._close(self._link)
            draft = self._draft
        elif self._link is not None and draft.is_blank:
            self._take_link()
        self._link = None
        if item.text.split()[0] in _RETURNS:
            draft.flags.add(Kind.AGAIN)
        if draft.connector is not None and item.text.split()[0] in ("are", "is", "am"):
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

    def _ceased(self) -> None:
        """Read "never stop visiting a" as coming back to it, "stop visiting a" as avoiding it."""
        if self._draft.operands:
            self._close(self._link)
        if self._draft.negations % 2:
            self._draft.verb, self._draft.modality = Kind.PATROL, None
        else:
            self._draft.verb = Kind.AVOID
        self._draft.negations = 0

    def _modal(self, index: int, kind: Kind) -> None:
        draft = self._draft
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

    def _split(self) -> None:
        """The last operand of a subordinate clause is the subject of the main clause."""
        operand = self._draft.operands.pop()
        self._close(None)
        self._draft.operands.append(Operand(operand.reference, operand.negated))

    def _negation(self, index: int, kind: Kind) -> None:
        draft = self._draft
        if draft.lists and kind is Kind.NOT and (
            not draft.operands
            or (self._link in (Kind.AND, Kind.OR) and not self._forbids(index))
        ):  # fmt: skip
            draft.flipped = not draft.flipped if not draft.operands else True
            draft.shared = False
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

    def _forbids(self, index: int) -> bool:
        """Whether a "not" begins a prohibition: "... and do not go there"."""
        before = self._items[index - 1] if index else None
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        return (
            following is not None
            and following.form is Form.BASE
            and not (before is not None and before.kind is Kind.SUBJECT)
        )

    def _flagged(self, index: int, kind: Kind) -> None:
        if self._draft.operands and self._link is not None and self._begins(index):
            self._close(self._link)
        self._draft.flags.add(kind)

    def _subject(self, index: int, item: Item) -> None:
        draft = self._draft
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        if item.text in _POINTERS and not draft.operands and draft.verb is not None:
            self._pointed(situation=False)
            return
        if item.kind is not Kind.SUBJECT:
            return
        begins = following is not None and (
            following.kind in (Kind.MUST, Kind.MAY, Kind.NOT, Kind.NEVER, Kind.ENSURE)
            or following.kind in _VERBS
            or (following.kind is Kind.REFERENCE and following.form is not Form.NOUN)
        )
        listed = draft.lists and self._link in (Kind.AND, Kind.OR)
        if listed:
            draft.flipped = draft.shared = False
        if listed and begins and following is not None and following.kind in (
            *_VERBS, Kind.REFERENCE, Kind.NOT,
        ):  # fmt: skip
            return  # "when the one is so and you visit the other"
        if draft.operands and begins:
            self._close(self._link)
        elif not draft.operands and draft.is_blank and self._link is not None:
            self._take_link()
        if not self._draft.operands:
            self._draft.subject = True

    def _pointed(self, *, situation: bool) -> None:
        """A word that points back: to what was last said to be so, or to where one last was."""
        wanted = [
            each for each in self._last
            if situation == (each.shape is not Shape.PLACE) or each is self._last[0]
        ]  # fmt: skip
        if not wanted or self._draft.operands:
            return
        states = [each for each in wanted if each.shape is Shape.STATE and each.form is Form.FINITE]
        chosen = states[-1] if situation and states else wanted[-1]
        self._draft.operands.append(Operand(chosen, chosen.negated))

    def _referred(self, index: int, reference: Reference) -> None:
        draft = self._draft
        if draft.operands and self._opens(index, reference):
            self._close(self._link)
            draft = self._draft
        elif draft.is_blank and self._link is not None:
            self._take_link()
        if reference.form is Form.FINITE and draft.operands and reference.shape is Shape.STATE:
            draft.flipped = False
        if reference.never:
            draft.negations += 1
        if reference.lasting and draft.connector is None:
            draft.verb = Kind.STAY
            draft.flags.add(Kind.ALWAYS)
        if reference.obliged and draft.modality is None and draft.connector is None:
            draft.modality = Kind.MUST
        link = self._link
        if draft.operands and link in (None, Kind.COMMA, Kind.BUT):
            link = None
        if self._is_setting(reference):
            link = Kind.NOW
        draft.append(reference, link)
        self._pause = False
        self._last.append(reference)
        self._link = None
        if reference.form is Form.FINITE:
            draft.complete = True

    def _is_setting(self, reference: Reference) -> bool:
        """Whether a place only says where the act before it is done."""
        return (
            reference.form is Form.NOUN
            and self._link is None
            and bool(self._draft.operands)
            and self._draft.operands[-1].reference.shape is Shape.ACT
        )

    def _opens(self, index: int, reference: Reference) -> bool:
        """Whether a reference begins a clause, and does not continue the list before it."""
        draft = self._draft
        if draft.connector is not None and self._link in (Kind.THEN, Kind.ONLY_THEN):
            return True
        if draft.counted and self._link is not None:
            return True  # "one twice, then another"
        if reference.form is Form.NOUN:
            if self._is_setting(reference) and not self._is_passive(index):
                return False
            following = self._items[index + 1] if index + 1 < len(self._items) else None
            if following is not None and following.kind in (Kind.BEFORE, Kind.AFTER) and (
                draft.connector is not None and self._link in (Kind.AND, Kind.COMMA)
            ):  # fmt: skip
                return True  # "one before two, and two before three"
            if draft.connector is None:
                return self._link is Kind.BUT or (
                    draft.operands[-1].reference.form is not Form.NOUN
                    and self._link not in (Kind.AND, Kind.OR)
                )
            listed = self._link in (Kind.AND, Kind.OR)
            return (draft.complete and not listed) or (
                self._link is Kind.COMMA and (self._is_passive(index) or self._ends_list(index))
            )
        if reference.form is Form.GERUND:
            return self._link is Kind.BUT
        if reference.form is Form.FINITE:
            return not draft.lists or self._link in (None, Kind.COMMA, Kind.BUT)
        before = self._items[index - 1] if index else None
        if draft.lists and before is not None and before.kind in (Kind.SUBJECT, Kind.NOT):
            return self._link not in (Kind.AND, Kind.OR)
        return not (
            draft.connector is not None and self._link in (Kind.AND, Kind.OR)
            and any(item.kind in (Kind.COMMA, Kind.THEN) for item in self._items[index:])
        )  # fmt: skip

    def _ends_list(self, index: int) -> bool:
        """Whether no "and" or "or" follows that would make this a list."""
        return not any(
            item.kind in (Kind.AND, Kind.OR) for item in self._items[index + 1 : index + 4]
        )
