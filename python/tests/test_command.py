"""The module finds what the command finds, byte for byte."""

import json

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
