//! The numbers that decide what is learned, in one place.
//!
//! Each has a name, a unit and a reason. They were chosen with `report -- pick`, `chain`,
//! `interval`, `union`, `angles` and `synthetic` on seeds from 0 on, which no published
//! figure uses. `report -- sensitivity` halves and doubles each, on other seeds, and prints
//! how many regions are exact then: the table in `tests/README.md` shows that every optimum
//! is flat. What a form costs for its class was taken from a prototype's prices, in the same
//! order: what is the same in every frame first.

/// A number of [`Tuning`]: what half and twice as much of it is.
trait Scale: Copy {
    fn scaled(self, factor: f64) -> Self;
}

impl Scale for f64 {
    fn scaled(self, factor: f64) -> f64 {
        self * factor
    }
}

impl Scale for u32 {
    fn scaled(self, factor: f64) -> u32 {
        libm::ceil(f64::from(self) * factor) as u32
    }
}

/// Feeds a checksum.
trait Digest {
    fn digest(self, bytes: &mut dyn FnMut(&[u8]));
}

impl Digest for f64 {
    fn digest(self, bytes: &mut dyn FnMut(&[u8])) {
        bytes(&self.to_bits().to_le_bytes());
    }
}

impl Digest for u32 {
    fn digest(self, bytes: &mut dyn FnMut(&[u8])) {
        bytes(&self.to_le_bytes());
    }
}

