"""Phrases that say what is done, forbidden, allowed, and on what condition.

No word of any domain stands here. An entry is one or more words; `~` before a word means any
inflection of it, and longer entries win over shorter ones.
"""

from __future__ import annotations

from plainspoken.language.kind import Kind

PHRASES_OF_DOING: dict[Kind, str] = {
    Kind.GO: """
        business; business in; business on; business at;
        ~wind up; ~wind up at; ~wind up in; ~go on; ~go on to; ~carry on; ~press on; ~push on;
        ~head on; ~round off at; ~round off in; ~conclude at; ~conclude in; ~start out;
        ~start out at; ~start off; ~start off at; ~set out; ~wander; ~roam; ~tick; ~tick off;
        ~work your way; ~work your way along;
        ~work your way through; ~work your way round;
        ~hit; ~check on; ~visit; ~go; ~reach; ~move; ~head; ~navigate; ~drive; ~travel;
        ~get to; ~proceed; ~enter; ~come; ~stop by; ~stop at; ~stop off; ~pass through;
        ~pass by; ~pass; ~drop by; ~drop in; ~swing by; ~walk; ~run to; ~run over;
        ~arrive; ~return; ~revisit; ~continue; ~advance; ~approach; ~access; ~step; ~set
        foot; ~make your way; ~make its way; ~journey; ~fly; ~roll; ~show up; ~find; ~see;
        ~observe; ~tour; ~explore; ~call at; ~attend; ~find your way; ~pay a visit; ~check
        out; ~land; ~cross; ~be at; ~be within; ~transition; ~be in; ~be on; ~be inside; ~go back;
        ~come back;
        ~have been; haven been; gone; went; visit; visits; passes; observation; ~route; ~trip;
        ~traverse; ~look in; ~make a stop; ~make it; ~go through; ~find yourself; ~pop
        into; ~pop over; ~stop; ~get into; ~get back; ~end up; ~pop by; ~swing; ~take a
        trip; ~lead; ~call in; ~call in at; ~call by; ~call on; ~drop in on; ~look in at;
        ~look in on; ~swing past; ~swing over; ~turn up; ~get yourself to; ~pay; ~touch;
        ~touch on; ~touch down; ~take in; ~put in an appearance; ~make an appearance;
        ~make for; ~make a detour; ~go out to; ~go over; ~get over to; ~move on; ~move
        over; ~carry on to; ~cover; ~look at; ~have a look in; ~have a look at; ~check in
        at; ~check in with; ~nip; ~nip over; ~pop; ~pop in; ~pop round; ~hop over; ~be
        through; ~be along; ~be present; ~be present at; ~be found; ~be situated; ~set out
        for; ~set off for; ~make tracks for; ~come by; ~come round; ~come round to; ~bring
        yourself to; ~take yourself to; ~be off to; off to; ~end; ~end at; ~finish at;
        ~finish in; ~finish up; ~run past; ~run by; ~go past; ~get there; ~reenter; ~see
        to
    """,
    Kind.STAY: """
        ~stay; ~remain; ~stay within; ~remain within; ~keep within; ~wait; ~linger; ~keep going
        on; ~dwell; ~stand by; ~stay put;
        ~hang around; ~hold position; ~keep; ~sit tight; ~rest; ~maintain; ~hold; ~hang
        on; ~hang about; ~stick around; ~stick to; ~stick with; ~stick at; ~wait around;
        ~stand still; ~hold still; ~hold your ground; ~stand guard; ~keep to; ~park;
        ~camp; ~abide
    """,
    Kind.LEAVE: """
        ~leave; ~exit; ~depart; ~depart from; ~go away; ~move away; ~go out of; ~get out
        of; ~move out of; ~move from; ~stir from; ~budge; ~budge from; ~stray from;
        ~wander off; ~walk away; ~walk out of; ~back away; ~drive off; ~drive away; ~drive
        away from; ~be away; ~be away from; ~pull out of; ~vacate; ~quit; ~clear out of;
        ~part from
    """,
    Kind.AVOID: """
        ~avoid; ~bypass; ~skip; ~stay away; ~keep away; ~steer clear; ~stay out; ~keep way; ~keep
        out; ~stay clear; ~keep clear; ~stay off; ~keep off; ~refrain from; ~refrain;
        ~evade; ~abstain from; ~shun; ~omit; ~keep your distance; ~keep from; ~stop short;
        ~forgo; ~prevent; ~stay well away; ~give a wide berth to; ~exclude; ~leave out;
        ~hold off; ~hold back; ~escape; ~keep outside; ~stay outside; ~remain outside;
        ~remain out of; ~remain away; ~keep well away; ~keep well clear; ~do without;
        ~dodge; ~hold back from; ~desist from; ~hold off from; ~abstain; ~be careful not
        to; ~beware of; ~give up; ~shy away from; ~turn away from; ~rule out; ~pass up;
        ~pass over; ~hold off on; ~delay; ~postpone; ~put off; ~defer; ~wait with; ~hold
        it back; ~hold that back; ~put it off; ~put that off; ~hold back on; ~save; ~stave
        off; ~hold fire on; ~resist; ~spare; ~abandon; ~renounce; ~decline; hands off;
        nothing but; anything but
    """,
    Kind.PATROL: """
        ~patrol; endless patrol; endless patrol of; endless patrol that; keep visiting; keep
        going; keep going to; keep returning to; keep coming
        back; never stop visiting; never stop going; do not stop visiting; do not stop
        going; not stop visiting; not stop going; ~circle; continue visiting; continue
        going; continuously visit; ~surveil; ~monitor; keep moving; keep on visiting;
        continue to visit; continue to go; keep on going to; keep on going; keep going
        back; keep patrolling; do not ever stop visiting; do not ever stop going; not ever
        stop visiting; ~do the rounds; ~do the rounds of; ~make the rounds of; ~go the
        rounds of; ~circulate; ~keep coming back to; keep on returning; keep on coming
        back; always come back to; always return to; always go back to; keep on
        patrolling; ~keep checking on; ~keep a watch on; ~go round and round; ~cycle;
        ~cycle through; ~loop; ~loop through; ~shuttle; ~shuttle between
    """,
    Kind.BARS: """
        locks; locks up; closes; closes off; blocks; blocks off; bars; seals off; rules out;
        precludes; prohibits; forbids; prevents you from; puts an end to; shuts; shuts off;
        means the end of; locks you out of; keeps you out of; bars you from; excludes
    """,
    Kind.RELEASES: "releases; frees; liberates; discharges",
    Kind.LEADS: """
        ~lead to; ~imply; ~imply that; ~entail; ~entail that; ~trigger; ~result in; ~bring
        about; ~necessitate; ~have as a consequence; ~have as a consequence that; has to
        be followed by; must be followed by; is to be followed by; needs to be followed
        by; is followed by; are followed by; should be followed by; shall be followed by;
        has to lead to; must always be followed by; always be followed by; be followed; is
        followed; are followed; ~call for; has to be followed; be answered by; be answered with; is
        answered by; means; means that; meaning that
    """,
    Kind.PRECEDED: """
        must be preceded by; has to be preceded by; be preceded by; is preceded by; are
        preceded by; is to be preceded by; needs to be preceded by; presupposes; requires
        first; ~presuppose; has to come after; must come after; be preceded; ~follow on
        from
    """,
    Kind.OCCUR: """
        ~happen; ~occur; ~hold true; holds; held; ~take place; ~come true; is true; are
        true; be true; being true; ~become true; ~be the case; ~be done; ~be over; ~be
        finished; holding true; done; finished; complete; completed; over; happening
    """,
    Kind.BE: """
        is; are; am; be; been; being; was; were; gets; get; got; getting; become; becomes;
        becoming; turn; turns; has been; have been; 's
    """,
    Kind.ENSURE: """
        make it a rule; make it a rule to; it would be nice to; it would be nice to have; it would
        be good to; it would be good to have; it would be great to; it would be great to have;
        make sure; make sure that; make certain; be sure; be certain; ensure; ensure that;
        ensuring; ensuring that; see to it; see to it that; guarantee; please; kindly; you
        are asked to; your task is to; your mission is to; your job is to; the task is to;
        the mission is to; the goal is to; i want you to; i want; i need you to; i need; i
        would like you to; i would like; we need; we need to; we want you to; it is
        required that; it is necessary that; try to; try; remember to; let; the robot is
        to; making sure; see that; take care to; take care that; it is important that; go
        ahead and; i wish; your goal is to; the objective is to; your objective is to;
        your task is; the aim is to; bear in mind; have the robot; guaranteeing; the rule
        is; the rule is that; as a rule; go and; come and; arrange for; arrange it so
        that; arrange that; see that it is so that; it is essential that; it is vital
        that; i expect; we expect; i am expecting; we are expecting; i insist; i insist
        on; we insist on; insist on; insist that; it is my wish that; i ask that; we ask
        that; i ask you to; we ask you to; i would ask you to; i would ask that; we would
        like; we would like to; we would like you to; i would rather; i would prefer that;
        i would prefer; we would prefer; i would love; i would appreciate; be so kind as
        to; be good enough to; be sure and; do not fail to; never fail to; do not forget
        to; do not forget; what i want is; what we want is; what i need is; all i want is;
        all i ask is; all i ask is that; my request is; the idea is; the idea is to; the
        plan is; the plan is to; the point is; the point is that; the mission consists of;
        the job consists of; the task consists of; consists of; have it so that; i would
        be grateful if; it would be good if; it would be nice if; it would be great if; i
        would be happy if; i would be glad if; i would be pleased if; i would be obliged
        if; i would appreciate it if; it would help if; i should like; i should like to;
        let there be; there must be; there has to be; there needs to be; there should be;
        there shall be; there is to be; there will be; i want to see; we want to see; i
        want to see that; we want; the aim is; the goal is; the objective is; the mission
        is; the task is; the job is; you are to see to it that; manage to; be sure to; be
        certain to; you are asked; it is a must that; it is mandatory that; it is
        compulsory that; it is imperative that; it is expected that; i command that; i
        demand that; go on and; how about; cause; get it so that; requirement; the
        requirement is that; the requirement is; the following must hold; what matters is
        that
    """,
    Kind.MUST: """
        ~deserve; ~merit; ~warrant; must; have to; has to; had to; having to; should; shall; need
        to; needs to; ought
        to; is to; are to; are required to; is required to; is supposed to; are supposed
        to; will; are obliged to; are expected to; will have to; will need to; is
        mandatory; gotta; got to; had better; it is mandatory to; it is compulsory to; are
        obligated to; be required to; requires; require; want to; wants to; may have to;
        dare; needs; has got to; have got to; is due to; are due to; is meant to; are
        meant to; is bound to; is in need of; wants; is wanted; are wanted; is needed; are
        needed; is required; are required; is expected; are expected; is called for; is a
        must; are a must; is obligatory; is compulsory; are mandatory; are compulsory; is
        necessary; are necessary; is essential; is not optional; are not optional; is no
        option; is not up for debate; is indispensable; is due; is on the list; are on the
        list; is requested; are requested; is in order; mandatory; needed; required; is on
        the cards; get to; gets to
    """,
    Kind.MAY: """
        can; could; may; might; are allowed to; is allowed to; are permitted to; is
        permitted to; allowed to; allowed; permitted to; permitted; are free to; is free
        to; be allowed to; be permitted to; would; are allowed; is allowed; it is fine to;
        feel free to; are permitted; is permitted; it is ok to; it is okay to; are able
        to; is able to; need not; do not have to; does not have to; do not need to; does
        not need to; have no need to; are not obliged to; are not required to; is not
        required to; needs not; are under no obligation to
    """,
    Kind.NOT: """
        only not; not; no; neither; nor; none of; none; nothing; nobody; no one; nowhere; are
        prohibited from; is prohibited from; forbidden to; forbidden from; are forbidden
        to; is forbidden to; are forbidden from; banned from; not even; under no
        circumstances; it is not the case that; it is not true that; on no account; in no
        case; by no means; instead of; rather than; it is forbidden to; it is prohibited
        to; no longer; not once; no more; no further; not a single; not any; not at any;
        under no condition; under no circumstance; in no circumstances; on no occasion;
        not on any account; not under any circumstances; nobody is to; no one is to; there
        must be no; there is to be no; there shall be no; there should be no; there will
        be no; there may be no; there must not be any; hardly; prohibited from; it is not
        so that
    """,
    Kind.NEVER: """
        only never; never; never ever; at no time; at no point; at no moment; not at any time; no
        time; at no stage; at no time may; at no time must; at no time should; not at any
        point; not at any moment; not at any stage; not for a moment; not for one moment;
        not even once; never once; not a single time; not one single time; in no step; at
        no instant; at no step; never at any time
    """,
    Kind.FORBIDDEN: """
        will not do; will not suffice; is not enough; are not enough; do not suffice;
        off limits; is off limits; are off limits; out of bounds; is out of bounds;
        prohibited; is prohibited; are prohibited; forbidden; is forbidden; are forbidden;
        must be avoided; should be avoided; is to be avoided; are to be avoided; has to be
        avoided; have to be avoided; is not allowed; are not allowed; is not permitted;
        are not permitted; must always be avoided; should always be avoided; should be
        avoided at all costs; is taboo; is banned; are banned; banned; need to be avoided;
        needs to be avoided; a miss; a wide berth; a no go area; a no go zone; a no go; no
        go; is a no go; are a no go; is a no go zone; is a no go area; are no go zones; are no go
        areas;
        no go zone; no go zones; are no go; are taboo; taboo; out of the question; is out of the
        question; are out of the question; off the table; barred; is barred; are barred;
        is not an option; are not an option; is ruled out; are ruled out; is over; are
        over; is over and done with; is strictly forbidden; are strictly forbidden;
        strictly forbidden; is a forbidden zone; is closed to you; are closed to you; is
        no longer allowed; are no longer allowed; may not happen; must not happen; must
        not occur; must not take place; is not to happen; is never to happen; is not
        tolerated; is unacceptable; is verboten; not permitted; not allowed; is not
        acceptable; is disallowed; disallowed; off limits to you; is banned from; is
        barred from; at bay
    """,
    Kind.SUBJECT: """
        you; we; i; the robot; robot; robots; the robots; he; she; they; it; your robot;
        yourself; itself; one; somebody; someone; anyone; the machine; them; us; me
    """,
    Kind.WHEN: """
        when; if; in case; in the event that; in the event of; provided; provided that;
        where; given that; should it happen that; assuming; assuming that; on condition
        that; in case of; if ever; any time that if; at any point in time if; at any time
        if; supposing; in a situation where; once it is the case that; now that; since;
        because; in the event; in the case that; in cases where; in situations where; in
        situations in which; in a case where; where it happens that; supposing that; if it
        happens that; if it so happens that; if it turns out that; if it should happen
        that; on finding that; upon finding that; with the condition that; under the
        condition that; as long as it happens that; whereever
    """,
    Kind.WHENEVER: """
        whenever; every time; every time that; each time; each time that; any time;
        anytime; any time that; each and every time; at any time when; always when; always
        after; always if; at every step where; at every step at which; at each instant
        where; at every instant where; at every instant at which; every single time; every
        single time that; each and every time that; for every; for each; at every; on
        every; on each; upon every; upon each; with every; with each; after every; after
        each; following every; following each; after any; at all times when; always once;
        as often as; each time when; every time when; at each; at the times when; on every
        occasion that; on each occasion that; on any occasion when; no matter when; at any
        moment when; at any instant when; in every instant in which; at every instant in
        which; at every moment when; at every moment in which; in each step in which; in
        every step in which; at every step in which; in any step in which
    """,
    Kind.AFTER: """
        after; once; following; having; subsequent to; after having; after that when;
        upon; later than; as a consequence of; in response to; from the moment; from when;
        starting from; since the moment; from then on after; from the time; ever after;
        only afterwards when; from the moment that; from the time that; from the time
        when; starting when; as of the moment; as of when; beginning when; from the point
        where; in the wake of; having been; having been to; having been in; having been
        at; having visited; having gone to; having passed through; having reached; having
        stopped at
    """,
    Kind.PROMPTLY: """
        as soon as; immediately after; right after; directly after; straight after; just
        after; the moment; the moment that; the instant; the instant that; immediately
        when; immediately once; immediately upon; the very moment; directly when; right
        when; immediately following; promptly after; right upon; the second; the minute;
        at the exact moment; instantly after; the very instant; at the moment when;
        immediately whenever; as soon as ever; shortly after; at the moment; right as;
        right once; the step after; in the step after; at the step after; immediately if;
        in the step right after; in the step immediately after; one step after; exactly
        one step after; in the very step after; in the next step after; in the very next
        step after; the very step after; right after every; right after each; directly
        after every; directly after each; immediately after every; immediately after each;
        straight after every; straight after each; in the step right after each; in the
        step right after every; in the step after each; in the step after every; exactly
        one step after every; exactly one step after each; the step right after; no
        sooner; the step following; at the step right after; in the instant after; the
        instant after; in the step which follows; the very second; in the very moment; the
        exact moment; at the very moment; the second that
    """,
    Kind.BEFORE: """
        before; prior to; ahead of; before any; earlier than; in advance of; any earlier
        than; before ever; until after; till after; sooner than; strictly before; any time
        before; at some point before; at any time before; strictly ahead of; strictly
        prior to; ~precede; well before; previous to; ere; not later than; no later than;
        by the time
    """,
    Kind.RIGHT_BEFORE: """
        right before; immediately before; just before; directly before; straight before;
        immediately prior to; one step before; a step before; one instant before; the step before;
        in the step before
    """,
    Kind.UNTIL: """
        until; till; til; up until; up to when; until such time as; until the moment;
        until such time that; up to the point where; up to the moment; as long as not;
        unless and until; until when; so long as not; up to the moment when; up to the
        time; up to the time that; up to the time when; up to the point when; up to the
        instant; until the time; until the moment that; until the moment when; until the
        point where; for as long as it takes; for as long as it takes for; as long as it
        takes; until such a time as; pending; till such time as; till the moment; up till;
        right until; right up until; up until the moment; waiting for; waiting until
    """,
    Kind.UNLESS: "unless; except if; except when; except while; except after; save when",
    Kind.WHILE: """
        while; whilst; at a time when; at a moment when; at an instant when;
        at the same time as;
        as long as; so long as; during; at times when; all the while;
        throughout; for as long as; meanwhile; in the meantime; as you; while you; the
        whole time; for the time that; at every moment at which; at any step where; all
        the time that; the whole time that; the entire time that; in the time that; at all
        times that; at the moments when; every moment that; every instant that; all the
        time while; for all the time that; whilst ever; for the duration of
    """,
    Kind.WITHOUT: """
        without; without first; without ever; without at any time; without at any point;
        minus; in the absence of
    """,
    Kind.ONLY_IF: """
        only if; only when; only while; only in case; only as long as; only during; only
        in; only at; only on; only so long as; only where; only provided that; solely if;
        solely when; just if; exclusively when; only with; only from; only whenever;
        exclusively if; exclusively while; only ever if; only ever when; only ever while;
        only ever in; only ever at; only ever with; only ever on; only under; only inside;
        nowhere but; nowhere but in; nowhere but at; nowhere except; nowhere except in;
        nowhere except at; nowhere other than; at no other place than; in no other place
        than; only once it is so that; only on condition that; only when and if; only in
        the case that; at no time other than when; at no time except when; at no time but
        when; solely in; solely at; solely while; never except when; never except while;
        never but when; never other than when; never other than in; never other than at;
        only if and when
    """,
    Kind.ELSEWHERE: """
        everywhere but; everywhere except; everywhere other than; everywhere apart from;
        anywhere apart from; anywhere save; wherever you like but; wherever you like except;
        wherever you want but; wherever you want except; everywhere save; anywhere you like but;
        anywhere you like except; anywhere you want but; anywhere you want except;
        everywhere else but; anything except; all places but; any place but; any place except;
        anywhere but; anywhere but in; anywhere but at; anywhere except; anywhere except
        in; anywhere except at; anywhere other than; anywhere other than in; anywhere
        other than at; elsewhere than; elsewhere than in; elsewhere than at; outside of;
        outside; anywhere else than; anywhere outside
    """,
    Kind.ONLY_AFTER: """
        only after; only once; not until; not before; only from the moment; only
        following; never before; only upon; no sooner than; never until; solely after; not
        unless; no earlier than; not till; exclusively after; not earlier than; not
        earlier than when; never earlier than; never earlier than when; not prior to; no
        earlier than when; not sooner than; never till; not any earlier than; not any
        sooner than; at no time before; at no point before; under no circumstances before;
        on no account before; in no case before; not ever before; at the earliest after;
        at the earliest when; at the earliest once; not before having; only from the time;
        only from then on when; not as long as; never prior to; never ahead of; not ahead
        of; not once before; at no moment before; strictly after; only as of; only
        starting from; only when once; not without; not without having; never without; not
        without first; not without first having; never without having; never without first
    """,
    Kind.ONLY_RIGHT_AFTER: """
        only right after; only immediately after; only directly after; only just after;
        only straight after; only as soon as; only the moment; only in the step after;
        only at the step after
    """,
    Kind.IFF: """
        if and only if; exactly when; exactly if; precisely when; precisely if; just in
        case; when and only when; iff; if but only if; whenever and only when; always and
        only when; exactly while; whenever and only whenever; as long as and only as long
        as; if and only when; when and only if; whenever and only if; exactly as long as;
        exactly as often as; exactly in those moments when; exactly at the times when;
        exactly at those times when; precisely as long as; precisely while; in exactly
        those steps in which; exactly whenever; precisely whenever; always when and only
        when; every time and only when; if and exactly if; at exactly the times when; just
        when and only when; always if and only if; just when; just as long as; in exactly
        the same instants in which; in exactly the same steps in which; in those same
        instants in which; in the same instants as
    """,
}  # fmt: skip
