
/// The lower and upper ends of all intervals that are admitted; returns how many there are.
pub fn intervals(instance: &[Real; INSTANCE_LEN], ends: &mut [Real; 2 * MAX_INTERVALS]) -> usize {
    let mut cut = Cut {
        at: [0.0; 2 * CONSTRAINTS],
        root: [(0, false); 2 * CONSTRAINTS],
        count: 0,
        hold: 0,
        equal: 0,
    };
