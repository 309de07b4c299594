"""Which symbols an utterance speaks of, in domains and words that the rules have not been fitted to."""

import pytest
from tests.language.domains import vocabulary

from plainspoken.language.ellipsis import resolved
from plainspoken.language.extraction import Status, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.word import words

# ruff: noqa: E501
# A sentence and its symbols read best side by side.

DOMAINS: dict[str, tuple[Vocabulary, str]] = {
    "library": (
        vocabulary(
            """
            at_desk, l, the front desk, the counter
            at_attic, l, the attic
            at_hall, l, the reading hall
            at_s1, l, shelf 1
            at_s2, l, shelf 2
            at_s3, l, shelf 3
            scan_at_desk, c, the scanner is at the front desk
            scan_at_attic, c, the scanner is in the attic
            scan_at_hall, c, the scanner is in the reading hall
            scan_at_s1, c, the scanner is at shelf 1
            scan_at_s2, c, the scanner is at shelf 2
            scan_at_s3, c, the scanner is at shelf 3
            sorted_s1, c, shelf 1 is sorted
            sorted_s2, c, shelf 2 is sorted
            sorted_s3, c, shelf 3 is sorted
            returned_atlas, c, the atlas is returned
            returned_novel, c, the novel is returned
            returned_diary, c, the diary is returned
            torn_atlas, c, the cover of the atlas is torn
            torn_novel, c, the cover of the novel is torn
            torn_diary, c, the cover of the diary is torn
            lamp, c, the lamp is on
            stamp_executed, a, to stamp a book
            catalogue_executed, a, to catalogue a book
            mend_executed, a, to mend a book
            librarian_executed, a, to call the librarian
            dust_executed, a, to dust a shelf
            lamp_on_executed, a, to switch the lamp on
            lamp_off_executed, a, to switch the lamp off
            """
        ),
        """
        The scanner goes to shelf 2. | scan_at_s2
        Have the scanner at the front desk at noon. | scan_at_desk
        You and the scanner must never be at shelf 1 at the same time. | at_s1 scan_at_s1
        Never may both robots be at shelf 2. | at_s2 scan_at_s2
        Keep the scanner out of the attic. | scan_at_attic
        Do not enter the attic before the scanner does. | at_attic scan_at_attic
        Never visit any shelf that is not sorted. | sorted_s1 at_s1 sorted_s2 at_s2 sorted_s3 at_s3
        Scanner, stay in the attic until the lamp is on. | scan_at_attic lamp
        Send the scanner to shelf 1 and then to shelf 3. | scan_at_s1 scan_at_s3
        While the scanner is in the reading hall, stay out of the reading hall. | scan_at_hall at_hall
        Wait at shelf 3 until the scanner gets there. | at_s3 scan_at_s3
        Visit shelf 1 before the scanner reaches shelf 1. | at_s1 scan_at_s1
        The scanner must never be in the attic. | scan_at_attic
        The atlas, the novel and the diary must be returned. | returned_atlas returned_novel returned_diary
        Get the atlas or the diary returned. | returned_atlas returned_diary
        If the cover of the novel is torn, mend a book. | torn_novel mend_executed
        Get the novel returned, and if its cover is torn, call the librarian. | returned_novel torn_novel librarian_executed
        Neither the atlas nor the novel may be returned before the lamp is on. | returned_atlas returned_novel lamp
        All shelves must be sorted. | sorted_s1 sorted_s2 sorted_s3
        Sort shelf 1, then shelf 2. | sorted_s1 sorted_s2
        Shelf 3 sorted, then shelf 1 sorted. | sorted_s3 sorted_s1
        Visit shelf 2 and sort it. | at_s2 sorted_s2
        No stamping before shelf 1 is sorted. | stamp_executed sorted_s1
        Catalogue, then stamp. | catalogue_executed stamp_executed
        After every mending, call the librarian. | mend_executed librarian_executed
        Never stamp a book while the lamp is off. | stamp_executed lamp
        Switch the lamp on, and later switch it off. | lamp_on_executed lamp_off_executed
        None of the shelves may be sorted. | sorted_s1 sorted_s2 sorted_s3
        Every book has to be returned. | returned_atlas returned_novel returned_diary
        The diary should be returned, but not before the atlas is. | returned_diary returned_atlas
        Shelves one and two, please. | at_s1 at_s2
        Go to all the shelves except shelf 2. | at_s1 at_s3
        The cataloguing of a book comes first. | catalogue_executed
        """,
    ),
    "hospital": (
        vocabulary(
            """
            at_porter_w1, l, ward 1, the porter is at ward 1
            at_porter_w2, l, ward 2, the porter is at ward 2
            at_porter_w3, l, ward 3, the porter is at ward 3
            at_porter_lab, l, the laboratory, the lab, the porter is at the laboratory
            at_porter_lift, l, the lift, the elevator, the porter is at the lift
            at_washer_w1, c, the washer robot is at ward 1
            at_washer_w2, c, the washer robot is at ward 2
            at_washer_w3, c, the washer robot is at ward 3
            at_washer_lab, c, the washer robot is at the laboratory
            at_washer_lift, c, the washer robot is at the lift
            clean_w1, c, ward 1 is clean
            clean_w2, c, ward 2 is clean
            clean_w3, c, ward 3 is clean
            infected_w1, c, ward 1 is infected
            infected_w2, c, ward 2 is infected
            infected_w3, c, ward 3 is infected
            delivered_blood, c, the blood sample is delivered
            delivered_urine, c, the urine sample is delivered
            broken_lift, c, the lift is broken
            porter_executes_drive, a, the porter drives, to drive the porter
            washer_executes_drive, a, the washer robot drives, to drive the washer robot
            disinfect_executed, a, to disinfect a ward
            collect_executed, a, to collect a sample
            nurse_executed, a, to call a nurse
            doctor_executed, a, to ask the doctor
            """
        ),
        """
        The porter heads for the lab. | at_porter_lab
        Porter to ward 3, please. | at_porter_w3
        The washer goes into ward 2 at least twice. | at_washer_w2
        Never let the washer robot enter the lift. | at_washer_lift
        The washer robot must not be driving while ward 1 is infected. | washer_executes_drive infected_w1
        Take the porter to ward 1 and then to the elevator. | at_porter_w1 at_porter_lift
        Ward 1 and ward 2 have to be clean. | clean_w1 clean_w2
        Clean ward 3 and ward 1. | clean_w3 clean_w1
        Once the blood sample has been delivered, go to the lift. | delivered_blood at_porter_lift
        Deliver the blood sample and the urine sample. | delivered_blood delivered_urine
        All samples must be delivered. | delivered_blood delivered_urine
        If the lift is faulty, call a nurse. | broken_lift nurse_executed
        Disinfection of a ward is followed by a call for a nurse. | disinfect_executed nurse_executed
        After the collection, ask the doctor. | collect_executed doctor_executed
        Consult the doctor whenever ward 2 becomes infected. | doctor_executed infected_w2
        Go to ward 2 only if it is clean. | at_porter_w2 clean_w2
        As long as ward 3 is dirty, stay away from it. | clean_w3 at_porter_w3
        If any ward is infected, call a nurse. | infected_w1 infected_w2 infected_w3 nurse_executed
        The washer is at ward 1 when the porter is at ward 2. | at_washer_w1 at_porter_w2
        Wards 1 to 3 must be clean. | clean_w1 clean_w2 clean_w3
        No disinfecting until ward 1, ward 2 and ward 3 are clean. | disinfect_executed clean_w1 clean_w2 clean_w3
        """,
    ),
    "greenhouse": (
        vocabulary(
            """
            at_bed_1, l, bed 1
            at_bed_2, l, bed 2
            at_shed, l, the tool shed, the shed
            at_gate, l, the gate, the entrance
            open_gate, c, the gate is open
            dry_1, c, the soil of bed 1 is dry
            dry_2, c, the soil of bed 2 is dry
            planted_rose, c, the rose is planted
            planted_fern, c, the fern is planted
            in_pot_rose, c, the rose is in the pot
            in_pot_fern, c, the fern is in the pot
            hold_rose, c, the robot is holding the rose
            hold_fern, c, the robot is holding the fern
            pump, c, the pump is jammed
            irrigate_executed, a, to irrigate a bed
            prune_executed, a, to prune a plant
            weed_executed, a, to weed a bed
            gardener_executed, a, to call the gardener
            open_executed, a, to open the gate
            vents_executed, a, to adjust the vents
            """
        ),
        """
        Put the rose in the pot. | in_pot_rose
        Get the fern into the pot, then get it planted. | in_pot_fern planted_fern
        The rose has to end up in the pot. | in_pot_rose
        Plant the rose and the fern. | planted_rose planted_fern
        Hold neither the rose nor the fern. | hold_rose hold_fern
        If the pump gets stuck, call the gardener. | pump gardener_executed
        When the entrance is open, go to the shed. | open_gate at_shed
        Open the gate. | open_executed
        Prune once the rose is planted. | prune_executed planted_rose
        Irrigation is forbidden while the soil of bed 1 is dry. | irrigate_executed dry_1
        Whenever bed 2's soil is dry, go to bed 2. | dry_2 at_bed_2
        Go to bed one and bed two, never to the entrance. | at_bed_1 at_bed_2 at_gate
        Adjustment of the vents comes after weeding. | vents_executed weed_executed
        Hold the rose until it is planted. | hold_rose planted_rose
        Keep the gate open. | open_gate
        The rose or the fern, at least one of them has to be planted. | planted_rose planted_fern
        The rose should be planted, and the fern too. | planted_rose planted_fern
        """,
    ),
    "airport": (
        vocabulary(
            """
            at_tug_g1, l, gate 1
            at_tug_g2, l, gate 2
            at_tug_belt, l, the baggage belt, the belt
            at_tug_fuel, l, the fuel station
            at_lifter_g1, c, the lifter is at gate 1
            at_lifter_g2, c, the lifter is at gate 2
            at_lifter_belt, c, the lifter is at the baggage belt
            at_lifter_fuel, c, the lifter is at the fuel station
            loaded_trunk, c, the trunk is loaded, to load the trunk
            loaded_crib, c, the crib is loaded, to load the crib
            lost_trunk, c, the trunk is lost
            lost_crib, c, the crib is lost
            boarding_g1, c, gate 1 is boarding
            boarding_g2, c, gate 2 is boarding
            fuel_low, c, the fuel is low
            refuel_executed, a, to refuel the tug
            sort_executed, a, to sort a bag
            tag_executed, a, to tag a bag
            agent_executed, a, to notify the agent
            """
        ),
        """
        Load the trunk and the crib, in any order. | loaded_trunk loaded_crib
        If the trunk or the crib gets lost, notify the agent. | lost_trunk lost_crib agent_executed
        Tag, sort, and go to gate 2. | tag_executed sort_executed at_tug_g2
        Keep the lifter at gate 1 until the trunk is loaded. | at_lifter_g1 loaded_trunk
        As soon as the lifter arrives at the belt, notify the agent. | at_lifter_belt agent_executed
        No tagging while gate 1 is boarding. | tag_executed boarding_g1
        When the fuel runs low, refuel. | fuel_low refuel_executed
        Notification of the agent follows each loss of the trunk. | agent_executed
        The lifter may visit gate 2 at most once. | at_lifter_g2
        Let the lifter go to the fuel station and you go to the belt. | at_lifter_fuel at_tug_belt
        Load everything. | loaded_trunk loaded_crib
        The trunk is loaded before the crib. | loaded_trunk loaded_crib
        """,
    ),
    "streets": (
        vocabulary(
            """
            bakery, l, Miller's Bakery
            bank, l, First National Bank
            park, l, Lincoln Park
            station, l, Union Station
            museum, l, the Museum of Modern Art
            oak, l, Oak Street
            elm, l, Elm Street
            """
        ),
        """
        Head to Union Station, then Lincoln Park. | station park
        Never walk along Oak Street or Elm Street. | oak elm
        Swing by the bakery, but not before the bank. | bakery bank
        Stop at the museum of modern art after Miller's bakery. | museum bakery
        """,
    ),
}

