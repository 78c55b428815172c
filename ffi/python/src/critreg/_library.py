"""The shared library: where it is, its functions, and how their answers are read."""

from __future__ import annotations

import ctypes
import os
import pathlib
import sys
from ctypes import POINTER, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p
from typing import Any, Callable, Optional, Type, TypeVar

from ._structs import RngStruct
from .status import error

ABI_VERSION = 0

_HERE = pathlib.Path(__file__).resolve().parent
_NAMES = {"darwin": "libcritreg.dylib", "win32": "critreg.dll"}
_CHECKOUT = _HERE.parents[3]  # If the package is used from one.
_BUILT = [
    _CHECKOUT / "target" / "c" / "libcritreg.so",
    _CHECKOUT / "target" / "release" / "libcritreg_ffi.dylib",
]

_STATUS, _SIZE, _TEXT, _ANY = c_int32, c_size_t, c_char_p, c_void_p
_INSTANCES = [_ANY, _SIZE]
_BUFFER = [_ANY, _SIZE, _ANY]
_MEMORY = [_ANY, _SIZE]
_QUESTIONS = [_SIZE, _ANY, _ANY, _ANY, _ANY]

# Pointers are plain addresses, so that arrays can be passed from any place in them.
ARGUMENTS: dict[str, list[Any]] = {
    "critreg_abi_version": [],
    "critreg_version": [],
    "critreg_strerror": [_STATUS],
    "critreg_status_name": [_STATUS],
    "critreg_check_domain": [_TEXT, *_BUFFER],
    "critreg_check_region": [_TEXT, _TEXT, *_BUFFER],
    "critreg_check_pddl": [_TEXT, _TEXT, *_BUFFER],
    "critreg_config_init": [_ANY, _SIZE],
    "critreg_report_init": [_ANY, _SIZE],
    "critreg_learner_size": [_ANY],
    "critreg_learner_init": [*_MEMORY, _TEXT, _ANY, _ANY],
    "critreg_choose_instances": [_ANY, _SIZE, _ANY, _ANY, _ANY, _SIZE, _ANY],
    "critreg_learn_region": [_ANY, *_INSTANCES, _ANY, _ANY, _ANY],
    "critreg_ask": [_ANY, *_INSTANCES, _ANY, _ANY],
    "critreg_tell": [_ANY, *_INSTANCES, _STATUS],
    "critreg_observe": [_ANY, *_INSTANCES, _SIZE, _ANY, _STATUS],
    "critreg_conclude": [_ANY, *_INSTANCES],
    "critreg_ask_many": [_ANY, *_INSTANCES, *_QUESTIONS],
    "critreg_tell_id": [_ANY, *_INSTANCES, c_uint64, _STATUS],
    "critreg_forget": [_ANY, c_uint64],
    "critreg_open_questions": [_ANY, *_QUESTIONS],
    "critreg_is_finished": [_ANY, _ANY],
    "critreg_learner_region": [_ANY, _ANY],
    "critreg_learner_challenge": [_ANY, _ANY, _ANY, _ANY, _ANY, _ANY],
    "critreg_learner_why": [_ANY, _ANY, *_BUFFER],
    "critreg_learner_report": [_ANY, _ANY],
    "critreg_learner_message": [_ANY, *_BUFFER],
    "critreg_learner_save": [_ANY, *_INSTANCES, *_BUFFER],
    "critreg_learner_resume": [_ANY, *_INSTANCES, _ANY, _SIZE],
    "critreg_learner_journal": [_ANY, *_INSTANCES, _SIZE, *_BUFFER],
    "critreg_learner_resume_journal": [_ANY, *_INSTANCES, _ANY, _SIZE, _ANY],
    "critreg_learner_to_svg": [_ANY, *_INSTANCES, _SIZE, *_BUFFER],
    "critreg_region_size": [],
    "critreg_region_parse": [*_MEMORY, _TEXT, _TEXT, _ANY],
    "critreg_region_load": [*_MEMORY, _ANY, _SIZE, _ANY],
    "critreg_region_save": [_ANY, *_BUFFER],
    "critreg_region_format": [_ANY, *_BUFFER],
    "critreg_region_quality": [_ANY, _ANY],
    "critreg_region_instance_len": [_ANY, _ANY],
    "critreg_region_parameter_count": [_ANY, _ANY],
    "critreg_region_constraint_count": [_ANY, _ANY],
    "critreg_constraint_init": [_ANY, _SIZE],
    "critreg_region_constraint": [_ANY, _SIZE, _ANY],
    "critreg_region_constraint_format": [_ANY, _SIZE, *_BUFFER],
    "critreg_region_constraint_name": [_ANY, _SIZE, *_BUFFER],
    "critreg_region_contains": [_ANY, _ANY, _ANY, _ANY],
    "critreg_region_contains_many": [_ANY, _ANY, _ANY, _SIZE, _ANY],
    "critreg_region_margins": [_ANY, _ANY, _ANY, _ANY, _ANY],
    "critreg_proof_init": [_ANY, _SIZE],
    "critreg_region_implies": [_ANY, _ANY, _ANY, _ANY, _ANY, _ANY],
    "critreg_region_question_count": [_ANY, _ANY],
    "critreg_region_to_smt2": [_ANY, _ANY, _ANY, _ANY, _SIZE, *_BUFFER],
    "critreg_region_to_c": [_ANY, _TEXT, *_BUFFER],
    "critreg_region_to_rust": [_ANY, c_uint32, *_BUFFER],
    "critreg_region_to_svg": [_ANY, _ANY, *_BUFFER],
    "critreg_region_intervals": [_ANY, _ANY, _ANY, _SIZE, _ANY],
    "critreg_region_is_empty": [_ANY, _ANY, _ANY],
    "critreg_sample_region": [_ANY, _ANY, _ANY, _ANY],
    "critreg_sample_regions": [_ANY, _ANY, _SIZE, _ANY, _ANY],
    "critreg_regions_are_empty": [_ANY, _ANY, _SIZE, _ANY],
    "critreg_rng_seed": [c_uint64],
    "critreg_rng_uniform": [_ANY, _ANY],
    "critreg_planner_config_init": [_ANY, _SIZE],
    "critreg_planner_measure": [_TEXT, _TEXT, _ANY],
    "critreg_planner_size": [_ANY],
    "critreg_planner_init": [*_MEMORY, _TEXT, _TEXT, _ANY, _ANY],
    "critreg_planner_set_ranges": [_ANY, _TEXT, _ANY, _SIZE],
    "critreg_planner_message": [_ANY, *_BUFFER],
    "critreg_callbacks_init": [_ANY, _SIZE],
    "critreg_plan": [_ANY, _ANY, _ANY, c_uint64, _ANY, _ANY],
    "critreg_step_init": [_ANY, _SIZE],
    "critreg_planner_step": [_ANY, _SIZE, _ANY],
    "critreg_metrics_init": [_ANY, _SIZE],
    "critreg_planner_metrics": [_ANY, _ANY],
    "critreg_planner_why": [_ANY, _ANY, *_BUFFER],
    "critreg_planner_failures": [_ANY, _TEXT, _ANY],
    "critreg_planner_reasons": [_ANY, c_uint32, _ANY],
    "critreg_planner_reason_text": [_ANY, *_BUFFER],
    "critreg_skills_config_init": [_ANY, _SIZE],
    "critreg_skills_size": [_ANY],
    "critreg_skills_init": [*_MEMORY, _TEXT, _TEXT, _ANY, _ANY],
    "critreg_skills_add_controller": [_ANY, _TEXT, _TEXT, _TEXT, _ANY, _SIZE],
    "critreg_skills_add": [_ANY, _TEXT, _TEXT, _TEXT, _TEXT],
    "critreg_skills_add_task": [_ANY, _TEXT, _ANY, _SIZE],
    "critreg_skills_message": [_ANY, *_BUFFER],
    "critreg_skills_learn": [_ANY, _ANY, _ANY],
    "critreg_skill_report_init": [_ANY, _SIZE],
    "critreg_skills_report": [_ANY, _SIZE, _ANY],
    "critreg_skills_format": [_ANY, _SIZE, *_BUFFER],
    "critreg_skills_domain": [_ANY, _SIZE, *_BUFFER],
    "critreg_skills_save": [_ANY, *_BUFFER],
    "critreg_skills_resume": [_ANY, _ANY, _SIZE],
}

