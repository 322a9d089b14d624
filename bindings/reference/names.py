"""What the functions of the C API are called in the other languages, as the bindings' generators spell them. Python's
classes are written by hand: their members are read from them."""
import ast
import importlib.util
import sys

from description import BINDINGS, camel, pascal


def generator(language):
    """A binding's generate.py."""
    path = BINDINGS / language / "generate.py"
    spec = importlib.util.spec_from_file_location(f"generate_{language}", path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def python_members(names):
    """The public functions of the package, and of each class named its members and those it inherits."""
    classes, functions = {}, set()
    for path in (BINDINGS / "python" / "contdyn").glob("*.py"):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(node, ast.ClassDef):
                own = {m.name for m in node.body if isinstance(m, ast.FunctionDef)}
                own |= {t.id for m in node.body if isinstance(m, ast.Assign) for t in m.targets
                        if isinstance(t, ast.Name)}
                classes[node.name] = own, [b.id for b in node.bases if isinstance(b, ast.Name)]
            elif isinstance(node, ast.FunctionDef) and path.name == "__init__.py":
                functions.add(node.name)

    def members(name):
        own, bases = classes.get(name, (set(), []))
        return own.union(*map(members, bases))

    return functions, {name: members(name) for name in names}


class Names:
    def __init__(self, api):
        self.api = api
        self.objects = {thing.name: thing for thing in api.objects}
        self.csharp, self.rust = generator("csharp"), generator("rust")
        self.javascript = generator("javascript").Api(api.json)
        self.python_functions, self.python = python_members([pascal(name) for name in self.objects])

    def of(self, function, entry):
        """(language, name) of each language that has the function; entry is what api.json has of it."""
        thing = self.objects.get(function.object)
        if thing is None:
            return self.free(function)
        rows = [("C++", f"contdyn::{thing.name}::{function.short}"), ("Python", self.in_python(thing, function)),
                ("JavaScript", self.in_javascript(thing, entry)), *self.made(thing, function)]
        return [(language, name) for language, name in rows if name]

    def free(self, function):
        short = function.short
        python = [("Python", f"contdyn.{short}")] if short in self.python_functions else []
        return [("C++", f"contdyn::{short}"), *python, ("JavaScript", camel(short)), ("Lua", f"contdyn.{short}"),
                ("Rust", f"contdyn::{short}"), ("C#", f"Library.{pascal(short)}")]

    def made(self, thing, function):
        """Lua, Rust and C#."""
        name, short = pascal(thing.name), function.short
        if short == "create":
            return [("Lua", f"contdyn.{name}"), ("Rust", f"{name}::new"), ("C#", f"new {name}")]
        if short == "destroy":
            return [("Lua", f"{name}:destroy"), ("Rust", f"drop({name})"), ("C#", f"{name}.Dispose")]
        return [("Lua", f"{name}:{short}"), ("Rust", f"{name}::{self.rust.variable(short)}"),
                ("C#", f"{name}.{self.csharp.property_of(thing, function) or pascal(short)}")]

    def in_javascript(self, thing, entry):
        if self.javascript.left_out(entry):
            return None
        name = self.javascript.public_name(entry)
        return name if name.startswith("new ") else f"{pascal(thing.name)}.{name}"

    def in_python(self, thing, function):
        name, short = pascal(thing.name), function.short
        if short == "create":
            return name
        if short == "destroy":
            return f"{name}.close"
        words = [short, short[4:], short[4:] + "_"] if short.startswith(("set_", "get_")) else [short, short[:-4]]
        word = next((w for w in words if w and w in self.python[name]), None)
        return word and f"{name}.{word}"
