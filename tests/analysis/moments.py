"""Snapshots and checkpoints of an invented flow under an interface that is known: a wave along x."""

import json
import pathlib

import numpy as np

LENGTH_X, LENGTH_Z = 6.0, 3.0  # h, the paper's box
NX, NZ = 24, 12
AMPLITUDE, WAVES = 0.05, 2
FILMED = "precursor", "G=1_mu=1"  # cases that have a film


def eta(n=NX):
    """Height of the interface over the centres of the cells along x."""
    x = (np.arange(n) + 0.5) / n * LENGTH_X
    return 2 + AMPLITUDE * np.cos(2 * np.pi * WAVES * x / LENGTH_X)


def velocity(name, x, y, z):
    """Of one component at points [z][y][x]; no derivative of it vanishes everywhere."""
    phase = {"u": 0.0, "v": 1.0, "w": 2.0}[name]
    return 0.1 * np.sin(2 * np.pi * (x / LENGTH_X + z / LENGTH_Z) + phase) * (1 + 0.5 * y)


def _points(y, shift_x=0.5, shift_z=0.5):
    x = (np.arange(NX) + shift_x) / NX * LENGTH_X
    z = (np.arange(NZ) + shift_z) / NZ * LENGTH_Z
    return x[None, None, :], y[None, :, None], z[:, None, None]


def _phi(y_face):
    """Share of each cell above the interface."""
    below = np.clip((eta()[None, :] - y_face[:-1, None]) / np.diff(y_face)[:, None], 0, 1)
    return np.broadcast_to(1 - below, (NZ, *below.shape))


def write_snapshot(file, y_face, time, elastic):
    import h5py

    centres = _points((y_face[1:] + y_face[:-1]) / 2)
    with h5py.File(file, "w") as data:
        data["time"] = time
        data["x"], data["z"] = np.linspace(0, LENGTH_X, NX + 1), np.linspace(0, LENGTH_Z, NZ + 1)
        data["y"] = y_face
        for name in "uvw":
            data[name] = velocity(name, *centres)
        data["p"] = velocity("v", *centres)
        if elastic:
            data["phi"] = _phi(y_face)


def write_planes(folder, y_face, times, elastic):
    """A film of `velocity` across each axis, and of `eta`, which travels along x by one cell from moment to moment."""
    import h5py

    faces = {"x": np.linspace(0, LENGTH_X, NX + 1), "y": y_face, "z": np.linspace(0, LENGTH_Z, NZ + 1)}
    centres = _points((y_face[1:] + y_face[:-1]) / 2)
    for number, time in enumerate(times):
        with h5py.File(folder / f"planes-{10 * number:09d}.h5", "w", userblock_size=512) as data:
            data["moment/time"], data["moment/step"] = [time], [10.0 * number]
            for axis, values in faces.items():
                data[f"grid/{axis}_face"], data[f"grid/{axis}_center"] = values, (values[1:] + values[:-1]) / 2
            for axis, along in (("x", 2), ("y", 1), ("z", 0)):
                data[f"{axis}_0/position"] = [(faces[axis][4] + faces[axis][5]) / 2]
                for name in ("u", "v", "w", "p"):
                    values = velocity("v" if name == "p" else name, *centres)
                    data[f"{axis}_0/{name}"] = np.roll(values, number, axis=2).take(4, axis=along).astype("f4")
                if elastic:
                    data[f"{axis}_0/phi"] = np.roll(_phi(y_face), number, axis=2).take(4, axis=along).astype("f4")
            if elastic:
                data["interface/position"] = [2.0]
                data["interface/height"] = np.broadcast_to(np.roll(eta(), number), (NZ, NX)).astype("f4")


def write_checkpoint(file, y_face, time, solid):
    """`solid`: None, "phi" (transported B) or "d_y" (a reference map whose columns have moved as a whole)."""
    import h5py

    y = (y_face[1:] + y_face[:-1]) / 2
    with h5py.File(file, "w", userblock_size=4096) as data:
        data["time"] = np.array([time])
        data["fields/u"] = velocity("u", *_points(y, shift_x=0))
        data["fields/v"] = velocity("v", *_points(y_face))
        data["fields/w"] = velocity("w", *_points(y, shift_z=0))
        data["fields/p"] = velocity("v", *_points(y))
        if solid == "phi":
            data["fields/phi"] = _phi(y_face)
        if solid == "d_y":
            data["fields/d_y"] = np.broadcast_to(eta() - 2, (NZ, len(y_face), NX))


