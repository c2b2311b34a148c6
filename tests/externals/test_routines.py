"""Strings, random numbers, files and LAPACK routines by their names."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from acausal.externals.arguments import Argument, RoutineFailed, Tensor, matrix, tensor
from acausal.externals.files import Files, file_routines, read_table
from acausal.externals.random_numbers import GLOBAL_SEED
from acausal.externals.routines import IMPURE_RANDOM, find_routine, routine_call
from acausal.symbolic.expressions.kernel import Part


def run(name: str, *args: Argument) -> dict[int, Argument]:
    routine = find_routine(name)
    assert routine is not None
    return routine(args)


def strings(name: str, *args: Argument) -> tuple[Argument, ...]:
    return tuple(run(f"ModelicaStrings_{name}", *args).values())


# ------------------------------------------------------------------------------ strings


@pytest.mark.parametrize(
    ("name", "args", "expected"),
    [
        ("length", ("abc",), (3,)),
        ("length", ("",), (0,)),
        ("substring", ("abcdef", 2, 4), ("bcd",)),
        ("substring", ("abcdef", 3, 99), ("cdef",)),
        ("substring", ("abcdef", 4, 2), ("",)),
        ("substring", ("abcdef", 3, -1), ("c",)),
        ("compare", ("abc", "abd", True), (1,)),
        ("compare", ("B", "a", True), (1,)),
        ("compare", ("B", "a", False), (3,)),
        ("compare", ("Abc", "aBC", False), (2,)),
        ("skipWhiteSpace", (" \t x", 1), (4,)),
        ("skipWhiteSpace", ("   ", 1), (4,)),
        ("scanIdentifier", ("  ab_1+", 1), (7, "ab_1")),
        ("scanIdentifier", ("  1ab", 1), (1, "")),
        ("scanInteger", (" -12,", 1, False), (5, -12)),
        ("scanInteger", (" -12,", 1, True), (1, 0)),
        ("scanInteger", ("12.5", 1, False), (1, 0)),
        ("scanReal", ("x = -1.5e3;", 5, False), (11, -1500.0)),
        ("scanReal", ("12", 1, True), (3, 12.0)),
        ("scanReal", ("1e+", 1, False), (1, 0.0)),
        ("scanReal", ("abc", 1, False), (1, 0.0)),
        ("scanReal", (".", 1, False), (1, 0.0)),
        ("scanString", ('a "b c" d', 2), (8, "b c")),
        ("scanString", ("abc", 1), (1, "")),
        ("scanString", (chr(34) * 2, 1), (1, "")),
        ("hashString", ("",), (0xAAAAAAAA - 2**32,)),
    ],
)
def test_strings(name: str, args: tuple[Argument, ...], expected: tuple[Argument, ...]) -> None:
    assert strings(name, *args) == expected


def test_hashes_differ_and_fit_32_bits() -> None:
    hashes = [strings("hashString", f"model.component[{i}]")[0] for i in range(1000)]
    assert len(set(hashes)) == 1000
    assert all(isinstance(h, int) and -(2**31) <= h < 2**31 for h in hashes)


def test_arguments_are_checked() -> None:
    with pytest.raises(RoutineFailed, match="String"):
        strings("length", 1.0)


# ------------------------------------------------------------------------------ random numbers


def test_xorshift64star_by_hand() -> None:
    """From the state 1 the shifts give 2^25 + 1, which is multiplied modulo 2^64."""
    word = (2**25 + 1) * 2685821657736338717 % 2**64
    result = run("ModelicaRandom_xorshift64star", Tensor((2,), (1, 0)))
    low, high = word % 2**32, word // 2**32
    assert result[1] == Tensor((2,), tuple(h - 2**32 if h >= 2**31 else h for h in (low, high)))
    assert result[2] == ((word - 2**64 if word >= 2**63 else word) * 2.0**-64 + 0.5)


def test_xorshift128plus_by_hand() -> None:
    """(1, 2): 1 ^ 1 << 23 = 8388609; (8388609 ^ 2 ^ 64) + 2 = 8388677."""
    result = run("ModelicaRandom_xorshift128plus", Tensor((4,), (1, 0, 2, 0)))
    assert result == {1: Tensor((4,), (2, 0, 8388677, 0)), 2: 8388677 * 2.0**-64 + 0.5}


@pytest.mark.parametrize(("name", "size"), [("64star", 2), ("128plus", 4), ("1024star", 33)])
def test_generators_are_uniform(name: str, size: int) -> None:
    rng = np.random.default_rng(1)
    state: Argument = Tensor(
        (size,), (*rng.integers(-(2**31), 2**31, size - size % 2).tolist(), *[0] * (size % 2))
    )
    numbers: list[float] = []
    for _ in range(4000):
        result = run(f"ModelicaRandom_xorshift{name}", state)
        state = result[1]
        number = result[2]
        assert isinstance(number, float)
        numbers.append(number)
    assert 0 < min(numbers) < 0.01
    assert 0.99 < max(numbers) <= 1
    assert np.mean(numbers) == pytest.approx(0.5, abs=0.02)
    assert np.corrcoef(numbers[:-1], numbers[1:])[0, 1] == pytest.approx(0, abs=0.05)


def test_impure_numbers_depend_on_place_and_time_and_repeat() -> None:
    def draw(site: int, time: float) -> Argument:
        return run(IMPURE_RANDOM, 715827883, site, time)[-1]

    drawn = [draw(site, time / 10) for site in range(20) for time in range(50)]
    assert len({str(d) for d in drawn}) == 1000
    assert all(isinstance(d, float) and 0 <= d <= 1 for d in drawn)
    assert draw(3, 0.1) == draw(3, 0.1)


def test_the_global_seed_is_fixed() -> None:
    assert run("ModelicaRandom_automaticGlobalSeed", 0.0) == {-1: GLOBAL_SEED}


def test_kernel_of_a_routine_gives_elements() -> None:
    template = (None, 0, None, 0)
    name = "ModelicaRandom_xorshift128plus"
    whole = routine_call(name, [(4,)], template, [(1, 4)])
    kernels = [Part(whole, k, "state", "Integer") for k in range(4)]
    assert [k.evaluate(1, 2) for k in kernels] == [2, 0, 8388677, 0]
    assert kernels[0].arity == 2
    assert kernels[0].is_discrete
    assert kernels[0].partial(0) is None


# ------------------------------------------------------------------------------ matrices


def test_solve_and_invert() -> None:
    a = np.array([[4.0, 1.0], [2.0, 3.0]])
    b = np.array([1.0, 2.0])
    solved = run("dgesv", 2, 1, tensor(a), 2, Tensor((2,), (0, 0)), tensor(b), 2, 0)
    assert matrix(solved[5]).tolist() == pytest.approx(np.linalg.solve(a, b).tolist())
    assert solved[7] == 0
    factors = run("dgetrf", 2, 2, tensor(a), 2, Tensor((2,), (0, 0)), 0)
    inverse = run("dgetri", 2, factors[2], 2, factors[4], Tensor((2,), (0.0, 0.0)), 2, 0)
    assert matrix(inverse[1]) == pytest.approx(np.linalg.inv(a))
    again = run("dgetrs", "N", 2, 1, factors[2], 2, factors[4], tensor(b), 2, 0)
    assert matrix(again[6]).tolist() == pytest.approx(np.linalg.solve(a, b).tolist())


def test_a_singular_matrix_says_so() -> None:
    solved = run("dgesv", 2, 1, tensor(np.ones((2, 2))), 2, Tensor((2,), (0, 0)), tensor(np.ones(2)), 2, 0)
    assert solved[7] == 2


def test_eigenvalues_singular_values_and_norms() -> None:
    a = np.array([[0.0, 1.0], [-2.0, -3.0]])
    work = tensor(np.zeros(20))
    zero = tensor(np.zeros((2, 2)))
    eigen = run("dgeev", "N", "V", 2, tensor(a), 2, *[tensor(np.zeros(2))] * 2, zero, 2, zero, 2, work, 20, 0)
    assert sorted(matrix(eigen[5]).tolist()) == pytest.approx([-2.0, -1.0])
    vectors = matrix(eigen[9])
    assert a @ vectors == pytest.approx(vectors * matrix(eigen[5]))
    svd = run("dgesdd", "A", 2, 2, tensor(a), 2, work, zero, 2, zero, 2, work, 20, work, 0)
    assert matrix(svd[5]).tolist() == pytest.approx(np.linalg.svd(a)[1].tolist())
    norms = [run("dlange", kind, 2, 2, tensor(a), 2, work)[-1] for kind in "M1IF"]
    assert norms == pytest.approx([3.0, 4.0, 5.0, 14.0**0.5])


def test_least_squares_with_and_without_full_rank() -> None:
    a, b = np.array([[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]]), np.array([1.0, 2.0, 4.0])
    work = tensor(np.zeros(20))
    full = run("dgels", "N", 3, 2, 1, tensor(a), 3, tensor(b), 3, work, 20, 0)
    assert matrix(full[6])[:2].tolist() == pytest.approx(np.linalg.lstsq(a, b)[0].tolist())
    flat = np.ones((3, 2))
    args = (3, 2, 1, tensor(flat), 3, tensor(b), 3, Tensor((2,), (0, 0)), 1e-10, 0, work, 20, 0)
    least = run("dgelsy", *args)
    assert least[9] == 1
    assert matrix(least[5])[:2].tolist() == pytest.approx(np.linalg.lstsq(flat, b)[0].tolist())


def test_factorizations() -> None:
    a = np.array([[2.0, 1.0], [1.0, 3.0], [0.0, 1.0]])
    work = tensor(np.zeros(8))
    qr = run("dgeqrf", 3, 2, tensor(a), 3, work, work, 8, 0)
    q = matrix(run("dorgqr", 3, 2, 2, qr[2], 3, qr[4], work, 8, 0)[3])
    assert q @ np.triu(matrix(qr[2])[:2]) == pytest.approx(a)
    spd = a.T @ a
    lower = np.tril(matrix(run("dpotrf", "L", 2, tensor(spd), 2, 0)[2]))
    assert lower @ lower.T == pytest.approx(spd)


def test_unknown_names_are_not_found() -> None:
    assert find_routine("dlaunch") is None
    assert find_routine("system") is None


# ------------------------------------------------------------------------------ files

TEXT = """#1
# a comment
double tab1(2,3)  # another
  0 1, 2
  3;4 5e0
