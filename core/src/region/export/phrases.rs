//! What two languages say differently, as templates: `$a`, `$b` and so on are what is put in,
//! and `@_` is what names in C begin with.

/// A language that a region is written in.
pub(super) struct Phrases {
    /// How the comment at the head begins, what its lines begin with, and how it ends.
    pub(super) comment: [&'static str; 3],
    /// A name, and a whole number that stands for it.
    pub(super) count: &'static str,
    // Values.
    pub(super) zero: &'static str,
    pub(super) one: &'static str,
    /// A number of the text.
    pub(super) number: &'static str,
    /// How a constant begins, a number or a flag, that is named `$a`.
    pub(super) real: &'static str,
    pub(super) flag: &'static str,
    pub(super) abs: &'static str,
    pub(super) sqrt: &'static str,
    pub(super) atan2: &'static str,
    /// Names the sine and the cosine of `$c`.
    pub(super) sin_cos: &'static str,
    /// More than any number, and less.
    pub(super) infinite: [&'static str; 2],
    /// One of two, if the flag `$a` is set or not.
    pub(super) choose: &'static str,
    /// The derivative of the magnitude of `$a`, of which that is `$b`; at zero, as if it had
    /// moved the value.
    pub(super) magnitude_slope: &'static str,
    /// The derivative of the length `$f` of a vector, of whose square that is `$g`, twice
    /// over. A vector along the x axis (y is `$a`, its derivative `$b`, for z `$c` and `$d`)
    /// is as long as that coordinate is far from zero, with the derivative `$e`.
    pub(super) length_slope: &'static str,
    /// `$b / $a`, or zero.
    pub(super) ratio: &'static str,
    /// The difference `$c` of two, which is zero if they are equal and infinite.
    pub(super) margin: &'static str,
    /// The derivative `$b` of `$a`, or zero if that is infinite.
    pub(super) slope: &'static str,
    // Functions.
    /// What is there for every region: numbers, then sines.
    pub(super) begin: &'static str,
    pub(super) sines: &'static str,
    pub(super) holds_begin: &'static str,
    /// How the step `$a` begins; what the constraint `$a` and truth are; what stands
    /// around the last step.
    pub(super) step: &'static str,
    pub(super) bit: &'static str,
    pub(super) truth: &'static str,
    pub(super) holds_end: [&'static str; 2],
    pub(super) contains_begin: &'static str,
    /// Notes whether `$a` compares with `$c` by `$b`, for the constraint `$d`.
    pub(super) met: &'static str,
    pub(super) contains_end: &'static str,
    pub(super) margins_begin: &'static str,
    /// How what is written to the derivative of `$a` by `$b` begins; `$c` is its number.
    pub(super) gradient: &'static str,
    pub(super) margins_end: &'static str,
    pub(super) cutting: &'static str,
    /// Cuts the line from `$l` to `$m` at the roots of a curve, `$a` to `$i`, for the
    /// constraint `$j` with the comparison `$k`.
    pub(super) cut: &'static str,
    /// Joins what is between the cuts, from `$a` to `$b`.
    pub(super) cutting_end: &'static str,
    pub(super) drawing: &'static str,
    pub(super) end: &'static str,
}

/// C99, and C++.
pub(super) static C: Phrases = Phrases {
    comment: ["/* ", " *", " */\n"],
    count: "#define @_$a $b\n",
    zero: "(@_real)0",
    one: "(@_real)1",
    number: "(@_real)$a",
    real: "    @_LET $a = ",
    flag: "    @_LET $a = ",
    abs: "@_abs($a)",
    sqrt: "@_sqrt($a)",
    atan2: "@_atan2($a, $b)",
    sin_cos: "    @_real $a, $b;\n    @_sin_cos($c, &$a, &$b);\n",
    infinite: ["(@_real)INFINITY", "-(@_real)INFINITY"],
    choose: "$a != 0 ? $b : $c",
    magnitude_slope: "$a < 0 || ($a == 0 && $b < 0) ? -$b : $b",
    length_slope: "$a == 0 && $b == 0 && $c == 0 && $d == 0 ? $e : $f == 0 ? 0 : $g / ($f + $f)",
    ratio: "$a == 0 ? 0 : $b / $a",
    margin: "$a == $b ? 0 : $c",
    slope: "$a - $a == 0 ? $b : 0",
    begin: include_str!("c/begin.c"),
    sines: include_str!("c/sine.c"),
    holds_begin: "
/* Whether the region has what satisfies these constraints, a bit each. */
static inline int @_holds(unsigned long constraints)
{
    (void)constraints;
",
    step: "    const int b$a = ",
    bit: "(int)(constraints >> $a & 1)",
    truth: "1",
    holds_end: ["    return ", ";\n}\n"],
    contains_begin: "
/* Whether parameters are inside. */
static inline int @_contains(const @_real *instance, const @_real *theta)
{
    unsigned long holds = 0;
    int inside = 1;
    (void)instance, (void)theta;
",
    met: "    holds |= (unsigned long)($a $b $c) << $d;\n",
    contains_end: "    return inside && @_holds(holds);\n}\n",
    margins_begin: "
/* How far each constraint is from its bound, at most 0 where it holds, and its
 * derivatives by the parameters, those of the first constraint first. */
static inline void @_margins(const @_real *instance, const @_real *theta,
    @_real *values, @_real *gradients)
{
    (void)instance, (void)theta;
    (void)values, (void)gradients;
",
    gradient: "    gradients[$c] = ",
    margins_end: "}\n",
    cutting: concat!(include_str!("c/cut.c"), include_str!("c/sample.c")),
    cut: "    {
        @_real c[9] = {$a, $b, $c, $d, $e, $f, $g, $h, $i, };
        @_cut_by(&cut, $j, $k, c, $l, $m);
    }
",
    cutting_end: "    return @_join(&cut, $a, $b, ends);\n}\n",
    drawing: include_str!("c/draw.c"),
    end: "\n#endif\n",
};

/// Rust, in double or single precision: a module that needs the crate `libm` only.
pub(super) static RUST_F64: Phrases = rust(concat!(
    include_str!("rust/begin.rs"),
    include_str!("rust/double.rs")
));
pub(super) static RUST_F32: Phrases = rust(concat!(
    include_str!("rust/begin.rs"),
    include_str!("rust/single.rs"),
    "\nmod sine {\n",
    include_str!("../../real/sine.rs"),
    "}\n"
));

const fn rust(begin: &'static str) -> Phrases {
    Phrases {
        comment: ["//! ", "//!", "\n"],
        count: "pub const $a: usize = $b;\n",
        zero: "0.0",
        one: "1.0",
        // Rounded once, as the library rounds it.
        number: "$af64 as Real",
        real: "    let $a: Real = ",
        flag: "    let $a = ",
        abs: "abs($a)",
        sqrt: "sqrt($a)",
        atan2: "atan2($a, $b)",
        sin_cos: "    let ($a, $b) = sin_cos($c);\n",
        infinite: ["Real::INFINITY", "Real::NEG_INFINITY"],
        choose: "if $a { $b } else { $c }",
        magnitude_slope: "if $a < 0.0 || ($a == 0.0 && $b < 0.0) { -$b } else { $b }",
        length_slope: "if $a == 0.0 && $b == 0.0 && $c == 0.0 && $d == 0.0 { $e } \
                       else if $f == 0.0 { 0.0 } else { $g / ($f + $f) }",
        ratio: "if $a == 0.0 { 0.0 } else { $b / $a }",
        margin: "if $a == $b { 0.0 } else { $c }",
        slope: "if $a - $a == 0.0 { $b } else { 0.0 }",
        begin,
        sines: "",
        holds_begin: "
/// Whether the region has what satisfies these constraints, a bit each.
fn holds(constraints: u32) -> bool {
",
        step: "    let b$a = ",
        bit: "(constraints >> $a) & 1 == 1",
        truth: "true",
        holds_end: ["    ", "\n}\n"],
        contains_begin: "
/// Whether parameters are inside.
pub fn contains(instance: &[Real; INSTANCE_LEN], theta: &[Real; PARAMETERS]) -> bool {
    let mut met = 0;
    let mut inside = true;
",
        met: "    met |= u32::from($a $b $c) << $d;\n",
        contains_end: "    inside && holds(met)\n}\n",
        margins_begin: "
/// How far each constraint is from its bound, at most 0 where it holds, and its derivatives by
/// the parameters.
pub fn margins(
    instance: &[Real; INSTANCE_LEN],
    theta: &[Real; PARAMETERS],
    values: &mut [Real; CONSTRAINTS],
    gradients: &mut [[Real; PARAMETERS]; CONSTRAINTS],
) {
",
        gradient: "    gradients[$a][$b] = ",
        margins_end: "}\n",
        cutting: concat!(
            include_str!("rust/cut.rs"),
            include_str!("rust/intervals.rs")
        ),
        cut: "    cut.by($j, $k, [$a, $b, $c, $d, $e, $f, $g, $h, $i], [$l, $m]);\n",
        cutting_end: "    cut.join($a, $b, ends)\n}\n",
        drawing: include_str!("rust/draw.rs"),
        end: "",
    }
}
