#!/usr/bin/env python3
"""Writes the tables that tests/unit/almanac_test.cpp, rise_and_set_test.cpp and stars_test.cpp compare the almanac with.

    make_sky_tables.py FOLDER [stars.6.json]

writes FOLDER/places.csv (sun and moon) and FOLDER/events.csv (rise, set, transit), and prints the rows of stars of
tests/unit/stars_test.cpp (the catalogue: assets/scripts/pack_stars.py). Made with Skyfield 1.55, the
ephemeris DE421 of JPL (packaged by skyfield-data 7.0.0), numpy 2.4.6 and PyEphem 4.2.1:

    pip install skyfield==1.55 skyfield-data==7.0.0 numpy==2.4.6 ephem==4.2.1

Times are UT1 (what the program takes UTC for); Skyfield's own table and prediction of delta T leads from there to
the ephemeris. Random times and places have the seed below.
"""

import csv
import json
import math
import random
import sys
from pathlib import Path

import ephem
import skyfield_data
from skyfield.api import Loader, wgs84
from skyfield.framelib import ecliptic_frame

SEED = 20260614
J2000 = 2451545.0

load = Loader(skyfield_data.get_skyfield_data_path())
timescale = load.timescale()
planets = load("de421.bsp")
earth, sun, moon = planets["earth"], planets["sun"], planets["moon"]


