"""Coordinates come back in the array's own axes, whatever convention it follows."""

import itertools

import numpy
import pytest
from conftest import plate

import isoloop

HOLE = (5, 6, 12)  # (z, y, x), (i, j, k), (k, j, i): a place in the array


def center_of(array, **given):
    """Where the one tunnel is: on the voxel that a person points at, to half a voxel."""
    found = isoloop.loops(array, **given)
    assert (found.components, found.tunnels, found.cavities) == (1, 1, 0)
    return found.tunnel_loops[0]


def test_scikit_image_and_napari_arrays_are_z_y_x():
    tunnel = center_of(plate(), spacing=(2.0, 0.5, 0.25))
    assert numpy.abs(tunnel.center_index[1:] - HOLE[1:]).max() < 0.5
    assert numpy.allclose(tunnel.center, tunnel.center_index * (2.0, 0.5, 0.25))
    assert numpy.abs(tunnel.curves[0][:, 2] - HOLE[2] * 0.25).max() < 3 * 0.25


def test_nibabel_arrays_are_i_j_k_with_an_affine():
    solid = numpy.asfortranarray(plate(axis=2, hole=(5, 6, 8)))
    affine = numpy.array([[-2.0, 0, 0, 90], [0, 0, 1.5, -126], [0, -1.0, 0, 72], [0, 0, 0, 1]])
    tunnel = center_of(solid, affine=affine, frame="ras")
    assert numpy.abs(tunnel.center_index[:2] - (5, 6)).max() < 0.5
    at_hole = affine @ [5, 6, tunnel.center_index[2], 1]
    assert numpy.abs(tunnel.center_world - at_hole[:3]).max() < 1.5
    assert numpy.allclose(isoloop.loops(solid, affine=affine).spacing, (2.0, 1.0, 1.5))


def test_pyvista_points_run_x_fastest():
    grid = plate(axis=2, hole=(5, 6, 8))  # of dimensions (11, 13, 17), as ImageData.dimensions
    flat = grid.ravel(order="F")  # as ImageData.point_data holds them
    array = flat.reshape((11, 13, 17), order="F")
    tunnel = center_of(array, spacing=(0.1, 0.2, 0.3))
    assert numpy.abs(tunnel.center[:2] - (0.5, 1.2)).max() < 0.1


def test_sitk_views_are_z_y_x_and_say_spacing_and_origin_in_x_y_z():
    view = plate()  # as sitk.GetArrayViewFromImage() has it
    spacing, origin, direction = (0.5, 0.7, 2.0), (10.0, -20.0, 30.0), numpy.eye(3)
    affine = numpy.eye(4)
    affine[:3, :3] = (direction * spacing)[:, ::-1]  # columns along z, y, x
    affine[:3, 3] = origin
    tunnel = center_of(view, affine=affine, frame="lps")
    assert abs(tunnel.center_world[0] - (10.0 + 0.5 * HOLE[2])) < 0.25
    assert abs(tunnel.center_world[1] - (-20.0 + 0.7 * HOLE[1])) < 0.35


def test_slicer_arrays_are_k_j_i_and_its_matrix_leads_from_i_j_k_to_ras():
    kji = plate()  # as slicer.util.arrayFromVolume() has it
    ijk_to_ras = numpy.array([[-0.5, 0, 0, 40], [0, -0.7, 0, 50], [0, 0, 2.0, -60], [0, 0, 0, 1]])
    affine = ijk_to_ras[:, [2, 1, 0, 3]]
    tunnel = center_of(kji, affine=affine, frame="ras")
    expected = ijk_to_ras @ [HOLE[2], HOLE[1], tunnel.center_index[0], 1]
    assert numpy.abs(tunnel.center_world - expected[:3]).max() < 0.35


def test_itk_images_as_numpy_arrays_turned_to_x_y_z():
    xyz = plate().transpose()  # a view: x slowest in its shape, fastest in memory
    tunnel = center_of(xyz, spacing=(0.5, 0.7, 2.0))
    assert numpy.abs(tunnel.center_index[:2] - (HOLE[2], HOLE[1])).max() < 0.5


@pytest.mark.parametrize("axes", itertools.permutations(range(3)))
def test_every_order_of_memory_is_read_where_it_lies_and_gives_the_same_place(axes):
    memory = plate().astype(numpy.uint8)
    turned = numpy.ascontiguousarray(memory.transpose(axes)).transpose(numpy.argsort(axes))
    assert numpy.array_equal(turned, memory)
    made = isoloop._arrays.input_of(turned)
    assert numpy.shares_memory(made.voxels(), turned)
    assert numpy.array_equal(made.voxels(), turned)
    tunnel = center_of(turned, iso=1)
    assert numpy.abs(tunnel.center_index[1:] - HOLE[1:]).max() < 0.5


@pytest.mark.parametrize("axes", itertools.permutations(range(3)))
def test_triangles_face_outwards_in_every_order_of_axes_and_in_mirrored_worlds(axes):
    solid = numpy.ascontiguousarray(plate().transpose(axes)).transpose(numpy.argsort(axes))
    mirror = numpy.diag([-1.0, 2.0, 3.0, 1.0])
    counts = isoloop.count(solid, affine=mirror)
    for world in (False, True):
        vertices, triangles = counts.surface(world=world)
        a, b, c = (vertices[triangles[:, i]].astype(float) for i in range(3))
        volume = numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6
        assert volume > 0.5 * 6.0 * solid.sum() if world else volume > 0
    assert vertices[:, 0].max() <= 0, "the world's first axis runs backwards"


def test_nan_is_named_by_its_place_in_the_array():
    array = numpy.zeros((3, 4, 5), numpy.float32)
    array[1, 2, 4] = numpy.nan
    for voxels in (array, numpy.asfortranarray(array), array.transpose((0, 2, 1)).copy().transpose((0, 2, 1))):
        with pytest.raises(isoloop.InvalidInput, match=r"voxel \(1, 2, 4\).*nan_as=VALUE") as caught:
            isoloop.count(voxels, iso=0)
        assert (caught.value.place, caught.value.fault) == ("voxel (1, 2, 4)", "not finite")
        assert isoloop.count(voxels, iso=0.5, nan_as=1).components == 1
    assert numpy.isnan(array[1, 2, 4]), "the caller's array stays as it is"
