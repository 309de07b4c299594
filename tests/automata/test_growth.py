"""Formulas that make other constructions explode stay small, in time and in memory."""

from __future__ import annotations

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "automata.py"
SPEC = spec_from_file_location("benchmark_of_automata", SCRIPT)
assert SPEC is not None
assert SPEC.loader is not None
benchmark = module_from_spec(SPEC)
sys.modules[SPEC.name] = benchmark  # where dataclasses look their module up
SPEC.loader.exec_module(benchmark)


@pytest.mark.parametrize("formula", benchmark.FORMULAS.values(), ids=benchmark.FORMULAS)
def test_an_automaton_takes_less_than_a_second_and_200_megabytes(formula: str) -> None:
    size = benchmark.measured(formula)
    assert size.process_seconds < benchmark.SECONDS
    assert size.megabytes < benchmark.MEGABYTES
    assert size.states <= 60
