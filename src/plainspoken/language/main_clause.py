"""What a main clause asks for when nothing is subordinate to it."""

from __future__ import annotations

from collections.abc import Callable

from plainspoken.language.clause import Act, Clause, Operand
from plainspoken.language.grounding import Shape
from plainspoken.language.item import Count
from plainspoken.language.itinerary import Chain, Itinerary, count_pattern
from plainspoken.language.lexicon import Kind
from plainspoken.language.reference import Form
from plainspoken.logic.formula import (
    And,
    Atom,
    Eventually,
    Formula,
    conjunction,
    disjunction,
)
from plainspoken.logic.pattern import (
    AtLeast,
    DelayedReaction,
    Exactly,
    FutureAvoidance,
    GlobalAvoidance,
    Maintenance,
    Patrolling,
    PromptReaction,
    Remaining,
    SequencedVisit,
    Visit,
    Wait,
    negated,
)


class MainClauses:
    """Main clauses by themselves; what they ask for is added to the route."""

    def __init__(
        self, placeholder: Callable[[Operand], Atom], persists: Callable[[Operand], bool]
    ) -> None:
        self._placeholder = placeholder
        self._persists = persists
        self._route = Itinerary()
        self._before: Clause | None = None  # what "that" of "after that" points to
        self._permissions = 0
        self._remarks = 0

    def _one(self, operand: Operand) -> Formula:
        atom = self._placeholder(operand)
        return negated(atom) if operand.negated else atom

    def _all(self, clause: Clause) -> list[Formula]:
        parts: list[Formula] = []
        for operand in clause.operands:
            formula = self._one(operand)
            if operand.link is Kind.NOW and parts:
                parts[-1] = conjunction(parts[-1], formula)
            elif formula not in parts:
                parts.append(formula)
        return parts

    def _situation(self, clause: Clause) -> Formula:
        """What a clause says to be the case: its operands joined as they are."""
        parts = self._all(clause)
        either = any(operand.link is Kind.OR for operand in clause.operands)
        inner = disjunction(*parts) if either else conjunction(*parts)
        return negated(inner) if clause.act is Act.AVOID else inner

    def _steady(self, clause: Clause) -> bool:
        """Whether the situation of a clause persists."""
        return clause.act is Act.AVOID or all(map(self._persists, clause.operands))

    def _goes_on(self, main: Clause) -> bool:
        """Read "when a, b, then c" and "a until b, then c" as one: c comes after b."""
        if main.link is not Kind.THEN or main.act is not Act.DO or main.counts:
            return False
        sequel = SequencedVisit(tuple(self._all(main))).literal
        match self._route.last:
            case DelayedReaction(a, b):
                self._route.patterns[-1] = DelayedReaction(a, _followed(b, sequel))
            case PromptReaction(a, b, persists):
                self._route.patterns[-1] = PromptReaction(a, _followed(b, sequel), persists)
            case Wait(kept, until):
                self._route.patterns[-1] = Wait(kept, _followed(until, sequel))
            case _:
                return False
        return True

    def _alone(self, main: Clause) -> None:
        """A main clause without a subordinate one."""
        parts = self._all(main)
        flags = main.flags
        if self._points_back(main, parts):
            return
        if main.counts:
            self._counted(main, parts)
        elif main.act is Act.AVOID:
            self._avoided(main, parts)
        elif (
            main.modality is Kind.MAY
            and Kind.BEFORE_THAT not in flags
            and not self._continues(main)
        ):
            self._permissions += 1
        elif main.act is Act.PATROL:
            self._route.add(Patrolling(tuple(parts)))
        elif main.act is Act.STAY:
            always = Kind.ALWAYS in flags and Kind.LATER not in flags
            self._route.add((Maintenance if always else Remaining)(tuple(parts)))
        elif Kind.ALWAYS in flags and (main.assured or is_state(main)):
            kept = Remaining if Kind.LATER in flags else Maintenance
            self._route.add(kept((self._situation(main),)))
        elif _is_remark(main):
            self._remarks += 1
        elif Kind.NOW in flags and len(parts) > 1:
            self._route.add(Visit((self._situation(main),)))
        else:
            self._visited(main, parts)

    def _continues(self, main: Clause) -> bool:
        return main.link in (Kind.THEN, Kind.ONLY_THEN) and self._route.chain is not None

    def _points_back(self, main: Clause, parts: list[Formula]) -> bool:
        """Take the clause before for a trigger: "you can go to a, but not to b after that"."""
        before, flags = self._before, main.flags
        if before is None or not before.operands:
            return False
        prompt = Kind.RIGHT_AFTER_THAT in flags or (
            Kind.AFTER_THAT in flags and bool(flags & {Kind.NEXT, Kind.NEXT_INSTANT})
        )
        trigger = self._situation(before)
        if main.act is Act.AVOID and Kind.AFTER_THAT in flags and before.act is Act.DO:
            for each in parts:
                self._route.add(FutureAvoidance(trigger, negated(each) if is_state(main) else each))
            return True
        if main.act is Act.DO and before.modality is Kind.MAY:
            response = self._response(main, parts)
            if prompt:
                self._route.add(PromptReaction(trigger, response, self._steady(before)))
                return True
            if Kind.AFTER_THAT in flags:
                self._route.add(DelayedReaction(trigger, response))
                return True
        return False

    def _response(self, main: Clause, parts: list[Formula]) -> Formula:
        either = any(operand.link is Kind.OR for operand in main.operands)
        return disjunction(*parts) if either else conjunction(*parts)

    def _avoided(self, main: Clause, parts: list[Formula]) -> None:
        chain = self._route.chain
        if Kind.NO_OTHER in main.flags and self._route.bind(parts):
            return
        last = self._route.patterns[-1] if self._route.patterns else None
        if (
            Kind.AGAIN in main.flags
            and isinstance(last, (AtLeast, Exactly))
            and [last.place] == parts
        ):
            self._route.patterns[-1] = Exactly(last.place, last.times)
            return
        on_the_way = chain is not None and all(part in chain.places for part in parts)
        if chain is not None and on_the_way and Kind.AGAIN in main.flags:
            # "... and do not visit it again": said of a place already on the way.
            chain.strict = True
        elif chain is not None and main.link in (Kind.AND, Kind.BUT, Kind.COMMA, None):
            # "go to a but not to b, then to b": b is to wait, if it is on the way at all.
            self._route.guards += [(part, chain.places[-1]) for part in parts]
        else:
            self._route.add(GlobalAvoidance(tuple(parts)))

    def _counted(self, main: Clause, parts: list[Formula]) -> None:
        if self._route.chain is not None and self._continues(main) and _is_once(main):
            self._route.chain.places += parts
            self._route.chain.strict = True
            return
        chain = self._route.chain
        if chain is not None and _is_once(main) and all(p in chain.places[:-1] for p in parts):
            chain.strict = True
            return
        for part in parts:
            for count in main.counts:
                self._route.add(count_pattern(part, count, forbidden=main.act is Act.AVOID))
        if _is_once(main) and len(parts) == 1:
            # "visit a exactly once, then b": it may yet turn out to begin an order.
            self._route.patterns.pop()
            self._route.chain = Chain(parts, strict=True)
            self._route.add(self._route.chain)

    def _visited(self, main: Clause, parts: list[Formula]) -> None:
        flags = main.flags
        if any(operand.link is Kind.OR for operand in main.operands):
            self._route.add(Visit((disjunction(*parts),)))
            return
        then = any(operand.link in (Kind.THEN, Kind.ONLY_THEN) for operand in main.operands)
        ordered = Kind.IN_ORDER in flags or any(
            operand.link is Kind.ONLY_THEN for operand in main.operands
        )
        linked = main.link in (Kind.THEN, Kind.ONLY_THEN) or bool(
            flags & {Kind.AFTER_THAT, Kind.RIGHT_AFTER_THAT, Kind.NTH}
        )
        if Kind.BEFORE_THAT in flags and self._route.chain is not None:
            self._route.chain.places[-1:-1] = parts
            self._route.chain.ordered = True
            return
        last = self._route.patterns[-1] if self._route.patterns else None
        if linked and self._route.chain is None and isinstance(last, Visit):
            # "a and b, then c": c after each of them.
            self._route.patterns[-1:] = [Chain([place, *parts]) for place in last.places]
            return
        if linked and self._route.chain is not None:
            self._route.chain.places += parts
            self._route.chain.ordered |= main.link is Kind.ONLY_THEN
            self._route.chain.strict |= Kind.NO_RETURN in flags
            return
        if len(parts) == 1 or then or ordered or flags & {Kind.SEQUENCE, Kind.NO_RETURN}:
            self._route.chain = Chain(parts, ordered, Kind.NO_RETURN in flags)
            self._route.add(self._route.chain)
        else:
            self._route.add(Visit(tuple(parts)))
            self._route.chain = None


def _followed(formula: Formula, sequel: Formula) -> Formula:
    """The formula, and the sequel after the last thing that it already goes on to."""
    match formula:
        case And((*parts, Eventually(later))):
            return conjunction(*parts, Eventually(_followed(later, sequel)))
        case _:
            return conjunction(formula, sequel)


def is_state(clause: Clause) -> bool:
    """Whether a clause tells of a state as it is: "the tank is full"."""
    return any(
        operand.reference.shape is Shape.STATE and operand.reference.form is Form.FINITE
        for operand in clause.operands
    )


def _is_remark(clause: Clause) -> bool:
    """Whether a main clause only says how things are: "the tank is full"."""
    return (
        clause.modality is None
        and not clause.wished
        and not clause.flags
        and clause.link in (None, Kind.STOP, Kind.COMMA, Kind.AND)
        and all(
            operand.reference.shape is Shape.STATE and operand.reference.form is Form.FINITE
            for operand in clause.operands
        )
    )


def _is_once(clause: Clause) -> bool:
    return clause.act is Act.DO and clause.counts in ((Count("=", 1),), (Count("", 1),))
