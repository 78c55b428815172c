"""Learning: with and without threads, by hand, interrupted, and used wrongly."""

import threading
import unittest

import critreg
from texts import DOMAIN, INSTANCES, TRUTH, try_grasp


def learned(**options):
    learner = critreg.Learner(DOMAIN, INSTANCES, **options)
    return learner, learner.learn(try_grasp)


class Learning(unittest.TestCase):
    def test_the_region_is_found_and_named(self):
        learner, region = learned(seed=3)
        self.assertEqual(region.text, "grasp.y <= 2.9 (zone.top - robot.radius)")
        self.assertEqual(region.quality, critreg.Quality.EXACT)
        self.assertEqual(learner.quality(), critreg.Quality.EXACT)
        (constraint,) = region.constraints
        self.assertEqual(constraint.name, "zone.top - robot.radius")
        self.assertLessEqual(constraint.evidence.feasible, 2.9)
        self.assertGreater(constraint.evidence.infeasible, 2.9)
        report = learner.report()
        self.assertEqual((report.calls, report.feasible + report.infeasible), (100, 100))
        self.assertIn("calls=100", repr(report))
        self.assertEqual(learner.why()[0], critreg.Why.EXPLAINED)

    def test_the_same_seed_gives_the_same_run(self):
        (one, _), (two, _), (other, _) = learned(seed=1), learned(seed=1), learned(seed=2)
        self.assertEqual(one.save(), two.save())
        self.assertNotEqual(one.save(), other.save())

    def test_ask_and_tell_ask_what_learn_asks(self):
        learner = critreg.Learner(DOMAIN, INSTANCES, seed=1)
        while not learner.is_finished:
            index, theta = learner.ask()
            learner.tell(try_grasp(INSTANCES[index], theta))
        self.assertEqual(learner.save(), learned(seed=1)[0].save())

    def test_threads_share_the_questions(self):
        learner = critreg.Learner(DOMAIN, INSTANCES)
        together, threads = threading.Barrier(3, timeout=20), set()

        def simulate(instance, theta):
            # The first trials wait for each other: they run at once, or never.
            if len(threads) < 3:
                threads.add(threading.get_ident())
                together.wait()
            return try_grasp(instance, theta)

        seen = []
        region = learner.learn(simulate, workers=3, progress=lambda r: seen.append(r.calls))
        self.assertEqual(region.text, "grasp.y <= 2.9 (zone.top - robot.radius)")
        self.assertEqual((len(threads), len(seen)), (3, 100))
        self.assertEqual(learner.report().calls, 100)

    def test_others_may_look_on(self):
        learner, looks, done = critreg.Learner(DOMAIN, INSTANCES), [], threading.Event()

        def look():
            while not done.is_set():
                looks.append((learner.report().calls, learner.is_finished, learner.region()))

        watcher = threading.Thread(target=look)
        watcher.start()
        try:
            learner.learn(try_grasp, workers=2)
        finally:
            done.set()
            watcher.join()
        calls = [calls for calls, _, _ in looks]
        self.assertEqual(calls, sorted(calls))
        self.assertLessEqual(calls[-1], 100)

    def test_what_a_simulator_raises_comes_through_and_learning_goes_on(self):
        for workers in (1, 4):
            learner, calls = critreg.Learner(DOMAIN, INSTANCES), []

            def fragile(instance, theta):
                calls.append(theta)
                if len(calls) == 10:
                    raise OSError("the gripper is stuck")
                return try_grasp(instance, theta)

            with self.assertRaisesRegex(OSError, "stuck"):
                learner.learn(fragile, workers=workers)
            self.assertTrue(learner.open_questions())
            learner.learn(fragile, workers=workers)
            # The trial that was cut off was repeated, and no other one.
            self.assertEqual((learner.report().calls, len(calls)), (100, 101), workers)

    def test_nothing_learned_says_why(self):
        learner = critreg.Learner(DOMAIN, INSTANCES, calls=20)
        with self.assertRaises(critreg.NoRegion) as caught:
            learner.learn(lambda instance, theta: False)
        self.assertEqual(caught.exception.status, critreg.Status.NO_REGION)
        why, text = learner.why()
        self.assertEqual((why, str(caught.exception)), (critreg.Why.NONE_WORKED, text))
        self.assertIsNone(learner.region())

    def test_questions_are_answered_in_any_order_and_forgotten(self):
        learner = critreg.Learner(DOMAIN, INSTANCES)
        first, second, third = learner.ask_many(3)
        learner.forget(second.id)
        for question in (third, first):
            learner.tell_id(question.id, try_grasp(INSTANCES[question.instance], question.theta))
        self.assertEqual(learner.open_questions(), [])
        learner.conclude()  # The third one's answer waited for that of the second.
        with self.assertRaises(critreg.Error) as caught:
            learner.tell_id(first.id, True)
        self.assertEqual(caught.exception.status, critreg.Status.OUT_OF_SEQUENCE)
        self.assertEqual(learner.report().calls, 2)

    def test_observed_samples_teach(self):
        learner = critreg.Learner(DOMAIN, INSTANCES, observations=400)
        for k in range(200):
            theta = [(k // 4) / 49]
            learner.observe(k % 4, theta, try_grasp(INSTANCES[k % 4], theta))
        learner.conclude()
        self.assertEqual(learner.region().text, "grasp.y <= 2.9 (zone.top - robot.radius)")
        self.assertEqual((learner.report().observed, learner.report().calls), (200, 0))

    def test_counterexamples_teach(self):
        truth = critreg.Region(DOMAIN, "grasp.y <= 2.9")
        ranges = [[0.0, 10.0], [0.0, 2.5], [1.57, 1.57]]
        # Where the stick lies this low, every grasp works but the last few.
        learner = critreg.Learner(DOMAIN, [[2.0, 0.0, 1.57]], calls=30, certifying=0)
        learner.learn(try_grasp)
        proof = learner.challenge(truth, ranges)
        for count in range(1, 12):
            if proof.verdict != critreg.Verdict.REFUTED:
                break
            learner.add_instances([proof.instance])
            learner.observe(count, proof.theta, try_grasp(proof.instance, proof.theta))
            learner.conclude()
            proof = learner.challenge(truth, ranges)
        self.assertEqual(proof.verdict, critreg.Verdict.PROVEN)

    def test_runs_are_saved_and_resumed(self):
        whole, _ = learned(seed=5)
        learner, journal = critreg.Learner(DOMAIN, INSTANCES, seed=5), b""
        for told in range(30):
            index, theta = learner.ask()
            learner.tell(try_grasp(INSTANCES[index], theta))
            journal += learner.journal(told)
        resumed = critreg.Learner(DOMAIN, INSTANCES, seed=5)
        resumed.resume(learner.save())
        resumed.learn(try_grasp)
        self.assertEqual(resumed.save(), whole.save())
        again = critreg.Learner(DOMAIN, INSTANCES, seed=5)
        self.assertEqual(again.resume_journal(journal + b"torn"), len(journal))
        self.assertEqual(again.save(), learner.save())
        with self.assertRaises(critreg.Error) as caught:
            critreg.Learner(DOMAIN, INSTANCES, seed=6).resume(learner.save())
        self.assertEqual(caught.exception.status, critreg.Status.MISMATCH)

    def test_instances_are_added(self):
        learner = critreg.Learner(DOMAIN, INSTANCES[:2])
        for _ in range(20):
            index, theta = learner.ask()
            learner.tell(try_grasp(INSTANCES[index], theta))
        learner.add_instances(INSTANCES[2:])
        self.assertEqual(learner.instances, INSTANCES)
        region = learner.learn(try_grasp)
        self.assertEqual(region.text, "grasp.y <= 2.9 (zone.top - robot.radius)")

    def test_instances_of_a_source(self):
        learner = critreg.Learner(DOMAIN, INSTANCES[:1])
        with self.assertRaises(ZeroDivisionError):
            learner.choose_instances(lambda number: [1 / number, 0, 0], 4)
        with self.assertRaises(ValueError):
            learner.choose_instances(lambda number: [], 4)
        self.assertEqual(learner.instances, INSTANCES[:1])
        offered = 4 * INSTANCES
        learner.choose_instances(lambda number: offered[number], len(offered), room=4)
        self.assertEqual(len(learner.instances), 4)
        for own in learner.instances:
            self.assertIn(list(own), [list(each) for each in INSTANCES])
        learner.learn(try_grasp)

    def test_chains_and_unknown_outcomes(self):
        learner, calls = critreg.Learner(DOMAIN, INSTANCES, steps=2), []

        def simulate(instance, theta):
            calls.append(theta)
            if len(calls) % 10 == 0:
                return critreg.UNKNOWN
            return True if try_grasp(instance, theta) else -2

        region = learner.learn(simulate)
        self.assertEqual(region.constraints[0].evidence.step, 2)
        self.assertEqual(learner.report().unknown, len(calls) // 10)

    def test_the_learner_of_the_thesis(self):
        learner = critreg.Learner(
            DOMAIN, INSTANCES, learner=critreg.ALGORITHM1, negative=[0.99], positive=[0.1]
        )
        index, theta = learner.ask()
        self.assertEqual((index, theta), (0, [0.99]))
        with self.assertRaisesRegex(ValueError, "negative: 2 numbers"):
            critreg.Learner(DOMAIN, INSTANCES, learner=critreg.ALGORITHM1, negative=[0, 1])


class Misuse(unittest.TestCase):
    def test_domain_texts(self):
        domain = critreg.Domain(DOMAIN)
        self.assertEqual((domain.instance_len, domain.parameters), (3, ("mu",)))
        with self.assertRaisesRegex(critreg.Error, "line 2, column") as caught:
            critreg.Domain("object a { x: length }\nshape a = potato(1)\n")
        self.assertEqual(caught.exception.status, critreg.Status.SYNTAX_ERROR)
        with self.assertRaisesRegex(ValueError, "NUL"):
            critreg.Domain("object a\0")

    def test_instances(self):
        for wrong in ([[1.0, 2.0]], [INSTANCES[0], [1.0]], INSTANCES[0], "abc", 3):
            with self.assertRaises((TypeError, ValueError)):
                critreg.Learner(DOMAIN, wrong)
        with self.assertRaises(critreg.Error):
            critreg.Learner(DOMAIN, []).ask()

    def test_options(self):
        with self.assertRaisesRegex(TypeError, "no iterations"):
            critreg.Learner(DOMAIN, INSTANCES, iterations=3)
        for wrong in (-1, 1 << 32):
            with self.assertRaisesRegex(ValueError, "calls is"):
                critreg.Learner(DOMAIN, INSTANCES, calls=wrong)
        with self.assertRaises(critreg.Error) as caught:
            critreg.Learner(DOMAIN, INSTANCES, noise=0.5)
        self.assertEqual(caught.exception.status, critreg.Status.INVALID_ARGUMENT)

    def test_outcomes(self):
        learner = critreg.Learner(DOMAIN, INSTANCES)
        learner.ask()
        for wrong in (None, 1.0, "yes", [True]):
            with self.assertRaises(TypeError):
                learner.tell(wrong)
        with self.assertRaises(ValueError):
            learner.tell((1 << 32) + 1)
        with self.assertRaisesRegex(critreg.Error, "7") as caught:
            learner.tell(7)
        self.assertEqual(caught.exception.status, critreg.Status.INVALID_ARGUMENT)
        with self.assertRaises(ValueError):
            learner.observe(-1, [0.5], True)
        with self.assertRaises(ValueError):
            learner.observe(0, [0.5, 0.5], True)

    def test_telling_before_asking(self):
        with self.assertRaises(critreg.Error) as caught:
            critreg.Learner(DOMAIN, INSTANCES).tell(True)
        self.assertEqual(caught.exception.status, critreg.Status.OUT_OF_SEQUENCE)


if __name__ == "__main__":
    unittest.main()
