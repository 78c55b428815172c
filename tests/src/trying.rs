//! Trying operators by their names.

use critreg::task::{Environment, ObjectId, State, try_operator};

/// The state after an operator with the first object of the type of each of its parameters;
/// `None` if it does not work.
///
/// # Panics
/// If there is no such operator or object.
pub fn after<E: Environment>(
    environment: &E,
    name: &str,
    parameters: &[f64],
    state: &State,
) -> Option<State> {
    let mut operators = E::OPERATORS.iter();
    let operator = operators.find(|operator| operator.name == name).unwrap();
    let first = |kind: &_| state.of_type(*kind).next().unwrap();
    let objects: Vec<ObjectId> = operator.parameters.iter().map(first).collect();
    let tried = try_operator(environment, operator, &objects, parameters, state);
    tried.is_feasible().then_some(tried.state)
}
