//! How good the region is, and why there is none: in honest words.

use super::VersionSpace;
use super::forms::{LeftOut, SampleSet, StepView};
use crate::domain::Domain;
use crate::error::Error;
use crate::learn::Observation;
use crate::real::Real;
use crate::region::Region;
use core::fmt;

/// What a region is worth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quality {
    /// There is no region; see [`VersionSpace::why`].
    #[default]
    None,
    /// It agrees with the answers so far, but they are too few to tell it from chance.
    Provisional,
    /// It is wrong about some answers. The report estimates how good it is.
    Approximate,
    /// It agrees with all answers, but for those of a few instances that stray a little, see
    /// [`Config::slack`](super::Config::slack).
    Exact,
}

/// Why there is no region, or no better one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Why {
    /// There is an exact region.
    #[default]
    Explained,
    /// Nothing was told yet.
    NothingTold,
    /// No sample worked.
    NoneWorked,
    /// All samples worked: the region is everything.
    AllWorked,
    /// In no instance did some samples work and others not: whether the action works was not
    /// seen to depend on the parameters.
    NoInfluence,
    /// There are too few answers for the smallest explanation: about so many more are needed.
    TooFew {
        /// Answers.
        more: u32,
    },
    /// Answers at one and the same place contradict each other. An exact region strays from
    /// some of them then, unless it was known that some are wrong.
    Contradiction {
        /// Places that were asked about again.
        asked: u32,
        /// Those where not all answers were the same.
        differing: u32,
    },
    /// Nothing that the text can say excludes these infeasible samples, or not without some
    /// feasible ones.
    Unexplained {
        /// Samples that the region is wrong about, or that nothing excludes.
        samples: u32,
        /// The first three of them, among the observations.
        examples: [Option<u32>; 3],
    },
}

impl fmt::Display for Why {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Why::Explained => f.write_str("the region agrees with the answers"),
            Why::NothingTold => f.write_str("no outcome was told yet"),
            Why::NoneWorked => f.write_str(
                "no sample worked: give a smaller range of the parameters, or a sample that works",
            ),
            Why::AllWorked => f.write_str("all samples worked: the region is everything"),
            Why::NoInfluence => f.write_str(
                "in no instance did some samples work and others not: \
                 the parameters were not seen to matter",
            ),
            Why::TooFew { more } => write!(
                f,
                "too few answers to tell an explanation from chance: about {more} more are needed"
            ),
            Why::Contradiction { asked, differing } => write!(
                f,
                "at {differing} of {asked} places that were asked about again the answers \
                 contradict each other: say how often they are wrong (noise)"
            ),
            Why::Unexplained { samples, .. } => write!(
                f,
                "nothing that the domain text can say explains {samples} samples: \
                 is a size, a body or an object missing in it?"
            ),
        }
    }
}

