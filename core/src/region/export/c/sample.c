
/* The lower and upper ends of all intervals that are admitted; returns how many there are. */
static inline int @_intervals(const @_real *instance, @_real *ends)
{
    @_cut cut;
    cut.count = 0;
    cut.hold = cut.equal = 0;
    (void)instance;
