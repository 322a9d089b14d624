"""Objects on threads of the caller, steps spread over threads, memory from the caller."""
import gc
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor

import contdyn
from contdyn import Chain, Field, Water

from support import KINDS, Heap, large, make, moving


class Threads(unittest.TestCase):
    def test_objects_on_threads_of_their_own(self):
        def run(kind):
            made = large(kind)
            for _ in range(20):
                made.step(0.01)
            return made.hash()

        kinds = [kind for kind in KINDS.values() for _ in range(3)]
        alone = {kind: run(kind) for kind in KINDS.values()}
        with ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(run, kinds)), [alone[kind] for kind in kinds])

    @staticmethod
    def change(made, kind, way, turn):
        """More that calls of the library one after the other are made of."""
        if way == 5:
            made.method = turn // 6 % 3
        elif kind is Water:
            made.depth = turn % 3 / 4
            made.indices(skip_dry=True)
        elif kind is Chain:
            made.ring = turn // 2 % 2
            made.enable_field(Field.STIFFNESS)
            made.read(Field.STIFFNESS)
        else:
            made.ring = turn // 2 % 2, 0
            made.indices()

    def test_one_object_on_many_threads(self):
        """Whatever they do at once, each call finds the object whole."""
        def use(made, kind, k):
            field = [field for field, info in kind._fields.items() if info.viewable and not info.always][0]
            other = make(kind)
            for turn in range(80):
                way = (k + turn) % 8
                try:
                    if way == 0:
                        made.enable_field(field)
                    elif way == 1:
                        made.disable_field(field)
                    elif way == 2:
                        made.view(field).tolist()
                    elif way == 3:
                        made.load(made.save())
                    elif way == 4:
                        made.copy_state(other)
                        other.copy_state(made)
                    else:
                        self.change(made, kind, way, turn)
                    made.step(1e-4)
                except (BufferError, contdyn.DisabledError):
                    pass

        for kind in KINDS.values():
            heap = Heap()
            made = moving(kind, allocator=heap)
            with ThreadPoolExecutor(6) as pool:
                for done in [pool.submit(use, made, kind, k) for k in range(6)]:
                    done.result()
            made.step(1e-4)
            made.close()
            gc.collect()
            self.assertEqual(heap.blocks, {})

    def test_two_that_copy_each_other(self):
        for kind in KINDS.values():
            one, other = make(kind), moving(kind)

            def copy(to, source):
                for _ in range(300):
                    to.copy_state(source)

            with ThreadPoolExecutor(2) as pool:
                for done in [pool.submit(copy, one, other), pool.submit(copy, other, one)]:
                    done.result(60)
            self.assertEqual(one.hash(), other.hash())

    def test_each_thread_has_its_own_message(self):
        def fail(mass):
            chain = Chain(1, 1, 1)
            for _ in range(200):
                with self.assertRaisesRegex(contdyn.InvalidValueError, f"mass is {mass},"):
                    chain.mass = mass

        with ThreadPoolExecutor(4) as pool:
            list(pool.map(fail, (-1, -2, -3, -4)))

    def test_steps_leave_pythons_lock(self):
        """While a step waits in `parallel` for another thread, that thread runs."""
        chain, met = large(Chain), threading.Barrier(2)
        waiting = threading.Thread(target=met.wait, args=(60,))
        waiting.start()

        def run(count, task):
            met.wait(60)
            for i in range(count):
                task(i)

        chain.parallel = run
        chain.step(0.01)
        waiting.join()


