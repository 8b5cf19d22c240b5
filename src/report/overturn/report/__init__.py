"""Figures and pages: each script's draw(data, path) draws what the program hands it as JSON."""
