"""Words that point back: "it", "there", "both", "that happens"."""

from __future__ import annotations

from dataclasses import replace

from plainspoken.language.clause import Act, Operand
from plainspoken.language.draft import Draft
from plainspoken.language.expression import Shape
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.lookahead import Lookahead
from plainspoken.language.reference import Form, Reference


class Pointers(Lookahead):
    """What a pointing word adds to the clause that is being read."""

    def _all_of(self, index: int, item: Item) -> None:
        """Read "both", "all three": what was last spoken of, or only the operands that follow."""
        following = self._items[index + 1] if index + 1 < len(self._items) else None
        before = self._items[index - 1] if index else None
        if following is not None and following.kind is Kind.REFERENCE:
            if before is not None and before.kind in (Kind.NOT, Kind.NEVER):
                self._draft.flags.add(Kind.NOW)
            return
        draft = self._draft
        if draft.operands:
            if self._link is None or (self._link is Kind.COMMA and draft.modality is None and (
                following is None or following.kind in (Kind.COMMA, Kind.STOP)
            )):  # fmt: skip
                return
            self._close(self._link)
        elif draft.is_blank and self._link is not None:
            self._take_link()
        self._link = None
        most = {"both": 2, "two": 2, "three": 3, "four": 4}
        number = next((most[word] for word in item.text.split() if word in most), len(self._last))
        chosen: dict[str, Reference] = {}
        for each in reversed(self._last):
            if len(chosen) < number:
                chosen.setdefault(each.symbol, each)
        for each in reversed(chosen.values()):
            self._draft.append(each, Kind.AND if self._draft.operands else None)
        self._draft.pointed = bool(chosen)

    def _pointed(self, *, situation: bool) -> None:
        """A word that points back: to what was last said to be so, or to where one last was."""
        wanted = [
            each for each in self._last
            if situation == (each.shape is not Shape.PLACE) or each is self._last[0]
        ]  # fmt: skip
        if not wanted or self._draft.operands:
            return
        topic = self._topic() if not situation and self._draft.connector is None else ()
        if topic:
            self._draft.operands += topic
            self._draft.pointed = True
            return
        states = [each for each in wanted if each.shape is Shape.STATE and each.form is Form.FINITE]
        chosen = states[-1] if situation and states else wanted[-1]
        self._draft.operands.append(Operand(chosen, chosen.negated))

    def _points_at_topic(self) -> bool:
        """Let a pronoun stand for the place that the main clause before is about."""
        topic = self._topic()
        if not topic or topic[0].reference.shape is not Shape.PLACE:
            return False
        self._draft.operands += topic
        self._draft.pointed = True
        self._link = None
        return True

    def _topic(self) -> tuple[Operand, ...]:
        """The operands of the main clause before, where another one belongs to it.

        "avoid a until b, then visit it": it is a.
        """
        if len(self._done) < 2 or self._done[-1].connector is None:
            before = self._done[-1] if self._done else None
            rest = self._done[:-1]
            mixed = (
                before is not None
                and before.connector is None
                and rest
                and (rest[-1].connector is not None and before.link is Kind.COMMA)
            )
            return before.operands if before is not None and mixed else ()
        main = next((each for each in reversed(self._done) if each.connector is None), None)
        return tuple(replace(each, link=None) for each in main.operands[:1]) if main else ()

    def _is_left(self, draft: Draft) -> bool:
        """Whether a place is left where one was just told to go: "go there, then leave it"."""
        before = self._done[-1] if self._done else None
        return (
            draft.verb is Kind.LEAVE
            and not draft.negations
            and not draft.flags
            and draft.connector is None
            and before is not None
            and before.connector is None
            and before.act is Act.DO
            and [each.reference.symbol for each in before.operands][-1:]
            == [each.reference.symbol for each in draft.operands]
        )

    def _close(self, link: Kind | None, connector: Kind | None = None) -> None:
        """End the clause that is being read and begin another."""
        draft = self._draft
        if draft.pronoun and not draft.operands and draft.connector is None and draft.verb:
            self._pointed(situation=False)
        if draft.counts and not draft.operands and draft.connector is None and (
            draft.verb is None and Kind.AGAIN not in draft.flags
        ):  # fmt: skip
            self._pointed(situation=False)  # "as to a, twice is the limit"
        open_end = draft.connector is not None or draft.negations > 0
        if self._is_left(draft):
            link = self._draft.link if link is None else link
        elif self._draft.operands or self._draft.counts or self._draft.flags or open_end:
            self._done.append(self._draft.clause())
        elif self._draft.link is not None and connector is None and link is None:
            link = self._draft.link
        pause = self._pause or link is Kind.STOP
        self._draft = Draft(connector=connector, link=link, pause=pause)
        self._link, self._pause = None, False
