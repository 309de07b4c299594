"""Italian: the forms of its words, and the templates that answers are told with.

Verbs go by their infinitives, nouns by their endings; what follows no rule is in tables. The robot
speaks of itself in the first person and is masculine, as `robot` is.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

TEMPLATES = {
    "doing": "{doing}",
    "doing_for": "{doing} per poter {goal}",
    "did_for": "{did} per poter {goal}",
    "next_for": "{shall} per poter {goal}",
    "because_facts": "{reason}, perché vuoi che {facts}",
    "because_asked": "{reason}, perché me l'hai chiesto",
    "just_did": "{did} proprio ora",
    "about_to": "fra poco {shall}",
    "paused": "sono in pausa",
    "planning": "sto ancora cercando un modo di fare quello che hai chiesto",
    "finished": "ho finito: tutto quello che hai chiesto è fatto",
    "ended": "mi sono fermato prima di aver fatto tutto quello che hai chiesto",
    "facts": "{facts}",
    "done_so_far": "finora {did}",
    "done_nothing": "non ho ancora fatto nulla",
    "not_done": "non l'ho fatto finora",
    "times_done": "in tutto {number}",
    "rest_so_far": "per il resto non è cambiato nulla",
    "rest_ahead": "tutto il resto resta com'è",
    "next": "poi {shall}",
    "first": "per prima cosa {shall}",
    "perhaps": "a seconda di come va, {shall}",
    "nothing_ahead": "nient'altro: la missione è finita",
    "not_planned": "non è nei miei piani",
    "obstacle": "ora non posso, perché {facts}",
    "not_now": "potrei, ma ora {doing}",
    "came_of": "è così da quando {did}, {ago}",
    "from_start": "{facts}, fin dall'inizio",
    "did_when": "{did}, {ago}",
    "shall_when": "{shall}, fra {number} al più presto",
    "reached": "fatto: {facts}",
    "missing": "da fare: {facts}",
    "left_between": "mancano da {least} a {most} azioni",
    "left_one": "ci vuole ancora un'azione",
    "left_exactly": "ci vogliono ancora {least} azioni",
    "left_at_least": "mancano almeno {least} azioni; quante al massimo, non lo so dire",
    "kept": "sì, finora ho rispettato quello che mi hai chiesto",
    "broken": "no, non ho rispettato tutto quello che mi hai chiesto",
    "may_be": "può succedere fra {number} al più presto",
    "so_already": "è già così: {facts}",
    "cannot_be": "per come stanno le cose, in questa missione non succederà",
    "unknown": "non lo so",
    "only_answers": "qui rispondo soltanto alle domande sulla mia missione",
}

_NUMBERS = [
    "zero",
    "un",
    "due",
    "tre",
    "quattro",
    "cinque",
    "sei",
    "sette",
    "otto",
    "nove",
    "dieci",
    "undici",
    "dodici",
]
_PARTICIPLES = dict(
    pair.split("/")
    for pair in [
        "accendere/acceso",
        "aprire/aperto",
        "chiedere/chiesto",
        "chiudere/chiuso",
        "consegnare/consegnato",
        "correggere/corretto",
        "cuocere/cotto",
        "decidere/deciso",
        "dire/detto",
        "dividere/diviso",
        "esaminare/esaminato",
        "essere/stato",
        "fare/fatto",
        "leggere/letto",
        "mettere/messo",
        "muovere/mosso",
        "nascondere/nascosto",
        "offrire/offerto",
        "perdere/perso",
        "porre/posto",
        "prendere/preso",
        "raccogliere/raccolto",
        "raggiungere/raggiunto",
        "rimanere/rimasto",
        "riporre/riposto",
        "rispondere/risposto",
        "rompere/rotto",
        "scaricare/scaricato",
        "scegliere/scelto",
        "scendere/sceso",
        "scrivere/scritto",
        "spegnere/spento",
        "spingere/spinto",
        "stendere/steso",
        "togliere/tolto",
        "vedere/visto",
        "venire/venuto",
        "vincere/vinto",
    ]
)
_FUTURE_STEMS = dict(
    pair.split("/")
    for pair in [
        "andare/andr",
        "avere/avr",
        "bere/berr",
        "dare/dar",
        "dire/dir",
        "dovere/dovr",
        "essere/sar",
        "fare/far",
        "porre/porr",
        "potere/potr",
        "rimanere/rimarr",
        "riporre/riporr",
        "sapere/sapr",
        "stare/star",
        "tenere/terr",
        "vedere/vedr",
        "venire/verr",
        "vivere/vivr",
        "volere/vorr",
    ]
)
_GERUNDS = {"fare": "facendo", "dire": "dicendo", "bere": "bevendo", "porre": "ponendo"}
_GERUNDS |= {"riporre": "riponendo"}
_WITH_BE = frozenset(
    [
        "andare",
        "arrivare",
        "entrare",
        "partire",
        "passare",
        "restare",
        "rimanere",
        "ripartire",
        "salire",
        "scendere",
        "tornare",
        "uscire",
        "venire",
    ]
)
_BE = {
    "now": ("sono", "è", "sono"),
    "was": ("ero", "era", "erano"),
    "will": ("sarò", "sarà", "saranno"),
    "may": ("potrei essere", "potrebbe essere", "potrebbero essere"),
    "that": ("sia", "sia", "siano"),
    "stays": ("resterò", "resterà", "resteranno"),
}
_IMPURE = re.compile(r"(?:s[^aeiou]|z|gn|ps|pn|x|y)")
_VOWEL = re.compile(r"[aeiouàèéìòù]")
_ARTICLES = ["il", "lo", "la", "l'", "i", "gli", "le"]
_JOINED = {
    preposition: dict(zip(_ARTICLES, forms.split(), strict=True))
    for preposition, forms in (
        ("a", "al allo alla all' ai agli alle"),
        ("da", "dal dallo dalla dall' dai dagli dalle"),
        ("di", "del dello della dell' dei degli delle"),
        ("in", "nel nello nella nell' nei negli nelle"),
        ("su", "sul sullo sulla sull' sui sugli sulle"),
    )
}
_UNCHANGED = frozenset(
    [
        "a",
        "al",
        "alla",
        "ai",
        "alle",
        "all'",
        "con",
        "da",
        "dal",
        "dalla",
        "di",
        "del",
        "della",
        "in",
        "nel",
        "nella",
        "su",
        "sul",
    ]
)


# -- nouns -------------------------------------------------------------------------------------


def is_feminine(noun: str) -> bool:
    """By the ending: `la cassa`; a file of words may say otherwise."""
    return noun.split(maxsplit=1)[0].endswith(("a", "zione", "sione", "tà"))


def plural(noun: str) -> str:
    """`filari`, `casse`, `robot di supporto`: the first word of a name."""
    first, space, rest = noun.partition(" ")
    feminine = is_feminine(first)
    if first.endswith(("ca", "ga")):
        first = f"{first[:-1]}he"
    elif first.endswith("go") or re.search(r"(?<![aei])co$", first):
        first = f"{first[:-1]}hi"
    elif first.endswith("io"):
        first = first[:-1]
    elif first.endswith("a"):
        first = f"{first[:-1]}{'e' if feminine else 'i'}"
    elif first.endswith(("o", "e")):
        first = f"{first[:-1]}i"
    return f"{first}{space}{rest}"


def with_article(noun: str, *, feminine: bool, several: bool = False) -> str:
    """`il filare 0`, `l'uva`, `lo scaffale`, `gli scaffali`; a person's name stands alone."""
    if noun[0].isupper():
        return noun
    if several:
        broad = _IMPURE.match(noun) or _VOWEL.match(noun)
        return f"{'le' if feminine else 'gli' if broad else 'i'} {noun}"
    if _VOWEL.match(noun):
        return f"l'{noun}"
    return f"{'la' if feminine else 'lo' if _IMPURE.match(noun) else 'il'} {noun}"


