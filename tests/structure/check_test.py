#!/usr/bin/env python3
"""Tests that the structure check finds what it is there to find."""

import unittest

import check


def messages(file, include):
    return [message for _, message in check.forbidden_includes(file, [f"#include {include}"])]


class StructureCheck(unittest.TestCase):
    def test_forbidden_includes_are_found(self):
        for file, include in (
            ("solver/model/model.h", '"trajan/v1/scene.pb.h"'),
            ("solver/analyses/run.cpp", "<grpcpp/grpcpp.h>"),
            ("solver/analyses/run.cpp", "<hdf5.h>"),
            ("solver/measures/measure.cpp", "<H5Cpp.h>"),
            ("solver/model/model.cpp", "<sqlite3.h>"),
            ("server/work.cpp", "<sqlite3.h>"),
            ("server/serve.cpp", '"client/commands.h"'),
            ("client/main.cpp", '"solver/model/model.h"'),
            ("client/main.cpp", '"server/serve.h"'),
            ("solver/results/writer.cpp", '"server/store.h"'),
            ("solver/materials/linear_elastic.h", '"solver/schemes/musl.h"'),
            ("solver/materials/linear_elastic.h", '"solver/model/model.h"'),
            ("solver/shapes/linear.h", '"solver/materials/material.h"'),
            ("solver/executors/tiles.h", '"solver/schemes/kernels.h"'),
            ("solver/model/validate.cpp", '"solver/schemes/musl.h"'),
            ("solver/measures/measure.cpp", '"solver/results/results.h"'),
        ):
            with self.subTest(file=file, include=include):
                self.assertEqual(len(messages(file, include)), 1)

    def test_allowed_includes_are_not(self):
        for file, include in (
            ("server/store_database.cpp", "<sqlite3.h>"),
            ("solver/results/handles.h", "<hdf5.h>"),
            ("server/convert.h", '"trajan/v1/scene.pb.h"'),
            ("server/work.cpp", '"solver/analyses/run.h"'),
            ("solver/model/validate_numerics.cpp", '"solver/schemes/time_step.h"'),
            ("solver/materials/linear_elastic.h", '"solver/materials/elastic_moduli.h"'),
            ("solver/schemes/musl.h", "<vector>"),
        ):
            with self.subTest(file=file, include=include):
                self.assertEqual(messages(file, include), [])


if __name__ == "__main__":
    unittest.main()
