"""Which kind a text is of: its grammar and what it speaks of decide, closed classes of words help.

The classes hold words of English for talk about work (to finish, to keep to a rule, a step), never
words of a domain.
"""

from __future__ import annotations

import re

from plainspoken.questions.grammar import BE, HAVE, Mood, Shape, Tense
from plainspoken.questions.idiom import idiom_of, noun_alone
from plainspoken.questions.kind import Kind, is_small_talk
from plainspoken.questions.referent import MOTION, Referents
from plainspoken.questions.voice import does, does_exactly, forms_of, of_a_thing

_TASK = r"goals?|missions?|jobs?|orders?|objectives?|requests?|aims?|wish(?:es)?|assignment"
_STEP = r"actions?|steps?|tasks?|things?|moves?|activit(?:y|ies)|operations?|jobs?"
_FINISH = (
    r"done|finished|finish|ready|complete|completed|over|through|there|achieved|accomplished|met"
    r"|fulfilled|reached|satisfied|along"
)
_WHOLE = r"you|we|it|everything|all|that|this|work|robot|" + _TASK
_LEFT = r"left|remains?|remaining|open|missing|outstanding|pending|unfinished|to go"
_KEEP = (
    r"(?:keep|stay|steer)(?:s|ing|ed)?|kept|(?:stick|sticking|stuck|adher\w+|hold(?:ing)?|held) to"
    r"|(?<!your )(?<!the )(?:avoid|respect|obey|follow|observ|compl|honou?r|violat|infring|disobey"
    r"|shun)(?:e|y|s|es|ed|d|ing|ied|ying|ies)?"
)
_RULE = (
    r"forb[aio]d\w*|rules?|constraints?|restrictions?|conditions? (?:i|we|that)|allowed|prohibited"
    r"|bans?|promises?|promised?|guarantees?|limits?|off limits|banned|out of bounds|safety"
)
_LATEST = (
    r"next|upcoming|following|follows|remaining|later|afterwards|eventually|ahead"
    r"|rest of|in the end"
)


def kind_of(shape: Shape, referents: Referents, plain: str) -> Kind:
    """The kind of a text."""
    if not referents.objects and is_small_talk(plain):
        return Kind.CHITCHAT
    if shape.mood is Mood.ORDERING or _is_request(shape, referents, plain):
        return _ordered(shape)
    if shape.mood is Mood.TELLING:
        return _told(shape, referents)
    if _supposes(shape, referents):
        return Kind.WHAT_IF
    if idiom := idiom_of(shape.clause):
        return idiom
    if not (shape.wh or shape.auxiliary) and (alone := noun_alone(shape.clause)):
        return alone
    for decide in (_about_reason, _about_number, _about_rule, _about_whole):
        kind = decide(shape, referents)
        if kind is not None:
            return kind
    if shape.wh in ("when", "how soon", "how recently", "how long"):
        return Kind.WHEN
    return _by_tense(shape, referents)


# -- orders and reports ------------------------------------------------------------------------


def _is_request(shape: Shape, referents: Referents, plain: str) -> bool:
    """`Can you call the other robot?`, `I'd like you to wait`, `you must stop`."""
    if re.search(
        r"\bi (?:want|need|order|ask|would (?:like|prefer|love)) (?:for )?you (?:not )?to\b"
        r"|^i would (?:rather|prefer|like|love) (?:it if )?you\b"
        r"|^i (?:want|need|would like) (?!to\b|you\b)"
        r"|^(?:you|robot) (?:should|must|have to|need to|ought to|had better|may|can|are to)\b"
        r"|\bwould you mind \w+ing|^let us (?!say|suppose|assume|imagine)"
        r"|^(?:make|be) sure (?!you are)",
        plain,
    ):
        return True
    found = re.search(
        r"\b(?:can|could|would) you (?:please |kindly |just |now |maybe )*(\w+)(?! (?:me|us)\b)",
        plain,
    )
    return bool(
        found
        and not shape.wh
        and not shape.condition
        and (found[1] in referents.verbs or found[1] in MOTION)
    )


def _ordered(shape: Shape) -> Kind:
    if shape.has(r"count") and shape.has("times|often|number"):
        return Kind.COUNT_HISTORY
    if re.match(r"(?:imagine|suppose|assume|say)\b", shape.clause):
        return Kind.WHAT_IF
    if idiom_of(shape.clause) is Kind.PAST:
        return Kind.PAST  # "Fill me in" orders nothing but an account.
    return noun_alone(shape.clause) or Kind.COMMAND


