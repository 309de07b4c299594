"""What kind of word stands in a name, as far as form and dictionary tell, and its inflections.

Names have no syntax: `plugged-in`, `lies`, `low-battery` and `door-open` differ only in what kind
of word stands where. The word lists here are closed classes of English; no word of a domain is one.
"""

from __future__ import annotations

from functools import cache

RELATIONS = frozenset(
    ("at", "in", "on", "inside", "into", "onto", "under", "near", "by", "behind", "above", "below",
     "beside", "within", "outside", "from", "to", "with", "of", "for", "through", "against",
     "around", "between", "aboard", "upon", "across", "over", "towards", "about", "beneath")
)  # fmt: skip
PARTICLES = frozenset(("up", "down", "on", "off", "out", "in", "away", "over", "back", "apart"))
COPULAS = frozenset(("is", "are", "was", "be"))
_SAME_PARTICIPLE = frozenset(
    ("put", "set", "cut", "shut", "let", "hit", "split", "spread", "burst", "cast", "hurt", "quit")
)
_STATIVE = frozenset(
    ("need", "want", "require", "know", "own", "contain", "like", "believe", "have", "belong",
     "deserve", "lack")
)  # fmt: skip
"""Verbs of how things are, which are not said in "-ing"."""
_ADJECTIVES = frozenset(
    ("free", "busy", "idle", "alive", "dead", "asleep", "awake", "absent", "present", "available",
     "left", "right", "upper", "lower", "front", "back", "north", "south", "east", "west", "middle",
     "inner", "outer", "main", "same", "other", "next", "last", "intact", "online", "offline")
)  # fmt: skip
_ADJECTIVE_ENDINGS = ("able", "ible", "ful", "less", "ous", "ive", "ic", "ical", "ish")
_HOLDING = frozenset(("hold", "carry", "grasp", "grip", "grab", "clutch", "transport", "bear"))
_BARE = frozenset(
    ("customs", "security", "headquarters", "dinner", "lunch", "breakfast", "quarantine", "fuel",
     "energy", "permission", "access", "food", "money", "data", "intensive care", "home")
)  # fmt: skip
"""Nouns that are said without an article."""
_BARE_BEHIND = frozenset(
    ("fire", "stock", "danger", "work", "water", "place", "order", "bed", "use", "transit",
     "service", "charge", "duty", "time", "motion", "progress", "storage", "board", "top", "power",
     "need", "reach", "sight", "range", "contact", "control", "rest", "standby", "hold")
)  # fmt: skip
"""Nouns that are so behind a preposition only: "on fire", "in stock"."""
_SURFACES = frozenset(
    ("table", "shelf", "floor", "platform", "balcony", "roof", "stage", "deck", "bridge", "field",
     "island", "terrace", "worktop", "bench", "rack", "tray", "street", "road", "trapdoor", "hill",
     "desk", "conveyor", "belt", "ground", "pallet", "lawn", "wall", "porch")
)  # fmt: skip
_ROOMS = frozenset(
    ("room", "hall", "kitchen", "house", "office", "garden", "building", "city", "town", "box",
     "bin", "ward", "corridor", "hangar", "barn", "cellar", "attic", "drawer", "cupboard",
     "library", "greenhouse", "orchard", "wing", "store", "storeroom", "warehouse", "lab",
     "laboratory", "garage", "forest", "park", "bay", "area", "lounge", "bedroom", "bathroom",
     "studio", "workshop", "foyer", "lobby", "pantry",
     "aisle", "zone", "yard", "shed", "care")
)  # fmt: skip


@cache
def is_word(text: str) -> bool:
    """Whether the dictionary of English has it."""
    # Loaded at the first word: the dictionary takes a quarter of a second.
    import simplemma  # noqa: PLC0415

    return bool(simplemma.is_known(text, lang="en"))


@cache
def lemma(text: str) -> str:
    """The word that a word is an inflection of, itself where it is none; names keep a capital."""
    import simplemma  # noqa: PLC0415

    return str(simplemma.lemmatize(text, lang="en"))


def is_quality(text: str) -> bool:
    """Whether a word says how something is: those have a noun in "-ness"."""
    head = text[:-1] + "i" if text.endswith("y") else text
    return is_word(f"{head}ness")


def is_adjective(text: str) -> bool:
    """Whether a word is an adjective and no participle."""
    if text in _ADJECTIVES or is_quality(text):
        return True
    return len(text) > 5 and text.endswith(_ADJECTIVE_ENDINGS) and is_word(text)