class Parallel(unittest.TestCase):
    def hash_of(self, kind, way):
        made = large(kind)
        made.parallel = way
        made.step(0.01, 3)
        return made.hash()

    def test_every_way_gives_the_same_bits(self):
        def backwards(count, task):
            for i in reversed(range(count)):
                task(i)

        def on_threads(count, task):
            threads = [threading.Thread(target=task, args=(i,)) for i in range(count)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()

        for kind in KINDS.values():
            plain = self.hash_of(kind, None)
            with ThreadPoolExecutor(3) as pool:
                for way in (1, 2, 5, pool, backwards, on_threads):
                    with self.subTest(kind.__name__, way=way):
                        self.assertEqual(self.hash_of(kind, way), plain)

    def test_other_threads_take_part(self):
        for kind in KINDS.values():
            made, seen = large(kind), set()

            class Seen(ThreadPoolExecutor):
                def submit(self, function, *arguments):
                    def noted(*words):
                        seen.add(threading.get_ident())
                        return function(*words)

                    future = super().submit(noted, *arguments)
                    while not future.running() and not future.done():
                        pass  # begun: it cannot be taken back
                    return future

            with Seen(2) as pool:
                made.parallel = pool
                made.step(0.01)
            self.assertTrue(seen)
            self.assertNotIn(threading.get_ident(), seen)

    def test_it_is_told_and_turned_off(self):
        made = large(Chain)
        calls = []

        def run(count, task):
            calls.append(count)
            for i in range(count):
                task(i)

        self.assertIsNone(made.parallel)
        made.parallel = run
        self.assertIs(made.parallel, run)
        made.step(0.01)
        made.parallel = None
        made.step(0.01)
        self.assertEqual(len(calls), 1)

    def test_what_a_way_leaves_out_is_done_and_what_it_raises_is_raised(self):
        def nothing(count, task):
            pass

        def only_one(count, task):
            task(count - 1)
            raise ZeroDivisionError

        def twice(count, task):
            task(0)
            task(0)

        def beyond(count, task):
            task(count)

        for kind in KINDS.values():
            plain = self.hash_of(kind, None)
            self.assertEqual(self.hash_of(kind, nothing), plain)
            for way, error in ((only_one, ZeroDivisionError), (twice, RuntimeError), (beyond, IndexError)):
                made = large(kind)
                made.parallel = way
                for _ in range(3):
                    with self.assertRaises(error):
                        made.step(0.01)
                self.assertEqual(made.hash(), plain)

    def test_a_part_that_runs_on_is_waited_for_and_a_late_one_refused(self):
        threads, late = [], []

        def run(count, task):
            threads.extend(threading.Thread(target=task, args=(i,)) for i in range(count // 2))
            for thread in threads:
                thread.start()
            late.append(task)

        made = large(Chain)
        plain = self.hash_of(Chain, None)
        made.parallel = run
        try:
            made.step(0.01)
        except RuntimeError:
            pass
        for thread in threads:
            thread.join()
        with self.assertRaises(RuntimeError):
            late[0](0)
        made.parallel = None
        made.step(0.01, 2)
        self.assertEqual(made.hash(), plain)

    def test_a_pool_that_is_shut_down(self):
        pool = ThreadPoolExecutor(2)
        pool.shutdown()
        made, plain = large(Water), self.hash_of(Water, None)
        made.parallel = pool
        for _ in range(3):
            with self.assertRaises(RuntimeError):
                made.step(0.01)
        self.assertEqual(made.hash(), plain)

    def test_a_pool_all_of_whose_threads_step(self):
        with ThreadPoolExecutor(2) as pool:
            def run(_):
                made = large(Chain)
                made.parallel = pool
                made.step(0.01, 3)
                return made.hash()

            self.assertEqual(set(pool.map(run, range(4))), {self.hash_of(Chain, None)})

    def test_wrong_ways(self):
        for way, error in (("2", TypeError), (0, ValueError), (-1, ValueError), (2.0, TypeError)):
            with self.assertRaises(error):
                make(Chain).parallel = way


class Memory(unittest.TestCase):
    def test_all_of_it_comes_from_the_allocator(self):
        for kind in KINDS.values():
            heap = Heap()
            made = moving(kind, allocator=heap)
            self.assertEqual(heap.bytes, made.memory)
            given = heap.given
            made.step(0.01, 5)
            made.read(0 if kind is not Water else 11)
            self.assertEqual(heap.given, given)

    def test_every_allocation_may_fail(self):
        for kind in KINDS.values():
            whole = Heap()
            make(kind, allocator=whole)
            for most in range(whole.given):
                heap = Heap(most)
                with self.assertRaises(contdyn.OutOfMemoryError) as caught:
                    make(kind, allocator=heap)
                self.assertIsInstance(caught.exception, MemoryError)
                self.assertEqual(heap.blocks, {})

    def test_what_an_allocator_raises_is_the_cause(self):
        class Broken(Heap):
            broken = True

            def allocate(self, size, alignment):
                if self.broken is True:
                    raise ZeroDivisionError
                return super().allocate(size, alignment) if not self.broken else "no address"

        heap = Broken()
        with self.assertRaises(contdyn.OutOfMemoryError) as caught:
            Chain(1, 1, 1, allocator=heap)
        self.assertIsInstance(caught.exception.__cause__, ZeroDivisionError)
        heap.broken = False
        chain = Chain(1, 1, 1, allocator=heap)
        heap.broken = "in another way"
        with self.assertRaises(contdyn.OutOfMemoryError) as caught:
            chain.enable_field(contdyn.Field.FORCE)
        self.assertIsInstance(caught.exception.__cause__, TypeError)
        with self.assertRaises(contdyn.InvalidValueError) as caught:
            chain.mass = -1
        self.assertIsNone(caught.exception.__cause__)


if __name__ == "__main__":
    unittest.main()
