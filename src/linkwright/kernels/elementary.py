"""Elementary functions without branches, for kernels that are compiled to machine code.

A compiler turns a loop over poses into vector instructions only where each step is straight-line arithmetic; calls of
the C library's functions stay one pose at a time. Each function here is a plain Python function of floats made of
double arithmetic, square roots, selects (``a if c else b`` of values already there) and three that look at a double's
bits. So Python can run it as its own twin, to the same bits, and emitters can write it out from its text
(:mod:`linkwright.kernels.straight_line`). No compiler may fuse or reorder anything of it.

NaN in gives NaN out, but for ``fmin`` and ``fmax``. The sign of a zero has no meaning. The tests allow
errors of 1 to 1.75 units in the last place; ``python tests/kernels/test_elementary.py 20000`` finds up to 1.24 (atan2),
1.21 (tan), 1.17 (atan), 1.14 (hypot), 1.12 (acos), 0.84 (exp), 0.76 (sin), 0.75 (log), 0.74 (cos), 0.69 (asin).

Sources: W. J. Cody, W. Waite, Software Manual for the Elementary Functions, Prentice-Hall 1980 (reduction in parts);
S. L. Moshier, Cephes Mathematical Library (minimax forms of sine and cosine); Sun Microsystems, fdlibm 5.3 (minimax
forms of arc tangent, arc sine, exponential and logarithm; correction terms).
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

FARTHEST = 1.0e8
"""Angles beyond this many radians have no sine: 2/pi of it, an integer of 26 bits, times a part of pi/2 is exact."""

ROUNDER = 6755399441055744.0
"""1.5 * 2**52: added and taken away again it rounds to an integer; added, its low bits are that integer."""


# Angles.


def _quadrant(x: float) -> tuple[float, float, float]:
    """x = (quadrant + whole turns) pi/2 + r + tail, with |r| <= pi/4 and quadrant 0, 1, 2 or 3; NaN beyond FARTHEST.

    Cody and Waite's reduction: pi/2 in three parts of 25 bits, whose products with n are exact, and a fourth.
    The first two differences are exact too, the third one's error goes to ``tail``. No double in the range is nearer
    than 2**-61 to a multiple of pi/2 (45.553093477052 is the nearest), so r keeps its digits.
    """
    # n = round(2 x / pi); adding and subtracting ROUNDER rounds without a call.
    n = (x * 0.6366197723675814 + ROUNDER) - ROUNDER if math.fabs(x) <= FARTHEST else math.nan
    # Subtract n pi/2 in parts, from the largest; these differences are exact.
    near = (x - n * 1.5707963109016418) - n * 1.5893254712295857e-08
    third = n * 6.123233932053594e-17
    less = near - third
    # What the third difference lost, and the fourth part of pi/2.
    rest = ((near - less) - third) - n * 6.36831716351095e-25
    r = less + rest
    tail = (less - r) + rest
    # Reduce n to the quadrant 0 .. 3.
    turns = (0.25 * (n - 1.5) + ROUNDER) - ROUNDER
    return n - 4.0 * turns, r, tail


def _sine(r: float, tail: float) -> tuple[float, float]:
    """Sine of r + tail, |r| <= pi/4 (Cephes), and what its last rounding took away."""
    z = r * r
    # Minimax polynomial of (sin r - r) / r^3 in r^2, by Horner's scheme.
    p = 1.58962301576546568060e-10 * z - 2.50507477628578072866e-8
    p = (p * z + 2.75573136213857245213e-6) * z - 1.98412698295895385996e-4
    p = (p * z + 8.33333333332211858878e-3) * z - 1.66666666666666307295e-1
    # The correction to r: the polynomial, and the tail by the slope cos r = 1 - r^2 / 2.
    more = r * z * p + tail * (1.0 - 0.5 * z)
    s = r + more
    return s, (r - s) + more


def _cosine(r: float, tail: float) -> tuple[float, float]:
    """Cosine of r + tail, |r| <= pi/4 (Cephes), and what its last rounding took away."""
    z = r * r
    # Minimax polynomial of (cos r - 1 + r^2 / 2) / r^4.
    p = -1.13585365213876817300e-11 * z + 2.08757008419747316778e-9
    p = (p * z - 2.75573141792967388112e-7) * z + 2.48015872888517045348e-5
    p = (p * z - 1.38888888888730564116e-3) * z + 4.16666666666665929218e-2
    half = 0.5 * z
    w = 1.0 - half
    # What the rounding of 1 - r^2 / 2 lost comes back with the higher terms.
    more = ((1.0 - w) - half) + (z * z * p - r * tail)
    c = w + more
    return c, (w - c) + more


def sin(x: float) -> float:
    """Sine; NaN beyond FARTHEST."""
    quadrant, r, tail = _quadrant(x)
    s, _ = _sine(r, tail)
    c, _ = _cosine(r, tail)
    value = c if math.fabs(quadrant - 2.0) == 1.0 else s
    return -value if quadrant > 1.5 else value


def cos(x: float) -> float:
    """Cosine; NaN beyond FARTHEST. Beside ``sin`` of the same angle it costs little: all but the selects is shared."""
    quadrant, r, tail = _quadrant(x)
    s, _ = _sine(r, tail)
    c, _ = _cosine(r, tail)
    value = s if math.fabs(quadrant - 2.0) == 1.0 else c
    return -value if math.fabs(quadrant - 1.5) < 1.0 else value


def tan(x: float) -> float:
    """Tangent; NaN beyond FARTHEST. The quotient q = s / c or -c / s is corrected by what the roundings of s and c
    took away; for that a straight line is good enough as 1 / c.
    """
    quadrant, r, tail = _quadrant(x)
    s, off_s = _sine(r, tail)
    c, off_c = _cosine(r, tail)
    odd = math.fabs(quadrant - 2.0) == 1.0
    above = -c if odd else s
    below = s if odd else c
    # Quotient first, then one correction by what the roundings of both had taken away.
    q = above / below
    inverse = 2.4 - 1.41 * c
    return q + ((off_c + q * off_s) * q if odd else off_s - q * off_c) * inverse


def _arc(low: float, high: float) -> float:
    """The angle whose tangent is low / high, 0 <= low <= high: 0 to pi/4 (fdlibm's minimax form of the arc tangent).

    tan(a - b) = (low - high tan b) / (high + low tan b) with tan b = 0, 1/2 or 1, whichever is near: the numerator is
    exact. Very large and very small pairs are scaled by a power of two first.
    """
    scale = 0.25 if high > 1.0e300 else (1.2676506002282294e30 if high < 1.0e-290 else 1.0)
    low = low * scale
    high = high * scale
    # Choose b with tan b = 0, 1/2 or 1, whichever is nearest to the quotient.
    small = low <= 0.4375 * high
    middle = low <= 0.6875 * high
    above = low - (0.0 if small else (0.5 * high if middle else high))
    below = high + (0.0 if small else (0.5 * low if middle else low))
    t = above / (below if below != 0.0 else 1.0)
    z = t * t
    # Minimax polynomial of the arc tangent for the small rest t.
    p = 1.62858201153657823623e-02 * z - 3.65315727442169155270e-02
    p = (p * z + 4.97687799461593236017e-02) * z - 5.83357013379057348645e-02
    p = (p * z + 6.66107313738753120669e-02) * z - 7.69187620504482999495e-02
    p = (p * z + 9.09088713343650656196e-02) * z - 1.11111104054623557880e-01
    p = (p * z + 1.42857142725034663711e-01) * z - 1.99999999998764832476e-01
    p = (p * z + 3.33333333333329318027e-01) * z
    # Add the angle b, whose low part is kept in fine.
    start = 0.0 if small else (0.4636476090008061 if middle else 0.7853981633974483)
    fine = 0.0 if small else (2.2698777452961687e-17 if middle else 3.061616997868383e-17)
    return start + (t - (t * p - fine))


def atan(x: float) -> float:
    """Arc tangent, -pi/2 to pi/2."""
    size = math.fabs(x)
    steep = size > 1.0
    a = _arc(1.0 if steep else size, size if steep else 1.0)
    value = 1.5707963267948966 - (a - 6.123233995736766e-17) if steep else a
    return value if x >= 0.0 else -value


def atan2(y: float, x: float) -> float:
    """Angle of the vector (x, y), -pi to pi; 0 for (0, 0), NaN where both are infinite.

    On the negative x axis it is +pi for either zero as y: compiled code may drop the sign of a zero.
    """
    wide = math.fabs(x)
    tall = math.fabs(y)
    # Divide the smaller by the larger component: an angle of at most pi/4.
    steep = tall > wide
    a = _arc(wide if steep else tall, tall if steep else wide)
    left = x < 0.0
    # Unfold into the right octant by selects.
    start = 1.5707963267948966 if steep else (3.141592653589793 if left else 0.0)
    fine = 6.123233995736766e-17 if steep else (1.2246467991473532e-16 if left else 0.0)
    falling = -a
    value = start + (((a if left else falling) if steep else (falling if left else a)) + fine)
    return value if y >= 0.0 else -value


def _arc_sine(z: float) -> tuple[float, float]:
    """p and q with asin s = s + s p / q, z = s**2 <= 1/4 (fdlibm)."""
    p = 3.47933107596021167570e-05 * z + 7.91534994289814532176e-04
    p = (p * z - 4.00555345006794114027e-02) * z + 2.01212532134862925881e-01
    p = ((p * z - 3.25565818622400915405e-01) * z + 1.66666666666666657415e-01) * z
    q = 7.70381505559019352791e-02 * z - 6.88283971605453293030e-01
    q = ((q * z + 2.02094576023350569471e00) * z - 2.40339491173441421878e00) * z + 1.0
    return p, q


def asin(x: float) -> float:
    """Arc sine; NaN beyond -1 and 1. From 1/2 on pi/2 - 2 asin s with s = sqrt((1 - x) / 2) = head + loss / (s + head).

    The head has 27 bits, so its square is exact (Dekker's split).
    """
    size = math.fabs(x)
    steep = size > 0.5
    # For large arguments use the half angle, where the arc sine is well conditioned.
    half = 0.5 - 0.5 * size
    z = (half if half > 0.0 else 0.0) if steep else size * size
    s = math.sqrt(z) if steep else size
    p, q = _arc_sine(z)
    # Split s, so that the error of the square root can be recovered.
    long = s * 134217729.0
    split = long - (long - s)
    head = split if steep else s
    loss = z - split * split if steep else 0.0
    both = s + head if (steep & (s > 0.0)) else 1.0
    rest = (loss * q + s * p * both) / (q * both)
    start = 1.5707963267948966 - 2.0 * head
    fine = (1.5707963267948966 - start) - 2.0 * head
    value = start + (fine - (2.0 * rest - 6.123233995736766e-17)) if steep else head + rest
    value = value if size <= 1.0 else math.nan
    return value if x >= 0.0 else -value


def acos(x: float) -> float:
    """Arc cosine, 0 to pi; NaN beyond -1 and 1. From 1/2 on acos x = 2 asin sqrt((1 - x) / 2)."""
    size = math.fabs(x)
    steep = size > 0.5
    half = 0.5 - 0.5 * size
    z = (half if half > 0.0 else 0.0) if steep else size * size
    s = math.sqrt(z) if steep else x
    p, q = _arc_sine(z)
    rest = s * p / q
    twice = 2.0 * (s + rest)
    flat = 1.5707963267948966 - (s - (6.123233995736766e-17 - rest))
    value = (twice if x > 0.0 else 3.141592653589793 - (twice - 1.2246467991473532e-16)) if steep else flat
    return value if size <= 1.0 else math.nan


# What is read from a number's bits; emitters have their own words for these three.


def power_of_two(raised: float) -> float:
    """2**n from ROUNDER + n, -1022 <= n <= 1023: the low bits of that sum become the exponent."""
    return float(np.int64((np.float64(raised).view(np.int64) + 1023) << 52).view(np.float64))


def binary_exponent(x: float) -> float:
    """n of x = 2**n (1 + f) with 1 + f between sqrt(1/2) and sqrt(2); x is positive, finite and not subnormal."""
    bits = np.float64(x).view(np.int64) + 0x95F619980C433
    return float(np.int64((bits >> 52) | 0x4330000000000000).view(np.float64)) - 4503599627371519.0


def binary_fraction(x: float) -> float:
    """f of the same."""
    bits = np.float64(x).view(np.int64) + 0x95F619980C433
    return float(np.int64((bits & 0xFFFFFFFFFFFFF) + 0x3FE6A09E667F3BCD).view(np.float64)) - 1.0


# Powers of e.


def exp(x: float) -> float:
    """e to the x."""
    return _exp_of_sum(x, 0.0)


def _exp_of_sum(x: float, tail: float) -> float:
    """e to the x + tail (fdlibm's form; the scaling by 2**n in two steps, so that results below 2**-1022 are rounded
    once)."""
    # Clamp to the range in which the result is neither 0 nor infinite.
    held = x if x < 710.0 else 710.0
    held = held if held > -746.0 else -746.0
    # x = n ln 2 + r; ln 2 in two parts, so that r keeps its digits.
    raised = held * 1.4426950408889634 + ROUNDER
    n = raised - ROUNDER
    high = held - n * 6.93147180369123816490e-01
    low = n * 1.90821492927058770002e-10 - (tail if held == x else 0.0)
    r = high - low
    # Rational form of exp r.
    z = r * r
    p = 4.13813679705723846039e-08 * z - 1.65339022054652515390e-06
    p = (p * z + 6.61375632143793436117e-05) * z - 2.77777777770155933842e-03
    c = r - (p * z + 1.66666666666666019037e-01) * z
    value = 1.0 - ((low - (r * c) / (2.0 - c)) - high)
    # Multiply by 2^n in two factors, written straight into the exponent bits.
    half = 0.5 * n + ROUNDER
    other = (n - (half - ROUNDER)) + ROUNDER
    return value * power_of_two(half) * power_of_two(other) if x == x else x


def log(x: float) -> float:
    """Natural logarithm (fdlibm's form): -inf at 0, NaN below."""
    # Scale subnormal numbers up; invalid ones become 1 and are replaced at the end.
    tiny = x < 2.2250738585072014e-308
    held = x * 1.8014398509481984e16 if tiny else x
    held = held if (x > 0.0) & (x < math.inf) else 1.0
    n = binary_exponent(held) - (54.0 if tiny else 0.0)
    f = binary_fraction(held)
    # Series of log((1 + s) / (1 - s)) = log(1 + f).
    s = f / (2.0 + f)
    z = s * s
    p = 1.479819860511658591e-01 * z + 1.531383769920937332e-01
    p = (p * z + 1.818357216161805012e-01) * z + 2.222219843214978396e-01
    p = (p * z + 2.857142874366239149e-01) * z + 3.999999999940941908e-01
    p = (p * z + 6.666666666666735130e-01) * z
    half = 0.5 * f * f
    value = n * 6.93147180369123816490e-01 - ((half - (s * (half + p) + n * 1.90821492927058770002e-10)) - f)
    value = value if x < math.inf else x
    return value if x > 0.0 else (-math.inf if x == 0.0 else math.nan)


def _product(x: float, y: float) -> tuple[float, float]:
    """A product and what its rounding took away (Dekker)."""
    long_x = x * 134217729.0
    head_x = long_x - (long_x - x)
    tail_x = x - head_x
    long_y = y * 134217729.0
    head_y = long_y - (long_y - y)
    tail_y = y - head_y
    p = x * y
    return p, ((head_x * head_y - p) + head_x * tail_y + tail_x * head_y) + tail_x * tail_y


def _sum(x: float, y: float) -> tuple[float, float]:
    """A sum and what its rounding took away (Knuth)."""
    s = x + y
    part = s - x
    return s, (x - (s - part)) + (y - part)


def _long_log(x: float) -> tuple[float, float]:
    """Natural logarithm of x > 0 in two numbers, to 64 bits: n ln 2 + 2 s + 2/3 s**3 + ... with s = f / (2 + f)."""
    tiny = x < 2.2250738585072014e-308
    held = x * 1.8014398509481984e16 if tiny else x
    n = binary_exponent(held) - (54.0 if tiny else 0.0)
    f = binary_fraction(held)
    # s in two numbers; so 2 + f has to be.
    d = 2.0 + f
    rest_d = f - (d - 2.0)
    s = f / d
    back, off = _product(s, d)
    rest_s = (((f - back) - off) - s * rest_d) / d
    # 2/3 s**3 in two numbers.
    z, off_z = _product(s, s)
    rest_z = off_z + 2.0 * s * rest_s
    cube, off_cube = _product(s, z)
    rest_cube = off_cube + (s * rest_z + rest_s * z)
    third, off_third = _product(cube, 0.6666666666666666)
    rest_third = off_third + (cube * 3.700743415417188e-17 + rest_cube * 0.6666666666666666)
    # The others: 2/5 s**5 + 2/7 s**7 + ...
    p = (0.08 * z + 0.08695652173913043) * z + 0.09523809523809523
    p = (p * z + 0.10526315789473684) * z + 0.11764705882352941
    p = (p * z + 0.13333333333333333) * z + 0.15384615384615385
    p = (p * z + 0.18181818181818182) * z + 0.2222222222222222
    p = (p * z + 0.2857142857142857) * z + 0.4
    more = cube * z * p
    # Add them, the largest first; n times the long part of ln 2 is exact.
    first, off_first = _sum(n * 6.93147180369123816490e-01, 2.0 * s)
    second, off_second = _sum(first, third)
    low = off_first + (off_second + (more + (rest_third + (2.0 * rest_s + n * 1.90821492927058770002e-10))))
    value = second + low
    return value, (second - value) + low


def power(x: float, y: float) -> float:
    """x to the y, as e to the y log |x|; NaN for a negative x unless y is whole. As in C, x**0 and 1**y are 1 for all.

    0 to a negative power is inf; the sign of a zero has no say.
    """
    size = math.fabs(x)
    some = (size > 0.0) & (size < math.inf)
    # Beyond 1e20 any power of what isn't 1 is 0 or infinite.
    held = y if y < 1.0e20 else 1.0e20
    held = held if held > -1.0e20 else -1.0e20
    log_x, rest = _long_log(size if some else 1.0)
    p, off = _product(held, log_x)
    value = _exp_of_sum(p, off + held * rest)
    rising = y > 0.0
    falling = y < 0.0
    value = value if some else (math.inf if ((size > 0.0) & rising) | ((size == 0.0) & falling) else 0.0)
    # The sign, and whether there is a value: adding 2**52 rounds to an integer.
    count = math.fabs(y)
    half = 0.5 * count
    whole = ((count + 4503599627370496.0) - 4503599627370496.0 == count) | (count >= 4503599627370496.0)
    even = ((half + 4503599627370496.0) - 4503599627370496.0 == half) | (half >= 4503599627370496.0)
    opposite = -value
    value = ((value if even else opposite) if whole else (math.nan if some else value)) if x < 0.0 else value
    value = value if (x == x) & (y == y) else math.nan
    return 1.0 if (y == 0.0) | (x == 1.0) else value


# Without series.


def fmin(x: float, y: float) -> float:
    """The smaller; where one is NaN the other, as in C and NumPy."""
    return x if (x <= y) | (y != y) else y


def fmax(x: float, y: float) -> float:
    """The larger; where one is NaN the other, as in C and NumPy."""
    return x if (x >= y) | (y != y) else y


def sign(x: float) -> float:
    """-1, 0 or 1; NaN for NaN."""
    return 1.0 if x > 0.0 else (-1.0 if x < 0.0 else x)


def copysign(x: float, y: float) -> float:
    """The size of x with the sign of y: plus for either zero as y; NaN where y is NaN, which has no sign to rely on."""
    size = math.fabs(x)
    return size if y >= 0.0 else (-size if y < 0.0 else y)


def hypot(x: float, y: float) -> float:
    """Length of the vector (x, y), scaled by a power of two where the squares would leave the range of doubles."""
    wide = math.fabs(x)
    tall = math.fabs(y)
    most = wide if wide > tall else tall
    large = most > 3.273390607896142e150
    small = most < 3.054936363499605e-151
    scale = 1.90109156629516e-211 if large else (5.260135901548374e210 if small else 1.0)
    back = 5.260135901548374e210 if large else (1.90109156629516e-211 if small else 1.0)
    a = wide * scale
    b = tall * scale
    return math.sqrt(a * a + b * b) * back


FUNCTIONS: dict[str, Callable[..., float]] = {
    f.__name__: f
    for f in (sin, cos, tan, asin, acos, atan, atan2, exp, log, power, fmin, fmax, sign, copysign, hypot)
}  # fmt: skip
"""What an emitter may call, by name."""
