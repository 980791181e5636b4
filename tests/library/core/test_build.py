"""The core is compiled with the answers of the plain source, and is not used when it is out of date."""

import array
import contextlib
import errno
import itertools
import os
import platform
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest
from core.building import CORE, PROJECT, compiled, hook, plain, write
from core.made_up import MODULES

from planar_pushing.core import INPUTS, RESULTS, keeps_bits

WIDTH = 28
#: Degenerate numbers first, then ordinary ones.
NUMBERS = (0.0, -0.0, 1.0, -1.0, 1e-300, 1e150, 0.1, 2.0 / 3.0, -7.25, 3.5)
PLAIN = "the core runs as plain Python, about 100 times slower"


@pytest.fixture(scope="module")
def made_up(tmp_path_factory):
    """A folder with the made-up core, and its compiled module."""
    if not shutil.which("cc"):
        pytest.skip("no C compiler")
    folder = write(tmp_path_factory.mktemp("made_up") / "core")
    return folder, compiled(folder)


#: A core that takes little time to compile.
CONSTANT = {"one": "NUMBER = 1.0\n"}


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    """The compiled library of a core of one number."""
    if not shutil.which("cc"):
        pytest.skip("no C compiler")
    return hook.build(write(tmp_path_factory.mktemp("constant") / "core", CONSTANT))


@pytest.fixture
def compiled_before(library, monkeypatch):
    """Let a build take that library, and not compile it once more."""
    monkeypatch.setattr(hook.compiler, "compile_library", lambda *_: library)


def rows():
    degenerate = [(x, y, k) for x, y in itertools.product(NUMBERS, NUMBERS) for k in (0, 1, 2)]
    random = np.random.default_rng(1).normal(size=(500, 3)) * [1.0, 3.0, 0.0] + [0.0, 0.0, 1.0]
    return np.concatenate([degenerate, random])


def answers(kernel, data, rows):
    results = np.full((len(rows), WIDTH), 5.0)
    kernel(data, rows.reshape(-1), *rows.shape, results.reshape(-1), WIDTH)
    return results


def test_compiled_answers_are_those_of_the_plain_source_to_the_last_bit(made_up, monkeypatch):
    folder, module = made_up
    data = np.arange(6.0)
    inputs = rows()
    inputs = inputs[np.abs(inputs[:, :2]).max(axis=1) < 100.0]
    native = answers(module.KERNELS["answer"], data, inputs)
    kernel = plain(folder, monkeypatch)["apex"].answer
    interpreted = np.full(native.size, 5.0)
    flat = memoryview(inputs.reshape(-1))
    kernel(memoryview(data), flat, *inputs.shape, memoryview(interpreted), WIDTH)
    interpreted = interpreted.reshape(native.shape)
    same = interpreted.view(np.int64) == native.view(np.int64)
    same |= np.isnan(interpreted) & np.isnan(native)
    assert same.all(), np.argwhere(~same)[:5]
    # Each construct is reached with more than one answer; infinities, NaN and signs of zeros occur.
    constant = [column for column in range(WIDTH) if len({*map(repr, interpreted[:, column])}) == 1]
    assert constant == [14]
    assert np.isneginf(interpreted).any()
    assert np.isnan(interpreted).any()
    assert (np.signbit(interpreted) & (interpreted == 0.0)).any()


def test_functions_may_be_in_any_module(tmp_path, made_up):
    _, module = made_up
    names = dict(zip(MODULES, reversed(MODULES), strict=True))
    renamed = {
        names[name]: re.sub(
            r"(?<=core\.)(apex|middle|floor\.zenith)",
            lambda match: names[match[0].replace(".", "/")].replace("/", "."),
            text,
        )
        for name, text in MODULES.items()
    }
    other = compiled(write(tmp_path / "core", renamed))
    inputs = rows()
    one, two = (answers(core.KERNELS["answer"], np.arange(6.0), inputs) for core in (module, other))
    assert one.tobytes() == two.tobytes()


GOOD = np.arange(6.0)


