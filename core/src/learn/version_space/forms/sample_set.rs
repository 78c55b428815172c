//! Sets of samples, a bit each.

/// Most words of a set.
pub(in super::super) const MAX_WORDS: usize = match cfg!(feature = "many_observations") {
    true => 32,
    false => 4,
};

/// A set of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) struct SampleSet {
    words: [u64; MAX_WORDS],
}

impl SampleSet {
    pub(in super::super) const EMPTY: SampleSet = SampleSet {
        words: [0; MAX_WORDS],
    };

    /// The set with these words; what they do not tell about is not in it.
    pub(super) fn of_words<'w>(own: impl IntoIterator<Item = &'w u64>) -> SampleSet {
        let mut set = SampleSet::EMPTY;
        for (word, own) in set.words.iter_mut().zip(own) {
            *word = *own;
        }
        set
    }

    /// A bit for each sample.
    pub(super) fn words(&self) -> &[u64; MAX_WORDS] {
        &self.words
    }

    pub(in super::super) fn is_empty(&self) -> bool {
        self.words.iter().all(|word| *word == 0)
    }

    /// How many samples are in it.
    pub(in super::super) fn len(&self) -> usize {
        let counts = self.words.iter().map(|word| word.count_ones() as usize);
        counts.sum()
    }

    pub(in super::super) fn contains(&self, sample: usize) -> bool {
        let word = self.words.get(sample / 64);
        word.is_some_and(|word| word >> (sample % 64) & 1 == 1)
    }

    pub(in super::super) fn insert(&mut self, sample: usize) {
        if let Some(word) = self.words.get_mut(sample / 64) {
            *word |= 1 << (sample % 64);
        }
    }

    pub(in super::super) fn remove(&mut self, sample: usize) {
        if let Some(word) = self.words.get_mut(sample / 64) {
            *word &= !(1 << (sample % 64));
        }
    }

    /// Every so many of its samples.
    pub(in super::super) fn every(&self, step: usize) -> SampleSet {
        let mut set = SampleSet::EMPTY;
        for sample in self.iter().step_by(step.max(1)) {
            set.insert(sample);
        }
        set
    }

    /// Takes out what is in another set.
    pub(in super::super) fn subtract(&mut self, other: &SampleSet) {
        for (word, other) in self.words.iter_mut().zip(&other.words) {
            *word &= !other;
        }
    }

    /// Keeps what is in another set, too.
    pub(in super::super) fn intersect(&mut self, other: &SampleSet) {
        for (word, other) in self.words.iter_mut().zip(&other.words) {
            *word &= other;
        }
    }

    /// Puts in what is in another set. Returns what was in both.
    pub(in super::super) fn unite(&mut self, other: &SampleSet) -> SampleSet {
        let mut both = *other;
        both.intersect(self);
        for (word, other) in self.words.iter_mut().zip(&other.words) {
            *word |= other;
        }
        both
    }

    /// Its samples, ascending.
    pub(in super::super) fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        let mut words = self.words.iter();
        // The first sample of the next word, and what is left of the one before.
        let (mut next, mut left) = (0, 0u64);
        core::iter::from_fn(move || {
            while left == 0 {
                left = *words.next()?;
                next += 64;
            }
            let bit = left.trailing_zeros() as usize;
            left &= left - 1;
            Some(next - 64 + bit)
        })
    }
}
