"""The kinds of questions, and the English that tells them apart.

A kind is known by patterns over the normalised text, one alternative a line; the first kind of
`RULES` with a pattern that is found decides, so the order is part of the rules.
"""

from __future__ import annotations

import re
from enum import StrEnum


class Kind(StrEnum):
    """The kinds of questions, as `ask --batch` writes them."""

    NOW = "now"
    PAST = "past"
    FUTURE = "future"
    WHY_ACTION = "why_action"
    WHY_NOT = "why_not"
    WHY_HAPPENED = "why_happened"
    WHEN = "when"
    STATE = "state"
    PROGRESS = "progress"
    WHAT_IF = "what_if"
    CONSTRAINT = "constraint"
    COUNT_HISTORY = "count_history"
    REPORT = "report"
    COMMAND = "command"
    CHITCHAT = "chitchat"


AUXILIARY = (
    r"(?:is|are|was|were|am|be|do|does|did|has|have|had|will|would|can|could|shall|should|may|might"
    r"|must)"
)


def _any(lines: str) -> re.Pattern[str]:
    """A pattern of alternatives, one a line; a line that begins with `..` goes on the last one."""
    joined = "|".join(line.strip() for line in lines.strip().splitlines())
    return re.compile(joined.replace("|..", "").replace("AUXILIARY", AUXILIARY))


SMALL_TALK = _any(r"""
    ^(?:hello|hi|hey|good (?:morning|afternoon|evening|night|day|bye)|goodbye|bye|thanks?|
    ..thank you|cheers|nice|great|well done|good (?:job|work|robot)|ok(?:ay)?|
    ..sorry)\b(?:[ ,!.]+(?:\w+)){0,3}\W*$
""")
OUT_OF_SCOPE = _any(r"""
    ^(?:who|what) are you\W*$
    your name
    how are you
    how do you (?:do|feel)
    are you (?:ok|okay|happy|sad|tired|alive|human|conscious|bored|a robot)\b
    joke
    weather
    do you (?:like|love|dream|enjoy)
    what can (?:you (?:do|answer|tell)|i ask)
    how old are you
    \bsing\b
    ^tell me about yourself
    ^help\W*$
    who (?:made|built) you
    meaning of life
    ignore (?:all |any )?(?:your |previous |the |these )
    system prompt
    pretend (?:to|you)
""")

