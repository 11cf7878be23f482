#!/usr/bin/env python3
"""Writes a study of four weeks of two SEVs and an ATHLETE on the rim of Shackleton, or one day.

    script/studies/lunar_campaign.py FOLDER          lunar_campaign_day.kml
    script/studies/lunar_campaign.py FOLDER --all    lunar_campaign.kml too, all 28 days

The habitat stands where the Sun hardly ever sets. Each SEV drives the better part of an hour a day,
with EVAs and samples between its legs, and camps with its panel after the Sun and its mast up;
ATHLETE drives a third of that, near the habitat, and lies down for the night. The SEVs meet at the
habitat every seventh day. The stops are made up; the camps lie where the Sun shines that night, and
some where it does not.
"""

from datetime import datetime, timedelta

from study import Plan, PolarFrame, day_text, main, utc

START = datetime(2027, 1, 1, 6, 0)
FRAME = PolarFrame(57.5, 1_737_400)
HABITAT = (-920, 4660)

# Where a cable of the habitat reaches the SEVs.
HOME = {"SEV_A": (-924, 4677), "SEV_B": (-920, 4643)}

# Four stops a day, in metres of the frame: where the crew works outside ("eva", "survey": a short
# one), where samples are taken, and the camp. From day 4 to 15 the Sun is behind the ridge for all
# but the top of the rim: the SEVs then camp at the habitat but for a night in the dark, and go far
# when it shines on the slopes.
DAYS = {
    "SEV_A": [
        [(-1910, 5820), (-1940, 7330), (-2940, 8090), (-2500, 7100)],
        [(-3630, 7380), (-3180, 6600), (-4050, 6620), (-2900, 5900)],
        [(-3600, 5290), (-3690, 4660), (-2800, 3000), (-2150, 3400)],
        [(-1650, 3260), (-2270, 3960), (-1930, 4900), HOME["SEV_A"]],
        [(-1740, 5880), (-2270, 6210), (-1540, 5390), HOME["SEV_A"]],
        [(-1650, 3260), (-2150, 3400), (-1500, 4200), HOME["SEV_A"]],
        [(-2120, 4420), (-2580, 4700), (-1930, 4900), HOME["SEV_A"]],
        [(-1500, 5100), (-1850, 6470), (-1740, 5880), (-1540, 5390)],
        [(-2030, 5610), (-1840, 6030), (-1500, 5100), HOME["SEV_A"]],
        [(-1800, 4120), (-2700, 3400), (-2270, 3960), HOME["SEV_A"]],
        [(-1910, 5820), (-1850, 6470), (-1500, 5100), HOME["SEV_A"]],
        [(-1930, 4900), (-2720, 5230), (-1800, 4120), HOME["SEV_A"]],
        [(-1600, 4100), (-1650, 3260), (-2150, 3400), (-1500, 4200)],
        [(-2120, 4420), (-2780, 4160), (-2270, 3960), HOME["SEV_A"]],
        [(-2030, 5610), (-2270, 6210), (-1850, 6470), HOME["SEV_A"]],
        [(-1940, 7330), (-2650, 7090), (-2520, 6420), (-2300, 6800)],
        [(-2050, 8430), (-2050, 9350), (-3020, 9330), (-3100, 9900)],
        [(-4230, 8790), (-4870, 8320), (-3940, 8280), (-3630, 7380)],
        [(-3180, 6600), (-4050, 6620), (-5130, 6150), (-3610, 5130)],
        [(-3340, 4800), (-2270, 3960), (-2800, 3000), (-2150, 3400)],
        [(-1650, 3260), (-1800, 4120), (-1930, 4900), HOME["SEV_A"]],
        [(-2120, 4420), (-3000, 3600), (-3870, 2820), (-5540, 3530)],
        [(-6000, 4000), (-3970, 4620), (-3680, 4610), (-5300, 4760)],
        [(-5610, 5680), (-4750, 6340), (-5450, 7410), (-6000, 8150)],
        [(-5280, 8690), (-5750, 9520), (-3880, 9920), (-3480, 9710)],
        [(-2800, 8980), (-1750, 8550), (-2190, 8620), (-3560, 7240)],
        [(-2500, 6400), (-3600, 5900), (-3020, 4950), (-1930, 4900)],
        [(-2780, 4160), (-2150, 3400), (-1600, 4100), HOME["SEV_A"]],
    ],
    "SEV_B": [
        [(-1800, 4120), (-2700, 3400), (-3790, 2820), (-2800, 3000)],
        [(-5720, 3260), (-6500, 4000), (-5830, 5030), (-5300, 4760)],
        [(-3970, 4620), (-2580, 4700), (-2030, 5610), (-2720, 5230)],
        [(-3600, 5290), (-2920, 4000), (-2120, 4420), HOME["SEV_B"]],
        [(-1800, 4120), (-2390, 3020), (-1650, 3260), HOME["SEV_B"]],
        [(-1740, 5880), (-1850, 6470), (-1500, 5100), HOME["SEV_B"]],
        [(-1930, 4900), (-2030, 5610), (-1540, 5390), HOME["SEV_B"]],
        [(-1600, 4100), (-2270, 3960), (-1800, 4120), (-1500, 4200)],
        [(-1650, 3260), (-2150, 3400), (-2120, 4420), HOME["SEV_B"]],
        [(-1740, 5880), (-2270, 6210), (-1910, 5820), HOME["SEV_B"]],
        [(-2120, 4420), (-2700, 3400), (-1800, 4120), HOME["SEV_B"]],
        [(-1740, 5880), (-1840, 6030), (-1500, 5100), HOME["SEV_B"]],
        [(-1930, 4900), (-2580, 4700), (-2030, 5610), (-1540, 5390)],
        [(-1740, 5880), (-2270, 6210), (-1840, 6030), HOME["SEV_B"]],
        [(-1800, 4120), (-2150, 3400), (-1650, 3260), HOME["SEV_B"]],
        [(-2120, 4420), (-3000, 3600), (-2580, 4700), (-2920, 4000)],
        [(-3970, 4620), (-5300, 4760), (-5830, 5030), (-5480, 6350)],
        [(-4940, 6960), (-5490, 7450), (-6500, 7810), (-5060, 8500)],
        [(-4010, 8730), (-3020, 9330), (-2050, 8430), (-1830, 7550)],
        [(-2500, 7100), (-3510, 6240), (-4720, 6250), (-3600, 5290)],
        [(-2800, 5570), (-1930, 4900), (-1500, 4200), HOME["SEV_B"]],
        [(-1740, 5880), (-2300, 6800), (-3210, 7770), (-4390, 7610)],
        [(-5200, 7900), (-6500, 7810), (-5480, 6350), (-4460, 6750)],
        [(-3220, 6560), (-2900, 5900), (-3820, 5900), (-5370, 5730)],
        [(-5300, 4760), (-6260, 3900), (-5550, 3570), (-3870, 2820)],
        [(-3300, 2760), (-2390, 3020), (-1790, 4030), (-2920, 4000)],
        [(-3690, 4660), (-2720, 5230), (-1840, 6030), (-2650, 7090)],
        [(-1850, 6470), (-1740, 5880), (-1500, 5100), HOME["SEV_B"]],
    ],
}
MEETINGS = (7, 14, 21, 28)

