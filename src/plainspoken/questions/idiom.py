"""Set phrases of talk about work: whole expressions whose kind no word of them gives away.

`Fill me in` asks for the past, `where to?` for the future, `what's the hold-up?` why it does not
go on. They hold words of English, never words of a domain; a phrase that a grammar can read has no
place here.
"""

from __future__ import annotations

import re
from functools import cache

from plainspoken.questions.kind import Kind

_NOW = r"""
    what (?:is|are) (?:you |it )?(?:up|going on|happening|cooking)(?: with you| there| here\
    | now| right now| at (?:the|this) (?:very )?(?:moment|minute))?$
    (?:is )?any(?:thing|body) (?:happening|going on|moving|working)
    (?:are|is) (?:you|it|the \w+|the robot) (?:moving|working|running|driving) or\b
    ^are you (?:in the (?:middle|midst) of|on) (?:something|anything|it|a job)
    ^(?:who|whom|what) are you (?:with|at|on|dealing with|attending to|looking at)\b
    ^are you (?:\w+ )?(?:trying|attempting|helping|looking|dealing|attending|taking care)\b
    ^are you (?:doing|working on) (?:anything|something)
    ^what (?:is|are) (?:you|it|the \w+) (?:at|on|about)(?: right)?(?: now| just now\
    | the moment)?$
    ^(?:which|what)(?: \w+)? are you (?:\w+ing (?:on|at|with)|handling|treating)\b
    ^what (?:is )?keep(?:s|ing) you (?:busy|occupied)
    ^what has you (?:busy|occupied)
    ^(?:which|what) (?:step|action|task|job|activity) are you (?:on|at|in)\b
    ^what are your hands (?:full|on)
    ^what is (?:on|in) (?:hand|progress)$
    ^(?:is it|so it is) \w+ (?:\w+ )?you are (?:looking|working|dealing|going)\b
"""
_PAST = r"""
    ^(?:please )?(?:recap\b|fill (?:me|us) in|catch (?:me|us) up|bring (?:me|us) up to (?:date\
    |speed))
    ^(?:get|put) (?:me|us) (?:up to speed|in the picture)
    ^(?:a |the )?(?:brief )?history\b
    (?:did|have) (?:i|we) miss(?:ed)?\b
    ^what all (?:did|have) you
    ^what (?:has|is|have) (?:\w+ )?(?:happened|gone on|been going on|been done\
    |been happening)(?! to\b| with\b)
    ^what happened (?:while|since|so far|until|up to|before|after|when i|today|yesterday|last\
    |this|in)
    ^(?:did|has|have) (?:anything|something|it|things?|everything) (?:\w+ )?(?:happen|go wrong\
    |gone wrong|come up|fail|break|change)
    ^were there (?:any )?(?:problem|trouble|difficult|issue|surprise|incident|hiccup)
    ^(?:did|have) you (?:\w+ )?(?:have|had|run into|meet|met\
    |encounter(?:ed)?) (?:any )?(?:problem|trouble|difficult|issue|surprise)
    ^how did you (?:get|come) (?:here|this far)
    ^how have you (?:spent|been spending)
    ^how was your (?:day|morning|night|shift)
    ^what did (?:your|the) \w+ look like
"""
_FUTURE = r"""
    (?:on|next on|left on|still on) (?:your|the) (?:agenda|list|schedule|plate|to do list\
    |programme)
    in store\b
    up your sleeve
    ^where (?:to|next|to next|now|to now)$
    ^what is (?:the )?(?:\w+ )?(?:plan|schedule|idea)(?: from| for| now| then| next|$)
    ^what do you have (?:planned|lined up|coming up)
    ^what (?:have|has) you got (?:planned|lined up)
    ^how (?:do|will|are|would) you (?:want to |going to |plan to |mean to )?(?:proceed|continue\
    |go on|carry on|finish|wrap)
    ^what (?:is|are) (?:up|coming|the) next\b
    ^what follows
    ^and (?:after|then|next)\b
"""
_WHY_ACTION = r"""
    in aid of\b
    ^what (?:do|did) you (?:want|need|hope|seek)(?: \w+)? (?:at|with|in|from|of)\b
    ^what (?:do|did|will) you (?:hope|expect|try|want) to (?:achieve|gain|get)
    ^what (?:is|was|are) (?:all )?(?:that|this|the) [\w ]+ (?:about|good for|in aid of|for)$
    ^what good (?:is|was|does|will)\b
    ^what use\b
    ^(?:is|was) (?:that|this|it) (?:really )?necessary
    ^(?:did|do) you really (?:have|need) to\b
    ^what (?:is|was|will|would|does|did|do) (?:that|this|it|all that) (?:supposed to \
    |meant to )?(?:achieve|accomplish|bring|gain|serve|help|do for)\b
"""
_WHY_NOT = r"""
    ^(?:could|can) you not\b
    ^what is (?:the|your) (?:hold[ -]?up|delay|obstacle|problem|snag|holdup)
    ^what (?:is )?(?:taking|took|takes) you so long to\b
    ^what are you waiting for
    ^what is (?:standing )?in (?:the|your) way
    ^what (?:does it|is it) (?:still )?need\b
    ^(?:could|can|would|should) (?:you|we|it|not) (?:not )?(?:have |be )?(?:\w+ )?(?:skip\
    |instead|rather|quicker|faster|better|easier|simpler|shorter|wiser|cheaper)
    ^(?:would|is) it (?:not )?(?:be )?(?:\w+ )?(?:quicker|faster|better|easier|simpler|shorter\
    |wiser|smarter)\b
    ^why not\b(?! what)
"""
_WHY_HAPPENED = r"""
    ^what (?:has )?(?:happened|went wrong|gone wrong) (?:to|with)\b
    ^(?:why|how come)\b.*\b(?:take|took|taken|taking|last|lasting) (?:so|that|this\
    |such a) (?:long|much)
    ^(?:why|how come)\b.*\b(?:fail(?:ed|ing)?|go(?:ne)? wrong|break|broken?|go(?:es|ne)? (?:off\
    |out|bad))\b
    ^who (?:made|caused|let|left|put)\b
    ^who(?: is| was)? (?:to blame|responsible|at fault)
    ^what (?!did|do|does|is|are|was|were|have|has|will|would|can|could|should|if|about|else\
    |time|kind|sort|makes|you|i|we)\w+(?:ed|t|d) (?:the|my|your|it|up)\b
    ^whose fault\b
"""
_PROGRESS = r"""
    ^(?:are|is) (?:you|it|we|everything) (?:\w+ )?(?:behind|ahead of|on\
    |in)(?: the)? (?:schedule|time|plan|track|course)\b(?! of)
    ^(?:are you |is it )?(?:running )?(?:late|on time)$
    ^(?:almost|nearly|all|quite) (?:there|done|finished|ready)
    ^how many (?:more )?(?:seconds|minutes|hours|rounds|turns|steps|actions)\b.*\b(?:until|till\
    |left|more|to go|before|need)\b
    ^how (?:is|are|goes) (?:it|things|everything|dinner|lunch|breakfast|work|life\
    |that)\b(?: going| coming| getting| looking| work| progress| with|$)
    ^(?:any|much) (?:news|progress|headway)
    ^where (?:are|do) (?:we|you) (?:at|stand)(?: with)?\b(?! the)
    ^how (?:far|close|near)\b.*\b(?:along|away from|off|from|you|we|got|through)\b
    ^(?:did|do|does|is|has) it (?:all )?(?:go|work(?:ed)?|gone|going) (?:well|out|smoothly|fine\
    |to plan)
    ^(?:will|are|is) (?:you|it|this)(?: going to)? (?:be|take|need) (?:much |a lot |any \
    |very )?(?:long|longer)\b
    ^(?:what|which|how (?:big|large|much)) (?:\w+ )?(?:part|portion|share|half|bit\
    |fraction)s? of (?:the|your|my|it)
    ^are you (?:getting|making) (?:any|some|good|there|on|head|pro|close)\w*
    ^(?:are|is) (?:you|it) (?:getting )?close
    ^is there (?:much|a lot|anything|more) (?:left|to do|to go|still)
"""
_CONSTRAINT = r"""
    \b(?:not|never|n't) (?:supposed|meant|allowed|permitted|to be allowed) to\b
    \b(?:supposed|meant|allowed|permitted|told|forbidden) (?:not|never) to\b
    ^(?:are|have|were) you (?:been )?(?:making|made|taking|taken) (?:sure|care)\b
    ^(?:do|need|should|must) i (?:have to |need to )?(?:worry|be worried|fear|be afraid)\b
    \b(?:i|we) (?:hope|trust)$
    ^(?:i|we) (?:hope|trust) you\b
    \b(?:conditions|rules|wishes|terms|limits|instructions|orders)\b(?: \w+)* (?:met|kept\
    |respected|followed|obeyed|observed)\b
    ^(?:are|have|do|did) you (?:been )?(?:comply|behav|conform)
    ^(?:are|have|were) you (?:been )?(?:follow|stick|obey|respect|observ|heed|break|violat\
    |disobey)\w* (?:to )?(?:my|our|the|your|any|all|what)\b
    ^(?:is|are) (?:\w+ ){1,4}(?:off limits|out of bounds|forbidden|taboo|a no go|banned)\b
    \b(?:by the (?:book|rules?)|in line with)\b
    \b(?:must|may|can|should) (?:you )?not (?:\w+ )?(?:do|touch|enter)$
    ^you will (?:not|never)\b.*\b(?:at any (?:time|point|moment)|ever|under any|no matter)\b
    \bout of (?:trouble|bounds)\b
    ^what (?:must|may|can) you not\b
    ^what are you (?:not )?(?:allowed|permitted)
"""
_STATE = r"""
    ^(?:have|are|did) (?:we|you) (?:run out|running out|out of|short of|(?:running )?low on)\b
    ^(?:is|are) there (?:any|some|still)\b.*\b(?:left|there|in|on|at)\b
    ^(?:do|does|have) (?:we|you) (?:still )?(?:have|got) (?:any|some)\b
    ^what (?:do|does) (?:it|\w+ \w+|\w+) look like
    ^what (?:state|condition|shape)\b
"""
_CHITCHAT = r"""
    ^what do you think (?:of|about)\b
    ^what (?:kind|sort)s? of (?:questions|things) (?:can|may|could)
    ^what (?:can|may|could|should) i (?:ask|say)
    ^what (?:questions|languages)\b
    ^do you (?:know|have|want|feel|like|hate|love|get|ever get) (?:any )?(?:jokes?|friends?\
    |tired|bored|lonely|feelings?)
    ^how (?:are|do) you (?:today|feel\w*|doing today)
    ^what is the (?:capital|weather|date|time|news)\b
    ^who (?:is|are|was) (?:the )?(?:president|prime|your|god)
    ^(?:happy|merry) \w+
"""
_TABLE = (
    (Kind.CHITCHAT, _CHITCHAT),
    (Kind.CONSTRAINT, _CONSTRAINT),
    (Kind.WHY_NOT, _WHY_NOT),
    (Kind.WHY_HAPPENED, _WHY_HAPPENED),
    (Kind.WHY_ACTION, _WHY_ACTION),
    (Kind.PROGRESS, _PROGRESS),
    (Kind.PAST, _PAST),
    (Kind.FUTURE, _FUTURE),
    (Kind.NOW, _NOW),
    (Kind.STATE, _STATE),
)


