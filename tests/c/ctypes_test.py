"""Loads the C library by dlopen, as programs in other languages do, and uses it through ctypes.

usage: ctypes_test.py LIBRARY
"""

import ctypes
import math
import re
import sys
import threading
import unittest
from pathlib import Path

HEADER = (Path(__file__).resolve().parents[2] / "bindings/c/waywright.h").read_text(encoding="utf-8")


class Point(ctypes.Structure):
    _fields_ = [("x", ctypes.c_double), ("y", ctypes.c_double)]


class Box(ctypes.Structure):
    _fields_ = [("min", Point), ("max", Point)]


class Agent(ctypes.Structure):
    _fields_ = [("radius", ctypes.c_double)]


TYPES = {
    "uint32_t": ctypes.c_uint32,
    "uint64_t": ctypes.c_uint64,
    "int64_t": ctypes.c_int64,
    "double": ctypes.c_double,
    "ww_bool": ctypes.c_int32,
    "ww_path_algorithm": ctypes.c_int32,
    "ww_point": Point,
    "ww_agent": Agent,
}


class PathQuery(ctypes.Structure):
    """Its members are those of waywright.h."""

    _fields_ = [
        (name, TYPES[kind])
        for kind, name in re.findall(
            r"^  (\w+) (\w+);", re.search(r"^typedef struct ww_path_query {$(.*?)^}", HEADER, re.M | re.S)[1], re.M
        )
    ]


Progress = ctypes.CFUNCTYPE(None, ctypes.c_size_t, ctypes.c_size_t, ctypes.c_void_p)


class BulkOptions(ctypes.Structure):
    _fields_ = [
        ("struct_size", ctypes.c_uint32),
        ("progress", Progress),
        ("progress_user_data", ctypes.c_void_p),
        ("threads", ctypes.c_size_t),
        ("jobs", ctypes.c_void_p),
    ]


class Change(ctypes.Structure):
    _fields_ = [("kind", ctypes.c_int32), ("id", ctypes.c_uint64), ("shape", ctypes.c_void_p)]


Question = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p)

REMOVE = 1
OUT_OF_DOMAIN, INVALID_ARGUMENT, BUFFER_TOO_SMALL = 2, -2, -3


