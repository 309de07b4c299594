"""What a word or phrase does in a sentence."""

from __future__ import annotations

from enum import StrEnum, auto


class Kind(StrEnum):
    """What a word or phrase does in a sentence."""

    GO = auto()  # be at a place at some instant
    STAY = auto()  # be there for a while
    LEAVE = auto()
    AVOID = auto()
    PATROL = auto()  # come back again and again
    CEASE = auto()  # stop doing what follows
    LEADS = auto()  # what is before it calls for what follows: "means that", "is followed by"
    BARS = auto()  # what is before it forbids what follows: "closes", "locks"
    RELEASES = auto()  # what follows is to last until what is before it
    PRECEDED = auto()  # what is before it calls for what follows to come first
    OCCUR = auto()  # what follows a situation: "occurs", "is seen", "holds"
    BE = auto()
    ENSURE = auto()  # "make sure that", "you have to", "please"
    MUST = auto()
    MAY = auto()
    NOT = auto()
    NEVER = auto()
    FORBIDDEN = auto()  # said after what it forbids: "site 3 is off limits"
    SUBJECT = auto()
    WHEN = auto()
    WHENEVER = auto()
    AFTER = auto()
    PROMPTLY = auto()  # "as soon as"
    BEFORE = auto()
    RIGHT_BEFORE = auto()
    UNTIL = auto()
    UNLESS = auto()
    WHILE = auto()
    WITHOUT = auto()
    ONLY_IF = auto()
    ELSEWHERE = auto()  # "anywhere but"
    ONLY_AFTER = auto()
    ONLY_RIGHT_AFTER = auto()
    IFF = auto()
    AND = auto()
    OR = auto()
    BUT = auto()
    COMMA = auto()
    STOP = auto()
    THEN = auto()
    ONLY_THEN = auto()
    NTH = auto()
    FIRST = auto()
    BEFORE_THAT = auto()
    AFTER_THAT = auto()
    RIGHT_AFTER_THAT = auto()
    RIGHT_BEFORE_THAT = auto()
    ANY_ORDER = auto()
    SEQUENCE = auto()
    IN_ORDER = auto()
    NO_RETURN = auto()
    NEXT = auto()
    NEXT_INSTANT = auto()  # said of instants: both readings are the literal one
    LATER = auto()
    LATER_ON = auto()  # later than what was said before
    NOW = auto()
    ALREADY = auto()  # of a situation: it may be over by now
    ALWAYS = auto()
    OTHERWISE = auto()  # where the condition before is not so
    NO_OTHER = auto()  # "and at no other time"
    AGAIN_AND_AGAIN = auto()
    ALTERNATE = auto()  # by turns
    COUNT = auto()
    ONLY = auto()
    AGAIN = auto()
    BOTH = auto()  # all that was last spoken of
    IT_HAPPENS = auto()  # "it is", "that happens": what was last spoken of
    RELATIVE = auto()
    FILLER = auto()
    REFERENCE = auto()
    UNKNOWN = auto()
