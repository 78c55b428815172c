
/* The parameter below which a share in [0, 1) of what is admitted lies: a uniform share
 * makes a uniform draw. Returns 0 if nothing is admitted. */
static inline int @_sample(const @_real *instance, @_real share, @_real *theta)
{
    @_real ends[2 * @_MAX_INTERVALS], length = 0, left;
    const int count = @_intervals(instance, ends);
    int i;
    for (i = 0; i < count; i++)
        length += ends[2 * i + 1] - ends[2 * i];
    left = share * length;
    for (i = 0; i < count; i++) {
        const @_real own = ends[2 * i + 1] - ends[2 * i];
        if (left < own) {
            theta[0] = ends[2 * i] + left;
            return 1;
        }
        left -= own;
    }
    if (count > 0)
        theta[0] = length > 0 ? ends[2 * count - 1] : ends[0];
    return count > 0;
}
