// What is typed as a number, as files have it: 160, 2*80, 16 cm, (160 + 5) mm; full-width digits and signs too.

/** Units that stand for each other, in SI. */
const FAMILIES: readonly Readonly<Record<string, number>>[] = [
  { um: 1e-6, mm: 1e-3, cm: 1e-2, dm: 0.1, m: 1, in: 0.0254 },
  { deg: Math.PI / 180, "°": Math.PI / 180, rad: 1 },
  { g: 1e-3, kg: 1, t: 1e3 },
  { ms: 1e-3, s: 1, min: 60 },
  { N: 1, kN: 1e3 },
  { "N*mm": 1e-3, "N*m": 1, Nm: 1, "kN*m": 1e3 },
  { "mm/s": 1e-3, "cm/s": 1e-2, "m/s": 1 },
  { "deg/s": Math.PI / 180, "rad/s": 1, rpm: Math.PI / 30, "r/min": Math.PI / 30 },
  { "N/mm": 1e3, "N/m": 1 },
  { "kg*mm^2": 1e-6, "kg*m^2": 1 },
];

const plain = (unit: string): string =>
  unit.replaceAll("·", "*").replaceAll("²", "^2").replaceAll("³", "^3").replace(/\s+/g, "");

/** The value in `unit` (whose SI value is `size`); null where there is none. */
export function entered(text: string, unit: string, size: number): number | null {
  const written = text.normalize("NFKC").replaceAll("−", "-").trim();
  const comma = /^[-+]?\d+,\d+$/.test(written) ? written.replace(",", ".") : written;
  const parts = /^(.*?[\d.)])\s*((?![eE][-+]?\d)[^\d\s.()+\-*/][^()]*)?$/s.exec(comma);
  if (!parts) return null;
  const value = arithmetic(parts[1]!);
  if (value === null || parts[2] === undefined) return value;
  const [stated, own] = [plain(parts[2]), plain(unit)];
  if (stated === own) return value;
  const family = FAMILIES.find((each) => own in each && stated in each);
  return family ? (value * family[stated]!) / size : null;
}

/** The value of a sum of products of numbers and brackets. */
function arithmetic(text: string): number | null {
  const tokens = text.match(/(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|[-+*/()]|\S/g) ?? [];
  let at = 0;
  const sum = (): number => {
    let value = product();
    while (tokens[at] === "+" || tokens[at] === "-") value += tokens[at++] === "+" ? product() : -product();
    return value;
  };
  const product = (): number => {
    let value = signed();
    while (tokens[at] === "*" || tokens[at] === "/") {
      if (tokens[at++] === "*") value *= signed();
      else value /= signed();
    }
    return value;
  };
  const signed = (): number => {
    if (tokens[at] === "-" || tokens[at] === "+") return tokens[at++] === "-" ? -signed() : signed();
    if (tokens[at] === "(") {
      at++;
      const value = sum();
      return tokens[at++] === ")" ? value : NaN;
    }
    const token = tokens[at++] ?? "";
    return /^[\d.]/.test(token) ? Number(token) : NaN;
  };
  const value = sum();
  return at === tokens.length && Number.isFinite(value) ? value : null;
}
