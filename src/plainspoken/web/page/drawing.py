"""The map of a site as SVG: the same state, the same picture.

Every part carries `data-key`, by which the browser moves it instead of drawing it anew, and the
objects it shows as `data-thing`, by which an answer can point at it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from plainspoken.web.page import shapes
from plainspoken.web.page.ground import Ground, Place, Whereabouts
from plainspoken.web.page.layout import HEIGHT, WIDTH, Mark, Point, Spot, arranged
from plainspoken.web.page.markup import Html, tag
from plainspoken.world.domain import GroundAction, State

_TONES = ("unseen", "doubt", "good", "bad", "done", "plain")


@dataclass(frozen=True)
class Scene:
    """What is drawn: a state, and the actions under way in it."""

    state: State
    actions: tuple[GroundAction, ...] = ()


class Drawing:
    """Draws one site, again and again."""

    def __init__(self, ground: Ground) -> None:
        self.ground = ground
        given = ground.layout.places
        free = [name for name in ground.places if name not in given]
        found = arranged(free, [w for w in ground.ways if not set(w) & set(given)])
        self._spots = {**given, **{name: Spot(at) for name, at in found.items()}}

    def svg(self, scene: Scene) -> Html:
        """The map, with a sentence for whoever cannot see it."""
        where = self.ground.whereabouts(scene.state)
        held: dict[str, list[Whereabouts]] = {}
        for each in where.values():
            if each.holder is not None:
                held.setdefault(each.holder, []).append(each)
        parts = [
            *self._ways(scene),
            *(self._place(name, where[name]) for name in self.ground.places),
            *self._things(held, where),
            *self._robots(held, where, scene),
        ]
        said = self.described(scene.state)
        return tag(
            "svg",
            tag("title", said),
            *parts,
            viewBox=f"0 0 {WIDTH:g} {HEIGHT:g}",
            role="img",
            class_="site",
            preserveAspectRatio="xMidYMid meet",
        )

    def described(self, state: State) -> str:
        """The map in a sentence: where the robots are, and what they have."""
        where, words = self.ground.whereabouts(state), self.ground.lexicon.object_words
        found = [
            f"{_name(self.ground, robot)} at {words(holder)}"
            for robot in self.ground.robots
            if (holder := where[robot].holder) is not None
        ]
        return f"Map of the site: {', '.join(found)}." if found else "Map of the site."

    # -- what stays ------------------------------------------------------------------------------

    def _ways(self, scene: Scene) -> Iterable[Html]:
        taken = [set(action.split()[1:]) for action in scene.actions]
        for first, second in self.ground.ways:
            (x1, y1), (x2, y2) = self._spots[first].at, self._spots[second].at
            live = " now" if any(each.issuperset((first, second)) for each in taken) else ""
            key = f"way {first} {second}"
            yield tag("line", data_key=key, class_=f"way{live}", x1=x1, y1=y1, x2=x2, y2=y2)

    def _place(self, name: str, about: Whereabouts) -> Html:
        spot = self._spots[name]
        mark = self._mark(name, about)
        inside: list[Html] = []
        x, y = spot.at
        if spot.shape == "row" and spot.to is not None:
            inside += shapes.trellis(spot.at, spot.to)
            label = (spot.to[0], spot.to[1] - 18)
        elif spot.shape == "house":
            roof = f"M{x - 62:g} {y - 8:g} L{x:g} {y - 40:g} L{x + 62:g} {y - 8:g} Z"
            inside.append(tag("path", d=roof, class_="roof"))
            inside.append(
                tag("rect", x=x - 54, y=y - 8, width=108.0, height=44.0, class_="building")
            )
            label = (x, y + 61)
        else:
            inside.append(tag("circle", cx=x, cy=y, r=30.0, class_="stop"))
            label = (x, y - 40)
        said = self.ground.lexicon.object_words(name).removeprefix("the ")
        words = f"{said} {mark.sign}".strip() if mark else said
        tone = f" {mark.tone}" if mark else ""
        inside.append(
            tag("text", words, x=label[0], y=label[1], class_=f"name{tone}", text_anchor="middle")
        )
        return self._group(f"place {name}", name, inside, "place")

    # -- what changes ----------------------------------------------------------------------------

    def _things(
        self, held: Mapping[str, Sequence[Whereabouts]], where: Mapping[str, Whereabouts]
    ) -> Iterable[Html]:
        """Whatever is at a place, or nowhere that is known; what is on a robot moves with it."""
        things = set(self.ground.things)
        for place in self.ground.places:
            here = [each for each in held.get(place, ()) if each.thing in things]
            for (x, y), each in zip(self._slots(place, len(here)), here, strict=True):
                yield self._thing(each, x, y, held)
        lost = [where[name] for name in self.ground.things if where[name].holder is None]
        if lost:
            yield tag("text", "no place known:", x=24.0, y=HEIGHT - 56, class_="name",
                      data_key="no place")  # fmt: skip
        for index, each in enumerate(lost):
            yield self._thing(each, 40 + 46.0 * index, HEIGHT - 30, held)

    def _slots(self, place: str, count: int) -> Iterable[Point]:
        spot = self._spots[place]
        x, y = spot.at
        if spot.shape == "row" and spot.to is not None:
            for index in range(count):
                share = (index + 1) / (count + 1)
                yield x + (spot.to[0] - x) * share, y + (spot.to[1] - y) * share
        else:
            for index in range(count):
                yield x + (index - (count - 1) / 2) * 34, y + (14 if spot.shape == "house" else 0)

    def _thing(
        self, about: Whereabouts, x: float, y: float, held: Mapping[str, Sequence[Whereabouts]]
    ) -> Html:
        inside = self._figure(about, held)
        return self._group(f"thing {about.thing}", about.thing, inside, "thing", (x, y))

    def _figure(self, about: Whereabouts, held: Mapping[str, Sequence[Whereabouts]]) -> list[Html]:
        """A thing drawn around 0, 0: its shape by its type, its tone by what is true of it."""
        mark = self._mark(about.thing, about) or Mark("plain", "")
        shape = self._shape(about.thing)
        words = self._told(about)
        if shape == "grape":
            parts = [tag("title", words), *shapes.bunch(mark)]
        elif shape == "box":
            within = [each for each in held.get(about.thing, ()) if each.thing != about.thing]
            parts = [tag("title", words), *shapes.box(mark, len(within))]
            parts += [
                tag("circle", cx=-9 + 9.0 * i, cy=3.0, r=4.0, class_="content", data_thing=e.thing)
                for i, e in enumerate(within[:3])
            ]
        else:
            letter = _name(self.ground, about.thing)[:2]
            parts = [
                tag("title", words),
                tag("rect", x=-15.0, y=-15.0, width=30.0, height=30.0, rx=6.0,
                    class_=f"item {mark.tone}"),
                tag("text", mark.sign or letter, class_="sign", text_anchor="middle", y=6.0),
            ]  # fmt: skip
        return parts

    def _robots(
        self,
        held: Mapping[str, Sequence[Whereabouts]],
        where: Mapping[str, Whereabouts],
        scene: Scene,
    ) -> Iterable[Html]:
        robots = self.ground.robots
        acting = {word for action in scene.actions for word in action.split()[1:2]}
        if scene.actions and not acting & set(robots):
            acting = {*robots[:1]}  # the domain does not say which robot acts
        at: dict[str, int] = {}
        for number, robot in enumerate(robots):
            place = where[robot].holder or ""
            index = at[place] = at.get(place, -1) + 1
            load = [each for each in held.get(robot, ()) if each.thing not in robots]
            inside = [tag("title", self._told(where[robot]))]
            inside += shapes.robot(number, busy=robot in acting)
            for i, each in enumerate(load):
                x = 36 * (i - (len(load) - 1) / 2)
                figure = tag("g", *self._figure(each, held), transform=f"translate({x:g} -30)")
                inside.append(tag("g", figure, class_="load", data_thing=each.thing))
            name = _name(self.ground, robot)
            inside.append(tag("text", name, class_="name", text_anchor="middle", y=38.0))
            classes = "robot busy" if robot in acting else "robot"
            yield self._group(f"thing {robot}", robot, inside, classes, self._stand(place, index))

    def _stand(self, place: Place, index: int) -> Point:
        """Where the first, second ... robot stands at a place: beside it, so that one sees both."""
        spot = self._spots.get(place)
        if spot is None:
            return 40 + 60.0 * index, HEIGHT - 80
        x, y = spot.at
        if spot.shape == "row":
            return x + 60.0 * index, y + 24
        if spot.shape == "house":
            return x - 190 + 60.0 * index, y + 6
        side = -1 if index % 2 == 0 else 1
        return x + side * (54.0 + 54 * (index // 2)), y + 6

    def _group(
        self, key: str, thing: str, inside: Sequence[Html], classes: str, at: Point | None = None
    ) -> Html:
        style = None if at is None else f"transform:translate({at[0]:g}px,{at[1]:g}px)"
        return tag("g", *inside, data_key=key, data_thing=thing, class_=classes, style=style)

    # -- how it looks ----------------------------------------------------------------------------

    def _shape(self, name: str) -> str:
        shapes = self.ground.layout.shapes
        return next((shapes[t] for t in self.ground.lexicon.types_of(name) if t in shapes), "item")

    def _mark(self, name: str, about: Whereabouts) -> Mark | None:
        """The mark of what is true of a thing: as the layout has it, or one tone for each fact."""
        types, known = self.ground.lexicon.types_of(name), self.ground.layout.marks
        styled = any(key[0] in types for key in known)
        for predicate in reversed(about.marks) if not styled else about.marks:
            for type_ in types:
                if (type_, predicate) in known:
                    return known[type_, predicate]
            if not styled:
                order = [p for p in self.ground.problem.domain.predicates
                         if p in self.ground.problem.changing_predicates]  # fmt: skip
                return Mark(_TONES[order.index(predicate) % len(_TONES)], predicate[0].upper())
        return None

    def _told(self, about: Whereabouts) -> str:
        """What is true of a thing, for whoever points at it."""
        lexicon = self.ground.lexicon
        facts = [lexicon.clause(f"{mark} {about.thing}").said() for mark in about.marks]
        return "; ".join(facts) or _name(self.ground, about.thing)


@dataclass(frozen=True, slots=True)
class LegendEntry:
    """A mark and its words."""

    mark: Mark
    shape: str
    words: str


def legend(drawing: Drawing) -> tuple[LegendEntry, ...]:
    """What the tones mean that a layout gives."""
    layout = drawing.ground.layout
    return tuple(
        LegendEntry(
            mark, layout.shapes.get(type_, "item"), f"{predicate.replace('-', ' ')} {type_}"
        )
        for (type_, predicate), mark in layout.marks.items()
    )


def _name(ground: Ground, name: str) -> str:
    return (
        "robot"
        if name == ground.lexicon.me
        else ground.lexicon.object_words(name).removeprefix("the ")
    )
