"""Files of results: what is written is read back, in every format, and by others."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import acausal
from acausal.errors import LookupProblem, SimulationProblem, UsageProblem
from acausal.results.signals import Layout, Signal, Vector
from acausal.results.stored import StoredResult, check_format, open_writer, read_result


def is_installed(ending: str) -> bool:
    """Whether a file with this ending can be written here."""
    try:
        check_format(Path(f"x.{ending}"))
    except UsageProblem:
        return False
    return True


ENDINGS = [ending for ending in ("csv", "mat", "nc", "parquet") if is_installed(ending)]

LAYOUT = Layout(
    "Tank",
    (
        Signal("h", "m", "Depth", 0),
        Signal("a[1,2].b", "", "", 1),
        Signal("minus", "m", "Opposite", 0, -1.0),
        Signal("der(h)", "m/s", "", 2),
        Signal("k", "1", "Constant [of the model]", None, 1.0, 0.1),
        Signal("'x/y'", "", "", 1),
    ),
    3,
)
TIME = np.array([0.0, 0.1, 0.1, 1 / 3])
ROWS = np.array([[1.0, -2.5, 1e-300], [0.1, 3.0, -1e300], [0.2, 3.0, 5.0], [np.pi, 1e-9, 0.0]])


def table(rows: Vector) -> dict[str, Vector]:
    columns = (rows[:, 0], rows[:, 1], -rows[:, 0], rows[:, 2], np.full(len(rows), 0.1), rows[:, 1])
    return {signal.name: column for signal, column in zip(LAYOUT.signals, columns, strict=True)}


def holds(found: StoredResult, time: Vector, rows: Vector) -> None:
    assert found.time.tolist() == time.tolist()
    assert found.names == tuple(signal.name for signal in LAYOUT.signals)
    for name, values in table(rows).items():
        assert found.values(name).tolist() == values.tolist(), name


@pytest.mark.parametrize("ending", ENDINGS)
def test_every_bit_comes_back(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"a.{ending}"
    writer = open_writer(path, LAYOUT)
    writer.write(TIME[:1], ROWS[:1])
    writer.write(TIME[1:], ROWS[1:])
    assert writer.rows == 4
    writer.close()
    found = read_result(path)
    holds(found, TIME, ROWS)
    if ending != "csv":
        assert [found.unit(name) for name in found.names] == ["m", "", "m", "m/s", "1", ""]
        assert found.description("k") == "Constant [of the model]"
        assert found["h"].attrs == {"units": "m", "long_name": "Depth"}
    with pytest.raises(LookupProblem):
        found.values("nothing")


@pytest.mark.parametrize("ending", ENDINGS)
def test_file_goes_on_after_some_rows(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"a.{ending}"
    first = open_writer(path, LAYOUT)
    first.write(TIME[:3], ROWS[:3])
    first.close()
    second = open_writer(path, LAYOUT, 2)
    second.write(TIME[2:], 2 * ROWS[2:])
    second.close()
    holds(read_result(path), TIME, np.concatenate([ROWS[:2], 2 * ROWS[2:]]))


@pytest.mark.parametrize("ending", ["csv", "mat", "nc"])
def test_file_that_nobody_closed_is_readable(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"a.{ending}"
    writer = open_writer(path, LAYOUT)
    writer.write(TIME, ROWS)
    writer.abandon()
    with path.open("ab") as file:
        file.write(b"1.5,2")  # of a row that was being written
    found = read_result(path)
    holds(found, TIME, ROWS)


@pytest.mark.parametrize("ending", ["csv", "mat", "nc"])
def test_full_disk_keeps_whole_rows(tmp_path: Path, ending: str) -> None:
    resource = pytest.importorskip("resource")
    path = tmp_path / f"a.{ending}"
    time = np.arange(3000) / 8
    rows = np.column_stack([time, 2 * time, 3 * time])
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    writer = open_writer(path, LAYOUT)
    writer.write(time[:100], rows[:100])
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_001, before[1]))
    try:
        with pytest.raises(SimulationProblem) as problem:
            writer.write(time[100:], rows[100:])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    writer.abandon()
    found = read_result(path)
    assert 100 < len(found.time) == writer.rows < 3000
    holds(found, time[: writer.rows], rows[: writer.rows])
    assert problem.value.diagnostics[0].code == "result.write"
    assert f"first {writer.rows} rows" in str(problem.value)


def test_device_that_is_full() -> None:
    device = Path("/dev/full")
    if not device.exists():
        pytest.skip("there is no /dev/full")
    with pytest.raises(UsageProblem, match=r"usage\.output"):
        open_writer(device, LAYOUT)


def test_mat_is_laid_out_as_tools_expect(tmp_path: Path) -> None:
    """Read by hand: names as columns, signs in `dataInfo`, the constant at both ends in `data_1`."""
    path = tmp_path / "a.mat"
    writer = open_writer(path, LAYOUT)
    writer.write(TIME, ROWS)
    writer.close()
    data, at, found = path.read_bytes(), 0, dict[str, tuple[tuple[int, int], bytes]]()
    while at < len(data):
        kind, rows, columns, imaginary, length = struct.unpack_from("<5i", data, at)
        name = data[at + 20 : at + 19 + length].decode()
        size = rows * columns * {0: 8, 20: 4, 51: 1}[kind]
        at += 20 + length
        found[name] = (rows, columns), data[at : at + size]
        assert imaginary == 0
        at += size
    assert list(found) == ["Aclass", "name", "description", "dataInfo", "data_1", "data_2"]
    assert found["Aclass"][0] == (4, 11)
    assert bytes(found["Aclass"][1][i] for i in range(3, 44, 4)).rstrip() == b"binTrans"
    length = found["name"][0][0]
    assert found["name"][1][length : 2 * length].rstrip(b"\0") == b"h"
    info = np.frombuffer(found["dataInfo"][1], "<i4").reshape(-1, 4)
    assert info[:, :2].tolist() == [[0, 1], [2, 2], [2, 3], [2, -2], [2, 4], [1, 2], [2, 3]]
    assert np.frombuffer(found["data_1"][1], "<f8").tolist() == [0.0, 0.1, TIME[-1], 0.1]
    assert found["data_2"][0] == (4, 4)


def test_xarray_reads_netcdf(tmp_path: Path) -> None:
    model = 'model M Real x(start = 1, fixed = true, unit = "m") "Way"; equation der(x) = 2; end M;'
    result = acausal.loads(model).compile().simulate(stop_time=0.1)
    path = result.save(tmp_path / "m.nc")
    with xr.open_dataset(path, decode_timedelta=False) as data:  # pyright: ignore[reportUnknownMemberType]
        assert data["x"].attrs == {"units": "m", "long_name": "Way"}
        assert data["x"].values.tolist() == result.values("x").tolist()
        assert data.attrs["model"] == "M"


TEXTS = [b"", b"time,x\n", b"x,y\n1,2\n", b"time,x\n1,2\n0,2\n", b"time,x\n1\n"]


@pytest.mark.parametrize("data", [*TEXTS, b"\0\1\2\3" * 20, b"CDF\x02abc", b"PAR1"])
def test_what_is_no_result_is_refused(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "bad"
    path.write_bytes(data)
    with pytest.raises(UsageProblem) as problem:
        read_result(path)
    assert problem.value.diagnostics[0].code in ("result.not-a-result", "usage.parquet")
