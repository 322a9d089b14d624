"""What the tests share."""
import ctypes
import json
from pathlib import Path

from contdyn import Chain, Field, Membrane, Precision, Water, _arrays

PYTHON = Path(__file__).resolve().parents[1]
BINDINGS = PYTHON.parent
NUMPY = _arrays.numpy is not None
KINDS = {"chain": Chain, "membrane": Membrane, "water": Water}


def api():
    return json.loads((BINDINGS / "api.json").read_text(encoding="utf-8"))


def large(kind, **rest):
    """One whose steps are spread over threads, if it is told how."""
    if kind is Water:
        made = Water(96, 64, 0.25, 0.25, **rest)
        made.depth = [[0.5 + 0.125 * ((3 * j + i) % 4) for i in range(96)] for j in range(64)]
        return made
    made = Membrane(200, 160, 1, **rest) if kind is Membrane else Chain(100, 20, 3, **rest)
    made.position = wave(made.position.shape)
    return made


def make(kind, precision=Precision.FLOAT64, **rest):
    """A small object at its start."""
    if kind is Water:
        return Water(5, 4, 0.5, 0.25, precision, **rest)
    if kind is Membrane:
        return Membrane(4, 3, 3, precision, **rest)
    return Chain(2, 5, 3, precision, **rest)


def moving(kind, precision=Precision.FLOAT64, **rest):
    """The same in motion."""
    made = make(kind, precision, **rest)
    if kind is Water:
        made.depth = [[0.5 + 0.125 * ((3 * j + i) % 4) for i in range(5)] for j in range(4)]
    else:
        made.position = wave(made.position.shape)
    made.step(0.01, 3)
    return made


def wave(shape):
    """Numbers that all differ and are exact in float32, nested by shape."""
    count = iter(range(1, 10**6))

    def nested(extents):
        return [nested(extents[1:]) for _ in range(extents[0])] if extents else next(count) / 64

    return nested(list(shape))


def numbers_for(made, field):
    """Numbers, all different, that may be written to a field."""
    numbers = wave(made.read(field).shape)
    if field == Field.VELOCITY_X:  # no water crosses the sides
        for row in numbers:
            row[0] = row[-1] = 0
    if field == Field.VELOCITY_Y:
        numbers[0] = numbers[-1] = [0] * len(numbers[0])
    return numbers


def optional_views(kind):
    """The fields of a kind that can be switched on and shown."""
    return [field for field, info in kind._fields.items() if info.viewable and not info.always]


def viewable(kind):
    return [field for field, info in kind._fields.items() if info.viewable]


def lengthen(made, length=1):
    """Makes a chain a rope and a membrane cloth; 0 undoes it."""
    if not isinstance(made, Water):
        made.rest_length = length if isinstance(made, Chain) else (length, length)


def possible(made):
    """The fields that it can have: rest angles need 2 components."""
    return [field for field in type(made)._fields if field != Field.REST_ANGLE or made.shape.components == 2]


def switch_all_on(made):
    lengthen(made)  # some fields are of ropes and cloth only
    for field in possible(made):
        if not type(made)._fields[field].always:
            made.enable_field(field)


class Heap:
    """An allocator that counts, that spoils what it gets back, and that can be told to give nothing."""

    def __init__(self, most=10**9):
        self.blocks = {}
        self.given = 0
        self.most = most

    def allocate(self, size, alignment):
        if self.given >= self.most:
            return None
        self.given += 1
        memory = ctypes.create_string_buffer(size + alignment)
        address = ctypes.addressof(memory) // alignment * alignment + alignment
        self.blocks[address] = (memory, size, alignment)
        return address

    def release(self, address, size, alignment):
        memory, was_size, was_alignment = self.blocks.pop(address)
        assert (size, alignment) == (was_size, was_alignment)
        ctypes.memset(memory, 0xFF, len(memory))
        SPOILED.append(memory)  # stays readable, so that a dangling view would show numbers that are none

    @property
    def bytes(self):
        return sum(size for _, size, _ in self.blocks.values())


SPOILED = []
