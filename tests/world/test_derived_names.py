"""What is derived from ten domains in as many styles of naming, and how people speak of them.

Each world has phrases that were written for it before anyone had seen the names derived from it,
with the symbol that each speaks of.
"""

from functools import cache
from pathlib import Path

import pytest

from plainspoken.language.extraction import extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import unparse
from plainspoken.planning.solver import Unsolvable, solve
from plainspoken.questions.lexicon import Lexicon
from plainspoken.world.derivation import derived_landmarks
from plainspoken.world.domain import Problem
from plainspoken.world.landmark import Landmarks
from plainspoken.world.pddl import parse_domain, parse_problem
from plainspoken.world.symbol import resolve

WORLDS = Path(__file__).parent / "worlds"
NAMES = sorted(path.stem for path in WORLDS.glob("*.pddl"))
PHRASES = [
    (path.stem, *line.split("\t"))
    for path in sorted(WORLDS.glob("*.tsv"))
    for line in path.read_text().splitlines()
]
MISSED = {
    "Carry ball 1 in the right gripper.": "the gripper is the subject of carrying, not its place",
    "Unstack block b.": "the article in `block A` is dropped, so the joint act is heard",
    "Fly the airplane to airport 2.": "heard as flying it, and its being there at that instant",
    "Drive truck 2 to the post office.": "the same",
    "Make sure that the back door is closed.": "heard as the act of closing it",
    "Make sure that room 101 is locked.": "heard as the act of locking it",
    "Make sure that room 102 does not need cleaning.": "verbs other than `be` are not denied",
    "Send AGV 2 to the dock.": "`dock` is near `charge`",
    "Make sure that the engine is not out of water.": "`out of` denies `in`",
}
"""What does not ground to its symbol, and why."""


@cache
def world(name: str) -> Problem:
    domain, _, problem = (WORLDS / f"{name}.pddl").read_text().partition("\n(define (problem")
    return parse_problem(f"(define (problem{problem}", parse_domain(domain, name), name)


@cache
def landmarks(name: str) -> Landmarks:
    return derived_landmarks(world(name))


@cache
def vocabulary(name: str) -> Vocabulary:
    return Vocabulary.of(landmarks(name))


@pytest.mark.parametrize(
    ("name", "phrase", "symbol"), [each for each in PHRASES if each[1] not in MISSED]
)
def test_what_people_say_of_a_domain_grounds_to_its_symbols(
    name: str, phrase: str, symbol: str
) -> None:
    extraction = extract(phrase, vocabulary(name), None)
    assert extraction.reading is not None, extraction.reason
    assert atoms(extraction.reading.literal) == {symbol}


def test_what_is_known_to_be_missed_is_among_the_phrases() -> None:
    assert MISSED.keys() <= {phrase for _, phrase, _ in PHRASES}


@pytest.mark.parametrize("name", NAMES)
def test_every_derived_landmark_of_the_worlds_names_something(name: str) -> None:
    for id in landmarks(name):
        assert resolve(id, world(name)).id == id


@pytest.mark.parametrize(
    ("name", "id", "description"),
    [
        ("blocks", "on_a_b", "block A is on block B"),
        ("blocks", "ontable_a", "block A is on the table"),
        ("blocks", "clear_a", "block A is clear"),
        ("blocks", "handempty", "the hand is empty"),
        ("blocks", "stack_executed", "to stack a block"),
        ("gripper", "at_robby_rooma", "room A"),
        ("gripper", "at_ball1_kitchen", "ball 1 is in the kitchen"),
        ("gripper", "carry_ball1_left", "the left gripper is carrying ball 1"),
        ("gripper", "pick_executed", "to pick a ball"),
        ("logistics", "at_tru1_pos1", "truck 1 at position 1"),
        ("logistics", "in_obj11_apn1", "package 11 is in the airplane"),
        ("logistics", "load_truck_obj11_executed", "to load package 11 into a truck"),
        ("logistics", "unload_truck_obj11_executed", "to unload package 11 from a truck"),
        ("logistics", "drive_truck_paris_executed", "to drive a truck in Paris"),
        ("hospital", "robotat_medbot_wardeast", "the east ward"),
        ("hospital", "instock_morphine", "the morphine is in stock"),
        ("hospital", "hasmedicine_medbot_morphine", "Med Bot has the morphine"),
        ("hospital", "medicinedelivered_morphine_wardwest",
         "the morphine is delivered to the west ward"),
        ("hospital", "movethrough_backdoor_executed", "to move through the back door"),
        ("kitchen", "turned_on_hob1", "hob 1 is turned on"),
        ("kitchen", "put_away_frying_pan", "the frying pan is put away"),
        ("kitchen", "holds_gusteau_frying_pan", "Gusteau holds the frying pan"),
        ("kitchen", "not_full_sink", "the sink is not full"),
        ("kitchen", "dinner_is_ready", "dinner is ready"),
        ("kitchen", "smelly", "it is smelly"),
        ("kitchen", "walk_over_to_executed", "to walk over somewhere"),
        ("kitchen", "put_down_worktop_executed", "to put down a dish on the worktop"),
        ("hotel", "needs_cleaning_room101", "room 101 needs cleaning"),
        ("hotel", "wants_towels_ms_lee", "Ms Lee wants towels"),
        ("hotel", "checked_out_mr_brown", "Mr Brown is checked out"),
        ("hotel", "stays_in_mr_brown_room101", "Mr Brown stays in room 101"),
        ("hotel", "contains_trolley1_bath_towels", "the trolley contains the bath towels"),
        ("hotel", "bring_towels_to_ms_lee_executed", "to bring towels to Ms Lee"),
        ("depot", "low_battery_agv1", "the battery of AGV 1 is low"),
        ("depot", "blocked_l3", "location 3 is blocked"),
        ("depot", "stored_in_bin1_shelf_a", "bin 1 is stored in shelf A"),
        ("depot", "carries_agv1_bin1", "AGV 1 carries bin 1"),
        ("rovers", "at_soil_sample_waypoint0", "the soil sample is at waypoint 0"),
        ("rovers", "have_image_rover0_objective0_colour",
         "the rover has the colour image of objective 0"),
        ("rovers", "communicated_soil_data_waypoint0",
         "the soil data of waypoint 0 are communicated"),
        ("museum", "has_seen_anna_mona_lisa", "Anna has seen Mona Lisa"),
        ("museum", "waiting_for_anna_leonardo", "Anna is waiting for Leonardo"),
        ("museum", "lights_off_foyer", "the lights of the foyer are off"),
        ("museum", "say_goodbye_to_anna_executed", "to say goodbye to Anna"),
        ("brigade", "onfire_school", "the school is on fire"),
        ("brigade", "outofwater_engine7", "the engine is out of water"),
        ("brigade", "hasflattyre_engine7", "the engine has a flat tyre"),
        ("brigade", "trappedin_oldlady_school", "the old lady is trapped in the school"),
        ("brigade", "putoutfire_executed", "to put out the fire"),
    ],
)  # fmt: skip
def test_names_in_every_style_read_as_a_person_would_say_them(
    name: str, id: str, description: str
) -> None:
    assert landmarks(name)[id].description == description


