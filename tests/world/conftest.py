"""Domains and problems written in a test, read from files as everywhere else."""

from collections.abc import Callable
from pathlib import Path

import pytest

from plainspoken.world.domain import Domain, Problem
from plainspoken.world.pddl import read_domain, read_problem

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def domain_of(tmp_path: Path) -> Callable[[str], Domain]:
    """Read a domain from its text, written to domain.pddl in the test's folder."""

    def read(text: str) -> Domain:
        path = tmp_path / "domain.pddl"
        path.write_text(text, encoding="utf-8")
        return read_domain(path)

    return read


@pytest.fixture
def problem_of(tmp_path: Path, domain_of: Callable[[str], Domain]) -> Callable[[str, str], Problem]:
    """Read a domain and a problem from their texts."""

    def read(domain: str, problem: str) -> Problem:
        path = tmp_path / "problem.pddl"
        path.write_text(problem, encoding="utf-8")
        return read_problem(path, domain_of(domain))

    return read


@pytest.fixture(scope="session")
def vineyard() -> Problem:
    """The bundled example."""
    folder = ROOT / "examples" / "vineyard"
    return read_problem(folder / "problem.pddl", read_domain(folder / "domain.pddl"))
