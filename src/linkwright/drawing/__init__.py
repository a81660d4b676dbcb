"""Still pictures as SVG: axes and their curves, places of the plane, colours, pictures beside each other."""
