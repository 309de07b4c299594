"""Who is where: a mover that is named, with a place, is the symbol that says so of that mover.

"The crane goes to the gate" speaks of the crane at the gate, though the bare name of the gate
stands for the robot that is spoken to. Who is spoken of is told by subjects ("the crane must
..."), objects ("send the crane ..."), vocatives ("Crane, ..."), and pronouns.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from plainspoken.language.expression import Shape
from plainspoken.language.frame import Frames, Mention, Thing
from plainspoken.language.kinship import alike
from plainspoken.language.reference import Form, Reference
from plainspoken.language.word import Word, stems
from plainspoken.world.symbol import SymbolId

_CONNECTORS_WORDS = """
    when if once while until till unless before after whenever as where whilst provided
    because since during upon following should
"""
_CONNECTORS = frozenset(_CONNECTORS_WORDS.split())
_JOINING = frozenset(("and", "or", "then", "but", "so", ",", "nor", "yet", "next", "afterwards"))
_STOPS = frozenset(".;!?:")
_GENERAL = frozenset(("robot", "machine", "bot", "vehicle"))
_GENERAL_PLURAL = frozenset(("robots", "machines", "bots", "vehicles"))
_SPOKEN_TO = frozenset(("you", "we", "i", "yourself"))
_OPEN = frozenset(("let", "have", "make", "keep", "must", "should", "can", "may", "will", "shall"))
_HOLDING_OPEN = frozenset(
    ("must", "should", "can", "may", "will", "shall", "might", "could", "would")
)
_VERBAL_WORDS = """
    is are was has have had goes gets does may never be been visits enters stays reaches
"""
_VERBAL = _HOLDING_OPEN | frozenset(_VERBAL_WORDS.split())
_THERE = frozenset(("there", "it"))
_AT = frozenset(("in", "at", "to", "into", "inside", "on", "of", "near", "out", "leaves", "enters"))
_SENDING_WORDS = """
    send sends sending dispatch dispatching direct order instruct tell ask request guide escort
"""
_SENDING = frozenset(_SENDING_WORDS.split())
"""Verbs that make somebody go, where no act of the domain is named by them."""
_TELLING = frozenset(("tell", "ask", "order", "instruct", "request", "direct"))
"""Those of them behind which "and" goes on telling what they are to do."""
_ARRIVING_WORDS = """
    arrives arrive arrived comes appears joins shows turns does is has did do
"""
_ARRIVING = frozenset(_ARRIVING_WORDS.split())
_THEM = frozenset(("him", "her", "them", "it"))
_ASIDE = frozenset(("out", "away", "off", "clear", "from"))

_ORDERS_WORDS = """
    go visit head drive move travel reach enter come return stay wait remain avoid leave
    keep patrol pass stop do never be proceed get make
