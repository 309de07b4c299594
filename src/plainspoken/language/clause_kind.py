"""What kind of thing a clause tells of: a place, a state, an errand, a remark."""

from __future__ import annotations

from plainspoken.language.clause import Act, Clause
from plainspoken.language.counting import Count
from plainspoken.language.expression import Shape
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form


def drops(clause: Clause | None) -> bool:
    """Whether a clause only picks something up or puts it down, which one goes on from."""
    errands = [each.reference.errand for each in clause.operands] if clause is not None else []
    return len(errands) == 1 and any(
        each is not None and each.carries and not each.travels for each in errands
    )


def is_errand(clause: Clause) -> bool:
    """Whether a clause tells of something that is carried or put down, and of nothing else."""
    errands = [operand.reference.errand for operand in clause.operands]
    return len(errands) == 1 and errands[0] is not None and (
        errands[0].travels or (errands[0].carries and len(errands[0].stops[0]) == 1)
    )  # fmt: skip


def is_place(clause: Clause) -> bool:
    """Whether a clause only speaks of places."""
    return all(operand.reference.shape is Shape.PLACE for operand in clause.operands)


def is_bound(main: Clause) -> bool:
    """Whether a permission is one for nothing else: "only at b", "and nowhere else"."""
    return main.modality is Kind.MAY and bool(main.flags & {Kind.ONLY, Kind.NO_OTHER})


def is_state(clause: Clause) -> bool:
    """Whether a clause tells of a state as it is: "the tank is full"."""
    return any(
        operand.reference.shape is Shape.STATE and operand.reference.form is Form.FINITE
        for operand in clause.operands
    )


def is_remark(clause: Clause) -> bool:
    """Whether a main clause only says how things are: "the tank is full"."""
    return (
        clause.modality is None
        and not clause.wished
        and clause.told
        and not clause.flags - {Kind.BE}
        and clause.link in (None, Kind.STOP, Kind.COMMA, Kind.AND)
        and all(
            operand.reference.shape is Shape.STATE and operand.reference.form is Form.FINITE
            for operand in clause.operands
        )
    )


def is_once(clause: Clause) -> bool:
    """Whether a clause asks for exactly one visit."""
    return clause.act is Act.DO and clause.counts in ((Count("=", 1),), (Count("", 1),))