# ATHLETE goes round the habitat, a place a day.
ATHLETE = [(-1200, 4480), (-1500, 4150), (-1100, 3850), (-1180, 4350), (-1570, 4570),
           (-1260, 4850), (-1550, 5320), (-1145, 5470), (-1190, 4870), (-1650, 4875),
           (-1350, 4450), (-1710, 4680), (-1380, 4650), (-960, 4660)]


def to(plan, rover, name, place_m, radius_m=10):
    # A SEV climbs 21 degrees, and the walls of small craters are as steep.
    limits = {} if rover == "ATHLETE" else {"MaxSlope": "16 deg"}
    plan.event(rover, "PathPlanRoute", f"To {name}", FRAME.place(*place_m), "drive" + rover,
               ArrivalRadius=f"{radius_m} m", OnFailure="skip", **limits)


def make_camp(plan, rover, name):
    plan.event(rover, "DeploySP", f"Panel up, {name}")
    plan.event(rover, "SteerSP", f"Panel after the Sun, {name}", Mode="track")
    plan.event(rover, "DeployCA", f"Mast up, {name}")


def add_sev_day(plan, rover, day, is_first, camp_of_other=None):
    """Returns the number of the drive to the camp. `camp_of_other`: that of the rover to meet."""
    short = f"{rover[-1]}{day}"
    morning = START + timedelta(days=day - 1, hours=1)
    plan.event(rover, "StowSP", f"{short} Panel down", StartTime=utc(morning))
    if not is_first:  # masts are down at the start
        plan.event(rover, "StowCA", f"{short} Mast down")
    out_m, samples_m, survey_m, camp_m = DAYS[rover][day - 1]
    to(plan, rover, f"{short} site", out_m)
    plan.event(rover, "EVA", f"{short} EVA", ActivityDuration="2 h", Crew=2, Power="200 W")
    to(plan, rover, f"{short} samples", samples_m)
    plan.event(rover, "Sample", f"{short} samples", Duration="30 min")
    to(plan, rover, f"{short} survey", survey_m)
    plan.event(rover, "EVA", f"{short} Short EVA", ActivityDuration="30 min", Crew=1)
    if day in MEETINGS and rover == "SEV_B":
        plan.event(rover, "Rendezvous", f"Meeting, day {day}", With="SEV_A", Distance="60 m",
                   StartAfter=f"SEV_A/{camp_of_other}", Timeout="6 h", OnFailure="skip")
    is_home = camp_m == HOME[rover]
    to(plan, rover, f"{short} camp", camp_m, 2 if is_home else 10)
    camp = plan.sequences[rover]
    make_camp(plan, rover, f"{short} camp")
    if is_home:
        plan.event(rover, "Recharge", f"{short} from the habitat", From="Habitat",
                   EnergyRate="2.5 kW", UntilCharge="95 %", Duration="8 h", OnFailure="skip")
    return camp


