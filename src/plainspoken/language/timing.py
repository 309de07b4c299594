"""Phrases that join, order, time and count, and those that shape nothing.

Written as in `phrases`: `~` before a word means any inflection of it.
"""

from __future__ import annotations

from plainspoken.language.kind import Kind

PHRASES_OF_TIMING: dict[Kind, str] = {
    Kind.AND: """
        and; as well as; along with; plus; &; and also; also; in addition; moreover;
        furthermore; additionally; besides; together with; in addition to; too; on top of
        that; /; likewise; and likewise; as also; not forgetting; equally; in the same
        way; the same way; or rather
    """,
    Kind.OR: """
        ~pick one from; ~pick one of; ~choose one from; ~choose one of; ~pick either of;
        ~choose either of; ~select one of; ~select one from; ~take one of;
        or; either; at least one of; any one of; one of; alternatively; or any
        of; at least one out of; one out of; at least one among; any of; whichever of; one
        or other of; one or the other of; either one of; either of; at least one of the
        two; as you prefer
    """,
    Kind.BUT: """
        but; however; yet; though; although; except that; with the proviso that; whereas;
        only that; on the other hand
    """,
    Kind.THEN: """
        then; and then; next; finally; lastly; followed by; and finally; after which;
        last; secondly; thirdly; and next; and subsequently; in turn; ->; and lastly;
        thence; thereupon; hereupon; then on; onward; onwards; then onward; onward to;
        followed then by; next stop; and after which; and thereafter; next after that;
        second stop; third stop; next comes; then comes; followed closely by; and onwards;
        then afterwards; before moving on to; before heading on to; before going on to;
        before proceeding to; before continuing to; before carrying on to; last of all;
        and last; and last of all; whereupon; upon which; then finally; then eventually;
        in second place
    """,
    Kind.ONLY_THEN: """
        only then; and only then; only after that; only afterwards; and only after that;
        then and only then; only then may you; not before then; and not before then; not
        until then; and not until then; not till then; only at that point; only from then
        on; and only from then on; and only afterwards; only when that is done; only when
        this is done; only once that is done; and only once that is done; only thereafter;
        and only thereafter
    """,
    Kind.NTH: "second; third; fourth; fifth; sixth; seventh",
    Kind.FIRST: """
        first; firstly; first of all; to begin with; start by; start with; begin by; begin
        with; start; begin; to start with; initially; first off; starting with; beginning
        with; before anything else; before all else; first up; as a first step; first
        things first; for starters; to kick off; initially of all; in first place; in the
        first place; first stop
    """,
    Kind.BEFORE_THAT: """
        before it; before them; before that; beforehand; but before that; first though; before
        this; before then;
        prior to that; prior to this; earlier; by then; by that time; ahead of that; ahead
        of it; earlier than that; at an earlier time; some time before that; before doing
        so; before doing that; before you do; before you do so; before you do that; before
        you get there; before you go there; before arriving; before arriving there; before
        getting there; before going there; before you arrive; before you arrive there; on
        the way; on the way there; any earlier than that; any earlier; any sooner; earlier
        on; not later; and not later; no later; and no later
    """,
    Kind.AFTER_THAT: """
        after that; after this; from then on; from that point on; from that moment on;
        from there on; from there; after it; afterwards; afterward; after then; from that
        moment; thereafter; any longer; ever since; following that; following this; once
        done; when done; once finished; when finished; after doing so; having done so;
        once that is done; once this is done; when that is done; after doing that; once
        there; when you are done; once you are done; after they are; from then onwards;
        since then; once that has been done; once that has happened; when that has been
        done; when that has happened; when that is over; once that is over; with that
        done; that done; this done; having done that; having got there; once you have got
        there; once you are there; when you are there; when you get there; once you get
        there; once arrived; having arrived there; having arrived; having been there; when
        you have been there; once you have been there; for the rest; for all the time that
        follows; for the time after; for all time after; for all that follows; past that
        point; from that time on; from then onward; from that point onward; from that
        point onwards; thenceforth; from there onwards; the stop after that; next in line;
        in the aftermath; some time afterwards; some time after that; at some time after
        that; at some point after that; at any time after that; any time after; ever
        afterwards; after doing this; later than that; when you have done that; once you
        have done that; after being there; when finished there; once finished there;
        for future visits; for any future visit; for the future; in future; for ever after;
        afterwards at some point; in the time after that
    """,
    Kind.RIGHT_AFTER_THAT: """
        right after that; immediately after that; right after; right next; right
        afterwards; immediately afterward; immediately afterwards; straight after;
        directly after; just after; right after this; directly after that; directly
        afterwards; immediately thereafter; straight afterwards; immediately after; just
        after that; straight after that; as the next step; immediately after this; right
        after it; immediately after it; just afterwards; directly thereafter; right
        afterward
    """,
    Kind.RIGHT_BEFORE_THAT: """
        right before; right before that; immediately before; just before; immediately
        before that; immediately beforehand; just before that; right beforehand; directly
        before; directly before that; directly beforehand; just beforehand; immediately
        prior; straight before; right before it; in the step before; at the step before;
        immediately before it; in the previous step; one step earlier
    """,
    Kind.ANY_ORDER: """
        in any order; in no particular order; in no specific order; in any sequence; in
        whatever order; order does not matter; the order does not matter; the order is not
        important; order is not important; the order is irrelevant; whichever comes first;
        in any order you like; regardless of order; in an arbitrary order; whatever the
        order; in whichever order; in any order you want; in no order; no matter the
        order; any order; any order will do; any order is fine; any order is ok; any order
        at all; any order you like; any old order; in any old order; the order is yours;
        the order is up to you; you choose the order; you pick the order; order is up to
        you; in no special order; in no set order; in no fixed order; no matter which
        first; whichever first; either one first; whichever you like first; no particular
        order; in either order; either order; either order will do; in either sequence; in
        what order does not matter; it does not matter in which order; it does not matter
        in what order; does not matter in which order; does not matter in what order; no
        matter in which order; never mind the order; order is of no importance; the order
        is of no importance; the sequence is of no importance; the sequence does not
        matter; the sequence is up to you; irrespective of order; irrespective of the
        order; regardless of the order; order irrelevant; order immaterial; the order is
        immaterial; order free; order is free; in whatever sequence; in whichever
        sequence; one way round or the other; one way or the other; in the order you like;
        in the order of your choice; in your own order; in whatever order suits; in
        whatever order suits you; whatever order; whatever order suits you; in random
        order; in arbitrary order; the order does not count; the order makes no
        difference; order makes no difference; the order is open; as it comes; as they
        come
    """,
    Kind.SEQUENCE: """
        one after another; one after the other; in sequence; in a sequence; in some
        sequence; successively; in succession; consecutively; sequentially; one by one; in
        a row; must be followed by the next; followed by the next; is followed by the next
    """,
    Kind.IN_ORDER: """
        none of them ahead of the one before it; none of them before the one before it;
        none ahead of the one before it; none before the one before it;
        in this order; in that order; in order; in exactly that order; in the given order;
        in exactly this order; in that specific order; in this specific order; in the
        following order; in the order given; in that exact order; in this exact order; in
        the order listed; in the specified order; without skipping; strictly in order; in
        strict order; in the order; in precisely that order; in precisely this order; in
        that very order; in this sequence; in that sequence; respecting that order;
        keeping to that order; in the stated order; in the order stated; in the order
        named; in the order mentioned; in the said order; in exactly the order given; in
        just that order; in just this order; and in that order; and in order; in the right
        order; in the correct order; in due order; in strict sequence; in that order only;
        in this order only; in strictly that order; in strictly this order; strictly in
        that order; strictly in this order; in that same order; exactly in that order;
        exactly in this order; precisely in that order; always in that order; this order
        only; that order only; in that order and no other; in this order and no other; in
        that order and in no other; in the order in which i say them; in the order i say;
        keep to that order; keep that order; keep the order; stick to that order; no
        jumping ahead; without jumping ahead; never the other way round; never the other
        way about; never the other way around; not the other way round; not the other way
        around; not the other way about; never in reverse; never the reverse; not the
        reverse; and not vice versa; not vice versa; never vice versa; in the given
        sequence; in the named order
    """,
    Kind.NO_RETURN: """
        without revisiting; without going back; without returning; without ever going
        back; once each; each location once; each place once; never return; never going
        back; without revisiting any; exactly once each; only once each; visit each of
        them once; each exactly once; each only once; and never go back; never revisit any
        of them; without going back to any of them; without coming back; without visiting
        any of them twice; without visiting any twice; each of them once; without
        revisiting any of them; without repeating any; without returning to any of them;
        without repeats; no repeats; no repetitions; without repetition; each just once;
        each one once; each one exactly once; each a single time; one time each; once
        apiece; exactly once apiece; each of them exactly once; each exactly one time;
        exactly one time each; each only one time; each of these exactly once; each of
        these once; no place twice; none of them twice; none twice; neither twice; never
        twice; without coming back to any of them; without going back to any; with no
        going back; no going back; no returning; and no coming back; each stop only once;
        each stop once; visiting each only once; visiting each exactly once; each one only
        once; each one just once; just once each; a single time each; entering each only
        once; entering each exactly once
    """,
    Kind.NEXT: """
        immediately; right away; straight away; at once; directly; instantly; promptly;
        without delay; right then; straightaway; forthwith; straight; right; next thing;
        without hesitation; asap; without any delay; as soon as possible; as quickly as
        possible; quickly; do not dawdle; on the spot; next up; very next; on the double;
        at the double; no dawdling; without dawdling; this very moment; then and there;
        with no delay; with immediate effect; without losing a moment; without losing
        time; without wasting time; first thing; as the very next thing; the very next
        thing you do is; the next thing you do is; the very next thing; the next thing; as
        the next thing; immediately thereupon; with no delay whatsoever; no delay; right
        off; on the instant; pronto; in a flash
    """,
    Kind.NEXT_INSTANT: """
        in the next step; at the next step; at the next time step; in the very next step;
        at the very next step; at the very next time instant; at the next instant; at the
        very next instant; in the next instant; in the next time step; one step later; in
        the following step; at the following instant; the next time step; the next step;
        at the very next time step; at the next moment; in the next moment; one instant
        later; at the next time instant; in the following instant; in the immediately
        following step; in the very following step; in the step directly after that; in
        the step right after that; in the step after that; in the next instant after; in
        the following moment; exactly one step later; one step later exactly; one step
        afterwards; one step after that; the very next step; the step after that; the
        following step; at the following step; in the very next instant; at the very next
        moment; with the next step; a step later; a single step later; just one step
        later; one tick later; the very next instant; in the one step after; in the step
        just after
    """,
    Kind.LATER_ON: """
        later; later on; later still; some time later; at some later time; at a later
        time; at some later point; at a later point; at some later moment; at a later
        moment; at some later stage; at a later stage; at some later instant; at a later
        instant; after a while; at a later date; a while later; a bit later; a little
        later; sometime later; some while later; at some point later; at some stage later;
        then later; subsequently; down the road; at some subsequent point; at some
        subsequent time; at some later step
    """,
    Kind.LATER: """
        before we pack up; before you pack up; before we finish; before we stop; before you stop;
        before we leave; before we go home; before you go home; before closing time; before
        knocking off; before the end of the day; before the day is over; before your shift is
        over; before your shift ends; before the shift is over; before the shift ends; before we
        close; before you call it a day; before we call it a day; by closing time; by tonight;
        by the end of the day; by the end of the shift;
        eventually; in the future; at some point; sooner or later; at some stage; in the
        end; at some time; ultimately; some time; sometime; at the end; in due course; at
        least once in the future; at least once after; at one point; at some point after;
        some day; at least once later; at some point in the future; at least once
        afterwards; in time; whenever suits; at some moment; at any later time; whenever
        you can; whenever you like; whenever convenient; whenever possible; at some
        instant; at some point or other; one day; at some time or other; at one time or
        another; at some point or another; some time or other; in the long run; before the
        end; by the end; in good time; whenever it suits; whenever it suits you; whenever
        you are ready; when convenient; when you can; when possible; when it suits; when
        it suits you; when you have time; when you have a moment; when you get a chance;
        when you get the chance; at your convenience; at your leisure; before it is over;
        before all is over; before you are done; before you finish; by the time you
        finish; by the time you are done; at least once; at some step; at any time you
        like; somewhere along the way; along the way; at some time after; at some point in
        time; over time; in one step at least; in at least one step; there must come a
        time when; there must come a moment when; somewhen; sooner or later though; a
        moment when; a later moment when; a time when; a later time when; a point when; a
        point at which; a later point at which; a moment at which; a later moment at
        which; an instant when; an instant at which; a step at which; a step in which;
        some moment when; some time when; a moment where; some point at which; a moment in
        which; a moment that
    """,
    Kind.NOW: """
        at the same time; simultaneously; at the same moment; at the same instant; in the
        same instant; at that very moment; in the same step; at that instant; at that
        moment; at the same step; concurrently; in that very instant; there and then; at
        that very instant; at once both; both at once; together at once; at the one time;
        all at once; in one and the same step; in one and the same instant; at one and the
        same time; at one and the same moment; in the same moment; in the very same step;
        at the very same time; at the very same moment; at the very same instant; go
        together; coincide; jointly; at that same moment; at that same time; throughout
        that time; right then and there; in tandem; side by side; in that step; that same
        instant; in that same step; at that step; right there and then
    """,
    Kind.ALWAYS: """
        every time that happens; whenever that happens; whenever that is the case; each time that
        happens; whenever that is so; every time this happens; each time this happens; whenever
        this happens; whenever this is the case; every time it happens; each time it happens;
        every time that is so; every time that is the case; whenever it happens;
        always; at all times; all the time; at every moment; at all costs; at any time;
        ever; in any case; permanently; at any point; at every point; at any moment; at
        every instant; at any point in time; for the whole mission; throughout the
        mission; the entire time; the whole time; for good; at all; from start to finish;
        at every step; at each step; in all cases; for all time instances starting from
        the next one; in every situation; during the mission; at any instant; until the
        end; to the end; from beginning to end; from the beginning to the end; from the
        start to the end; from the very start; from the start; from first to last; from
        the first moment to the last; the whole way; all along; at every single step; in
        every step; in each step; at every single moment; at every time; at each moment;
        at each instant; in every instant; at each and every moment; without exception;
        without interruption; the whole way through; all the way through; the whole while;
        every single step; day and night; at every turn; around the clock; all through;
        invariably; under all circumstances; in any circumstances; without a break; in all
        situations; without fail; with no exception; with no exceptions; no exceptions;
        without any exception; at every stage; every step of the way; come what may; from
        now on; from now to the end; the complete time
    """,
    Kind.OTHERWISE: """
        otherwise; or else; if not; or otherwise; failing that; if that is not the case; if
        this is not the case; in all other cases; in any other case; in the other case; if it
        is not; if they are not; if it does not; if that is not so; and if not; but if not
    """,
    Kind.NO_OTHER: """
        at no other time; any other time; at any other time; nowhere else; no other time;
        no other place; nothing else; never otherwise; and not otherwise; not otherwise;
        anywhere else; anything else; at no other step; at no other moment; at no other
        instant; otherwise never; and only then; except then; except right then; only at
        that time; nowhere else except; in no other case; on no other occasion; in no
        other step; at no other point; under no other circumstances; only at that moment;
        in no other order; never at any other time; and never at any other time; not at
        any other time; not at any other moment; never else; in no other situation; and in
        no other situation; nowhere other; never elsewhere; not elsewhere; nor anywhere
        else; not anywhere else; in no other place; at no other place; and only right
        after that; only right after that; and at that time only; and only in that case;
        only in that case; and only in those cases; only in those cases; then only; in no
        other event; not in any other case; in no other moment; not in any other step; not
        in any other situation; at none other; no others; and no others; and no other; no
        other; and only there; only there; and there only; there only; always then and
        only then; and only at those times; only at those times; and only at that moment;
        in that case only; and not at any other time; and only in that step; only in that
        step; but never otherwise; otherwise not; otherwise do not; and otherwise never;
        and otherwise not; and only right then; only right then; and only at that time;
        not before and not after; not sooner and not later
    """,
    Kind.AGAIN_AND_AGAIN: """
        always eventually; eventually always again; forever; for ever; indefinitely; continually;
        infinite times; without ever
        stopping; without end; at least once after at any point; infinitely; infinitely
        often; repeatedly; again and again; over and over; over and over again; an
        infinite number of times; infinitely many times; constantly; forever and ever;
        perpetually; endlessly; time and again; regularly; on repeat; ad infinitum; in a
        loop; in an endless loop; without stopping; round and round; forevermore; all over
        again; time after time; without cease; without ceasing; unceasingly; incessantly;
        for all time; in endless rounds; again and yet again; without letup; always anew;
        on and on; without pause; continuously; evermore; in perpetuity; ceaselessly;
        tirelessly; persistently; periodically; consistently; recurrently; recurringly;
        routinely; habitually; intermittently; at regular intervals; on a regular basis;
        from time to time; every now and then; nonstop; until further notice; as often as
        possible; every so often; now and
        again
    """,
    Kind.ALTERNATE: """
        ~share your visits evenly between; ~share your visits between; ~share your time between;
        ~split your visits between; ~divide your visits between;
        alternate; alternates; alternating; alternate between; alternates between;
        alternating between; ~take turns; ~take turns with; ~take turns at; ~take turns
        between; in turns; by turns; strictly in turns; strictly by turns; turn about;
        turn and turn about; turn by turn; alternately; alternatingly; in alternation; in
        strict alternation; in fair alternation; fairly; ~be fair to; fair; a fair share;
        a fair share of; ~treat fairly; even handedly; evenly; equitably; by rotation; in
        rotation; ~rotate; ~rotate between; ~rotate through; ~go back and forth between;
        back and forth between; to and fro between; ~switch between; ~swap between
    """,
    Kind.ALREADY: "already; previously; ever before",
    Kind.ONLY: "only; solely; exclusively",
    Kind.AGAIN: """
        ~repeat; ~repeat this; ~repeat that; ~repeat it; ~do it again; ~do that again;
        ~do this again; ~do so again; ~do the same again;
        again; any more; anymore; a second time; ever again; once more; another time; one
        more time; one further time; afresh; anew; yet again; a further time; all over;
        once again; the same again; any further; further
    """,
    Kind.IT_HAPPENS: """
        it is; it does; it happens; that is; that happens; this happens; it occurs; that
        occurs; it has; that is the case; this is the case; they are; it becomes so; it is
        so; this is so; that is so; it gets so; so; it has happened; that has happened;
        this occurs; you do; you do so; you do that; you have done so; you have done that;
        you have; it has been; it becomes; they do; that has been done; it does so; it is
        done; that is done; it has happened so; it is there; it has been done
    """,
    Kind.BOTH: """
        the other one; the other two; the others; the remaining one; the remaining two;
        both; both of them; both of these; both of those; both the two; each of the two;
        each of them; each of these; all of them; all three; all four; all of these; all
        of those; the two; the two of them; the three of them; all three of them; the
        three; all five; each; the lot; the whole lot; them both; them all; every one of
        them; each one of them; each one; all
    """,
    Kind.RELATIVE: "that; which; who; whose; what; how; why; whether",
    Kind.FILLER: """
        or do both if you like; or both; or do both; if you like; if you wish; if you want;
        or even both; possibly; perhaps; preferably; ideally; hopefully; obviously; naturally;
        at your earliest convenience; think about; think of; even think about; even think of;
        dream of; even dream of; no matter which; whichever it is; subsequently to; in fact;
        understood; got it; real quick; across;
        make; bring; put; get; do; does; did; the; a; an;
        to; at; in; into; on; onto;
        from; of; off; by; for; with; towards; toward; through; inside; near; up; down;
        over; back; around; just; simply; also; really; some; any; every; this; these;
        those; there; here; your; its; their; his; her; my; our; have; has; had; ok; okay;
        well; so; as; than; hey; hi; hello; thanks; thank; very; quite; even; still; now;
        today; please; pls; plz; thx; location; locations; place; places; area; areas;
        spot; position; positions; stop; stops; stopping; point; following; list; like;
        want; wish; time; times; moment; instant; step; steps; about; need; bit; little; kind;
        such; same;
        else; other; others; them; everything; go ahead; to be; along; way; previous;
        path; own; specific; given; particular; order; able; possible; certain; sure; at
        least; at most; while; would you; could you; can you; will you; mission; task;
        tasks; job; goal; the following; mr; hmm; um; uh; er; well then; right now; good;
        great; gladly; soon; whole; entire; alone; being; do so; doing so; doing; done so;
        if possible; if you can; if you would; if you please; would you please; if you do
        not mind; robot; of course; careful; be careful; carefully; quickly; state; true;
        false; ahead; exactly; precisely; strictly; either; whatever; whichever;
        somewhere; anywhere; everywhere; together; yes; first; out; away; one; step by
        step; trip; visit; visits; occasion; occasions; instance; instances; ones; set;
        directly; i; me; us; rest; too; as many times as you want; as often as you want;
        as many times as you like; as often as you like; any number of times; let's; 's;
        let us; happen; take; keep in mind; remember; note; note that; situation; case;
        cases; no more and no less; no more and no fewer; neither more nor less; neither
        more nor fewer; no more no less; just the one; no second one; give; gives;
        completely; entirely; altogether; no more than that; and no more than that; that includes
        you;
        and that includes you; you included; including you; errand; errands; chore; chores;
        presence; attendance; appearance; destination; target; entrance; in between
    """,
}  # fmt: skip
