"""The structs, functions and codes that Python knows are those of critreg.h."""

import ctypes
import pathlib
import re
import unittest

from critreg import (
    Advice,
    Heuristic,
    Options,
    PlannerOptions,
    Quality,
    SkillsOptions,
    Status,
    Why,
    _library,
    _structs,
)

HEADER = pathlib.Path(__file__).resolve().parents[3] / "include" / "critreg.h"
# Of all comments, so that what is left is declarations.
CODE = re.sub(r"/\*.*?\*/|//[^\n]*", "", HEADER.read_text(), flags=re.DOTALL)

C_TYPES = {
    "uint32_t": ctypes.c_uint32,
    "int32_t": ctypes.c_int32,
    "uint64_t": ctypes.c_uint64,
    "size_t": ctypes.c_size_t,
    "double": ctypes.c_double,
    "struct critreg_ground": _structs.GroundStruct,
}
STRUCTS = {
    "config": _structs.Config,
    "report": _structs.Report,
    "constraint": _structs.ConstraintStruct,
    "proof": _structs.ProofStruct,
    "rng": _structs.RngStruct,
    "planner_config": _structs.PlannerConfig,
    "ground": _structs.GroundStruct,
    "draw": _structs.DrawStruct,
    "drawn": _structs.DrawnStruct,
    "callbacks": _structs.CallbacksStruct,
    "step": _structs.StepStruct,
    "metrics": _structs.Metrics,
    "training": _structs.Training,
    "skills_config": _structs.SkillsConfig,
    "skill_report": _structs.SkillReport,
}
# Answered by others, or for programs that lend memory; beside them the built-in environment.
NOT_WRAPPED = {
    "critreg_capabilities",
    "critreg_learner_align",
    "critreg_region_align",
    "critreg_planner_align",
    "critreg_learner_instance_len",
    "critreg_learner_parameter_count",
    "critreg_check_config",
    "critreg_sample_region_many",
    "critreg_skills_align",
}


def defined(name):
    """The value of a macro."""
    return int(re.search(rf"#define {name} (\d+)\b", CODE)[1])


def fields_of_header(name):
    """Name and type of each field of a struct."""
    body = re.search(rf"typedef struct critreg_{name} \{{(.*?)\}} critreg_{name};", CODE, re.DOTALL)
    for field in filter(None, map(str.strip, body[1].split(";"))):
        kind, stars, name, _, length = re.fullmatch(
            r"(.*?)(\*?)(\w+)(\[(\w+)\])?", field
        ).groups()
        kind = kind.strip()
        if stars and kind == "const char":
            declared = ctypes.c_char_p
        elif stars or kind not in C_TYPES:
            declared = ctypes.c_void_p  # Of callbacks, too.
        else:
            declared = C_TYPES[kind]
        if length:
            declared *= int(length) if length.isdigit() else defined(length)
        yield name, declared


class Interface(unittest.TestCase):
    def test_structs(self):
        for name, struct in STRUCTS.items():
            own = [(field, kind) for field, kind in struct._fields_]
            self.assertEqual(own, list(fields_of_header(name)), name)

    def test_functions(self):
        declared = {}
        for name, arguments in re.findall(r"\b(critreg_\w+)\(([^()]*)\);", CODE):
            count = 0 if arguments.strip() == "void" else arguments.count(",") + 1
            declared[name] = count
        for name, types in _library.ARGUMENTS.items():
            self.assertEqual(len(types), declared.get(name), name)
        left_out = set(declared) - set(_library.ARGUMENTS)
        others = "stick_button", "_recover"
        left_out = {name for name in left_out if not any(part in name for part in others)}
        self.assertEqual(left_out, NOT_WRAPPED)

    def test_codes(self):
        for prefix, codes in [
            ("", Status),
            ("", Quality),
            ("", Advice),
            ("", Heuristic),
            ("WHY_", Why),
        ]:
            for code in codes:
                self.assertEqual(defined(f"CRITREG_{prefix}{code.name}"), code, code.name)
        for name in ["MAX_PARAMETERS", "MAX_ARGUMENTS", "MAX_INTERVALS", "MAX_QUESTIONS"]:
            self.assertEqual(defined(f"CRITREG_{name}"), getattr(_structs, name))
        self.assertEqual(defined("CRITREG_NO_REASON"), _structs.NO_REASON)
        self.assertEqual(defined("CRITREG_DEFAULT_INSTANCES"), _structs.DEFAULT_INSTANCES)
        self.assertEqual(defined("CRITREG_ABI_VERSION"), _library.ABI_VERSION)

    def test_options_are_fields(self):
        config = {name for name, _ in _structs.Config._fields_}
        # Room for instances is an option of its own name; progress is told by learn().
        others = {"struct_size", "progress", "progress_data", "instances"}
        self.assertEqual(config - set(Options.__annotations__), others)
        self.assertEqual(set(Options.__annotations__) - config, {"room"})
        planner = {name for name, _ in _structs.PlannerConfig._fields_}
        self.assertLessEqual(set(PlannerOptions.__annotations__), planner)
        skills = {name for name, _ in _structs.SkillsConfig._fields_}
        # Room for training tasks is for those that are given.
        others = {"struct_size", "progress", "progress_data", "tasks"}
        self.assertEqual(skills - set(SkillsOptions.__annotations__), others)


if __name__ == "__main__":
    unittest.main()