@pytest.mark.parametrize("arrays", [
    {"data": np.arange(6)}, {"data": np.arange(6.0, dtype=np.float32)}, {"data": GOOD.astype(">f8")},
    {"data": np.zeros(6, complex)}, {"data": GOOD[::2]}, {"data": bytes(48)},
    {"rows": np.arange(6)}, {"rows": np.zeros((3, 4))[:, :3]}, {"rows": np.zeros((3, 2), order="F")},
    {"rows": np.zeros(5)}, {"rows": np.zeros(0)}, {"results": np.zeros(2 * WIDTH - 1)},
    {"results": np.zeros(4 * WIDTH)[::2]}, {"results": np.zeros((2, WIDTH), np.float32)},
    {"count": 3}, {"columns": 4}, {"width": WIDTH + 1}, {"count": -1}, {"columns": -1}, {"width": -1},
    {"count": 2**62, "columns": 2**62},
    {"results": np.broadcast_to(0.0, (2, WIDTH))},
], ids=str)  # fmt: skip
def test_arrays_of_another_type_layout_or_size_are_refused(made_up, arrays):
    inputs = {
        "data": GOOD, "rows": np.ones((2, 3)), "count": 2, "columns": 3,
        "results": np.zeros((2, WIDTH)), "width": WIDTH,
    }  # fmt: skip
    kernel = made_up[1].KERNELS["answer"]
    kernel(*inputs.values())
    assert inputs["results"].any()
    inputs["results"][:] = 0.0
    inputs |= arrays
    with pytest.raises(ValueError, match="contiguous numbers of type float64 expected"):
        kernel(*inputs.values())
    assert not inputs["results"].any()


@pytest.mark.parametrize("sizes", [(6, 6, 2 * WIDTH), (6, 5, 2 * WIDTH), (6, 6, WIDTH)], ids=str)
def test_nothing_holds_the_arrays_afterwards(made_up, sizes):
    data, rows, results = (array.array("d", bytes(8 * size)) for size in sizes)
    # The kernel divides by no zero, and reads no more than six numbers of the data.
    with contextlib.suppress(ValueError):
        made_up[1].KERNELS["answer"](data, rows, 2, 3, results, WIDTH)
    for numbers in (data, rows, results):
        numbers.append(1.0)  # refused with a BufferError as long as somebody holds the array


def test_an_array_that_cannot_be_written_and_what_is_no_array_are_refused(made_up):
    kernel = made_up[1].KERNELS["answer"]
    results = np.zeros((2, WIDTH))
    results.flags.writeable = False
    with pytest.raises(ValueError, match="results: "):
        kernel(GOOD, np.ones((2, 3)), 2, 3, results, WIDTH)
    with pytest.raises(TypeError):
        kernel(None, np.ones((2, 3)), 2, 3, np.zeros((2, WIDTH)), WIDTH)


def test_the_compiled_file_has_no_fused_multiplication_and_addition(made_up):
    if not shutil.which("objdump"):
        pytest.skip("no objdump")
    for path in filter(Path.exists, (folder / hook.TARGET for folder in (made_up[0], CORE))):
        listing = subprocess.run(
            ["objdump", "-d", path], capture_output=True, text=True, check=True
        )
        assert "mul" in listing.stdout or path.parent == CORE
        assert re.findall(r"\bv?fn?m(?:add|sub|la|ls)\w*", listing.stdout) == []


#: Options that change results, and whether those of the build undo them or are refused with a line.
OPTIONS = {
    "-ffast-math": True, "-Ofast": True, "-funsafe-math-optimizations": True,
    "-ffinite-math-only": True, "-freciprocal-math": True, "-fno-signed-zeros": True,
    "-fassociative-math -fno-signed-zeros -fno-trapping-math": True,
}  # fmt: skip
if platform.machine() == "x86_64" and sys.platform == "linux":
    OPTIONS |= {"-Ofast -mfma -ffp-contract=fast": True, "-mfpmath=387": False}
#: The first option in every run of the tests, the others in the slow ones.
OPTION_CASES = [
    pytest.param(option, marks=pytest.mark.slow if i else ()) for i, option in enumerate(OPTIONS)
]
#: Whether numbers below the smallest normal one survive beside a library, and what it says of its bits.
SUBNORMAL = """
import importlib.util, sys
spec = importlib.util.spec_from_file_location("_compiled", sys.argv[1])
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
print(float("5e-324") * 2.0, module.probe(*eval(sys.argv[2], {"nan": float("nan")})))
"""