impl<R: Real> VersionSpace<'_, R> {
    /// What the region is worth.
    pub fn quality(&self) -> Quality {
        if self.report.infeasible == 0 {
            // What was not asked was perhaps told because it works.
            let worked = f64::from(self.report.certificate.feasible);
            let known = worked >= self.config.tuning.significance;
            return if known { Quality::Exact } else { Quality::None };
        }
        if self.approximating {
            let Some((lower, upper)) = self.report.precision(self.config.confidence) else {
                return self.provisional();
            };
            let wanted = self.config.precision_wanted;
            let good = upper >= wanted && lower >= wanted - self.config.tuning.unproven;
            return match (good, self.calls_left() > 0) {
                (true, _) => Quality::Approximate,
                (false, true) => Quality::Provisional,
                (false, false) => Quality::None,
            };
        }
        if !self.is_explained() {
            return self.provisional();
        }
        match self.admitted_wrongly() > self.config.tuning.admitted {
            true => Quality::Approximate,
            false => Quality::Exact,
        }
    }

    /// The share of what the best hypotheses admit that does not work.
    fn admitted_wrongly(&self) -> f64 {
        if !self.committee.is_strained() {
            return 0.0;
        }
        let (mut wrongly, mut rightly) = (0.0, 0.0);
        for (step, own) in self.committee.best().enumerate() {
            let view = StepView::new(&self.forms, step);
            let admitted = |set: &SampleSet| {
                let admitted = set.iter().filter(|sample| own.admits(&view, *sample));
                self.forms.weigh(admitted)
            };
            wrongly += admitted(&view.infeasible);
            // What works comes to the last step.
            rightly = admitted(&view.feasible);
        }
        wrongly / (wrongly + rightly).max(1.0)
    }

    /// The best region there is, of whatever quality.
    ///
    /// # Errors
    /// [`Error::NoRegion`] if there is none.
    pub fn best_region(&self) -> Result<&Region, Error> {
        match self.quality() {
            Quality::None => Err(Error::NoRegion),
            Quality::Provisional | Quality::Approximate | Quality::Exact => Ok(self.region),
        }
    }

    fn provisional(&self) -> Quality {
        let known = self.report.feasible > 0 && self.report.infeasible > 0;
        let fits = self.approximating || self.committee.is_consistent();
        match known && fits && self.shown_clauses().next().is_some() {
            true => Quality::Provisional,
            false => Quality::None,
        }
    }

    /// Why there is no region, or none that is exact.
    pub fn why(&self) -> Why {
        let report = &self.report;
        if report.feasible + report.infeasible == 0 {
            return Why::NothingTold;
        }
        if report.infeasible == 0 {
            return Why::AllWorked;
        }
        if report.feasible == 0 {
            return Why::NoneWorked;
        }
        let exact = self.quality() == Quality::Exact;
        // Nothing agrees with answers that contradict each other, unless some are known to be
        // wrong.
        let agrees = exact && (self.config.noise > 0.0 || report.strays == 0);
        if !agrees && let Some(why) = self.contradiction() {
            return why;
        }
        if exact {
            return Why::Explained;
        }
        if !self.influence {
            return Why::NoInfluence;
        }
        let (samples, examples) = self.unexplained();
        // What strays from the first guess is explained by the next one.
        let learning = self.calls_left() > 0 && !self.approximating;
        let guess = self.committee.is_consistent() && !self.is_significant();
        if samples > 0 && !(learning && guess) {
            return Why::Unexplained { samples, examples };
        }
        Why::TooFew {
            more: self.answers_needed(),
        }
    }

    /// What could be compared and is not, because it found no room: `None` if there is nothing.
    /// It is left sides; or, where those all found room, comparisons with right sides that did
    /// not, once the instances are known.
    pub fn left_out(&self, domain: &Domain<'_>) -> Option<LeftOut> {
        let forms = u32::try_from(self.report.forms_left_out).unwrap_or(u32::MAX);
        let comparisons = (forms > 0).then_some(LeftOut {
            count: forms,
            first: None,
        });
        self.forms.lefts_left_out(domain).or(comparisons)
    }

    /// How often answers at one place differ, if they do.
    fn contradiction(&self) -> Option<Why> {
        let all = self.observations.as_slice();
        let same =
            |a: &Observation, b: &Observation| a.instance == b.instance && a.theta == b.theta;
        let (mut asked, mut differing) = (0, 0);
        for (index, own) in all.iter().enumerate() {
            let before = all.get(..index).unwrap_or(&[]);
            let behind = all.get(index + 1..).unwrap_or(&[]);
            if before.iter().any(|other| same(own, other)) {
                continue;
            }
            let mut again = behind.iter().filter(|other| same(own, other)).peekable();
            if again.peek().is_some() {
                asked += 1;
                differing += u32::from(again.any(|other| other.outcome != own.outcome));
            }
        }
        (differing > 0).then_some(Why::Contradiction { asked, differing })
    }

    /// The samples that the region, or the best hypothesis, is wrong about.
    fn unexplained(&self) -> (u32, [Option<u32>; 3]) {
        let (mut samples, mut examples) = (0, [None; 3]);
        for (step, own) in self.shown().enumerate() {
            let view = StepView::new(&self.forms, step);
            for sample in own.wrong(&view) {
                if let Some(example) = examples.get_mut(samples as usize) {
                    *example = Some(sample as u32);
                }
                samples += 1;
            }
        }
        (samples, examples)
    }

    /// About how many answers more it takes until the best hypothesis is no accident, at the
    /// rate at which they say something now.
    fn answers_needed(&self) -> u32 {
        let missing = -self.significance();
        let each = self.entropy() / self.forms.samples().max(1) as f64;
        let more = libm::ceil(missing / each.max(0.1));
        (more as u32).max(1)
    }
}