def _told(shape: Shape, referents: Referents) -> Kind:
    """A statement: a report, unless it is a few words that ask for something."""
    if alone := noun_alone(shape.clause):
        return alone
    about = referents.objects or referents.predicates or referents.actions
    if shape.subject == "you" and not about:
        return Kind.CHITCHAT  # Praise or blame.
    if len(shape.clause.split()) > 2 or referents.predicates or referents.objects:
        return Kind.REPORT
    return Kind.CHITCHAT


# -- what is asked -----------------------------------------------------------------------------


def _supposes(shape: Shape, referents: Referents) -> bool:
    """What if: a condition, or `when` behind a question about what is then done."""
    if shape.condition:
        return True
    if shape.has(r"react|respond|cope|handle") and shape.tense is Tense.CONDITIONAL:
        return True
    if shape.tense is Tense.CONDITIONAL and shape.has("what would you do (?:with|at|about|in)"):
        return True
    later = re.search(
        r"(?:do|happens?|go on|react|proceed|next|then) (?:when|whenever|once|as soon as)\b",
        shape.clause,
    )
    ends = re.search(rf"\b(?:when|once) (?:{_WHOLE})\b.*\b(?:{_FINISH})\b", shape.clause)
    return later is not None and not ends and not referents.actions and bool(shape.wh)


def _about_reason(shape: Shape, referents: Referents) -> Kind | None:
    if shape.wh == "why not" or shape.has("(?:go|be|have gone|be so) wrong if|would go wrong"):
        return Kind.WHY_NOT
    if shape.wh != "why" and not re.search(r"\bwhy\b", shape.clause):
        return Kind.WHY_HAPPENED if shape.has("(?:went|go|gone) wrong with") else None
    if of_a_thing(shape, referents) and not shape.negated:
        return Kind.WHY_HAPPENED
    speaks_of_deed = does(shape, referents)
    contrast = shape.has("instead|rather than|and not|first|before|ahead of|sooner")
    other_subject = bool(referents.objects) and not speaks_of_deed and not shape.has("you|your")
    yet = shape.negated and shape.has("yet|already")
    undone = other_subject and not referents.predicates and shape.tense is not Tense.PAST
    if yet or (shape.negated and undone and not shape.has("can|could")):
        return Kind.WHY_NOT
    if shape.negated and other_subject:
        return Kind.WHY_HAPPENED
    if shape.negated or (contrast and speaks_of_deed):
        no_fact = speaks_of_deed or shape.has("you|go") or not referents.predicates
        return Kind.WHY_NOT if no_fact else Kind.WHY_HAPPENED
    if speaks_of_deed or not (referents.predicates or shape.has("happen\\w*|fail\\w*|wrong")):
        bare_fact = (referents.objects or referents.kinds) and not shape.has("you|your|yourself")
        if (
            speaks_of_deed
            or not bare_fact
            or not re.search(r"\b(?:is|are|was|were)\b", shape.clause)
        ):
            return Kind.WHY_ACTION
    if referents.predicates and shape.has("you|your") and not shape.has("my|hand|hands"):
        return Kind.WHY_HAPPENED if _is_state_of_me(shape) else Kind.WHY_ACTION
    return Kind.WHY_HAPPENED


def _is_state_of_me(shape: Shape) -> bool:
    return not shape.has(r"\w+ing") and re.search(r"\b(?:are|were) you\b", shape.clause) is not None


def _about_number(shape: Shape, referents: Referents) -> Kind | None:
    if shape.wh == "how often" or shape.has("number of times|how many times|count"):
        return Kind.COUNT_HISTORY
    if shape.wh in ("how far", "how close"):
        return None if referents.objects else Kind.PROGRESS
    if shape.wh == "how much":
        return (
            None
            if referents.predicates and not shape.has(_LEFT + "|longer|more")
            else (Kind.PROGRESS)
        )
    if shape.wh == "how many" or re.match(r"what (?:is the )?number of", shape.clause):
        past = shape.tense in (Tense.PAST, Tense.PERFECT)
        steps = re.fullmatch(_STEP, shape.noun) is not None
        if shape.has(_LEFT + "|more|still") and not (referents.predicates and not steps):
            return Kind.PROGRESS
        if steps and not past:
            return Kind.PROGRESS
        counts = steps or referents.actions or shape.noun in referents.verbs
        found = shape.has("find|found|see|know|have got|there")
        did = re.search(r"\b(?:did|have|had|has) (?:you|it|we|the robot)\b", shape.clause)
        tries = re.fullmatch(r"tr(?:y|ip)|attempt|goe?|visit|round|call|effort", shape.noun)
        if past and not found and (counts or did or tries):
            return Kind.COUNT_HISTORY
        return Kind.STATE
    return None