@pytest.mark.parametrize("option", OPTION_CASES)
def test_options_of_the_compiler_change_no_results(made_up, tmp_path, monkeypatch, capsys, option):
    """Those of CC are undone or refused; CFLAGS and LDFLAGS are not read."""
    monkeypatch.setenv("CC", f"cc {option}")
    for name in ("CFLAGS", "LDFLAGS"):
        monkeypatch.setenv(name, "-ffast-math")
    folder = write(tmp_path / "core", CONSTANT)
    target = hook.build(folder)
    if not OPTIONS[option]:
        assert target is None
        assert (
            f"the C compiler (cc {option}) needs other options; {PLAIN}" in capsys.readouterr().err
        )
        return
    ran = subprocess.run(
        [sys.executable, "-c", SUBNORMAL, target, repr(INPUTS)],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert ran.stdout == f"1e-323 {RESULTS}\n"


@pytest.mark.parametrize("option", OPTION_CASES)
def test_a_library_with_other_results_is_refused(made_up, tmp_path, monkeypatch, capsys, option):
    """As if the options of the build undid nothing, and did not set a level of optimization either."""
    monkeypatch.setattr(hook.compiler, "FLAGS", "-fPIC -w -O2 " + option)
    assert hook.build(write(tmp_path / "core", CONSTANT)) is None
    output = capsys.readouterr().err
    assert re.fullmatch(
        r"planar-pushing: compiled, the core does not have the results of its source; "
        rf"the C compiler \(.+\) needs other options; {PLAIN}\n", output,
    )  # fmt: skip


def test_the_known_results_are_those_of_python(made_up):
    one, small, near, square, seven, least, low, high, zero, unknown = INPUTS
    plain = (
        one + small - one, near * near - square, seven / 3.0, one * 0.1, least * 2.0, low * 0.5,
        high * high / high, zero + 0.0, float(unknown != unknown),
    )  # fmt: skip
    assert repr(plain) == repr(RESULTS)
    assert keeps_bits(made_up[1].probe)
    # Each result counts.
    for place in range(len(RESULTS)):
        changed = [*RESULTS]
        changed[place] = -changed[place]
        assert keeps_bits(lambda *_, changed=changed: changed) is False, place


def test_what_is_compiled_is_not_compiled_again_but_after_a_change(library, tmp_path, monkeypatch):
    folder = write(tmp_path / "core", CONSTANT)
    target = Path(shutil.copy(library, folder))
    before = target.stat()
    monkeypatch.setattr(hook.compiler, "run", None)
    assert hook.build(folder) == target
    assert target.stat().st_ino == before.st_ino
    for change in [
        lambda _: (folder / "one.py").write_text("NUMBER = 2.0\n", encoding="utf-8"),
        lambda patch: patch.setattr(hook.compiler, "FLAGS", "-O1"),
        lambda patch: patch.setattr(hook.module, "TAIL", hook.module.TAIL + "\n"),
        lambda patch: patch.setattr(hook.compiler, "cython_version", lambda: "0"),
        lambda patch: patch.setattr(hook.compiler, "compiler_version", lambda *_: "0"),
        lambda patch: patch.setenv("CC", "cc -pipe"),
    ]:
        with monkeypatch.context() as patch:
            change(patch)
            with pytest.raises(TypeError, match="not callable"):
                hook.build(folder)
        write(folder, CONSTANT)
    assert [path.name for path in folder.iterdir() if path.suffix != ".py"] == [target.name]


@pytest.mark.parametrize(("lacking", "reason"), [
    ("compiler", r"no C compiler \(/nonexistent not found\)"),
    ("working", r"the C compiler failed \(false .*\)"),
    ("command", r"the C compiler failed \(.*/compiler .*: Exec format error\)"),
    ("quotation", r"no C compiler \(cc ' not found\)"),
    ("headers", r"no headers of Python \(.*/none/Python.h not found\)"),
    ("cython", "no Cython"),
])  # fmt: skip
def test_without_a_tool_the_old_file_goes_and_one_line_says_so(
    tmp_path, monkeypatch, capsys, lacking, reason
):
    folder = write(tmp_path / "core", CONSTANT)
    old = folder / hook.TARGET
    old.write_bytes(b"old")
    run = hook.compiler.run
    monkeypatch.setattr(  # no compiler works, and none needs what Cython writes
        hook.compiler, "run", lambda tool, *given: None if tool == "Cython" else run(tool, *given)
    )
    match lacking:
        case "compiler":
            monkeypatch.setenv("CC", "/nonexistent")
        case "working":
            monkeypatch.setenv("CC", "false")
        case "command":
            (tmp_path / "compiler").write_text("neither a program nor a script", encoding="utf-8")
            (tmp_path / "compiler").chmod(0o755)
            monkeypatch.setenv("CC", str(tmp_path / "compiler"))
        case "quotation":
            monkeypatch.setenv("CC", "cc '")
        case "headers":
            monkeypatch.setattr(
                hook.compiler.sysconfig, "get_path", lambda _: str(tmp_path / "none")
            )
        case "cython":
            monkeypatch.setattr(hook.compiler.importlib.util, "find_spec", lambda _: None)
    assert hook.build(folder) is None
    assert not old.exists()
    output = capsys.readouterr()
    assert output.out == ""
    assert re.fullmatch(rf"planar-pushing: {reason}; {PLAIN}\n", output.err)


def test_a_missing_compiler_is_an_error_if_the_environment_says_so(tmp_path, monkeypatch, capsys):
    folder = write(tmp_path / "core", CONSTANT)
    monkeypatch.setenv("CC", "/nonexistent")
    monkeypatch.setenv("PLANAR_PUSHING_COMPILED", "0")
    assert hook.build(folder) is None
    monkeypatch.setenv("PLANAR_PUSHING_COMPILED", "1")
    reason = "no C compiler (/nonexistent not found); PLANAR_PUSHING_COMPILED=1 requires the compiled core"
    with pytest.raises(hook.compiler.CompileFailure) as failure:
        hook.build(folder)
    assert str(failure.value) == reason
    monkeypatch.setattr(hook, "CORE", folder)
    with pytest.raises(SystemExit, match=re.escape(f"planar-pushing: {reason}")):
        hook.build_or_exit()


@pytest.mark.usefixtures("compiled_before")
def test_a_folder_that_cannot_be_written_is_said_in_one_line(tmp_path, monkeypatch, capsys):
    folder = write(tmp_path / "core", CONSTANT)

    def refused(source, copy):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(copy))

    monkeypatch.setattr(hook.shutil, "copy", refused)
    assert hook.build(folder) is None
    expected = f"planar-pushing: {folder} cannot be written: Permission denied; {PLAIN}\n"
    assert capsys.readouterr().err == expected


