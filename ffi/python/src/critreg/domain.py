"""Domain texts: what there is to know about an action."""

from __future__ import annotations

import re
from ctypes import byref, c_size_t, c_void_p
from typing import Union

from ._library import check, complaint, encoded, library, memory, out

# As the grammar of the domain text has it; comments end with their lines.
_COMMENT = re.compile(r"#.*")
_PARAMETER = re.compile(r"\bparameter\s+(\w+)\s+in\b")


class Domain:
    """A domain text that was checked.

    Its grammar stands in ACTIONS.md and in critreg.h. A text that is wrong raises
    `Error` with line, column and what was expected.
    """

    text: str
    """The text itself."""
    instance_len: int
    """How many numbers an instance has: one per attribute of every object, in order."""
    parameters: tuple[str, ...]
    """The names of the action's parameters: a sample has a number for each, in order."""

    def __init__(self, text: str) -> None:
        self.text = text
        domain = encoded(text)
        check(*complaint(library.critreg_check_domain, domain))
        # The region that holds everywhere knows how long instances are.
        room = memory(library.critreg_region_size())
        size = library.critreg_region_size()
        handle = c_void_p()
        check(library.critreg_region_parse(room, size, domain, b"true", byref(handle)))
        self.instance_len = out(c_size_t, library.critreg_region_instance_len, handle)
        self.parameters = tuple(_PARAMETER.findall(_COMMENT.sub("", text)))
        assert len(self.parameters) == out(
            c_size_t, library.critreg_region_parameter_count, handle
        )

    def __repr__(self) -> str:
        return f"Domain({self.text!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Domain) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)


def as_domain(domain: Union[Domain, str]) -> Domain:
    """The domain of a text, unless it is one already."""
    return domain if isinstance(domain, Domain) else Domain(domain)
