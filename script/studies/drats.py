#!/usr/bin/env python3
"""Writes a study of two weeks of two SEVs at Black Point, or its first day alone.

    script/studies/drats.py FOLDER          drats_day.kml, as it ships in plans/
    script/studies/drats.py FOLDER --all    drats.kml too, all fourteen days

Two pressurised rovers leave the same place on 31 August 2010; A works above the ridge, B below it.
Each drives several kilometres a day over planned routes, with stops for EVAs, long and short
("survey"), and samples; masts are deployed for EVAs and nights and stowed to drive; they meet on
the seventh and on the last day. The stops are made up.
"""

from datetime import datetime, timedelta

from study import Frame, Plan, day_text, main, utc

START = datetime(2010, 8, 31, 15, 0)  # 08:00 in Arizona, UTC-7
FRAME = Frame(-111.466, 35.690, 6_371_000)

# Three stops a day, in metres east and north of the base, and what is done there; the last one is
# the camp. The rovers meet at the base on the seventh and on the last day.
DAYS = {
    "A": [
        [(460, 1170, "eva"), (1170, 2210, "sample"), (1690, 3250, "survey")],
        [(2600, 3770, "sample"), (3510, 3380, "survey"), (4160, 2600, "eva")],
        [(4680, 1690, "survey"), (4290, 780, "eva"), (3770, -130, "sample")],
        [(3250, 650, "eva"), (2470, 460, "sample"), (1690, 910, "survey")],
        [(2210, 1950, "sample"), (2990, 2340, "survey"), (3380, 3120, "eva")],
        [(2470, 2860, "survey"), (1560, 2470, "eva"), (780, 1950, "sample")],
        [(260, 1300, "eva"), (-390, 780, "sample"), (30, 25, "survey")],
        [(-780, 910, "sample"), (-1560, 1560, "survey"), (-1950, 2470, "eva")],
        [(-1170, 3120, "survey"), (-260, 3640, "eva"), (650, 3900, "sample")],
        [(1560, 4290, "eva"), (2340, 4810, "sample"), (3250, 4550, "survey")],
        [(3900, 3900, "sample"), (4420, 3120, "survey"), (4810, 2210, "eva")],
        [(4030, 1560, "survey"), (3380, 1040, "eva"), (2470, 1170, "sample")],
        [(1950, 390, "eva"), (1300, 1040, "sample"), (780, 780, "survey")],
        [(390, 390, "sample"), (130, 200, "survey"), (30, 25, "eva")],
    ],
    "B": [
        [(390, -1040, "eva"), (650, -2210, "sample"), (390, -3380, "survey")],
        [(1170, -3900, "sample"), (2080, -3770, "survey"), (2860, -3250, "eva")],
        [(3510, -2470, "survey"), (3770, -1560, "eva"), (3120, -910, "sample")],
        [(2340, -1300, "eva"), (1560, -1690, "sample"), (780, -1560, "survey")],
        [(0, -1950, "sample"), (-780, -2470, "survey"), (-1560, -2860, "eva")],
        [(-2210, -2210, "survey"), (-1950, -1300, "eva"), (-1300, -650, "sample")],
        [(-780, -390, "eva"), (-390, -650, "sample"), (-30, -25, "survey")],
        [(-910, -910, "sample"), (-1690, -1300, "survey"), (-2600, -1430, "eva")],
        [(-3250, -2210, "survey"), (-3510, -3120, "eva"), (-3120, -4030, "sample")],
        [(-2340, -4550, "eva"), (-1430, -4810, "sample"), (-520, -4550, "survey")],
        [(390, -4290, "sample"), (1170, -4680, "survey"), (2080, -4550, "eva")],
        [(2860, -4160, "survey"), (3250, -3380, "eva"), (2730, -2600, "sample")],
        [(1950, -2210, "eva"), (1300, -1430, "sample"), (910, -780, "survey")],
        [(520, -520, "sample"), (200, -260, "survey"), (-30, -25, "eva")],
    ],
}

MEETINGS = (7, 14)
WORK = {
    "eva": ("EVA", "EVA", {"ActivityDuration": "150 min", "Crew": 2}),
    "sample": ("Sample", "Sample", {"Duration": "40 min"}),
    "survey": ("EVA", "Short EVA", {"ActivityDuration": "1 h", "Crew": 1}),
}


def add_day(plan, rover, day, stops, is_first):
    if not is_first:  # masts are stowed at the start
        morning = START + timedelta(days=day - 1)
        plan.event(rover, "StowCA", f"{rover}{day} Break camp", StartTime=utc(morning))
    for number, (east_m, north_m, work) in enumerate(stops, 1):
        is_camp = number == len(stops)
        stop = f"{rover}{day} camp" if is_camp else f"{rover}{day} stop {number}"
        plan.event(rover, "PathPlanRoute", f"To {stop}", FRAME.place(east_m, north_m), "drive" + rover,
                   ArrivalRadius="5 m", OnFailure="skip")
        if is_camp and day in MEETINGS:
            continue
        schema, name, fields = WORK[work]
        if schema == "EVA":
            plan.event(rover, "DeployCA", f"Mast up, {stop}")
        plan.event(rover, schema, f"{name}, {stop}", **fields)
        if schema == "EVA" and not is_camp:
            plan.event(rover, "StowCA", f"Mast down, {stop}")
        if number == 1:
            plan.event(rover, "Pause", f"Lunch, day {day}", Duration="1 h")


def add_night(plan, rover, day, stops):
    if WORK[stops[-1][2]][0] != "EVA" or day in MEETINGS:
        plan.event(rover, "DeployCA", f"Mast up for night {day}")
    evening = START + timedelta(days=day - 1, hours=10)  # 18:00 in Arizona
    plan.event(rover, "Recharge", f"Night {day}: from the support trailer", StartTime=utc(evening),
               EnergyRate="3 kW", Duration="12 h", OnFailure="skip")


def drats(days):
    name = "DRATS" if len(days) > 1 else "A day of DRATS"
    plan = Plan(name, "Two SEVs at Black Point, Arizona, on the model of the field test of 2010: A "
                "above the ridge, B below it.",
                "Made by script/studies/drats.py from a table of stops. The stops are made up.",
                "earth")
    plan.style("driveA", "ff2020d0")
    plan.style("driveB", "ffd05020")
    plan.folder("Mission")
    plan.add("MissionInfo", Planet="Earth", StartTime=utc(START + timedelta(days=days[0] - 1)),
             Terrain="BlackPoint", Seed=2010, LogInterval="10 s", ParkedLogInterval="10 min")
    plan.add("Asset", "Base", FRAME.place(0, 0), AssetId="Base", AssetType="CommStation",
             Height="10 m")
    for rover, north_m in (("A", 15), ("B", -15)):
        plan.add("Rover", f"SEV {rover}", FRAME.place(30, north_m), RoverId=rover, RoverType="SEV",
                 InitialCharge="95 %")
    for day in days:
        plan.folder(day_text(day, START + timedelta(days=day - 1)))
        for rover in "AB":
            add_day(plan, rover, day, DAYS[rover][day - 1], day == days[0])
        if day in MEETINGS:
            plan.event("B", "Rendezvous", f"Meeting, day {day}", With="A", Distance="40 m",
                       StartAfter=f"A/{plan.sequences['A']}")
        for rover in "AB":
            add_night(plan, rover, day, DAYS[rover][day - 1])
    return plan.text()


if __name__ == "__main__":
    main(__doc__, {"drats_day.kml": lambda: drats([1]), "drats.kml": lambda: drats(range(1, 15))})
