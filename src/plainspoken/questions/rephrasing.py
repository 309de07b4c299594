"""A language model may say an answer in other words; what it may not do is add, drop or turn.

    found = rephrased(answer, moment, model)
    found.text   # the model's words if they pass, else the computed ones

Its text is read back: the fluents it states must be those of the computed words, and the words
that weigh must stand as they stood; it may add only words that state nothing. A text that fails
is sent back once with what is wrong with it; then the computed words stand. The question goes to
no model: nothing in it can change what is said.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from dataclasses import dataclass
from functools import lru_cache

from plainspoken.language.completion import LanguageModel, Message, Role
from plainspoken.questions.claim import Answer
from plainspoken.questions.concordance import concordance_of
from plainspoken.questions.fluents import Fluent, Reading, read
from plainspoken.questions.identity import ById
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import participle, past, progressive, third_person
from plainspoken.questions.spelling import normal

TRIES = 2
SCHEMA = {
    "type": "object",
    "properties": {"text": {"type": "string"}},
    "required": ["text"],
    "additionalProperties": False,
}
_TASK = (
    "Say the robot's answer below in a warmer and more natural way, in the first person. Keep "
    "every fact, every name, every number, every 'not', and their order. Add nothing, leave "
    'nothing out, address nothing else. Reply with JSON: {"text": "..."}.'
)
_STATING_NOTHING = frozenset(
    {"a", "an", "the", "and", "well", "ok", "okay", "really", "actually", "hello", "hi", "hey"}
    | {"friend", "please", "thanks", "happily", "gladly", "alright", "oh", "ah"}
)
"""Words that any text may use or leave out: they say of nothing that it is so."""


@dataclass(frozen=True, slots=True)
class Attempt:
    """A text of the model, and what is wrong with it; nothing where it may be said."""

    text: str
    faults: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Rephrased:
    """What is said, and how it came to be."""

    text: str
    attempts: tuple[Attempt, ...]

    @property
    def fell_back(self) -> bool:
        """Whether the computed words are said after all."""
        return not self.attempts or bool(self.attempts[-1].faults)


def rephrased(answer: Answer, moment: Moment, model: LanguageModel) -> Rephrased:
    """Ask a model to put an answer in other words, and check what it says.

    raises CompletionError: when the model gives no reply
    """
    attempts: list[Attempt] = []
    messages = [Message(Role.SYSTEM, _TASK), Message(Role.USER, answer.text)]
    for _ in range(TRIES):
        reply = model(messages, SCHEMA)
        attempt = Attempt(_text_of(reply), faults(_text_of(reply), answer.text, moment.lexicon))
        attempts.append(attempt)
        if not attempt.faults:
            return Rephrased(attempt.text, tuple(attempts))
        wrong = "; ".join(attempt.faults)
        messages += [Message(Role.MODEL, reply), Message(Role.USER, f"Not so: {wrong}. Again.")]
    return Rephrased(answer.text, tuple(attempts))


def faults(text: str, computed: str, lexicon: Lexicon) -> tuple[str, ...]:
    """What keeps a text from being said in place of the computed one."""
    if not text:
        return ("it is no text",)
    text, computed = (_with_first_verbs(each, lexicon) for each in (text, computed))
    meant = _read(computed, ById(lexicon))
    return (
        *_wrong_fluents(read(text, lexicon), meant),
        *_wrong_words(text, computed, lexicon),
    )


@lru_cache(maxsize=64)
def _read(text: str, lexicon: ById[Lexicon]) -> Reading:
    return read(text, lexicon.value)


def _wrong_fluents(said: Reading, meant: Reading) -> list[str]:
    """Facts that were added, and facts that were lost."""
    found = [f"it adds {_shown(each)}" for each in said.fluents if each not in meant.fluents]
    return found + [
        f"it drops {_shown(each)}" for each in meant.fluents if each not in said.fluents
    ]


def _shown(fluent: Fluent) -> str:
    offset = "" if fluent.offset is None else f"{fluent.offset:+d}"
    return f"{'' if fluent.holds else 'not '}({fluent.atom}), {fluent.time}{offset}"


def _wrong_words(text: str, computed: str, lexicon: Lexicon) -> list[str]:
    """Words that weigh and are not the computed ones in their order.

    Every word of a text may be known and the text be false: "line 1 is full", of "line 1 isn't
    cleared and the box is full", or two conditions with each other's consequences. So what weighs
    stands where it stood; a model has the rest to itself, and other words for the same things.
    """
    said, meant = _weighty(text, lexicon), _weighty(computed, lexicon)
    if said == meant:
        return []
    new = [f"it uses the word {word!r}" for word in dict.fromkeys(said) if word not in meant]
    gone = [f"it lacks the word {word!r}" for word in dict.fromkeys(meant) if word not in said]
    return [*new, *gone] or ["it puts the words together in another way"]


def _weighty(text: str, lexicon: Lexicon) -> list[str]:
    """The words that weigh, things as marks."""
    marked = concordance_of(lexicon).mark(normal(text))
    # Not their lemmas: a tense is a claim.
    return [word for word in _WORD.findall(marked) if word not in _STATING_NOTHING]


def _with_first_verbs(text: str, lexicon: Lexicon) -> str:
    """A text that says each action with the first of its verbs, `collect` for `gather`."""
    same = _verbs(ById(lexicon))
    return re.sub(r"[a-z]+", lambda m: same.get(m[0], m[0]), text)


_WORD = re.compile(r"<[^>]+>|[\w'-]+")


@lru_cache(maxsize=8)
def _verbs(lexicon: ById[Lexicon]) -> dict[str, str]:
    """Verbs that the landmarks give for one action and for no other, each as its first one."""
    phrases = {
        schema.name: [each.split()[0] for each in lexicon.value.action_phrases(schema.name) if each]
        for schema in lexicon.value.problem.domain.actions
    }
    uses = Counter(verb for verbs in phrases.values() for verb in set(verbs))
    return {
        form(verb): form(verbs[0])
        for verbs in phrases.values()
        for verb in verbs[1:]
        for form in (str, past, participle, progressive, third_person)
        if uses[verb] == 1 and uses[verbs[0]] == 1
    }


def _text_of(reply: str) -> str:
    """The text in a reply; nothing where the reply is not what was asked for."""
    try:
        document = json.loads(reply)
    except ValueError:
        return ""
    text = document.get("text") if isinstance(document, dict) else None
    return " ".join(text.split()) if isinstance(text, str) else ""
