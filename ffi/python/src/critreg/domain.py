"""Domain texts: what there is to know about an action."""

from __future__ import annotations

import ast
import math
import operator
import re
from ctypes import byref, c_size_t, c_void_p
from typing import Any, NamedTuple, Union

from ._library import check, complaint, encoded, library, memory, out

# As the grammar of the domain text has it; comments end with their lines.
_COMMENT = re.compile(r"#.*")
_PARAMETER = re.compile(r"\bparameter\s+(\w+)\s+in\s*\[([^,\]]*),([^\]]*)\]")
_CONSTANT = re.compile(r"\bconstant\s+([\w.]+)\s*=([^:]*):")
_ATTRIBUTES = r"\{([^}]*)\}"
_TYPE = re.compile(rf"\btype\s+(\w+)\s*{_ATTRIBUTES}")
_OBJECT = re.compile(rf"\bobject\s+([^{{:]*)(?:{_ATTRIBUTES}|:\s*(\w+))")
_NAMED = re.compile(r"(\w+)\s*(?:\[\s*(\d+)\s*\])?")

_OPERATIONS = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.USub: operator.neg,
}


class Role(NamedTuple):
    """An object that a domain text declares, or a group of them."""

    name: str
    attributes: dict[str, str]
    """Their dimensions, by their names."""
    members: int
    """How many members the group has at most; 0 for a single object."""


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
    ranges: tuple[tuple[float, float], ...]
    """Their least and greatest values."""
    objects: tuple[Role, ...]
    """Its objects and groups, in order."""

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
        plain = _COMMENT.sub("", text)
        constants = {"pi": math.pi}
        for name, value in _CONSTANT.findall(plain):
            constants[name] = _value(value, constants)
        declared = _PARAMETER.findall(plain)
        self.parameters = tuple(name for name, _, _ in declared)
        self.ranges = tuple(
            (_value(low, constants), _value(high, constants)) for _, low, high in declared
        )
        types = {name: _attributes(listed) for name, listed in _TYPE.findall(plain)}
        self.objects = tuple(
            Role(name, types[kind] if kind else _attributes(listed), int(members or 0))
            for names, listed, kind in _OBJECT.findall(plain)
            for name, members in _NAMED.findall(names)
        )
        assert len(self.parameters) == out(
            c_size_t, library.critreg_region_parameter_count, handle
        )

    def __repr__(self) -> str:
        return f"Domain({self.text!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Domain) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)


def _attributes(listed: str) -> dict[str, str]:
    pairs = (pair.split(":") for pair in listed.split(",") if pair.strip())
    return {name.strip(): dimension.strip() for name, dimension in pairs}


def _value(expression: str, constants: dict[str, float]) -> float:
    """The number that an expression of constants is; the library has checked it."""

    def value(node: Any) -> float:
        if isinstance(node, ast.Constant):
            return float(str(node.value))
        if isinstance(node, ast.UnaryOp):
            return float(_OPERATIONS[type(node.op)](value(node.operand)))  # type: ignore
        if isinstance(node, ast.BinOp):
            operation: Any = _OPERATIONS[type(node.op)]
            return float(operation(value(node.left), value(node.right)))
        return constants[ast.unparse(node)]

    return value(ast.parse(expression.strip(), mode="eval").body)


def as_domain(domain: Union[Domain, str]) -> Domain:
    """The domain of a text, unless it is one already."""
    return domain if isinstance(domain, Domain) else Domain(domain)
