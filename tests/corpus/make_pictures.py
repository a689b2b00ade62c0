#!/usr/bin/env python3
"""Writes the damaged files of tests/corpus/pictures from its good ones, which cjpeg of libjpeg-turbo made:
48 x 32 pixels of a formula, -quality 80 -sample 2x2 and -progressive, and 33 x 17 grey ones with -restart 1B;
badArithmetic.jpg with -arithmetic."""

import os

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "pictures")


def read(name):
    with open(os.path.join(FOLDER, name), "rb") as file:
        return file.read()


def write(name, content):
    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(content)


def main():
    good, scans = read("goodBaseline.jpg"), read("goodProgressive.jpg")
    frame = good.index(b"\xff\xc0")
    write("badCutOff.jpg", good[: len(good) // 2])
    write("badNoEnd.jpg", good[:-2])
    write("badCutOffInTheScans.jpg", scans[:-40])
    write("badTwelveBits.jpg", good[: frame + 4] + b"\x0c" + good[frame + 5 :])
    write("badHuge.jpg", good[: frame + 5] + b"\xff" * 4 + good[frame + 9 :])
    write("badTooManyPixels.jpg", good[: frame + 5] + b"\x3f\xff" * 2 + good[frame + 9 :])
    write("badFourComponents.jpg", good[: frame + 9] + b"\x04" + good[frame + 10 :])
    write("badNoWidth.jpg", good[: frame + 7] + b"\0\0" + good[frame + 9 :])
    write("badSegmentOfOneByte.jpg", good[:4] + b"\0\1" + good[6:])
    write("badSecondFrame.jpg", good[: frame + 19] + good[frame:])
    write("badNoFrame.jpg", good[:frame] + good[frame + 19 :])
    write("badStartAlone.jpg", good[:2])
    write("badStartAndEnd.jpg", good[:2] + good[-2:])
    write("badGif.jpg", b"GIF89a\1\0\1\0\0\0\0;")
    write("badEmpty.jpg", b"")
    write("goodBytesAfterTheEnd.jpg", good + b"trailing")


main()