# Of those that return no status.
RESULTS: dict[str, Any] = {
    "critreg_abi_version": c_uint32,
    "critreg_version": _TEXT,
    "critreg_strerror": _TEXT,
    "critreg_status_name": _TEXT,
    "critreg_learner_size": _SIZE,
    "critreg_region_size": _SIZE,
    "critreg_planner_size": _SIZE,
    "critreg_skills_size": _SIZE,
    "critreg_rng_seed": RngStruct,
}

# What a planner asks.
_GROUND, _NUMBERS = c_void_p, POINTER(c_double)
EXECUTE = ctypes.CFUNCTYPE(
    _STATUS, _ANY, _GROUND, _NUMBERS, _NUMBERS, _NUMBERS, _SIZE, POINTER(c_uint32)
)
HOLDS = ctypes.CFUNCTYPE(_STATUS, _ANY, _GROUND, _NUMBERS, _SIZE, POINTER(c_int32))
SAMPLE = ctypes.CFUNCTYPE(_STATUS, _ANY, _ANY, POINTER(RngStruct), _ANY)
ADVISE = ctypes.CFUNCTYPE(
    _STATUS, _ANY, _GROUND, _SIZE, _NUMBERS, _SIZE, POINTER(c_int32), POINTER(c_uint32)
)
MAKE = ctypes.CFUNCTYPE(_STATUS, _ANY, _SIZE, _NUMBERS)
TRAINING = ctypes.CFUNCTYPE(_STATUS, _ANY, _ANY)
SIMULATE = ctypes.CFUNCTYPE(_STATUS, _ANY, _NUMBERS, _NUMBERS, POINTER(c_int32))


