"""A NIfTI file to a table of tunnels in RAS: python3 nifti_table.py IMAGE.nii.gz ISO [TABLE.csv]"""

import sys

import nibabel
import numpy

import isoloop

path, iso = sys.argv[1], float(sys.argv[2])
image = nibabel.load(path)
found = isoloop.loops(
    numpy.asanyarray(image.dataobj), iso, affine=image.affine, frame="ras", unit="mm", side="tunnel"
)
table = found.to_numpy()
print(f"{len(table)} tunnels; the widest first, in mm, right-anterior-superior:")
for row in table[::-1][:10]:
    right, anterior, superior = row["center_world"]
    print(f"{row['id']:4d} {row['length']:9.2f} {right:9.2f} {anterior:9.2f} {superior:9.2f}")
if len(sys.argv) > 3:
    with open(sys.argv[3], "w", encoding="utf-8") as file:
        file.write(found.to_csv())
