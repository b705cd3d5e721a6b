"""The module finds what the command finds, byte for byte."""

import json

import warnings

import numpy
import pytest
from conftest import data, without_cost

import isoloop

VOLUMES = {
    "volumes/fuel_64x64x64_uint8.raw": 30,
    "volumes/engine_half_128x128x64_uint8.raw": 70,
    "volumes/silicium_98x34x34_uint8.raw": 120,
    "formats/hippo.nii.gz": 0.5,
    "formats/hydrogenAtom.mha": 60,
    "formats/tooth.nhdr": 600,
}


@pytest.mark.parametrize("name", VOLUMES)
def test_counts_and_loops_are_those_of_the_command(command, name):
    path, iso = data(name), VOLUMES[name]
    volume = isoloop.read(path)
    counted = isoloop.count(volume, iso)
    expected = command("count", path, "--iso", iso)
    assert without_cost(counted.to_json()) == without_cost(expected)
    found = isoloop.loops(volume, iso)
    assert without_cost(found.to_json()) == without_cost(command("loops", path, "--iso", iso))
    assert json.loads(found.to_json()) == found.to_dict()


def test_features_labels_and_csv_are_those_of_the_command(command, tmp_path):
    path = data("volumes/fuel_64x64x64_uint8.raw")
    found = isoloop.features(isoloop.read(path), 30, side="tunnel")
    labels = str(tmp_path / "labels.nrrd")
    csv = str(tmp_path / "table.csv")
    text = command("loops", path, "--iso", 30, "--side", "tunnel", "--features", "--labels", labels,
                   "--csv", csv)
    assert without_cost(found.to_json()) == without_cost(text)
    assert numpy.array_equal(found.labels, isoloop.read(labels).array)
    with open(csv, encoding="utf-8") as file:
        assert found.to_csv() == file.read()


def test_scans_are_those_of_the_command(command):
    path = data("volumes/fuel_64x64x64_uint8.raw")
    scan = isoloop.scan(isoloop.read(path), from_=5, to=90)
    assert without_cost(scan.to_json()) == without_cost(
        command("scan", path, "--from", 5, "--to", 90))
    assert scan.proposed == scan.to_dict()["proposed_iso"]
    assert scan.rows["iso"][0] == 5 and scan.rows["b1"].max() > 0


@pytest.mark.parametrize("ignore_below", [None, 64])
def test_plateaus_have_the_counts_of_the_json(ignore_below):
    scan = isoloop.scan(data("volumes/fuel_64x64x64_uint8.raw"), ignore_below=ignore_below)
    told = scan.to_dict()["plateaus"]
    assert [p.betti for p in scan.plateaus] == [(p["b0"], p["b1"], p["b2"]) for p in told]
    assert [(p.width, p.voxels) for p in scan.plateaus] == [(p["width"], p["voxels"]) for p in told]
    assert [(p.least, p.most) for p in scan.plateaus] == [(p["from"], p["to"]) for p in told]


def test_auto_takes_the_value_that_the_command_takes(command):
    path = data("volumes/fuel_64x64x64_uint8.raw")
    counted = isoloop.count(isoloop.read(path), "auto")
    assert without_cost(counted.to_json()) == without_cost(command("count", path, "--iso", "auto"))
    assert counted.iso == isoloop.scan(path).proposed and "auto" in counted.notes[0]


def test_repairs_are_those_of_the_command(command, tmp_path):
    path = data("volumes/fuel_64x64x64_uint8.raw")
    out = str(tmp_path / "out_64x64x64_uint8.raw")
    text = command("repair", path, "--iso", 30, "--genus", 0, "-o", out)
    volume = isoloop.read(path)
    repaired = isoloop.repair(volume, 30, genus=0)
    expected = json.loads(text)
    for report in (expected, found := repaired.to_dict()):
        for cost in ("seconds", "peak_bytes", "output"):
            del report[cost]
    assert found == expected
    after = isoloop.read(out).array
    assert numpy.array_equal(repaired.array, after)
    assert numpy.array_equal(repaired.changed, after != volume.array)
    assert (repaired.added_voxels, repaired.removed_voxels, repaired.shifted_voxels) == (
        found["filled_voxels"], found["cut_voxels"], found["shifted_voxels"])
    assert repaired.after.genus == 0


@pytest.mark.parametrize("order", ["C", "F"])
def test_repairs_of_labels_keep_the_others_as_the_command_does(command, tmp_path, ring, order):
    import subprocess

    labels = numpy.where(ring, 7, 0).astype("u1")
    labels[0, 0, 0] = 5
    labels = numpy.asarray(labels, order=order)
    isoloop.write(labels, tmp_path / "labels.nrrd")
    subprocess.run([command.program, "repair", tmp_path / "labels.nrrd", "--label", "7", "--genus", "0",
                    "-o", tmp_path / "out.nrrd"], check=True, capture_output=True)
    repaired = isoloop.repair(labels, label=7, genus=0)
    assert numpy.array_equal(repaired.array, isoloop.read(tmp_path / "out.nrrd").array)
    assert numpy.array_equal(repaired.changed, repaired.array != labels)
    assert set(numpy.unique(repaired.array[repaired.changed])) == {7}
    assert isoloop.count(repaired.array, label=7).tunnels == 0
    hole = numpy.argwhere(repaired.changed)[0]
    labels[tuple(hole)] = 3
    with pytest.warns(isoloop.IsoloopWarning, match="another label than 0: 1"):
        isoloop.repair(labels, label=7, genus=0)