"""
_ORDERS = frozenset(_ORDERS_WORDS.split())


@dataclass(slots=True)
class _Clause:
    """Who is spoken of since the clause began, and where that leaves the places in it."""

    agents: tuple[Thing | None, ...] = ()
    before: tuple[Thing | None, ...] = ()
    open: bool = False
    sticky: bool = False
    fresh: bool = False
    subordinate: bool = False


def told_apart(
    said: tuple[Word, ...],
    found: tuple[Reference, ...],
    frames: Frames,
    deeds: Mapping[tuple[Thing, SymbolId], SymbolId],
    doers: Mapping[SymbolId, Thing],
) -> tuple[tuple[Word, ...], tuple[Reference, ...]]:
    """Give each place to whoever is said to be there; their names become "robot".

    deeds: for somebody and an act, the symbol that says that they do it
    doers: who it is that a symbol says to do something
    """
    if not frames.movers:
        return said, found
    return _Teller(said, found, frames, deeds, doers).told()


def mover_at(said: Sequence[Word], index: int, frames: Frames) -> Mention | None:
    """A mover that is named from a word on, by its own words or by what sets it apart."""
    best: Mention | None = None
    for thing in frames.movers:
        last = _named(thing, said, index)
        if last is not None and (best is None or last > best.last):
            best = Mention(thing, index, last)
    return best


def _named(thing: Thing, said: Sequence[Word], index: int) -> int | None:
    telling = [text for text in thing if text not in _GENERAL] or list(thing)
    if telling[0].isdigit():
        telling = list(thing)
    place = index
    for text in telling:
        own = stems(text)
        if place >= len(said) or not said[place].stems & (own | alike(own)):
            return None
        exact = bool(said[place].stems & own)
        if not exact and said[place].text.endswith("ing"):
            return None
        place += 1
    if place < len(said) and said[place].text in _GENERAL:
        return place + 1
    verb = len(telling) == 1 and len(thing) > 1
    if verb and not (index and said[index - 1].text in ("the", "a", "your", "my", "our")):
        return None
    return place


class _Teller:
    def __init__(
        self,
        said: tuple[Word, ...],
        found: tuple[Reference, ...],
        frames: Frames,
        deeds: Mapping[tuple[Thing, SymbolId], SymbolId],
        doers: Mapping[SymbolId, Thing],
    ) -> None:
        self._said = list(said)
        self._deeds = deeds
        self._doers = doers
        self._frames = frames
        self._found = {each.first: each for each in found}
        self._out: list[Reference] = []
        self._clause = _Clause()
        self._last: Thing | None = None
        self._place: tuple[SymbolId, Thing | None] | None = None
        self._own = {
            symbol: (place, thing)
            for thing, there in frames.movers.items()
            for place, symbol in there.items()
        }
        self._names: list[Mention] = []
        # Whoever is somewhere, is called, or is spoken to anyway; others stay unknown words.
        self._used = {
            thing
            for thing, there in frames.movers.items()
            if all(place == symbol for place, symbol in there.items())
        }
        self._default = frozenset(self._used)
        self._since: list[int] = []  # references of places in this clause, by their number

    def told(self) -> tuple[tuple[Word, ...], tuple[Reference, ...]]:
        index = 0
        while index < len(self._said):
            index = self._step(index)
        for mention in (each for each in self._names if each.thing in self._used):
            for place in range(mention.first, mention.last):
                word = self._said[place]
                text = "robot" if place == mention.first else "the"
                self._said[place] = replace(word, text=text)
            self._move_aside(mention)
        return tuple(self._said), tuple(self._out)

    def _move_aside(self, mention: Mention) -> None:
        """Put together what a name stands between: "keep the crane out of" is "keep out of"."""
        first = mention.first - (self._text(mention.first - 1) == "the")
        if self._text(first - 1) in ("keep", "keeping") and self._text(mention.last) in _ASIDE:
            span = self._said[first - 1 : mention.last]
            self._said[first - 1 : mention.last] = [*span[1:], span[0]]

    def _step(self, index: int) -> int:
        each = self._found.get(index)
        if each is not None and each.shape is not Shape.PLACE:
            self._passed(each)
            return each.last
        mention = mover_at(self._said, index, self._frames)
        inside = each is not None and mention is not None and mention.last <= each.last
        if mention is not None and not inside:
            self._met(mention)
            return mention.last
        if each is not None:
            self._placed(each)
            return each.last
        self._word(index)
        return index + 1

    def _both(self, each: Reference, other: Thing | None) -> None:
        """Read "you and the crane must not be at the gate" as both being there."""
        place, _ = self._own[each.symbol]
        symbol = self._frames.movers[other].get(place, place) if other is not None else place
        if other is not None:
            self._used.add(other)
        cut = each.last - 1
        if each.negated and each.obliged:
            each = replace(each, negated=False, never=True)
        if each.never and self._text(each.last) == "together":
            both = self._said[each.last]
            self._said[each.last] = replace(both, text="simultaneously")
        self._out.append(replace(each, symbol=symbol, last=cut - 1))
        self._said[cut - 1] = replace(self._said[cut - 1], text="and")
        self._out.append(replace(each, first=cut, form=Form.NOUN, never=False, obliged=False))

    def _text(self, index: int) -> str:
        return self._said[index].text if 0 <= index < len(self._said) else "."

    def _passed(self, each: Reference) -> None:
        """An act, or what is so: an imperative ends what was said of a mover."""
        each = self._done_by(each)
        sent = self._sent(each.first)
        if each.symbol in self._own:
            place, self._last = self._own[each.symbol]
            self._place = (place, self._last)
        if each.symbol in self._doers and not self._clause.sticky:
            self._last = self._doers[each.symbol]
            held = each.obliged or self._text(each.first - 1) in _OPEN
            self._clause = _Clause(
                (self._last,), open=held or self._clause.open, subordinate=self._clause.subordinate
            )
        elif each.form is Form.BASE and not self._clause.sticky:
            self._clause = _Clause()
        elif each.symbol in self._own and not self._clause.sticky:
            before = each.first - 1 - (self._text(each.first - 1) == "the")
            if self._text(before) == "and" and self._clause.agents and not self._since:
                self._both(each, self._clause.agents[-1])
                return
            self._clause.agents = (self._last,)
            self._clause.open |= self._is_bound(each) or (self._text(before) in _OPEN and not sent)
        self._clause.fresh = False
        self._named_in(each)
        self._out.append(each)

    def _is_bound(self, each: Reference) -> bool:
        """Whether somebody must be there, so that "and" goes on telling what they must do."""
        own = {word.text for word in self._said[each.first : each.last]}
        return each.obliged and not own.isdisjoint(_VERBAL | {"needs", "ought"})

    def _done_by(self, each: Reference) -> Reference:
        """The act of another, where the clause is about them: "the crane is to lift, then turn"."""
        agents = self._clause.agents
        symbol = self._deeds.get((agents[-1], each.symbol)) if agents and agents[-1] else None
        told = self._clause.open or self._clause.subordinate or each.form is not Form.BASE
        return replace(each, symbol=symbol) if symbol is not None and told else each

    def _named_in(self, each: Reference) -> None:
        """Remember whom an act is done to: "call the crane and have it come to the gate"."""
        for place in range(each.first, each.last) if each.symbol not in self._own else ():
            mention = mover_at(self._said, place, self._frames)
            if mention is not None and mention.last <= each.last:
                self._last = mention.thing

    def _sent(self, first: int) -> bool:
        """Read "send the crane to the gate" as having it there; whether that is all of it."""
        before = first - 1 - (self._text(first - 1) in ("the", "your", "our"))
        verb = self._text(before)
        if verb in _SENDING:
            self._said[before] = replace(self._said[before], text="have")
        return verb in _SENDING - _TELLING

    def _met(self, mention: Mention) -> None:
        before = self._text(mention.first - 1)
        if before in ("the", "a", "your", "our"):
            before = self._text(mention.first - 2)
        behind = self._text(mention.last)
        self._sent(mention.first)
        self._last = mention.thing
        self._names.append(mention)
        clause = self._clause
        if before in ("by", "from", "to", "for") and self._since and not clause.agents:
            self._used.add(mention.thing)
            for number in self._since:
                self._out[number] = self._at(self._out[number], mention.thing)
            return
        opening = before in _STOPS or mention.first <= 1
        if opening and behind == ",":
            self._used.add(mention.thing)
        joined = before in ("and", "nor", "or") and bool(clause.agents) and not self._since
        agents = (*clause.agents, mention.thing) if joined else (mention.thing,)
        self._clause = _Clause(
            agents,
            open=before in _OPEN | _TELLING,
            sticky=opening and behind == ",",
            subordinate=clause.subordinate,
        )
        self._since = []

    def _at(self, each: Reference, agent: Thing | None) -> Reference:
        if agent is None:
            return each
        there = self._frames.movers[agent]
        self._used.add(agent)
        for symbol in (each.symbol, *each.rivals):
            if symbol in there:
                return replace(each, symbol=there[symbol], rivals=())
        return each

    def _placed(self, each: Reference) -> None:
        clause = self._clause
        if clause.fresh and not clause.agents:
            clause.agents, clause.fresh = clause.before, False
        agent = clause.agents[-1] if clause.agents else None
        self._place = (each.symbol, agent)
        self._since.append(len(self._out))
        if len(clause.agents) > 1:
            self._together(each, clause.agents)
            return
        self._out.append(self._at(each, agent))

    def _together(self, each: Reference, agents: Sequence[Thing | None]) -> None:
        """Two at one place: two references, the first of them on the word before."""
        own = [self._at(each, agent) for agent in agents]
        first = each.first - (1 if each.last - each.first > 1 else 2)
        if len(own) > 2 or first < 0 or (self._out and self._out[-1].last > first):
            self._out.append(own[-1])
            return
        self._out.append(replace(own[0], first=first, last=first + 1))
        self._said[first + 1] = replace(self._said[first + 1], text="and")
        self._out.append(replace(own[1], first=first + 2))

    def _word(self, index: int) -> None:
        word, clause = self._said[index], self._clause
        text = word.text
        if text in _STOPS:
            self._clause, self._since = _Clause(), []
        elif (
            text in _CONNECTORS
            and not clause.sticky
            and (text != "should" or self._text(index - 1) in _STOPS | {","})
        ):
            before = clause.agents or clause.before
            self._clause = _Clause(before=before, fresh=True, subordinate=True)
            self._since = []
        elif text == "," and clause.subordinate:
            self._clause, self._since = _Clause(), []
        elif text in _GENERAL_PLURAL and self._text(index - 1) in ("both", "two", "the", "all"):
            several = self._others()
            if len(several) == 1 or (len(several) == 2 and not self._default):
                agents = (None, *several) if len(several) == 1 else several
                self._clause = _Clause(agents, open=True)
                denied = {each.text for each in self._said[:index]} & {"never", "no", "not"}
                if denied and self._text(index - 1) == "both":
                    # "never both at the gate" forbids the two of them at once.
                    both = self._said[index - 1]
                    self._said[index - 1] = replace(both, text="simultaneously")
        elif text in _SPOKEN_TO:
            self._clause = _Clause((None,), subordinate=clause.subordinate)
        elif text in ("it", "he", "she", "they") and self._text(index + 1) in _VERBAL:
            if self._last is not None and not clause.sticky:
                self._clause = _Clause((self._last,), open=True, subordinate=clause.subordinate)
        elif text in _THEM and self._text(index - 1) in _OPEN | {"get", "bring"} | _SENDING:
            if self._last is not None and self._text(index + 1) not in _STOPS:
                self._sent(index)
                self._clause = _Clause((self._last,), open=True, subordinate=clause.subordinate)
                self._said[index] = replace(word, text="robot")
        elif text in _HOLDING_OPEN or (
            text in ("has", "needs", "ought", "is") and self._text(index + 1) == "to"
        ):
            clause.open = True
        elif text in _JOINING and not clause.sticky and not clause.open and self._orders(index + 1):
            self._clause, self._since = _Clause(), []
        self._points(index)
        self._answers(index)

    def _others(self) -> tuple[Thing, ...]:
        """Who moves beside whoever is spoken to, each by one name."""
        found: dict[tuple[SymbolId, ...], Thing] = {}
        for thing, there in self._frames.movers.items():
            if thing not in self._default:
                found.setdefault(tuple(there.values()), thing)
        return tuple(found.values())

    def _answers(self, index: int) -> None:
        """Read "(not before) the crane does" as the crane at the place last spoken of."""
        mention = self._names[-1] if self._names else None
        if (
            mention is None or mention.last != index or self._place is None
            or self._text(index) not in _ARRIVING
            or (self._text(index + 1) not in _STOPS | {","} and index + 1 < len(self._said))
        ):  # fmt: skip
            return
        symbol = self._frames.movers[mention.thing].get(self._place[0])
        if symbol is not None:
            self._used.add(mention.thing)
            self._out.append(Reference(symbol, index, index + 1, 0.95, Form.NOUN, Shape.PLACE))

    def _orders(self, index: int) -> bool:
        """Whether a verb in its plain form follows, which speaks to the robot."""
        while self._text(index) in _JOINING | {"please", "also"}:
            index += 1
        text = self._text(index)
        return text.isalpha() and text in _ORDERS

    def _points(self, index: int) -> None:
        """Read "there" as the place last spoken of, where it is another's place now."""
        text = self._text(index)
        if text not in _THERE or self._place is None:
            return
        if text == "it" and self._text(index - 1) not in _AT:
            return
        place, whose = self._place
        agent = self._clause.agents[-1] if self._clause.agents else None
        there = self._frames.movers.get(agent, {}) if agent is not None else {}
        symbol = there.get(place, place)
        if agent is not None:
            self._used.add(agent)
        if agent == whose or (agent is not None and place not in there):
            return
        self._out.append(Reference(symbol, index, index + 1, 0.95, Form.NOUN, Shape.PLACE))
