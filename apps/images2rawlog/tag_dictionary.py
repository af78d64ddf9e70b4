#!/usr/bin/env python3
"""Writes one of OpenCV's dictionaries of markers as images2rawlog reads it (key dictionary_file). Needs python3-opencv.

usage: tag_dictionary.py NAME > FILE.yml      with NAME as in DICT_4X4_50
"""
import sys

import cv2

if len(sys.argv) != 2 or not hasattr(cv2.aruco, "DICT_" + sys.argv[1]):
    names = ", ".join(sorted(name[5:] for name in dir(cv2.aruco) if name.startswith("DICT_")))
    sys.exit("usage: tag_dictionary.py NAME > FILE.yml, NAME is one of " + names)
dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, "DICT_" + sys.argv[1]))
draw = getattr(cv2.aruco, "generateImageMarker", None) or cv2.aruco.drawMarker  # OpenCV 4.7 has renamed it
size = dictionary.markerSize
print("nmarkers: %d\nmarkersize: %d" % (len(dictionary.bytesList), size))
for number in range(len(dictionary.bytesList)):
    cells = draw(dictionary, number, size + 2)[1:-1, 1:-1] > 127
    print('marker_%d: "%s"' % (number, "".join("01"[cell] for cell in cells.ravel().astype(int))))
