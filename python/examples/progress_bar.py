"""A tqdm bar while isoloop runs: python3 progress_bar.py"""

from tqdm import tqdm

import isoloop

with tqdm(total=100, unit="%") as bar:

    def show(stage, share):
        bar.set_description(stage)
        bar.update(round(100 * share) - bar.n)

    found = isoloop.loops(isoloop.generate("lattice", size=64, cells=2), progress=show)
    bar.update(100 - bar.n)
print(found)
