"""Formulas read one instant at a time: progression, small automata on demand, running verdicts."""
