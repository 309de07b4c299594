"""References taken into the clause that is being read, or opening another."""

from __future__ import annotations

from collections.abc import Sequence

from plainspoken.language.clause import Act
from plainspoken.language.expression import Shape
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.pointing import Pointers
from plainspoken.language.reference import Form, Reference

COPULA_FORMS = frozenset(("is", "are", "am", "was", "were", "'s"))

BEING = frozenset(("be", *COPULA_FORMS))


def _is_standing(said: Sequence[str]) -> bool:
    """Whether a state is said to be so, and not to be brought about."""
    return not BEING.isdisjoint(said) and not (
        said[-1].endswith("ed") or not {"get", "gets", "become", "becomes"}.isdisjoint(said)
    )


class OperandReader(Pointers):
    """Where a reference belongs: to the list before it, or to a clause of its own."""

    def _referred(self, index: int, item: Item) -> None:
        reference = item.reference
        if reference is None:
            return
        draft = self._draft
        further = self._nor
        if self._nor:
            self._nor = False
        elif draft.operands and self._opens(index, reference):
            connector = draft.connector
            self._close(self._link)
            draft = self._draft
            following = self._items[index + 1] if index + 1 < len(self._items) else None
            main = next((each for each in reversed(self._done) if each.connector is None), None)
            if connector and main and following and following.kind is connector:
                # "do not go to a until b, or to c until d"
                draft.negations = int(main.act is Act.AVOID)
                draft.modality = main.modality
        elif draft.is_blank and self._link is not None:
            self._take_link()
        told = reference.form is Form.FINITE and reference.shape is Shape.STATE
        if told and draft.operands and not further:
            draft.flipped = False
        if reference.never:
            draft.negations += 1
        if reference.lasting and draft.connector is None:
            draft.verb = Kind.STAY
            draft.flags.add(Kind.ALWAYS)
        if reference.obliged and draft.modality is None and draft.connector is None:
            draft.modality = Kind.MUST
        if item.filled and reference.shape is Shape.PLACE and not draft.operands and (
            draft.connector is None and self._points_at_topic()
        ):  # fmt: skip
            return
        draft.apart |= item.start in draft.starts
        draft.starts.add(item.start)
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
        said = self._items[index].text.split()
        draft.told |= not COPULA_FORMS.isdisjoint(said) and reference.shape is not Shape.PLACE
        if draft.connector is None:
            standing = reference.shape is Shape.STATE and _is_standing(said)
            if standing or (draft.being and reference.shape is Shape.PLACE):
                draft.flags.add(Kind.BE)
        elif not BEING.isdisjoint(said) or (draft.being and reference.shape is Shape.PLACE):
            draft.flags.add(Kind.BE)

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
            same = following is not None and following.kind is draft.connector
            if following is not None and (following.kind in (Kind.BEFORE, Kind.AFTER) or same) and (
                draft.connector is not None and self._link in (Kind.AND, Kind.COMMA, Kind.OR)
            ):  # fmt: skip
                return True  # "one before two, and two before three"
            if draft.connector is None:
                told = following is not None and following.kind in (
                    Kind.BE, Kind.MUST, Kind.MAY, Kind.FORBIDDEN,
                )  # fmt: skip
                again = draft.operands[-1].reference.symbol == reference.symbol
                if told and (draft.being or again) and self._link in (Kind.AND, Kind.COMMA):
                    return True  # "the one is your next stop, and the other is ..."
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
            if draft.negations % 2 and self._link in (Kind.AND, Kind.OR) and not (
                reference.obliged or not COPULA_FORMS.isdisjoint(self._items[index].text.split())
            ):  # fmt: skip
                return False  # "never have a full and b empty"
            if draft.connector is not None and self._link is Kind.BUT and not self._pause and (
                reference.shape is Shape.STATE and not reference.obliged
            ):  # fmt: skip
                self._link = Kind.AND  # "if the one is so but the other is not"
                return False
            return not draft.lists or self._link in (None, Kind.COMMA, Kind.BUT)
        before = self._items[index - 1] if index else None
        if draft.lists and before is not None and before.kind in (Kind.SUBJECT, Kind.NOT):
            return self._link not in (Kind.AND, Kind.OR)
        return not (
            draft.connector is not None and self._link in (Kind.AND, Kind.OR)
            and any(item.kind in (Kind.COMMA, Kind.THEN) for item in self._items[index:])
        )  # fmt: skip
