"""The cam study: a plate cam held against limits, sized, drawn, milled, and the NC code proven."""
