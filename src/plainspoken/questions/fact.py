"""What is so: one fact with its age and source, where things are, lists and counts."""

from __future__ import annotations

import re
from collections.abc import Sequence

from plainspoken.questions.age import lasting, since_when
from plainspoken.questions.claim import Draft
from plainspoken.questions.doubt import doubted, tell_doubt, tell_doubts
from plainspoken.questions.moment import Moment
from plainspoken.questions.morphology import counted, listed, number_word, plural
from plainspoken.questions.narration import MOST_NAMED, ago, facts_together, named
from plainspoken.questions.past import is_motion, tell_whether
from plainspoken.questions.prospect import tell_when_ahead
from plainspoken.questions.question import Question
from plainspoken.questions.spelling import normal
from plainspoken.questions.standing import say_facts
from plainspoken.world.domain import GroundAtom


def tell_state(draft: Draft, question: Question) -> None:
    """Answer what is so."""
    asked = question.referents
    plain = normal(question.text)
    draft.evidence.add(draft.moment.steps[-1])
    if question.form == "where" and _tell_where(draft, question, plain):
        pass
    elif question.yes_no and asked.atoms:
        _tell_whether(draft, _best(asked.atoms)[:MOST_NAMED])
    elif asked.predicates and (
        asked.kinds or question.yes_no or question.form in ("which", "how many", "what", "who")
    ):
        _tell_list(draft, question, plain)
    elif asked.atoms:
        _tell_whether(draft, _best(asked.atoms)[:1])
    elif question.yes_no and asked.actions:
        tell_whether(draft, question)
    elif asked.objects:
        _tell_about(draft, asked.objects)
    elif question.form in ("which", "how many") and asked.kinds:
        _tell_kind(draft, question)
    else:
        draft.known = False
        draft.say("I don't know which fact you mean, or I don't keep track of it")
        draft.say(hint(draft.moment))
    if draft.full:
        say_facts(draft, sorted(draft.moment.fluents), draft.now, opening="All in all,")


def _best(atoms: Sequence[GroundAtom]) -> list[GroundAtom]:
    """The facts of the predicate that the words fit best, which comes first."""
    predicate = atoms[0].split()[0]
    return [atom for atom in atoms if atom.split()[0] == predicate]


def hint(moment: Moment) -> str:
    """What could be asked about."""
    lexicon = moment.lexicon
    atoms = sorted(moment.fluents)[:1]
    example = f', or "Is it true that {lexicon.clause(atoms[0]).said()}?"' if atoms else ""
    return f'You can ask "Where are you?", "What is done so far?"{example}'


def _tell_whether(draft: Draft, atoms: Sequence[GroundAtom]) -> None:
    moment = draft.moment
    for atom in atoms:
        if moment.is_unsure(atom):
            tell_doubt(draft, atom)
            continue
        true = atom in moment.state or atom in moment.static
        draft.now([atom])
        clause = moment.lexicon.clause(atom)
        if true:
            draft.say(f"Yes, {lasting(draft, atom)}")
        else:
            back = moment.runs.get(atom)
            was = ""
            if back:
                draft.was(atom, back[-1][0])
                was = f" any more{since_when(draft, atom)}"
            draft.say(f"No, {clause.said(negative=True)}{was}")
            _tell_rivals(draft, atom)


def _tell_rivals(draft: Draft, atom: GroundAtom) -> None:
    """What is so instead: the other facts about the same thing that the same action decides."""
    moment = draft.moment
    arguments = atom.split()[1:]
    if moment.lexicon.place_clause(atom):
        _say_place(draft, arguments[0])
    elif len(arguments) == 1:
        about = [each for each in sorted(moment.fluents) if each.split()[1:] == arguments]
        draft.now(about)
        draft.say(listed([s.text for s in facts_together(moment.lexicon, about)]))


