"""Attacks on a jostle-server with honest players connected. scripts/attack-check runs them; arena.py describes the procedure."""
