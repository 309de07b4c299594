"""A policy as a tree of words: one line an action, a branch for each way it may turn out."""

from __future__ import annotations

from rich.text import Text
from rich.tree import Tree

from plainspoken.planning.diagram import PolicyOutcome, outcomes
from plainspoken.planning.policy import NodeId, Policy, PolicyNode
from plainspoken.questions.lexicon import Lexicon

MOST_LINES = 30
"""Actions that are shown; a larger policy is cut there."""


def policy_tree(policy: Policy, lexicon: Lexicon) -> Tree:
    """Each state is shown once; where it comes up again, the tree says so."""
    tree = Tree(Text("start", style="bold"))
    seen: dict[NodeId, int] = {}
    stack = [(tree, policy.node(policy.initial))]
    while stack:
        branch, node = stack.pop()
        if node.id in seen:
            branch.add(Text(f"↺ as at step {seen[node.id]}", style="dim"))
            continue
        if node.action is None:
            branch.add(Text("done", style="bold green"))
            continue
        if len(seen) == MOST_LINES:
            branch.add(Text("…", style="dim"))
            continue
        seen[node.id] = len(seen) + 1
        line = branch.add(Text.assemble((f"{seen[node.id]:>2} ", "dim"), _deed(node, lexicon)))
        after = outcomes(policy, node)
        if len(after) == 1:
            # The next action of a chain stands below, not inside: depth is for choices.
            stack.append((branch, after[0].node))
            continue
        named_first = sorted(after, key=lambda one: not (one.added or one.deleted))
        branches = [
            (line.add(Text(_said(outcome, lexicon), style="cyan")), outcome.node)
            for outcome in named_first
        ]
        stack.extend(reversed(branches))
    return tree


def _deed(node: PolicyNode, lexicon: Lexicon) -> str:
    return lexicon.deed(node.action).bare if node.action else ""


def _said(outcome: PolicyOutcome, lexicon: Lexicon) -> str:
    said = [lexicon.clause(atom).said() for atom in outcome.added]
    said = said or [lexicon.clause(atom).said(negative=True) for atom in outcome.deleted]
    return "if " + " and ".join(said) if said else "otherwise"
