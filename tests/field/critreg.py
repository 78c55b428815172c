"""The part of the C interface that the scenario runner needs, for Python.

The functions are those of include/critreg.h, which is their manual. What fails raises
`Error`, with the library's own words.
"""

import ctypes
import os
import pathlib

ABI_VERSION = 0
OK, NO_REGION = 0, 10
FEASIBLE, INFEASIBLE = 1, 0

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
FILES = ["libcritreg_ffi.so", "libcritreg_ffi.dylib"]


class Error(Exception):
    """A call failed. `status` is the name of what it returned."""

    def __init__(self, status, message):
        super().__init__(message)
        self.status = status


class Config(ctypes.Structure):
    """critreg_config."""

    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("learner", ctypes.c_uint32),
        ("seed", ctypes.c_uint64),
        ("hypotheses", ctypes.c_uint32),
        ("observations", ctypes.c_uint32),
        ("iterations", ctypes.c_uint32),
        ("certifying", ctypes.c_uint32),
        ("instances", ctypes.c_uint32),
        ("steps", ctypes.c_uint32),
        ("noise", ctypes.c_double),
        ("exploring", ctypes.c_double),
        ("slack", ctypes.c_double),
        ("confidence", ctypes.c_double),
        ("negative", ctypes.c_void_p),
        ("positive", ctypes.c_void_p),
        ("progress", ctypes.c_void_p),
        ("progress_data", ctypes.c_void_p),
        ("tracked", ctypes.c_uint32),
        ("precision", ctypes.c_uint32),
    ]


def _load():
    named = os.environ.get("CRITREG_LIBRARY")
    built = [CHECKOUT / "target" / "release" / file for file in FILES]
    paths = [named] if named else [path for path in built if path.exists()]
    if not paths:
        raise ImportError(
            "no library of critreg: run `make -C c_examples library`, or name one in CRITREG_LIBRARY"
        )
    library = ctypes.CDLL(os.fspath(paths[0]))
    pointer, size, text = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_char_p
    # Whatever is not a status has its type of result here.
    results = {
        "critreg_abi_version": ctypes.c_uint32,
        "critreg_strerror": text,
        "critreg_status_name": text,
        "critreg_learner_size": size,
    }
    # Pointers are plain addresses, so that an array can be passed from any place in it.
    arguments = {
        "critreg_abi_version": [],
        "critreg_strerror": [ctypes.c_int32],
        "critreg_status_name": [ctypes.c_int32],
        "critreg_check_domain": [text, pointer, size, pointer],
        "critreg_config_init": [pointer, size],
        "critreg_learner_size": [pointer],
        "critreg_learner_init": [pointer, size, text, pointer, pointer],
        "critreg_learner_instance_len": [pointer, pointer],
        "critreg_learner_parameter_count": [pointer, pointer],
        "critreg_learner_message": [pointer, pointer, size, pointer],
        "critreg_is_finished": [pointer, pointer],
        "critreg_ask": [pointer, pointer, size, pointer, pointer],
        "critreg_tell": [pointer, pointer, size, ctypes.c_int32],
        "critreg_observe": [pointer, pointer, size, size, pointer, ctypes.c_int32],
        "critreg_learner_region": [pointer, pointer],
        "critreg_region_format": [pointer, pointer, size, pointer],
        "critreg_region_contains": [pointer, pointer, pointer, pointer],
    }
    for name, types in arguments.items():
        function = getattr(library, name)
        function.argtypes = types
        function.restype = results.get(name, ctypes.c_int32)
    if library.critreg_abi_version() != ABI_VERSION:
        raise ImportError(f"{paths[0]} is of another version of the interface")
    return library


_library = _load()


def numbers(values):
    """An array of doubles for the library."""
    return (ctypes.c_double * len(values))(*values)


def _check(status, message=""):
    """Raises what a status says, in these words or in general ones."""
    if status != OK:
        name = _library.critreg_status_name(status).decode()
        raise Error(name, message or _library.critreg_strerror(status).decode())


def _out(kind, function, *arguments):
    """The last argument of a function, which it writes."""
    value = kind()
    _check(function(*arguments, ctypes.addressof(value)))
    return value.value


