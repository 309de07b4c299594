"""The grammar of what is said: mood, question word, tense, voice and subject.

English only: what the words speak of is looked up elsewhere. A text is cut down to one clause
(`Hey, can you tell me what you are doing` is about `what you are doing`), and what decides between
kinds of questions is read off it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

from plainspoken.questions.morphology import IRREGULAR_VERBS, lemma

BE = frozenset({"is", "are", "am", "was", "were", "be", "been", "being"})
HAVE = frozenset({"has", "have", "had"})
DO = frozenset({"do", "does", "did"})
MODAL = frozenset(
    {"will", "would", "can", "could", "shall", "should", "may", "might", "must", "ought"}
)
AUXILIARIES = (BE - {"be", "been", "being"}) | HAVE | DO | MODAL
PRONOUNS = frozenset(
    {"you", "i", "we", "it", "they", "he", "she", "this", "that", "these", "those", "there"}
    | {"someone", "somebody", "something", "anyone", "anybody", "anything", "everything"}
    | {"everyone", "everybody", "nothing", "nobody", "all", "both", "none", "another", "others"}
)
DETERMINERS = frozenset(
    {"the", "a", "an", "my", "your", "our", "its", "their", "his", "her", "this", "that"}
    | {"these", "those", "some", "any", "every", "each", "no", "which", "what", "next", "last"}
    | {"first", "many", "several", "previous", "current", "latest"}
)
_FUNCTION_WORDS = (
    AUXILIARIES
    | PRONOUNS
    | DETERMINERS
    | {"and", "or", "but", "if", "of", "in", "on", "at", "by", "to", "from", "with", "for", "as"}
    | {"what", "where", "which", "who", "whose", "whom", "how", "why", "when", "yes", "not"}
    | {"now", "then", "afterwards", "later", "already", "still", "yet", "so", "once", "after"}
    | {"actually", "unfortunately", "apparently", "suddenly", "today", "meanwhile", "because"}
    | {"everything", "anything", "nothing", "ever", "until", "before", "than", "imagine"}
)


_PARTICIPLES = frozenset(participle for _, participle in IRREGULAR_VERBS.values())


class Mood(StrEnum):
    """What a text does."""

    ASKING = "asking"
    ORDERING = "ordering"
    TELLING = "telling"


class Tense(StrEnum):
    """When it is about."""

    PRESENT = "present"
    PAST = "past"
    PERFECT = "perfect"
    FUTURE = "future"
    CONDITIONAL = "conditional"


@dataclass(frozen=True, slots=True)
class Shape:
    """What the grammar of a text gives away.

    clause:    the words that are left without openings, frames and tags
    wh:        why, what, which, who, where, when, how, how many, how often ...; "" for yes or no
    noun:      the noun behind `which`, `what` or `how many`: `which action`
    auxiliary: the first auxiliary of the main clause, "" where there is none
    subject:   the word behind it, or before it where the order is that of a statement
    condition: whether the main clause hangs on an `if`
    """

    mood: Mood
    clause: str
    wh: str = ""
    noun: str = ""
    auxiliary: str = ""
    tense: Tense = Tense.PRESENT
    subject: str = ""
    negated: bool = False
    condition: bool = False

    def has(self, pattern: str) -> bool:
        """Whether the clause has whole words that fit."""
        return re.search(rf"\b(?:{pattern})\b", self.clause) is not None

    @property
    def to_me(self) -> bool:
        """Whether the robot that speaks is the subject, or who is meant."""
        return self.subject in ("you", "robot", "your") or self.has("you|your|yourself")

    @property
    def yes_no(self) -> bool:
        return (
            self.mood is Mood.ASKING
            and not self.wh
            and (bool(self.auxiliary) or self.subject == "you")
        )


_OPENING = re.compile(
    r"^(?:and|so|but|then|now|well|ok|okay|alright|right|hey|hi|hello|please|excuse me|listen|sorry"
    r"|robot|also|just|again|tell me this|one question|quick question|out of curiosity"
    r"|roughly|approximately|about(?= how)|exactly|honestly|seriously|actually|status please"
    r"|come on|say(?= (?:how|what|why|where|when|who)))\b (?=\w)"
)
_KEPT_OPENING = re.compile(r"^(?:and|then|so|now) (?:then|now|what|after that)?$|^(?:now|then)$")
_ME = r"(?: to)?(?: me| us)?"
_FRAME = re.compile(
    rf"^(?:(?:can|could|would|will) you (?:please |kindly |just |quickly )*(?=(?:tell|show|list"
    rf"|give|name|explain|describe|say|report|summari[sz]e|recap|remind|walk|talk|run|let|count)\b))?"
    rf"(?:(?:please|kindly|just) )?"
    rf"(?:(?:tell|show|give|say|remind)(?: to)?"
    rf"(?: me| us| about|(?= (?:what|which|why|where|when|how"
    rf"|who|whether|if|a|an|your)\b))(?: about| again| exactly)?(?= )"
    rf"|(?:explain|describe|list|name|report|recap|summari[sz]e|repeat)"
    rf"{_ME}(?: about| again| exactly)?(?= (?!please$))"
    rf"|sum up|(?:walk|talk|run|take) (?:me|us) through|let (?:me|us) know"
    rf"|(?:do|would|could) you (?:happen to )?(?:know|remember|recall|think|believe)"
    rf"|(?:have you )?any idea|are you (?:sure|certain|aware)(?: that)?"
    rf"|i (?:want|would like|d like|need|have) to (?:know|ask|hear)|i (?:wonder|was wondering)"
    rf"|is it (?:true|right|correct|possible|so) that|is it the case that"
    rf"|can i (?:ask|know)|may i (?:ask|know))(?: if| whether)? "
)
_REPORTING = re.compile(
    r"^(?:watch out|look out|attention|beware|look|mind you|(?:it )?turns out|fyi|by the way|btw"
    r"|note that|heads up|for your information|be aware|careful"
    r"|just (?:so you know|to let you know)|(?:so |as )?you (?:should|may|might) know)(?: that)? "
)
_AHEAD = re.compile(
    r"((?:when|once|after|as soon as|whenever|while|if) .+?) ((?:then )?"
    r"(?:what|where|which|how|who|why|(?:will|would|do|are) (?:you|it|we))\b.*)"
)
"""What hangs on the main clause and stands before it: "when you are done, what will you do"."""
_ASIDE = re.compile(
    r" (?:as|like|the way)(?: \w+)? (?:i|we)(?: have| had)? (?:ask|tell|told|sa(?:y|id)|want)\w*"
    r"(?: you| for)?(?: to)?$"
)
_TAG = re.compile(
    r" (do|does|did|is|are|was|were|has|have|had|will|would|can|could|shall|should)"
    r"(?: (?:you|it|he|she|they|we|there|i))(?: not)?$| (?:right|correct|yes|no|ok|okay)$"
)
_WH = re.compile(
    r"^(?:(?:at|in|on|since|until|till|by|from|for|to|up to) )?"
    r"(why|how come|how many|how much|how often|how frequently|how long|how far|how soon|how close"
    r"|how recently|how|what|which|who|whom|whose|where|when)\b"
)
_CLEFT = re.compile(
    r"^(what|who|where|why|when|how) (?:is|was) it (?:that )?(?=(?:you|is|was|has|i|we|the)\b)"
)
"""`What is it that is going on` asks what is going on."""
_REASON = re.compile(
    r"^(?:(?:for|with) (?:what|which)(?: \w+)? (?:reason|purpose|motive|intention|aim)s?"
    r"|to what (?:end|purpose)|on what grounds|what reason"
    r"|what (?:is|was|were|are)(?: all)? (?:the|your) (?:\w+ )?(?:reason|point|purpose|use|sense"
    r"|idea|motive|cause|rationale|intention)s?(?: of| behind| in| for| that| why)?"
    r"|what (?:made|makes|led|leads|drove|drives|prompted|prompts|caused|causes)"
    r"|what (?:takes|took|brings|brought|gets|got) (?:you|it)"
    r"|(?:is there |are there )?(?:any|a|some)(?: \w+)? (?:reason|purpose|point|sense)"
    r"|what (?:has |have |had )?(?:caused|led to|brought about)"
    r"|the reason (?:for|why|that|behind)|reason (?:for|why|behind)|what for|for what|wherefore)\b"
)
_HINDERED = re.compile(
    r"^what(?: is| was| are| has| would)?(?: it that)? (?:stop|prevent|keep|hinder|hold|block|bar)"
    r"(?:s|ping|ing|ped|ed|t)?\b(?! you busy)"
)
_CONDITION = re.compile(
    r"^(?:what )?if\b|^(?:suppose|supposing|imagine|assume|assuming|provided|say)\b"
    r"|\b(?:if|in case|in the event)\b(?! (?:you|i) (?:may|want|please))"
    r"|^(?:what|how) (?:about|if)\b|^should (?!(?:you|i|we)\b)"
)
_LATER = re.compile(r"\b(?:going to|about to|plan(?:ning)? (?:to|on)|intend(?:ing)? to|gonna)\b")


def shape_of(
    plain: str, *, question_mark: bool, names: frozenset[str], me: frozenset[str] = frozenset()
) -> Shape:
    """Read the grammar of a normalised text.

    names: words that begin the name of a thing or a kind of things
    me:    what the robot that speaks is called
    """
    clause, framed = _unframed(plain, me)
    if ahead := _AHEAD.match(clause):
        clause = f"{ahead[2]} {ahead[1]}"
    clause = re.sub(r"^let us (?=say|suppose|assume|imagine)", "", clause)
    clause = _CLEFT.sub(r"\1 ", clause)
    telling = _REPORTING.match(clause)
    clause = _ASIDE.sub("", _REPORTING.sub("", clause))
    tag = _TAG.search(clause) if " " in clause else None
    asks = question_mark or framed
    polite = tag is not None and tag[1] in ("will", "would", "can", "could")
    if tag and not re.match(rf"(?:{'|'.join(AUXILIARIES)}|what|how|why|who|where)\b", clause):
        clause = clause[: tag.start()]
        asks = not polite
    wh = _question_word(clause)
    words = clause.split()
    condition = _CONDITION.search(clause) is not None and not wh.startswith("why")
    auxiliary, subject = _subject(words, is_wh=bool(wh))
    if telling and not wh:
        mood = Mood.TELLING
    elif wh or condition or (words and words[0] in AUXILIARIES and not _is_ban(words)):
        mood = Mood.ASKING
    elif _orders(words, names) and not (asks and not polite):
        mood = Mood.ORDERING
    elif asks:
        mood = Mood.ASKING
    else:
        mood = Mood.TELLING
    return Shape(
        mood,
        clause,
        wh,
        _noun(clause),
        auxiliary,
        _tense(clause),
        subject,
        re.search(r"\b(?:not|never|no longer|without|nobody|no one)\b", clause) is not None,
        condition,
    )


def _is_ban(words: list[str]) -> bool:
    """`do not go there`: begins like a question and is none."""
    return words[:2] == ["do", "not"] and words[2:3] not in (["you"], ["i"], ["we"], ["they"])


def _unframed(plain: str, me: frozenset[str]) -> tuple[str, bool]:
    """The clause without `hey`, `can you tell me`; and whether such words asked for an answer."""
    framed = False
    clause = plain
    for name in me:
        if not re.match(rf"{re.escape(name)} (?:is|has|was|will|can|does|did)\b", clause):
            clause = re.sub(
                rf"^(?:(?:hey|hi|ok|okay|please) )?{re.escape(name)} (?=\w)", "", clause
            )
    while True:
        shorter = clause
        if not _KEPT_OPENING.match(clause):
            shorter = _OPENING.sub("", clause)
        match = _FRAME.match(shorter)
        # "Say the box is full" supposes; "say what you did" asks.
        if match and not re.match(r"say (?!what|why|where|when|how|which|who)", shorter):
            shorter = shorter[match.end() :]
            framed = True
        if shorter == clause or not shorter:
            return clause, framed
        clause = shorter


def _question_word(clause: str) -> str:
    if _HINDERED.match(clause):
        return "why not"
    if _REASON.match(clause):
        return "why"
    if re.match(r"(?:what|which)\b.*\bfor$", clause) and not re.search(
        r"\b(?:wait|look|search|ask|call|aim|head|mak)(?:ing)? for$", clause
    ):
        return "why"
    if re.match(r"how (?:did|does|could|has|have|do) (?!you\b|i\b|it go)", clause) and re.search(
        r"\b(?:get|got|become|became|come|end|ended|turn|happen|gotten|break"
        r"|run (?:out|low|short))\b",
        clause,
    ):
        return "why"
    if re.match(
        r"(?:at|in|by|from|since|until|till|up to)? ?(?:what|which) (?:time|point|moment|"
        r"step|instant|hour|stage)\b(?! are you| is)",
        clause,
    ):
        return "when"
    found = _WH.match(clause)
    if found is None:
        inner = re.search(r"\b(why|what for)$", clause)
        return "why" if inner else ""
    if found[1] == "how come":
        return "why"
    if re.match(r"(?:since|until|till) (?:when|what|which)", clause):
        return "when"
    if found[1] in ("how often", "how frequently") or re.match(r"how many times\b", clause):
        return "how often"
    return found[1]


def _noun(clause: str) -> str:
    found = re.match(
        r"(?:\w+ )?(?:which|what|how many|how much)(?: of)?(?: the| my| your| all)? (\w+)", clause
    )
    if found is None or found[1] in AUXILIARIES | PRONOUNS:
        return ""
    return lemma(found[1])


def _subject(words: list[str], *, is_wh: bool) -> tuple[str, str]:
    """The first auxiliary, and the word that the clause is about."""
    for index, word in enumerate(words):
        if word in AUXILIARIES:
            after = words[index + 1 : index + 3]
            if after[:1] and after[0] in DETERMINERS - {"this", "that"}:
                after = after[1:]
            before = words[:index]
            inverted = index == 0 or (is_wh and not ({"you", "i", "we", "it"} & set(before)))
            if inverted:
                return word, after[0] if after else ""
            return word, before[-1]
    found = next((word for word in words if word in PRONOUNS), "")
    return "", found


def _tense(clause: str) -> Tense:
    # What hangs on the main clause has a tense of its own: "what do you do after you have paid".
    clause = re.sub(r"(?<=\w) (?:after|once|when|until|till|while|before)\b.*", "", clause)
    if re.search(r"\bwould(?! (?:like|you (?:like|mind)))|\bwere to\b", clause):
        return Tense.CONDITIONAL
    if re.search(r"\b(?:will|shall)\b", clause) or (
        _LATER.search(clause) and not re.search(r"\bw(?:as|ere)\b", clause)
    ):
        return Tense.FUTURE
    if re.search(r"\b(?:has|have)\b.*\bhad\b", clause):
        return Tense.PERFECT
    if re.search(r"\b(?:did|was|were|had)\b", clause):
        return Tense.PAST
    have = re.search(r"\b(?:has|have)\b(?! to\b)(.*)", clause)
    if have and any(map(_is_participle, have[1].replace(" got ", " ", 1).split())):
        return Tense.PERFECT
    return Tense.PRESENT


def _is_participle(word: str) -> bool:
    """Whether a word behind `have` makes it a perfect: "has it gone", not "has it a lid"."""
    return word in _PARTICIPLES or (word.endswith("ed") and len(word) > 3)


def _orders(words: list[str], names: frozenset[str]) -> bool:
    """Whether a clause begins with the bare form of a verb, which is an order."""
    rest = list(words)
    while rest and rest[0] in ("please", "kindly", "just", "now", "always", "never", "do", "not"):
        rest.pop(0)
    if not rest or rest[0] in _FUNCTION_WORDS or rest[0] in names:
        return False
    word = rest[0]
    if word.endswith(("ing", "ly", "ed")) and lemma(word) != word:
        return False
    return lemma(word) == word and not re.match(r"\d", word)
