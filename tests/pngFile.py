"""PNG files of the kinds that matplotlib does not write, for tests: 16 bits, palettes, transparency."""

import struct
import zlib

import numpy as np


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def writePng(path, pixels, palette=None, transparentColours=None):
    """pixels: unsigned integers of 8 or 16 bits, height x width (grey, or indices if there is a palette) or height x
    width x samples (2: grey and alpha, 3: colour, 4: colour and alpha); palette: 8-bit colours, n x 3."""
    samples = 1 if pixels.ndim == 2 else pixels.shape[2]
    kind = 3 if palette is not None else {1: 0, 2: 4, 3: 2, 4: 6}[samples]
    height, width = pixels.shape[:2]
    rows = pixels.astype(pixels.dtype.newbyteorder(">")).reshape(height, -1).view(np.uint8).reshape(height, -1)
    unfiltered = np.hstack([np.zeros((height, 1), np.uint8), rows])
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        file.write(chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8 * pixels.itemsize, kind, 0, 0, 0)))
        if palette is not None:
            file.write(chunk(b"PLTE", np.asarray(palette, np.uint8).tobytes()))
        if transparentColours is not None:
            file.write(chunk(b"tRNS", bytes(transparentColours)))
        file.write(chunk(b"IDAT", zlib.compress(unfiltered.tobytes(), 1)))
        file.write(chunk(b"IEND", b""))
