"""An external PRP (planner for relevant policies) as the engine: optional, never a dependency.

PRP reads the compiled problem (`planning.compilation`) and dumps its policy; that is read back,
played over the product of the compiled problem from its first state, mapped to the original
problem, and validated there. Nothing that PRP says is believed without that.

The format is that of PRP 0.4, run as `prp DOMAIN PROBLEM --dump-policy 2`. In the folder where it
runs it leaves

    output       the preprocessed task: between `end_metric` and `begin_state` its variables, each
                 with its name and the fact that each value stands for
    policy.out   `If holds: var3:0 var1:1` and `Execute: move a b / SC / d=2`, or `Execute: goal /
                 SC / d=0`; SC for strong-cyclic, d for the distance to the goal
    policy.fsap  `If holds: ...` and `Forbid: move a b`: pairs that lead to a dead end

A state executes the rule that matches it, is not forbidden, is strong-cyclic if any is, and is
nearest to the goal; where all are forbidden, the nearest.

PRP is GPL-licensed C++ from the repository QuMuLab/planner-for-relevant-policies; its script `prp`
needs GNU time. This module is tested against the format only, with a program that writes it.

Source: Muise, McIlraith and Beck, Improved Non-deterministic Planning by Exploiting State
Relevance, ICAPS 2012; conditional effects after Muise, McIlraith and Belle, ICAPS 2014.
"""

from __future__ import annotations

import contextlib
import os
import re
import resource
import signal
import subprocess
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from plainspoken.errors import PlainspokenError
from plainspoken.logic.formula import Formula
from plainspoken.logic.syntax import unparse
from plainspoken.planning.compilation import Compiled, compiled
from plainspoken.planning.goal import problem_goal
from plainspoken.planning.policy import Policy
from plainspoken.planning.product import ActionIndex, Product, ProductState, product_of
from plainspoken.planning.solver import OutOfTime, Solved, policy_of
from plainspoken.planning.validation import Invalid, validate
from plainspoken.planning.watch import Seconds, Watch
from plainspoken.world.domain import Problem

MOST_MEMORY = 4 << 30
"""Bytes of address space for each process of PRP."""
MOST_SHOWN = 1_500
"""Characters of what PRP printed that an error repeats."""
_VARIABLE = re.compile(
    r"begin_variable\n(?P<name>\S+)\n-?\d+\n(?P<count>\d+)\n(?P<facts>.*?)\nend_variable", re.DOTALL
)
_RULE = re.compile(
    r"If holds:(?P<held>[^\n]*)\n(?:Execute|Forbid): *(?P<action>[^/\n]*?) *"
    r"(?:/ *(?P<kind>N?SC) */ *d=(?P<distance>\d+))?\n"
)


class PrpError(PlainspokenError):
    """PRP gave no policy that can be used; `printed` is the end of what it printed."""

    def __init__(self, what: str, printed: str = "", hint: str | None = None) -> None:
        self.printed = printed[-MOST_SHOWN:].strip()
        super().__init__(
            what, where=f"PRP printed:\n{self.printed}" if printed else None, hint=hint
        )


@dataclass(frozen=True, slots=True)
class PrpRule:
    """Where these atoms hold and those do not, an action; None at the goal."""

    positive: frozenset[str]
    negative: frozenset[str]
    action: str | None
    strong_cyclic: bool = True
    distance: int = 0


@dataclass(frozen=True, slots=True)
class PrpPolicy:
    rules: tuple[PrpRule, ...]
    forbidden: tuple[PrpRule, ...]


def solve_with_prp(
    problem: Problem,
    goal: Formula,
    prp: Path,
    *,
    timeout: Seconds | None = None,
    memory: int = MOST_MEMORY,
) -> Solved | OutOfTime:
    """Have PRP find a policy, and check it against the original problem and formula.

    timeout: None for PRP's own limit, half an hour
    raises PrpError: when it finds none, fails, or what it writes is no valid policy
    raises UnknownSymbolError, FormulaTooLargeError: as `planning.compilation.compiled` does
    """
    watch = Watch(timeout)
    made = compiled(problem, goal)
    compiling = watch.seconds
    with tempfile.TemporaryDirectory(prefix="plainspoken-prp-") as name:
        folder = Path(name)
        (folder / "domain.pddl").write_text(made.domain)
        (folder / "problem.pddl").write_text(made.problem)
        printed = _run(prp, folder, None if timeout is None else timeout - compiling, memory)
        if printed is None:
            return OutOfTime("PRP", watch.progress(0, 0, 0))
        found = read_prp_policy(folder, printed)
    seconds = {"ground": compiling, "automaton": 0.0, "search": watch.seconds - compiling}
    policy = _policy(made, found, printed, {**seconds, "total": watch.seconds})
    verdict = validate(problem, goal, policy)
    if isinstance(verdict, Invalid):
        raise PrpError(f"PRP's policy is not valid, at its node {verdict.node}: {verdict.reason}")
    return Solved(policy)


def _run(prp: Path, folder: Path, timeout: Seconds | None, memory: int) -> str | None:
    """What PRP prints; None where it runs out of time. Its whole process group ends with it."""
    log = folder / "printed.txt"
    with log.open("wb") as out:
        try:
            process = subprocess.Popen(  # noqa: S603 - the program that the user named
                [prp.absolute(), "domain.pddl", "problem.pddl", "--dump-policy", "2"],
                cwd=folder,
                stdin=subprocess.DEVNULL,
                stdout=out,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )
        except OSError as error:
            raise PrpError(
                f"cannot run PRP: {error.strerror}: {prp}",
                hint="--prp takes the path of its script src/prp, built by src/build_all",
            ) from error
        try:
            if hasattr(resource, "prlimit"):
                # Its children inherit the limit; where there is no prlimit, there is none.
                with contextlib.suppress(ProcessLookupError):
                    resource.prlimit(process.pid, resource.RLIMIT_AS, (memory, memory))
            process.wait(timeout)
        except subprocess.TimeoutExpired:
            return None
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    return log.read_text(errors="replace")


