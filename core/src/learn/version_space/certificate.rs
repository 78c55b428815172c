//! What draws from a region prove about it.

/// Draws from the region, and a lower bound on the share that works.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Certificate {
    /// Draws from inside the region.
    pub draws: u32,
    /// Those that worked.
    pub feasible: u32,
    /// With the configured confidence, at least this share of the region works
    /// (Clopper and Pearson 1934).
    pub lower_bound: f64,
}

impl Certificate {
    /// What `feasible` of `draws` prove.
    pub fn new(draws: u32, feasible: u32, confidence: f64) -> Certificate {
        Certificate {
            draws,
            feasible,
            lower_bound: lower_bound(draws, feasible, 1.0 - confidence),
        }
    }
}

/// The share at which so many successes or more have the probability `doubt`.
fn lower_bound(draws: u32, feasible: u32, doubt: f64) -> f64 {
    if feasible == 0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..48 {
        let middle = 0.5 * (low + high);
        if tail(draws, feasible.min(draws), middle) > doubt {
            high = middle;
        } else {
            low = middle;
        }
    }
    low
}

/// The probability of at least `feasible` successes in `draws`.
///
/// All terms of the binomial distribution are measured by that of `feasible`, so that none
/// underflows that counts, and together they are one.
fn tail(draws: u32, feasible: u32, share: f64) -> f64 {
    let odds = share / (1.0 - share);
    let more = terms((feasible..draws).map(|n| f64::from(draws - n) / f64::from(n + 1) * odds));
    let fewer = (1..=feasible).rev();
    let fewer = terms(fewer.map(|n| f64::from(n) / (f64::from(draws - n) + 1.0) / odds));
    match more.is_finite() {
        true => (1.0 + more) / (1.0 + more + fewer),
        false => 1.0,
    }
}

/// The sum of terms of which each is so many times the one before, from one on. They rise to
/// one place and fall behind it.
fn terms(ratios: impl Iterator<Item = f64>) -> f64 {
    let (mut term, mut sum) = (1.0, 0.0);
    for ratio in ratios {
        term *= ratio;
        sum += term;
        if ratio < 1.0 && term < 1e-17 * sum {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::Certificate;

    /// The values of SciPy's `beta.ppf(1 - confidence, feasible, draws - feasible + 1)`.
    #[test]
    fn bounds_agree_with_another_library() {
        for (draws, feasible, bounds) in [
            (5, 0, [0.0, 0.0, 0.0]),
            (
                7,
                1,
                [
                    9.427_633_573_609e-2,
                    7.300_831_979_01e-3,
                    1.428_632_656_85e-5,
                ],
            ),
            (
                10,
                10,
                [
                    0.933_032_991_536_8,
                    0.741_134_449_106_9,
                    0.398_107_170_553_5,
                ],
            ),
            (
                20,
                19,
                [
                    0.917_490_339_996_8,
                    0.783_893_835_793_2,
                    0.546_694_535_163_3,
                ],
            ),
            (
                30,
                15,
                [
                    0.483_519_678_127_7,
                    0.338_892_661_609_5,
                    0.186_220_868_895_4,
                ],
            ),
            (
                100,
                95,
                [
                    0.943_487_978_710_8,
                    0.897_746_622_356_7,
                    0.818_070_972_182_6,
                ],
            ),
            (
                1000,
                1,
                [6.929_070_095_475e-4, 5.129_197_890_90e-5, 1.000_049_953e-7],
            ),
            (
                1000,
                480,
                [
                    0.479_506_834_702_9,
                    0.453_582_231_002_0,
                    0.421_158_525_662_9,
                ],
            ),
            (
                1000,
                1000,
                [
                    0.999_307_092_990_5,
                    0.997_008_750_454_9,
                    0.990_831_944_892_8,
                ],
            ),
            (
                2048,
                1500,
                [
                    0.732_139_938_940_3,
                    0.715_846_655_043_2,
                    0.694_763_309_382_1,
                ],
            ),
            (
                2048,
                2047,
                [
                    0.999_180_630_339_1,
                    0.997_685_776_028_8,
                    0.994_274_634_445_0,
                ],
            ),
            (
                2048,
                2048,
                [
                    0.999_661_606_496_2,
                    0.998_538_309_412_6,
                    0.995_512_860_915_9,
                ],
            ),
            (
                100_000,
                99_000,
                [
                    0.989_993_366_492_4,
                    0.989_466_799_099_4,
                    0.988_777_288_999_7,
                ],
            ),
            (
                1_000_000,
                500_000,
                [
                    0.499_999_500_000_2,
                    0.499_177_073_949_5,
                    0.498_139_998_656_8,
                ],
            ),
        ] {
            for (confidence, bound) in [0.5, 0.95, 0.9999].into_iter().zip(bounds) {
                let found = Certificate::new(draws, feasible, confidence).lower_bound;
                assert!((found - bound).abs() < 1e-11, "{draws} {feasible}: {found}");
            }
        }
    }

    #[test]
    fn more_successes_prove_more() {
        for draws in [1, 2, 3, 50, 999, 2048] {
            let bound = |feasible| Certificate::new(draws, feasible, 0.95).lower_bound;
            let mut last = -1.0;
            for feasible in 0..=draws {
                let share = f64::from(feasible) / f64::from(draws);
                let own = bound(feasible);
                assert!(own > last && own <= share, "{draws} {feasible}: {own}");
                last = own;
            }
        }
    }
}
