"""The README shows what its commands print."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def documents() -> ModuleType:
    spec = importlib.util.spec_from_file_location("documents", ROOT / "tools" / "documents.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_readme_shows_what_its_commands_print(documents: ModuleType) -> None:
    text = (ROOT / "README.md").read_text()
    assert documents.BLOCK.search(text)
    assert documents.is_true(text), "python tools/documents.py writes it anew"


def test_a_document_that_shows_something_else_is_found_out(documents: ModuleType) -> None:
    text = "<!-- made by: plainspoken --version -->\n```text\nnothing\n```\n<!-- end -->"
    assert not documents.is_true(text)
    assert documents.is_true(documents.rewritten(text))
