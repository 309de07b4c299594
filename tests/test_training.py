"""The corpus that the reader learned from is what its page says, and what is held out stays out."""

import ast
import json
from pathlib import Path

import pytest

from plainspoken.logic.formula import atoms
from plainspoken.logic.syntax import parse
from plainspoken.world.landmark import Landmarks, read_landmarks

ROOT = Path(__file__).parents[1]
CORPUS = ROOT / "training" / "corpus"
FILES = sorted(CORPUS.glob("*/*.jsonl"))


def constant(file: str, name: str) -> object:
    """The value of a constant in a script that cannot be imported without PyTorch."""
    tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
    found = [
        node.value
        for node in tree.body
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", None) == name
    ]
    return ast.literal_eval(found[0])


def test_what_is_measured_is_what_was_held_out_of_training() -> None:
    held_out = constant("training/train.py", "HELD_OUT")
    assert held_out == constant("benchmarks/reader.py", "HELD_OUT")
    assert isinstance(held_out, tuple)
    for name in held_out:
        folder, domain = name.split("/")
        assert (CORPUS / folder / f"landmarks-{domain}.json").exists()


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_every_row_has_a_formula_over_its_landmarks_or_a_reason_for_none(path: Path) -> None:
    known: dict[str, Landmarks] = {}
    seen = set()
    for line in path.read_text(encoding="utf-8").splitlines():
        row = json.loads(line)
        domain = row["domain"]
        if domain not in known:
            known[domain] = read_landmarks(path.parent / f"landmarks-{domain}.json")
        assert (domain, row["utterance"]) not in seen
        seen.add((domain, row["utterance"]))
        if path.stem == "impossible":
            assert row["why"]
            continue
        for reading in ("literal", "formula"):
            assert atoms(parse(row[reading])) <= set(known[domain])


def test_every_folder_of_the_corpus_is_on_its_page() -> None:
    page = (ROOT / "training" / "README.md").read_text(encoding="utf-8")
    for folder in CORPUS.iterdir():
        assert f"| `{folder.name}` |" in page
