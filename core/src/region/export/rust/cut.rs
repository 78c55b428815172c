
/// A line cut where constraints change their minds.
struct Cut {
    at: [Real; 2 * CONSTRAINTS],
    /// The constraint, and whether it then holds.
    root: [(u32, bool); 2 * CONSTRAINTS],
    count: usize,
    hold: u32,
    equal: u32,
}

fn length(x: Real, y: Real, z: Real) -> Real {
    if y == 0.0 && z == 0.0 {
        abs(x)
    } else {
        sqrt(x * x + y * y + z * z)
    }
}

/// Of a curve: `c[0] + c[1] t + c[2] |(c[3] + c[4] t, c[5] + c[6] t, c[7] + c[8] t)|`.
fn value(c: &[Real; 9], t: Real) -> Real {
    let line = c[0] + c[1] * t;
    if c[2] == 0.0 {
        return line;
    }
    line + c[2] * length(c[3] + c[4] * t, c[5] + c[6] * t, c[7] + c[8] * t)
}

fn roots(c: &[Real; 9]) -> [Real; 2] {
    let bends = |at: usize| c[at] != 0.0 || c[at + 1] != 0.0;
    let (x, y, z) = (bends(3), bends(5), bends(7));
    if c[2] == 0.0 {
        return [-c[0] / c[1], Real::NAN];
    }
    if u8::from(x) + u8::from(y) + u8::from(z) <= 1 {
        let v = if y { 5 } else if z { 7 } else { 3 };
        let (at, slope) = (c[2] * c[v], c[2] * c[v + 1]);
        return [-(c[0] + at) / (c[1] + slope), -(c[0] - at) / (c[1] - slope)];
    }
    let square = c[2] * c[2];
    let a = square * (c[4] * c[4] + c[6] * c[6] + c[8] * c[8]) - c[1] * c[1];
    let b = square * (c[3] * c[4] + c[5] * c[6] + c[7] * c[8]) - c[0] * c[1];
    let d = square * (c[3] * c[3] + c[5] * c[5] + c[7] * c[7]) - c[0] * c[0];
    let e = b * b - a * d;
    let rounding = 8.0 * Real::EPSILON * b * b;
    if e < -rounding {
        return [Real::NAN; 2];
    }
    let root = if abs(e) <= rounding { 0.0 } else { sqrt(e) };
    let q = if b < 0.0 { root - b } else { -(b + root) };
    [q / a, d / q]
}

/// The signs are those of `<`, `<=`, `>=` and `>`, from 0.
fn compares(sign: u32, value: Real) -> bool {
    match sign {
        0 => value < 0.0,
        1 => value <= 0.0,
        2 => value >= 0.0,
        _ => value > 0.0,
    }
}

fn is_root(c: &[Real; 9], [low, high]: [Real; 2], t: Real) -> bool {
    let size = abs(c[0]) + abs(c[1] * t);
    low <= t && t <= high && abs(value(c, t)) <= SQRT_EPSILON * (1.0 + size)
}

/// Whether a constraint holds between two places.
fn between(c: &[Real; 9], sign: u32, a: Real, b: Real) -> bool {
    compares(sign, value(c, a + (b - a) * 0.5))
}

impl Cut {
    fn at(&mut self, owner: u32, at: Real, holds: bool) {
        let mut i = self.count;
        while i > 0 && at < self.at[i - 1] {
            self.at[i] = self.at[i - 1];
            self.root[i] = self.root[i - 1];
            i -= 1;
        }
        self.at[i] = at;
        self.root[i] = (owner, holds);
        self.count += 1;
    }

    /// Cuts a line at the roots of a curve.
    fn by(&mut self, owner: u32, sign: u32, mut c: [Real; 9], [low, high]: [Real; 2]) {
        if c[2] != 0.0 && c[4] == 0.0 && c[6] == 0.0 && c[8] == 0.0 {
            c[0] += c[2] * length(c[3], c[5], c[7]);
            c[2] = 0.0;
        }
        let [mut early, mut late] = roots(&c);
        if late < early {
            (early, late) = (late, early);
        }
        let mut end = high;
        let first = is_root(&c, [low, high], early);
        if is_root(&c, [low, high], late) && !(first && early == late) {
            self.at(owner, late, between(&c, sign, late, end));
            end = late;
        }
        if first {
            self.at(owner, early, between(&c, sign, early, end));
            end = early;
        }
        self.hold |= u32::from(between(&c, sign, low, end)) << owner;
        self.equal |= u32::from(sign == 1 || sign == 2) << owner;
    }

    /// The lower and upper ends of all intervals; returns how many there are.
    fn join(&self, low: Real, high: Real, ends: &mut [Real; 2 * MAX_INTERVALS]) -> usize {
        let (mut hold, mut next, mut count) = (self.hold, 0, 0);
        let (mut open, mut at) = (false, low);
        loop {
            let (mut owners, mut then) = (0, 0);
            while next < self.count && self.at[next] == at {
                let (owner, holds) = self.root[next];
                owners |= 1 << owner;
                then |= u32::from(holds) << owner;
                next += 1;
            }
            let here = holds((hold & !owners) | (owners & self.equal));
            hold = (hold & !owners) | then;
            let after = at < high && holds(hold);
            if !open && after {
                ends[2 * count] = at;
                open = true;
            } else if !open && here {
                ends[2 * count] = at;
                ends[2 * count + 1] = at;
                count += 1;
            } else if open && !(here && after) {
                ends[2 * count + 1] = at;
                count += 1;
                ends[2 * count] = at;
                open = after;
            }
            if !(at < high) {
                return count;
            }
            at = if next < self.count { self.at[next] } else { high };
        }
    }
}