RULES: tuple[tuple[Kind, re.Pattern[str]], ...] = (
    (
        Kind.WHAT_IF,
        _any(
            r"""
            \bwhat if\b
            what (?:happens|would happen|will happen|do you do|would you do|
            ..will you do)(?: next)? (?:if|when|in case|should)\b
            ^(?:suppose|imagine|assume|assuming|say)\b
            ^if\b
            \bin case\b.*\bwhat\b
            \bif\b.*\b(?:what|would you|will you)\b
            (?:would|will) you .*\bif\b
            what would\b
            """
        ),
    ),
    (
        Kind.WHY_NOT,
        _any(
            r"""
            \bwhy (?:not|dont|didnt|havent|wont|arent|isnt|cant|couldnt|wouldnt|doesnt|wasnt|
            ..hasnt)\b
            \bwhy (?:do|did|are|is|will|can|could|have|has|should|would|does|was|were)\b.*\bnot\b
            how come .*\bnot\b
            why .*(?:instead|rather than|and not|before|first)\b
            what (?:stops|prevents|keeps|hinders) you
            what would (?:go|be) wrong
            """
        ),
    ),
    (
        Kind.WHY_ACTION,
        _any(
            r"""
            (?:\bwhy\b|how come|for what reason|what reason|to what end|what makes you|
            ..what made you|what is the (?:reason|point|purpose|use|goal|aim)|^what .* for\W*$|
            ..reason (?:for|behind)|explain)(?!.*\b(?:happen|go wrong|went wrong|fail)).*\b(?:you|
            ..your|youre|yourself)\b
            ^(?:and |but |so |ok |okay )?(?:why|how come|what for|for what)\W*(?:now|that|this|
            ..so)?\W*$
            \byour?\b.* why\W*$
            what are you .* for\W*$
            what is (?:this|that|it) (?:good )?for
            what is the (?:point|purpose|reason)
            """
        ),
    ),
    (
        Kind.WHY_HAPPENED,
        _any(
            r"""
            \bwhy\b
            how come
            what caused
            what went wrong
            what is the cause
            how did it
            """
        ),
    ),
    (
        Kind.COUNT_HISTORY,
        _any(
            r"""
            how (?:often|many times|frequently)
            (?:did|have|has|were|was) (?:you|it|the \w+|\w+) ever\b
            \bever (?:been|done|fail|failed|had)
            how many (?:actions|steps|things|tasks|moves|times).*\b(?:did|have|taken|done|so far|
            ..already)\b
            number of times
            what number of
            how many \w+(?: \w+)? (?:did|have|has|were|got)
            """
        ),
    ),
    (
        Kind.PROGRESS,
        _any(
            r"""
            (?:did|have|do) i (?:\w+ )?(?:ask|asked|told|tell|want|wanted|said|say)\b
            what is (?:your|the) (?:goal|mission|task|job|order|objective|request|aim)s?\b
            going well
            how far
            progress
            how much (?:is|of|work|more|longer|remains|have)
            how many (?:more )?(?:steps|actions|tasks|things) (?:are|remain|left|to go|more|will|do)
            how many more
            how long (?:will|does|until|till|before|is it going)
            how (?:is|are) (?:it|things|the (?:mission|work|job|task)|everything) (?:going|coming)
            are (?:you|we) (?:\w+ )?(?:done|finished|ready|there yet|on track|complete)\b
            are (?:you|we) on (?:track|schedule)
            is (?:it|the (?:mission|job|work|task|request)|everything) (?:\w+ )?(?:done|finished|
            ..complete|completed|over|fine|ok|okay|on track|ready)
            what (?:is|are|s) (?:still )?(?:left|open|missing|outstanding|remaining|done|finished)\b
            what (?:remains|is still)
            have you (?:\w+ )?(?:finished|completed|achieved|done (?:everything|it|all))
            when will (?:you|it|we|the \w+|everything) be (?:done|finished|ready|complete|over)
            when (?:will|do) you (?:finish|be done|complete)
            status\b
            percent
            nearly there
            almost (?:done|finished)
            how close
            what (?:part|parts) of .*(?:done|open|left)
            did you (?:finish|complete|achieve|succeed)
            will you (?:make it|manage|succeed)
            """
        ),
    ),
    (
        Kind.CONSTRAINT,
        _any(
            r"""
            (?:are|were) you (?:\w+ )?(?:keeping|staying|sticking|avoiding|respecting|obeying|
            ..following|observing|complying|honouring|honoring|breaking|violating|careful)
            (?:have|did|do|will|would) you (?:\w+ )?(?:kept|keep|stayed|stay away|stick|stuck|
            ..avoided|avoid|respected|respect|violated|violate|broken|break|broke|obey|obeyed|follow|
            ..followed)
            \b(?:rule|rules|constraint|constraints|restriction|restrictions|forbidden|allowed|
            ..safety|condition i set)\b
            guarantee
            ^(?:is|was) .*\b(?:never|always|kept|respected|violated|broken|ever be)\b
            promise
            """
        ),
    ),
    (
        Kind.WHEN,
        _any(
            r"""
            ^(?:and |so )?(?:when|since when|until when|till when)\b
            at (?:what|which) (?:time|point|step|moment|instant)
            how long (?:ago|have|has|did|was|were)
            what time
            how (?:soon|recently)
            since (?:when|what time)
            in how many steps
            """
        ),
    ),
    (
        Kind.FUTURE,
        _any(
            r"""
            \b(?:next|upcoming|afterwards|later|eventually|from now on|in the future)\b(?! to)
            (?:going|planning|intending|about|want|intend|plan|mean|have) to (?!you)
            will you\b
            \byou will\b
            \bplans?\b
            \bplanned\b
            after (?:that|this|it|you|then)
            (?:is|are|s) coming
            to do(?: now)?\W*$
            what (?:is|s) (?:ahead|to come)
            will (?:the|there|it|any|all|\w+ \d+|\w+)
            ^(?:and )?then(?: what)?\W*$
            ^(?:and|what) then
            where are you (?:heading|going|off|headed)
            what remains for you
            your intentions?
            your (?:next|following)
            rest of
            what (?:do|does|happens|comes) .*\bafter\b
            ^after
            """
        ),
    ),
    (
        Kind.PAST,
        _any(
            r"""
            (?:go|gone|went) wrong\b
            (?:what|which \w+|where|who|whom|how) (?:all )?(?:did|have|had|was|were|has) (?:you|
            ..your|happened|the robot|already|it)\b
            what happened
            \bso far\b
            until now
            up to now
            ^(?:did|have|had) you\b
            (?:your|the) (?:last|previous|past|latest|first|most recent|earlier)
            what (?:have|did)
            \bhistory\b
            already (?:do|done)
            have you been
            you (?:just|already|have|had|did)\b
            (?:summary|summarise|summarize|recap|log|account|report) .*(?:of|what|on|your)?
            ^were you\b
            what was (?:done|that|it)
            before (?:that|this)
            what were you
            (?:last|yesterday|earlier)\W*$
            """
        ),
    ),
    (
        Kind.NOW,
        _any(
            r"""
            ^are you (?:\w+ )?(?:paused|waiting|stuck|idle|moving|working|running|stopped|active)\b
            \byou (?:\w+ )?(?:doing|working on|up to|busy|occupied)
            you (?:right )?now\W*$
            (?:doing|happening|going on|up)\b.*
            current(?:ly)? .*(?:action|task|activity|step|doing|situation|state|job|working|busy|
            ..happening)
            ^(?:and )?(?:right )?now\W*$
            at the moment
            what is up
            what (?:action|task|job|activity) (?:are|is)
            situation
            ^what now
            busy
            """
        ),
    ),
    (
        Kind.STATE,
        _any(
            r"""
            ^(?:and |so |but )?(?:where|which|who|whose|what|how many|how much|how|AUXILIARY|
            ..tell me|show|list|name|give)\b
            """
        ),
    ),
)

COMMAND = _any(r"""
    ^(?:please |now |robot |then |hey )*(?:(?:can|could|would|will) you (?:please |kindly )|
    ..(?:i (?:want|need|would like|order|d like) you to|you (?:should|must|have to|need to|
    ..had better)|let us|lets|make sure|be sure|dont|do not|never|always|go |come |stop|halt|
    ..pause|resume|continue|cancel|abort|wait|start|begin|hurry|return|proceed|forget)\b)
""")
REPORT = _any(r"""
    ^(?:fyi|by the way|btw|note that|just so you know|for your information|heads up|i think|
    ..actually)\b
    ^(?:i|we) (?:have |ve |had |just |already |also |myself )*(?!want|need|would|am|order|
    ..wonder|like|love|see you)\w+
    ^(?!what|where|which|who|how|why|when|is|are|was|were|do|does|did|has|have|will|can|
    ..could)(?:the |my |your |there )?(?:\w+ ){1,4}?(?:is|are|was|were|has|have|isnt|needs|
    ..looks|seems)\b
""")