def _tell_where(draft: Draft, question: Question, plain: str) -> bool:
    moment = draft.moment
    names = list(question.referents.objects)
    names += [name for _, each in question.referents.kinds for name in each if name not in names]
    if not names and re.search(r"\byou\b|\brobot\b|\bi\b", plain) and moment.lexicon.me:
        names = [moment.lexicon.me]
    if not names or not [name for name in names if _placed(moment, name)]:
        return False
    for name in names[:MOST_NAMED]:
        _say_place(draft, name, missing=True)
    return True


def _placed(moment: Moment, name: str) -> bool:
    """Whether anything is known of a thing that could answer where it is."""
    known = moment.state | moment.static | moment.unsure
    return any(name in atom.split()[1:] for atom in known)


def _say_place(draft: Draft, name: str, *, missing: bool = False) -> None:
    moment = draft.moment
    lexicon = moment.lexicon
    everything = sorted(moment.state) + sorted(moment.static)
    found = [a for a in everything if a.split()[1:2] == [name] and lexicon.place_clause(a)]
    found = [a for a in found if moment.changes(a)] + [a for a in found if not moment.changes(a)]
    moving = moment.started is not None and name == lexicon.me
    if found:
        draft.now(found[:1])
        still = "still " if moving and moment.started and _leaves(moment) else ""
        said = lexicon.clause(found[0]).said()
        draft.say(said.replace("I'm ", f"I'm {still}", 1))
        if still and moment.started is not None:
            draft.evidence.add(moment.started_step)
            draft.sentences[-1] = draft.sentences[-1].rstrip(".") + (
                f", {lexicon.deed(moment.started.action).doing}."
            )
    elif missing and (maybe := _possible_places(moment, name)):
        tell_doubts(draft, maybe)
        draft.known = False
    elif missing:
        about = [a for a in sorted(moment.fluents) if name in a.split()[1:]]
        draft.now(about)
        said_all = listed([s.text for s in facts_together(lexicon, about)])
        draft.say(
            f"I don't keep track of where {lexicon.object_words(name)} is"
            + (f"; what I know is that {said_all}" if said_all else "")
        )
        draft.known = bool(about)


def _possible_places(moment: Moment, name: str) -> list[GroundAtom]:
    """The facts of where a thing is of which it is not known whether they are so."""
    about = [atom for atom in sorted(moment.unsure) if atom.split()[1:2] == [name]]
    return [atom for atom in about if moment.lexicon.place_clause(atom)]


def _leaves(moment: Moment) -> bool:
    return moment.started is not None and is_motion(moment, moment.started.action)


def _tell_list(draft: Draft, question: Question, plain: str) -> None:
    """Lists and counts: the things of a kind of which something is true."""
    moment = draft.moment
    asked = question.referents
    found_anything = False
    for predicate in asked.predicates[:1]:
        negative = re.search(r"\bnot\b|\b(?:yet|still|left) to\b", plain) is not None
        # "Not checked" is what "unchecked" says already.
        negative = negative and not (predicate.startswith("un") and predicate not in plain)
        column, candidates = _column(question, predicate, moment)
        if column is None:
            continue
        found_anything = True
        ever = re.search(r"\b(?:did|found|have you|had|ever)\b", plain) is not None
        atoms = _matching(moment, predicate, column, candidates, question, ever=ever)
        true = list(dict.fromkeys(atom.split()[column + 1] for atom in atoms))
        kind = (
            asked.kinds[0][0]
            if asked.kinds
            else moment.lexicon.type_words(candidates[0] if candidates else "")
        )
        doubts = doubted(moment, predicate, column, candidates)
        unsure = {atom.split()[column + 1] for atom in doubts}
        if negative:
            false = [c for c in candidates if c not in true and c not in unsure]
            if false or not doubts:
                _say_negative(draft, predicate, false, kind)
            tell_doubts(draft, doubts)
            return
        for atom in atoms:
            if atom in moment.state:
                draft.now([atom])
            else:
                draft.was(atom, moment.runs[atom][-1][0])
        _say_list(draft, atoms, question)
        if doubts:
            if not atoms:
                draft.say("None that I know of" if question.form else "Not that I know of")
            tell_doubts(draft, doubts)
        elif not atoms:
            _say_none(
                draft, _sample(question, predicate, column, candidates, moment), kind, question
            )
            for name in candidates[:50]:
                parameters = moment.problem.domain.predicates[predicate]
                if len(parameters) == 1:
                    draft.now([f"{predicate} {name}"])
    if not found_anything:
        draft.known = False
        draft.say("I'm not sure which things you mean")


