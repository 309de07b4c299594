"""Words that turn a clause already read into another: its negation, its consequence."""

from __future__ import annotations

from dataclasses import replace

from plainspoken.language.clause import Act, Operand
from plainspoken.language.lexicon import Kind
from plainspoken.language.operand import OperandReader
from plainspoken.language.reference import Form


class Turns(OperandReader):
    """What is said behind operands and changes what is asked of them."""

    def _leads(self) -> None:
        """What was said so far calls for what follows: "a must be followed by b"."""
        draft = self._draft
        if not draft.operands or draft.connector is not None:
            return
        if any(each.link is Kind.THEN for each in draft.operands):
            self._link = Kind.THEN  # "a, followed by b, which is to be followed by c"
            return
        draft.connector, draft.modality = Kind.AFTER, None
        flags, draft.flags = draft.flags, set()
        self._close(Kind.COMMA)
        self._draft.modality = Kind.MUST
        self._draft.flags = flags - {Kind.ALWAYS, Kind.BE}

    def _bars(self) -> None:
        """Once what was said so far has been, what follows may not be: "a closes b to you"."""
        draft = self._draft
        if draft.operands and draft.connector is None:
            draft.connector, draft.modality = Kind.AFTER, None
            self._close(Kind.COMMA)
            self._draft.negations = 1
            self._draft.flags.add(Kind.AFTER_THAT)

    def _releases(self) -> None:
        """What follows lasts until what was said so far: "a releases b"."""
        draft = self._draft
        if draft.operands and draft.connector is None:
            draft.connector, draft.modality = Kind.UNTIL, None
            self._close(Kind.COMMA)
            self._draft.verb = Kind.STAY

    def _preceded(self) -> None:
        """What follows must come before what was said so far: "a must be preceded by b"."""
        draft = self._draft
        if draft.pronoun and not draft.operands:
            self._pointed(situation=False)
        if draft.operands and draft.connector is None:
            draft.negations += 1
            self._close(None, Kind.UNTIL)

    def _forbidden(self) -> None:
        """Said of the operands before; of the main clause where "a while b is forbidden"."""
        draft = self._draft
        if draft.connector is None or not draft.operands:
            draft.negations += 1
        elif self._done and self._done[-1].connector is None and draft.link is None:
            if self._done[-1].act is Act.DO:
                self._done[-1] = replace(self._done[-1], act=Act.AVOID)
        elif draft.connector in (Kind.WHEN, Kind.WHENEVER, Kind.AFTER, Kind.PROMPTLY):
            if len(draft.operands) > 1 and draft.operands[-1].link is None:
                self._split()  # "once you have been to a b is closed to you"
                self._draft.negations = 1
            else:
                draft.complete = True  # "once a is over"

    def _with_what_is_asked(self) -> None:
        """Read "one full and the other empty?" as one condition."""
        draft = self._draft
        before = self._done[-1] if self._done else None
        joined = draft.link is Kind.AND and before is not None and before.connector is None
        if not joined or before is None or before.modality is not None or before.act is not Act.DO:
            return
        if all(each.reference.form is Form.FINITE for each in before.operands):
            self._done.pop()
            first, *rest = draft.operands
            draft.operands = [*before.operands, replace(first, link=Kind.AND), *rest]
            draft.link = before.link

    def _otherwise(self) -> None:
        """What follows is asked for where the condition before is not so; without one, it is or."""
        clauses = (*self._done, *([self._draft.clause()] if self._draft.operands else ()))
        if any(each.connector in (Kind.WHEN, Kind.WHENEVER, Kind.WHILE) for each in clauses):
            if self._draft.operands:
                self._close(Kind.STOP)
            self._draft.flags.add(Kind.OTHERWISE)
            self._link = None
        elif self._draft.operands:
            self._link = Kind.OR

    def _either_of(self) -> None:
        if self._draft.is_blank and self._link is not Kind.OR:
            self._take_link()
        self._link = None
        self._draft.either = True

    def _ceased(self) -> None:
        """Read "never stop visiting a" as coming back to it, "stop visiting a" as avoiding it."""
        if self._draft.operands:
            self._close(self._link)
        if self._draft.negations % 2:
            self._draft.verb, self._draft.modality = Kind.PATROL, None
        else:
            self._draft.verb = Kind.AVOID
        self._draft.negations = 0

    def _behind(self) -> None:
        """Deny the last operand; of several, it becomes a clause of its own."""
        draft = self._draft
        if draft.negations % 2:
            return  # "do not go there, not even once"
        if len(draft.operands) == 1 or draft.connector is not None:
            draft.negations += 1
            return
        operand = draft.operands.pop()
        self._close(Kind.AND)
        self._draft.operands.append(replace(operand, link=None))
        self._draft.negations = 1

    def _split(self) -> None:
        """The last operand of a subordinate clause is the subject of the main clause."""
        operand = self._draft.operands.pop()
        self._close(None)
        self._draft.operands.append(Operand(operand.reference, operand.negated))
