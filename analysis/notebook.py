"""A campaign's results in one's own hands: copy this file and change it.

python3 analysis/notebook.py CAMPAIGN_DIR [-o FILE]

Lines with %% begin cells for editors that run a script cell by cell (Jupyter through jupytext, Spyder, VS Code). It
needs numpy, h5py and matplotlib, uses pandas where that is installed, and reads only: it may look on while the campaign runs.
"""

# %% Where the campaign is
import argparse
import pathlib
import sqlite3

import packages

packages.needed("h5py", "matplotlib", "numpy")
import h5py
import matplotlib.pyplot as plt
import numpy as np

arguments = argparse.ArgumentParser(description="Print the results of a campaign and draw one mean profile of each case.")
arguments.add_argument("campaign", type=pathlib.Path, help="folder of the campaign")
arguments.add_argument("-o", "--output", type=pathlib.Path, help="picture; default: notebook.png in the campaign's folder")
arguments = arguments.parse_args()
campaign = arguments.campaign

# %% The store: a row a case, with the half widths of its 95 % intervals
QUESTION = """SELECT results.label, results.G, results.viscosity_ratio, re_tau, re_tau_ci95, delta_rms, window_start, directory
              FROM results JOIN cases USING (case_id) WHERE window_start IS NOT NULL"""
store = sqlite3.connect(f"file:{campaign / 'results.db'}?mode=ro", uri=True)
try:
    import pandas

    table = pandas.read_sql(QUESTION, store)  # table.to_parquet("results.parquet") where pyarrow is installed, too
    print(table.drop(columns="directory").to_string(index=False))
    rows = table.to_dict("records")
except ModuleNotFoundError:
    store.row_factory = sqlite3.Row
    rows = [dict(row) for row in store.execute(QUESTION)]
    for row in rows:
        print(*(f"{name}={value}" for name, value in row.items() if name != "directory"))
store.close()


# %% Block averages: the mean of a profile over the blocks from a time on, weighted by what each has sampled
def mean_profile(directory, name, start):
    with h5py.File(directory / "statistics.h5") as file:
        blocks = file["blocks/start"][:] >= start
        weight = file["blocks/weight"][:][blocks]
        profile = file["profiles"][name]
        y = file["grid/y_center" if profile.attrs["location"] in ("center", b"center") else "grid/y_face"][:]
        return y, np.average(profile[:][blocks], axis=0, weights=weight)


# %% A figure of one's own
figure, axes = plt.subplots()
for row in rows:
    y, u = mean_profile(campaign / row["directory"], "u", row["window_start"])
    axes.plot(u, y, label=row["label"])
axes.set(xlabel=r"$\overline{u}/U_b$", ylabel="$y/h$")
axes.legend()
output = arguments.output or campaign / "notebook.png"
figure.savefig(output, dpi=150)
print(output)
