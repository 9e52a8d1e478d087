# SPDX-License-Identifier: GPL-3.0-or-later
"""How the dullness of the wheel changes the shaft 30h6: cycle, sweep and batch.

    PYTHONPATH=build/release/python python3 resources/examples/python/shaft_30h6.py
"""
import pathlib

import numpy as np
import sparkout

project = sparkout.Project.read(pathlib.Path(__file__).parents[1] / "shaft-30h6-factory.sparkout")

# One cycle against its drawing.
cycle = sparkout.evaluate(project)
print(f"{cycle.status}: {cycle.count} double strokes, {cycle.time_s / 60:.3f} min")
for section in cycle.sections:
    size_um = 1000 * (2 * section["radii_mm"].mean() - project["/part/diameter_mm"])
    print(f"  {section['where']:4} {size_um:+7.2f} µm, peak {section['peak_normal_force_n']:.0f} N")
for each in cycle.requirements:
    if not each["holds"]:
        print(f"  fails: {each['name']} at {each['where']}")

# The same cycle with a wheel that dulls.
axis = {"input": "/wheel/dullness", "from": 0.02, "to": 0.1, "points": 9}
sweep = sparkout.sweep(project.with_values({"/sweep": {"inputs": [axis]}}))
time_s = sweep.values[:, sweep.quantities.index("time part [s]")]
for dullness, seconds in zip(sweep.points[:, 0], time_s):
    print(f"  dullness {dullness:.2f}: {seconds / 60:.3f} min")

# What scatters from part to part.
batch = sparkout.batch(project)
for name, values in zip(batch.quantities, batch.values.T):
    print(f"  {name}: {np.nanmean(values):.2f} ± {np.nanstd(values, ddof=1):.2f}")
print(f"  good: {batch.good.mean():.0%}")
