"""What is asked for when, or right before, something is the case."""

from __future__ import annotations

from itertools import pairwise

from plainspoken.language.clause import Act, Clause
from plainspoken.language.counting import Count
from plainspoken.language.expression import Shape
from plainspoken.language.itinerary import Chain
from plainspoken.language.lexicon import Kind
from plainspoken.language.main_clause import MainClauses
from plainspoken.logic.formula import (
    Formula,
    Next,
    conjunction,
)
from plainspoken.logic.pattern import (
    AtMost,
    BoundDelay,
    BoundReaction,
    DelayedReaction,
    FutureAvoidance,
    InstantaneousReaction,
    PastAvoidance,
    PromptPrecedence,
    PromptReaction,
    negated,
)


class Reactions(MainClauses):
    """Main clauses that answer to a condition, or follow another one."""

    def _reaction(
        self, main: Clause, clause: Clause, trigger: Formula, parts: list[Formula]
    ) -> None:
        flags = main.flags | clause.flags
        if main.act is Act.AVOID and not main.counts:
            self._reaction_forbidden(main, clause, trigger, parts)
            return
        response = self._response(main, parts)
        steady = self._steady(clause)
        prompt = clause.connector is Kind.PROMPTLY or bool(
            flags & {Kind.NEXT, Kind.NEXT_INSTANT, Kind.RIGHT_AFTER_THAT}
        )
        if Kind.NO_OTHER in flags:
            self._route.add(
                (BoundDelay(trigger, response, steady))
                if prompt
                else BoundReaction(trigger, response)
            )
        elif main.link is Kind.ONLY_THEN and prompt:
            self._route.add(BoundDelay(trigger, response, steady))
        elif main.link is Kind.ONLY_THEN:
            for part in parts:
                self._route.add(PastAvoidance(part, trigger))
        elif prompt:
            self._route.add(PromptReaction(trigger, response, steady))
        elif Kind.NOW in flags or main.act is Act.STAY or self._is_at_once(main, clause):
            self._route.add(InstantaneousReaction(trigger, response))
        elif clause.connector is Kind.AFTER and clause.counts == (Count("=", 1),):
            self._once_before(self._all(clause), parts)
        elif clause.connector is Kind.AFTER and self._is_journey(main, clause):
            self._extend(clause, parts)
        elif main.modality is Kind.MAY:
            self._permissions += 1
        elif response == conjunction(*parts) and all(
            operand.reference.shape is Shape.PLACE for operand in main.operands
        ):
            for place in parts:  # nobody is at two places at once
                self._route.add(DelayedReaction(trigger, place))
        else:
            self._route.add(DelayedReaction(trigger, response))

    def _is_at_once(self, main: Clause, clause: Clause) -> bool:
        """Whether "whenever a, it must be so" tells of a state that holds while a does."""
        return (
            clause.connector in (Kind.WHEN, Kind.WHENEVER)
            and Kind.BE in main.flags
            and not main.flags & {Kind.LATER, Kind.LATER_ON, Kind.AFTER_THAT, Kind.AGAIN}
            and Kind.ALREADY not in clause.flags
            and all(o.reference.shape is not Shape.ACT for o in main.operands)
        )

    def _is_journey(self, main: Clause, clause: Clause) -> bool:
        """Whether "after a, b" tells where to go next, and not what to do whenever."""
        places = all(
            operand.reference.shape is Shape.PLACE for operand in (*main.operands, *clause.operands)
        )
        return places and main.modality is None and not main.flags & {Kind.LATER, Kind.LATER_ON}

    def _extend(self, clause: Clause, parts: list[Formula]) -> None:
        earlier = self._all(clause)
        chain = self._route.chain
        if chain is not None and earlier == chain.places[-1:]:
            chain.places += parts
        elif chain is not None and parts == chain.places[:1]:
            chain.places[:0] = earlier
        else:
            self._route.begin(Chain([*earlier, *parts], ordered=Kind.IN_ORDER in clause.flags))

    def _reaction_forbidden(
        self, main: Clause, clause: Clause, trigger: Formula, parts: list[Formula]
    ) -> None:
        states = all(o.reference.shape is Shape.STATE for o in clause.operands)
        later = main.flags & {Kind.LATER, Kind.LATER_ON}
        same = (
            clause.connector in (Kind.WHEN, Kind.WHENEVER)
            and not later
            and (states or Kind.BE in clause.flags)
        )
        unvisited = (
            same
            and (clause.act is Act.AVOID or all(o.negated for o in clause.operands))
            and all(o.reference.shape is Shape.PLACE for o in (*main.operands, *clause.operands))
        )
        for part in parts:
            lasting = main.flags & {Kind.AFTER_THAT, Kind.ALWAYS, Kind.AGAIN}
            if (clause.connector is Kind.PROMPTLY and not lasting) or (
                Kind.NEXT_INSTANT in main.flags
            ):
                self._route.add(PromptReaction(trigger, negated(part), self._steady(clause)))
            elif part == trigger:
                # "never again once you have been there three times"
                times = max((count.times for count in clause.counts), default=1)
                self._route.add(AtMost(part, times))
            elif unvisited:
                # "not b if you have not been to a"
                self._route.add(PastAvoidance(part, negated(trigger)))
            elif (same and Kind.AFTER_THAT not in main.flags) or Kind.NOW in main.flags:
                self._route.add(InstantaneousReaction(trigger, negated(part)))
            elif clause.connector in (Kind.WHEN, Kind.WHENEVER) and (
                clause.act is Act.AVOID or all(o.negated for o in clause.operands)
            ):
                # "not b if you have not been to a"
                self._route.add(PastAvoidance(part, negated(trigger)))
            else:
                self._route.add(FutureAvoidance(trigger, part))

    def _once_before(self, parts: list[Formula], later: list[Formula]) -> None:
        """Read "a exactly once before b": a strict order."""
        chain = self._route.chain
        if chain is not None and [*parts, *later] in map(list, pairwise(chain.places)):
            chain.strict = True
        elif chain is not None and chain.places[-1:] == parts:
            chain.places += later
            chain.strict = True
        elif chain is not None and chain.places == later:
            chain.places[:0] = parts
            chain.strict = True
        else:
            self._route.begin(Chain([*parts, *later], strict=True))

    def _is_tour(self, main: Clause, clause: Clause) -> bool:
        return main.modality is None and all(
            operand.reference.shape is Shape.PLACE for operand in (*main.operands, *clause.operands)
        )

    def _right_before(
        self, main: Clause, clause: Clause, trigger: Formula, parts: list[Formula]
    ) -> None:
        for part in parts:
            if main.act is Act.AVOID:
                self._route.add(InstantaneousReaction(part, negated(Next(trigger))))
            else:
                self._route.add(
                    PromptPrecedence(part, trigger, all(map(self._persists, main.operands)))
                )
