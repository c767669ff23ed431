class PlotError(Exception):
    """A mistake in the input, told in one line that names the file and what would be right."""
