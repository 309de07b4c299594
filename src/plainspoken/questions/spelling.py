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
    (r"\bwhats\b", "what is"),
    (r"\bgonna\b", "going to"),
    (r"\bwanna\b", "want to"),
    (r"\b(dont|didnt|isnt|arent|doesnt|havent|wasnt)\b", lambda m: m[1][:-2] + " not"),
)
_ASKING = "do|does|did|is|are|was|were|have|has|had|will|would|can|could|should"


def normal(text: str) -> str:
    """Lower case, contractions spelled out, no marks but those inside words."""
    plain = text.lower().replace("\u2019", "'").replace("\u2018", "'").strip()
    for pattern, spelled in _CONTRACTIONS:
        plain = re.sub(pattern, spelled, plain)
    plain = re.sub(rf"\b({_ASKING}) not (you|it|the|they|we|i)\b", r"\1 \2 not", plain)
    plain = re.sub(r"\b(?:mr|mrs|ms|miss|dr|prof)\b\.? (?=\w)", "", plain)
    plain = re.sub(r"[^\w\s'-]", " ", plain.replace("'s ", " 's "))
    return " ".join(plain.split())
