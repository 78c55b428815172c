"""Regions: membership, draws, text and bytes; and the types of what is passed."""

import array
import copy
import pickle
import unittest
import xml.etree.ElementTree

import critreg
from texts import DOMAIN, INSTANCES, PLANE, TRUTH, try_grasp

try:
    import numpy
except ImportError:
    numpy = None

TOO_HIGH = [2.0, 3.5, 1.57]


class Regions(unittest.TestCase):
    def setUp(self):
        self.region = critreg.Region(DOMAIN, TRUTH)

    def test_membership(self):
        for instance in INSTANCES:
            thetas = [[k / 97] for k in range(98)]
            expected = [try_grasp(instance, theta) for theta in thetas]
            self.assertEqual([self.region.contains(instance, t) for t in thetas], expected)
            self.assertEqual(list(self.region.contains_many(instance, thetas)), expected)
            self.assertTrue(any(expected) and not all(expected))

    def test_margins(self):
        for instance in INSTANCES:
            for k in range(98):
                theta = [k / 97]
                values, gradients = self.region.margins(instance, theta)
                inside = self.region.contains(instance, theta)
                self.assertEqual(all(value <= 0.0 for value in values), inside)
                self.assertEqual(len(gradients), len(values))

    def test_proofs(self):
        ranges = [[0.0, 10.0], [0.0, 6.0], [0.0, 1.57]]
        wider = critreg.Region(DOMAIN, "grasp.y <= 3.0")
        self.assertEqual(self.region.implies(wider, ranges).verdict, critreg.Verdict.PROVEN)
        proof = wider.implies(self.region, ranges)
        self.assertEqual(proof.verdict, critreg.Verdict.REFUTED)
        self.assertTrue(wider.contains(proof.instance, proof.theta))
        self.assertFalse(self.region.contains(proof.instance, proof.theta))
        (question,) = wider.to_smt2(self.region, ranges)
        self.assertIn("(check-sat)", question)
        with self.assertRaises(critreg.Error):
            wider.implies(self.region, ranges, tolerance=-1.0)

    def test_c(self):
        self.assertIn("int pick_contains(", self.region.to_c("pick"))

    def test_draws(self):
        rng, instance = critreg.Rng(7), INSTANCES[0]
        many = self.region.sample_many(instance, critreg.Rng(7), 50)
        for row in many:
            theta = self.region.sample(instance, rng)
            self.assertEqual(theta, list(row))
            self.assertTrue(try_grasp(instance, theta))
        self.assertNotEqual(many[0][0], many[1][0])
        self.assertEqual(len(self.region.sample_many(instance, rng, 0)), 0)

    def test_intervals_and_emptiness(self):
        ((low, high),) = self.region.intervals(INSTANCES[0])
        self.assertEqual(low, 0.0)
        self.assertAlmostEqual(high, (2.9 - 0.7) / 3.0, places=5)
        self.assertFalse(self.region.is_empty(INSTANCES[0]))
        self.assertTrue(self.region.is_empty(TOO_HIGH))
        self.assertEqual(self.region.intervals(TOO_HIGH), [])
        with self.assertRaises(critreg.EmptyRegion) as caught:
            self.region.sample(TOO_HIGH, critreg.Rng(0))
        self.assertEqual(caught.exception.status, critreg.Status.EMPTY_REGION)
        with self.assertRaisesRegex(ValueError, "2 parameters"):
            critreg.Region(PLANE, "u <= v").intervals([0.0, 0.0])

    def test_several_regions(self):
        parts = [(self.region, instance) for instance in INSTANCES]
        theta = critreg.sample(parts, critreg.Rng(1))
        self.assertTrue(all(try_grasp(instance, theta) for instance in INSTANCES))
        self.assertFalse(critreg.are_empty(parts))
        self.assertTrue(critreg.are_empty([*parts, (self.region, TOO_HIGH)]))
        with self.assertRaises(critreg.Error):
            critreg.sample([], critreg.Rng(1))

    def test_text_and_bytes(self):
        self.assertEqual(repr(self.region), f"<Region {TRUTH}>")
        self.assertEqual(str(critreg.Region(DOMAIN, str(self.region))), TRUTH)
        loaded = critreg.Region.load(self.region.save())
        self.assertEqual((loaded.text, loaded.save()), (TRUTH, self.region.save()))
        with self.assertRaises(critreg.Error) as caught:
            critreg.Region.load(self.region.save()[:-1])
        self.assertEqual(caught.exception.status, critreg.Status.CORRUPT)
        with self.assertRaisesRegex(critreg.Error, "line 1, column"):
            critreg.Region(DOMAIN, "grasp.y <= zone.bottom")

    def test_copies_keep_the_evidence(self):
        learned = critreg.Learner(DOMAIN, INSTANCES).learn(try_grasp)
        self.assertIsNotNone(learned.constraints[0].evidence)
        for twin in (pickle.loads(pickle.dumps(learned)), copy.deepcopy(learned)):
            self.assertEqual(twin.text, learned.text)
            self.assertEqual(twin.constraints, learned.constraints)
            self.assertEqual(twin.quality, critreg.Quality.EXACT)
        self.assertIsNone(self.region.constraints[0].evidence)

    def test_code(self):
        self.assertIn("int pick_contains(", self.region.to_c("pick"))
        self.assertIn("pub type Real = f64;", self.region.to_rust())
        self.assertIn("pub type Real = f32;", self.region.to_rust(32))
        with self.assertRaises(critreg.Error):
            self.region.to_rust(16)

    def test_pictures(self):
        picture = self.region.picture(INSTANCES[0])
        self.assertTrue(picture.startswith("<svg") and "grasp" in picture)
        self.assertEqual(picture._repr_svg_(), picture)
        xml.etree.ElementTree.fromstring(picture)
        learner = critreg.Learner(DOMAIN, INSTANCES)
        self.assertIn("what can be chosen", learner.picture(0))
        learner.observe(1, [0.5], False)
        self.assertNotIn("tried, and failed", learner.picture(0))
        self.assertIn("tried, and failed", learner.picture(1))
        with self.assertRaisesRegex(critreg.Error, "no instance"):
            learner.picture(len(INSTANCES))

    def test_generators(self):
        one, two = critreg.Rng(3), critreg.Rng(3)
        self.assertEqual([one.uniform() for _ in range(5)], [two.uniform() for _ in range(5)])
        self.assertTrue(0.0 <= one.uniform() < 1.0)
        with self.assertRaises(ValueError):
            critreg.Rng(-1)


