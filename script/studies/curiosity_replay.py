#!/usr/bin/env python3
"""Writes curiosity_replay.kml and its terrain: MSL drives where Curiosity stood, on the HiRISE ground of Gale crater.

    script/studies/curiosity_replay.py FOLDER [DATA]

DATA is the folder of reference data, by default that of LSOS_REFERENCE_DATA. It holds Curiosity's
localisations, traverses/MSL_Waypoints_sol3_1782.csv, and an elevation model of 1 m, on which those
of sols 960 to 1073 lie. Each drive begins when Curiosity's did and ends where Curiosity's did; the
way between is planned, as the localisations do not tell it.
"""

import csv
import math
import os
import sys
from datetime import datetime, timedelta
from pathlib import Path

from study import Plan, utc

RADIUS_M = 3_396_190  # eastings and northings are longitudes and latitudes times that
FIRST_SOL, LAST_SOL = 960, 1073
TRAVERSE = "traverses/MSL_Waypoints_sol3_1782.csv"
GROUND = "dem/mars/gale_hirise_1m_missionDEM.tif"
# The spacecraft's clock counts seconds, leap seconds among them, from here.
CLOCK_ZERO, LEAP_SECONDS = datetime(2000, 1, 1, 11, 58, 56), timedelta(seconds=3)


def place(row):
    lon_deg = math.degrees(float(row["easting_m"]) / RADIUS_M)
    lat_deg = math.degrees(float(row["northing_m"]) / RADIUS_M)
    return f"{lon_deg:.8f},{lat_deg:.8f}"


def moment(row):
    return CLOCK_ZERO + timedelta(seconds=float(row["SCLK_START"])) - LEAP_SECONDS


# The soil of the place is not known from orbit. Curiosity climbed 16 degrees here, for the most part
# on bedrock, which is more than a wheel can on the soil that is assumed on Mars.
TERRAIN_SCRIPT = """-- Gale crater on sols 960 to 1073, taken for bedrock.
local lsos = require 'lsos'

return lsos.terrain {{
  api     = 1,
  doc     = 'Gale crater at 1 m by HiRISE, taken for bedrock.',
  surface = lsos.raster {{ file = '{file}' }},
  soil    = 'Rock',
}}
"""


def curiosity_replay(data):
    with open(data / TRAVERSE, encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if FIRST_SOL <= int(row["sol"]) <= LAST_SOL]
    first, drives = rows[0], rows[1:]
    plan = Plan("Curiosity, sols 960 to 1073", "MSL at the positions of Curiosity in Gale crater.",
                "Made by script/studies/curiosity_replay.py from Curiosity's localisations.", "mars")
    plan.style("drive", "ff2020d0")
    plan.folder("Mission")
    plan.add("MissionInfo", Planet="Mars", StartTime=utc(moment(drives[0])),
             Terrain="GaleRock", LogInterval="10 s", ParkedLogInterval="1 h")
    plan.add("Rover", "Curiosity", place(first), RoverId="MSL", RoverType="MSL",
             Heading=f"{float(first['yaw_deg']) % 360:.3f} deg")
    plan.folder("Drives")
    for row in drives:
        own_m = float(row["mobtrav_id"])
        plan.event("MSL", "PathPlanRoute", f"Sol {row['sol']}, Curiosity drove {own_m:.1f} m",
                   place(row), "drive", StartTime=utc(moment(row)), ArrivalRadius="0.3 m",
                   OnFailure="skip")
    return plan.text()


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = Path(sys.argv[2] if len(sys.argv) == 3 else os.environ.get("LSOS_REFERENCE_DATA", ""))
    for needed in (TRAVERSE, GROUND):
        if not (folder / needed).is_file():
            sys.exit(f"{folder / needed} is missing: DATA is the folder of reference data")
    out = Path(sys.argv[1])
    (out / "terrain").mkdir(parents=True, exist_ok=True)
    script = TERRAIN_SCRIPT.format(file=(folder / GROUND).resolve())
    (out / "terrain" / "GaleRock.lua").write_text(script, encoding="utf-8")
    (out / "curiosity_replay.kml").write_text(curiosity_replay(folder), encoding="utf-8")
