"""The generator of points for programs that run campaigns."""

import math
import types
import unittest

import critreg
from texts import DOMAIN, INSTANCES, try_grasp


def vocs(variables=("mu", "instance"), outputs=("works",)):
    names = {name: [0, 1] for name in variables}
    return types.SimpleNamespace(variables=names, observables={name: None for name in outputs})


def tried(point):
    theta = [point["mu"]]
    return dict(point, works=float(try_grasp(INSTANCES[point["instance"]], theta)))


class Campaign(unittest.TestCase):
    def test_suggest_and_ingest(self):
        generator = critreg.Generator(vocs(), DOMAIN, INSTANCES, calls=90)
        while not generator.learner.is_finished:
            points = generator.suggest(3)
            self.assertEqual(len({point["_id"] for point in points}), 3)
            generator.ingest([tried(point) for point in reversed(points)])
        generator.finalize()
        self.assertEqual(generator.region().text, "grasp.y <= 2.9 (zone.top - robot.radius)")

    def test_what_was_not_suggested(self):
        generator = critreg.Generator(vocs(), DOMAIN, INSTANCES)
        generator.ingest([tried({"mu": 0.1, "instance": 1}), tried({"mu": 0.9, "instance": 2})])
        (point,) = generator.suggest()
        generator.ingest([dict(point, works=math.nan)])
        report = generator.learner.report()
        self.assertEqual((report.observed, report.unknown), (2, 1))

    def test_wrong_points(self):
        generator = critreg.Generator(vocs(), DOMAIN, INSTANCES)
        with self.assertRaises(ValueError):
            generator.suggest(1000)
        self.assertEqual(generator.learner.open_questions(), [])
        (point,) = generator.suggest(1)
        told = tried(point)
        generator.ingest([told])
        with self.assertRaisesRegex(ValueError, "ids"):
            generator.ingest([told])

    def test_wrong_names(self):
        for wrong in (vocs(["nu", "instance"]), vocs(["mu"]), vocs(outputs=["a", "b"])):
            with self.assertRaises(ValueError):
                critreg.Generator(wrong, DOMAIN, INSTANCES)
        alone = critreg.Generator(vocs(["mu"]), DOMAIN, INSTANCES[:1])
        self.assertEqual(set(alone.suggest(1)[0]), {"mu", "_id"})


if __name__ == "__main__":
    unittest.main()
