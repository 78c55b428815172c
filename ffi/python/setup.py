"""Builds the C library with the Makefile of the checkout and puts it inside the wheel."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]
LICENCES = ["LICENSE-MIT", "LICENSE-APACHE", "ffi/package/THIRD_PARTY"]


def version():
    """That of the workspace: there is one version for all parts."""
    manifest = CHECKOUT / "Cargo.toml"
    if not manifest.exists():
        sys.exit("critreg is built in a checkout of the project: pip install ./ffi/python")
    return re.search(r'^version = "(.*)"', manifest.read_text(), re.MULTILINE)[1]


def shared_library():
    """Builds it; where it lies, and its name in the package."""
    subprocess.run(["make", "--silent", "-C", CHECKOUT, "library"], check=True)
    target = CHECKOUT / os.environ.get("CARGO_TARGET_DIR", "target")
    target /= os.environ.get("CARGO_BUILD_TARGET", "")
    places = {
        "libcritreg.so": target / "c" / "libcritreg.so",
        "libcritreg.dylib": target / "release" / "libcritreg_ffi.dylib",
        "critreg.dll": target / "release" / "critreg_ffi.dll",
    }
    for name, place in places.items():
        if place.exists():
            return place, name
    sys.exit(f"the build left no shared library below {target}")


class BuildWithLibrary(build_py):
    """The Python files, the library and the licences of what is in it."""

    def run(self):
        super().run()
        place, name = shared_library()
        if self.editable_mode:
            return  # It is found where it was built.
        package = pathlib.Path(self.build_lib) / "critreg"
        shutil.copyfile(place, package / name)
        (package / "licences").mkdir(exist_ok=True)
        for licence in LICENCES:
            shutil.copy(CHECKOUT / licence, package / "licences")


class PlatformWheel(bdist_wheel):
    """Any Python 3, one platform: the library is loaded, not linked with Python."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


class WithLibrary(Distribution):
    """It is not the same on every platform, though nothing is compiled against Python."""

    def has_ext_modules(self):
        return True


setup(
    version=version(),
    distclass=WithLibrary,
    cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel},
)
