"""The Python module by pip: CMake builds what is compiled, setuptools packs it.

setuptools rather than meson-python, since the build is CMake's, and Debian has no scikit-build-core.
"""

import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    """Builds the target isoloop_python, and puts isoloop._core where setuptools wants it."""

    def build_extension(self, extension):
        build = pathlib.Path(os.environ.get("ISOLOOP_BUILD", self.build_temp)).absolute()
        if not (build / "CMakeCache.txt").exists():
            options = ["-DCMAKE_BUILD_TYPE=Release", "-DISOLOOP_PYTHON=ON", "-DISOLOOP_TESTS=OFF",
                       "-DISOLOOP_INSTALL=OFF", "-DCMAKE_UNITY_BUILD=ON",
                       f"-DPython_EXECUTABLE={sys.executable}"]
            generator = ["-G", "Ninja"] if self._has_ninja() else []
            subprocess.run(["cmake", *generator, "-S", ROOT, "-B", build, *options], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--build", build, "--target", "isoloop_python", "-j", jobs],
                       check=True)
        wanted = pathlib.Path(self.get_ext_fullpath(extension.name))
        wanted.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(next((build / "python" / "isoloop").glob("_core*.so"))), str(wanted))

    @staticmethod
    def _has_ninja():
        return any(os.access(pathlib.Path(folder) / "ninja", os.X_OK)
                   for folder in os.environ["PATH"].split(os.pathsep))


version = re.search(r"project\(isoloop VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
setup(
    version=version,
    ext_modules=[Extension("isoloop._core", [])],
    cmdclass={"build_ext": CMakeBuild},
)
