// Small systems of linear equations.

/** Solves a x = b for a dense matrix by elimination with row pivots; both are overwritten, b by the solution.
 * NaN where the matrix is singular. Gives the sign of the determinant: 1 or -1, else 0. */
export function solve(a: Float64Array, b: Float64Array): number {
  const n = b.length;
  let sign = 1;
  for (let k = 0; k < n; k++) {
    let pivot = k;
    for (let i = k + 1; i < n; i++) if (Math.abs(a[i * n + k]!) > Math.abs(a[pivot * n + k]!)) pivot = i;
    if (pivot !== k) {
      sign = -sign;
      for (let j = k; j < n; j++) [a[k * n + j], a[pivot * n + j]] = [a[pivot * n + j]!, a[k * n + j]!];
      [b[k], b[pivot]] = [b[pivot]!, b[k]!];
    }
    const at = a[k * n + k]!;
    if (!(Math.abs(at) > 0)) {
      b.fill(NaN);
      return 0;
    }
    if (at < 0) sign = -sign;
    for (let i = k + 1; i < n; i++) {
      const factor = a[i * n + k]! / at;
      if (factor === 0) continue;
      for (let j = k + 1; j < n; j++) a[i * n + j]! -= factor * a[k * n + j]!;
      b[i]! -= factor * b[k]!;
    }
  }
  for (let k = n - 1; k >= 0; k--) {
    let sum = b[k]!;
    for (let j = k + 1; j < n; j++) sum -= a[k * n + j]! * b[j]!;
    b[k] = sum / a[k * n + k]!;
  }
  return sign;
}
