#!/usr/bin/env python3
"""Writes tests/corpus/weather: weather files as services answer, with made-up weather: good*, and bad* that
are wrong in one way each that their name says. The tests read each, and damaged copies of each. Nothing in
them is a provider's data; the forms are those of public descriptions.

    make_weather.py [FOLDER]     beside this script unless told
"""

import copy
import datetime
import json
import math
import pathlib
import sys

START = datetime.datetime(2026, 6, 21)


def even(hour, period, phase=0):
    return 0.5 + 0.5 * math.sin(2 * math.pi * (hour + phase) / period)


def day(hours, offset=2.0):
    """A warm day with showers in the afternoon, as basic-1h and clouds-1h have it."""
    times = [(START + datetime.timedelta(hours=h)).strftime("%Y-%m-%d %H:%M") for h in range(hours)]
    h = range(hours)
    wet = [max(0, even(i, 24, -9) - 0.8) * 10 for i in h]
    data = {
        "time": times,
        "temperature": [round(12 + 14 * even(i, 24, -9), 2) for i in h],
        "relativehumidity": [round(90 - 45 * even(i, 24, -9)) for i in h],
        "sealevelpressure": [round(1018 - 6 * even(i, 48), 1) for i in h],
        "windspeed": [round(1 + 5 * even(i, 24, -8), 2) for i in h],
        "winddirection": [(200 + 7 * i) % 360 for i in h],
        "precipitation": [round(w, 2) for w in wet],
        "convective_precipitation": [round(0.8 * w, 2) for w in wet],
        "snowfraction": [0.0 for i in h],
        "pictocode": [31 if w > 0 else 7 for w in wet],
        "isdaylight": [1 if 5 <= i % 24 <= 21 else 0 for i in h],
        "uvindex": [0 for i in h],
        "rainspot": ["0" * 49 for i in h],
        "totalcloudcover": [round(20 + 70 * even(i, 24, -9)) for i in h],
        "lowclouds": [round(60 * even(i, 24, -9)) for i in h],
        "midclouds": [round(50 * even(i, 36)) for i in h],
        "highclouds": [round(100 * even(i, 30)) for i in h],
        "visibility": [round(8000 + 22000 * even(i, 24, -9)) for i in h],
        "sunshinetime": [None if i == 0 else 30 for i in h],
        "fog_probability": [round(40 * even(i, 24, 3)) for i in h],
    }
    return {
        "metadata": {"modelrun_updatetime_utc": "2026-06-20 18:00", "name": "Example hill", "height": 858,
                     "timezone_abbrevation": "CEST", "latitude": 46.92, "longitude": 7.44,
                     "modelrun_utc": "2026-06-20 12:00", "utc_timeoffset": offset, "kwp": None,
                     "generation_time_ms": 1.5},
        "units": {"time": "YYYY-MM-DD hh:mm", "temperature": "C", "windspeed": "ms-1",
                  "winddirection": "degree", "precipitation": "mm", "pressure": "hPa", "cloudcover": "percent",
                  "visibility": "m", "relativehumidity": "percent"},
        "data_1h": data,
    }


CLOUDS = ["totalcloudcover", "lowclouds", "midclouds", "highclouds", "visibility", "sunshinetime",
          "fog_probability"]


def only(answer, names):
    out = copy.deepcopy(answer)
    out["data_1h"] = {k: v for k, v in out["data_1h"].items() if k == "time" or k in names}
    return out


def changed(answer, change):
    out = copy.deepcopy(answer)
    change(out)
    return out


def open_meteo(hours):
    h = range(hours)
    return {
        "latitude": 47.21, "longitude": 7.54, "generationtime_ms": 0.9, "utc_offset_seconds": 0,
        "timezone": "GMT", "timezone_abbreviation": "GMT", "elevation": 432.0,
        "hourly_units": {"time": "iso8601", "temperature_2m": "°C", "cloudcover_low": "%",
                         "cloud_cover_mid": "%", "windspeed_10m": "km/h", "wind_direction_10m": "°",
                         "precipitation": "mm", "snowfall": "cm", "visibility": "m"},
        "hourly": {
            "time": [(START + datetime.timedelta(hours=i)).strftime("%Y-%m-%dT%H:%M") for i in h],
            "temperature_2m": [-0.0 if i == 3 else round(4 * even(i, 24), 1) for i in h],
            "dewpoint_2m": [round(-2 + even(i, 24), 1) for i in h],
            "pressure_msl": [1009.4 for i in h],
            "windspeed_10m": [round(12 + 20 * even(i, 24), 1) for i in h],
            "wind_gusts_10m": [round(30 + 20 * even(i, 24), 1) for i in h],
            "wind_direction_10m": [(350 + 3 * i) % 360 for i in h],
            "precipitation": [1.4 if 6 <= i % 24 < 9 else 0.0 for i in h],
            "snowfall": [0.98 if 6 <= i % 24 < 9 else 0.0 for i in h],
            "cloudcover_low": [round(100 * even(i, 24)) for i in h],
            "cloud_cover_mid": [90 for i in h],
            "cloudcover_high": [round(60 * even(i, 15)) for i in h],
            "cloud_cover": [95 for i in h],
            "visibility": [24140.0 for i in h],
            "weathercode": [73 if 6 <= i % 24 < 9 else 3 for i in h],
            "windspeed_850hPa": [45.0 for i in h], "winddirection_850hPa": [290 for i in h],
            "wind_speed_500hPa": [80.0 for i in h], "wind_direction_500hPa": [300 for i in h],
            "windspeed_250hPa": [140.0 for i in h], "winddirection_250hPa": [310 for i in h],
            "geopotential_height_250hPa": [10310.0 for i in h],
        },
    }


