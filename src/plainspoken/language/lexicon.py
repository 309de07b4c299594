"""The general words of English that shape a mission: what moves, forbids, orders, times, counts.

No word of any domain stands here. An entry is one or more words; `~` before a word means any
inflection of it, and longer entries win over shorter ones.
"""

from __future__ import annotations

from enum import StrEnum, auto

from plainspoken.language.word import Word


class Kind(StrEnum):
    """What a word or phrase does in a sentence."""

    GO = auto()  # be at a place at some instant
    STAY = auto()  # be there for a while
    LEAVE = auto()
    AVOID = auto()
    PATROL = auto()  # come back again and again
    CEASE = auto()  # stop doing what follows
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
    NOW = auto()
    ALREADY = auto()  # of a situation: it may be over by now
    ALWAYS = auto()
    NO_OTHER = auto()  # "and at no other time"
    AGAIN_AND_AGAIN = auto()
    COUNT = auto()
    ONLY = auto()
    AGAIN = auto()
    IT_HAPPENS = auto()  # "it is", "that happens": what was last spoken of
    RELATIVE = auto()
    FILLER = auto()
    REFERENCE = auto()
    UNKNOWN = auto()


_ENTRIES: dict[Kind, str] = {
    Kind.GO: """
        ~hit; ~check on; ~visit; ~go; ~reach; ~move; ~head; ~navigate; ~drive; ~travel; ~get to;
        ~proceed; ~enter;
        ~come; ~stop by; ~stop at; ~stop off; ~pass through; ~pass by; ~pass; ~drop by; ~drop in;
        ~swing by; ~walk; ~run to; ~run over; ~arrive; ~return; ~revisit; ~continue; ~advance;
        ~approach; ~access; ~step; ~set foot; ~make your way; ~make its way; ~journey; ~fly;
        ~roll; ~show up; ~find; ~see; ~observe; ~tour; ~explore; ~call at; ~attend; ~find your
        way; ~pay a visit; ~check out; ~land; ~cross; ~be at; ~be in; ~be on; ~be inside; ~go
        back; ~come back; ~have been; gone; went; visit; visits; passes; observation; ~route;
        ~trip; ~traverse; ~look in; ~make a stop; ~make it; ~go through; ~find yourself; ~pop
        into; ~pop over; ~stop; ~get into; ~get back; ~end up; ~pop by; ~swing; ~take a trip;
        ~lead
    """,
    Kind.STAY: """
        ~stay; ~remain; ~wait; ~linger; ~keep going on; ~dwell; ~stand by; ~stay put; ~hang
        around; ~hold position; ~keep; ~sit tight; ~rest; ~maintain; ~hold
    """,
    Kind.LEAVE: """
        ~leave; ~exit; ~depart; ~depart from; ~go away; ~move away; ~get out; ~go out
    """,
    Kind.AVOID: """
        ~avoid; ~bypass; ~skip; ~stay away; ~keep away; ~steer clear; ~stay out; ~keep out; ~stay
        clear; ~keep clear; ~stay off; ~keep off; ~refrain from; ~refrain; ~evade; ~abstain from;
        ~shun; ~omit; ~keep your distance; ~keep from; ~stop short; anywhere but; anywhere except;
        anywhere except for; everywhere but; everywhere except; everywhere except for; anywhere
        other than; ~forgo; ~prevent; ~stay well away; ~give a wide berth to; ~exclude; ~leave
        out; ~hold off; ~hold back; ~escape; ~forget
    """,
    Kind.PATROL: """
        ~patrol; keep visiting; keep going; keep going to; keep returning to; keep coming back;
        never stop visiting; never stop going; do not stop visiting; do not stop going; not stop
        visiting; not stop going; ~circle; continue visiting; continue going; continuously visit;
        ~surveil; ~monitor; keep moving; keep on visiting; continue to visit; continue to go; keep
        on going to; keep on going; keep going back; keep patrolling; prohibited from not
        infinitely; do not ever stop visiting; do not ever stop going; not ever stop visiting
    """,
    Kind.OCCUR: """
        ~happen; ~occur; ~hold true; holds; held; ~take place; ~come true; is true; are true; be
        true; being true; ~become true; ~be the case; ~be done; ~be over; ~be finished; holding
        true; done; finished; complete; completed; over; happening
    """,
    Kind.BE: """
        is; are; am; be; been; being; was; were; gets; get; got; getting; become; becomes;
        becoming; turn; turns; has been; have been; 's
    """,
    Kind.ENSURE: """
        make sure; make sure that; make certain; be sure; be certain; ensure; ensure that;
        ensuring; ensuring that; see to it; see to it that; guarantee; please; kindly; you are
        asked to; your task is to; your mission is to; your job is to; the task is to; the mission
        is to; the goal is to; i want you to; i want; i need you to; i need; i would like you to;
        i would like; we need; we need to; we want you to; it is required that; it is necessary
        that; try to; try; remember to; let; the robot is to; making sure; see that; take care to;
        take care that; it is important that; go ahead and; i wish; your goal is to; the objective
        is to; your objective is to; your task is; the aim is to; bear in mind; mind; have the
        robot; get the robot to; help; guaranteeing; the rule is; the rule is that; as a rule; go
        and; come and
    """,
    Kind.MUST: """
        must; have to; has to; had to; having to; should; shall; need to; needs to; ought to; is
        to; are to; are required to; is required to; is supposed to; are supposed to; will; are
        obliged to; are expected to; will have to; will need to; is mandatory; gotta; got to; had
        better; it is mandatory to; it is compulsory to; are obligated to; be required to;
        requires; require; want to; wants to; may have to
    """,
    Kind.MAY: """
        can; could; may; might; are allowed to; is allowed to; are permitted to; is permitted to;
        allowed to; allowed; permitted to; permitted; are free to; is free to; be allowed to; be
        permitted to; would; are allowed; is allowed; it is fine to; feel free to; are permitted;
        is permitted; it is ok to; it is okay to; are able to; is able to
    """,
    Kind.NOT: """
        not; no; neither; nor; none of; none; nothing; nobody; no one; nowhere; prohibited from;
        are prohibited from; is prohibited from; forbidden to; forbidden from; are forbidden to;
        is forbidden to; are forbidden from; banned from; not even; under no circumstances; it is
        not so that; it is not the case that; it is not true that; on no account; in no case; by
        no means; instead of; rather than; a no go; it is forbidden to; it is prohibited to; no
        longer
    """,
    Kind.NEVER: """
        never; not ever; never ever; at no time; at no point; at no moment; not at
        any time; no time
    """,
    Kind.FORBIDDEN: """
        off limits; is off limits; are off limits; out of bounds; is out of bounds; prohibited; is
        prohibited; are prohibited; forbidden; is forbidden; are forbidden; must be avoided;
        should be avoided; is to be avoided; are to be avoided; has to be avoided; have to be
        avoided; is not allowed; are not allowed; is not permitted; are not permitted; must always
        be avoided; should always be avoided; should be avoided at all costs; is taboo; is banned;
        are banned; banned; need to be avoided; needs to be avoided
    """,
    Kind.SUBJECT: """
        you; we; i; the robot; robot; robots; the robots; he; she; they; it; your robot; yourself;
        itself; one; somebody; someone; anyone; the machine; them; us; me
    """,
    Kind.WHEN: """
        when; if; in case; in the event that; in the event of; provided; provided that; where;
        given that; should it happen that; assuming; assuming that; on condition that; in case of;
        if ever; any time that if; at any point in time if; at any time if; supposing; in a
        situation where; once it is the case that; now that; since; because
    """,
    Kind.WHENEVER: """
        whenever; every time; every time that; each time; each time that; any time; anytime; any
        time that; each and every time; at any time when; always when; always after; always if; at
        every step where; at every step at which; at each instant where; at every instant where;
        at every instant at which
    """,
    Kind.AFTER: """
        after; once; following; having; subsequent to; after having; after that when; upon; later
        than; as a consequence of; in response to; from the moment; from when; starting from;
        since the moment; from then on after; from the time; ever after; only afterwards when
    """,
    Kind.PROMPTLY: """
        as soon as; immediately after; right after; directly after; straight after; just after;
        the moment; the moment that; the instant; the instant that; immediately when; immediately
        once; immediately upon; the very moment; directly when; right when; immediately following;
        promptly after; right upon; the second; the minute; just when; at the exact moment;
        instantly after; the very instant; at the moment when; immediately whenever; as soon as
        ever; shortly after; at the moment; right as; right once; the step after; in the step
        after; at the step after; immediately if
    """,
    Kind.BEFORE: """
        before; prior to; ahead of; before any; earlier than; in advance of; any earlier than;
        before ever; until after; till after; sooner than
    """,
    Kind.RIGHT_BEFORE: """
        right before; immediately before; just before; directly before; straight before;
        immediately prior to; the step before; in the step before
    """,
    Kind.UNTIL: """
        until; till; til; up until; up to when; until such time as; until the moment; until such
        time that; up to the point where; up to the moment; as long as not; unless and until;
        until when; so long as not
    """,
    Kind.UNLESS: "unless; except if; except when; except while; except after; save when",
    Kind.WHILE: """
        while; whilst; as long as; so long as; during; at times when; all the while; throughout;
        for as long as; meanwhile; at the times when; in the meantime; as you; while you; the
        whole time; for the time that; at every moment at which; at any step where
    """,
    Kind.WITHOUT: "without; without first; without ever",
    Kind.ONLY_IF: """
        only if; only when; only while; only in case; only as long as; only during; only in; only
        at; only on; only so long as; only where; only provided that; solely if; solely when; just
        if; exclusively when; only with; only from; only whenever; exclusively if; exclusively
        while
    """,
    Kind.ONLY_AFTER: """
        only after; only once; not until; not before; only from the moment; only following; never
        before; only upon; no sooner than; never until; only having; solely after; not unless; no
        earlier than; not till; exclusively after
    """,
    Kind.ONLY_RIGHT_AFTER: """
        only right after; only immediately after; only directly after; only just after; only
        straight after; only as soon as; only the moment; only in the step after; only at the step
        after
    """,
    Kind.IFF: """
        if and only if; exactly when; exactly if; precisely when; precisely if; just in case; when
        and only when; iff; if but only if; whenever and only when; always and only when; exactly
        while; whenever and only whenever; as long as and only as long as
    """,
    Kind.AND: """
        and; as well as; along with; plus; &; and also; also; both; in addition; moreover;
        furthermore; additionally; besides; together with; in addition to; too; on top of that; /
    """,
    Kind.OR: """
        or; either; or else; at least one of; any one of; one of; alternatively; or any of
    """,
    Kind.BUT: """
        but; however; yet; though; although; except that; with the proviso that; whereas; only
        that; on the other hand
    """,
    Kind.THEN: """
        then; and then; next; finally; lastly; followed by; and finally; subsequently; after
        which; last; secondly; thirdly; and next; and subsequently; in turn; ->; and lastly; later
        on; then later
    """,
    Kind.ONLY_THEN: """
        only then; and only then; only after that; only afterwards; and only after that; then and
        only then; only then may you; not before then
    """,
    Kind.NTH: "second; third; fourth; fifth; sixth; seventh",
    Kind.FIRST: """
        first; firstly; first of all; to begin with; start by; start with; begin by; begin with;
        start; begin; to start with; initially; first off; first thing; starting with; beginning
        with
    """,
    Kind.BEFORE_THAT: """
        before that; beforehand; but before that; first though; before this; before then; prior to
        that; prior to this; earlier
    """,
    Kind.AFTER_THAT: """
        after that; after this; from then on; from that point on; from that moment on; from there
        on; from there; after it; afterwards; afterward; after then; from that moment; thereafter;
        any longer; ever since; following that; following this; once done; when done; once
        finished; when finished; after doing so; having done so; once that is done; once this is
        done; when that is done; after doing that; once there; when you are done; once you are
        done; after they are; from then onwards; since then
    """,
    Kind.RIGHT_AFTER_THAT: """
        right after that; immediately after that; right after; right next; right afterwards;
        immediately afterward; immediately afterwards; straight after; directly after; just after;
        right after this; directly after that; directly afterwards; immediately thereafter;
        straight afterwards; immediately after; just after that; straight after that; as the next
        step; immediately after this; right after it; immediately after it; just afterwards;
        directly thereafter; right afterward
    """,
    Kind.RIGHT_BEFORE_THAT: """
        right before; right before that; immediately before; just before; immediately before that;
        immediately beforehand; just before that; right beforehand; directly before; directly
        before that; directly beforehand; just beforehand; immediately prior; straight before;
        right before it; in the step before; at the step before; immediately before it; in the
        previous step; one step earlier
    """,
    Kind.ANY_ORDER: """
        in any order; in no particular order; in no specific order; in any sequence; in whatever
        order; order does not matter; the order does not matter; the order is not important; order
        is not important; the order is irrelevant; whichever comes first; in any order you like;
        regardless of order; in an arbitrary order; whatever the order; in whichever order; in any
        order you want; in no order; no matter the order
    """,
    Kind.SEQUENCE: """
        one after another; one after the other; in sequence; in a sequence; in some sequence; each
        must be followed by the next; successively; in succession; consecutively; sequentially;
        one by one; in a row
    """,
    Kind.IN_ORDER: """
        in this order; in that order; in order; in exactly that order; in the given order; in
        exactly this order; in that specific order; in this specific order; in the following
        order; in the order given; in that exact order; in this exact order; in the order listed;
        in the specified order; without skipping any one of them; without skipping any; without
        skipping; strictly in order; in strict order; in the order; in precisely that order; in
        precisely this order; in that very order; in this sequence; in that sequence; respecting
        that order; keeping to that order
    """,
    Kind.NO_RETURN: """
        without revisiting previously visited location; without revisiting; without going back;
        without returning; without ever going back; once each; each location once; each place
        once; never return; never going back; without revisiting any; exactly once each; only once
        each; visit each location once; visit each of them once; each exactly once; each only
        once; and never go back; never revisit any of them; without going back to any of them;
        without coming back; without visiting any of them twice; without visiting any twice; each
        of them once; without revisiting any of them; without repeating any; without returning to
        any of them
    """,
    Kind.NEXT: """
        immediately; right away; straight away; at once; directly; instantly; promptly; without
        delay; right then; straightaway; forthwith; straight; right; next thing; without
        hesitation; asap; without any delay; as soon as possible; as quickly as possible; quickly;
        do not dawdle; on the spot; next up; very next
    """,
    Kind.NEXT_INSTANT: """
        in the next step; at the next step; at the next time step; in the very next step; at the
        very next step; at the very next time instant; at the next instant; at the very next
        instant; in the next instant; in the next time step; one step later; in the following
        step; at the following instant; the next time step; the next step; at the very next time
        step; at the next moment; in the next moment; one instant later; at the next time instant;
        in the following instant; in the step right after
    """,
    Kind.LATER: """
        eventually; later; in the future; at some point; at some later point; sooner or later; at
        some stage; in the end; at some time; ultimately; some time; sometime; at the end; in due
        course; at least once in the future; at least once after; at one point; at some point
        later; at some point after; some day; at a later time; at least once later; at some point
        in the future; at some later time; at least once afterwards; at a later point; some time
        later; in time; at some later instant; whenever suits
    """,
    Kind.NOW: """
        at the same time; simultaneously; at the same moment; at the same instant; in the same
        instant; at that very moment; in the same step; at that instant; at that moment; at the
        same step; concurrently; in that very instant; there and then; at that very instant
    """,
    Kind.ALWAYS: """
        always; at all times; all the time; at every moment; at all costs; at any time; ever; in
        any case; permanently; at any point; at every point; at any moment; at every instant;
        continuously; at any point in time; for the whole mission; throughout the mission; the
        entire time; the whole time; for good; at all; from start to finish; at every step; at
        each step; in all cases; for all time instances starting from the next one; in every
        situation; during the mission; at any instant; until the end; every single time; to the
        end
    """,
    Kind.NO_OTHER: """
        at no other time; any other time; at any other time; nowhere else; no other time; no other
        place; nothing else; never otherwise; and not otherwise; not otherwise; anywhere else;
        anything else; at no other step; at no other moment; at no other instant; otherwise never;
        and only then; except then; except right then; only at that time; nowhere else except; in
        no other case; on no other occasion; in no other step; at no other point; under no other
        circumstances; only at that moment; in no other order
    """,
    Kind.AGAIN_AND_AGAIN: """
        forever; for ever; indefinitely; continually; infinite times; without ever stopping;
        without end; at least once after at any point; infinitely; infinitely often; repeatedly;
        again and again; over and over; over and over again; an infinite number of times;
        infinitely many times; constantly; forever and ever; perpetually; endlessly; time and
        again; regularly; on repeat; ad infinitum; in a loop; in an endless loop; without
        stopping; round and round; forevermore; all over again; time after time
    """,
    Kind.ALREADY: "already; previously; ever before",
    Kind.ONLY: "only; solely; exclusively",
    Kind.AGAIN: """
        again; any more; anymore; a second time; ever again; once more; another time; one more
        time
    """,
    Kind.IT_HAPPENS: """
        it is; it does; it happens; that is; that happens; this happens; it occurs; that occurs;
        it has; that is the case; this is the case; they are; it becomes so; it is so; this is so;
        that is so; it gets so; so; it has happened; that has happened; this occurs
    """,
    Kind.RELATIVE: "that; which; who; whose; what; how; why; whether; then to",
    Kind.FILLER: """
        make; bring; put; get; do; does; did; the; a; an; to; at; in; into; on; onto; from; of; off;
        by; for; with;
        towards; toward; through; inside; near; up; down; over; back; around; just; simply; also;
        really; some; any; all; every; each; this; these; those; there; here; your; its; their;
        his; her; my; our; have; has; had; ok; okay; well; so; as; than; hey; hi; hello; thanks;
        thank; very; quite; even; still; now; today; please; location; locations; place; places;
        area; areas; spot; position; positions; stop; stops; stopping; point; following; list;
        like; want; wants; wish; time; times; moment; instant; step; steps; about; need; needs;
        bit; little; kind; such; same; else; other; others; both; them; everything; go ahead; to
        be; along the way; along; way; previous; path; own; specific; given; particular; order;
        able; possible; certain; sure; at least; at most; while; would you; could you; can you;
        will you; mission; task; tasks; job; goal; the following; mr; hmm; um; uh; er; well then;
        right now; good; great; gladly; soon; whole; entire; alone; being; do so; doing so; doing;
        done so; if possible; if you can; if you would; if you please; would you please; if you do
        not mind; robot; of course; careful; be careful; carefully; quickly; state; true; false;
        ahead; exactly; precisely; strictly; either; whatever; whichever; somewhere; anywhere;
        everywhere; together; yes; first; out; away; one; step by step; trip; visit; visits;
        occasion; occasions; instance; instances; ones; set; directly; i; me; us; rest; too; as
        many times as you want; as often as you want; as many times as you like; as often as you
        like; any number of times; let's; 's; let us; happen; take; keep in mind; remember; note;
        note that; situation; case; cases
    """,
}  # fmt: skip


def is_general(word: Word) -> bool:
    """Whether a word by itself stands in the lexicon."""
    return any(
        pattern in ((word.text,), ("~" + stem,))
        for stem in word.stems | {word.text}
        for pattern, _ in PHRASES.get(stem, ())
    )


MARKS = dict.fromkeys(",:()[]–—-", Kind.COMMA) | dict.fromkeys(".;!?…", Kind.STOP)
"""What punctuation does; any other mark is passed over."""


def _compiled() -> dict[str, list[tuple[tuple[str, ...], Kind]]]:
    table: dict[str, list[tuple[tuple[str, ...], Kind]]] = {}
    taken: set[tuple[str, ...]] = set()
    for kind, text in _ENTRIES.items():
        for part in text.split(";"):
            pattern = tuple(part.split())
            if pattern and pattern not in taken:
                taken.add(pattern)
                table.setdefault(pattern[0].lstrip("~"), []).append((pattern, kind))
    for candidates in table.values():
        candidates.sort(key=lambda entry: (-len(entry[0]), entry[0][0].startswith("~")))
    return table


PHRASES = _compiled()
"""Entries by their first word, longest first; of one pattern, the first kind listed counts, and
of two as long the one that gives the word itself and not any inflection."""