def _column(
    question: Question, predicate: str, moment: Moment
) -> tuple[int | None, tuple[str, ...]]:
    """Which argument of the predicate the question wants, and what could stand there."""
    parameters = moment.problem.domain.predicates[predicate]
    for _, names in question.referents.kinds:
        for index, parameter in enumerate(parameters):
            fitting = moment.problem.objects_for(parameter)
            chosen = tuple(name for name in names if name in fitting)
            if chosen and not set(question.referents.objects) & set(chosen):
                return index, chosen
    me = moment.lexicon.me
    columns = [(index, moment.problem.objects_for(each)) for index, each in enumerate(parameters)]
    free = [each for each in columns if not set(question.referents.objects) & set(each[1])]
    return next(iter(sorted(free, key=lambda each: me in each[1])), (None, ()))


def _matching(
    moment: Moment,
    predicate: str,
    column: int,
    candidates: Sequence[str],
    question: Question,
    *,
    ever: bool,
) -> list[GroundAtom]:
    pool = moment.runs if ever else moment.state | moment.static
    wanted = set(candidates)
    return sorted(
        atom
        for atom in pool
        if atom.split()[0] == predicate
        and atom.split()[column + 1] in wanted
        and set(question.referents.objects) <= set(atom.split()[1:])
    )


def _sample(
    question: Question,
    predicate: str,
    column: int,
    candidates: Sequence[str],
    moment: Moment,
) -> tuple[GroundAtom, str] | None:
    """A fact of the kind that is asked for, and the thing in it that stands for the others."""
    arguments: list[str] = []
    for index, parameter in enumerate(moment.problem.domain.predicates[predicate]):
        fitting = moment.problem.objects_for(parameter)
        named = [each for each in question.referents.objects if each in fitting]
        own = [each for each in fitting if each == moment.lexicon.me]
        pool = list(candidates[:1]) if index == column else named or own or list(fitting[:1])
        if not pool or (index != column and not named and not own and len(fitting) > 1):
            return _spoken_sample(predicate, column, candidates, moment)
        arguments.append(pool[0])
    return " ".join([predicate, *arguments]), arguments[column]


def _spoken_sample(
    predicate: str, column: int, candidates: Sequence[str], moment: Moment
) -> tuple[GroundAtom, str] | None:
    """The same from the landmarks, whose words may leave a further thing unsaid."""
    for atom, _ in moment.lexicon.atom_phrases():
        name, *arguments = atom.split()
        if name == predicate and arguments[column] in candidates:
            others = [each for each in arguments if each != arguments[column]]
            text = moment.lexicon.clause(atom).said()
            if not any(moment.lexicon.object_words(each) in text for each in others):
                return atom, arguments[column]
    return None


def _say_none(
    draft: Draft, sample: tuple[GroundAtom, str] | None, kind: str, question: Question
) -> None:
    """`Nothing is in the box`, `no mug is clean`."""
    lexicon = draft.moment.lexicon
    what = "nothing" if question.form in ("what", "") and not question.referents.kinds else ""
    if sample is None:
        draft.say("No, nothing" if question.yes_no else "Nothing" if what else "None")
        return
    atom, name = sample
    clause = lexicon.clause(atom)
    words = lexicon.object_words(name)
    said = clause.said()
    text = said.replace(words, what or f"no {kind}", 1) if words in said else ""
    text = text or clause.said(negative=True)
    number = "None: " if question.form == "how many" else ""
    draft.say(f"{'No, ' if question.yes_no else number}{text}")