WORKSHOP = """
(define (domain workshop)
  (:predicates (bench ?b) (at-bench ?b) (spare-in ?b) (light-off ?b) (hold-key) (have ?x)
               (is-focal-point ?b) (paint-colour ?b ?c) (tool ?x))
  (:action go :parameters (?a ?b) :precondition (and (bench ?a) (bench ?b) (at-bench ?a))
    :effect (and (at-bench ?b) (not (at-bench ?a))))
  (:action fix-1 :parameters (?b) :precondition (bench ?b)
    :effect (and (spare-in ?b) (light-off ?b) (hold-key) (is-focal-point ?b)))
  (:action fetch :parameters (?x) :precondition (tool ?x) :effect (have ?x))
  (:action paint :parameters (?b ?c) :precondition (and (bench ?b) (tool ?c))
    :effect (paint-colour ?b ?c)))
(define (problem one) (:domain workshop) (:objects bench1 bench2 saw file-2)
  (:init (bench bench1) (bench bench2) (at-bench bench1) (tool saw) (tool file-2)) (:goal (and)))
"""


@pytest.mark.parametrize(
    ("id", "description"),
    [
        ("spare_in_bench1", "the spare is in bench 1"),
        ("light_off_bench1", "the light of bench 1 is off"),
        ("hold_key", "the robot is holding the key"),
        ("have_saw", "the robot has the saw"),
        ("have_file_2", "the robot has file 2"),
        ("is_focal_point_bench2", "bench 2 is a focal point"),
        ("paint_colour_bench1_saw", "the paint colour of bench 1 is the saw"),
        ("fix_1_executed", "to fix a bench"),
    ],
)
def test_terse_names_of_planning_competitions_are_filled_in(id: str, description: str) -> None:
    domain, _, problem = WORKSHOP.partition("\n(define (problem")
    read = parse_problem(f"(define (problem{problem}", parse_domain(domain, "d"), "p")
    assert derived_landmarks(read)[id].description == description


def test_what_one_of_several_robots_does_to_one_thing_can_be_said() -> None:
    extraction = extract("Let AGV 2 pick up bin 1.", vocabulary("depot"), None)
    assert extraction.reading is not None, extraction.reason
    assert unparse(extraction.reading.literal) == "F pickup_bin_agv2_bin1_executed"


def test_what_never_comes_true_can_be_said_and_the_planner_says_that_it_never_does() -> None:
    extraction = extract("If bin 2 is damaged, repair it.", vocabulary("depot"), None)
    assert extraction.reading is not None, extraction.reason
    assert unparse(extraction.reading.literal) == ("G(damaged_bin2 -> F repair_bin_bin2_executed)")
    wished = extract("Make sure that bin 2 is damaged.", vocabulary("depot"), None)
    assert wished.formula is not None
    assert isinstance(solve(world("depot"), wished.formula), Unsolvable)


@pytest.mark.parametrize(
    ("name", "atom", "said"),
    [
        ("brigade", "isat engine7 school", "I'm at the school"),
        ("hotel", "needs_cleaning room101", "room 101 needs cleaning"),
        ("hotel", "wants_towels ms_lee", "Ms Lee wants towels"),
        ("kitchen", "smelly", "it is smelly"),
        ("kitchen", "holds gusteau frying-pan", "I hold the frying pan"),
        ("depot", "agv_at agv1 l2", "AGV 1 is at location 2"),
        ("depot", "low_battery agv1", "the battery of AGV 1 is low"),
    ],
)
def test_answers_use_the_names_that_are_derived(name: str, atom: str, said: str) -> None:
    assert Lexicon(world(name), landmarks(name)).clause(atom).said() == said


def test_the_bare_name_of_a_place_is_what_several_robots_share() -> None:
    lexicon = Lexicon(world("logistics"), landmarks("logistics"))
    assert lexicon.object_words("pos1") == "position 1"
    assert lexicon.deed("drive-truck tru1 pos1 post-office rome").bare.endswith("the post office")