def read_prp_policy(folder: Path, printed: str = "") -> PrpPolicy:
    """The policy that PRP left in a folder.

    raises PrpError: when there is none, or it is not in the format
    """
    try:
        task = (folder / "output").read_text()
        rules = (folder / "policy.out").read_text()
    except OSError as error:
        what = "PRP found no policy" if "No solution" in printed else "PRP left no policy"
        raise PrpError(
            f"{what}: there is no {Path(str(error.filename)).name}",
            printed or "(nothing)",
            hint="run it on the files of `plainspoken export pddl` to see more",
        ) from error
    forbidden = folder / "policy.fsap"
    facts = dict(_facts(task))
    if not facts:
        raise PrpError("cannot read PRP's file output: it has no variables", task[:MOST_SHOWN])
    return PrpPolicy(
        tuple(_rules(rules, facts)),
        tuple(_rules(forbidden.read_text(), facts)) if forbidden.exists() else (),
    )


def _facts(task: str) -> Iterator[tuple[str, tuple[frozenset[str], frozenset[str]]]]:
    """Each `variable:value`, and the atoms that are true and false then."""
    section = task.partition("end_metric")[2].partition("begin_state")[0]
    for match in _VARIABLE.finditer(section):
        values = match["facts"].split("\n")
        atoms = [_atom(value) for value in values]
        for number, value in enumerate(values):
            true = {atoms[number]} if value.startswith("Atom ") else set[str]()
            # The values exclude each other: where one is true, all the others are false.
            false = {atom for atom in atoms if atom} - true
            yield f"{match['name']}:{number}", (frozenset(true), frozenset(false))


def _atom(fact: str) -> str:
    """`Atom p(a, b)`, `NegatedAtom p(a, b)` as `p a b`; the empty text for none of those."""
    match = re.fullmatch(r"(?:Negated)?Atom (?P<name>[^(]+)\((?P<arguments>.*)\)", fact)
    if match is None:
        return ""
    return " ".join([match["name"], *match["arguments"].replace(",", " ").split()])


def _rules(text: str, facts: dict[str, tuple[frozenset[str], frozenset[str]]]) -> Iterator[PrpRule]:
    if text.count("If holds:") != len(_RULE.findall(text + "\n")):
        raise PrpError("cannot read PRP's policy: it is not in the format of 0.4", text[:500])
    for match in _RULE.finditer(text + "\n"):
        positive, negative = frozenset[str](), frozenset[str]()
        for word in match["held"].split():
            if word not in facts:
                raise PrpError(f"PRP's policy speaks of {word}, which its file output has not")
            positive |= facts[word][0]
            negative |= facts[word][1]
        yield PrpRule(
            positive,
            negative,
            None if match["action"] == "goal" else match["action"].lower(),
            match["kind"] != "NSC",
            int(match["distance"] or 0),
        )


@dataclass(frozen=True, slots=True)
class _Masks:
    """A rule in the bits of the compiled problem's product."""

    positive: int
    negative: int
    rule: PrpRule

    def matches(self, state: ProductState) -> bool:
        return state & self.positive == self.positive and not state & self.negative


def _masks(rules: tuple[PrpRule, ...], product: Product) -> list[_Masks]:
    """The rules that can match at all."""
    task = product.task
    bits = {atom: 1 << bit for bit, atom in enumerate(task.atoms)}
    true = task.always | task.static
    return [
        _Masks(
            sum(bits.get(atom, 0) for atom in rule.positive),
            sum(bits.get(atom, 0) for atom in rule.negative),
            rule,
        )
        for rule in rules
        if rule.positive <= bits.keys() | true and not rule.negative & true
    ]


def _policy(made: Compiled, found: PrpPolicy, printed: str, seconds: dict[str, Seconds]) -> Policy:
    """Play PRP's rules from the first state, over every outcome."""
    read = made.read()
    product = product_of(read, problem_goal(read))
    rules, forbidden = _masks(found.rules, product), _masks(found.forbidden, product)
    numbers = {action.name: i for i, action in enumerate(product.actions)}
    choice: dict[ProductState, ActionIndex] = {}
    order, seen = [product.initial], {product.initial}
    for state in order:
        if product.is_goal(state):
            continue
        name = _chosen(state, rules, forbidden)
        after = product.successors(state, numbers[name]) if name in numbers else ()
        if name is None or not after:
            what = "has no rule" if name is None else f"wants {name!r}, which is not applicable,"
            atoms = ", ".join(sorted(product.task.state(state)))
            raise PrpError(f"PRP's policy {what} where this holds: {atoms}", printed)
        choice[state] = numbers[name]
        new = [state for state in after if state not in seen]
        seen.update(new)
        order += new
    return made.original(policy_of(product, choice, "strong-cyclic", unparse(made.goal), seconds))


def _chosen(state: ProductState, rules: list[_Masks], forbidden: list[_Masks]) -> str | None:
    """The action of the rule that PRP would follow."""
    matching = [each.rule for each in rules if each.rule.action and each.matches(state)]
    refused = {each.rule.action for each in forbidden if each.matches(state)}
    allowed = [rule for rule in matching if rule.action not in refused] or matching
    if not allowed:
        return None
    return min(allowed, key=lambda rule: (not rule.strong_cyclic, rule.distance)).action