class Library(unittest.TestCase):
    path = ""

    @classmethod
    def setUpClass(cls):
        cls.ww = ctypes.CDLL(cls.path)
        cls.ww.ww_version.restype = ctypes.c_char_p
        cls.ww.ww_status_name.restype = ctypes.c_char_p

    def ok(self, status):
        self.assertEqual(self.ww.ww_status_name(status), b"ok")

    def make(self, kind, *arguments):
        made = ctypes.c_void_p()
        self.ok(getattr(self.ww, f"ww_{kind}_create")(*arguments, ctypes.byref(made)))
        self.addCleanup(getattr(self.ww, f"ww_{kind}_destroy"), made)
        return made

    def make_world(self):
        return self.make("world", Box(Point(0, 0), Point(10, 10)), None)

    def points_of(self, path):
        count = ctypes.c_size_t()
        self.ok(self.ww.ww_path_points(path, None, ctypes.c_size_t(0), ctypes.byref(count)))
        points = (Point * count.value)()
        self.ok(self.ww.ww_path_points(path, points, count, ctypes.byref(count)))
        return [(point.x, point.y) for point in points]

    def find_path(self, world, start, goal):
        context, path, query = self.make("context"), self.make("path"), PathQuery()
        self.ok(self.ww.ww_path_query_init(ctypes.byref(query), ctypes.c_size_t(ctypes.sizeof(query))))
        query.start, query.goal = Point(*start), Point(*goal)
        self.ok(self.ww.ww_world_find_path(world, ctypes.byref(query), context, path))
        return self.points_of(path)

    def test_finds_a_path(self):
        world = self.make_world()
        self.ok(self.ww.ww_world_insert_segment(world, Point(4, 0), Point(4, 7), ctypes.c_uint64(0), None))
        self.assertEqual(self.find_path(world, (1, 1), (7, 1)), [(1, 1), (4, 7), (7, 1)])

    def test_says_what_is_wrong(self):
        world = self.make_world()
        inserted = ctypes.c_uint64()
        status = self.ww.ww_world_insert_point(world, Point(11, 5), ctypes.c_uint64(0), ctypes.byref(inserted))
        self.assertEqual(status, OUT_OF_DOMAIN)
        message = ctypes.create_string_buffer(10)
        count = ctypes.c_size_t()
        status = self.ww.ww_last_error_message(message, ctypes.c_size_t(len(message)), ctypes.byref(count))
        self.assertEqual(status, BUFFER_TOO_SMALL)
        message = ctypes.create_string_buffer(count.value)
        self.ok(self.ww.ww_last_error_message(message, ctypes.c_size_t(len(message)), None))
        self.assertIn(b"(11, 5), lies outside the domain", message.value)
        self.assertEqual(self.ww.ww_world_remove(None, ctypes.c_uint64(1)), INVALID_ARGUMENT)

    def test_calls_back(self):
        calls = []
        options = BulkOptions()
        self.ok(self.ww.ww_bulk_options_init(ctypes.byref(options), ctypes.c_size_t(ctypes.sizeof(options))))
        options.progress = Progress(lambda done, total, _: calls.append((done, total)))
        points = (Point * 500)(*(Point(5 + 4 * math.cos(i), 5 + 4 * math.sin(i)) for i in range(500)))
        world = self.make_world()
        self.ok(
            self.ww.ww_world_insert_points(
                world, points, ctypes.c_size_t(500), ctypes.c_uint64(1), ctypes.byref(options), None
            )
        )
        self.assertEqual(calls[-1][0], calls[-1][1])

    def test_asks_a_question(self):
        world = self.make_world()
        self.ok(self.ww.ww_world_insert_segment(world, Point(4, 0), Point(4, 7), ctypes.c_uint64(9), None))
        change, paths = Change(REMOVE, 9, None), []

        def find(changed, _):
            paths.append(self.find_path(ctypes.c_void_p(changed), (1, 1), (7, 1)))
            return self.ww.ww_world_remove(ctypes.c_void_p(changed), ctypes.c_uint64(9))

        status = self.ww.ww_world_attempt(world, ctypes.byref(change), ctypes.c_size_t(1), Question(find), None)
        self.assertEqual(status, INVALID_ARGUMENT)
        self.assertEqual(paths, [[(1, 1), (7, 1)]])
        self.assertEqual(self.find_path(world, (1, 1), (7, 1)), [(1, 1), (4, 7), (7, 1)])

    def test_saves_to_memory(self):
        world, text = self.make_world(), self.make("text")
        self.ok(self.ww.ww_world_insert_segment(world, Point(4, 0), Point(4, 7), ctypes.c_uint64(0), None))
        self.ok(self.ww.ww_world_save_bytes(world, text))
        data, size = ctypes.c_void_p(), ctypes.c_size_t()
        self.ok(self.ww.ww_text_bytes(text, ctypes.byref(data), ctypes.byref(size)))
        saved = ctypes.string_at(data, size.value)
        self.assertEqual(saved[:6], b"WWORLD")
        loaded = ctypes.c_void_p()
        self.ok(self.ww.ww_world_load_bytes(saved, ctypes.c_size_t(len(saved)), None, ctypes.byref(loaded)))
        self.addCleanup(self.ww.ww_world_destroy, loaded)
        self.assertEqual(self.find_path(loaded, (1, 1), (7, 1)), [(1, 1), (4, 7), (7, 1)])

    def test_each_thread_has_its_own_error(self):
        world = self.make_world()
        self.assertEqual(self.ww.ww_world_remove(world, ctypes.c_uint64(99)), 4)
        messages = []

        def read():
            message = ctypes.create_string_buffer(100)
            self.ww.ww_last_error_message(message, ctypes.c_size_t(100), None)
            messages.append(message.value)

        thread = threading.Thread(target=read)
        thread.start()
        thread.join()
        read()
        self.assertEqual(messages, [b"", b"no item has id 99"])


if __name__ == "__main__":
    Library.path = sys.argv.pop(1)
    unittest.main()