METARS = """2026/06/21 12:20
METAR LSZB 211220Z AUTO 23008G20KT 190V270 9999 -SHRA FEW025TCU SCT040 BKN090AC 22/14 Q1012 NOSIG
2026/06/21 12:50
SPECI LSZB 211250Z VRB03KT 1500 R14/1200 +TSRAGR SCT020CB OVC050 16/16 Q1014 RMK LTG DSNT
METAR COR LSZB 211320Z 00000KT CAVOK M01/M05 A2992=
LSZB 211350Z /////KT //// // ////// ///// Q////
LSZB 211420Z 36010MPS 1 1/2SM BR OVC004 201/16 Q1016
LSZB 211450Z 04004KT 0200 FG VV001 08/08 Q1020 BECMG 3000
"""


def ms_of(times, offset):
    epoch = datetime.datetime(1970, 1, 1)
    return [int((datetime.datetime.strptime(t, "%Y-%m-%d %H:%M") - epoch).total_seconds() * 1000
                - offset * 3600000) for t in times]


def iso_of(times):
    return [t.replace(" ", "T") + "+02:00" for t in times]


def with_iso(a):
    a["data_1h"]["time"] = iso_of(a["data_1h"]["time"])
    a["units"]["time"] = "ISO8601"


def with_ms(a):
    a["data_1h"]["time"] = ms_of(a["data_1h"]["time"], 2)
    a["units"]["time"] = "milliseconds since 1 January 1970 00:00 UTC"


def with_points(a):
    points = ["N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"]
    for i, d in enumerate(a["data_1h"]["winddirection"]):
        if i % 2:
            a["data_1h"]["winddirection"][i] = points[round(d / 22.5) % 16]


def with_nulls(a):
    for k, (name, values) in enumerate(a["data_1h"].items()):
        if name != "time":
            values[k % len(values)] = None
            values[(2 * k + 1) % len(values)] = None


def set_of(name, index, value):
    return lambda a: a["data_1h"][name].__setitem__(index, value)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "weather"
    folder.mkdir(parents=True, exist_ok=True)
    base, meteo = day(24), open_meteo(24)
    plain = list(base["data_1h"]["time"])
    out = {
        "goodMeteoblue": base,
        "goodMeteoblueBasic": only(base, [k for k in base["data_1h"] if k not in CLOUDS]),
        "goodMeteoblueClouds": only(base, CLOUDS),
        "goodMeteoblueIso": changed(base, with_iso),
        "goodMeteoblueMilliseconds": changed(base, with_ms),
        "goodMeteoblueCompass": changed(base, with_points),
        "goodMeteoblueNulls": changed(base, with_nulls),
        "goodMeteoblueOneHour": day(1),
        "goodMeteoblueKnots": changed(base, lambda a: a["units"].update(windspeed="kn")),
        "goodOpenMeteo": meteo,
        "goodOpenMeteoUnixtime": changed(meteo, lambda a: (
            a["hourly"].update(time=[t // 1000 for t in ms_of(plain, 0)]),
            a["hourly_units"].update(time="unixtime"))),
        "badAnswerOfOpenMeteo": {"error": True, "reason": "Latitude must be in range of -90 to 90. Given: 100."},
        "badAnswerOfMeteoblue": {"error_message": "Invalid API key", "error": True},
        "badListOfPlaces": [meteo, meteo],
        "badOtherJson": {"schema": 1, "effects": []},
        "badNoData": changed(base, lambda a: a.pop("data_1h")),
        "badNoTime": changed(base, lambda a: a["data_1h"].pop("time")),
        "badEmptyTime": changed(base, lambda a: a["data_1h"].update(time=[])),
        "badLength": changed(base, lambda a: a["data_1h"]["lowclouds"].pop()),
        "badCover": changed(base, set_of("lowclouds", 17, 140)),
        "badTemperature": changed(base, set_of("temperature", 3, 900)),
        "badWindText": changed(base, set_of("winddirection", 2, "NORTH")),
        "badSpeedUnit": changed(base, lambda a: a["units"].update(windspeed="furlongs")),
        "badTimesDescend": changed(base, lambda a: a["data_1h"]["time"].reverse()),
        "badTimeMixed": changed(base, set_of("time", 5, 1780000000000)),
        "badTimeText": changed(base, set_of("time", 5, "yesterday")),
        "badOffset": changed(base, lambda a: a["metadata"].update(utc_timeoffset=99)),
        "badPictocode": changed(base, set_of("pictocode", 0, 77)),
        "badArrayIsText": changed(base, lambda a: a["data_1h"].update(lowclouds="many")),
        "badSaysNothing": only(base, []),
    }
    for name, answer in out.items():
        (folder / (name + ".json")).write_text(json.dumps(answer, ensure_ascii=False) + "\n", encoding="utf-8")
    texts = {
        "goodMetar": METARS,
        "badTwoStations": "LSZB 211220Z 23008KT CAVOK 22/14 Q1012\nLSZH 211220Z 23008KT CAVOK 22/14 Q1012\n",
        "badDay": "METAR LSZB 322500Z 23008KT CAVOK 22/14 Q1012\n",
        "badText": "It will rain in the afternoon.\n",
    }
    for name, text in texts.items():
        (folder / (name + ".txt")).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
