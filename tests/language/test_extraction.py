"""Sentences and the formulas they mean: literal readings, compared over all finite traces."""

# ruff: noqa: E501
# A sentence and its formula read best side by side.

import pytest
from tests.language.domains import DOMAINS

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.extraction import Status, extract
from plainspoken.logic.syntax import parse, unparse

LITERAL = {
    "vineyard": """
        Visit line 1. | F l1
        Go to row two. | F l2
        Please drive to the warehouse. | F wh
        Could you go to the depot, please? | F wh
        I'd like you to visit line 1 and line 3. | F l1 & F l3
        Visit lines 1, 2 and 3 in any order. | F l1 & F l2 & F l3
        Visit line 1, line 2, and the warehouse. | F l1 & F l2 & F wh
        Line 1 and line 2 must be visited. | F l1 & F l2
        You have to go to line 3 at some point. | F l3
        Eventually reach line 0. | F l0
        Visit line 1 or line 2. | F(l1 | l2)
        Go to either the warehouse or line 3. | F(wh | l3)
        Harvest a grape. | F harvest
        Make sure that the box is full at some point. | F full
        Clear line 2. | F cleared2
        Make sure line 2 is cleared. | F cleared2
        I want line 1 cleared. | F cleared1
        Please see to it that line 2 is cleared and line 1 is cleared. | F cleared1 & F cleared2
        Line 2 must be cleared. | F cleared2
        Go to line 2 and clear it. | F l2 & F cleared2
        Get line 1 cleared. | F cleared1
        Go to line 1, then line 2. | F(l1 & F l2)
        Go to line 1, then to line 2, and finally to the warehouse. | F(l1 & F(l2 & F wh))
        First visit line 3, then visit line 1. | F(l3 & F l1)
        Visit line 1. Then line 3. | F(l1 & F l3)
        Visit line 1 and after that go to line 2. | F(l1 & F l2)
        After visiting line 2, go to line 3. | F(l2 & F l3)
        Go to line 3 after line 2. | F(l2 & F l3)
        Check a grape, then harvest a grape. | F(check & F harvest)
        Visit lines 1, 2 and 3 in that order. | F(l1 & F(l2 & F l3)) & (!l2 U l1) & (!l3 U l2)
        Visit line 1 before line 2. | F(l1 & F l2) & (!l2 U l1)
        Before going to line 2, visit line 1. | F(l1 & F l2) & (!l2 U l1)
        Go to line 1 and only then to line 2. | F(l1 & F l2) & (!l2 U l1)
        Go to line 1, then to line 2, but do not visit line 2 before line 1. | F(l1 & F l2) & (!l2 U l1)
        Go to line 2, but before that go to line 1. | F(l1 & F l2) & (!l2 U l1)
        Visit line 1, then line 2 in strict order, without revisiting any. | F(l1 & F l2) & (!l2 U l1) & (!l1 U (l1 U (!l1 U l2)))
        Visit line 1 exactly once, then go to line 2. | F(l1 & F l2) & (!l2 U l1) & (!l1 U (l1 U (!l1 U l2)))
        Never enter line 3. | G !l3
        Do not go to line 3. | G !l3
        Don't ever visit row 3! | G !l3
        Avoid line 1 and line 2. | G !l1 & G !l2
        Stay away from the warehouse at all times. | G !wh
        Steer clear of line 0. | G !l0
        Line 3 is off limits. | G !l3
        Line 3 must never be visited. | G !l3
        You must not visit line 1 or line 2. | G !l1 & G !l2
        Visit neither line 1 nor line 2. | G !l1 & G !l2
        Under no circumstances enter line 2. | G !l2
        Never harvest a grape. | G !harvest
        The box must never be full. | G !full
        Always stay out of line 2. | G !l2
        It is forbidden to enter line 1. | G !l1
        Do not harvest a grape until you have visited line 1. | !harvest U l1
        Do not visit line 2 until line 1 is cleared. | !l2 U cleared1
        Do not enter line 2 before visiting line 1. | !l2 U l1
        Avoid line 3 until the box is full. | !l3 U full
        Until the box is full, do not call the support robot. | !call U full
        No grape may be harvested before line 1 has been visited. | !harvest U l1
        Call the support robot only after visiting line 1. | !call U l1
        Only after the box is full may you call the support robot. | !call U full
        Check a grape before harvesting a grape. | !harvest U check
        After visiting line 2, never go back to line 1. | G(l2 -> X G !l1)
        Once the box is full, never harvest a grape again. | G(full -> X G !harvest)
        Never visit line 1 after line 2. | G(l2 -> X G !l1)
        You may visit line 1, but you must not go to line 2 after that. | G(l1 -> X G !l2)
        After you have called the support robot, avoid line 2. | G(call -> X G !l2)
        Stay at line 1 until the box is full. | l1 U full
        Wait in line 2 until the support robot is called. | l2 U call
        Do not leave line 1 until the box is full. | l1 U full
        Remain at the warehouse till line 1 is cleared. | wh U cleared1
        Until a human is present, stay at line 0. | l0 U human
        Whenever the box is full, call the support robot. | G(full -> F call)
        If the bin gets full, the support robot must be called. | G(full -> F call)
        When the box becomes full, go to the warehouse. | G(full -> F wh)
        Every time you visit line 1, check a grape. | G(l1 -> F check)
        You must go to line 2 after you visit line 1. | G(l1 -> F l2)
        If grape 0 is ripe, harvest a grape eventually. | G(ripe0 -> F harvest)
        Call the support robot whenever the box is full. | G(full -> F call)
        If grape 0 is not ripe, ask a human. | G(!ripe0 -> F ask)
        If grape 0 is unripe, ask a human. | G(unripe0 -> F ask)
        If the box is empty, harvest a grape. | G(!full -> F harvest)
        After harvesting a grape, drop a grape in the box. | G(harvest -> F drop)
        As soon as the box is full, call the support robot. | G(full -> X call)
        Call the support robot as soon as the bin gets full. | G(full -> X call)
        When the box is full, immediately call the support robot. | G(full -> X call)
        Right after visiting line 1, check a grape. | G(l1 -> X check)
        Once you reach line 2, go to line 3 right away. | G(l2 -> X l3)
        Whenever a grape is harvested, drop a grape in the box in the next step. | G(harvest -> X drop)
        The moment the box is full, go to the warehouse. | G(full -> X wh)
        As soon as the box is full, call the support robot, and at no other time. | G(full <-> X call)
        Call the support robot right after the box gets full, and never otherwise. | G(full <-> X call)
        You cannot call the support robot without visiting line 1 right before, and you cannot visit line 1 without calling the support robot right after that. | G(l1 <-> X call)
        Never enter line 3 while the bin is full. | G(full -> !l3)
        While the box is full, do not enter line 3. | G(full -> !l3)
        If the box is full, never harvest a grape. | G(full -> !harvest)
        Harvest a grape only if grape 0 is ripe. | G(harvest -> ripe0)
        Only harvest a grape when the box is not full. | G(harvest -> !full)
        Never harvest a grape unless grape 1 is ripe. | G(harvest -> ripe1)
        Do not visit line 2 unless you have visited line 1. | !l2 U l1
        Visit line 1 at least twice. | F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Visit line 1 twice or more. | F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Do not visit line 1 more than once. | !F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Go to line 1 at most one time. | !F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Visit line 1 no more than once. | !F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Visit line 1 exactly once. | F l1 & !F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Visit line 1 once and never again. | F l1 & !F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Patrol line 1 and line 2. | G F l1 & G F l2
        Keep visiting line 3. | G F l3
        Visit line 1 again and again. | G F l1
        Clear line 2, but never enter line 3 while the bin is full, and call the support robot as soon as it is. | F cleared2 & G(full -> !l3) & G(full -> X call)
        Visit line 1 and line 2, but avoid line 3. | F l1 & F l2 & G !l3
        Go to line 1 without passing through line 2. | F l1 & G !l2
        Go to line 1; never enter line 2. | F l1 & G !l2
        Visit line 1, and if the box is full, call the support robot. | F l1 & G(full -> F call)
        When the box is full and line 1 is cleared, go to the warehouse. | G((full & cleared1) -> F wh)
        If the box is full or a human is present, go to the warehouse. | G((full | human) -> F wh)
        Never enter any line. | G !l0 & G !l1 & G !l2 & G !l3
        Visit every line. | F l0 & F l1 & F l2 & F l3
        Visit lines 1 to 3. | F l1 & F l2 & F l3
        Visit all lines except line 2. | F l0 & F l1 & F l3
        Visit line 1 or visit line 2, and never enter line 3. | (F l1 | F l2) & G !l3
        Box full? Call the support robot straight away. | G(full -> X call)
        When you see that the box is full you should call the support robot. | G(full -> F call)
        I want the robot to clear line 2 and then go to the depot. | F(cleared2 & F wh)
        Make sure line 2 is cleared before you visit line 3. | !l3 U cleared2
        Line 2 has to be cleared, then line 1. | F(cleared2 & F cleared1)
        Clear lines 1 and 2. | F cleared1 & F cleared2
        Clear line 1, then line 2. | F(cleared1 & F cleared2)
        You are not allowed to harvest a grape while the box is full. | G(full -> !harvest)
        No harvesting a grape while the box is full. | G(full -> !harvest)
        Harvesting a grape is forbidden while the box is full. | G(full -> !harvest)
        Never harvest a grape without checking a grape first. | !harvest U check
        Every time the box gets full, call the support robot and then empty the box. | G(full -> F(call & F empty))
        Go to line 1, but only if the box is empty. | F l1 & G(l1 -> !full)
        Row 3 first, would you, then row 2 whenever suits. | F(l3 & F l2)
        Don't forget to visit line 2. | F l2
        Unless the box is full, stay out of the warehouse. | G(wh -> full)
        Stay at line 1 until the box is full, then go to the warehouse. | l1 U (full & F wh)
        please go to line 1 and wait there until the box is full | F(l1 & (l1 U full))
        Go to line 1 and stay there. | F l1 & F G l1
        After line 1 visit line 2 and after line 2 visit line 3. | F(l1 & F(l2 & F l3))
        Call the support robot if and only if the box is full. | G(full <-> call)
        Harvest a grape, but not before line 1 has been visited. | F harvest & (!harvest U l1)
        You may only harvest a grape after you have checked a grape. | !harvest U check
        At no time should the robot be in line 3 with the box full. | G(full -> !l3)
        Make at least two visits to line 1. | F(l1 & (l1 U (!l1 & (!l1 U F l1))))
        Check a grape at line 1. | F(check & l1)
        Visit line 1, but before visiting line 1 go to line 2. | F l1 & F(l2 & F l1) & (!l1 U l2)
        Go to line 1 but not to line 2, and then go to line 2. | F(l1 & F l2) & (!l2 U l1)
        Do not go to line 1 until line 2 is visited and do not go to line 2 until line 3 is visited. | (!l1 U l2) & (!l2 U l3)
        When all lines are cleared, go to the warehouse. | G((cleared1 & cleared2) -> F wh)
        If any grape is ripe, ask a human. | G((ripe0 | ripe1) -> F ask)
        """,
    "hospital": """
        Go to ward 1, then to ward 2, then back to the dock. | F(w1 & F(w2 & F dock))
        Hey robot, could you please swing by the pharmacy? | F pharmacy
        Deliver the medicine. | F deliver
        The medicine must be delivered. | F deliver
        Don't go into ward 3 while the floor is wet. | G(spill -> !w3)
        Keep out of the lab as long as the fire alarm is on. | G(alarm -> !lab)
        If the battery is low, go to the charging station. | G(low -> F dock)
        As soon as the battery gets low, head to the dock. | G(low -> X dock)
        Whenever the fire alarm is on, call a nurse immediately. | G(alarm -> X nurse)
        Do not deliver the medicine before you have been to the pharmacy. | !deliver U pharmacy
        Never deliver the medicine while the medicine cabinet is unlocked. | G(!locked -> !deliver)
        Wait in the lobby until room 12 is free. | lobby U !occupied
        Do not enter the lab until the blood sample has been collected. | !lab U sample
        Collect the blood sample and then go to the laboratory. | F(sample & F lab)
        Disinfect the room only if room 12 is not occupied. | G(disinfect -> !occupied)
        Visit wards 1, 2 and 3. | F w1 & F w2 & F w3
        Visit ward 1 and ward 2 in any order, but stay away from ward 3. | F w1 & F w2 & G !w3
        Once the blood sample is collected, never visit ward 2 again. | G(sample -> X G !w2)
        Before delivering the medicine, go to the pharmacy. | !deliver U pharmacy
        You shouldn't visit the lobby more than twice. | !F(lobby & (lobby U (!lobby & (!lobby U F(lobby & (lobby U (!lobby & (!lobby U F lobby))))))))
        When the battery is low, recharge the battery. | G(low -> F recharge)
        Call a nurse right after the fire alarm is turned on. | G(alarm -> X nurse)
        Go to ward 1 and ward 2 and recharge the battery afterwards. | F(w1 & F recharge) & F(w2 & F recharge)
        Pop over to ward 2 and then come back to the lobby. | F(w2 & F lobby)
        I need you in ward 3. | F w3
        The lab is off-limits until the blood sample has been collected. | !lab U sample
        While the battery is low, don't leave the charging station. | G(low -> dock)
        Once you've delivered the medicine, return to the dock. | G(deliver -> F dock)
        After delivering the medicine, return to the dock and recharge the battery. | G(deliver -> F dock) & G(deliver -> F recharge)
        Don't deliver the medicine twice. | !F(deliver & (deliver U (!deliver & (!deliver U F deliver))))
        The medicine cabinet must stay locked. | G locked
        Ward 1 has to be visited before ward 2. | !w2 U w1
        Never be in the lab when the fire alarm is on. | G(alarm -> !lab)
        Do not call a nurse when you are in ward 1. | G(w1 -> !nurse)
        Go to all wards before delivering the medicine. | (!deliver U w1) & (!deliver U w2) & (!deliver U w3)
        Go to ward 2 after ward 1 but before ward 3. | F(w1 & F w2) & F(w2 & F w3) & (!w3 U w2)
        The battery is low. | reject
        Go to ward 1 or ward 2 but never both. | reject
        Go to ward 1 before leaving. | reject
        Go to ward 1 within five minutes. | reject
        Call a nurse and a doctor. | reject
        Bring the blood sample to the lab. | reject
        Always keep the medicine cabinet locked. | G locked
        Make sure that the medicine cabinet is never unlocked. | G locked
        Do either: go to ward 1 or call a nurse. | F w1 | F nurse
        Wait for the battery to be low before going to the dock. | !dock U low
        If you see that the floor is wet, call a nurse, and then disinfect the room. | G(spill -> F(nurse & F disinfect))
        Lock the medicine cabinet before you go to the lab. | !lab U locked
        """,
    "warehouse": """
        Go to aisle A, then aisle B, then aisle C. | F(a & F(b & F c))
        Never enter aisle B while the forklift is moving. | G(forklift -> !b)
        Scan the parcel, then go to the packing station. | F(scan & F pack)
        Don't wrap the pallet until the parcel is scanned. | !wrap U scanned
        If the corridor is blocked, alert the supervisor at once. | G(blocked -> X alert)
        The supervisor must be alerted whenever the corridor is blocked. | G(blocked -> F alert)
        Wait at the loading bay until the truck is loaded. | load U loaded
        Pick up the parcel and wrap the pallet. | F pick & F wrap
        Visit the loading bay, but only after the parcel has been scanned. | F load & (!load U scanned)
        Stay out of aisle C unless the corridor is clear. | G(c -> !blocked)
        Visit aisle A at least three times. | F(a & (a U (!a & (!a U F(a & (a U (!a & (!a U F a))))))))
        After the truck is loaded, never go to aisle A. | G(loaded -> X G !a)
        Load the truck. | F loaded
        Make sure the truck gets loaded eventually. | F loaded
        Avoid aisle A, aisle B and aisle C at all costs. | G !a & G !b & G !c
        Whenever you pick up the parcel, scan the parcel in the very next step. | G(pick -> X scan)
        Go to the charger as soon as the truck is loaded and nowhere else. | G(loaded <-> X charger)
        Hit aisle A, aisle B, then the packing station. | F(a & F(b & F pack))
        Don't go anywhere near aisle B while the forklift is moving. | G(forklift -> !b)
        Pick up the parcel from aisle A and scan it. | F(pick & a) & F scan
        You need to visit at least one of aisle A, aisle B and aisle C. | F(a | b | c)
        Never pick up the parcel while in aisle C. | G(c -> !pick)
        No more than two trips to aisle A. | !F(a & (a U (!a & (!a U F(a & (a U (!a & (!a U F a))))))))
        Visit all aisles. | F a & F b & F c
        """,
    "kitchen": """
        Go to the sink and wash the dishes. | F sink & F wash
        As soon as the water is boiling, turn off the stove. | G(boiling -> X off)
        When the water boils, turn off the stove. | G(boiling -> F off)
        Never leave the stove while the pan is hot. | G(hot -> stove)
        Do not serve the soup until the counter is clean. | !serve U clean
        Chop the onions before you serve the soup. | !serve U chop
        Close the oven door. | F !open
        Never go to the fridge while the oven door is open. | G(open -> !fridge)
        If the counter is dirty, wash the dishes. | G(!clean -> F wash)
        Visit the stove, the sink and the fridge, in that order. | F(stove & F(sink & F fridge)) & (!sink U stove) & (!fridge U sink)
        Stay at the stove until the water is boiling. | stove U boiling
        After chopping the onions, wash the dishes right away. | G(chop -> X wash)
        Visit the dining table exactly once. | F table & !F(table & (table U (!table & (!table U F table))))
        The stove must be turned off right after serving the soup. | G(serve -> X off)
        Bring nothing. | reject
        Keep the oven door closed at all times. | G !open
        Never leave the oven door open. | G !open
        If the water is not boiling, do not serve the soup. | G(!boiling -> !serve)
        """,
    "streets": """
        go to lee nails | F lee_nails
        visit blue region red room and green room | F blue_region & F red_room & F green_room
        go to small red room and never visit red room | F small_red_room & G !red_room
        move to Chase Bank then go to Sorrento's Cafe & Bar | F(chase & F cafe)
        visit 5th Avenue & Main Street, but avoid Chase Bank | F fifth & G !chase
        you can go anywhere but yellow room | G !yellow_room
        navigate to red room while avoiding green room, then go to green room | F(red_room & F green_room) & (!green_room U red_room)
        visit blue region only once you have been to red room | F blue_region & (!blue_region U red_room)
        after you reach red room you can not move to green room | G(red_room -> X G !green_room)
        go from red room to green room to blue region | F(red_room & F(green_room & F blue_region))
        never enter any room | G !red_room & G !green_room & G !small_red_room & G !yellow_room
        visit every room except red room | F green_room & F small_red_room & F yellow_room
        """,
}

CASES = [
    (domain, *map(str.strip, line.split(" | ", 1)))
    for domain, table in LITERAL.items()
    for line in table.strip().splitlines()
]


@pytest.mark.parametrize(("domain", "sentence", "meant"), CASES)
def test_a_sentence_means_its_formula(domain: str, sentence: str, meant: str) -> None:
    extraction = extract(sentence, DOMAINS[domain], None)
    if meant == "reject":
        assert extraction.status is Status.REJECT
        return
    assert extraction.reading is not None, extraction.reason
    assert extraction.status is Status.OK, extraction.question
    literal = extraction.reading.literal
    assert equivalent(literal, parse(meant)), unparse(literal)
