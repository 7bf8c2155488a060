# SPDX-License-Identifier: MIT
# Prints scikit-image's SSIM of three pairs of images that are formulas; metrics_test.cpp holds the
# figures that it printed and, where scikit-image is installed, runs it again.
import numpy
from skimage.metrics import structural_similarity

y, x = numpy.mgrid[0:48, 0:64].astype(numpy.float64)
hashed = ((7 * x + 13 * y) % 256) / 255
pairs = [
    (x / 63, numpy.floor(x / 8) / 7),
    (hashed, ((7 * (x + 1) + 13 * y) % 256) / 255),
    ((x >= 32) * 1.0, (x >= 33) * 0.8 + 0.1),
]
for reference, test in pairs:
    print("%.9f" % structural_similarity(
        reference, test, gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
        data_range=1.0))