def add_athlete_day(plan, day, is_first):
    if is_first:
        plan.event("ATHLETE", "SteerSP", f"T{day} Panel after the Sun", Mode="track")
    plan.event("ATHLETE", "SetPosture", f"T{day} Stand up", Stance="Drive",
               StartTime=utc(START + timedelta(days=day - 1, hours=2)))
    to(plan, "ATHLETE", f"T{day}", ATHLETE[(day - 1) % len(ATHLETE)])
    plan.event("ATHLETE", "SetPosture", f"T{day} Lie down", Stance="Stow")


def lunar_campaign(days):
    name = "Lunar campaign" if len(days) > 1 else "A day of the lunar campaign"
    plan = Plan(name, "Two SEVs and an ATHLETE on the rim of Shackleton, near the Moon's south pole.",
                "Made by script/studies/lunar_campaign.py from a table of stops. The stops are made up.",
                "moon")
    for rover, colour in (("SEV_A", "ff2020d0"), ("SEV_B", "ffd05020"), ("ATHLETE", "ff20a020")):
        plan.style("drive" + rover, colour)
    plan.folder("Mission")
    plan.add("MissionInfo", Planet="Moon", StartTime=utc(START + timedelta(days=days[0] - 1)),
             Terrain="LunarSouthPole", Seed=28, LogInterval="10 s", ParkedLogInterval="10 min")
    plan.add("Asset", "Habitat", FRAME.place(*HABITAT), AssetId="Habitat", AssetType="Habitat")
    for rover, place_m in (*HOME.items(), ("ATHLETE", (-960, 4660))):
        plan.add("Rover", rover.replace("_", " "), FRAME.place(*place_m), RoverId=rover,
                 RoverType=rover[:3] if rover != "ATHLETE" else rover, InitialCharge="95 %",
                 **({"RoverConfig": "Stow"} if rover == "ATHLETE" else {}))
    for day in days:
        plan.folder(day_text(day, START + timedelta(days=day - 1)))
        camp_of_a = add_sev_day(plan, "SEV_A", day, day == days[0])
        add_sev_day(plan, "SEV_B", day, day == days[0], camp_of_a)
        add_athlete_day(plan, day, day == days[0])
    return plan.text()


if __name__ == "__main__":
    main(__doc__, {"lunar_campaign_day.kml": lambda: lunar_campaign([1]), "lunar_campaign.kml": lambda: lunar_campaign(range(1, 29))})