def test_files_are_those_that_convert_writes(command, tmp_path):
    import subprocess

    volume = isoloop.read(data("formats/hippo.nii.gz"))
    for name in ("a.nrrd", "a.nii.gz", "a.npy", "a.vti", "a.mha"):
        ours = tmp_path / ("ours_" + name)
        subprocess.run([command.program, "convert", volume.file, tmp_path / name], check=True,
                       capture_output=True)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            isoloop.write(volume, ours)
        assert ours.read_bytes() == (tmp_path / name).read_bytes()


def test_writing_says_what_a_format_cannot(tmp_path, ring):
    with pytest.warns(isoloop.IsoloopWarning, match="the spacing 1 2 3"):
        isoloop.write(ring, tmp_path / "a.npy", spacing=(1, 2, 3))
    assert isoloop.read(tmp_path / "a.npy").mask
    assert numpy.array_equal(isoloop.read(tmp_path / "a.npy").array, ring)
    with pytest.raises(isoloop.UsageError, match="written as"):
        isoloop.write(ring, tmp_path / "a.tif")
    with pytest.raises(isoloop.UsageError, match="round"):
        isoloop.write(ring.astype("i4"), tmp_path / "a.vdb")


def test_tables_and_summaries_are_those_of_the_command(command):
    import subprocess

    path = data("volumes/fuel_64x64x64_uint8.raw")
    found = isoloop.loops(path, 30)
    for method, flags in (("summary", ["--summary"]), ("table", []), ("table", ["--top", "3"])):
        told = subprocess.run([command.program, "loops", path, "--iso", "30", *flags],
                              check=True, capture_output=True).stdout.decode()
        given = [int(flags[1])] if len(flags) == 2 else []
        assert getattr(found, method)(*given).strip() == told.strip()


def test_the_page_is_the_commands(command, tmp_path):
    import subprocess

    path = data("volumes/fuel_64x64x64_uint8.raw")
    page = str(tmp_path / "page.html")
    subprocess.run([command.program, "view", path, "--iso", "30", "-o", page], check=True,
                   capture_output=True)
    shown = isoloop.view(isoloop.read(path), 30, tmp_path / "ours.html")
    with open(page, encoding="utf-8") as file:
        assert shown.html == file.read()
    assert (tmp_path / "ours.html").read_text(encoding="utf-8") == shown.html
    assert "srcdoc" in shown._repr_html_()


def test_an_array_in_any_order_gives_the_page_of_its_own_axes():
    volume = isoloop.generate("plate", size=32, holes=1)
    c_order = numpy.ascontiguousarray(volume.array)
    given = {"iso": 0, "inside": "below", "triangles": 500}
    assert len(isoloop.view(c_order, **given).html) == pytest.approx(
        len(isoloop.view(volume.array, **given).html), rel=0.01)


def test_files_of_every_kind_are_read_with_the_place_of_their_voxels():
    for name in ("formats/hippo.nii.gz", "formats/tooth.nhdr", "formats/hydrogenAtom.mha"):
        array, affine = isoloop.read(data(name))
        assert array.flags.f_contiguous and affine.shape == (4, 4)
    volume = isoloop.read(data("volumes/engine_half_128x128x64_uint8.raw"), crop="0:20,:,5:")
    assert volume.shape == (20, 128, 59)
    assert isoloop.read(volume.file, crop=(slice(20), slice(None), slice(5, None))).shape == volume.shape


def test_reading_says_what_is_wrong_in_keywords(tmp_path):
    with pytest.raises(isoloop.InvalidInput) as caught:
        isoloop.read(tmp_path / "none.nii")
    assert caught.value.fault == "unreadable" and caught.value.file.endswith("none.nii")
    (tmp_path / "a.raw").write_bytes(b"1234")
    with pytest.raises(isoloop.UsageError, match="dims="):
        isoloop.read(tmp_path / "a.raw")
    with pytest.raises(isoloop.UsageError, match="crop="):
        isoloop.read(tmp_path / "a.raw", crop=(slice(0, 4, 2), slice(None), slice(None)))
    assert isoloop.read(tmp_path / "a.raw", dims=(4, 1, 1), type="u8").shape == (4, 1, 1)


def test_complexes_are_those_of_the_command(command):
    path = data("volumes/fuel_64x64x64_uint8.raw")
    volume = isoloop.read(path)
    for complex, grading in [("grid", None), ("octree", None), ("octree", 0), ("octree", 2)]:
        found = isoloop.loops(volume, 15, complex=complex, grading=grading)
        flags = [] if grading is None else ["--grading", grading]
        text = command("loops", path, "--iso", 15, "--complex", complex, *flags)
        assert without_cost(found.to_json()) == without_cost(text)
        assert found.to_dict()["conventions"]["complex"] == complex
    with pytest.raises(isoloop.UsageError, match="grading="):
        isoloop.loops(volume, 15, complex="grid", grading=1)
    with pytest.raises(isoloop.UsageError, match="grading="):
        isoloop.loops(volume, 15, grading=3)