def _about_rule(shape: Shape, referents: Referents) -> Kind | None:
    """Whether something that is to be kept or avoided is."""
    if shape.wh in ("where", "when", "who", "how many", "how long", "how"):
        return None
    ruled = shape.has(_RULE)
    if ruled and not shape.has("next|after"):
        return Kind.CONSTRAINT
    kept = re.search(rf"\b(?:{_KEEP})\b(?! you\b)", shape.clause)
    if shape.to_me and kept and kept[0].split()[0] not in forms_of(referents.verbs):
        return Kind.CONSTRAINT
    if shape.to_me and shape.has("never|at no time") and not shape.wh:
        return Kind.CONSTRAINT
    if (
        shape.auxiliary in BE
        and shape.has("kept|respected|violated|broken|obeyed|observed")
        and not (referents.predicates or does_exactly(shape, referents))
    ):
        return Kind.CONSTRAINT
    return Kind.CONSTRAINT if shape.has("careful") else None


def _about_whole(shape: Shape, referents: Referents) -> Kind | None:
    """How far the request is: the whole of it, or its parts, and what is done or left."""
    clause = shape.clause
    if re.search(
        r"\b(?:did|have|do|was|am|had) i (?:\w+ )?(?:ask|tell|want|said|say|request)", clause
    ):
        return Kind.PROGRESS
    if shape.has(
        "what i (?:asked|told|wanted|said)|(?<!in )progress|status|percent\\w*"
        "|on (?:track|schedule)"
    ):
        return Kind.PROGRESS
    if shape.has(rf"(?:{_TASK}|parts?|half|portion|bits?|share)") and not shape.has(
        f"current|now|at the moment|at present|being|{_LATEST}|busy|moment"
    ):
        return Kind.PROGRESS
    if shape.wh == "where" and shape.subject == "we":
        return Kind.PROGRESS
    if shape.wh == "how" and shape.has(
        "going|coming|getting on|getting along|go(?! on)|doing|along"
    ):
        return None if shape.has("about it|that") else Kind.PROGRESS
    if shape.wh in ("when", "how long", "how soon"):
        return Kind.PROGRESS if _asks_for_the_end(shape, referents) else None
    about_all = not referents.objects and not referents.kinds
    finishing = shape.has(_FINISH)
    if shape.yes_no and shape.subject in ("everything", "all") and not referents.predicates:
        return Kind.PROGRESS
    fact = shape.yes_no and referents.predicates
    if (
        about_all
        and not fact
        and shape.has(f"{_LEFT}|still to (?:do|come)|take (?:much )?long(?:er)?")
        and not (shape.has("which") or (shape.has("remaining|pending") and shape.has(_STEP)))
    ):
        return Kind.PROGRESS
    if about_all and finishing and not shape.wh and _asks_of_subject(shape):
        whole = re.fullmatch(_WHOLE, shape.subject) is not None
        return Kind.PROGRESS if whole and not does_exactly(shape, referents) else None
    if (
        about_all
        and shape.wh in ("what", "which")
        and (
            re.match(
                r"(?:what|which)(?: \w+)* (?:is|are|ha(?:s|ve) been)(?: \w+)? (?:done|finished)$",
                clause,
            )
        )
    ):
        return Kind.PROGRESS
    fine = shape.has(
        "fine|ok|okay|well|smoothly|all right|alright|as planned|to plan|succeed|manage"
    )
    if fine and about_all and not shape.wh:
        return Kind.PROGRESS
    return Kind.PROGRESS if shape.has("make it|success\\w*") and about_all else None


def _asks_for_the_end(shape: Shape, referents: Referents) -> bool:
    """`When will you be done`, `how long does it take`: the time of the whole."""
    whole = re.search(rf"\b(?:{_WHOLE})\b", shape.clause) is not None
    if not whole or referents.objects or referents.kinds or referents.actions:
        return False
    lasts = shape.wh == "how long" and shape.tense is not Tense.PERFECT
    ended = lasts or shape.has(_FINISH) or shape.has("end|stop|take|longer")
    return ended and not shape.has("ago|been")


def _asks_of_subject(shape: Shape) -> bool:
    """`Are you done`, `you are done`; not `everything you have done`."""
    first, *rest = shape.clause.split() or [""]
    return first == shape.auxiliary or (first == shape.subject and rest[:1] == [shape.auxiliary])


