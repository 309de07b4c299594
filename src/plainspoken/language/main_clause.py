"""What a main clause asks for when nothing is subordinate to it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from plainspoken.language.clause import Act, Clause, Operand, Statement
from plainspoken.language.clause_kind import (
    drops,
    is_bound,
    is_once,
    is_place,
    is_remark,
    is_state,
)
from plainspoken.language.counting import Count
from plainspoken.language.expression import Shape
from plainspoken.language.itinerary import Chain, Itinerary, count_pattern
from plainspoken.language.lexicon import Kind
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
    AtMost,
    DelayedReaction,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    InstantaneousReaction,
    Maintenance,
    PastAvoidance,
    Patrolling,
    PromptReaction,
    Remaining,
    SequencedVisit,
    Visit,
    Wait,
    negated,
)
from plainspoken.world.symbol import SymbolId


class MainClauses:
    """Main clauses by themselves; what they ask for is added to the route."""

    def __init__(
        self, placeholder: Callable[[Operand], Atom], persists: Callable[[Operand], bool]
    ) -> None:
        self._placeholder = placeholder
        self._persists = persists
        self._route = Itinerary()
        self._before: Clause | None = None  # what "that" of "after that" points to
        self._spoken: list[Formula] = []  # what was asked for, in the order of saying
        self._fair: frozenset[Formula] = frozenset()  # what is visited by turns
        self._afterwards = False  # the last condition was "after", "once"
        self._recurrent = False  # the last condition was "whenever"
        self._permissions = 0
        self._remarks = 0

    def _one(self, operand: Operand) -> Formula:
        first, *later = self._stops(operand)
        done = _followed(first, SequencedVisit(tuple(later)).literal) if later else first
        return negated(done) if operand.negated else done

    def _route_of(self, main: Clause, parts: list[Formula]) -> list[Formula]:
        """The places that a clause leads to one after another."""
        if len(main.operands) == 1 and main.operands[0].reference.errand is not None:
            return self._stops(main.operands[0])
        return parts

    def _stops(self, operand: Operand) -> list[Formula]:
        """What is done one after another, where an operand is an errand; else the operand."""
        errand = operand.reference.errand
        if errand is None:
            return [self._placeholder(operand)]
        return [
            conjunction(*(self._placeholder(_of_symbol(operand, each)) for each in stop))
            for stop in errand.stops
        ]

    def _all(self, clause: Clause) -> list[Formula]:
        parts: list[Formula] = []
        for operand in clause.operands:
            formula = self._one(operand)
            if operand.link is Kind.NOW and parts:
                parts[-1] = conjunction(parts[-1], formula)
            elif formula not in parts or (operand.link is Kind.THEN and formula != parts[-1]):
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
        waited = isinstance(self._route.last, Wait) and Kind.AFTER_THAT in main.flags
        linked = main.link is Kind.THEN or waited
        if not linked or main.act is not Act.DO or main.counts:
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
        if Kind.NO_OTHER in flags and self._route.bind(parts):
            return
        if self._points_back(main, parts) or self._once_more(main, parts):
            return
        if Kind.ALTERNATE in flags:
            self._by_turns(parts)
        elif main.pointed and main.act is Act.DO and main.modality is not Kind.MAY and (
            not main.counts and self._asked_for(main, parts)
        ):  # fmt: skip
            return
        elif main.counts:
            self._counted(main, parts)
        elif main.act is Act.AVOID:
            self._avoided(main, parts)
        elif is_bound(main) and self._bounded(main):
            pass
        elif (
            main.modality is Kind.MAY
            and not main.wished
            and Kind.BEFORE_THAT not in flags
            and not self._continues(main)
        ):
            self._permissions += 1
        elif main.act is Act.PATROL:
            self._route.add(Patrolling(tuple(parts)))
        elif main.act is Act.STAY:
            steady = flags & {Kind.ALWAYS, Kind.AGAIN_AND_AGAIN} and Kind.LATER not in flags
            always = bool(steady) and main.link not in (Kind.THEN, Kind.ONLY_THEN)
            chain = self._route.chain
            always &= chain is None or parts != chain.places[-1:]  # "end there and stay for good"
            self._route.add((Maintenance if always else Remaining)(tuple(parts)))
        elif Kind.ALWAYS in flags and (main.assured or is_state(main) or Kind.BE in flags):
            kept = Remaining if Kind.LATER in flags else Maintenance
            self._route.add(kept((self._situation(main),)))
        elif is_remark(main):
            self._remarks += 1
        elif self._route.chain is not None and Kind.NOW in flags and len(parts) > 1 and (
            self._continues(main)
        ):  # fmt: skip
            self._route.chain.places.append(self._situation(main))
        elif Kind.NOW in flags and len(parts) > 1:
            self._route.add(Visit((self._situation(main),)))
        else:
            self._visited(main, parts)

    def _ordered(self, *, strict: bool) -> None:
        """Read "..., in that order" of clauses that each asked for one thing as one order."""
        chain = self._route.chain
        if chain is not None and len(chain.places) > 1:
            chain.ordered = True
            chain.strict |= strict
        elif len(self._spoken) > 1:
            self._route.patterns = [
                each for each in self._route.patterns if not isinstance(each, (Chain, Visit))
            ]
            places = list(dict.fromkeys(self._spoken))
            self._route.begin(Chain(places, ordered=True, strict=strict))

    def _by_turns(self, parts: list[Formula]) -> None:
        """The places by turns; without any, those that were just asked for."""
        if len(parts) < 2:
            parts = list(dict.fromkeys((*self._spoken, *parts)))
            self._route.patterns = [
                each for each in self._route.patterns if not isinstance(each, (Chain, Visit))
            ]
        self._fair = frozenset(parts)
        self._route.add(FairVisit(tuple(parts)) if len(parts) > 1 else Visit(tuple(parts)))
        self._route.chain = None

    def _bounded(self, main: Clause) -> bool:
        """Read "doing a is permitted at b, and nowhere else" as a only at b."""
        acts = [o for o in main.operands if o.reference.shape is Shape.ACT]
        places = [o for o in main.operands if o.reference.shape is Shape.PLACE]
        if not acts or not places:
            return False
        where = disjunction(*map(self._one, places))
        for act in acts:
            self._route.add(InstantaneousReaction(self._one(act), where))
        return True

    def _elaborates(self, statement: Statement) -> bool:
        """Whether a statement only spells out what "by turns" said already."""
        spoken = {
            self._placeholder(operand)
            for clause in (statement.main, *statement.subordinates)
            for operand in clause.operands
        }
        return bool(self._fair) and spoken <= self._fair

    def _asked_for(self, main: Clause, parts: list[Formula]) -> bool:
        """Demand what was spoken of before: "b only after a, and do visit it", "do both"."""
        chain = self._route.chain
        linked = main.link in (Kind.THEN, Kind.ONLY_THEN) or bool(
            main.flags & {Kind.AFTER_THAT, Kind.LATER_ON, Kind.BEFORE_THAT}
        )
        last = self._route.last
        either = any(operand.link is Kind.OR for operand in main.operands)
        if len(parts) > 1 and not either and Visit((disjunction(*parts),)) in self._route.patterns:
            self._route.add(Visit(tuple(parts)))  # "go to one of them, then to the other one"
            return True
        match last:
            case DelayedReaction(a, b) if not self._recurrent and set(parts) & {a, b}:
                # "once a, b; and do a": b after a, and a is to be
                self._route.patterns.pop()
                self._route.begin(Chain([a, b]))
                return True
        if chain is not None and linked and not any(
            isinstance(each, PastAvoidance) for each in self._route.patterns
        ):  # fmt: skip
            return False
        if any(operand.link is Kind.OR for operand in main.operands):
            return False
        known = chain.places if chain is not None else []
        for part in parts:
            if part not in known:
                self._route.add(Visit((part,)))
        return True

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
        known = self._spoken or any(map(self._route.guards_against, parts))
        if main.act is Act.AVOID and Kind.BEFORE_THAT in flags and known:
            chain = self._route.chain
            earlier = [each for each in self._spoken if each not in parts]
            for each in parts:
                if Kind.AGAIN in flags and earlier:
                    self._route.enter_once(each, earlier[-1])
                elif chain is not None and each in chain.places[1:]:
                    chain.ordered = True
                elif self._route.guards_against(each):
                    earlier = earlier or [each]
                elif earlier:
                    self._route.add(PastAvoidance(each, earlier[-1], demanded=True))
            return chain is not None or bool(earlier)
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
        if Kind.NOW in main.flags and len(parts) > 1:
            self._route.add(GlobalAvoidance((self._response(main, parts),)))
            return
        last = self._route.patterns[-1] if self._route.patterns else None
        if (
            Kind.AGAIN in main.flags
            and isinstance(last, (AtLeast, Exactly))
            and [last.place] == parts
        ):
            self._route.patterns[-1] = Exactly(last.place, last.times)
            return
        for_good = {Kind.AGAIN, Kind.NO_RETURN} <= main.flags
        if for_good and all(map(self._route.is_guard, parts)):
            self._route.no_return = True  # "do not revisit a before the mission is over"
            return
        on_the_way = chain is not None and all(part in chain.places for part in parts)
        if Kind.AGAIN in main.flags and not on_the_way:
            for part in parts:
                self._route.add(AtMost(part, 1))
            return
        if chain is not None and on_the_way and Kind.AGAIN in main.flags:
            # "... and do not visit it again": said of a place already on the way.
            chain.strict = True
        elif chain is not None and all(part in self._spoken for part in parts):
            # "go to a, then to b, and never to a": no guard of what is still to come, a clash
            self._route.add(GlobalAvoidance(tuple(parts)))
        elif chain is not None and main.link in (Kind.AND, Kind.BUT, Kind.COMMA, None):
            # "go to a but not to b, then to b": b is to wait, if it is on the way at all.
            self._route.guards += [(part, chain.places[-1]) for part in parts]
        else:
            self._route.add(GlobalAvoidance(tuple(parts)))

    def _once_more(self, main: Clause, parts: list[Formula]) -> bool:
        """Count visits on top of the one asked for: "go there, and then twice more"."""
        chain = self._route.chain
        again = Kind.AGAIN in main.flags or any(count.more for count in main.counts)
        if chain is None or main.act is not Act.DO or not again or chain.places != parts:
            return False
        self._route.drop_chain()
        for count in main.counts or (Count(">=", 1),):
            more = replace(count, times=count.times + 1)
            self._route.add(count_pattern(parts[0], more, forbidden=False))
        return True

    def _counted(self, main: Clause, parts: list[Formula]) -> None:
        if self._route.chain is not None and self._continues(main) and is_once(main):
            self._route.chain.places += parts
            self._route.chain.strict = True
            return
        chain = self._route.chain
        if chain is not None and is_once(main) and Kind.BEFORE_THAT in main.flags:
            if parts != chain.places[-2:-1]:
                chain.places[-1:-1] = parts
            chain.strict = True
            return
        if chain is not None and is_once(main) and all(p in chain.places[:-1] for p in parts):
            chain.strict = True
            return
        for part in parts:
            for count in main.counts:
                self._route.add(count_pattern(part, count, forbidden=main.act is Act.AVOID))
        if is_once(main) and len(parts) == 1:
            # "visit a exactly once, then b": it may yet turn out to begin an order.
            self._route.patterns.pop()
            self._route.chain = Chain(parts, strict=True)
            self._route.add(self._route.chain)

    def _visited(self, main: Clause, parts: list[Formula]) -> None:
        flags = main.flags
        self._spoken += parts
        if any(operand.link is Kind.OR for operand in main.operands):
            parts = [disjunction(*parts)]
            if not self._continues(main):
                self._route.add(Visit(tuple(parts)))
                return
        then = any(operand.link in (Kind.THEN, Kind.ONLY_THEN) for operand in main.operands)
        ordered = Kind.IN_ORDER in flags or any(
            operand.link is Kind.ONLY_THEN for operand in main.operands
        )
        linked = main.link in (Kind.THEN, Kind.ONLY_THEN) or bool(
            flags & {Kind.AFTER_THAT, Kind.RIGHT_AFTER_THAT, Kind.NTH, Kind.LATER_ON}
        )
        linked |= main.link is Kind.AND and drops(self._before) and is_place(main)
        chain = self._route.chain
        if Kind.BEFORE_THAT in flags and chain is not None:
            that = next((p for p in reversed(self._spoken) if p not in parts), None)
            place = chain.places.index(that) if that in chain.places else -1
            chain.places[place:place] = parts
            chain.ordered = True
            return
        last = self._route.patterns[-1] if self._route.patterns else None
        if linked and self._route.chain is None and isinstance(last, Visit):
            if len(last.places) == 1:
                self._route.patterns.pop()
                self._route.begin(Chain([*last.places, *parts]))
                return
            # "a and b, then c": c after each of them.
            self._route.patterns[-1:] = [Chain([place, *parts]) for place in last.places]
            return
        if linked and self._route.chain is None and isinstance(last, (AtLeast, Exactly)):
            # "a twice, then b": the count, and b after a
            self._route.begin(Chain([last.place, *parts]))
            return
        places = self._route_of(main, parts)
        if linked and self._route.chain is not None:
            self._route.chain.places += places
            self._route.chain.ordered |= main.link is Kind.ONLY_THEN
            self._route.chain.strict |= Kind.NO_RETURN in flags
            return
        if isinstance(last, DelayedReaction) and self._afterwards and parts == [last.trigger]:
            # "once a, b; a is a must": b after a
            self._route.patterns.pop()
            self._route.begin(Chain([last.trigger, last.response]))
            return
        if len(parts) == 1 or then or ordered or flags & {Kind.SEQUENCE, Kind.NO_RETURN}:
            self._route.chain = Chain(places, ordered, Kind.NO_RETURN in flags)
            self._route.add(self._route.chain)
            if ordered and len(parts) == 1:
                self._ordered(strict=Kind.NO_RETURN in flags)
        else:
            self._route.add(Visit(tuple(parts)))
            self._route.chain = None


def _of_symbol(operand: Operand, symbol: SymbolId) -> Operand:
    """One symbol of an operand that is an errand, by itself."""
    return replace(operand, reference=replace(operand.reference, symbol=symbol, errand=None))


def _followed(formula: Formula, sequel: Formula) -> Formula:
    """The formula, and the sequel after the last thing that it already goes on to."""
    match formula:
        case And((*parts, Eventually(later))):
            return conjunction(*parts, Eventually(_followed(later, sequel)))
        case _:
            return conjunction(formula, sequel)
