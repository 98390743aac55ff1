#!/usr/bin/env python3
"""Registers a reference to an object with Open3D: FPFH features, RANSAC over them, ICP with scale.

The settings are those of Open3D's tutorial "Global registration", scaled to the part as in the bench's PCL pipeline: a
grid of 1/30 of the reference's half diagonal, normals over 2 cells, features over 5, pairs within 1.5 cells. The scale
to start from is the ratio of the clouds' RMS sizes, because RANSAC over features knows only one size.

Usage: open3d_registration.py REFERENCE.ply OBJECT.ply
Prints the 4 x 4 matrix that puts the reference on the object, one row per line, then ICP's fitness and the seconds of
processor time. Exit code 3: Open3D is not installed."""

import sys
import time

try:
    import numpy
    import open3d
except ImportError:
    sys.exit(3)

CELLS = 30
REGISTRATION = open3d.pipelines.registration


def rms_size(cloud):
    """Root mean square distance from the centroid."""
    points = numpy.asarray(cloud.points)
    return numpy.sqrt(((points - points.mean(axis=0)) ** 2).sum(axis=1).mean())


def described(cloud, cell):
    """The cloud reduced on a grid, and the features of its points."""
    reduced = cloud.voxel_down_sample(cell)
    search = open3d.geometry.KDTreeSearchParamHybrid
    reduced.estimate_normals(search(radius=2 * cell, max_nn=30))
    return reduced, REGISTRATION.compute_fpfh_feature(reduced, search(radius=5 * cell, max_nn=100))


def coarse(reference, object_, cell):
    """RANSAC over pairs of features, with the tutorial's checks."""
    source, source_features = described(reference, cell)
    target, target_features = described(object_, cell)
    distance = 1.5 * cell
    return REGISTRATION.registration_ransac_based_on_feature_matching(
        source, target, source_features, target_features, True, distance,
        REGISTRATION.TransformationEstimationPointToPoint(False), 3,
        [REGISTRATION.CorrespondenceCheckerBasedOnEdgeLength(0.9),
         REGISTRATION.CorrespondenceCheckerBasedOnDistance(distance)],
        REGISTRATION.RANSACConvergenceCriteria(100000, 0.999)).transformation


def main():
    """Reads, registers, prints."""
    open3d.utility.random.seed(1)
    reference, object_ = (open3d.io.read_point_cloud(name) for name in sys.argv[1:3])
    start = time.process_time()
    scale = rms_size(object_) / rms_size(reference)
    size = numpy.diag([scale, scale, scale, 1])
    cell = scale * numpy.linalg.norm(reference.get_max_bound() - reference.get_min_bound()) / 2 / CELLS
    scaled = open3d.geometry.PointCloud(reference).transform(size)
    fine = REGISTRATION.registration_icp(
        scaled, object_, cell, coarse(scaled, object_, cell),
        REGISTRATION.TransformationEstimationPointToPoint(True),
        REGISTRATION.ICPConvergenceCriteria(max_iteration=100))
    for row in fine.transformation @ size:
        print(*row)
    print(fine.fitness)
    print(time.process_time() - start)


if __name__ == "__main__":
    main()
