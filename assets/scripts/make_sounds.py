"""The game's sounds. Writes one WAV file each (16 bit, mono, 22050 Hz) into the folder given.

    python3 make_sounds.py ../audio

Every sample is rounded to 16 bits from a signal that is designed, not recorded; the noise comes from one seed.
"""

import argparse
import pathlib
import struct

import numpy as np

RATE = 22050
SEED = 20260102


def seconds(duration):
    return np.arange(int(round(duration * RATE))) / RATE


def noise(rng, count):
    return rng.uniform(-1, 1, count)


def low_pass(signal, hertz):
    """One pole, run twice: 12 dB an octave."""
    a = 1 - np.exp(-2 * np.pi * hertz / RATE)
    for _ in range(2):
        out, state = np.empty_like(signal), 0.0
        for i, x in enumerate(signal):
            state += a * (x - state)
            out[i] = state
        signal = out
    return signal


def envelope(t, attack, decay):
    return np.minimum(t / attack, 1) * np.exp(-np.maximum(t - attack, 0) / decay)


def faded(signal, duration=0.01):
    """No click at either end."""
    n = int(duration * RATE)
    ramp = 0.5 - 0.5 * np.cos(np.pi * np.arange(n) / n)
    signal = signal.copy()
    signal[:n] *= ramp
    signal[-n:] *= ramp[::-1]
    return signal


def chime(t, notes, step, decay):
    out = np.zeros_like(t)
    for k, hertz in enumerate(notes):
        local = t - k * step
        on = local >= 0
        for partial, gain in ((1, 1.0), (2, .35), (3, .12)):
            out[on] += gain * np.sin(2 * np.pi * hertz * partial * local[on]) * np.exp(-local[on] * partial / decay)
    return out


def engine(rng):
    """A loop of whole periods: a six-cylinder at 2400/min fires 120 times a second; one turn is 40 Hz."""
    duration = 1.0  # whole periods of every partial below
    t = seconds(duration)
    out = np.zeros_like(t)
    for k in range(1, 40):
        hertz = 40 * k
        firing = 1.0 if k % 3 == 0 else 0.32
        out += firing / k**0.9 * np.cos(2 * np.pi * hertz * t + rng.uniform(0, 2 * np.pi))
    # Breath of the propeller: noise made periodic in the frequency domain, beating with the blades (80 Hz).
    spectrum = np.fft.rfft(noise(rng, len(t)))
    f = np.fft.rfftfreq(len(t), 1 / RATE)
    breath = np.fft.irfft(spectrum * np.exp(-((f - 420) / 380) ** 2), len(t))
    breath /= np.abs(breath).max()
    return out / np.abs(out).max() + 0.35 * breath * (1 + 0.6 * np.cos(2 * np.pi * 80 * t))


def drop(rng):
    t = seconds(.45)
    latch = noise(rng, len(t)) * envelope(t, .001, .012)
    whoosh = low_pass(noise(rng, len(t)), 900) * envelope(t, .12, .12)
    return faded(latch * .6 + whoosh * 4, .003)


def parachute(rng):
    t = seconds(.9)
    flap = low_pass(noise(rng, len(t)), 1400) * (1 + .8 * np.sin(2 * np.pi * 23 * t)) * envelope(t, .02, .22)
    snap = low_pass(noise(rng, len(t)), 260) * envelope(np.maximum(t - .28, 0), .004, .07) * (t > .28)
    return faded(flap * 2 + snap * 9, .003)


def landing(rng):
    t = seconds(.5)
    thud = np.sin(2 * np.pi * (70 * t - 40 * t * t)) * envelope(t, .004, .09)
    return faded(thud + low_pass(noise(rng, len(t)), 500) * envelope(t, .002, .05) * 2.5, .003)


def splash(rng):
    t = seconds(1.1)
    return faded(low_pass(noise(rng, len(t)), 2600) * envelope(t, .015, .25) *
                 (1 + .3 * np.sin(2 * np.pi * 9 * t)), .003)


def score(rng):
    return faded(chime(seconds(1.4), (659.25, 783.99, 1046.5), .12, .35), .003)


def miss(rng):
    return faded(chime(seconds(.9), (311.13, 233.08), .17, .25), .003)


def crash(rng):
    t = seconds(1.6)
    boom = low_pass(noise(rng, len(t)), 180) * envelope(t, .005, .35) * 9
    debris = low_pass(noise(rng, len(t)), 3200) * envelope(t, .002, .12) * 1.5
    ring = sum(np.sin(2 * np.pi * h * t) * np.exp(-t / .18) for h in (523, 871, 1373)) * .12
    return faded(boom + debris + ring, .003)


