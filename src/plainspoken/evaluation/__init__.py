"""Experiments: corpora, runs with named outcomes, tables and pictures."""