def _write_blocks(data, group, start, end):
    data[f"{group}/start"], data[f"{group}/end"], data[f"{group}/weight"] = start, end, end - start


def _write_pairs(data, start, end):
    """v, p and the height along their wave: p a sixth of a period behind the height, v a quarter."""
    angle = 2 * np.pi * (np.arange(2000) + 0.5) / 2000
    values = {"v": np.sqrt(0.02) * np.sin(angle), "p": np.sqrt(0.02) * np.cos(angle - np.pi / 3),
              "eta": AMPLITUDE * np.cos(angle)}
    shape = np.sinh(6 * np.linspace(-1, 1, 50)) / np.sinh(6)
    _write_blocks(data, "interface_pairs", start, end)
    for name, half_range in (("v", 1), ("p", 0.5), ("eta", 0.5)):
        data[f"interface_pairs/edges_{name}"] = half_range * shape
    for (first, second), moment in ((("v", "eta"), "v_eta"), (("p", "eta"), "p_eta"), (("v", "p"), "vp")):
        edges = [data[f"interface_pairs/edges_{name}"][:] for name in (first, second)]
        share = np.histogram2d(values[first], values[second], edges)[0] / len(angle)
        data[f"interface_pairs/share_{first}_{second}"] = np.broadcast_to(share, (len(start), 49, 49))
        data[f"interface/{moment}"] = np.full(len(start), (values[first] * values[second]).mean())


def budget_of_a_known_flow(y_face, reynolds=2800.0):
    """Arrays of the budget of energy, [row]: a parabola under a layer at rest whose fluctuations produce, dissipate 0.9 of it in
    the same row, keep 0.05 and hand on 0.1 from the lower half of the fluid to the upper (0.05 of it from nowhere),
    while the mean flow gets faster. Also the production."""
    y, dy = (y_face[1:] + y_face[:-1]) / 2, np.diff(y_face)
    u = np.where(y < 2, 1.5 * y * (2 - y), 0)
    gap = np.concatenate([[dy[0]], np.diff(y), [dy[-1]]])
    shear = np.diff(np.concatenate([[-u[0]], u, [-u[-1]]])) / gap
    flux = np.where((y_face > 0) & (y_face < 2), -0.003 * np.sin(np.pi * y_face), 0)
    to_rows = lambda faces: (faces[:-1] * gap[:-1] + faces[1:] * gap[1:]) / (2 * dy)
    stress, production = shear / reynolds, -to_rows(flux * shear)
    force = {"convection": -np.diff(flux) / dy, "viscous": np.diff(stress) / dy, "excess": 0 * u, "elastic": 0 * u,
             "driving": 0.004 + 0 * u}
    handed_on = np.where(y < 1, -1.0, 0.0) + np.where((y > 1) & (y < 2), 1.0, 0.0)
    handed_on *= 0.1 * (production * dy)[y < 1].sum() / np.where(handed_on < 0, dy[y < 1].sum(), dy[(y > 1) & (y < 2)].sum())
    power = {"convection": u * force["convection"] + production + handed_on,
             "viscous": u * force["viscous"] - 0.9 * production, "excess": 0 * u, "elastic": 0 * u,
             "driving": u * force["driving"]}
    arrays = {f"force_{name}": rows for name, rows in force.items()} | {f"power_{name}": rows for name, rows in power.items()}
    arrays |= {"rate_u": 0.01 * u, "rate_kinetic": u * 0.01 * u + 0.05 * production}
    arrays |= {"u": u, "uv": flux[:-1], "kinetic": u**2 / 2, "elastic": 0 * u, "power_pressure": 0 * u,
               "work_viscous": to_rows(stress * shear) + 0.9 * production, "work_excess": 0 * u, "work_elastic": 0 * u}
    return arrays, production, handed_on


