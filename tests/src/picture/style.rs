//! How the pictures look.

/// How everything looks, by class.
pub(super) const STYLE: &str = "\
text{font:13px sans-serif;fill:#222}
.title{font-weight:bold}
.small{font-size:11px}
.code{font:10px monospace}
.middle{text-anchor:middle}
.end{text-anchor:end}
.background{fill:#fff}
.table{fill:none;stroke:#555}
.zone{fill:#e8eef7}
.feasible{fill:#1a9641}
.partly{fill:#b8e0b0}
.infeasible{fill:#e58a86}
.robot{fill:#4575b4;stroke:#222}
.button{fill:#ffd42a;stroke:#222}
.holder{fill:#8c6d46;stroke:#222}
.stick{fill:#222}
.tip{fill:#d600a8}
.axis{fill:none;stroke:#555}
.grid{fill:none;stroke:#ddd}
.original{fill:none;stroke:#d55e00;stroke-width:1.5}
.learned{fill:none;stroke:#0072b2;stroke-width:1.5}
.original-mark{fill:#d55e00}
.learned-mark{fill:#0072b2}
";
