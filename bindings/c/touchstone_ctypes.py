# SPDX-License-Identifier: Apache-2.0
"""Declarations of touchstone.h for Python's ctypes: the functions for a polygon. touchstone.h says what each promises."""

import ctypes
from ctypes import POINTER, c_char, c_char_p, c_double, c_int32, c_size_t, c_uint64, c_void_p

Vector = c_double * 3


class Error(ctypes.Structure):
    _fields_ = [("status", c_int32), ("message", c_char * 508)]


class Ball(ctypes.Structure):
    _fields_ = [("center", Vector), ("radius", c_double)]


class Motion(ctypes.Structure):
    _fields_ = [("ball", Ball), ("to", Vector)]


class Feature(ctypes.Structure):
    _fields_ = [("index", c_uint64), ("kind", c_int32), ("reserved", c_int32)]


class Answer(ctypes.Structure):
    _fields_ = [("plane", c_int32), ("plane_tangent", c_int32), ("foot", c_int32), ("relation", c_int32), ("nearest", Feature),
                ("point", Vector), ("distance", c_double), ("contact_normal", Vector), ("depth", c_double), ("off_plane", c_double)]


class FirstContact(ctypes.Structure):
    _fields_ = [("kind", c_int32), ("momentary", c_int32), ("time", c_double), ("feature", Feature), ("point", Vector),
                ("contact_normal", Vector), ("depth", c_double)]


FUNCTIONS = {  # name: what it returns, and its arguments; a handle is a c_void_p
    "status_name": (c_char_p, c_int32),
    "polygon_create": (c_int32, POINTER(c_double), POINTER(c_size_t), c_size_t, POINTER(c_void_p), POINTER(Error)),
    "polygon_free": (None, c_void_p),
    "polygon_answer": (c_int32, c_void_p, POINTER(Ball), c_size_t, POINTER(Answer), POINTER(Error)),
    "polygon_edges_hit": (c_int32, c_void_p, POINTER(Ball), POINTER(c_uint64), c_size_t, POINTER(c_size_t), POINTER(Error)),
    "polygon_first_contact": (c_int32, c_void_p, POINTER(Motion), c_size_t, POINTER(FirstContact), POINTER(Error)),
}


def load(path):
    """Returns the shared library at `path`, with the functions above declared."""
    library = ctypes.CDLL(str(path))
    for name, (result, *arguments) in FUNCTIONS.items():
        function = getattr(library, f"touchstone_{name}")
        function.restype, function.argtypes = result, arguments
    return library