def is_gerund(text: str) -> bool:
    """Whether a word is a verb in "-ing"."""
    return text.endswith("ing") and lemma(text) != text


def is_participle(text: str) -> bool:
    """Whether a word is the past form of a verb: "plugged", "broken", "lit"."""
    if text in _SAME_PARTICIPLE:
        return True
    base = lemma(text)
    if base == text or text.endswith(("s", "ing", "er", "est")) or not base.islower():
        return False
    return gerund(base) is not None


def is_third_person(text: str) -> bool:
    """Whether a word may be a verb as it is said of one: "lies"; "lights" may be one too."""
    base = lemma(text)
    plain = text.endswith("s") and not text.endswith(("ss", "us", "is"))
    return plain and base != text and gerund(base) is not None


def is_verb(text: str) -> bool:
    """Whether a word may be a verb in its plain form: "carry"."""
    return lemma(text) == text and not is_adjective(text) and gerund(text) is not None


def is_stative(verb: str) -> bool:
    """Whether a verb tells of how things are, and so has no use for "-ing"."""
    return lemma(verb) in _STATIVE


def is_holding(word: str) -> bool:
    """Whether a verb tells of one who has something in the hand."""
    return lemma(word) in _HOLDING


def is_state(text: str) -> bool:
    """Whether a word tells how something is, where it is no noun: "open", "lit", "off"."""
    return text in PARTICLES or is_adjective(text) or is_participle(text) or is_gerund(text)


def is_plural(noun: str) -> bool:
    """Whether a noun speaks of several."""
    if noun == "data":
        return True
    base = lemma(noun)
    return noun.endswith("s") and not noun.endswith(("ss", "us", "is")) and base != noun


@cache
def gerund(verb: str) -> str | None:
    """A verb in "-ing", None where the dictionary has none such: "hold" is "holding"."""
    heads = [verb[:-1]] if verb.endswith("e") and not verb.endswith("ee") else [verb]
    if verb.endswith("ie"):
        heads = [f"{verb[:-2]}y"]
    elif verb[-1:] not in "aeiouwxy" and verb[-2:-1] in "aeiou":
        heads = [verb + verb[-1], verb]
    return next((f"{head}ing" for head in heads if is_word(f"{head}ing")), None)


def third_person(verb: str) -> str:
    """A verb as it is said of someone: "drives"."""
    if verb in ("be", "have"):
        return {"be": "is", "have": "has"}[verb]
    if verb.endswith("y") and verb[-2:-1] not in "aeiou":
        return f"{verb[:-1]}ies"
    return f"{verb}es" if verb.endswith(("s", "sh", "ch", "x", "o")) else f"{verb}s"


def some(noun: str) -> str:
    """A noun with what tells that it is any one: "an engine", "towels"."""
    if noun in _BARE or is_plural(noun.rsplit(maxsplit=1)[-1]):
        return noun
    silent = noun.startswith(("hour", "honest", "heir"))
    spoken = noun.startswith(("uni", "use", "one", "eu"))
    vowel = noun[0] in "aeiou" and not spoken
    return f"{'an' if silent or vowel or noun[0] in 'AEFHILMNORSX' else 'a'} {noun}"


def the(noun: str) -> str:
    """A noun that is known which; those that are said without an article stay bare."""
    return noun if noun in _BARE else f"the {noun}"


def related(relation: str, noun: str) -> str:
    """A preposition with what it is to: "in the hand", "on fire"."""
    bare = noun.split(maxsplit=1)[0] in RELATIONS or noun in _BARE_BEHIND
    return f"{relation} {noun if bare else the(noun)}"


def is_idiom(relation: str, noun: str) -> bool:
    """Whether a preposition and a noun say together how something is: "on fire", "in stock"."""
    return related(relation, noun) == f"{relation} {noun}"


def whereabouts(relation: str, place: str) -> str:
    """The preposition for a place, by what kind of place the words for it name.

    Domains say `in` and `at` of any place; a person is on a balcony and in a hall.
    """
    if relation not in ("at", "in", "on"):
        return relation
    words = place.split()
    head = next((word for word in reversed(words) if word.isalpha() and len(word) > 1), "")
    if head in _SURFACES:
        return "on"
    return "in" if head in _ROOMS else relation


def doing(noun: str) -> str | None:
    """What one who is called after what they do is doing: a "lifter" is "lifting"."""
    if not noun.endswith(("er", "or")) or len(noun) < 5:
        return None
    head = noun[:-2]
    head = head[:-1] + "y" if head.endswith("i") else head
    ending = f"{head}ing"
    return ending if is_word(ending) else None
