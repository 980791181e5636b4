"""Figures on the computation itself and on measured pushes."""
