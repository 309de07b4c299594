"""The forms of English words: tenses of verbs, plurals of nouns, lists.

Written here and not taken from a library: `lemminflect` needs NumPy and a third of a second before
its first form, `inflect` has no tenses. The irregular verbs are a closed class; the rest is rules.
Spelling is British (`travelled`, `labelled`).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from plainspoken.questions.spelling import NUMBERS

_IRREGULAR = """
arise arose arisen|awake awoke awoken|be was been|bear bore borne|beat beat beaten
become became become|begin began begun|bend bent bent|bet bet bet|bind bound bound
bite bit bitten|bleed bled bled|blow blew blown|break broke broken|breed bred bred
bring brought brought|build built built|burn burnt burnt|burst burst burst|buy bought bought
catch caught caught|choose chose chosen|cling clung clung|come came come|cost cost cost
creep crept crept|cut cut cut|deal dealt dealt|dig dug dug|do did done|draw drew drawn
drink drank drunk|drive drove driven|eat ate eaten|fall fell fallen|feed fed fed|feel felt felt
fight fought fought|find found found|fit fitted fitted|flee fled fled|fling flung flung
fly flew flown|forbid forbade forbidden|forget forgot forgotten|forgive forgave forgiven
freeze froze frozen|get got got
give gave given|go went gone|grind ground ground|grow grew grown|hang hung hung|have had had
hear heard heard|hide hid hidden|hit hit hit|hold held held|hurt hurt hurt|keep kept kept
kneel knelt knelt|know knew known|lay laid laid|lead led led|lean leant leant|leap leapt leapt
learn learnt learnt|leave left left|lend lent lent|let let let|lie lay lain|light lit lit
lose lost lost|make made made|mean meant meant|meet met met|mow mowed mown|pay paid paid
put put put|quit quit quit|read read read|ride rode ridden|ring rang rung|rise rose risen
run ran run|saw sawed sawn|say said said|see saw seen|seek sought sought|sell sold sold
send sent sent|set set set|sew sewed sewn|shake shook shaken|shed shed shed|shine shone shone
shoot shot shot|show showed shown|shrink shrank shrunk|shut shut shut|sing sang sung
sink sank sunk|sit sat sat|sleep slept slept|slide slid slid|sling slung slung|slit slit slit
sow sowed sown|speak spoke spoken|spend spent spent|spill spilt spilt|spin spun spun
split split split|spread spread spread|spring sprang sprung|stand stood stood|steal stole stolen
stick stuck stuck|sting stung stung|stink stank stunk
stride strode stridden|strike struck struck|string strung strung|sweep swept swept
swell swelled swollen|swim swam swum|swing swung swung|take took taken|teach taught taught
tear tore torn|tell told told|think thought thought|throw threw thrown|thrust thrust thrust
tread trod trodden|wake woke woken|wear wore worn|weave wove woven|weep wept wept
wet wet wet|win won won|wind wound wound|withdraw withdrew withdrawn|wring wrung wrung
write wrote written
"""
IRREGULAR_VERBS: dict[str, tuple[str, str]] = {
    verb: (past, participle)
    for verb, past, participle in (
        entry.split() for line in _IRREGULAR.split("\n") for entry in line.split("|") if entry
    )
}
"""Past and past participle of the verbs that follow no rule."""

PARTICIPLES = frozenset(participle for _, participle in IRREGULAR_VERBS.values())
_PREFIX = re.compile(r"^(?:under|over|fore|with|out|up|be|mis|pre|for|dis|re|un)-?(?=[a-z]{2})")
_SHORT = re.compile(r"[^aeiou]*(?:qu)?[aeiou][^aeiouwxy]")
"""One syllable with a short vowel, such as `stop`: its last consonant is doubled."""
_SHORT_BEHIND = re.compile(
    r"(?:[b-df-hj-np-tv-z]|[bcdfgpst]r|[bcfgps]l|s[tkpnmw]|[cst]h)[aeiou][^aeiouwxy]"
)
"""The same behind a prefix, such as `unstop`; the onset keeps `redden` and `better` out."""
_STRESSED_LAST = frozenset(
    [
        "abet",
        "abut",
        "admit",
        "allot",
        "begin",
        "befit",
        "commit",
        "compel",
        "confer",
        "control",
        "defer",
        "deter",
        "emit",
        "equip",
        "embed",
        "excel",
        "expel",
        "forget",
        "format",
        "infer",
        "inter",
        "occur",
        "omit",
        "patrol",
        "permit",
        "prefer",
        "propel",
        "rebut",
        "recur",
        "refer",
        "regret",
        "remit",
        "repel",
        "submit",
        "transfer",
        "transmit",
        "unplug",
    ]
)
_VOWELS = "aeiou"
_IRREGULAR_PLURALS = dict(
    pair.split("/")
    for pair in [
        "child/children",
        "foot/feet",
        "goose/geese",
        "man/men",
        "mouse/mice",
        "ox/oxen",
        "person/people",
        "tooth/teeth",
        "woman/women",
        "human/humans",
        "sheep/sheep",
        "fish/fish",
        "deer/deer",
        "series/series",
        "calf/calves",
        "half/halves",
        "knife/knives",
        "leaf/leaves",
        "life/lives",
        "loaf/loaves",
        "self/selves",
        "shelf/shelves",
        "thief/thieves",
        "wife/wives",
        "wolf/wolves",
        "echo/echoes",
        "hero/heroes",
        "potato/potatoes",
        "tomato/tomatoes",
    ]
)


def _root(verb: str) -> tuple[str, str]:
    """A prefix that does not change the forms (`re`fill, `un`lock), and the verb behind it."""
    found = _PREFIX.match(verb)
    if found and verb[found.end() :] in IRREGULAR_VERBS:
        return found.group(), verb[found.end() :]
    return "", verb


def _doubled(verb: str) -> str:
    """The verb before `-ed` and `-ing`: its last consonant doubled where English does so."""
    if re.search(r"[^aeiou][aeiou]l$", verb) and verb != "parallel":
        return verb + "l"
    bare = _PREFIX.sub("", verb)
    if _SHORT.fullmatch(verb) or _SHORT_BEHIND.fullmatch(bare) or verb in _STRESSED_LAST:
        return verb + verb[-1]
    return verb


@lru_cache(maxsize=4096)
def past(verb: str) -> str:
    """`picked`, `drove`, `emptied`."""
    prefix, root = _root(verb)
    if root in IRREGULAR_VERBS:
        return prefix + IRREGULAR_VERBS[root][0]
    return _regular_past(verb)


@lru_cache(maxsize=4096)
def participle(verb: str) -> str:
    """The past participle: `picked`, `driven`."""
    prefix, root = _root(verb)
    if root in IRREGULAR_VERBS:
        return prefix + IRREGULAR_VERBS[root][1]
    return _regular_past(verb)


def _regular_past(verb: str) -> str:
    if verb.endswith("e"):
        return verb + "d"
    if verb.endswith("y") and verb[-2:-1] not in _VOWELS:
        return verb[:-1] + "ied"
    if verb.endswith("c"):
        return verb + "ked"
    return _doubled(verb) + "ed"


@lru_cache(maxsize=4096)
def progressive(verb: str) -> str:
    """The `-ing` form: `picking`, `driving`, `putting`."""
    if verb.endswith("ie"):
        return verb[:-2] + "ying"
    if verb.endswith("e") and not verb.endswith(("ee", "oe", "ye")) and verb != "be":
        return verb[:-1] + "ing"
    if verb.endswith("c"):
        return verb + "king"
    return _doubled(verb) + "ing"


@lru_cache(maxsize=4096)
def third_person(verb: str) -> str:
    """`picks`, `carries`, `is`, `has`."""
    if verb in ("be", "have"):
        return {"be": "is", "have": "has"}[verb]
    return _with_s(verb)


def _with_s(word: str) -> str:
    if word.endswith(("s", "x", "z", "ch", "sh")) or re.search(r"[^aeiou]o$", word):
        return word + "es"
    if word.endswith("y") and word[-2:-1] not in _VOWELS:
        return word[:-1] + "ies"
    return word + "s"


@lru_cache(maxsize=4096)
def plural(noun: str) -> str:
    """`mugs`, `boxes`, `shelves`; the last word of a compound."""
    head, _, last = noun.rpartition(" ")
    if last in _IRREGULAR_PLURALS:
        last = _IRREGULAR_PLURALS[last]
    elif last.endswith("man") and last != "human":
        last = last[:-3] + "men"
    elif re.search(r"[^aeiou]o$", last):
        last += "s"
    else:
        last = _with_s(last)
    return f"{head} {last}".strip()


@lru_cache(maxsize=4096)
def lemma(word: str) -> str:
    """The base form of an English word, lower case."""
    # Imported here: its dictionary takes a quarter of a second, and `--help` asks nothing.
    import simplemma  # noqa: PLC0415

    return str(simplemma.lemmatize(word.lower(), "en")).lower()


def listed(parts: Sequence[str], conjunction: str = "and") -> str:
    """`a`, `a and b`, `a, b and c`."""
    if len(parts) <= 1:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} {conjunction} {parts[-1]}"


def a(noun: str) -> str:
    """The noun with its indefinite article, by its spelling."""
    vowel = noun[:1] in _VOWELS and not re.match(r"(?:uni|use|usu|eu|one\b)", noun)
    return f"{'an' if vowel else 'a'} {noun}"


_NUMBERS = ["no", *NUMBERS[1:13]]


def counted(number: int, noun: str) -> str:
    """`no mugs`, `one mug`, `three mugs`, `17 mugs`."""
    words = _NUMBERS[number] if number < len(_NUMBERS) else str(number)
    return f"{words} {noun if number == 1 else plural(noun)}"


def number_word(number: int) -> str:
    """`none`, `one`, `three`, `17`."""
    return "none" if number == 0 else _NUMBERS[number] if number < len(_NUMBERS) else str(number)


def times(number: int) -> str:
    """`never`, `once`, `twice`, `three times`."""
    return {0: "never", 1: "once", 2: "twice"}.get(number) or counted(number, "time")


def sentence(text: str) -> str:
    """With a capital and one full stop."""
    text = " ".join(text.split()).rstrip(".;, ")
    if not text:
        return ""
    return text[0].upper() + text[1:] + ("" if text[-1] in "?!" else ".")