def _say_list(draft: Draft, atoms: Sequence[GroundAtom], question: Question) -> None:
    moment = draft.moment
    lexicon = moment.lexicon
    current = [atom for atom in atoms if atom in moment.state or atom in moment.static]
    gone = [atom for atom in atoms if atom not in current]
    if not atoms:
        return
    opening = "Yes, " if question.yes_no else ""
    if question.form == "how many":
        opening = f"{number_word(len(atoms))}: "
    parts = [s.text for s in facts_together(lexicon, current, most=12)]
    parts += [s.text for s in facts_together(lexicon, gone, "was", most=12)]
    draft.say(opening + listed(parts))


def _say_negative(draft: Draft, predicate: str, names: Sequence[str], kind: str) -> None:
    moment = draft.moment
    atoms = [f"{predicate} {name}" for name in names]
    if len(moment.problem.domain.predicates[predicate]) != 1:
        draft.known = False
        draft.say(f"I can't list {plural(kind)} by what is not so")
        return
    draft.now(atoms)
    said = facts_together(moment.lexicon, atoms, negative=True, most=12)
    draft.say(
        listed([each.text for each in said]) if said else f"None: that's true of every {kind}"
    )


def _tell_about(draft: Draft, names: Sequence[str]) -> None:
    """Everything known of some things."""
    moment = draft.moment
    about = [atom for atom in sorted(moment.fluents) if set(names) & set(atom.split()[1:])]
    draft.now(about)
    said = listed([each.text for each in facts_together(moment.lexicon, about)])
    words = named(moment.lexicon, list(names))
    draft.say(f"What I know: {said}" if said else f"I know nothing about {words} that could change")
    tell_doubts(draft, [atom for atom in moment.unsure if set(names) & set(atom.split()[1:])])


def _tell_kind(draft: Draft, question: Question) -> None:
    kind, names = question.referents.kinds[0]
    draft.evidence.add(draft.moment.steps[0])
    draft.say(
        f"There {'is' if len(names) == 1 else 'are'} {counted(len(names), kind)}: "
        f"{named(draft.moment.lexicon, names)}"
    )


def tell_when(draft: Draft, question: Question) -> None:
    """Answer since when something is so, or when something was done."""
    moment = draft.moment
    asked = question.referents
    found = [each for each in moment.happenings if asked.actions and asked.concerns(each.action)]
    draft.evidence.add(moment.steps[-1])
    ahead = re.search(r"\b(?:will|going to|shall)\b", normal(question.text)) is not None
    if ahead and (asked.actions or asked.atoms):
        if not tell_when_ahead(draft, question):
            draft.say("Not in this mission: it's not in my plan")
    elif found:
        last = found[-1]
        draft.did(last)
        deed = moment.lexicon.deed(last.action)
        clock = next(e.time for e in reversed(moment.entries) if e.step == last.step)[11:16]
        draft.say(
            f"{deed.subject} {deed.did} {ago(moment.now - last.at)}"
            + (f", at {clock}" if re.fullmatch(r"\d\d:\d\d", clock) else "")
        )
    elif asked.atoms:
        atom = asked.atoms[0]
        runs = moment.runs.get(atom)
        clause = moment.lexicon.clause(atom)
        if moment.is_unsure(atom):
            tell_doubt(draft, atom)
        elif runs is None:
            draft.now([atom])
            draft.say(clause.never())
        elif atom in moment.state:
            draft.now([atom])
            draft.say(f"{lasting(draft, atom)}")
        else:
            draft.was(atom, runs[-1][0])
            draft.say(f"{clause.said('was')} until {ago(moment.now - runs[-1][1])}")
    elif asked.actions:
        if not tell_when_ahead(draft, question):
            tell_whether(draft, question)
    else:
        draft.known = False
        draft.say("I can't tell what you want the time of")
