import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")

from tests.mission.small_vineyard import PROBLEM

from plainspoken.errors import InputFileError
from plainspoken.pipeline import Site, bundled, open_site
from plainspoken.questions.lexicon import Lexicon
from plainspoken.web.page.drawing import Drawing, Scene, legend
from plainspoken.web.page.ground import Ground
from plainspoken.web.page.layout import (
    HEIGHT,
    WIDTH,
    Layout,
    arranged,
    layout_from_json,
    read_layout,
)

EXAMPLES = ("vineyard", "kitchen", "warehouse")


def site(name: str) -> Site:
    folder = bundled(name)
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


def drawing(name: str, layout: Layout | None = None) -> Drawing:
    found = site(name)
    return Drawing(Ground(Lexicon(found.problem, found.landmarks), layout or Layout()))


def vineyard() -> Drawing:
    return drawing("vineyard", read_layout(bundled("vineyard") / "layout.json"))


def parts(svg: str) -> dict[str, ET.Element]:
    """What is drawn, by what it shows."""
    root = ET.fromstring(svg)  # noqa: S314 - our own picture
    return {each.attrib["data-key"]: each for each in root.iter() if "data-key" in each.attrib}


def at(element: ET.Element) -> tuple[float, float]:
    found = re.search(r"translate\((-?[\d.]+)px,(-?[\d.]+)px\)", element.attrib["style"])
    assert found
    return float(found[1]), float(found[2])


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_place_and_robot_of_a_domain_is_drawn_without_a_layout(name: str) -> None:
    made = drawing(name)
    found = parts(made.svg(Scene(site(name).problem.initial)))
    assert {f"place {place}" for place in made.ground.places} <= set(found)
    assert {f"thing {robot}" for robot in made.ground.robots} <= set(found)


@pytest.mark.parametrize(
    ("name", "robots", "places"),
    [
        ("vineyard", {"rob", "sup"}, {"l0", "l1", "l2", "l3", "wh"}),
        ("kitchen", {"rob"}, {"pantry", "fridge", "sink", "counter", "stove", "table"}),
        ("warehouse", {"cart", "fork"}, {"aisle-1", "aisle-2", "aisle-3", "bay", "desk", "plug"}),
    ],
)
def test_what_is_a_robot_and_what_a_place_follows_from_the_domain(
    name: str, robots: set[str], places: set[str]
) -> None:
    ground = drawing(name).ground
    assert set(ground.robots) == robots
    assert set(ground.places) == places
    assert ground.ways or name == "kitchen"


def test_the_same_state_gives_the_same_picture_and_another_one_moves_the_robot() -> None:
    made, initial = vineyard(), site("vineyard").problem.initial
    moved = (initial - {"robot-at rob l0"}) | {"robot-at rob l2"}
    before, after = made.svg(Scene(initial)), made.svg(Scene(moved))
    assert before == vineyard().svg(Scene(initial))
    assert at(parts(before)["thing rob"]) != at(parts(after)["thing rob"])
    others = [key for key in parts(before) if key != "thing rob"]
    assert all(ET.tostring(parts(before)[k]) == ET.tostring(parts(after)[k]) for k in others)


@pytest.mark.parametrize(
    ("mark", "tone"),
    [("unchecked", "unseen"), ("unknown", "doubt"), ("ripe", "good"), ("unripe", "bad")],
)
def test_a_grape_shows_what_is_known_of_it(mark: str, tone: str) -> None:
    state = (site("vineyard").problem.initial - {"unchecked g1"}) | {f"{mark} g1"}
    grape = ET.tostring(parts(vineyard().svg(Scene(state)))["thing g1"], encoding="unicode")
    assert f"berry {tone}" in grape
    assert mark in grape  # also in words


def test_a_grape_in_the_box_hangs_no_longer_on_its_line_and_the_box_fills() -> None:
    initial = site("vineyard").problem.initial
    picked = (initial - {"unchecked g2"}) | {"ripe g2", "picked g2", "inside g2 b", "full b"}
    svg = vineyard().svg(Scene(picked))
    assert "thing g2" not in parts(svg)
    robot = ET.tostring(parts(svg)["thing rob"], encoding="unicode")
    assert 'data-thing="g2"' in robot
    assert "crate doubt" in robot
    assert 'data-thing="g2"' not in ET.tostring(
        parts(vineyard().svg(Scene(initial)))["thing rob"], "unicode"
    )


def test_the_way_that_is_gone_and_the_robot_at_work_are_marked() -> None:
    found = parts(vineyard().svg(Scene(site("vineyard").problem.initial, ("move rob l0 l1",))))
    assert found["way l0 l1"].attrib["class"] == "way now"
    assert found["way l1 l2"].attrib["class"] == "way"
    assert found["thing rob"].attrib["class"] == "robot busy"
    assert found["thing sup"].attrib["class"] == "robot"


def test_a_map_says_in_words_where_the_robots_are() -> None:
    said = vineyard().described(site("vineyard").problem.initial)
    assert said == "Map of the site: robot at line 0, support robot at the warehouse."


def test_the_legend_names_what_the_layout_marks() -> None:
    assert "ripe grape" in [each.words for each in legend(vineyard())]


def test_neighbours_lie_nearer_than_others_and_the_map_is_the_same_tomorrow() -> None:
    names = [f"p{i}" for i in range(12)]
    ring = [(names[i], names[(i + 1) % 12]) for i in range(12)]
    spots = arranged(names, ring)
    assert spots == arranged(names, ring)

    def far(one: str, other: str) -> float:
        (a, b), (c, d) = spots[one], spots[other]
        return ((a - c) ** 2 + (b - d) ** 2) ** 0.5

    near = max(far(*pair) for pair in ring)
    assert near < far("p0", "p6")
    assert all(0 < x < WIDTH and 0 < y < HEIGHT for x, y in spots.values())
    assert len({(round(x), round(y)) for x, y in spots.values()}) == 12


@pytest.mark.parametrize("count", [0, 1, 2, 300])
def test_any_number_of_places_fits_on_the_map(count: int) -> None:
    spots = arranged([f"p{i}" for i in range(count)], [])
    assert len(spots) == count
    assert all(0 < x < WIDTH and 0 < y < HEIGHT for x, y in spots.values())


@pytest.mark.parametrize(
    ("document", "field"),
    [
        ([], "(top)"),
        ({"places": {"a": {}}}, "places.a.at"),
        ({"places": {"a": {"at": [1, "x"]}}}, "places.a.at"),
        ({"places": {"a": {"at": [1, 2], "shape": "castle"}}}, "places.a.shape"),
        ({"places": {"a": {"at": [1, 2], "shape": "row"}}}, "places.a.to"),
        ({"types": {"t": {"marks": {"p": {"tone": "mauve"}}}}}, "types.t.marks.p.tone"),
    ],
)
def test_a_wrong_layout_names_the_field(document: object, field: str) -> None:
    with pytest.raises(InputFileError) as caught:
        layout_from_json(document, Path("layout.json"))
    assert field in str(caught.value)


def test_a_layout_of_another_problem_does_no_harm() -> None:
    layout = layout_from_json({"places": {"moon": {"at": [1, 2]}}}, "x")
    made = Drawing(Ground(Lexicon(PROBLEM, {}), layout))
    assert "<svg" in made.svg(Scene(PROBLEM.initial))
