"""Domains and problems as values: types, bindings, what changes."""

from plainspoken.world.domain import (
    Action,
    Add,
    AllOf,
    AtomCondition,
    Delete,
    Domain,
    Effect,
    ForEach,
    OneOf,
    Parameter,
    Problem,
    Together,
    When,
    changed_atoms,
    ground,
)


def of(predicate: str, *terms: str) -> AtomCondition:
    return AtomCondition(predicate, terms)


TYPES = {"robot": "thing", "drone": "robot", "thing": "object"}
DOMAIN = Domain("d", TYPES, {}, {"p": (Parameter("?x", ("robot",)),)}, ())
OBJECTS = {"r": "robot", "box": "thing", "d": "drone", "hall": "place", "x": "object"}
PROBLEM = Problem("p", DOMAIN, OBJECTS, frozenset(), AllOf())


def names(*types: str) -> tuple[str, ...]:
    return PROBLEM.objects_for(Parameter("?x", types))


def test_a_type_is_below_itself_its_parent_and_so_on_to_object() -> None:
    assert list(DOMAIN.ancestors("drone")) == ["drone", "robot", "thing", "object"]
    assert list(DOMAIN.ancestors("object")) == ["object"]
    assert list(DOMAIN.ancestors("place")) == ["place", "object"]


def test_an_object_fits_its_type_and_every_type_above_in_the_order_of_the_file() -> None:
    assert names("drone") == ("d",)
    assert names("robot") == ("r", "d")
    assert names("thing") == ("r", "box", "d")
    assert names("object") == ("r", "box", "d", "hall", "x")
    assert names("ghost") == ()


def test_an_object_fits_any_of_several_types_once() -> None:
    assert names("place", "robot", "drone") == ("r", "d", "hall")
    assert names("ghost", "place") == ("hall",)
    assert names() == ()


def test_bindings_are_every_way_to_choose_the_last_place_changing_first() -> None:
    parameters = (Parameter("?a", ("robot",)), Parameter("?b", ("drone", "place")))
    assert list(PROBLEM.bindings(parameters)) == [
        {"?a": "r", "?b": "d"},
        {"?a": "r", "?b": "hall"},
        {"?a": "d", "?b": "d"},
        {"?a": "d", "?b": "hall"},
    ]
    assert list(PROBLEM.bindings(())) == [{}]
    assert list(PROBLEM.bindings((Parameter("?a", ("ghost",)),))) == []


def test_an_atom_is_grounded_by_its_binding_and_names_stay() -> None:
    assert ground(of("at", "?r", "hall"), {"?r": "d", "?s": "x"}) == "at d hall"
    assert ground(of("rain"), {}) == "rain"


def test_a_predicate_changes_if_any_outcome_anywhere_adds_or_deletes_it() -> None:
    effect: Effect = Together(
        (
            Add(of("a")),
            Delete(of("b")),
            When(of("read"), ForEach((), OneOf((Add(of("c")), Together((Delete(of("d")),)))))),
        )
    )
    actions = (Action("one", (), of("needed"), effect), Action("two", (), AllOf(), Add(of("e"))))
    problem = Problem("p", Domain("d", {}, {}, {}, actions), {}, frozenset(), AllOf())
    assert problem.changing_predicates == set("abcde")
    assert [(atom.predicate, added) for atom, added in changed_atoms(effect)] == [
        ("a", True),
        ("b", False),
        ("c", True),
        ("d", False),
    ]


def test_the_schemas_of_a_name_are_found_together() -> None:
    actions = tuple(Action(name, (), AllOf(), Together()) for name in ("go", "stay", "go"))
    problem = Problem("p", Domain("d", {}, {}, {}, actions), {}, frozenset(), AllOf())
    assert problem.action("go") == (actions[0], actions[2])
    assert problem.action("fly") == ()


def test_the_line_and_the_file_do_not_make_two_values_differ() -> None:
    assert Action("go", (), AllOf(), Together(), 3) == Action("go", (), AllOf(), Together(), 7)
    assert Problem("p", DOMAIN, OBJECTS, frozenset(), AllOf(), "elsewhere.pddl") == PROBLEM