def contracted(text: str) -> str:
    """Prepositions joined with the articles behind them: `a il filare` is `al filare`."""
    return re.sub(
        r"\b(a|da|di|in|su) (il |lo |la |l'|i |gli |le )",
        lambda m: _JOINED[m[1]][m[2].strip()] + ("" if m[2] == "l'" else " "),
        text,
    )


def agreeing(complement: str, *, feminine: bool, several: bool) -> str:
    """`pieno`, `piena`, `pieni`, `piene`: the first word where it is an adjective."""
    first, space, rest = complement.partition(" ")
    if first in _UNCHANGED:
        return complement
    if first.endswith("o"):
        ending = ("e" if feminine else "i") if several else ("a" if feminine else "o")
        return f"{first[:-1]}{ending}{space}{rest}"
    if first.endswith("e") and several:
        return f"{first[:-1]}i{space}{rest}"
    return complement


def listed(parts: Sequence[str], conjunction: str = "e") -> str:
    """`a, b e c`."""
    if len(parts) < 2:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} {conjunction} {parts[-1]}"


def counted_actions(number: int) -> str:
    """`un'azione`, `tre azioni`."""
    return "un'azione" if number == 1 else f"{number_word(number)} azioni"


def times(number: int) -> str:
    """`una volta`, `tre volte`."""
    return "una volta" if number == 1 else f"{number_word(number)} volte"


def number_word(number: int) -> str:
    """`tre`, `17`."""
    return _NUMBERS[number] if number < len(_NUMBERS) else str(number)


def ago(number: int) -> str:
    """`proprio ora`, `due azioni fa`."""
    return f"{counted_actions(number)} fa" if number else "proprio ora"


# -- verbs -------------------------------------------------------------------------------------


def be(tense: str, *, me: bool, several: bool) -> str:
    """`sono`, `è`, `saranno`."""
    return _BE[tense][0 if me else 2 if several else 1]


def gerund(verb: str) -> str:
    """`controllando`, `mettendo`."""
    return _GERUNDS.get(verb) or f"{verb[:-3]}{'ando' if verb.endswith('are') else 'endo'}"


def participle(verb: str) -> str:
    """`controllato`, `messo`."""
    ending = {"are": "ato", "ere": "uto", "ire": "ito"}
    return _PARTICIPLES.get(verb) or verb[:-3] + ending.get(verb[-3:], "to")


def future(verb: str, *, me: bool) -> str:
    """`controllerò`, `caricherà`, `andrò`."""
    stem = _FUTURE_STEMS.get(verb)
    if stem is None:
        root = verb[:-3]
        if verb.endswith(("care", "gare")):
            root += "h"
        elif verb.endswith(("ciare", "giare")):
            root = root[:-1]
        stem = root + ("ir" if verb.endswith("ire") else "er")
    return stem + ("ò" if me else "à")


def has_done(verb: str, *, me: bool, feminine: bool = False) -> str:
    """`ho controllato`, `è andata`."""
    done = participle(verb)
    if verb in _WITH_BE:
        return f"{'sono' if me else 'è'} {done[:-1]}{'a' if feminine else 'o'}"
    return f"{'ho' if me else 'ha'} {done}"


def is_doing(verb: str, *, me: bool) -> str:
    """`sto controllando`."""
    return f"{'sto' if me else 'sta'} {gerund(verb)}"