CASES = [
    (name, *(part.strip() for part in line.split("|")))
    for name, (_, text) in DOMAINS.items()
    for line in text.strip().splitlines()
]


@pytest.mark.parametrize(("domain", "sentence", "symbols"), CASES)
def test_a_sentence_speaks_of_its_symbols(domain: str, sentence: str, symbols: str) -> None:
    _, found = resolved(words(sentence), DOMAINS[domain][0])
    assert [each.symbol for each in found if not each.rivals] == symbols.split()


REFUSED = {
    "library": """
        Mend the roof.
        Go to shelf 9.
        Stamp the passport.
        Catalogue the scanner.
        Never mend shelf 1.
        Never dust the atlas.
        Call the police.
        Switch the radio on.
        Visit shelf 1 and the cellar.
        If the cat is torn, call the librarian.
    """,
    "hospital": """
        Disinfect the porter.
        Call an ambulance.
        Collect the rubbish.
        Deliver the blood sample to ward 9.
        If ward 1 is on fire, call a nurse.
    """,
    "greenhouse": """
        Plant the tulip.
        Hold the door.
        Put the rose in the vase.
        Irrigate the tool shed.
    """,
    "airport": """
        Load the truck.
        Refuel the plane.
        Visit gate 3.
    """,
}


@pytest.mark.parametrize(
    ("domain", "sentence"),
    [(name, line.strip()) for name, text in REFUSED.items() for line in text.strip().splitlines()],
)
def test_what_the_domain_does_not_hold_is_no_symbol(domain: str, sentence: str) -> None:
    assert extract(sentence, DOMAINS[domain][0], None).status is not Status.OK


PARTICLES_AND_LETTERS = vocabulary(
    """
    lamp_on, c, the lamp is turned on
    lamp_off, c, the lamp is turned off
    pull_a_executed, a, to pull rope a
    pull_b_executed, a, to pull rope b
    pull_executed, a, to pull a rope
    has_key, c, rob has the key, the robot has the key
    """
)


@pytest.mark.parametrize(
    ("sentence", "symbol"),
    [
        ("Make sure that the lamp is turned on.", "lamp_on"),
        ("Make sure that the lamp is turned off.", "lamp_off"),
        ("Pull a rope.", "pull_executed"),
        ("Pull rope a.", "pull_a_executed"),
        ("Make sure that you have the key.", "has_key"),
    ],
)
def test_particles_letters_and_having_tell_symbols_apart(sentence: str, symbol: str) -> None:
    extraction = extract(sentence, PARTICLES_AND_LETTERS, None)
    assert {each.symbol for each in extraction.referring_expressions} == {symbol}
