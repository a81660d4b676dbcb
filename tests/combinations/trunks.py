"""What several mechanisms of the matrix have in common, as text of model files."""

from __future__ import annotations

HEAD = "units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}\ngravity: earth\n"
FOUR_BAR = """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame:   {points: {A: [0, 0], D: [100, 0]}}
  crank:   {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  coupler: {points: {B: [0, 0], C: [90, 0], E: [45, 25]}, mass: 0.8, com: [45, 5], inertia: 900}
  rocker:  {points: {D: [0, 0], C: [70, 0]}, mass: 0.6, shape: rod D-C}
assembly: {C: left of B-D}
"""
SLIDER_CRANK = """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame:  {points: {A: [0, 0], F: [0, 8]}}
  crank:  {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  rod:    {points: {B: [0, 0], C: [90, 0]}, mass: 0.8, shape: rod B-C}
  slider: {points: {C: [0, 0]}, mass: 1.2, shape: point C}
joints:
  guide: {prismatic: [frame, slider], line: [F at 0 deg, C at 0 deg]}
assembly: {C: ahead of B along guide}
"""
TWO_WHEELS = """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], Q: [120, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 0.5, shape: rod A-B}
  wheel: {points: {Q: [0, 0], T: [50, 0]}, mass: 2, shape: rod Q-T}
"""
"""Two links pinned to the frame, for what ties one to the other."""
CAM = """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], S: [10, 90], Q: [130, 0]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 2, shape: disc 60 mm at A}
  lever: {points: {Q: [0, 0], C: [110, 0], H: [60, 0], K: 110 at 100 deg}, mass: 1, shape: rod Q-C}
springs: {closing: {from: H, to: S, stiffness: 4 N/mm, free: 20}}
laws:
  lift:
    over: angle
    of: angle
    segments:
      - {rise: 14, over: 140, law: modified_sine}
      - {dwell: 40}
      - {fall: 14, over: 140, law: modified_sine}
      - {dwell: 40}
"""
TAPPET = """
parameters: {r: {value: 30, tolerance: 0.05}}
links:
  frame: {points: {A: [0, 0], G: [4, 0], S: [4, 200]}}
  crank: {points: {A: [0, 0], B: [r, 0]}, mass: 2, shape: disc 60 mm at A}
  tappet: {points: {C: [0, 0], H: [0, 40], K: [0, 5]}, mass: 1, shape: point C}
joints: {guide: {prismatic: [frame, tappet], line: [G at 90 deg, C at 90 deg]}}
springs: {closing: {from: H, to: S, stiffness: 2 N/mm, free: 100, preload: 60}}
laws:
  lift:
    over: angle
    of: length
    segments:
      - {rise: 12, over: 140, law: cycloidal}
      - {dwell: 40}
      - {fall: 12, over: 140, law: cycloidal}
      - {dwell: 40}
"""
