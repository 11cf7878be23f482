#!/usr/bin/env python3
"""Draws a run from its log.gpkg: the drawn and the driven line, elevation, speed and slip.

    docs/plot_run.py RUN-FOLDER PICTURE.png

Also an example of reading the log: a GeoPackage is an SQLite file with plain tables.
"""
import math
import sqlite3
import sys
import xml.etree.ElementTree as ElementTree

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)


def samples(folder):
    log = sqlite3.connect(f"file:{folder}/log.gpkg?mode=ro", uri=True)
    log.row_factory = sqlite3.Row
    rows = {}
    for row in log.execute("SELECT * FROM samples ORDER BY fid"):
        rows.setdefault(row["rover_id"], []).append(row)
    events = log.execute("SELECT * FROM events WHERE start_s IS NOT NULL").fetchall()
    return rows, events


def drawn_lines(folder):
    for element in ElementTree.parse(f"{folder}/plan.kml").iter():
        if element.tag.endswith("LineString"):
            text = next(c.text for c in element if c.tag.endswith("coordinates"))
            yield [tuple(map(float, point.split(",")[:2])) for point in text.split()]


def main(folder, picture):
    rovers, events = samples(folder)
    first = next(iter(rovers.values()))[0]
    # Degrees of the plan to metres about the first sample, by the log's own two systems.
    far = max((r for rows in rovers.values() for r in rows), key=lambda r: abs(r["y_m"]))
    m_per_lat = (far["y_m"] - first["y_m"]) / (far["lat_deg"] - first["lat_deg"])
    m_per_lon = m_per_lat * math.cos(math.radians(first["lat_deg"]))

    figure = plt.figure(figsize=(11, 5.2), layout="constrained")
    grid = figure.add_gridspec(3, 2, width_ratios=[1.15, 1])
    plan = figure.add_subplot(grid[:, 0], aspect="equal")
    height, speed, slip = (figure.add_subplot(grid[i, 1]) for i in range(3))
    for line in drawn_lines(folder):
        plan.plot([(lon - first["lon_deg"]) * m_per_lon for lon, _ in line],
                  [(lat - first["lat_deg"]) * m_per_lat for _, lat in line],
                  color="goldenrod", marker="o", markersize=4, linewidth=4, alpha=0.5, label="drawn")
    for rover, rows in rovers.items():
        minutes = [row["time_s"] / 60 for row in rows]
        plan.plot([r["x_m"] for r in rows], [r["y_m"] for r in rows], linewidth=1.2, color="firebrick",
                  label=f"{rover} driven")
        height.plot(minutes, [r["elevation_m"] - rows[0]["elevation_m"] for r in rows], color="firebrick")
        speed.plot(minutes, [r["speed_mps"] * 3.6 for r in rows], color="firebrick")
        slip.plot(minutes, [100 * r["slip"] if r["slip"] is not None else None for r in rows],
                  color="firebrick", linewidth=0.8)
    for axes in (height, speed, slip):
        for i, event in enumerate(events):
            if event["end_s"] is not None:
                axes.axvspan(event["start_s"] / 60, event["end_s"] / 60, alpha=0.08 + 0.1 * (i % 2),
                             color="gray", linewidth=0)
        axes.margins(x=0)
    for event in events:
        height.text(event["start_s"] / 60, 1.02, event["label"], fontsize=7, rotation=20,
                    transform=height.get_xaxis_transform())
    plan.set(xlabel="east, m", ylabel="north, m")
    handles, labels = plan.get_legend_handles_labels()
    unique = dict(zip(labels, handles))
    plan.legend(unique.values(), unique.keys(), loc="best", fontsize=8)
    height.set(ylabel="elevation, m")
    speed.set(ylabel="speed, km/h")
    slip.set(ylabel="slip, %", xlabel="time, min", ylim=(-20, 60))
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
