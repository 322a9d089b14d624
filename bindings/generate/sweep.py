"""Arguments with which every function succeeds, for tests that are made from api.json. The numbers are those by which
tests/bindings/check_api.py holds the library to the description."""
import sys
from description import BINDINGS

sys.path.insert(0, str(BINDINGS.parent / "tests" / "bindings"))
import check_api  # noqa: E402

COMPONENTS = {"chain": 2, "membrane": 3, "water": 1}  # rest angles need 2, and there beds have one row
VALUES = {("chain", "columns"): 4, ("chain", "rows"): 1}


def sizes(thing):
    """What create takes, but for the precision and the allocator."""
    shape = [*check_api.SHAPES[thing.name][:-2]]
    if thing.name != "water":
        shape[2] = COMPONENTS[thing.name]
    return shape


def elements(function, array):
    """How many values an array argument has."""
    own = check_api.COUNTS.get(function.short, {}).get(array.name)
    if own is not None:
        return own
    single = array.times in (2, 3) or function.short == "sample" and array.length == "n"
    count = 1 if single else COMPONENTS[function.object]
    return count * (count if isinstance(array.times, str) else array.times)


def value(thing, parameter, enums):
    """A number, or the short name of an enumerator."""
    if parameter.enum == "cd_field":
        raise ValueError("see field()")
    if parameter.enum:
        return enums[parameter.enum]["values"][0]["short"]
    return VALUES.get((thing.name, parameter.name), check_api.VALUES.get(parameter.name, 1))


def field(thing):
    return next(f["name"] for f in thing.fields if f["always"])[3:].lower()


def numbers(function, array):
    """An array's values."""
    count = elements(function, array)
    if array.name in check_api.STARTS:
        size = COMPONENTS[function.object] if function.object == "chain" else 3
        return [float(row == column) for row in range(size) for column in range(size)][:count]
    return [0.0 if array.base in ("double", "float") else 0] * count


def arguments(thing, function, enums):
    """Of each argument what it is and its value: ("number", n), ("flag", b), ("enum", short), ("array", numbers),
    ("room", how many), ("bytes", None), ("buffer", how many bytes), ("other", None), ("made", the name of another kind
    of object), ("none", None)."""
    for p in function.arguments:
        if p.role == "handle":
            yield (p, "other", None) if p.base == thing.handle else (p, "made", p.base[3:])
        elif p.role == "callbacks":
            yield p, "none", None
        elif p.role == "bytes":
            yield (p, "bytes", None) if p.is_in else (p, "buffer", check_api.ROOM)
        elif p.role == "array":
            yield (p, "array", numbers(function, p)) if p.is_in else (p, "room", elements(function, p))
        elif p.base == "cd_field":
            yield p, "enum", field(thing)
        elif p.enum:
            yield p, "enum", value(thing, p, enums)
        elif p.is_flag:
            yield p, "flag", bool(value(thing, p, enums))
        else:
            yield p, "number", value(thing, p, enums)


def told_by(thing, function):
    """The getter that tells what a setter was given, and which of the setter's arguments each of its results is."""
    getter = thing.by_short.get("get_" + function.short[4:]) if function.short.startswith("set_") else None
    if getter is None or any(p.role != "value" for p in getter.arguments):
        return None
    given = {p.name: p for p in function.arguments if p.role == "value"}
    if not all(p.name in given and given[p.name].base == p.base for p in getter.arguments):
        return None
    if not getter.results or not all(p.word in given for p in getter.results):
        return None
    if len({p.enum for p in getter.results}) > 1:  # what the numbers mean depends on the enumerator
        return None
    return getter


def may_fail(function):
    """Of functions that these arguments do not suit; they then say CD_ERROR_UNSUPPORTED, CD_ERROR_RANGE, or without the
    functions that they call back CD_ERROR_NULL."""
    return function.short in ("disable_field", "get_volume", "set_callback")