def write_spectra(file, y_face, blocks, elastic):
    """spectra.h5 with the waves of `eta` and `velocity`, and a power law beside them; a wave of the interface that travels
    with speed 0.6. `blocks`: their bounds, h/U_b."""
    import h5py

    start, end = np.array(blocks[:-1]), np.array(blocks[1:])
    with h5py.File(file, "w", userblock_size=512) as data:
        data["grid/y_center"], data["grid/y_face"] = (y_face[1:] + y_face[:-1]) / 2, y_face
        data["grid/length"], data["grid/columns"] = [LENGTH_X, LENGTH_Z], [float(NX), float(NZ)]
        data["grid/interface_y"] = [2.0]
        _write_blocks(data, "spectra", start, end)
        for axis, n in (("x", NX), ("z", NZ)):
            mode = np.arange(n // 2 + 1)
            power = 1e-5 * np.where(mode > 0, np.maximum(mode, 1.0) ** (-5 / 3), 0)
            power[1] += 0.005
            rows = power[:, None] * (1 + 0.25 * (y_face[1:] + y_face[:-1]))**2
            for name in "uvwp":
                data[f"spectra/{axis}_{name}"] = np.broadcast_to(rows, (len(start), *rows.shape)).astype("f4")
            if elastic:
                height = AMPLITUDE**2 / 2 * (mode == (WAVES if axis == "x" else 0)) + 1e-3 * power
                data[f"spectra/{axis}_eta"] = np.broadcast_to(height, (len(start), len(height)))
        _write_blocks(data, "budget", start, end)
        for name, rows in budget_of_a_known_flow(y_face)[0].items():
            data[f"budget/{name}"] = np.broadcast_to(rows, (len(start), len(rows)))
        if not elastic:
            return
        _write_blocks(data, "interface", start, end)
        edges = np.linspace(-0.5, 0.5, 257)
        share = np.histogram(AMPLITUDE * np.cos(2 * np.pi * (np.arange(1000) + 0.5) / 1000), edges)[0] / 1000
        data["interface/bin_edges"], data["interface/share"] = edges, np.broadcast_to(share, (len(start), 256))
        for name, value in (("eta2", AMPLITUDE**2 / 2), ("eta3", 0.0), ("eta4", 3 / 8 * AMPLITUDE**4)):
            data[f"interface/{name}"] = np.full(len(start), value)
        for name in ("uu", "vv", "ww", "pp", "uv", "up", "u_eta"):
            data[f"interface/{name}"] = np.full(len(start), 0.01)
        _write_pairs(data, start, end)
        time = np.arange(start[0], end[-1], 0.0503)
        amplitude = np.zeros((len(time), 8), complex) + 1e-5
        amplitude[:, WAVES - 1] = AMPLITUDE / 2 * np.exp(-2j * np.pi * WAVES / LENGTH_X * 0.6 * time)
        data["interface_waves/time"] = time
        data["interface_waves/real"], data["interface_waves/imaginary"] = amplitude.real, amplitude.imag


def write_moments(campaign):
    """A snapshot, a later checkpoint and spectra for every case of a campaign with statistics, and two films."""
    import h5py

    for directory in (pathlib.Path(campaign) / "cases").iterdir():
        elastic = json.loads((directory / "case.json").read_text())["physics"]["flow"] == "elastic_wall"
        with h5py.File(directory / "statistics.h5") as statistics:
            y_face = statistics["grid/y_face"][:]
            blocks = [*statistics["blocks/start"][:], statistics["blocks/end"][-1]]
        write_spectra(directory / "spectra.h5", y_face, blocks[::4], elastic)
        for folder in ("fields", "checkpoints", "planes"):
            (directory / folder).mkdir(exist_ok=True)
        if directory.name in FILMED:
            write_planes(directory / "planes", y_face, (0.0, 130.0, 148.0), elastic)
        write_snapshot(directory / "fields" / "fields-000000010.h5", y_face, 120.0, elastic)
        write_checkpoint(directory / "checkpoints" / "checkpoint-000000020.h5", y_face, 148.0, "d_y" if elastic else None)
