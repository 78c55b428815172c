//! Keeping the explanations up to date, and electing the best.

use super::cover::{Cover, MEMBERS, members};
use super::explain;
use super::forms::MAX_TRIM;
use super::greedy::Taste;
use super::{CANDIDATES, VersionSpace};
use crate::domain::Domain;
use crate::error::Error;
use crate::grammar::Formula;
use crate::real::Real;
use crate::region::Region;

impl<R: Real> VersionSpace<'_, R> {
    /// Replaces the explanations that no longer hold, from some member on.
    pub(super) fn mend(&mut self, from: usize) {
        for (step, covers) in self.covers.chunks_mut(MEMBERS).enumerate() {
            let wanted = self.forms.infeasible(step);
            for (member, cover) in covers.iter_mut().enumerate().skip(from) {
                if cover.holds(&self.forms, &wanted) {
                    cover.measure(&self.forms, step);
                } else {
                    let taste = Taste::of_member(member);
                    *cover = Cover::greedy(&self.forms, step, taste, &mut self.rng);
                }
            }
        }
    }

    /// Brings the best explanation of each step up to date, the simplest of all
    /// that are known.
    pub(super) fn mend_best(&mut self) {
        self.trim();
        for (step, covers) in self.covers.chunks_mut(MEMBERS).enumerate() {
            let wanted = self.forms.infeasible(step);
            let Some((best, others)) = covers.split_first_mut() else {
                continue;
            };
            if best.complete && best.holds(&self.forms, &wanted) {
                best.measure(&self.forms, step);
                continue;
            }
            self.elected = false;
            *best = Cover::greedy(&self.forms, step, Taste::SOBER, &mut self.rng);
            for other in others {
                if other.holds(&self.forms, &wanted) {
                    other.measure(&self.forms, step);
                    let cheaper = other.price() < best.price() - 1e-9;
                    if cheaper && (other.complete || !best.complete) {
                        core::mem::swap(best, other);
                    }
                }
            }
        }
    }

    /// Excuses infeasible samples just inside of a bound, rather than making a
    /// constraint for them.
    pub(super) fn excuse(&mut self) {
        for step in 0..self.capacity.steps {
            let all = members(&self.forms.feasible(step)).count() + self.report.infeasible;
            let excused = members(&self.forms.excused(step)).count();
            let most = ((self.config.slack * all as f64) as usize).saturating_sub(excused);
            let best = self.covers.get_mut(step * MEMBERS);
            let Some(best) = best.filter(|best| best.complete) else {
                continue;
            };
            if let Some(set) = best.excusable(&self.forms, step, most) {
                self.forms.excuse(step, &set);
                *best = Cover::greedy(&self.forms, step, Taste::SOBER, &mut self.rng);
            }
        }
    }

    /// Lets constraints ignore more samples as there are more.
    pub(super) fn trim(&mut self) {
        for step in 0..self.capacity.steps {
            let feasible = members(&self.forms.feasible(step)).count();
            let trim = ((self.config.slack * feasible as f64) as usize).min(MAX_TRIM);
            if trim != self.forms.trim(step) {
                self.forms.set_trim(step, trim);
                let worth = self.covers.get_mut(step * MEMBERS);
                worth.into_iter().for_each(|best| best.complete = false);
            }
        }
    }

    /// Looks for still better explanations and makes the region of them.
    pub(super) fn elect(&mut self, domain: &Domain<'_>) -> Result<(), Error> {
        self.elected = true;
        self.mend(1);
        self.excuse();
        for (step, covers) in self.covers.chunks_mut(MEMBERS).enumerate() {
            let Some((best, others)) = covers.split_first_mut() else {
                continue;
            };
            let forms = &self.forms;
            let price = |chosen: &_| explain::price(domain, forms, chosen);
            let rate = |cover: &mut Cover<R>| {
                cover.improve(forms, step, price);
                let all: f64 = cover.chosen.iter().map(price).sum();
                (!cover.complete, all, cover.looseness().to_f64())
            };
            let mut standing = rate(best);
            for member in 0..CANDIDATES {
                let mut other = match others.get(member) {
                    Some(known) => known.clone(),
                    None => {
                        let taste = Taste::of_member(member);
                        Cover::greedy(forms, step, taste, &mut self.rng)
                    }
                };
                let rating = rate(&mut other);
                if rating < standing {
                    (*best, standing) = (other, rating);
                }
            }
        }
        self.rebuild_region(domain)
    }

    pub(super) fn rebuild_region(&mut self, domain: &Domain<'_>) -> Result<(), Error> {
        let mut formula = Formula::everything();
        self.support.clear();
        for (step, cover) in self.covers.iter().step_by(MEMBERS).enumerate() {
            let (forms, support) = (&self.forms, &mut self.support);
            explain::add_constraints(domain, forms, cover, step, &mut formula, support)?;
        }
        let best = self.covers.iter().step_by(MEMBERS).flat_map(|c| &c.chosen);
        self.report.ignored = best.map(|c| c.ignored as usize).max().unwrap_or(0);
        self.region = Region::new(domain, formula);
        Ok(())
    }
}
