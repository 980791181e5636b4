"""Screenshots compared with stored ones: a picture may differ a little, as letters and edges do."""

import io
import os

import numpy as np
from PIL import Image

#: Difference of a color that counts, of 255, and the part of a picture that may have it: letters of
#: another font take about one part in a hundred.
COLOR, PART = 48, 0.02
#: With this variable set, stored screenshots are written anew.
WRITE = "WRITE_SHOTS"


def _pixels(content):
    return np.asarray(Image.open(io.BytesIO(content)).convert("RGB"), dtype=int)


def alike(path, content):
    """Whether a screenshot looks like the stored one; it is stored where it is asked for."""
    if os.environ.get(WRITE):
        path.parent.mkdir(exist_ok=True)
        Image.open(io.BytesIO(content)).convert("RGB").quantize(64).save(path, optimize=True)
    stored, found = _pixels(path.read_bytes()), _pixels(content)
    if np.abs(np.subtract(stored.shape, found.shape)).max() > 2:
        return False
    height, width = np.minimum(stored.shape, found.shape)[:2]
    apart = np.abs(stored[:height, :width] - found[:height, :width]).max(axis=-1)
    return float((apart > COLOR).mean()) < PART