float other(1, 2)
7\t8
"""


@pytest.fixture
def files(tmp_path: Path) -> Files:
    inside = tmp_path / "Package"
    inside.mkdir()
    (inside / "table.txt").write_text(TEXT)
    (inside / "data.csv").write_text("t;y\n0;1\n1;2.5\n\n")
    savemat(inside / "data.mat", {"m": np.array([[1.0, 2.0], [3.0, 4.0]])}, format="4")
    savemat(
        inside / "data7.mat",
        {"m": np.array([[1.0, 2.0]]), "s": {"t": np.eye(2), "u": {"v": np.ones((1, 2))}}},
        format="5",
    )
    (tmp_path / "secret.txt").write_text("secret")
    (inside / "link.txt").symlink_to(tmp_path / "secret.txt")
    return Files((inside,), inside, lambda name: inside if name == "Package" else None)


def test_text_tables(files: Files) -> None:
    assert read_table(files, "table.txt", "tab1") == [[0, 1, 2], [3, 4, 5]]
    assert read_table(files, "modelica://Package/table.txt", "other") == [[7, 8]]


def test_csv_and_matlab_tables(files: Files) -> None:
    assert read_table(files, "data.csv", "", ";", 1) == [[0, 1], [1, 2.5]]
    assert read_table(files, "data.mat", "m") == [[1, 2], [3, 4]]
    assert read_table(files, "data7.mat", "m") == [[1, 2]]
    assert read_table(files, "data7.mat", "s.t") == [[1, 0], [0, 1]]
    assert read_table(files, "data7.mat", "s.u.v") == [[1, 1]]


@pytest.mark.parametrize(
    ("name", "table", "word"),
    [
        ("table.txt", "tab9", "tab1, other"),
        ("nowhere.txt", "tab1", "no file"),
        ("../secret.txt", "tab1", "neither below"),
        ("link.txt", "tab1", "neither below"),
        ("/etc/passwd", "tab1", "neither below"),
        ("modelica://Other/table.txt", "tab1", "not found"),
        ("http://host/table.txt", "tab1", "not the name"),
        ("data.csv", "", "not a number"),
        ("data.mat", "x", "no matrix"),
    ],
)
def test_files_that_cannot_be_read(files: Files, name: str, table: str, word: str) -> None:
    with pytest.raises(RoutineFailed, match=word):
        read_table(files, name, table)


@pytest.mark.parametrize(
    ("content", "word"),
    [
        ("double a(1,1)\n1", "#1"),
        ("#1\ndouble a(2,2)\n1 2 3", "3 elements"),
        ("#1\ndouble a(1,1)\nx", "not a number"),
    ],
)
def test_damaged_text_tables(files: Files, content: str, word: str) -> None:
    (files.base / "bad.txt").write_text(content)
    with pytest.raises(RoutineFailed, match=word):
        read_table(files, "bad.txt", "a")


def test_a_damaged_matlab_file(files: Files) -> None:
    (files.base / "bad.mat").write_bytes(b"\x80\x04garbage" * 20)
    with pytest.raises(RoutineFailed, match="MATLAB"):
        read_table(files, "bad.mat", "a")


def test_functions_of_files(files: Files) -> None:
    table = file_routines(files)
    assert table["ModelicaInternal_stat"](["table.txt"]) == {-1: 2}
    assert table["ModelicaInternal_stat"]([str(files.base)]) == {-1: 3}
    assert table["ModelicaInternal_stat"](["/etc"]) == {-1: 1}
    assert table["ModelicaInternal_countLines"](["table.txt"]) == {-1: 7}
    assert table["ModelicaInternal_readLine"](["table.txt", 2]) == {-1: "# a comment", 2: False}
    assert table["ModelicaInternal_readLine"](["table.txt", 9]) == {-1: "", 2: True}
    assert table["ModelicaIO_readMatrixSizes"](["data.mat", "m"]) == {2: Tensor((2,), (2, 2))}
    full = table["ModelicaInternal_fullPathName"](["modelica://Package/a/b.txt"])[-1]
    assert full == str(files.base / "a" / "b.txt")
    assert "ModelicaInternal_removeFile" not in table
