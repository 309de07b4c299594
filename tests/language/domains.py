"""Small domains for the tests of language: landmarks in the words of their field."""

from plainspoken.language.grounding import Vocabulary
from plainspoken.world.landmark import Landmark, LandmarkType

_TYPES = {
    "l": LandmarkType.LOCATION,
    "c": LandmarkType.CONDITION,
    "a": LandmarkType.ACTION,
}


def vocabulary(text: str) -> Vocabulary:
    """Landmarks from lines of `id, l or c or a, description, further name, ...`."""
    landmarks = {}
    for line in text.strip().splitlines():
        id, kind, description, *names = (part.strip() for part in line.split(","))
        landmarks[id] = Landmark(id, description, _TYPES[kind], tuple(names))
    return Vocabulary.of(landmarks)


DOMAINS = {
    "vineyard": vocabulary(
        """
        l0, l, line 0, row 0
        l1, l, line 1, row 1
        l2, l, line 2, row 2
        l3, l, line 3, row 3
        wh, l, the warehouse, depot
        full, c, the box is full, the bin is full
        cleared1, c, line 1 is cleared
        cleared2, c, line 2 is cleared
        ripe0, c, grape 0 is ripe
        ripe1, c, grape 1 is ripe
        unripe0, c, grape 0 is unripe
        human, c, a human is present
        harvest, a, to harvest a grape, to pick a grape
        check, a, to check a grape
        drop, a, to drop a grape in the box
        call, a, to call the support robot
        empty, a, to empty the box, to empty the bin
        ask, a, to ask a human
        """
    ),
    "hospital": vocabulary(
        """
        pharmacy, l, the pharmacy
        w1, l, ward 1
        w2, l, ward 2
        w3, l, ward 3
        lab, l, the laboratory, the lab
        dock, l, the charging station, the dock
        lobby, l, the lobby
        low, c, the battery is low
        locked, c, the medicine cabinet is locked
        occupied, c, room 12 is occupied
        spill, c, the floor is wet
        alarm, c, the fire alarm is on
        deliver, a, to deliver the medicine
        sample, a, to collect the blood sample
        disinfect, a, to disinfect the room
        nurse, a, to call a nurse
        recharge, a, to recharge the battery
        """
    ),
    "warehouse": vocabulary(
        """
        a, l, aisle A
        b, l, aisle B
        c, l, aisle C
        load, l, the loading bay
        pack, l, the packing station
        charger, l, the charger
        loaded, c, the truck is loaded
        blocked, c, the corridor is blocked
        scanned, c, the parcel is scanned
        forklift, c, the forklift is moving
        pick, a, to pick up the parcel
        scan, a, to scan the parcel
        wrap, a, to wrap the pallet
        alert, a, to alert the supervisor
        """
    ),
    "kitchen": vocabulary(
        """
        stove, l, the stove
        sink, l, the sink
        fridge, l, the fridge
        table, l, the dining table
        boiling, c, the water is boiling
        clean, c, the counter is clean
        open, c, the oven door is open
        hot, c, the pan is hot
        wash, a, to wash the dishes
        chop, a, to chop the onions
        serve, a, to serve the soup
        off, a, to turn off the stove
        """
    ),
    "streets": vocabulary(
        """
        lee_nails, l, Lee Nails
        blue_region, l, blue region
        red_room, l, red room
        green_room, l, green room
        yellow_room, l, yellow room
        small_red_room, l, small red room
        chase, l, Chase Bank
        cafe, l, Sorrento's Cafe & Bar
        fifth, l, 5th Avenue & Main Street
        """
    ),
}