@pytest.mark.usefixtures("compiled_before")
def test_another_folder_takes_the_new_library_and_the_sources_keep_theirs(tmp_path, monkeypatch):
    folder = write(tmp_path / "a core", CONSTANT)
    (folder / hook.TARGET).write_bytes(b"old")
    (tmp_path / "new").mkdir()
    target = hook.build(folder, tmp_path / "new")
    assert target == tmp_path / "new" / hook.TARGET
    assert (folder / hook.TARGET).read_bytes() == b"old"
    with monkeypatch.context() as changed:
        changed.setenv("CC", "/nonexistent")
        assert hook.build(folder, tmp_path / "new") is None
    assert (folder / hook.TARGET).read_bytes() == b"old"
    shutil.copy(target, folder)
    assert hook.build(folder, tmp_path / "new") == folder / hook.TARGET


@pytest.mark.usefixtures("compiled_before")
def test_a_build_that_fails_leaves_nothing_half_written(tmp_path, monkeypatch):
    folder = write(tmp_path / "core", CONSTANT)
    target = hook.build(folder)
    before = target.read_bytes()
    (folder / "one.py").write_text("NUMBER = 2.0\n", encoding="utf-8")

    def killed(source, copy):
        copy.write_bytes(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(hook.shutil, "copy", killed)
    with pytest.raises(KeyboardInterrupt):
        hook.build(folder)
    assert target.read_bytes() == before
    assert {path.suffix for path in folder.iterdir()} == {".py", ".so"}


@pytest.mark.usefixtures("compiled_before")
def test_what_killed_builds_have_left_is_removed_and_that_of_a_running_one_stays(tmp_path):
    folder = write(tmp_path / "core", CONSTANT)
    ended = subprocess.Popen([sys.executable, "-c", ""])
    ended.wait()
    running = folder / f".{hook.TARGET}.{os.getppid()}"
    running.write_bytes(b"half")
    (folder / f".{hook.TARGET}.{ended.pid}").write_bytes(b"half")
    (folder / f".{hook.TARGET}.notes").write_bytes(b"the user's own")
    hook.build(folder)
    names = {path.name for path in folder.iterdir()}
    left = {running.name, f".{hook.TARGET}.notes"}
    assert {name for name in names if name.startswith(".")} == left


ASK = """
import sys, warnings
import numpy as np
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    import planar_pushing.mechanics.kernels.calls as kernels
    import planar_pushing.mechanics.kernels.calls
print([f"{one.category.__name__}: {one.message}" for one in caught])
print("planar_pushing.core.apex" in sys.modules, kernels.COMPILED is not None)
print(kernels.run("answer", np.arange(6), [[0.5, 2, 1], [1, 1, 2]], 29).tobytes().hex())
"""


@pytest.fixture(scope="module")
def package(made_up, tmp_path_factory):
    """A copy of the package with the made-up core and its library, which has the same sources."""
    source = tmp_path_factory.mktemp("package") / "planar_pushing"
    skip = shutil.ignore_patterns("__pycache__", "_compiled.*", "apex.py", "middle.py", "zenith.py")
    shutil.copytree(PROJECT / "src/planar_pushing", source, ignore=skip)
    for path in source.glob("core/[!_]*"):
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    shutil.copy(made_up[0] / hook.TARGET, write(source / "core"))
    return source


@pytest.fixture(scope="module")
def native(package):
    """What the package says with the compiled core."""
    return ask(package)


def ask(package, **variables):
    ran = subprocess.run(
        [sys.executable, "-W", "error", "-c", ASK], capture_output=True, text=True, check=False,
        env=os.environ | {"PYTHONPATH": str(package.parent)} | variables,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    warned, plain, results = ran.stdout.splitlines()
    return warned, plain, results


def test_the_package_runs_the_compiled_core_without_loading_its_source(native):
    warned, loaded, results = native
    assert (warned, loaded) == ("[]", "False True")
    last = np.frombuffer(bytes.fromhex(results)).reshape(2, 29)[:, 28]
    assert np.isnan(last).all()  # the kernel writes 28 numbers


def test_the_variable_for_the_plain_source_gives_no_warning_and_the_same_answers(package, native):
    warned, loaded, results = ask(package, PLANAR_PUSHING_PLAIN="1")
    assert (warned, loaded) == ("[]", "False False")
    assert results == native[2] == ask(package, PLANAR_PUSHING_PLAIN="0")[2]


@pytest.mark.parametrize(("damage", "reason"), [
    ("edit", "it has changed since it was compiled; compile it"),
    ("add", "it has changed since it was compiled; compile it"),
    ("remove", "it is not compiled; install a C compiler and Python's headers, .* the package again"),
    ("spoil", r"it cannot be loaded \(.*\); install the package again"),
    ("round", "compiled, it rounds in another way, or drops subnormal numbers; compile it without .*"),
])  # fmt: skip
def test_what_is_out_of_date_or_missing_is_not_used_and_one_warning_says_so(
    package, native, tmp_path, damage, reason
):
    copy = tmp_path / "planar_pushing"
    # Bytecode would pass for that of a file of the same size that is edited within the second.
    shutil.copytree(package, copy, ignore=shutil.ignore_patterns("__pycache__"))
    folder = copy / "core"
    match damage:
        case "edit":
            text = (folder / "apex.py").read_text(encoding="utf-8")
            edited = text.replace("result[3] = min(x, y)", "result[3] = max(x, y)")
            (folder / "apex.py").write_text(edited, encoding="utf-8")
        case "add":
            (folder / "another.py").write_text("FOUR = 4\n", encoding="utf-8")
        case "remove":
            (folder / hook.TARGET).unlink()
        case "spoil":
            (folder / hook.TARGET).write_bytes(b"half")
        case "round":
            text = (folder / "__init__.py").read_text(encoding="utf-8")
            other = text.replace("RESULTS = (0.0, ", "RESULTS = (1e-17, ")
            (folder / "__init__.py").write_text(other, encoding="utf-8")
    warned, _, results = ask(copy)
    expected = rf"""\[["']PlainCoreWarning: {PLAIN}, as {reason} \(in a clone: make\)["']\]"""
    assert re.fullmatch(expected, warned)
    assert (results == native[2]) is (damage != "edit")
    assert ask(copy, PLANAR_PUSHING_PLAIN="1")[0] == "[]"


def test_the_real_core_is_in_its_language():
    hook.join(CORE)


def wheel(tmp_path, **variables):
    """The wheel of the project as pip makes it, but for the isolation."""
    folder = tmp_path / "a project"
    if not folder.exists():
        for name in ("src", "workflow", "joiner"):
            skip = shutil.ignore_patterns("__pycache__", "_compiled.*")
            shutil.copytree(PROJECT / name, folder / name, ignore=skip)
        for name in (
            "pyproject.toml",
            "README.md",
            "LICENSE",
            "Snakefile",
            ".gitignore",
        ):
            shutil.copy(PROJECT / name, folder)
    shutil.rmtree(tmp_path / "dist", ignore_errors=True)
    command = [sys.executable, "-m", "hatchling", "build", "--directory", str(tmp_path / "dist")]
    ran = subprocess.run(
        command, cwd=folder, env=os.environ | variables, capture_output=True, text=True, check=True
    )
    (wheel,) = (tmp_path / "dist").glob("*.whl")
    return wheel, ran.stderr


@pytest.mark.slow
def test_the_wheel_is_for_one_platform_and_every_python_and_without_a_compiler_for_all(tmp_path):
    path, _ = wheel(tmp_path)
    assert re.fullmatch(r"planar_pushing-[\d.]+-cp311-abi3-\w+\.whl", path.name)
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
        archive.extractall(tmp_path / "site")
    assert f"planar_pushing/core/{hook.TARGET}" in names
    assert not any("joiner" in name or name.endswith((".pyx", ".c")) for name in names)
    # The sources may be in a folder that cannot be written.
    assert not [*(tmp_path / "a project").rglob("*_compiled.*")]
    load = "import planar_pushing.mechanics.kernels.calls as kernels; print(kernels.COMPILED is not None)"
    ran = subprocess.run(
        [sys.executable, "-W", "error", "-c", load], capture_output=True, text=True, check=True,
        env=os.environ | {"PYTHONPATH": str(tmp_path / "site")},
    )  # fmt: skip
    assert ran.stdout == "True\n"
    path, output = wheel(tmp_path, CC="/nonexistent")
    assert re.fullmatch(r"planar_pushing-[\d.]+-py3-none-any\.whl", path.name)
    assert f"planar-pushing: no C compiler (/nonexistent not found); {PLAIN}" in output
    with zipfile.ZipFile(path) as archive:
        assert not any("_compiled" in name for name in archive.namelist())


@pytest.mark.slow
def test_the_source_distribution_has_what_compiles_it(tmp_path):
    wheel(tmp_path, CC="/nonexistent")
    (archive,) = (tmp_path / "dist").glob("*.tar.gz")
    shutil.unpack_archive(archive, tmp_path / "unpacked")
    (source,) = (tmp_path / "unpacked").iterdir()
    assert (source / "joiner/bodies.py").exists()
    assert not [*source.rglob("_compiled.*")]
    shutil.rmtree(tmp_path / "a project")
    source.rename(tmp_path / "a project")
    assert "abi3" in wheel(tmp_path)[0].name