class Types(unittest.TestCase):
    def setUp(self):
        self.region = critreg.Region(PLANE, "u <= v")

    def test_lists(self):
        cup = array.array("f", [0.0, 0.0])  # Floats are converted, not read as doubles.
        self.assertTrue(self.region.contains(cup, (0.25, 0.5)))
        for wrong in ([0.25], [0.25, 0.5, 0.5], 0.25, "ab", ["a", "b"], [None, 1.0], [[0.1], 1]):
            with self.assertRaises((TypeError, ValueError)):
                self.region.contains(cup, wrong)
            with self.assertRaises((TypeError, ValueError)):
                self.region.contains_many(cup, [wrong])
        with self.assertRaises(critreg.Error) as caught:
            self.region.contains(cup, [float("nan"), 0.5])
        self.assertEqual(caught.exception.status, critreg.Status.NOT_FINITE)

    @unittest.skipIf(numpy is None, "NumPy is not there")
    def test_arrays(self):
        rows = numpy.random.default_rng(0).uniform(size=(100, 2))
        expected = rows[:, 0] <= rows[:, 1]
        wide = numpy.zeros((100, 4))
        wide[:, ::2] = rows
        for same in (rows, numpy.asfortranarray(rows), wide[:, ::2], rows.tolist()):
            inside = self.region.contains_many(numpy.zeros(2), same)
            self.assertEqual(inside.dtype, bool)
            self.assertTrue((inside == expected).all())
        single = rows.astype(numpy.float32)
        inside = self.region.contains_many(numpy.zeros(2, dtype=int), single)
        self.assertTrue((inside == (single[:, 0] <= single[:, 1])).all())
        drawn = self.region.sample_many(numpy.zeros(2), critreg.Rng(0), 30)
        self.assertEqual((drawn.shape, drawn.dtype), ((30, 2), numpy.float64))
        self.assertTrue(self.region.contains_many([0, 0], drawn).all())

    @unittest.skipIf(numpy is None, "NumPy is not there")
    def test_wrong_arrays(self):
        cup = numpy.zeros(2)
        for wrong in (numpy.zeros(3), numpy.zeros((2, 1)), numpy.zeros((1, 2)), numpy.zeros(())):
            with self.assertRaises(ValueError):
                self.region.contains(cup, wrong)
        for kind in (complex, object, str):
            with self.assertRaises(TypeError):
                self.region.contains(cup, numpy.zeros(2, dtype=kind))
        with self.assertRaises(ValueError):
            self.region.contains_many(cup, numpy.zeros((4, 3)))

    @unittest.skipIf(numpy is None, "NumPy is not there")
    def test_outcomes_of_arrays(self):
        learner = critreg.Learner(DOMAIN, numpy.array(INSTANCES, dtype=numpy.float64))
        region = learner.learn(lambda i, t: numpy.asarray(try_grasp(i, t))[()])
        self.assertEqual(region.quality, critreg.Quality.EXACT)
        self.assertEqual(learner.report().calls, 100)


if __name__ == "__main__":
    unittest.main()
