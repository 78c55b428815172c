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

/// The probability of at least `feasible` successes in `draws`, from the top
/// down, where the terms are largest.
fn tail(draws: u32, feasible: u32, share: f64) -> f64 {
    let mut term = (0..draws).fold(1.0, |power, _| power * share);
    let odds = (1.0 - share) / share;
    let mut sum = term;
    for successes in (feasible + 1..=draws).rev() {
        term *= f64::from(successes) / f64::from(draws - successes + 1) * odds;
        sum += term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::Certificate;

    #[test]
    fn bounds_agree_with_published_tables() {
        // One-sided 95% bounds; 10 of 10 is the root of p^10 = 0.05.
        for (draws, feasible, bound) in [
            (10, 10, 0.741_13),
            (20, 19, 0.783_89),
            (30, 15, 0.338_89),
            (100, 95, 0.897_75),
            (5, 0, 0.0),
        ] {
            let found = Certificate::new(draws, feasible, 0.95).lower_bound;
            assert!((found - bound).abs() < 1e-3, "{draws} {feasible}: {found}");
        }
    }
}
