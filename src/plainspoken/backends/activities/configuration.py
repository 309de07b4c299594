"""A robots' file: which services there are, and what each action of a domain is on them.

    services:                   # what can be called; `via` names the adapter
      drive: {via: http, begin: POST /drive, poll: GET /goals/{call}}
    actions:                    # every action that a mission may need
      move:
        do: {call: drive, with: {to: "{to}"}, as: "driving to {to}"}
    facts:                      # what can be sensed; all else is believed from the domain
      "robot-at {h} {l}": {call: where, with: {robot: "{h}"}, when: {place: "{l}"}}

All of it is checked against the domain and the services before anything moves. `docs/robots.md`
has every key.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

from plainspoken.backends.activities.adapter import BUNDLED, Adapter, Around, opened
from plainspoken.backends.activities.document import Section, Value, did_you_mean, read_yaml
from plainspoken.backends.activities.journal import Journal
from plainspoken.backends.activities.reading import (
    OF_EVERY_ACTION,
    ActivityReader,
    Scope,
    asked,
    expected,
    fact_of,
)
from plainspoken.backends.activities.robot import ActivityRobot
from plainspoken.knowledge.sqlite import SqliteDatabase
from plainspoken.knowledge.store import Store
from plainspoken.mission.repertoire import (
    TRIES,
    Ask,
    Conduct,
    Offer,
    Outcome,
    Repertoire,
    Sensor,
)
from plainspoken.mission.robot import Unreachable
from plainspoken.mission.service import Service
from plainspoken.mission.template import Table
from plainspoken.world.domain import (
    Action,
    Effect,
    ForEach,
    OneOf,
    Parameter,
    Problem,
    State,
    Together,
    When,
)

ASK_KEYS = ("call", "with", "when", "unless")
FACT_KEYS = (*ASK_KEYS, "otherwise", "needed", "lasts", "tries", "at_first")


@contextmanager
def robot_from(
    path: Path,
    problem: Problem,
    store: Store,
    *,
    via: str | None = None,
    state: State | None = None,
) -> Iterator[ActivityRobot]:
    """The robot that a file describes; its connections end with the context.

    via:   the adapter of services that do not name one
    state: what is believed at first, None for the problem's s0
    store: keeps what is to be found again when the process ends
    raises InputFileError: with file, line and what was expected
    """
    with ExitStack() as stack:
        journal = Journal(store.database)
        around = Around(journal, store, via)
        repertoire, services = read_robots(path, problem, around, stack)
        yield ActivityRobot(problem, repertoire, services, journal, state=state)


def reached(path: Path, problem: Problem, via: str | None) -> dict[str, str]:
    """Try every service of a robots' file; what is wrong with each, empty where nothing is.

    raises InputFileError: when the file is wrong
    """
    found = {}
    with ExitStack() as stack:
        store = stack.enter_context(Store(SqliteDatabase(":memory:")))
        around = Around(Journal(store.database), store, via)
        for name, service in read_robots(path, problem, around, stack)[1].items():
            try:
                service.reach()
                found[name] = ""
            except Unreachable as error:
                found[name] = error.what
    return found


def read_robots(
    path: Path, problem: Problem, around: Around, stack: ExitStack
) -> tuple[Repertoire, Mapping[str, Service]]:
    """Read and check a robots' file, and open the adapters that it names.

    stack: closes them
    raises InputFileError: with file, line and what was expected
    """
    file = read_yaml(path)
    file.only("services", "actions", "facts", "state", "objects", *BUNDLED)
    services, offers = _services(file, around, stack)
    reader = _Reader(file, problem, services, offers)
    return reader.repertoire(), services


def _services(
    file: Section, around: Around, stack: ExitStack
) -> tuple[dict[str, Service], dict[str, Offer]]:
    services: dict[str, Service] = {}
    offers: dict[str, Offer] = {}
    adapters: dict[str, Adapter] = {}
    for name, value in file.need("services", "what can be called").section():
        section = value.section()
        via = section.get("via")
        if via is None and around.via is None:
            section.need("via", f"how the service is reached: {', '.join(BUNDLED)}")
        kind = str(around.via) if via is None else via.text()
        if kind not in adapters:
            own = file.get(kind)
            settings = None if own is None else own.section()
            adapters[kind] = opened(kind, via or value, settings, around)
            stack.callback(adapters[kind].close)
        services[name] = adapters[kind].service(section)
        offers[name] = _offer(section, kind)
    return services, offers


def _offer(section: Section, kind: str) -> Offer:
    # People answer when they come to it.
    limit = math.inf if kind == "human" else Offer().limit
    return Offer(
        succeeds=section.mapping("succeeds"),
        reason=section.text("reason"),
        progress=section.text("progress") or "{progress}",
        doing=section.text("doing") or "{doing}",
        limit=section.positive("limit", limit),
    )


@dataclass(frozen=True)
class _Reader:
    """Reads what a domain's actions and facts are on these services."""

    file: Section
    problem: Problem
    services: Mapping[str, Service]
    offers: Mapping[str, Offer]

    def repertoire(self) -> Repertoire:
        objects = self._objects()
        sensors = tuple(self._sensors(objects))
        scene = self._scene()
        section = self.file.need("actions", "how each action of the domain is done").section()
        actions = {
            name: self._conduct(
                self._schema(name, section),
                value.section(),
                objects,
                seen=scene is not None or bool(sensors),
            )
            for name, value in section
        }
        missing = [a.name for a in self.problem.domain.actions if a.name not in actions]
        if missing:
            raise section.at.error(
                f"the domain has actions that are not here: {', '.join(missing)}",
                "a policy may need any of them; say how each is done",
            )
        return Repertoire(actions, self.offers, sensors, scene, objects)

    def _objects(self) -> dict[str, dict[str, object]]:
        """What is known of objects beside their names."""
        found = {}
        given = self.file.get("objects")
        for name, value in () if given is None else given.section():
            if name not in self.problem.objects:
                raise value.error(
                    f"the problem has no object {name!r}", did_you_mean(name, self.problem.objects)
                )
            value.section()
            found[name] = value.plain()
        return found

    def _schema(self, name: str, section: Section) -> Action:
        schemas = self.problem.action(name)
        if not schemas:
            known = [action.name for action in self.problem.domain.actions]
            raise section.keys[name].error(
                f"the domain has no action {name!r}", did_you_mean(name, known)
            )
        return schemas[0]

    def _conduct(self, schema: Action, section: Section, objects: Table, *, seen: bool) -> Conduct:
        """How an action is done; seen: whether something is sensed of what comes of it."""
        section.only("do", "outcomes")
        scope = Scope(
            self.problem, schema.parameters, objects, OF_EVERY_ACTION, tuple(self.services)
        )
        do = section.need("do", "the activity that the action is")
        activity = ActivityReader(scope, self.services).read(do)
        given = section.get("outcomes")
        if given is not None:
            return Conduct(activity, tuple(_outcome(item, scope) for item in given.items()))
        if not seen and _is_open(schema.effect):
            raise section.at.error(
                f"the action {schema.name!r} may turn out in several ways",
                "say under `outcomes` which result is which, or under `facts` how it is seen",
            )
        return Conduct(activity)

    def _sensors(self, objects: Table) -> Iterator[Sensor]:
        """How facts are sensed: the key is an atom with a placeholder for each argument."""
        given = self.file.get("facts")
        for atom, value in () if given is None else given.section():
            section = value.section()
            section.only(*FACT_KEYS)
            key = given.section().keys[atom] if given is not None else value
            parameters = self._sensed(key)
            scope = Scope(self.problem, parameters, objects)
            fact_of(key, scope)
            ways = self._ways(section, scope)
            needed = section.get("needed")
            only_needed = needed is not None and needed.flag()
            if not only_needed:
                self._refuse_slow(section, ways)
            lasts = section.positive("lasts", 0.0)
            tries = section.get("tries")
            yield Sensor(
                atom.lower(),
                parameters,
                ways,
                only_needed,
                lasts or None,
                TRIES if tries is None else tries.count(1),
                section.text("at_first") is not None
                and section.entries["at_first"].one_of(["unknown"]) == "unknown",
            )

    def _ways(self, section: Section, scope: Scope) -> tuple[Ask, ...]:
        """Who is asked about a fact, in this order."""
        ways = [self._way(section, scope)]
        otherwise = section.get("otherwise")
        for item in () if otherwise is None else otherwise.items():
            item.section().only(*ASK_KEYS)
            ways.append(self._way(item.section(), scope))
        return tuple(ways)

    def _way(self, section: Section, scope: Scope) -> Ask:
        service, fields = asked(section, self.services, scope)
        when = section.need("when", "what the result is where the fact holds: {field: value}")
        unless = section.get("unless")
        for each in (when, unless):
            if each is not None:
                scope.check(each)
        return Ask(service, fields, expected(when), None if unless is None else expected(unless))

    def _refuse_slow(self, section: Section, ways: tuple[Ask, ...]) -> None:
        """What every look at the world asks has to answer at once, and be one service."""
        for key in ("otherwise", "tries"):
            if key in section:
                raise section.keys[key].error(
                    f"{key!r} is for facts that are looked at when needed", "say `needed: true`"
                )
        if math.isinf(self.offers[ways[0].service].limit):
            raise section.entries["call"].error(
                "a person cannot be asked with every look at the world",
                "say `needed: true`: then they are asked when a decision or an answer needs it",
            )

    def _sensed(self, atom: Value) -> tuple[Parameter, ...]:
        """The placeholders of an atom, each with the types that the predicate asks for."""
        predicate, *terms = atom.text().lower().split() or [""]
        typed = self.problem.domain.predicates.get(predicate, ())
        return tuple(
            Parameter(term.strip("{}"), parameter.types)
            for term, parameter in zip(terms, typed, strict=False)
            if term.startswith("{")
        )

    def _scene(self) -> tuple[str, str] | None:
        """The service that tells all atoms that are true."""
        given = self.file.get("state")
        if given is None:
            return None
        section = given.section()
        section.only("call", "atoms")
        service, _ = asked(section, self.services, Scope(self.problem, (), {}))
        return service, section.need("atoms", "the field of the result that lists them").text()


def _outcome(item: Value, scope: Scope) -> Outcome:
    section = item.section()
    section.only("when", "facts")
    when = section.need("when", "what the result is then: {field: value}")
    facts = section.get("facts")
    read = () if facts is None else tuple(fact_of(fact, scope) for fact in facts.items())
    scope.check(when)
    return Outcome(expected(when), read)


def _is_open(effect: Effect) -> bool:
    """Whether an effect leaves it to chance how it turns out."""
    match effect:
        case OneOf(parts):
            return len(parts) > 1
        case Together(parts):
            return any(map(_is_open, parts))
        case When(_, part) | ForEach(_, part):
            return _is_open(part)
        case _:
            return False
