"""A clause while it is read."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from plainspoken.language.clause import Act, Clause, Operand
from plainspoken.language.counting import Count
from plainspoken.language.expression import Shape
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form, Reference


@dataclass(slots=True)
class Draft:
    """What has been read of a clause so far."""

    connector: Kind | None = None
    link: Kind | None = None
    verb: Kind | None = None
    negations: int = 0
    operands: list[Operand] = field(default_factory=list)
    modality: Kind | None = None
    flags: set[Kind] = field(default_factory=set)
    counts: list[Count] = field(default_factory=list)
    subject: bool = False
    complete: bool = False
    assured: bool = False
    wished: bool = False
    pause: bool = False
    flipped: bool = False  # a "not" that goes for the operands that follow
    counted: bool = False  # a count stands behind an operand
    shared: bool = False  # the operand before stands under the same "not"
    told: bool = False  # a copula tells how things are
    either: bool = False  # one of the operands will do
    pointed: bool = False  # it only points back to what was spoken of
    apart: bool = False  # each operand for itself: "neither a nor b", "no site"
    starts: set[int] = field(default_factory=set)
    being: bool = False  # "you are ...", before a place
    denied: bool = False  # "not until", and not "only after"
    pronoun: bool = False  # its subject is "it", "they"

    @property
    def is_blank(self) -> bool:
        return not (self.operands or self.verb or self.connector or self.flags or self.counts)

    def clause(self) -> Clause:
        """What has been read; "do not leave a place" is to stay there."""
        negated = self.negations % 2 == 1
        if self.connector is Kind.WITHOUT and self.verb is Kind.LEAVE and not negated:
            # "without leaving a" is while staying there all the time
            self.connector, self.verb = Kind.WHILE, Kind.STAY
            self.flags.add(Kind.ALWAYS)
        match self.verb:
            case Kind.LEAVE if self.operands and all(
                each.reference.shape is Shape.STATE for each in self.operands
            ):
                act = Act.AVOID if negated else Act.STAY  # "do not leave it open"
            case Kind.LEAVE:
                act = Act.STAY if negated else Act.AVOID
            case Kind.AVOID:
                act = Act.DO if negated else Act.AVOID
            case Kind.STAY if not negated and self.operands and all(
                each.reference.shape is Shape.ACT and each.reference.form is Form.GERUND
                for each in self.operands
            ):  # fmt: skip
                act = Act.PATROL  # "keep using it"
            case Kind.STAY if not negated:
                act = Act.STAY
            case Kind.PATROL if not negated:
                act = Act.PATROL
            case _:
                act = Act.AVOID if negated else Act.DO
        if Kind.AGAIN_AND_AGAIN in self.flags and act is Act.DO:
            act = Act.PATROL
        if self._is_joint(act):
            self.flags.add(Kind.NOW)
        operands = tuple(self.operands)
        joined = all(each.link is not Kind.OR for each in operands)
        if (
            self.connector is None and act is Act.DO and operands and joined
            and all(each.negated for each in operands) and Kind.LATER not in self.flags
            and all(self.assured or each.reference.form is Form.FINITE for each in operands)
        ):  # fmt: skip
            # "make sure that it is not so" forbids it.
            act = Act.AVOID
            operands = tuple(replace(each, negated=False) for each in operands)
        return Clause(
            self.connector, self.link, act, operands, self.modality,
            frozenset(self.flags), tuple(self.counts), self.subject, self.assured,
            self.wished, self.pause, self.told, self.pointed, self.denied,
        )  # fmt: skip

    def _is_joint(self, act: Act) -> bool:
        """Whether "never a full and b empty" forbids the two together."""
        return (
            act is Act.AVOID
            and self.connector is None
            and len(self.operands) > 1
            and not self.apart
            and all(each.link is Kind.AND for each in self.operands[1:])
            and all(
                each.reference.shape is Shape.STATE and each.reference.form is Form.FINITE
                for each in self.operands
            )
            and self.verb is not Kind.AVOID
        )

    @property
    def lists(self) -> bool:
        """Whether it tells what is the case, so that "and" may go on telling it."""
        return self.connector is not None or self.assured

    def append(self, reference: Reference, link: Kind | None) -> None:
        """Add an operand; "not a or b" is neither of them."""
        if self.either and self.operands and link is not Kind.NOW:
            link = Kind.OR
        if self.flipped and self.shared and link is Kind.OR:
            link = Kind.AND
        self.shared = self.flipped
        self.operands.append(Operand(reference, reference.negated != self.flipped, link))
