//! What others learn from the same answers: a random forest and a support vector machine, whose
//! inputs are the numbers of the instance and the parameters.

use smartcore::ensemble::random_forest_classifier::{
    RandomForestClassifier, RandomForestClassifierParameters,
};
use smartcore::linalg::basic::arrays::Array;
use smartcore::linalg::basic::matrix::DenseMatrix;
use smartcore::svm::Kernels;
use smartcore::svm::svc::{SVC, SVCParameters};

const TREES: u16 = 100;
/// The price of an answer that the machine is wrong about.
const PRICE: f64 = 10.0;
/// How often the machine goes through the answers.
const EPOCHS: usize = 5;

/// Inputs, a row for each sample, and which of them work.
#[derive(Default)]
pub(super) struct Labelled {
    pub(super) inputs: Vec<Vec<f64>>,
    pub(super) works: Vec<bool>,
}

impl Labelled {
    fn labels(&self) -> Vec<i32> {
        self.works.iter().map(|own| i32::from(*own)).collect()
    }

    /// Inputs with the mean zero and the variance one of those that are learned from.
    fn scaled(&self, like: &Labelled) -> DenseMatrix<f64> {
        let count = like.inputs.len() as f64;
        let columns = like.inputs.first().map_or(0, Vec::len);
        let scales: Vec<(f64, f64)> = (0..columns)
            .map(|column| {
                let values = || like.inputs.iter().map(|row| row[column]);
                let mean = values().sum::<f64>() / count;
                let variance = values().map(|own| (own - mean).powi(2)).sum::<f64>() / count;
                (mean, variance.sqrt().max(1e-9))
            })
            .collect();
        let rows = self.inputs.iter().map(|row| {
            let own = row.iter().zip(&scales);
            own.map(|(value, (mean, scale))| (value - mean) / scale)
                .collect()
        });
        let rows: Vec<Vec<f64>> = rows.collect();
        DenseMatrix::from_2d_vec(&rows).expect("rows of equal length")
    }
}

/// Which of the samples a random forest says work. `None` where only one kind of answers is
/// known.
pub(super) fn forest(known: &Labelled, asked: &Labelled, seed: u64) -> Option<Vec<bool>> {
    let parameters = RandomForestClassifierParameters::default()
        .with_n_trees(TREES)
        .with_seed(seed);
    let (inputs, labels) = (known.scaled(known), known.labels());
    let forest = both(known)
        .then(|| RandomForestClassifier::fit(&inputs, &labels, parameters).expect("two classes"))?;
    let said = forest.predict(&asked.scaled(known)).expect("it is fitted");
    Some(said.into_iter().map(|own| own == 1).collect())
}

/// The same of a support vector machine with Gaussian kernels.
pub(super) fn machine(known: &Labelled, asked: &Labelled, seed: u64) -> Option<Vec<bool>> {
    let (inputs, labels) = (known.scaled(known), known.labels());
    // One over the sum of all variances.
    let width = 1.0 / inputs.shape().1 as f64;
    let parameters = SVCParameters::default()
        .with_c(PRICE)
        .with_epoch(EPOCHS)
        .with_kernel(Kernels::rbf().with_gamma(width))
        .with_seed(Some(seed));
    let machine =
        both(known).then(|| SVC::fit(&inputs, &labels, &parameters).expect("two classes"))?;
    let asked = asked.scaled(known);
    let said = machine.predict(&asked).expect("it is fitted");
    Some(said.into_iter().map(|own| own > 0.5).collect())
}

/// Whether there are answers of both kinds.
fn both(known: &Labelled) -> bool {
    known.works.contains(&true) && known.works.contains(&false)
}
