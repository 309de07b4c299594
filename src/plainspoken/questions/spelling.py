"""A text as it is looked up: lower case, contractions spelled out, numbers as they are said."""

from __future__ import annotations

import re

NUMBERS = [
    "zero",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
    "thirteen",
    "fourteen",
    "fifteen",
    "sixteen",
    "seventeen",
    "eighteen",
    "nineteen",
    "twenty",
]
"""The words for 0, 1, 2 ..."""

_CONTRACTIONS = (
    (r"\bwon't\b", "will not"),
    (r"\bcan't\b|\bcannot\b", "can not"),
    (r"\bshan't\b", "shall not"),
    (r"n't\b", " not"),
    (r"\b(i)'m\b", r"\1 am"),
    (r"'re\b", " are"),
    (r"'ve\b", " have"),
    (r"'ll\b", " will"),
    (r"'d\b", " would"),
    (r"\b(what|where|who|how|when|why|that|it|there|here|he|she|which)'?s\b(?! own)", r"\1 is"),
    (r"\blet's\b", "let us"),
    (r"\b(what|where|who|how|when|why|that|there|here)s\b", r"\1 is"),
    (r"\b(you|they)re\b", r"\1 are"),
    (r"\b(i|you|we|they|could|should|would)ve\b", r"\1 have"),
    (r"\bim\b", "i am"),
    (r"\b(you|they)ll\b", r"\1 will"),
    (r"\b(do|did|is|are|does|have|has|was|were|had|could|would|should|must)nt\b", r"\1 not"),
    (r"\b(?:wont|ca n't)\b", "will not"),
    (r"\bcant\b", "can not"),
)
_SHORT = {
    "gonna": "going to", "wanna": "want to", "gotta": "got to", "lemme": "let me",
    "gimme": "give me", "whatcha": "what are you", "dunno": "do not know", "kinda": "kind of",
    "u": "you", "ya": "you", "ur": "your", "pls": "please",
    "plz": "please", "wot": "what", "wat": "what", "wut": "what", "coz": "because",
    "cos": "because", "cuz": "because", "thx": "thanks", "ta": "thanks",
    "rn": "right now", "atm": "at the moment", "asap": "at once", "til": "until", "ain't": "is not",
    "aint": "is not", "yr": "your", "tho": "though", "cya": "see you",
    "'em": "them", "em": "them", "y'all": "you", "goin": "going", "doin": "doing",
}  # fmt: skip
"""What people write for short, and what they would write at length."""
_ASKING = "do|does|did|is|are|was|were|have|has|had|will|would|can|could|should"


def normal(text: str) -> str:
    """Lower case, contractions spelled out, no marks but those inside words."""
    plain = text.lower().replace("\u2019", "'").replace("\u2018", "'").strip()
    for pattern, spelled in _CONTRACTIONS:
        plain = re.sub(pattern, spelled, plain)
    plain = " ".join(_SHORT.get(word.strip(".,;:!?"), word) for word in plain.split())
    plain = re.sub(rf"\b({_ASKING}) not (you|it|the|they|we|i)\b", r"\1 \2 not", plain)
    plain = re.sub(r"\b(?:mr|mrs|ms|miss|dr|prof)\b\.? (?=\w)", "", plain)
    plain = re.sub(r"[^\w\s'-]", " ", plain.replace("'s ", " 's "))
    return " ".join(plain.split())
