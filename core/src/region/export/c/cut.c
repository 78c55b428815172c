
/* A line cut where constraints change their minds. */
typedef struct {
    @_real at[2 * @_CONSTRAINTS];
    unsigned char root[2 * @_CONSTRAINTS]; /* the constraint, and whether it then holds */
    int count;
    unsigned long hold, equal;
} @_cut;

static inline @_real @_length(@_real x, @_real y, @_real z)
{
    return y == 0 && z == 0 ? @_abs(x) : @_sqrt(x * x + y * y + z * z);
}

/* Of a curve: c[0] + c[1] t + c[2] |(c[3] + c[4] t, c[5] + c[6] t, c[7] + c[8] t)|. */
static inline @_real @_value(const @_real *c, @_real t)
{
    const @_real line = c[0] + c[1] * t;
    if (c[2] == 0)
        return line;
    return line + c[2] * @_length(c[3] + c[4] * t, c[5] + c[6] * t, c[7] + c[8] * t);
}

static inline void @_roots(const @_real *c, @_real *roots)
{
    const int x = c[3] != 0 || c[4] != 0, y = c[5] != 0 || c[6] != 0, z = c[7] != 0 || c[8] != 0;
    const @_real square = c[2] * c[2];
    @_real a, b, d, e, q, root;
    roots[0] = roots[1] = (@_real)NAN;
    if (c[2] == 0) {
        roots[0] = -c[0] / c[1];
    } else if (x + y + z <= 1) {
        const @_real *v = y ? c + 5 : z ? c + 7 : c + 3;
        const @_real at = c[2] * v[0], slope = c[2] * v[1];
        roots[0] = -(c[0] + at) / (c[1] + slope);
        roots[1] = -(c[0] - at) / (c[1] - slope);
    } else {
        a = square * (c[4] * c[4] + c[6] * c[6] + c[8] * c[8]) - c[1] * c[1];
        b = square * (c[3] * c[4] + c[5] * c[6] + c[7] * c[8]) - c[0] * c[1];
        d = square * (c[3] * c[3] + c[5] * c[5] + c[7] * c[7]) - c[0] * c[0];
        e = b * b - a * d;
        root = (@_real)8 * @_EPSILON * b * b;
        if (e < -root)
            return;
        root = @_abs(e) <= root ? 0 : @_sqrt(e);
        q = b < 0 ? root - b : -(b + root);
        roots[0] = q / a;
        roots[1] = d / q;
    }
}

static inline int @_compares(int sign, @_real value)
{
    return sign == 0 ? value < 0 : sign == 1 ? value <= 0 : sign == 2 ? value >= 0 : value > 0;
}

static inline int @_is_root(const @_real *c, @_real low, @_real high, @_real t)
{
    const @_real size = @_abs(c[0]) + @_abs(c[1] * t);
    return low <= t && t <= high && @_abs(@_value(c, t)) <= @_SQRT_EPSILON * (1 + size);
}

/* Whether a constraint holds between two places; it is cut at the first one. */
static inline int @_between(const @_real *c, int sign, @_real a, @_real b)
{
    return @_compares(sign, @_value(c, a + (b - a) * (@_real)0.5));
}

static inline void @_cut_at(@_cut *cut, int owner, @_real at, int holds)
{
    int i;
    for (i = cut->count++; i > 0 && at < cut->at[i - 1]; i--) {
        cut->at[i] = cut->at[i - 1];
        cut->root[i] = cut->root[i - 1];
    }
    cut->at[i] = at;
    cut->root[i] = (unsigned char)(2 * owner + holds);
}

/* Cuts a line at the roots of a curve; signs are <, <=, >=, > from 0. */
static inline void @_cut_by(@_cut *cut, int owner, int sign, @_real *c, @_real low, @_real high)
{
    @_real roots[2], end = high;
    int first;
    if (c[2] != 0 && c[4] == 0 && c[6] == 0 && c[8] == 0) {
        c[0] += c[2] * @_length(c[3], c[5], c[7]);
        c[2] = 0;
    }
    @_roots(c, roots);
    if (roots[1] < roots[0]) {
        const @_real swap = roots[0];
        roots[0] = roots[1];
        roots[1] = swap;
    }
    first = @_is_root(c, low, high, roots[0]);
    if (@_is_root(c, low, high, roots[1]) && !(first && roots[0] == roots[1])) {
        @_cut_at(cut, owner, roots[1], @_between(c, sign, roots[1], end));
        end = roots[1];
    }
    if (first) {
        @_cut_at(cut, owner, roots[0], @_between(c, sign, roots[0], end));
        end = roots[0];
    }
    cut->hold |= (unsigned long)@_between(c, sign, low, end) << owner;
    cut->equal |= (unsigned long)(sign == 1 || sign == 2) << owner;
}

/* The lower and upper ends of all intervals; returns how many there are. */
static inline int @_join(const @_cut *cut, @_real low, @_real high, @_real *ends)
{
    unsigned long hold = cut->hold;
    int next = 0, count = 0, open = 0;
    @_real at = low;
    for (;;) {
        unsigned long owners = 0, then = 0;
        int here, after;
        for (; next < cut->count && cut->at[next] == at; next++) {
            const unsigned long bit = 1ul << (cut->root[next] >> 1);
            owners |= bit;
            then = cut->root[next] & 1 ? then | bit : then;
        }
        here = @_holds((hold & ~owners) | (owners & cut->equal));
        hold = (hold & ~owners) | then;
        after = at < high && @_holds(hold);
        if (!open && after) {
            ends[2 * count] = at;
            open = 1;
        } else if (!open && here) {
            ends[2 * count] = ends[2 * count + 1] = at;
            count++;
        } else if (open && !(here && after)) {
            ends[2 * count + 1] = at;
            count++;
            ends[2 * count] = at;
            open = after;
        }
        if (!(at < high))
            return count;
        at = next < cut->count ? cut->at[next] : high;
    }
}