def _text(function, *arguments):
    """A text that a function writes, however long."""
    needed = ctypes.c_size_t()
    function(*arguments, None, 0, ctypes.addressof(needed))
    buffer = ctypes.create_string_buffer(needed.value)
    _check(function(*arguments, buffer, len(buffer), None))
    return buffer.value.decode()


def complaint(domain):
    """What is wrong with a domain text, with line and column; empty if nothing is."""
    buffer = ctypes.create_string_buffer(128)
    _library.critreg_check_domain(domain.encode(), buffer, len(buffer), None)
    return buffer.value.decode()


class Learner:
    """Learns about a domain text from training instances; `options` are fields of `Config`."""

    def __init__(self, domain, instances, **options):
        config = Config()
        _check(_library.critreg_config_init(ctypes.addressof(config), ctypes.sizeof(config)))
        for name, value in dict(options, instances=len(instances)).items():
            if not hasattr(config, name):
                raise TypeError(f"a configuration has no {name}")
            setattr(config, name, value)
        at = ctypes.addressof(config)
        size = _library.critreg_learner_size(at)
        self._memory = (ctypes.c_uint64 * (size // 8 + 1))()
        handle = ctypes.c_void_p()
        status = _library.critreg_learner_init(
            self._memory, size, domain.encode(), at, ctypes.addressof(handle)
        )
        _check(status, complaint(domain))
        self._handle = handle.value
        length = _out(ctypes.c_size_t, _library.critreg_learner_instance_len, self._handle)
        for instance in instances:
            if len(instance) != length:
                raise ValueError(f"an instance has {len(instance)} numbers, the text {length}")
        self._instances = numbers([number for instance in instances for number in instance])
        self._count = len(instances)
        self.parameters = _out(
            ctypes.c_size_t, _library.critreg_learner_parameter_count, self._handle
        )
        self._theta = numbers([0.0] * self.parameters)
        self._index = ctypes.c_size_t()

    def _check(self, status):
        if status != OK:
            _check(status, _text(_library.critreg_learner_message, self._handle))

    def is_finished(self):
        """Whether there is nothing more to ask."""
        return bool(_out(ctypes.c_int32, _library.critreg_is_finished, self._handle))

    def ask(self):
        """The sample to try next: the index of an instance, and parameters."""
        index = ctypes.addressof(self._index)
        status = _library.critreg_ask(
            self._handle, self._instances, self._count, index, self._theta
        )
        self._check(status)
        return self._index.value, list(self._theta)

    def tell(self, outcome):
        """What came of the sample that was asked for: FEASIBLE, INFEASIBLE, or -k if step k failed."""
        self._check(_library.critreg_tell(self._handle, self._instances, self._count, outcome))

    def observe(self, index, theta, outcome):
        """What came of a sample that was not asked for."""
        status = _library.critreg_observe(
            self._handle, self._instances, self._count, index, numbers(theta), outcome
        )
        self._check(status)

    def region(self):
        """What is learned so far, or None. It is valid until the next answer is told."""
        region = ctypes.c_void_p()
        status = _library.critreg_learner_region(self._handle, ctypes.addressof(region))
        if status == NO_REGION:
            return None
        self._check(status)
        return Region(region.value, self)


class Region:
    """A region that belongs to a learner."""

    def __init__(self, handle, learner):
        self._handle = handle
        self._learner = learner  # The handle lies in its memory.

    def text(self):
        """The constraints as text."""
        return _text(_library.critreg_region_format, self._handle)

    def contains(self, instance, thetas):
        """Whether each of many thetas, which stand one behind the other, is inside.

        `instance` and `thetas` are arrays of `numbers()`.
        """
        contains, handle = _library.critreg_region_contains, self._handle
        inside = ctypes.c_int32()
        written, place = ctypes.addressof(inside), ctypes.addressof(instance)
        first, step = ctypes.addressof(thetas), ctypes.sizeof(ctypes.c_double)
        answers = []
        for theta in range(first, first + ctypes.sizeof(thetas), step * self._learner.parameters):
            status = contains(handle, place, theta, written)
            if status != OK:
                _check(status)
            answers.append(inside.value == 1)
        return answers
