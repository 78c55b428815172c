
/// The parameter below which a share in [0, 1) of what is admitted lies: a uniform share makes a
/// uniform draw. `None` if nothing is admitted.
pub fn sample(instance: &[Real; INSTANCE_LEN], share: Real) -> Option<Real> {
    let mut ends = [0.0; 2 * MAX_INTERVALS];
    let count = intervals(instance, &mut ends);
    let mut length = 0.0;
    for interval in ends[..2 * count].chunks(2) {
        length += interval[1] - interval[0];
    }
    let mut left = share * length;
    for interval in ends[..2 * count].chunks(2) {
        let own = interval[1] - interval[0];
        if left < own {
            return Some(interval[0] + left);
        }
        left -= own;
    }
    match count {
        0 => None,
        _ if length > 0.0 => Some(ends[2 * count - 1]),
        _ => Some(ends[0]),
    }
}
