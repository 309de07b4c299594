"""Clauses, order, conditions, scope and counts: sentences and the literal formulas they mean."""

# ruff: noqa: E501
# A sentence and its formula read best side by side.

import pytest
from tests.language.domains import DOMAINS

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.extraction import Status, extract
from plainspoken.logic.syntax import parse, unparse

MEANT = {
    "hospital": """
        Whenever the floor is wet, you must not be in ward 1. | G(spill -> !w1)
        Whenever the fire alarm is on, you must be in the lobby. | G(alarm -> lobby)
        Whenever the fire alarm is on, you have to end up in the lobby. | G(alarm -> F lobby)
        Pharmacy first, thereafter the lab. | F(pharmacy & F lab)
        The lab, and some time later ward 3. | F(lab & F w3)
        Go to ward 1, subsequently to ward 2, and last of all to the dock. | F(w1 & F(w2 & F dock))
        Don't set foot in ward 2 till you've been to the pharmacy, and then do visit it. | F(pharmacy & F w2) & (!w2 U pharmacy)
        Ward 2 only after ward 1, and you must get to ward 2. | F(w1 & F w2) & (!w2 U w1)
        Hold off on ward 3 until the floor is dry, then go there. | (!w3 U !spill) & F w3
        Drop in on ward 1 exactly once before you head for the lab. | F(w1 & F lab) & (!lab U w1) & (!w1 U (w1 U (!w1 U lab)))
        Wards 1, 2 and 3, each of them exactly once and in that order. | F(w1 & F(w2 & F w3)) & (!w2 U w1) & (!w3 U w2) & (!w1 U (w1 U (!w1 U w2))) & (!w2 U (w2 U (!w2 U w3)))
        Once the medicine has been delivered, the pharmacy is out of bounds for the rest of the shift. | G(deliver -> X G !pharmacy)
        Should the battery be low, recharge the battery in the very next step. | G(low -> X recharge)
        A low battery means that the battery has to be recharged sooner or later. | G(low -> F recharge)
        Every delivery of the medicine must be followed by a call to a nurse. | G(deliver -> F nurse)
        Collecting the blood sample always leads to a trip to the lab in the end. | G(sample -> F lab)
        Fire alarm on? Then call a nurse. | G(alarm -> F nurse)
        No delivering the medicine without collecting the blood sample first. | !deliver U sample
        Deliver the medicine only while the cabinet is locked. | G(deliver -> locked)
        The moment the battery is low, go to the dock, and at no other time. | G(low <-> X dock)
        Call a nurse if, and only if, the fire alarm is on. | G(alarm <-> nurse)
        Go to ward 1 and then to ward 2, without visiting ward 1 a second time before ward 2 and without visiting ward 2 before ward 1. | F(w1 & F w2) & (!w2 U w1) & (!w1 U (w1 U (!w1 U w2)))
        Visit ward 3, then the lab: no lab before ward 3, and no returning to ward 3 until you have been to the lab. | F(w3 & F lab) & (!lab U w3) & (!w3 U (w3 U (!w3 U lab)))
        Each call to a nurse has to be followed in the very next step by delivering the medicine, and the medicine may be delivered at no other time. | G(nurse <-> X deliver)
        keep out of ward 3 at all times pls | G !w3
        Visit ward 2, and do not set a foot in ward 2 before you have been to ward 1. | F w2 & (!w2 U w1)
        Wards 1, 2 and 3 are to be visited in that order, none of them ahead of the one before it. | F(w1 & F(w2 & F w3)) & (!w2 U w1) & (!w3 U w2)
        Give ward 3 a miss. | G !w3
        Ward 2 is taboo. | G !w2
        Keep clear of ward 1 and ward 2 all shift long. | G !w1 & G !w2
        Refrain from entering the lab while the fire alarm is on. | G(alarm -> !lab)
        Not once may you enter ward 3. | G !w3
        At no time may the floor be wet and the battery low. | G !(spill & low)
        Neither deliver the medicine nor call a nurse before you have been to the lab. | (!deliver U lab) & (!nurse U lab)
        Either ward 1 or ward 2: one will do. | F(w1 | w2)
        Visit one of the two, ward 1 or ward 2. | F(w1 | w2)
        At least one of ward 1 and ward 3 has to be visited. | F(w1 | w3)
        Stop by the lobby precisely two times, no more and no fewer. | F(lobby & (lobby U (!lobby & (!lobby U F lobby)))) & !F(lobby & (lobby U (!lobby & (!lobby U F(lobby & (lobby U (!lobby & (!lobby U F lobby))))))))
        Two or more visits to the lobby, please. | F(lobby & (lobby U (!lobby & (!lobby U F lobby))))
        A third visit to the lobby is not allowed. | !F(lobby & (lobby U (!lobby & (!lobby U F(lobby & (lobby U (!lobby & (!lobby U F lobby))))))))
        Enter the lab once only. | F lab & !F(lab & (lab U (!lab & (!lab U F lab))))
        Never enter the lab a second time. | !F(lab & (lab U (!lab & (!lab U F lab))))
        One stop at the lab, one stop at the pharmacy, any order. | F lab & F pharmacy
        Let there be a moment when room 12 is free. | F !occupied
        A visit to the lab followed by a visit to the pharmacy. | F(lab & F pharmacy)
        Have a look in at ward 2 and pop over to the lab afterwards. | F(w2 & F lab)
        Amble over to the pharmacy, will you, mate? | F pharmacy
        Trundle across to the lobby at some point this evening. | F lobby
        We're short of staff, so call a nurse. | F nurse
        Visit ward 1 and ward 2 in turns, both at least once. | F w1 & F w2 & G(w1 -> X(!w1 W w2)) & G(w2 -> X(!w2 W w1))
        Alternate between the lab and the lobby. | F lab & F lobby & G(lab -> X(!lab W lobby)) & G(lobby -> X(!lobby W lab))
        Stay in the lobby from start to finish. | G lobby
        The medicine cabinet has to be locked at all times. | G locked
        Hold off calling a nurse until the fire alarm is on. | !nurse U alarm
        Call a nurse, but not before the floor is wet. | F nurse & (!nurse U spill)
        Recharge the battery, just not until you have been to the dock. | F recharge & (!recharge U dock)
        Go to ward 3, yet never while the floor is wet. | F w3 & G(spill -> !w3)
        Ward 1 before ward 2, and go to both. | F(w1 & F w2) & (!w2 U w1)
        Visit the lab, then ward 1, but never ward 1 while room 12 is occupied. | F(lab & F w1) & G(occupied -> !w1)
        Delivering the medicine outside ward 2 is prohibited. | G(deliver -> w2)
        Calling a nurse is permitted in ward 1 or ward 2 and nowhere else. | G(nurse -> (w1 | w2))
        After every delivery of the medicine, disinfect the room in the next step. | G(deliver -> X disinfect)
        Ward 3 yes, ward 2 never. | F w3 & G !w2
        Visit the lab at least twice and ward 1 not at all. | F(lab & (lab U (!lab & (!lab U F lab)))) & G !w1
        Go to the lab; before that, though, look in at the pharmacy. | F(pharmacy & F lab) & (!lab U pharmacy)
        Wait at the dock until the battery is not low any more, then go to ward 1. | dock U (!low & F w1)
        End up at the dock and stay there for good. | F G dock
        Make the rounds of ward 1, ward 2 and ward 3 endlessly. | G F w1 & G F w2 & G F w3
        It would be great if you could swing by the lab. | F lab
        The boss insists that you go to ward 2. | F w2
        Disinfecting the room is a must. | F disinfect
        You need not go to ward 1, but go to ward 2. | F w2
        Ward 1 twice, then the dock. | F(w1 & F dock) & F(w1 & (w1 U (!w1 & (!w1 U F w1)))) & !F(w1 & (w1 U (!w1 & (!w1 U F(w1 & (w1 U (!w1 & (!w1 U F w1))))))))
    """,
    "warehouse": """
        Aisle A, aisle B, then the packing station, in that order. | F(a & F(b & F pack)) & (!b U a) & (!pack U b)
        Hop over to aisle C, followed by a visit to the charger. | F(c & F charger)
        The charger, yes, but only after the truck is loaded. | F charger & (!charger U loaded)
        As soon as the corridor is blocked, alert the supervisor; never otherwise. | G(blocked <-> X alert)
        Any time the forklift is moving, aisle B is off limits. | G(forklift -> !b)
        In case the corridor is blocked, the supervisor has to be alerted eventually. | G(blocked -> F alert)
        No wrapping the pallet until the parcel has been scanned. | !wrap U scanned
        While the forklift is moving, you must neither pick up the parcel nor wrap the pallet. | G(forklift -> !pick) & G(forklift -> !wrap)
        First aisle A, later aisle B, and last the loading bay. | F(a & F(b & F load))
        Get to the loading bay without passing through aisle B on the way. | !b U load
        Visit aisle A no fewer than two times. | F(a & (a U (!a & (!a U F a))))
        The packing station may be entered at most once. | !F(pack & (pack U (!pack & (!pack U F pack))))
        You must be at the charger whenever the truck is loaded. | G(loaded -> charger)
        Scan the parcel straight after picking up the parcel. | G(pick -> X scan)
        Scanning the parcel has to come before wrapping the pallet. | !wrap U scan
        Before wrapping the pallet, the parcel must be scanned. | !wrap U scanned
        Steer clear of aisle C until the truck is loaded, then head there. | (!c U loaded) & F c
        Make sure the truck is loaded in the end, and keep out of aisle B throughout. | F loaded & G !b
        Don't ever be in aisle A and don't alert the supervisor. | G !a & G !alert
        Aisle B is not to be entered unless the corridor is clear. | G(b -> !blocked)
        Park at the charger till the parcel is scanned. | charger U scanned
        Keep returning to the loading bay. | G F load
        Once you have been to the packing station you must not go back to aisle A. | G(pack -> X G !a)
        If the truck isn't loaded, do not go to the charger. | G(!loaded -> !charger)
        Wrap the pallet exactly twice. | F(wrap & (wrap U (!wrap & (!wrap U F wrap)))) & !F(wrap & (wrap U (!wrap & (!wrap U F(wrap & (wrap U (!wrap & (!wrap U F wrap))))))))
        Could you pass by aisle A and, after that, aisle B? | F(a & F b)
        Either scan the parcel or wrap the pallet, whichever you prefer. | (F scan) | (F wrap)
        Both aisle A and aisle C have to be visited, in whichever order. | F a & F c
    """,
    "kitchen": """
        The oven door must be closed whenever you are at the sink. | G(sink -> !open)
        The oven door has to stay closed while you are at the sink. | G(sink -> !open)
        Chop the onions, wash the dishes, serve the soup, strictly in that order. | F(chop & F(wash & F serve)) & (!wash U chop) & (!serve U wash)
        Every time you chop the onions, wash the dishes right away. | G(chop -> X wash)
        When the pan is hot, don't touch the stove. | G(hot -> !stove)
        Never serve the soup without the counter being clean. | G(serve -> clean)
        Serving the soup is allowed only at the dining table. | G(serve -> table)
        The fridge is a no-go once the water is boiling. | G(boiling -> X G !fridge)
        Stay by the stove as long as the pan is hot. | G(hot -> stove)
        Stop at the sink once and only once before you get to the dining table. | F(sink & F table) & (!table U sink) & (!sink U (sink U (!sink U table)))
        See that the counter gets clean, and afterwards serve the soup. | F(clean & F serve)
        After washing the dishes you're not to go near the stove again. | G(wash -> X G !stove)
    """,
}
NOT_UNDERSTOOD = (
    ("hospital", "Paint ward 1."),
    ("hospital", "Go to ward 1 and sing."),
    ("hospital", "Go to ward 1, then juggle."),
    ("hospital", "If it rains, go to ward 1."),
    ("hospital", "Visit ward 2 when the doctor arrives."),
    ("kitchen", "Visit the sink unless you are tired."),
    ("kitchen", "Visit the sink, then sharpen the knives."),
    ("kitchen", "Don't sharpen the knives, visit the sink."),
    ("kitchen", "Visit the fridge three minutes later."),
    ("kitchen", "Serve the soup when the guests arrive."),
    ("kitchen", "Visit the sink, but only on Sundays."),
)
CASES = [
    (domain, *map(str.strip, line.split(" | ", 1)))
    for domain, table in MEANT.items()
    for line in table.strip().splitlines()
]


@pytest.mark.parametrize(("domain", "sentence", "meant"), CASES)
def test_a_clause_means_its_formula(domain: str, sentence: str, meant: str) -> None:
    extraction = extract(sentence, DOMAINS[domain], None)
    assert extraction.status is Status.OK, extraction.reason or extraction.question
    assert extraction.reading is not None
    literal = extraction.reading.literal
    assert equivalent(literal, parse(meant)), unparse(literal)


@pytest.mark.parametrize(("domain", "sentence"), NOT_UNDERSTOOD)
def test_what_may_be_an_argument_or_a_condition_is_not_dropped(domain: str, sentence: str) -> None:
    assert extract(sentence, DOMAINS[domain], None).status is Status.REJECT