macro_rules! tuning {
    ($($(#[$doc:meta])* $name:ident: $kind:ty = $value:expr,)*) => {
        /// The numbers that decide what a [`VersionSpace`](super::VersionSpace) learns. See
        /// the source of `learn/version_space/tuning.rs` for how they were chosen.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Tuning {
            $($(#[$doc])* pub $name: $kind,)*
        }

        impl Tuning {
            /// The numbers as they were chosen.
            pub const CHOSEN: Tuning = Tuning { $($name: $value,)* };

            /// The names of the numbers.
            pub const NAMES: &'static [&'static str] = &[$(stringify!($name)),*];

            /// The same with one number, by its name, multiplied by a factor; whole numbers
            /// are rounded up. `None` if there is none of this name.
            pub fn scaled(mut self, name: &str, factor: f64) -> Option<Tuning> {
                $(if name == stringify!($name) {
                    self.$name = self.$name.scaled(factor);
                    return Some(self);
                })*
                None
            }

            /// Shows all numbers to a checksum, in their order.
            pub(super) fn digest(&self, bytes: &mut dyn FnMut(&[u8])) {
                $(self.$name.digest(bytes);)*
            }
        }
    };
}

tuning! {
    /// Bits to say that a form is one that the hypothesis named before.
    form_again: f64 = 3.0,
    /// Where a domain has bodies, bits for a left side that is a straight distance instead of
    /// a relation between whole bodies. Those are as they are in every frame.
    distance_class: f64 = 1.0,
    /// The same for a relation along one axis of a body, or an angle.
    axis_class: f64 = 2.0,
    /// The same for a parameter.
    parameter_class: f64 = 3.0,
    /// The same for a coordinate or a distance along an axis of the world, which say something
    /// else as soon as the scene is turned.
    world_class: f64 = 5.0,
    /// Bits for a left side that is derived, or a condition on the scene.
    derived: f64 = 2.0,
    /// Up to how many bits an explanation with sums is so short that no more complex ones
    /// are looked for.
    short_sums: f64 = 45.0,
    /// Bits for an instance that strays from a bound.
    stray: f64 = 0.7,
    /// Bits for how far it strays, per range of the form.
    stray_distance: f64 = 280.0,
    /// Bits for each sample on the wrong side in an instance that has no boundary of its
    /// own.
    stray_sample: f64 = 2.0,
    /// Bits for a threshold, per complexity of its name.
    name_complexity: f64 = 0.42,
    /// The complexity that a threshold without a name counts as.
    unnamed_complexity: f64 = 7.0,
    /// How close the ends of a bound must be for its name to count, as a share of what the
    /// form ranges over.
    name_gap: f64 = 0.01,
    /// Bits for the threshold zero, which needs no description.
    zero_threshold: f64 = 1.0,
    /// Bits to measure from an object that has key points.
    corner: f64 = 0.56,
    /// By how many bits the answers must be longer than their explanation: one of
    /// 2^significance times that answers by chance seem to be explained.
    significance: f64 = 10.0,
    /// Up to which share of the answers may stray from an explanation.
    strays: f64 = 0.05,
    /// Up to which share of what an exact region admits may fail.
    admitted: f64 = 0.01,
    /// Bits for an answer that a region is wrong about where none explains all, or that a sum does
    /// not exclude: the log odds of 2% wrong answers.
    wrong: f64 = 6.0,
    /// How much a sample that was asked about for a reason counts for how good such a region
    /// is, compared to one drawn at random: reasons are near boundaries.
    undrawn: f64 = 0.3,
    /// By how much better than wanted such a region must be on the samples that it is chosen
    /// by, as a share of what is not wanted of it: they flatter it.
    optimism: f64 = 0.4,
    /// By how much less than wanted its precision may be proven to be: with ten draws that
    /// work, 0.74 is.
    unproven: f64 = 0.25,
    /// Share of the calls after which such a region is looked for.
    give_up: f64 = 0.6,
    /// Share of new samples between two looks: each is done at once, so they are to be fewer
    /// than one of a hundred questions.
    batch: f64 = 0.2,
    /// From how many bits on an explanation is so long that it is compared with such a region.
    long: f64 = 60.0,
    /// Share of the questions then that are draws from the region, and share that are draws
    /// from everything.
    draws: f64 = 0.67,
    /// See `draws`.
    uniform: f64 = 0.17,
    /// Share of the calls, the last ones, that only estimate how good such a region is.
    judging: f64 = 0.25,
    /// Where between its ends a bound is drawn, as a share from S on.
    threshold_share: f64 = 0.4,

    /// By which share the greedy choice discounts a form whose right side is an attribute or
    /// a coordinate.
    discount_attribute: f64 = 0.1,
    /// The same for a distance or an angle.
    discount_distance: f64 = 0.15,
    /// The same for a scaled one.
    discount_scaled: f64 = 0.2,
    /// The same for a sum.
    discount_sum: f64 = 0.3,
    /// How much chance blurs what the greedy choice of a committee's member counts, as a
    /// share.
    committee_noise: f64 = 0.3,
    /// How much more every other member discounts complex forms, so that chance chooses among
    /// the few simple ones.
    committee_plainness: f64 = 4.0,
    /// By how many bits a member of the committee may be longer than the best hypothesis to
    /// have a vote: one of 10 more is a thousand times less likely.
    rival: f64 = 10.0,
    /// Share of what a clause alone excludes that its replacement must exclude at least.
    replacement: f64 = 0.6,

    /// Samples that a disjunction is tried on, each with all forms.
    pivots: u32 = 3,
    /// The most complex level of right sides with which the search for two bounds begins.
    pair_level: u32 = 1,
    /// First bounds of a disjunction for which a second one is looked for; at most 24.
    beam: u32 = 24,
    /// Intervals, of different left sides, from which a disjunction is improved; at most 4.
    interval_starts: u32 = 4,
    /// How often other right sides of the two bounds of a disjunction are looked for.
    polish_rounds: u32 = 2,
    /// By how much a disjunction of two forms is discounted.
    discount_second: f64 = 0.1,
    /// How much discounts count in the choice of a disjunction.
    disjunction_plainness: f64 = 0.5,

    /// Hypotheses that compete when one is selected.
    candidates: u32 = 16,
    /// Hypotheses with a disjunction that compete, too, where the others are longer than
    /// `disjunctions_beyond`.
    disjunctions: u32 = 3,
    /// See `disjunctions`, in bits.
    disjunctions_beyond: f64 = 50.0,
    /// By how many bits the best hypotheses may grow before they are doubted.
    growth: f64 = 3.0,
    /// How many times as many samples as at the last selection there are when one is made
    /// while nobody asks: each looks at all samples.
    observed_growth: f64 = 1.5,
    /// A new selection needs one new sample for so many old ones: where nothing explains the
    /// answers for long, selections would follow each other.
    patience: u32 = 8,

    /// How much is done between two answers to select hypotheses, in looks at a form and 64
    /// samples: the rest is done after the next ones. A look takes about five nanoseconds on a
    /// PC, so this is about two milliseconds.
    work: u32 = 400_000,

    /// Instances that candidates for a query are drawn in.
    query_instances: u32 = 12,
    /// Candidates in each.
    query_candidates: u32 = 8,
    /// A gap between the ends of a bound is narrow below this share of the form's range.
    narrow: f64 = 0.002,
    /// How many times the width of what works, or may work, counts as the range where that is
    /// less.
    narrow_slot: f64 = 4.0,
    /// Share of the questions that narrow a bound although the committee is not of one mind:
    /// it may never be about one bound, and then says nothing about the others.
    narrowing: f64 = 0.3,
    /// Share of the questions that look for a bound that fits by chance, where the committee is of
    /// one mind and all gaps are narrow; the others explore.
    probing: f64 = 0.5,
    /// How far inside or outside of a bound a probe lies, and how close to it another sample
    /// must be to make it superfluous, as a share of a narrow gap.
    probe: f64 = 0.5,
    /// How often an instance is drawn to find a sample at a certain value of a form.
    bisect_tries: u32 = 12,
    /// How often the distance to a proposal is halved at most.
    proposal_scales: u32 = 12,
    /// The same for the distance to what was told to work although nobody asked, which is
    /// known to be right.
    observed_scales: u32 = 20,
    /// Instances in which a draw from the region is tried, to certify it.
    certify_draws: u32 = 8,
    /// Share of the calls that are left after a draw from the region failed that certify
    /// again.
    certify_again: f64 = 0.5,
    /// Where answers may be wrong, by how much more likely an answer must be than its
    /// opposite.
    beyond_doubt: f64 = 10_000.0,
}
