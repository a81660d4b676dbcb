"""Plate cams: followers, exact profiles, and what is to be said of them.

Everything is a function of the cam angle theta (rad), which grows in the sense in which the cam turns. The fixed frame
has its origin at the cam's centre; the cam's frame is turned by ``sense * theta`` against it, ``sense`` being +1 for a
cam that turns counter-clockwise, -1 clockwise. A prime is d/d(theta). Lengths are in m, lifts in m or rad.
"""
