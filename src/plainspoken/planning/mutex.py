"""Groups of bits of which at most one is ever set.

Candidates are the atoms of one predicate that agree in all arguments but one (or none); they are
kept where the initial state has one of them at most, and each outcome that sets one clears one
that its test asked for. The states of an automaton are a group by construction.
"""

from __future__ import annotations

from collections.abc import Iterator

from plainspoken.planning.task import Bits, Outcome, Task, Variant, ones


def mutex_groups(task: Task) -> tuple[Bits, ...]:
    """Masks of groups of two bits or more, of which at most one is set in any reachable state."""
    groups: dict[tuple[str, ...], Bits] = {}
    keys_of: list[list[tuple[str, ...]]] = []
    for bit, atom in enumerate(task.atoms):
        predicate, *arguments = atom.split()
        keys = [(predicate, *arguments[:i], "", *arguments[i + 1 :]) for i in range(len(arguments))]
        keys_of.append(keys)
        for key in keys:
            groups[key] = groups.get(key, 0) | 1 << bit
    groups = {
        key: mask
        for key, mask in groups.items()
        if mask & (mask - 1) and (task.initial & mask).bit_count() <= 1
    }
    for action in task.actions:
        for variant in action.variants:
            for outcome in variant.outcomes:
                for key in _broken(variant, outcome, keys_of, groups):
                    groups.pop(key, None)
        if not groups:
            break
    return tuple(dict.fromkeys(groups.values()))


def _broken(
    variant: Variant,
    outcome: Outcome,
    keys_of: list[list[tuple[str, ...]]],
    groups: dict[tuple[str, ...], Bits],
) -> Iterator[tuple[str, ...]]:
    """The groups of which an outcome may set one more than it clears."""
    required = variant.requirement.mask
    for bit in ones(outcome.add & ~required):
        if bit >= len(keys_of):
            break
        for key in keys_of[bit]:
            mask = groups.get(key)
            if mask is not None and (
                not required & outcome.delete & mask or (outcome.add & mask).bit_count() > 1
            ):
                yield key
    for change in outcome.changes:
        for bit in ones(change.add):
            if bit < len(keys_of):
                yield from keys_of[bit]


def exclusions(task: Task) -> list[Bits]:
    """For each bit of an atom, the bits that cannot be set together with it."""
    found = [0] * len(task.atoms)
    for group in mutex_groups(task):
        for bit in ones(group):
            found[bit] |= group & ~(1 << bit)
    return found
