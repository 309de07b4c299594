"""An answer in another language: its claims, told with that language's templates.

The question is asked in English; what is computed does not depend on the language, only the words.
"""

from __future__ import annotations

from collections.abc import Sequence

from plainspoken.automata.verdict import Verdict
from plainspoken.questions.claim import ActionClaim, Answer
from plainspoken.questions.foresight import Foresight
from plainspoken.questions.italian import TEMPLATES, ago, counted_actions, number_word, times
from plainspoken.questions.kind import Kind
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import sentence
from plainspoken.questions.reason import Reason, further_link, open_atoms, reason_for, reason_then
from plainspoken.questions.translated import Speaker, Words
from plainspoken.world.domain import GroundAction, GroundAtom


def retold(answer: Answer, moment: Moment, words: Words) -> str:
    """The answer in the language of a file of words."""
    return _Retelling(answer, moment, words).text()


class _Retelling:
    def __init__(self, answer: Answer, moment: Moment, words: Words) -> None:
        self._answer = answer
        self._moment = moment
        self._speaker = Speaker(words, moment.problem, moment.lexicon.me)
        self._known = frozenset(words.facts)
        self._sentences: list[str] = []

    def text(self) -> str:
        self._tell()
        if not self._sentences:
            self._say("unknown")
        return " ".join(map(sentence, self._sentences))

    def _say(self, template: str, **slots: str) -> None:
        self._sentences.append(TEMPLATES[template].format(**slots))

    # -- what was claimed ----------------------------------------------------------------------

    def _facts(self, *certainties: str) -> list[GroundAtom]:
        claims = self._answer.claims
        return [
            claim.fluent
            for claim in claims
            if claim.certainty in certainties and claim.fluent.split()[0] in self._known
        ]

    @property
    def _denied(self) -> list[GroundAtom]:
        return [c.fluent for c in self._answer.denied if c.fluent.split()[0] in self._known]

    def _acts(self, *certainties: str) -> list[ActionClaim]:
        return [claim for claim in self._answer.actions if claim.certainty in certainties]

    def _deeds(self, claims: Sequence[ActionClaim], form: str, conjunction: str = "e") -> str:
        return self._speaker.deeds([claim.action for claim in claims], form, conjunction)

    def _standing(self) -> str:
        """What is so and what is not, now."""
        so = self._speaker.facts(self._facts("is"))
        not_so = self._speaker.facts(self._denied, negative=True)
        return " e ".join(filter(None, (so, not_so)))

    # -- kind by kind --------------------------------------------------------------------------

    def _tell(self) -> None:
        match self._answer.kind:
            case Kind.REPORT | Kind.COMMAND | Kind.CHITCHAT:
                self._say("only_answers")
            case Kind.NOW:
                self._tell_now()
            case Kind.PAST | Kind.COUNT_HISTORY:
                self._tell_past()
            case Kind.FUTURE:
                self._tell_future()
            case Kind.WHY_ACTION:
                self._tell_why()
            case Kind.WHY_NOT:
                self._tell_why_not()
            case Kind.WHY_HAPPENED:
                self._tell_cause()
            case Kind.WHEN:
                self._tell_when()
            case Kind.STATE:
                if facts := self._standing():
                    self._say("facts", facts=facts)
            case Kind.PROGRESS:
                self._tell_progress()
            case Kind.CONSTRAINT:
                lost = any(d.verdict is Verdict.VIOLATED for d in self._moment.demands)
                self._say("broken" if lost else "kept")
            case Kind.WHAT_IF:
                self._tell_what_if()

    def _tell_now(self) -> None:
        moment = self._moment
        if moment.ended is not None:
            self._say("finished" if moment.ended.satisfied else "ended")
        elif moment.started is not None:
            self._say_reason(reason_for(moment), moment.started.action, "doing")
        elif moment.paused:
            self._say("paused")
        elif moment.chosen is None:
            self._say("planning")
        else:
            if done := self._acts("was"):
                self._say("just_did", did=self._deeds(done[-1:], "did"))
            if ahead := self._acts("will"):
                self._say("about_to", shall=self._deeds(ahead[:1], "shall"))
        if facts := self._standing():
            self._say("facts", facts=facts)

    def _tell_past(self) -> None:
        done = self._acts("was")
        if not done:
            self._say("not_done" if self._moment.happenings else "done_nothing")
        elif self._answer.kind is Kind.COUNT_HISTORY:
            self._say("done_so_far", did=self._deeds(done, "did"))
            self._say("times_done", number=times(len(done)))
        else:
            self._say("done_so_far", did=self._deeds(done, "did"))
        if self._answer.rest:
            self._say("rest_so_far")

    def _tell_future(self) -> None:
        moment = self._moment
        if moment.ended is not None:
            self._say("nothing_ahead")
            return
        sure, may = self._acts("will"), self._acts("may")
        if moment.started is not None:
            self._say("doing", doing=self._speaker.deeds([moment.started.action], "doing"))
            sure = [each for each in sure if each.at > moment.now + 1]
        if sure:
            first = "next" if moment.started is not None else "first"
            self._say(first, shall=self._deeds(sure, "shall"))
        chance = [each for each in may if each.at > moment.now + 1]
        if chance:
            self._say("perhaps", shall=self._deeds(chance, "shall", "o"))
        if self._answer.rest:
            self._say("rest_ahead")
        elif staying := self._staying():
            self._say("facts", facts=self._speaker.facts(staying, "stays"))
        if not self._sentences:
            self._say("not_planned")

    def _staying(self) -> list[GroundAtom]:
        """What is claimed now and stays so in every execution."""
        moment = self._moment
        if moment.node is None or moment.policy is None:
            return []
        kept = Foresight(moment.policy, moment.node, moment.now).kept
        return sorted(set(self._facts("is")) & set(self._facts("will")) & kept)

    def _tell_why(self) -> None:
        moment = self._moment
        if done := self._acts("was"):
            each = next(h for h in reversed(moment.happenings) if h.action == done[-1].action)
            reason = None
            if each.node is not None:
                reason = reason_then(moment, each.node, each.policy, each.at - 1)
            self._say_reason(reason, each.action, "did")
        elif moment.started is not None:
            self._say_reason(reason_for(moment), moment.started.action, "doing")
        elif ahead := self._acts("will", "may"):
            self._say_reason(reason_for(moment), ahead[0].action, "shall")

    def _say_reason(self, reason: Reason | None, action: GroundAction, form: str) -> None:
        """The action, what it is for, and the part of the request behind it."""
        said = self._speaker.deeds([action], form)
        goal = further_link(reason) if reason is not None and reason.links else None
        if goal is not None:
            template = {"doing": "doing_for", "did": "did_for", "shall": "next_for"}[form]
            purpose = self._speaker.deeds([goal.action], "do")
            said = TEMPLATES[template].format(goal=purpose, **{form: said})
        part = reason.part if reason is not None else None
        if self._answer.kind is Kind.NOW or part is None:
            self._say("facts", facts=said)
            return
        wanted = [a for a in open_atoms((part,), self._moment) if a.split()[0] in self._known]
        if wanted:
            self._say("because_facts", reason=said, facts=self._speaker.facts(wanted, "that"))
        else:
            self._say("because_asked", reason=said)

    def _tell_why_not(self) -> None:
        moment = self._moment
        if done := self._acts("was"):
            self._say(
                "did_when", did=self._deeds(done[-1:], "did"), ago=ago(moment.now - done[-1].at)
            )
        elif facts := self._standing():
            self._say("obstacle", facts=facts)
        elif moment.started is not None:
            self._say("not_now", doing=self._speaker.deeds([moment.started.action], "doing"))

    def _tell_cause(self) -> None:
        facts, done = self._standing(), self._acts("was")
        if done and facts:
            when = ago(self._moment.now - done[-1].at)
            self._say("came_of", did=self._deeds(done[-1:], "did"), ago=when)
        elif facts:
            self._say("from_start" if self._facts("is") else "facts", facts=facts)

    def _tell_when(self) -> None:
        now = self._moment.now
        if done := self._acts("was"):
            self._say("did_when", did=self._deeds(done[-1:], "did"), ago=ago(now - done[-1].at))
        elif ahead := self._acts("will", "may"):
            number = counted_actions(ahead[0].at - now)
            self._say("shall_when", shall=self._deeds(ahead[:1], "shall"), number=number)
        elif facts := self._standing():
            self._say("facts", facts=facts)

    def _tell_progress(self) -> None:
        moment = self._moment
        if moment.ended is not None:
            self._say("finished" if moment.ended.satisfied else "ended")
        if reached := self._facts("is"):
            self._say("reached", facts=self._speaker.facts(reached))
        if missing := self._denied:
            self._say("missing", facts=self._speaker.facts(missing, negative=True))
        if moment.node is not None and moment.policy is not None and moment.ended is None:
            left = Foresight(moment.policy, moment.node, moment.now).remaining
            least = number_word(left.least)
            if left.most is None:
                self._say("left_at_least", least=least)
            elif left.most == left.least == 1:
                self._say("left_one")
            elif left.most == left.least:
                self._say("left_exactly", least=least)
            else:
                self._say("left_between", least=least, most=number_word(left.most))

    def _tell_what_if(self) -> None:
        moment = self._moment
        ahead = [each for each in self._acts("may", "will") if each.at > moment.now]
        possible = [c for c in self._answer.claims if c.certainty == "may"]
        if facts := self._standing():
            self._say("so_already", facts=facts)
        elif possible:
            self._say("may_be", number=counted_actions(possible[0].start - moment.now))
        elif not ahead:
            self._say("cannot_be")
        if ahead:
            perhaps = "perhaps" if len(ahead) > 1 else "next"
            self._say(perhaps, shall=self._deeds(ahead, "shall", "o"))
