"""OpenEXR files as cognac writes them (one part, scan lines, ZIP or no compression, half or
float), to and from numpy."""

import os
import struct
import zlib

import numpy

MAGIC = 20000630
ZIP, NONE = 3, 0
ROWS = {NONE: 1, 2: 1, ZIP: 16}  # rows of a block; 2 is ZIPS
TYPES = {0: "<u4", 1: "<f2", 2: "<f4"}


def _text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def _header(data):
    """Attributes by name, as (type, bytes), and where they end."""
    at, attributes = 8, {}
    while data[at]:
        name, at = _text(data, at)
        kind, at = _text(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name] = (kind, data[at + 4 : at + 4 + size])
        at += 4 + size
    return attributes, at + 1


def _channels(data):
    at = 0
    while data[at]:
        name, at = _text(data, at)
        yield name, numpy.dtype(TYPES[struct.unpack_from("<i", data, at)[0]])
        at += 16


def _unzip(packed, size):
    """A block's bytes: they were parted into even and odd ones, and each replaced by the
    difference to the last."""
    if len(packed) == size:
        return packed
    raw = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).astype(numpy.int64)
    raw[1:] -= 128
    raw = (numpy.cumsum(raw) & 255).astype(numpy.uint8)
    out = numpy.empty(size, numpy.uint8)
    half = (size + 1) // 2
    out[0::2], out[1::2] = raw[:half], raw[half:]
    return out.tobytes()


def read(path):
    """Channels by name, each [row, column] in float32, and the text attributes by name."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = _header(data)
    compression = attributes["compression"][1][0]
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"][1])
    width, height, rows = right - left + 1, bottom - top + 1, ROWS[compression]
    layout = list(_channels(attributes["channels"][1]))
    planes = {name: numpy.empty((height, width), numpy.float32) for name, _ in layout}
    row_bytes = sum(width * kind.itemsize for _, kind in layout)
    for offset in struct.unpack_from("<%dQ" % -(-height // rows), data, at):
        y, size = struct.unpack_from("<2i", data, offset)
        y -= top
        block = _unzip(data[offset + 8 : offset + 8 + size], row_bytes * min(rows, height - y))
        place = 0
        while place < len(block):
            for name, kind in layout:
                planes[name][y] = numpy.frombuffer(block, kind, width, place)
                place += width * kind.itemsize
            y += 1
    texts = {name: value.decode() for name, (kind, value) in attributes.items() if kind == "string"}
    return planes, texts


def _attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def _write_header(names, width, height, texts):
    channels = (
        b"".join(name.encode() + struct.pack("<B4i", 0, 2, 0, 1, 1) for name in names) + b"\0"
    )
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    parts = [
        _attribute("channels", "chlist", channels),
        _attribute("compression", "compression", bytes([NONE])),
        _attribute("dataWindow", "box2i", window),
        _attribute("displayWindow", "box2i", window),
        _attribute("lineOrder", "lineOrder", b"\0"),
        _attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        _attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        _attribute("screenWindowWidth", "float", struct.pack("<f", 1)),
    ]
    parts += [_attribute(name, "string", text.encode()) for name, text in sorted(texts.items())]
    return struct.pack("<2i", MAGIC, 2) + b"".join(parts) + b"\0"


def write(path, planes, texts):
    """Float channels without compression; written beside and renamed."""
    names = sorted(planes)
    height, width = planes[names[0]].shape
    header = _write_header(names, width, height, texts)
    row_bytes = 8 + 4 * width * len(names)
    with open(path + ".new", "wb") as file:
        file.write(header)
        first = len(header) + 8 * height
        file.write(struct.pack("<%dQ" % height, *(first + row_bytes * y for y in range(height))))
        for y in range(height):
            file.write(struct.pack("<2i", y, row_bytes - 8))
            file.write(b"".join(planes[name][y].astype("<f4").tobytes() for name in names))
    os.replace(path + ".new", path)


def layer(planes, name):
    """[row, column, colour] of a layer, "" for the picture itself."""
    prefix = name + "." if name else ""
    return numpy.stack([planes[prefix + c] for c in "RGB"], axis=-1)