def text(ms):
    """Milliseconds since 1970 as ISO 8601."""
    days, rest = divmod(ms, 86400000)
    year, month, day = ephem.Date(days + 25567.5).triple()
    day = int(day + 0.5 / 86400)
    return "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ" % (
        year, month, day, rest // 3600000, rest // 60000 % 60, rest // 1000 % 60, rest % 1000)


def ut1(ms):
    return timescale.ut1_jd(ms / 86400000 + 2440587.5)


def milliseconds(iso):
    """Of "2026-06-21T12:00"."""
    date = ephem.Date(iso.replace("T", " ").replace("-", "/"))
    return round((float(date) - 25567.5) * 86400000 / 60000) * 60000


def place_rows():
    """Where sun and moon are, and what of the moon is lit."""
    random.seed(SEED)
    asked = []
    first, last = milliseconds("1950-01-01T00:00"), milliseconds("2050-12-31T23:59")
    for _ in range(1500):
        latitude = math.degrees(math.asin(random.uniform(-1, 1)))
        asked.append((random.randint(first, last), latitude, random.uniform(-180, 180)))
    for latitude in (90, -90, 0, 66.5622, -66.5622, 78.2, -77.8, 89.999):
        for _ in range(40):
            asked.append((random.randint(first, last), latitude, random.uniform(-180, 180)))
    for year in range(1950, 2051, 10):  # the equator at the equinox, every hour; the first and the last minute
        for hour in range(0, 24, 3):
            asked.append((milliseconds("%d-03-20T%02d:00" % (year, hour)), 0, 0))
    for hour in range(0, 24, 2):  # midnight sun and polar night
        asked.append((milliseconds("2026-06-21T%02d:00" % hour), 70, 25))
        asked.append((milliseconds("2026-12-21T%02d:00" % hour), 70, 25))
    asked += [(first, 51.5, 0), (last, 51.5, 0), (first, -33.9, 151.2), (last, -33.9, 151.2)]
    for ms, latitude, longitude in asked:
        time = ut1(ms)
        latitude, longitude = round(latitude, 6), round(longitude, 6)
        here = earth + wgs84.latlon(latitude, longitude)
        seen_sun, seen_moon = (here.at(time).observe(body).apparent() for body in (sun, moon))
        sun_up, sun_around, sun_far = seen_sun.altaz()
        moon_up, moon_around, moon_far = seen_moon.altaz()
        middle = earth.at(time)
        _, sun_along, _ = middle.observe(sun).apparent().frame_latlon(ecliptic_frame)
        _, moon_along, _ = middle.observe(moon).apparent().frame_latlon(ecliptic_frame)
        moon_ra, moon_dec, _ = seen_moon.radec("date")
        sun_ra, sun_dec, _ = seen_sun.radec("date")
        # Meeus, chapter 48.
        apart = sun_ra.radians - moon_ra.radians
        limb = math.atan2(
            math.cos(sun_dec.radians) * math.sin(apart),
            math.sin(sun_dec.radians) * math.cos(moon_dec.radians)
            - math.cos(sun_dec.radians) * math.sin(moon_dec.radians) * math.cos(apart))
        # The parallactic angle, from the hour angle of the moon.
        hour = math.radians(time.gast * 15 + longitude) - moon_ra.radians
        parallactic = math.atan2(
            math.sin(hour) * math.cos(math.radians(latitude)),
            math.sin(math.radians(latitude)) * math.cos(moon_dec.radians)
            - math.cos(math.radians(latitude)) * math.sin(moon_dec.radians) * math.cos(hour))
        yield [text(ms), "%.6f" % latitude, "%.6f" % longitude,
               "%.6f" % sun_around.degrees, "%.6f" % sun_up.degrees, "%.0f" % sun_far.km,
               "%.6f" % moon_around.degrees, "%.6f" % moon_up.degrees, "%.1f" % moon_far.km,
               "%.6f" % ((moon_along.degrees - sun_along.degrees) % 360),
               "%.6f" % seen_moon.fraction_illuminated(sun),
               "%.4f" % (math.degrees(limb) % 360), "%.4f" % (math.degrees(limb - parallactic) % 360)]


def event_rows():
    """The first rise, set and transit of each body in the two days after a time, empty where there is none."""
    random.seed(SEED + 1)
    first, last = milliseconds("1950-01-01T00:00"), milliseconds("2050-12-28T00:00")
    asked = [(random.randint(first, last), random.uniform(-89, 89), random.uniform(-180, 180)) for _ in range(60)]
    asked += [(milliseconds("2026-06-21T00:00"), 70, 25), (milliseconds("2026-12-21T00:00"), 70, 25),
              (milliseconds("2026-03-20T00:00"), 0, 0), (milliseconds("2026-01-10T00:00"), 68, 15),
              (milliseconds("2026-06-21T00:00"), 51.5, 0), (milliseconds("2026-12-21T00:00"), -33.9, 151.2)]
    for ms, latitude, longitude in asked:
        latitude, longitude = round(latitude, 6), round(longitude, 6)
        start = ut1(ms)
        here = earth + wgs84.latlon(latitude, longitude)
        for name, body, radius_km in (("sun", sun, 695700.0), ("moon", moon, 1737.4)):
            def height(time):
                up, _, far = here.at(time).observe(body).apparent().altaz()
                return up.degrees + [math.degrees(math.asin(radius_km / km)) for km in far.km] + 34 / 60
            def hour(time):
                ra, _, _ = here.at(time).observe(body).apparent().radec("date")
                return ((time.gast + longitude / 15 - ra.hours) + 12) % 24 - 12
            # Each ten minutes, then halved down to a tenth of a second.
            days = [start.ut1 + i / 144 for i in range(289)]
            heights, hours = height(timescale.ut1_jd(days)), hour(timescale.ut1_jd(days))

            def crossing(value, i, sign):
                low, high = days[i], days[i + 1]
                while (high - low) * 86400 > 0.1:
                    middle = (low + high) / 2
                    low, high = (middle, high) if sign * value(timescale.ut1_jd([middle]))[0] <= 0 else (low, middle)
                return ms + round((high - start.ut1) * 86400000)

            found = {}
            for i in range(288):
                a, b = heights[i], heights[i + 1]
                kind = "rise" if a <= 0 < b else "set" if a >= 0 > b else None
                if kind and kind not in found:
                    found[kind] = crossing(height, i, 1 if kind == "rise" else -1)
                if "transit" not in found and -6 < hours[i] <= 0 < hours[i + 1] < 6:
                    found["transit"] = crossing(hour, i, 1)
            yield [text(ms), "%.6f" % latitude, "%.6f" % longitude, name] + [
                text(found[kind]) if kind in found else "" for kind in ("rise", "set", "transit")] + [
                "%.4f" % min(heights), "%.4f" % max(heights)]


def star_rows(catalogue):
    """Directions of a catalogue's positions, as tests/unit/stars_test.cpp has them (no aberration, no own motion)."""
    positions = {star["id"]: star["geometry"]["coordinates"] for star in json.load(open(catalogue))["features"]}
    for utc, latitude, longitude in (("2050-07-01T03:00", -33.9, 151.2), ("1950-01-01T00:00", 60, 0)):
        turn = wgs84.latlon(latitude, longitude).rotation_at(ut1(milliseconds(utc)))
        for number in (11767, 32349, 91262, 27989, 68702):
            ra, dec = (math.radians(angle) for angle in positions[number])
            north, east, up = turn @ [math.cos(dec) * math.cos(ra), math.cos(dec) * math.sin(ra), math.sin(dec)]
            print('{%d, "%s", {%g, %g}, {%.6f, %.6f}},' % (
                number, utc, latitude, longitude, math.degrees(math.atan2(east, north)) % 360,
                math.degrees(math.asin(up))))


def write(path, head, rows):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        writer.writerows(rows)


def check_with_pyephem(path):
    """A second opinion: prints how far PyEphem is from the table of places."""
    worst = {"sun": 0, "moon": 0}
    with open(path) as file:
        for row in csv.DictReader(file):
            observer = ephem.Observer()
            observer.pressure = 0
            observer.lat, observer.lon = row["latitude"], row["longitude"]
            observer.date = row["utc"].replace("T", " ").replace("-", "/").rstrip("Z")
            for name, body in (("sun", ephem.Sun(observer)), ("moon", ephem.Moon(observer))):
                a, b = math.radians(float(row[name + "Elevation"])), float(body.alt)
                turn = math.radians(float(row[name + "Azimuth"])) - float(body.az)
                apart = math.hypot(a - b, math.cos(a) * math.sin(turn))
                worst[name] = max(worst[name], math.degrees(apart))
    print("PyEphem is at most %(sun).4f (sun) and %(moon).4f (moon) degrees away" % worst)


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    write(folder / "places.csv",
          ["utc", "latitude", "longitude", "sunAzimuth", "sunElevation", "sunKm", "moonAzimuth", "moonElevation",
           "moonKm", "phaseDegrees", "illuminated", "brightLimb", "brightLimbTilt"], place_rows())
    write(folder / "events.csv",
          ["utc", "latitude", "longitude", "body", "rise", "set", "transit", "lowest", "highest"], event_rows())
    check_with_pyephem(folder / "places.csv")
    if len(sys.argv) > 2:
        star_rows(sys.argv[2])


if __name__ == "__main__":
    main()
