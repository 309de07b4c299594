"""Statements to mission patterns over placeholders: the symbolic translation, by construction.

Source: Argenziano et al., section on symbolic translation; there a trained model does this step.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from plainspoken.language.clause import Act, Clause, Operand, Statement
from plainspoken.language.clause_kind import drops, is_errand, is_once, is_place
from plainspoken.language.counting import Count
from plainspoken.language.expression import Shape
from plainspoken.language.itinerary import Chain
from plainspoken.language.lexicon import Kind
from plainspoken.language.reaction import Reactions
from plainspoken.logic.formula import (
    Atom,
    Formula,
    Until,
    conjunction,
    disjunction,
)
from plainspoken.logic.pattern import (
    BoundDelay,
    BoundReaction,
    Choice,
    DelayedReaction,
    GlobalAvoidance,
    GuardedVisit,
    InstantaneousReaction,
    Maintenance,
    PastAvoidance,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    Remaining,
    Visit,
    Wait,
    negated,
)

_SPECIFIC = (Kind.RIGHT_AFTER_THAT, Kind.NEXT, Kind.NEXT_INSTANT)


@dataclass(frozen=True, slots=True)
class Lifted:
    """The patterns of an utterance, all of which are to hold, and what asks for nothing.

    permissions: clauses that only allow
    remarks:     clauses that only tell what is the case
    """

    patterns: tuple[Pattern, ...]
    permissions: int = 0
    remarks: int = 0


def lifted(
    said: Sequence[Statement],
    placeholder: Callable[[Operand], Atom],
    persists: Callable[[Operand], bool],
) -> Lifted:
    """The patterns that an utterance asks for, over the placeholders of its operands."""
    return _Lifter(placeholder, persists).lifted(said)


class _Lifter(Reactions):
    """Main clauses together with what belongs to them."""

    def lifted(self, said: Sequence[Statement]) -> Lifted:
        for options in _options(said):
            if len(options) == 1:
                for statement in options[0]:
                    self._statement(statement)
            else:
                self._choice(options)
        return Lifted(_entered(self._route.merged()), self._permissions, self._remarks)

    def _choice(self, options: Sequence[Sequence[Statement]]) -> None:
        found = [_Lifter(self._placeholder, self._persists).lifted(each) for each in options]
        self._permissions += sum(each.permissions for each in found)
        self._remarks += sum(each.remarks for each in found)
        if all(each.patterns for each in found):
            self._route.add(Choice(tuple(each.patterns for each in found)))
        self._route.chain = None

    def _statement(self, statement: Statement) -> None:
        main = statement.main
        subordinates = [each for each in statement.subordinates if each.operands]
        again = Kind.AGAIN in main.flags and (main.act is Act.AVOID or bool(main.counts))
        self._route.no_return |= any(
            Kind.NO_RETURN in each.flags for each in statement.subordinates
        )
        if not main.operands and self._before is not None and (subordinates or again):
            main = _with_operands(main, _last_named(self._before.operands))
        before = self._before
        if not main.operands and main.counts and before is not None and before.operands:
            # "your visits to a | must be at most two": no visit by itself
            told = main.link is None and before.modality is None and not before.counts
            main = _with_operands(main, _last_named(before.operands))
            if told and self._route.chain and self._route.chain.places == self._all(main):
                self._route.drop_chain()
        if Kind.NO_OTHER in main.flags and not main.operands:
            before = self._before
            if before is not None and before.modality is Kind.MAY and self._bounded(before):
                self._permissions -= 1
                return
            self._route.bind(None)
            return
        if self._elaborates(statement):
            return
        if not main.operands and self._before is None and subordinates and all(
            each.connector is Kind.WITHOUT for each in subordinates
        ):  # fmt: skip
            self._never_or_once(main, subordinates)
            return
        if not main.operands:
            if main.act is Act.DO and main.modality is Kind.MUST and before is not None and (
                Kind.AFTER_THAT in main.flags and before.act is Act.AVOID
            ):  # fmt: skip
                self._route.add(Visit(tuple(self._all(before))))  # "... but one has to follow"
            if Kind.ALTERNATE in main.flags and len(set(self._spoken)) > 1:
                self._by_turns([])
            self._route.no_return |= Kind.NO_RETURN in main.flags
            if Kind.IN_ORDER in main.flags:
                self._ordered(strict=Kind.NO_RETURN in main.flags)
            return
        also = any(
            each.connector in (Kind.ONLY_IF, Kind.ONLY_AFTER)
            and (each.link is Kind.BUT or (each.pause and _denies(each, main)))
            for each in subordinates
        )
        if (not subordinates or also) and not self._goes_on(main):
            self._alone(main)
        for clause in subordinates:
            self._joined(main, clause)
        self._before = main

    def _never_or_once(self, main: Clause, subordinates: Sequence[Clause]) -> None:
        """Read "get it done without a" as never a, "do not stop without a" as a."""
        for clause in subordinates:
            parts = tuple(self._all(clause))
            self._route.add((Visit if main.act is Act.AVOID else GlobalAvoidance)(parts))

    def _joined(self, main: Clause, clause: Clause) -> None:
        trigger = self._situation(clause)
        parts = self._all(main)
        self._recurrent = clause.connector is Kind.WHENEVER
        self._afterwards = clause.connector is Kind.AFTER
        goes_on = clause.connector is Kind.AFTER and main.act is Act.DO and not main.counts
        if goes_on and is_errand(clause) and clause.act is Act.DO:
            # "after taking it from a to b, go to c": it is to be taken there
            self._route.begin(Chain([*self._route_of(clause, []), *self._route_of(main, parts)]))
            return
        match clause.connector:
            case Kind.WHEN | Kind.WHENEVER | Kind.AFTER | Kind.PROMPTLY:
                self._reaction(main, clause, trigger, parts)
            case Kind.BEFORE:
                self._before_clause(main, clause, trigger, parts)
            case Kind.RIGHT_BEFORE:
                self._right_before(main, clause, trigger, parts)
            case Kind.UNTIL:
                self._until(main, clause, trigger, parts)
            case Kind.UNLESS:
                self._unless(main, clause, trigger, parts)
            case Kind.WHILE:
                self._while(main, clause, trigger, parts)
            case Kind.WITHOUT:
                self._without(main, clause, parts)
            case Kind.ONLY_IF if Kind.ALREADY in clause.flags or _is_elsewhere(main, clause):
                self._only_after(main, clause, parts)
            case Kind.ONLY_IF:
                for part in parts:
                    self._route.add(InstantaneousReaction(part, trigger))
            case Kind.ELSEWHERE:
                places = disjunction(*self._all(clause))
                where = places if main.act is Act.AVOID else negated(places)
                for part in parts:
                    self._route.add(InstantaneousReaction(part, where))
            case Kind.ONLY_AFTER:
                self._only_after(main, clause, parts)
            case Kind.ONLY_RIGHT_AFTER:
                for part in parts:
                    self._route.add(PromptPrecedence(trigger, part, self._steady(clause)))
            case Kind.IFF:
                bound = self._situation(main)
                earlier = Kind.RIGHT_BEFORE_THAT in clause.flags
                if earlier or main.flags & {Kind.NEXT, Kind.NEXT_INSTANT, *_SPECIFIC}:
                    self._route.add(BoundDelay(trigger, bound, self._steady(clause)))
                else:
                    self._route.add(BoundReaction(trigger, bound))
            case _:
                raise AssertionError(clause.connector)

    def _before_clause(
        self, main: Clause, clause: Clause, trigger: Formula, parts: list[Formula]
    ) -> None:
        later = self._all(clause)
        if main.act is Act.AVOID:
            self._until(main, clause, trigger, parts)
        elif main.act is Act.STAY and all(
            operand.reference.shape is Shape.STATE for operand in main.operands
        ):
            # "wait for it to be full before going there"
            for each in later:
                self._route.add(PastAvoidance(each, self._response(main, parts)))
        elif main.act is Act.STAY:
            self._route.add(Wait(self._response(main, parts), trigger))
        elif (is_once(main) and main.modality is Kind.MAY) or _is_at_most_once(main):
            # "you may go to a once before b", "no second visit to a before b"
            for here in parts:
                for there in later:
                    self._route.enter_once(here, there)
        elif main.modality is Kind.MAY:
            self._permissions += 1
        elif is_once(main):
            self._once_before(parts, later)
        elif drops(main) and is_place(clause) and main.act is Act.DO:
            self._route.begin(Chain([*parts, *later]))
        elif self._is_tour(main, clause):
            chain = self._route.chain
            if chain is not None and later == chain.places[-1:] and len(parts) == 1:
                chain.places[-1:-1] = parts
                chain.ordered = True
            else:
                self._route.chain = Chain([*parts, *later], ordered=True)
                self._route.add(self._route.chain)
        else:
            either = any(operand.link is Kind.OR for operand in main.operands)
            earlier = [self._response(main, parts)] if either else parts
            for each in later:
                for part in earlier:
                    self._route.add(PastAvoidance(each, part, demanded=True))

    def _until(self, main: Clause, clause: Clause, trigger: Formula, parts: list[Formula]) -> None:
        if main.act is Act.STAY and all(o.negated for o in main.operands):
            # "leave it off until": it is not on until then
            for part in parts:
                self._route.add(PastAvoidance(negated(part), trigger))
        elif main.act is Act.AVOID:
            again = Kind.AGAIN in main.flags
            for part in parts:
                for guard in self._each(clause):
                    if not again and clause.counts in ((Count("=", 1),), (Count("", 1),)):
                        # "b is preceded by exactly one visit to a"
                        self._route.add(PastAvoidance(part, guard))
                        self._route.enter_once(guard, part)
                    elif again or any(count.times > 1 or count.bound for count in main.counts):
                        self._route.enter_once(part, guard)
                    else:
                        self._route.add(PastAvoidance(part, guard))
        elif self._route.chain is not None and parts == self._route.chain.places[-1:]:
            # "go there and stay until ...": staying begins when it gets there
            here = parts[0]
            self._route.chain.places[-1] = conjunction(here, Until(here, trigger))
        else:
            self._route.add(Wait(self._response(main, parts), trigger))

    def _unless(self, main: Clause, clause: Clause, trigger: Formula, parts: list[Formula]) -> None:
        if main.act is not Act.AVOID:
            self._route.add(Visit((disjunction(self._response(main, parts), trigger),)))
            return
        steady = all(o.reference.shape is Shape.STATE for o in clause.operands)
        for part in parts:
            if Kind.AGAIN in main.flags and not steady:
                self._route.enter_once(part, trigger)
            elif steady:
                self._route.add(InstantaneousReaction(part, trigger))
            else:
                self._route.add(PastAvoidance(part, trigger))

    def _while(self, main: Clause, clause: Clause, trigger: Formula, parts: list[Formula]) -> None:
        if clause.act is Act.AVOID and main.act is Act.DO:
            # "go to a while avoiding b": b stays out until a, if b is on the way at all.
            self._visited(main, parts) if not main.counts else self._counted(main, parts)
            for avoided in self._all(clause):
                self._route.guards += [(avoided, part) for part in parts]
        elif main.act is Act.AVOID and _is_unvisited(clause):
            # "keep out of a as long as you have not been to b"
            for part in parts:
                self._route.add(PastAvoidance(part, negated(trigger)))
        elif main.act is Act.AVOID:
            for part in parts:
                self._route.add(InstantaneousReaction(trigger, negated(part)))
        elif main.act is Act.STAY or main.modality is Kind.MUST or Kind.ALWAYS in main.flags:
            self._route.add(InstantaneousReaction(trigger, self._response(main, parts)))
        else:
            self._route.add(Visit((conjunction(*parts, trigger),)))

    def _without(self, main: Clause, clause: Clause, parts: list[Formula]) -> None:
        flags = main.flags | clause.flags
        steady = all(map(self._persists, clause.operands))
        for other in self._all(clause):
            for part in parts:
                if Kind.RIGHT_BEFORE_THAT in flags:
                    self._route.add(PromptPrecedence(other, part, steady))
                elif flags & set(_SPECIFIC):
                    self._route.add(
                        PromptReaction(part, other, all(map(self._persists, main.operands)))
                    )
                elif Kind.AFTER_THAT in flags or Kind.LATER in flags:
                    self._route.add(DelayedReaction(part, other))
                elif main.act is Act.AVOID and Kind.AGAIN in main.flags and part != other:
                    self._route.enter_once(part, other)
                elif main.act is Act.AVOID and self._stands(clause):
                    self._route.add(InstantaneousReaction(part, other))
                elif main.act is Act.AVOID:
                    self._route.add(PastAvoidance(part, other))
                else:
                    continue
        if main.act is Act.DO and Kind.BEFORE_THAT in clause.flags:
            # "go to a without passing b on the way"
            for other in self._all(clause):
                for part in parts:
                    self._route.add(PastAvoidance(other, part, demanded=True))
        elif main.act is Act.DO:
            self._alone(main)
            self._route.guards += [(other, part) for other in self._all(clause) for part in parts]

    def _stands(self, clause: Clause) -> bool:
        """Whether a clause tells of a state that must hold, not of what must have been."""
        earlier = {Kind.ALREADY, Kind.FIRST, Kind.BEFORE_THAT}
        return not clause.flags & earlier and (
            Kind.BE in clause.flags
            or all(operand.reference.shape is Shape.STATE for operand in clause.operands)
        )

    def _only_after(self, main: Clause, clause: Clause, parts: list[Formula]) -> None:
        chain = self._route.chain
        guards = self._each(clause)
        tour = self._is_tour(main, clause) and main.act is not Act.AVOID
        if tour and chain is not None and (
            self._continues(main) or guards[-1] == chain.places[-1]
        ):  # fmt: skip
            chain.places += [part for part in parts if part not in chain.places]
            self._route.guards += [(part, guard) for part in parts for guard in guards]
            return
        self._spoken += parts if tour else []
        for part in parts:
            for guard in guards:
                self._route.add(GuardedVisit(part, guard) if tour else PastAvoidance(part, guard))
                if main.modality is Kind.MAY:
                    self._route.permitted.append((part, guard))

    def _each(self, clause: Clause) -> list[Formula]:
        """What a clause speaks of, one by one: several places are not reached at one instant."""
        lasting = all(o.reference.shape is Shape.STATE for o in clause.operands)
        either = any(operand.link is Kind.OR for operand in clause.operands)
        if lasting or either or clause.act is Act.AVOID or Kind.NOW in clause.flags:
            return [self._situation(clause)]
        return self._all(clause)


def _entered(found: Sequence[Pattern]) -> tuple[Pattern, ...]:
    """Read "stay at a all the time" beside "but not at a until b" as staying from its arrival."""
    waits = [each.avoided for each in found if isinstance(each, PastAvoidance)]
    return tuple(
        Remaining(each.kept)
        if isinstance(each, Maintenance) and all(kept in waits for kept in each.kept)
        else each
        for each in found
    )


def _denies(clause: Clause, main: Clause) -> bool:
    """Whether "do a, (just) not before b" asks for a, and does not only restrict it."""
    return clause.denied and main.act is Act.DO and main.modality is not Kind.MAY


def _options(said: Sequence[Statement]) -> list[list[list[Statement]]]:
    """Group statements by "or" between main clauses; "then" binds tighter than "or"."""
    groups: list[list[list[Statement]]] = []
    for statement in said:
        main = statement.main
        if groups and main.link in (Kind.THEN, Kind.ONLY_THEN):
            groups[-1][-1].append(statement)
        elif groups and main.link is Kind.OR:
            before = groups[-1][-1][-1].main
            if before.act is Act.AVOID and main.modality is None:
                # "do not do this or do that": neither
                groups.append([[replace(statement, main=replace(main, act=Act.AVOID))]])
            else:
                groups[-1].append([statement])
        else:
            groups.append([[statement]])
    return groups


def _last_named(operands: tuple[Operand, ...]) -> tuple[Operand, ...]:
    """What is spoken of further: in "a, then b: b may not ..." the b that is named anew."""
    symbols = [each.reference.symbol for each in operands]
    return operands[-1:] if symbols and symbols[-1] in symbols[:-1] else operands


def _is_unvisited(clause: Clause) -> bool:
    """Whether a clause tells of places where one has not been: "while you have not been to a"."""
    denied = clause.act is Act.AVOID or all(operand.negated for operand in clause.operands)
    now = Kind.BE in clause.flags and Kind.ALREADY not in clause.flags  # "while you are not at a"
    return denied and not now and all(o.reference.shape is Shape.PLACE for o in clause.operands)


def _is_at_most_once(main: Clause) -> bool:
    limit = (Count("<", 2), Count("<=", 1))
    return main.act is Act.DO and bool(main.counts) and all(each in limit for each in main.counts)


def _is_elsewhere(main: Clause, clause: Clause) -> bool:
    """Whether "visit b only if a is visited" speaks of two places, where nobody is at once."""
    return Kind.BE not in main.flags and all(
        operand.reference.shape is Shape.PLACE and not operand.negated and operand.link is None
        for operand in (*main.operands, *clause.operands)
    )


def _with_operands(clause: Clause, operands: tuple[Operand, ...]) -> Clause:
    return replace(clause, operands=operands)
