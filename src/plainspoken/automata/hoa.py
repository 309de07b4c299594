"""Automata in the Hanoi Omega-Automata format, for other tools and for drawing.

The format is about infinite words; as other finite-word tools do, we write the accepting states
as `Acceptance: 1 Inf(0)` and say in the header that a *finite* word is accepted when it ends in
one of them.

Source: Babiak et al., The Hanoi Omega-Automata Format, CAV 2015.
"""

from __future__ import annotations

from plainspoken.automata.construction import Automaton, Guard
from plainspoken.logic.syntax import unparse


def hoa(automaton: Automaton) -> str:
    """One automaton, explored to the end; its state 0 has read nothing."""
    automaton.can_accept(automaton.initial)  # explores, and so numbers, every state
    body = []
    count = 0
    while count < len(automaton):
        mark = " {0}" if automaton.accepts(count) else ""
        body.append(f'State: {count} "{unparse(automaton.residual(count))}"{mark}')
        body += [
            f"[{_label(guard, automaton.atoms)}] {guard.target}"
            for guard in automaton.guards(count)
        ]
        count += 1
    names = "".join(f' "{atom}"' for atom in automaton.atoms)
    header = [
        "HOA: v1",
        'tool: "plainspoken"',
        f'name: "{unparse(automaton.formula)}"',
        f"States: {count}",
        f"Start: {automaton.initial}",
        f"AP: {len(automaton.atoms)}{names}",
        "acc-name: Buchi",
        "Acceptance: 1 Inf(0)",
        "properties: explicit-labels state-acc deterministic complete",
        'finite-words: "accepted when they end in an accepting state"',
    ]
    return "\n".join([*header, "--BODY--", *body, "--END--"]) + "\n"


def _label(guard: Guard, atoms: tuple[str, ...]) -> str:
    literals = [
        f"{'' if atom in guard.positive else '!'}{index}"
        for index, atom in enumerate(atoms)
        if atom in guard.positive or atom in guard.negative
    ]
    return " & ".join(literals) or "t"
