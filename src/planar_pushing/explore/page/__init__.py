"""The page: Bokeh's figures and widgets, and what joins them to the state."""