def stall(rng):
    """A loop of whole periods: the reed of a stall horn, a buzz of 400 Hz and its odd partials, a little rough."""
    t = seconds(.5)
    reed = sum(np.cos(2 * np.pi * 400 * k * t + k) / k for k in (1, 2, 3, 5, 7, 9))
    return reed * (1 + .25 * np.cos(2 * np.pi * 36 * t))


def periodic(rng, t, shape):
    """Noise that ends where it begins: shaped in the frequency domain."""
    spectrum = np.fft.rfft(noise(rng, len(t)))
    out = np.fft.irfft(spectrum * shape(np.fft.rfftfreq(len(t), 1 / RATE)), len(t))
    return out / np.abs(out).max()


def rain(rng):
    """A loop: drops on a canopy, short ticks of all strengths over a hiss."""
    t = seconds(2)
    ticks = np.zeros_like(t)
    tick = np.exp(-seconds(.012) / .0022) * np.sin(2 * np.pi * 2300 * seconds(.012))
    for _ in range(900):
        start = int(rng.integers(len(t)))
        ticks[(start + np.arange(len(tick))) % len(t)] += rng.uniform(.05, 1)**3 * tick * rng.choice((-1, 1))
    hiss = periodic(rng, t, lambda f: np.exp(-((f - 3600) / 2600)**2) + .5 * np.exp(-((f - 700) / 500)**2))
    return .55 * ticks / np.abs(ticks).max() + .6 * hiss


def wind(rng):
    """A loop of air that streams past, a little stronger and weaker in whole periods."""
    t = seconds(3)
    low = periodic(rng, t, lambda f: f / 90 * np.exp(-f / 170))
    high = periodic(rng, t, lambda f: np.exp(-((f - 900) / 420)**2))
    return low * (1 + .25 * np.sin(2 * np.pi * t / 1.5)) + .3 * high * (1 + .5 * np.sin(2 * np.pi * t / 3 + 1))


def thunder(duration, crack, body_hertz, rolls):
    """A clap of thunder: this share of a crack of high noise, a body of low noise, and so many rolls after it."""
    def make(rng):
        t = seconds(duration)
        out = low_pass(noise(rng, len(t)), 3000) * envelope(t, .002, .06) * 2 * crack
        out += low_pass(noise(rng, len(t)), body_hertz) * envelope(t, .01 + .2 * (1 - crack), duration / 5) * 6
        for _ in range(rolls):
            start = rng.uniform(.1, .6 * duration)
            local = np.maximum(t - start, 0)
            out += low_pass(noise(rng, len(t)), body_hertz * rng.uniform(.5, 1)) * \
                envelope(local, .05, duration / 9) * (t > start) * 6 * rng.uniform(.3, .9)
        return faded(out, .05)
    return make


def touchdown(rng):
    """A tyre that is spun up on turf: a bump, a short chirp and what rolls on."""
    t = seconds(.7)
    bump = np.sin(2 * np.pi * (85 * t - 45 * t * t)) * envelope(t, .004, .07)
    chirp = low_pass(noise(rng, len(t)), 2400) * envelope(t, .002, .05) * 2
    roll = low_pass(noise(rng, len(t)), 260) * envelope(t, .05, .25) * 3
    return faded(bump + chirp + roll, .003)


def applause(rng):
    """A small crowd: each of its hands claps at a pace of its own, and they stop one after the other."""
    t = seconds(3)
    out = np.zeros_like(t)
    clap_t = seconds(.03)
    for _ in range(24):
        pace, at, last = rng.uniform(.19, .3), rng.uniform(.05, .5), rng.uniform(1.6, 2.7)
        # A palm is a short burst with a tone of its own, between 700 and 1900 Hz.
        palm = noise(rng, len(clap_t)) * np.exp(-clap_t / .006)
        palm += .8 * np.sin(2 * np.pi * rng.uniform(700, 1900) * clap_t) * np.exp(-clap_t / .004)
        loud = rng.uniform(.3, 1)
        while at < last:
            start = int(at * RATE)
            out[start:start + len(clap_t)] += palm * loud * rng.uniform(.6, 1)
            at += pace * rng.uniform(.9, 1.1)
    return faded(out, .01)


def warning(rng):
    """A loop: two tones that rise, and a pause."""
    t = seconds(.8)
    out = np.zeros_like(t)
    for start, low, high in ((0, 520, 700), (.32, 620, 880)):
        local = t - start
        on = (local >= 0) & (local < .26)
        span = local[on] / .26
        sweep = 2 * np.pi * (low * local[on] + .5 * (high - low) * local[on] * span)
        out[on] = (np.sin(sweep) + .3 * np.sin(3 * sweep)) * np.sin(np.pi * span)
    return out


