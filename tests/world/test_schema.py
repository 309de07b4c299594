"""Action schemas are read with the names, arities and variables of their domain checked.

What is refused, and on which line, stands in test_pddl.py; here is what the reader itself knows.
"""

from pathlib import Path

import pytest

from plainspoken.errors import InputFileError
from plainspoken.world.domain import (
    AllOf,
    AtomCondition,
    Domain,
    Exists,
    ForAll,
    Parameter,
)
from plainspoken.world.expression import PddlFile
from plainspoken.world.schema import SchemaReader

DOMAIN = Domain(
    "d",
    {"room": "object"},
    {"hall": "room"},
    {"lit": (Parameter("?r", ("room",)),), "link": (Parameter("?a"), Parameter("?b"))},
    (),
)


def reader(folder: Path, text: str, objects: dict[str, str] | None = None) -> SchemaReader:
    path = folder / "d.pddl"
    path.write_text(text)
    return SchemaReader(PddlFile(path), DOMAIN, objects)


def read(folder: Path, text: str, objects: dict[str, str] | None = None) -> object:
    one = reader(folder, text, objects)
    root = PddlFile(folder / "d.pddl").root
    return one.condition(root, root)


def test_a_domain_knows_its_constants_and_a_problem_its_objects(tmp_path: Path) -> None:
    assert read(tmp_path, "(lit hall)") == AtomCondition("lit", ("hall",))
    assert read(tmp_path, "(lit attic)", {"attic": "room"}) == AtomCondition("lit", ("attic",))
    with pytest.raises(InputFileError, match="there is no object 'attic'"):
        read(tmp_path, "(lit attic)")
    with pytest.raises(InputFileError, match="there is no object 'hall'"):
        read(tmp_path, "(lit hall)", {"attic": "room"})


def test_a_variable_is_bound_inside_its_quantifier_only(tmp_path: Path) -> None:
    both = "(and (exists (?x) (lit ?x)) (forall (?y - room) (exists (?x) (link ?x ?y))))"
    assert read(tmp_path, both) == AllOf(
        (
            Exists((Parameter("?x"),), AtomCondition("lit", ("?x",))),
            ForAll(
                (Parameter("?y", ("room",)),),
                Exists((Parameter("?x"),), AtomCondition("link", ("?x", "?y"))),
            ),
        )
    )
    with pytest.raises(InputFileError, match=r"the variable \?x is not bound"):
        read(tmp_path, "(and (exists (?x) (lit ?x)) (lit ?x))")


def test_an_inner_variable_hides_an_outer_one_of_its_name_and_gives_it_back(
    tmp_path: Path,
) -> None:
    text = "(:action a :parameters (?x) :precondition (and (exists (?x) (lit ?x)) (lit ?x)))"
    action = reader(tmp_path, text).action(PddlFile(tmp_path / "d.pddl").root)
    lit = AtomCondition("lit", ("?x",))
    assert action.precondition == AllOf((Exists((Parameter("?x"),), lit), lit))


def test_an_unknown_predicate_is_answered_with_those_there_are(tmp_path: Path) -> None:
    with pytest.raises(InputFileError) as caught:
        read(tmp_path, "\n(lid hall)")
    assert caught.value.line == 2
    assert caught.value.hint == "the predicates are link, lit"


@pytest.mark.parametrize(
    ("text", "warned"),
    [
        ("(lit hall)", False),
        ("(link hall desk)", False),
        ("(lit desk)", True),
        ("(exists (?x) (lit ?x))", False),
    ],
)
def test_an_object_of_another_type_than_the_predicate_takes_is_a_warning(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, text: str, *, warned: bool
) -> None:
    read(tmp_path, text, {"hall": "room", "desk": "object"})
    assert bool(caplog.messages) is warned
