"""The parts of a request in words: what is to be reached, kept, avoided or done."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from plainspoken.logic.english import say
from plainspoken.logic.formula import Always, And, Atom, Eventually, Formula, Not, Or
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.morphology import a, listed
from plainspoken.questions.narration import facts_together
from plainspoken.world.domain import GroundAtom
from plainspoken.world.symbol import ActionSymbol, AtomSymbol, resolve


class Aim(StrEnum):
    """What a part of a request wants of its facts or action."""

    REACH = "reach"
    KEEP = "keep"
    AVOID = "avoid"
    DO = "do"
    NEVER_DO = "never do"
    OTHER = "other"


@dataclass(frozen=True, slots=True)
class Wish:
    """One part of a request.

    atoms:  the facts it is about, where it is about nothing else
    action: the symbol of the action it is about
    """

    aim: Aim
    formula: Formula
    atoms: tuple[GroundAtom, ...] = ()
    action: ActionSymbol | None = None


def wish_of(formula: Formula, lexicon: Lexicon) -> Wish:
    """What a conjunct of the request wants, as far as it is of a simple form."""
    match formula:
        case Eventually(Atom() | And() as inner):
            return _of_atoms(Aim.REACH, Aim.DO, formula, inner, lexicon)
        case Always(Not(Atom() | Or() as inner)):
            return _of_atoms(Aim.AVOID, Aim.NEVER_DO, formula, inner, lexicon)
        case Always(And(operands)) if all(isinstance(each, Not) for each in operands):
            bare = And(tuple(each.operand for each in operands if isinstance(each, Not)))
            return _of_atoms(Aim.AVOID, Aim.OTHER, formula, bare, lexicon)
        case Always(Atom() | And() as inner):
            return _of_atoms(Aim.KEEP, Aim.OTHER, formula, inner, lexicon)
        case _:
            return Wish(Aim.OTHER, formula)


def _of_atoms(
    aim: Aim, deed: Aim, formula: Formula, inner: Atom | And | Or, lexicon: Lexicon
) -> Wish:
    parts = (inner,) if isinstance(inner, Atom) else inner.operands
    symbols = [resolve(p.name, lexicon.problem) for p in parts if isinstance(p, Atom)]
    if len(symbols) == len(parts):
        facts = tuple(symbol.atom for symbol in symbols if isinstance(symbol, AtomSymbol))
        if len(facts) == len(symbols):
            return Wish(aim, formula, facts)
        if len(symbols) == 1 and isinstance(symbols[0], ActionSymbol) and deed is not Aim.OTHER:
            return Wish(deed, formula, action=symbols[0])
    return Wish(Aim.OTHER, formula)


def action_words(symbol: ActionSymbol, lexicon: Lexicon) -> str:
    """The words for any action that a symbol means: `wash a mug`, `check mug 1`."""
    given = list(symbol.arguments)
    if not given and (one := lexicon.landmarks.get(symbol.id)) is not None:
        return one.description.removeprefix("to ")
    template = lexicon.template(symbol.action)
    schema = lexicon.problem.action(symbol.action)[0]
    words = [template.verb]
    for part in template.parts:
        if isinstance(part, str):
            words.append(part)
            continue
        parameter = schema.parameters[part]
        fitting = lexicon.problem.objects_for(parameter)
        fits = [name for name in given if name in fitting]
        if fits:
            words.append(lexicon.object_words(fits[0]))
        elif len(fitting) == 1:
            words.append(lexicon.object_words(fitting[0]))
        else:
            words.append(a(" ".join(parameter.types[0].split("-"))))
    return " ".join(words)


def wanted(wish: Wish, lexicon: Lexicon) -> str:
    """The wish after `you want`: `line 1 to be cleared`, `me to keep away from line 3`."""
    facts = listed([_infinitive(lexicon, atom) for atom in wish.atoms])
    merged = facts_together(lexicon, wish.atoms)
    if len(wish.atoms) > 1 and len(merged) == 1 and " are " in merged[0].text:
        clause = lexicon.clause(wish.atoms[0])
        subject = merged[0].text.split(" are ")[0]
        facts = f"{subject} to {clause.verb} {clause.complement}"
    match wish.aim:
        case Aim.REACH:
            return facts
        case Aim.KEEP:
            return f"{facts} all the time"
        case Aim.AVOID if _places(wish, lexicon):
            return f"me to keep away from {_where(wish, lexicon)}"
        case Aim.AVOID:
            return facts.replace(" to ", " never to ")
        case Aim.DO if wish.action is not None:
            return f"me to {action_words(wish.action, lexicon)}"
        case Aim.NEVER_DO if wish.action is not None:
            return f"me never to {action_words(wish.action, lexicon)}"
        case _:
            return f"this: {plain(wish.formula, lexicon)}"


def _infinitive(lexicon: Lexicon, atom: GroundAtom) -> str:
    clause = lexicon.clause(atom)
    subject = "me" if clause.subject == "I" else clause.subject
    return f"{subject} to {clause.verb} {clause.complement}".strip()


def _where(wish: Wish, lexicon: Lexicon) -> str:
    return listed([lexicon.clause(atom).complement.split(" ", 1)[-1] for atom in wish.atoms])


def standing(wish: Wish, lexicon: Lexicon) -> str:
    """What has been kept, done or is left of a wish that is not about reaching facts."""
    match wish.aim:
        case Aim.AVOID if _places(wish, lexicon):
            return f"keeping away from {_where(wish, lexicon)}"
        case Aim.AVOID:
            said = [lexicon.clause(atom).said(negative=True) for atom in wish.atoms]
            return f"that {listed(said)} at any time"
        case Aim.KEEP:
            said = [lexicon.clause(atom).said() for atom in wish.atoms]
            return f"that {listed(said)} all the time"
        case Aim.DO if wish.action is not None:
            return f"to {action_words(wish.action, lexicon)}"
        case Aim.NEVER_DO if wish.action is not None:
            return f"never to {action_words(wish.action, lexicon)}"
        case _:
            return plain(wish.formula, lexicon)


def plain(formula: Formula, lexicon: Lexicon) -> str:
    """A part of no simple form, as the formula's own English has it."""
    return say(formula, lexicon.landmarks).strip().rstrip(".")


def _places(wish: Wish, lexicon: Lexicon) -> bool:
    """Whether the wish is about where the robot that speaks is."""
    return bool(wish.atoms) and all(
        lexicon.clause(atom).subject == "I" and lexicon.place_clause(atom) for atom in wish.atoms
    )
