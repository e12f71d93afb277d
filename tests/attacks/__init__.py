"""Attacks on a jostle-server, each beside honest players. scripts/attack-check runs them; arena.py says how one goes."""
