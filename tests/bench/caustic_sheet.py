"""Crops of the caustic layer of several pictures side by side in one PNG, with a line of text
under each."""

import struct
import zlib

import numpy

import exr

SCALE, COLUMNS, GAP = 2, 5, 4
# Letters of 3 x 5 pixels, a digit a row.
LETTERS = "abcdefghijklmnopqrstuvwxyz0123456789.- "
SHAPES = """
25755 65656 34443 65556 74647 74644 34553 55755 72227 11152 55655 44447 57755 65555 25552 65644
25563 65655 34216 72222 55557 55552 55775 55255 55222 71247 75557 26227 71747 71717 55711 74717
74757 71111 75757 75717 00002 00700 00000
"""
FONT = dict(zip(LETTERS, SHAPES.split()))
LETTER = 2  # pixels of the sheet to one of a letter


def write_png(path, pixels):
    """[row, column, colour] of bytes."""
    height, width, _ = pixels.shape
    rows = numpy.concatenate(
        [numpy.zeros((height, 1), numpy.uint8), pixels.reshape(height, 3 * width)], axis=1
    )

    def chunk(kind, data):
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    with open(path, "wb") as file:
        file.write(
            b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows.tobytes(), 9))
            + chunk(b"IEND", b"")
        )


def encode(linear):
    """sRGB bytes"""
    v = numpy.clip(linear, 0, 1)
    v = numpy.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)
    return numpy.round(255 * v).astype(numpy.uint8)


def label(text, width):
    """White letters on black"""
    out = numpy.zeros((7 * LETTER, width, 3), numpy.uint8)
    for i, letter in enumerate(text.lower()[: width // (4 * LETTER)]):
        rows = [[bit == "1" for bit in f"{int(row):03b}"] for row in FONT.get(letter, "00000")]
        out[LETTER : 6 * LETTER, 4 * LETTER * i : (4 * i + 3) * LETTER] = numpy.kron(
            numpy.array(rows, numpy.uint8) * 255, numpy.ones((LETTER, LETTER), numpy.uint8)
        )[:, :, None]
    return out


def write(path, crop, pictures):
    """crop: its name, x, y, width, height; pictures: pairs of text and EXR file, the reference
    first. All are shown as bright as lets the reference's brightest hundredth be white."""
    _, x, y, width, height = crop
    crops = [
        exr.layer(exr.read(file)[0], "caustic")[y : y + height, x : x + width]
        for _, file in pictures
    ]
    white = numpy.percentile(crops[0].max(axis=-1), 99)
    tiles = []
    for (text, _), one in zip(pictures, crops):
        tile = numpy.repeat(
            numpy.repeat(encode(one / max(white, 1e-9)), SCALE, axis=0), SCALE, axis=1
        )
        tile = numpy.concatenate([tile, label(text, tile.shape[1])])
        tiles.append(numpy.pad(tile, ((0, GAP), (0, GAP), (0, 0))))
    while len(tiles) % COLUMNS:
        tiles.append(numpy.zeros_like(tiles[0]))
    rows = [
        numpy.concatenate(tiles[i : i + COLUMNS], axis=1) for i in range(0, len(tiles), COLUMNS)
    ]
    write_png(path, numpy.concatenate(rows))
