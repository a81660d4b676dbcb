"""Coefficients of linear thermal expansion of engineering materials near room temperature, in 1e-6/K.

Sources: (1) ISO 3650, 6.2.2, steel of gauge blocks near 20 deg C, +-1; (2) EN 10088-1, annex E, 20 to 100 deg C;
(3) CRC Handbook of Chemistry and Physics, pure metals at 25 deg C; (4) EN 1561, annex; (5) ASM Handbook vol. 2,
copper alloys 20 to 300 deg C, Fe-36Ni 20 to 100. Alloys of one name differ by several percent, plastics by far more:
these are stated by their own ``expansion``.
"""

from __future__ import annotations

EXPANSION: dict[str, float] = {
    "steel": 11.5,  # (1)
    "stainless steel": 16.0,  # (2) austenitic: 1.4301, 1.4401
    "ferritic stainless steel": 10.0,  # (2) 1.4016
    "martensitic stainless steel": 10.5,  # (2) 1.4021
    "duplex stainless steel": 13.0,  # (2) 1.4462
    "cast iron": 10.0,  # (4) grey
    "aluminium": 23.1,  # (3)
    "copper": 16.5,  # (3)
    "magnesium": 24.8,  # (3)
    "nickel": 13.4,  # (3)
    "titanium": 8.6,  # (3)
    "tungsten": 4.5,  # (3)
    "zinc": 30.2,  # (3)
    "brass": 19.9,  # (5) CuZn30
    "bronze": 18.2,  # (5) CuSn8
    "invar": 1.3,  # (5) Fe-36Ni
}
"""By name of the material."""
