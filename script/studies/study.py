"""Writes a study as a KML plan: folders by day, one Placemark an event, typed schemas.

A study is a table of days. What every day has (breaking camp, drives, the night) is written out
here, so that the plan itself needs nothing to be understood by.
"""

import math
import sys
from dataclasses import dataclass, field
from pathlib import Path
from xml.sax.saxutils import escape

EVENT_FIELDS = ["Enabled", "StartTime", "StartAfter", "StartWhen", "SkipWhen", "StopWhen",
                "Timeout", "OnFailure"]


@dataclass
class Frame:
    """Metres east and north of a place, as longitude and latitude on a sphere of that radius."""

    lon_deg: float
    lat_deg: float
    radius_m: float

    def place(self, east_m, north_m):
        lat_deg = self.lat_deg + math.degrees(north_m / self.radius_m)
        across_m = self.radius_m * math.cos(math.radians(self.lat_deg))
        return f"{self.lon_deg + math.degrees(east_m / across_m):.6f},{lat_deg:.6f}"


@dataclass
class PolarFrame:
    """Metres in a polar stereographic map of the south: y away from the pole along `lon_deg`, x to
    the right of that, with longitudes growing clockwise."""

    lon_deg: float
    radius_m: float

    def place(self, x_m, y_m):
        from_pole_rad = 2 * math.atan(math.hypot(x_m, y_m) / 2 / self.radius_m)
        lon_deg = self.lon_deg + math.degrees(math.atan2(x_m, y_m))
        return f"{(lon_deg + 180) % 360 - 180:.5f},{math.degrees(from_pole_rad) - 90:.6f}"


@dataclass
class Mark:
    """A Placemark: what it is, its fields, and its coordinates."""

    type: str
    name: str
    fields: dict
    at: list = field(default_factory=list)  # "lon,lat"; one is a point, more are a line
    style: str = ""


class Plan:
    def __init__(self, name, description, comment, body):
        self.name, self.description, self.comment, self.body = name, description, comment, body
        self.styles = []   # (id, element)
        self.folders = []  # (name, [Mark])
        self.sequences = {}

    def style(self, name, colour, icon_scale=None):
        """`colour`: aabbggrr, as KML has it."""
        inner = f"<LineStyle><color>{colour}</color><width>3</width></LineStyle>"
        if icon_scale:
            inner += f"<IconStyle><color>{colour}</color><scale>{icon_scale}</scale></IconStyle>"
        self.styles.append((name, inner))

    def folder(self, name):
        self.folders.append((name, []))

    def add(self, type, name="", at=(), style="", **fields):
        self.folders[-1][1].append(
            Mark(type, name, {"Type": type, **fields}, [at] if isinstance(at, str) else list(at), style))

    def event(self, rover, type, name, at=(), style="", **fields):
        """The rover's next event; Sequence numbers are multiples of ten."""
        number = self.sequences[rover] = self.sequences.get(rover, 0) + 10
        self.add(type, name, at, style, RoverId=rover, Sequence=number, **fields)

    def schemas(self):
        known = {}
        for _, marks in self.folders:
            for mark in marks:
                names = known.setdefault(mark.type, {})
                for name in mark.fields:
                    names[name] = None
                if "Sequence" in mark.fields:
                    for name in EVENT_FIELDS:
                        names[name] = None
        return known

    def text(self):
        lines = ['<?xml version="1.0" encoding="UTF-8"?>', f"<!-- {self.comment} -->",
                 f'<kml xmlns="http://www.opengis.net/kml/2.2" hint="target={self.body}">',
                 "  <Document>", f"    <name>{escape(self.name)}</name>",
                 f"    <description>{escape(self.description)}</description>"]
        for name, inner in self.styles:
            lines.append(f'    <Style id="{name}">{inner}</Style>')
        for schema, names in self.schemas().items():
            lines.append(f'    <Schema id="{schema}" name="{schema}">')
            for name in names:
                kind = "int" if name in ("Sequence", "Seed", "Crew") else "string"
                lines.append(f'      <SimpleField type="{kind}" name="{name}"/>')
            lines.append("    </Schema>")
        for name, marks in self.folders:
            lines += ["    <Folder>", f"      <name>{escape(name)}</name>"]
            for mark in marks:
                lines += self._placemark(mark)
            lines.append("    </Folder>")
        return "\n".join(lines + ["  </Document>", "</kml>"]) + "\n"

    @staticmethod
    def _placemark(mark):
        lines = ["      <Placemark>"]
        if mark.name:
            lines.append(f"        <name>{escape(mark.name)}</name>")
        if mark.style:
            lines.append(f"        <styleUrl>#{mark.style}</styleUrl>")
        lines.append(f'        <ExtendedData><SchemaData schemaUrl="#{mark.type}">')
        for name, value in mark.fields.items():
            lines.append(f'          <SimpleData name="{name}">{escape(str(value))}</SimpleData>')
        lines.append("        </SchemaData></ExtendedData>")
        if mark.at:
            shape = "Point" if len(mark.at) == 1 else "LineString"
            lines.append(f"        <{shape}><coordinates>{' '.join(mark.at)}</coordinates></{shape}>")
        lines.append("      </Placemark>")
        return lines


def main(usage, plans):
    """`plans`: a function for the text of each file, by its name; all but the first with --all."""
    if len(sys.argv) < 2:
        sys.exit(usage)
    names = list(plans) if "--all" in sys.argv[2:] else list(plans)[:1]
    for name in names:
        (Path(sys.argv[1]) / name).write_text(plans[name](), encoding="utf-8")


def utc(moment):
    return moment.strftime("%Y-%m-%dT%H:%M:%SZ")


def day_text(day, date):
    return f"Day {day}, {date.day} {date.strftime('%B')}"
