"""flow_fields_test.py ROOT: what the figures make of snapshots, checkpoints and block averages. ROOT is the source folder.

Exit 77 (skipped) where h5py or matplotlib is not installed.
"""

import os
import pathlib
import sys
import tempfile
import unittest
import weakref

import packages_or_skip

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "analysis"))


class FakeCase:
    """What FlowField asks of a case, over rows that are not uniform."""

    def __init__(self, directory):
        face = np.concatenate([np.linspace(0, 1.8, 19), np.linspace(1.82, 2.5, 35)])
        self.directory, self.interface_y = directory, 2.0
        self.y = {"face": face, "center": (face[1:] + face[:-1]) / 2}

    def mean(self, name):
        return self.y["center"], np.full(len(self.y["center"]), 0.25)


class FlowFields(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.case = FakeCase(pathlib.Path(scratch.name))
        for folder in ("fields", "checkpoints"):
            (self.case.directory / folder).mkdir()

    def snapshot(self, step=1, time=1.0, elastic=True):
        file = self.case.directory / f"fields/fields-{step:09d}.h5"
        moments.write_snapshot(file, self.case.y["face"], time, elastic)
        return file

    def checkpoint(self, step=2, time=2.0, solid="d_y"):
        file = self.case.directory / f"checkpoints/checkpoint-{step:09d}.h5"
        file.unlink(missing_ok=True)  # an earlier one may still be open
        moments.write_checkpoint(file, self.case.y["face"], time, solid)
        return file

    def test_moments_come_in_the_order_of_time_and_each_once(self):
        self.snapshot(1, 1.0)
        self.snapshot(3, 3.0)
        self.checkpoint(1, 1.0)
        self.checkpoint(2, 2.0)  # the newest one counts
        self.assertEqual([field.time for field in flow_fields.flow_fields(self.case)], [1.0, 2.0, 3.0])
        self.assertEqual(flow_fields.newest(self.case).time, 3.0)

    def test_what_cannot_be_read_is_left_out(self):
        self.snapshot()
        self.checkpoint().write_bytes(b"damaged")
        self.assertEqual([field.time for field in flow_fields.flow_fields(self.case)], [1.0])

    def test_a_checkpoint_can_be_read_after_the_case_has_removed_it(self):
        file = self.checkpoint()
        field = flow_fields.newest(self.case)
        file.unlink()
        self.assertLess(abs(field.interface_height() - moments.eta()).max(), 1e-12)

    def test_the_interface_is_found_by_volume_and_by_material(self):
        self.snapshot()
        by_snapshot = flow_fields.newest(self.case).interface_height()
        for solid in ("phi", "d_y"):
            self.checkpoint(solid=solid)
            field = flow_fields.newest(self.case)
            self.assertEqual(field.time, 2.0)
            for found in (by_snapshot, field.interface_height()):
                self.assertLess(abs(found - moments.eta()).max(), 1e-12)

    def test_the_interface_of_a_map_is_its_material_also_in_a_snapshot(self):
        """Which has the solid's share of the cells, too, and the displacement at the centres."""
        file = self.snapshot()
        with h5py.File(file, "r+") as data:
            data["d_y"] = np.broadcast_to(moments.eta() - 2, data["phi"].shape)
            data["phi"][...] = 0
        self.assertLess(abs(flow_fields.newest(self.case).interface_height() - moments.eta()).max(), 1e-12)

    def test_a_checkpoint_holds_the_velocities_of_a_snapshot(self):
        """To the second order of the mean of two faces."""
        self.snapshot()
        snapshot = flow_fields.newest(self.case)
        self.checkpoint()
        checkpoint = flow_fields.newest(self.case)
        for name in "uvwp":
            difference = abs(checkpoint.field(name) - snapshot.field(name)).max()
            self.assertLess(difference, 0.1 * 2.3 * (2 * np.pi / moments.NZ) ** 2 / 8, name)

    def test_values_on_a_surface_are_interpolated(self):
        self.snapshot()
        field = flow_fields.newest(self.case)
        with h5py.File(field.file, "r+") as data:
            data["p"][...] = 3 - 2 * self.case.y["center"][:, None]
        height = np.broadcast_to(moments.eta(), (moments.NZ, moments.NX))
        self.assertLess(abs(field.on_surface("p", height) - (3 - 2 * height)).max(), 1e-12)
        self.assertLess(abs(field.plane("p", 1.234) - (3 - 2 * 1.234)).max(), 1e-12)
        self.assertEqual(field.plane("p", 1.234).shape, height.shape)
        self.assertLess(abs(field.fluctuation("u") - (field.field("u") - 0.25)).max(), 1e-12)
        self.assertLess(abs(field.plane_of_fluctuation("u", 1.234) - (field.plane("u", 1.234) - 0.25)).max(), 1e-12)

    def test_a_plane_takes_the_rows_beside_it_alone(self):
        self.snapshot()
        self.checkpoint()
        for field in flow_fields.flow_fields(self.case):
            for name, rows in (("u", 2), ("v", 3 if field.is_checkpoint else 2)):
                read, shapes = field._read, []
                field._read = lambda *what: shapes.append(read(*what).shape) or read(*what)
                found = field.plane(name, 1.234)
                self.assertEqual(shapes, [(moments.NZ, rows, moments.NX)])
                del field._read
                row = np.searchsorted(self.case.y["center"], 1.234)
                whole = field.field(name)[:, row - 1: row + 1]
                self.assertTrue(((found - whole[:, 0]) * (found - whole[:, 1]) <= 1e-15).all())

    def test_a_checkpoint_is_closed_with_its_moment(self):
        file = self.checkpoint()
        field = flow_fields.newest(self.case)
        self.assertGreater(abs(field.field("u")).max(), 0)
        open_files = lambda: [os.path.realpath(each) for each in pathlib.Path("/proc/self/fd").iterdir()]
        self.assertIn(str(file.resolve()), open_files())
        ended = weakref.ref(field)
        del field
        self.assertIsNone(ended())
        self.assertNotIn(str(file.resolve()), open_files())


class Correlations(unittest.TestCase):
    def test_waves_have_the_exact_correlation(self):
        x, z = np.arange(32) / 32, np.arange(24) / 24
        field = (np.cos(2 * np.pi * 3 * x)[None, None, :] * (1 + np.sin(2 * np.pi * 2 * z))[:, None, None]
                 * np.ones((1, 2, 1)))
        field[:, 1] = 0  # a row at rest
        for axis, exact in ((2, np.cos(2 * np.pi * 3 * x[:17])), (0, (1 + np.cos(2 * np.pi * 2 * z[:13]) / 2) / 1.5)):
            found = correlations.correlation([field, 2 * field], axis)
            self.assertEqual(found.shape, (2, len(exact)))
            self.assertLess(abs(found[0] - exact).max(), 1e-12)
            self.assertTrue((found[1] == 0).all())

    def test_separations_are_whole_cells(self):
        """Of an odd number none is half the period."""
        for cells, exact in ((4, (0, 1.5, 3)), (5, (0, 1.2, 2.4))):
            self.assertLess(abs(correlations._separations(6.0, cells) - exact).max(), 1e-12)


class Surfaces(unittest.TestCase):
    def test_waves_are_resampled_exactly_and_their_first_points_repeated(self):
        wave = lambda nz, nx: np.add.outer(np.cos(2 * np.pi * np.arange(nz) / nz), np.sin(4 * np.pi * np.arange(nx) / nx))
        for shape in ((16, 48), (8, 12), (24, 31)):
            found = plot_wall_surface.resampled(wave(11, 24), shape)
            self.assertEqual(found.shape, (shape[0] + 1, shape[1] + 1))
            self.assertLess(abs(found[:-1, :-1] - wave(*shape)).max(), 1e-12)
            self.assertTrue((found[-1] == found[0]).all() and (found[:, -1] == found[:, 0]).all())


if __name__ == "__main__":
    packages_or_skip.needed("h5py", "matplotlib")
    import h5py
    import numpy as np

    import correlations
    import flow_fields
    import moments
    import plot_wall_surface
    import transient
    unittest.main(argv=sys.argv[:1])