def birds(rng):
    """A loop of a wood by day: songs of four kinds, each bird with its own phrase, some near and some far."""
    t = seconds(8)
    out = np.zeros_like(t)

    def add(start, sound):
        at = (int(start * RATE) + np.arange(len(sound))) % len(t)
        out[at] += sound

    def note(duration, low, high, curve=1.0, flutter=0.0):
        local = seconds(duration)
        share = local / duration
        hertz = low + (high - low) * share**curve + flutter * np.sin(2 * np.pi * 45 * local)
        phase = 2 * np.pi * np.cumsum(hertz) / RATE
        return (np.sin(phase) + .12 * np.sin(2 * phase)) * np.sin(np.pi * share)**1.5

    def tit(loud, pitch):  # two tones, again and again
        start = rng.uniform(0, 8)
        for k in range(int(rng.integers(3, 6))):
            add(start + .34 * k, loud * note(.13, 5200 * pitch, 5000 * pitch))
            add(start + .34 * k + .16, loud * .8 * note(.12, 3900 * pitch, 3750 * pitch))

    def chaffinch(loud, pitch):  # a rattle that falls, and a flourish
        start = rng.uniform(0, 8)
        for k in range(9):
            add(start + .09 * k, loud * (.5 + .05 * k) * note(.06, (5400 - 220 * k) * pitch, (4100 - 160 * k) * pitch))
        add(start + .84, loud * note(.1, 2600 * pitch, 4600 * pitch))
        add(start + .97, loud * .9 * note(.16, 4400 * pitch, 2500 * pitch))

    def thrush(loud, pitch):  # fluted phrases
        start = rng.uniform(0, 8)
        for _ in range(int(rng.integers(3, 6))):
            low = rng.uniform(1900, 2700) * pitch
            add(start, loud * note(rng.uniform(.14, .3), low, low * rng.uniform(.8, 1.3), 1.6, 60))
            start += rng.uniform(.25, .42)

    def chirp(loud, pitch):
        add(rng.uniform(0, 8), loud * note(.05, 4300 * pitch, 6100 * pitch, .6))

    for sing, count in ((tit, 4), (chaffinch, 4), (thrush, 4), (chirp, 26)):
        for _ in range(count):
            sing(rng.uniform(.15, 1)**1.6, rng.uniform(.92, 1.08))
    leaves = periodic(rng, t, lambda f: np.exp(-((f - 2600) / 2200)**2))
    return out / np.abs(out).max() + .05 * leaves * (1 + .5 * np.sin(2 * np.pi * t / 4))


def water(rng):
    """A loop of small waves at a shore: each runs up with a hiss and drains away."""
    t = seconds(9)
    hiss = periodic(rng, t, lambda f: np.exp(-((f - 1500) / 1900)**2))
    wash = periodic(rng, t, lambda f: np.exp(-((f - 380) / 330)**2))
    out = .1 * hiss + .25 * wash
    for start, loud in ((.2, 1), (2.5, .7), (4.6, .9), (7.0, .6)):
        local = (t - start) % 9
        rise = np.minimum(local / .9, 1)**2
        out += loud * (wash * rise * np.exp(-np.maximum(local - .9, 0) / .55) +
                       .8 * hiss * rise * np.exp(-np.maximum(local - 1.0, 0) / .9))
    return out


SOUNDS = {"engine": (engine, .8), "drop": (drop, .7), "parachute": (parachute, .7), "landing": (landing, .8),
          "splash": (splash, .7), "score": (score, .55), "miss": (miss, .5), "crash": (crash, .9),
          "stall": (stall, .4), "rain": (rain, .7), "wind": (wind, .7),
          "thunderNear": (thunder(1.8, 1, 400, 2), .95), "thunder": (thunder(2.4, .25, 170, 4), .9),
          "thunderFar": (thunder(3, 0, 80, 5), .9), "touchdown": (touchdown, .7),
          "applause": (applause, .5), "warning": (warning, .6), "birds": (birds, .5), "water": (water, .6)}


def write_wav(path, signal, peak):
    signal = signal / np.abs(signal).max() * peak
    data = np.floor(signal * 32767 + .5).astype("<i2").tobytes()
    header = b"RIFF" + struct.pack("<I", 36 + len(data)) + b"WAVEfmt " + struct.pack(
        "<IHHIIHH", 16, 1, 1, RATE, RATE * 2, 2, 16) + b"data" + struct.pack("<I", len(data))
    path.write_bytes(header + data)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for k, (name, (make, peak)) in enumerate(SOUNDS.items()):
        write_wav(folder / f"{name}.wav", make(np.random.default_rng(SEED + k)), peak)


if __name__ == "__main__":
    main()