@cache
def _compiled() -> tuple[tuple[Kind, re.Pattern[str]], ...]:
    return tuple((kind, re.compile(_joined(phrases))) for kind, phrases in _TABLE)


def _joined(phrases: str) -> str:
    """One pattern of several, each on a line; a backslash at the end goes on with the next."""
    lines = re.sub(r"\\\n\s*", "", phrases).splitlines()
    return "|".join(line.strip() for line in lines if line.strip())


def idiom_of(clause: str) -> Kind | None:
    """The kind of a set phrase, None where the clause holds none."""
    for kind, pattern in _compiled():
        if pattern.search(clause):
            return kind
    return None


_ACCOUNT = (
    r"(?:please )?recap|(?:short |brief )?(?:summary|account|overview)|log|history|report|so far"
    r"|and before(?: that)?|before that"
)
_NOUN_ALONE = (
    (Kind.PROGRESS, r"status|progress|how far|done|finished|ready|anything left|all done|complete"),
    (Kind.FUTURE, r"plans?|next|and next|and then|then|next steps?|and after that|intentions?"),
    (Kind.PAST, _ACCOUNT),
    (Kind.NOW, r"now|and now|right now|busy|situation|current \w+|doing what"),
)


def noun_alone(clause: str) -> Kind | None:
    """The kind of a few words that ask by themselves: `status?`, `and then?`."""
    for kind, words in _NOUN_ALONE:
        if re.match(rf"(?:(?:the|your|a|any|quick) )*(?:{words})\b", clause):
            return kind
    return None