# -- what is left: the tense decides -----------------------------------------------------------


def _by_tense(shape: Shape, referents: Referents) -> Kind:
    if _is_future(shape):
        return Kind.FUTURE
    if _is_past(shape, referents):
        return Kind.PAST
    if _is_now(shape, referents):
        return Kind.NOW
    known = referents.objects or referents.predicates or referents.kinds or referents.topics
    if known or shape.wh == "where" or (shape.wh == "who" and shape.has("you|there|here|around")):
        return Kind.STATE
    if referents.actions or shape.has("it|this|that|so"):
        return Kind.NOW if shape.auxiliary in BE else Kind.FUTURE
    return Kind.CHITCHAT


def _is_future(shape: Shape) -> bool:
    if shape.has("so far|already|up to now|until now|happened"):
        return False
    if shape.tense in (Tense.FUTURE, Tense.CONDITIONAL):
        return True
    past = shape.tense in (Tense.PAST, Tense.PERFECT)
    if past:
        return False
    if shape.has(rf"{_LATEST}|plans?|planned|planning|intend\w*|intentions?|coming|comes?|to come"):
        return not shape.has("before")
    if re.match(r"(?:what|and|where|so)?\s*(?:then|now what|what then)$", shape.clause):
        return True
    if shape.wh == "how" and shape.has("go on|continue|proceed|carry on"):
        return True
    if shape.has("after|until you|once|when|heading|headed|off to") and shape.wh:
        return True
    if shape.has(r"(?:want|have|need|supposed|expected|left|got) to") and shape.to_me:
        return True
    return shape.wh == "where" and shape.has("going|go|driving|moving|travelling")


def _is_past(shape: Shape, referents: Referents) -> bool:
    if re.search(r"\b(?:before|previously|earlier)(?: (?:that|this|then|it))?$", shape.clause):
        return True
    if shape.has(
        r"(?:last|previous|latest|most recent|earlier) (?:action|step|thing|task|move|deed)"
    ):
        return True
    past = shape.tense in (Tense.PAST, Tense.PERFECT)
    if not shape.auxiliary and does_exactly(shape, referents, "past"):
        return True
    if not past:
        return bool(
            shape.has("so far|until now|up to now|history|recap|summary|up to this")
        ) and not (referents.predicates)
    fact = bool(referents.predicates) and shape.wh in ("which", "how many", "what", "who", "where")
    if (
        shape.tense is Tense.PERFECT
        and fact
        and not shape.has("you|your|i")
        and (shape.auxiliary in HAVE)
    ):
        return False  # "Which have been seen": what is so.
    if shape.auxiliary in BE and not shape.negated and not shape.has("was|were"):
        return False
    return not (shape.wh == "where" and not shape.has("you|been|go|went"))


def _is_now(shape: Shape, referents: Referents) -> bool:
    if re.fullmatch(_STEP, shape.noun) and shape.has(
        "at the moment|right now|at present|currently"
    ):
        return True
    if shape.wh == "where" or (shape.wh in ("how many", "which") and referents.predicates):
        return False
    if re.match(
        r"are you (?:\w+ )*(?:paused|waiting|stuck|idle|moving|working|running|stopped|active|busy"
        r"|free|resting|on a break|on hold|blocked)\b",
        shape.clause,
    ):
        return True
    if shape.has(
        "doing|happening|going on|up to|bus(?:y|ying)|occup\\w+|working|situation|what is up"
        "|(?:current|present)\\w*|in progress|your attention|carrying out|performing|executing"
    ):
        return not (referents.predicates and not shape.to_me)
    if (
        shape.to_me
        and re.search(r"\b(?:are|is)\b", shape.clause)
        and does_exactly(shape, referents)
    ):
        return not (referents.atoms and not referents.actions)
    if shape.auxiliary in BE and shape.has("being"):
        return True
    if re.fullmatch(_STEP, shape.noun) or re.match(
        rf"what(?: \w+)? is (?:your|the) (?:{_STEP})$", shape.clause
    ):
        return True
    if shape.auxiliary in BE and does_exactly(shape, referents) and shape.has(r"\w+ing"):
        return True
    bare = not (referents.objects or referents.predicates or referents.kinds)
    return bare and (
        shape.has("at the moment|right now|now|at present|currently")
        or (
            re.fullmatch(
                r"what are you(?: \w+)? (?:at|on|about|in)(?: \w+)*"
                r"|what you are (?:at|on)(?: \w+)*",
                shape.clause,
            )
            is not None
        )
    )