def _find() -> str:
    named = os.environ.get("CRITREG_LIBRARY")
    if named:
        return named
    inside = _HERE / _NAMES.get(sys.platform, "libcritreg.so")
    for path in [inside, *_BUILT]:
        if path.exists():
            return os.fspath(path)
    raise ImportError(
        f"there is no {inside}: install the package (pip install ./ffi/python), run make at"
        " the top of the checkout, or name a library in CRITREG_LIBRARY"
    )


def _load() -> ctypes.CDLL:
    path = _find()
    library = ctypes.CDLL(path)
    for name, types in ARGUMENTS.items():
        function = getattr(library, name, None)
        if function is None:
            raise ImportError(f"{path} has no {name}: it is of another version")
        function.argtypes = types
        function.restype = RESULTS.get(name, _STATUS)
    if library.critreg_abi_version() != ABI_VERSION:
        raise ImportError(f"{path} is of another version of the interface")
    return library


library = _load()

Number = TypeVar("Number", bound="ctypes._SimpleCData[Any]")
Struct = TypeVar("Struct", bound=ctypes.Structure)


def words(status: int) -> str:
    """What a status means."""
    return bytes(library.critreg_strerror(status)).decode()


def check(status: int, message: str = "") -> None:
    """Raises what a status says, in these words or in general ones."""
    if status != 0:
        raise error(status, message or words(status))


def out(kind: Type[Number], function: Callable[..., int], *arguments: Any) -> Any:
    """The last argument of a function, which it writes."""
    value = kind()
    check(function(*arguments, ctypes.byref(value)))
    return value.value


def made(kind: Type[Struct], init: Callable[..., int]) -> Struct:
    """A struct with the library's defaults."""
    struct = kind()
    check(init(ctypes.byref(struct), ctypes.sizeof(struct)))
    return struct


def filled(
    function: Callable[..., int],
    *arguments: Any,
    checked: Callable[[int], None] = check,
) -> bytes:
    """What a function writes into a buffer, however long."""
    needed = c_size_t()
    status = function(*arguments, None, 0, ctypes.byref(needed))
    if status != 3:  # TOO_SMALL, which is how it tells the length.
        checked(status)
    buffer = ctypes.create_string_buffer(needed.value)
    checked(function(*arguments, buffer, len(buffer), None))
    return buffer.raw


def text_of(function: Callable[..., int], *arguments: Any) -> str:
    """The text that a function writes."""
    return filled(function, *arguments).rstrip(b"\0").decode()


def complaint(check_text: Callable[..., int], *texts: bytes) -> tuple[int, str]:
    """The status of texts, and what is wrong with them; empty if nothing is."""
    buffer = ctypes.create_string_buffer(256)
    status = check_text(*texts, buffer, len(buffer), None)
    return status, buffer.value.decode(errors="replace")


def encoded(text: str) -> bytes:
    """A text for the library, which would take a NUL for its end."""
    if not isinstance(text, str):
        raise TypeError(f"a text is a str, not {type(text).__name__}")
    if "\0" in text:
        raise ValueError("a text has a NUL inside")
    return text.encode()


def configured(config: ctypes.Structure, options: dict[str, Any]) -> None:
    """Sets fields of a configuration; what a field cannot hold is refused, not cut off."""
    fields = dict((field[0], field[1]) for field in config._fields_)
    for name, value in options.items():
        kind = fields.get(name)
        if kind is None or name in ("struct_size", "reserved") or kind is c_void_p:
            raise TypeError(f"a configuration has no {name}, but {', '.join(fields)}")
        setattr(config, name, value)
        if kind is not c_double and getattr(config, name) != value:
            raise ValueError(f"{name} is {value}, which is none that a configuration can hold")


def memory(size: int) -> ctypes.Array[c_uint64]:
    """Memory for a handle, aligned."""
    return (c_uint64 * (size // 8 + 1))()


def checked_id(number: int, what: str, bits: int = 64) -> int:
    """A whole number that C can hold: ctypes would cut off a larger one."""
    if not 0 <= number < 1 << bits:
        raise ValueError(f"{what} is {number}; it is from 0 to 2^{bits} - 1")
    return number


