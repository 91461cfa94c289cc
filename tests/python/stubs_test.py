"""The type stubs (_core.pyi) name what the compiled module has, with the same parameters."""

import ast
import inspect
import re
from pathlib import Path

import waywright
from waywright import _core

STUB = ast.parse((Path(waywright.__file__).parent / "_core.pyi").read_text(encoding="utf-8"))
# Methods that every class with pickle or an order has, and that callers do not name.
SILENT = re.compile(r"__(?!init|contains|len|bool|enter|exit|copy|deepcopy|geo_interface)\w+__$|_pybind11|_[a-z]\w*$")


def parameters_of_stub(function):
    """Returns the names of the parameters, those with a default marked by '=', after '*' those by name only."""
    arguments = function.args
    names = [argument.arg for argument in arguments.args]
    with_default = len(names) - len(arguments.defaults)
    names = [name + ("=" if i >= with_default else "") for i, name in enumerate(names)]
    names += ["*" + arguments.vararg.arg] if arguments.vararg else ["*"] if arguments.kwonlyargs else []
    for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults):
        names.append(argument.arg + ("" if default is None else "="))
    return names + (["**" + arguments.kwarg.arg] if arguments.kwarg else [])


def split(text):
    """Splits a list of parameters at the commas outside of brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "[(") - (letter in "])")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def parameters_of_module(function):
    """Returns the same for a function of the module: of Python, or of pybind11, whose docstring has the signature."""
    if inspect.isfunction(function):
        return parameters_of_stub(ast.parse("def f" + re.sub(r"<.*?>", "0", str(no_types(function))) + ": pass").body[0])
    signature = re.match(r"\w+\((.*)\) -> ", function.__doc__.splitlines()[0])[1]
    names = []
    for parameter in split(signature):
        name = re.match(r"\**\w*", parameter)[0]
        names.append(name + ("=" if " = " in parameter else ""))
    return names


def no_types(function):
    signature = inspect.signature(function)
    empty = inspect.Parameter.empty
    plain = [parameter.replace(annotation=empty) for parameter in signature.parameters.values()]
    return signature.replace(parameters=plain, return_annotation=inspect.Signature.empty)


def members_of_stub(body):
    """Returns by name: 'property', or whether a method is static, and its parameters."""
    members = {}
    for node in body:
        if not isinstance(node, ast.FunctionDef):
            continue
        decorators = [ast.unparse(decorator) for decorator in node.decorator_list]
        if "property" in decorators:
            members[node.name] = "property"
        elif not any(decorator.endswith(".setter") for decorator in decorators):
            members[node.name] = ("staticmethod" in decorators, parameters_of_stub(node))
    return members


def members_of_class(cls):
    members = {}
    for name, value in vars(cls).items():
        if SILENT.match(name) or (name == "__init__" and "accurate signature" in (value.__doc__ or "")):
            continue
        if isinstance(value, property):
            members[name] = "property"
        elif callable(value) or isinstance(value, staticmethod):
            members[name] = (isinstance(value, staticmethod), parameters_of_module(getattr(cls, name)))
    return members


CLASSES = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
# Classes that only the stubs have: they contain what several classes share.
BASES = {base.id for node in CLASSES.values() for base in node.bases}


def test_names():
    stub = {node.name for node in STUB.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))} - BASES
    stub |= {node.target.id for node in STUB.body if isinstance(node, ast.AnnAssign)}
    module = {name for name in dir(_core) if not name.startswith("__") or name == "__version__"}
    assert stub == module
    public = {name for name in module if not name.startswith("_") or name == "__version__"}
    assert public <= set(waywright.__all__)


def test_functions():
    members = members_of_stub(STUB.body)
    assert members
    for name, (_, parameters) in members.items():
        assert parameters == parameters_of_module(getattr(_core, name)), name


def test_classes():
    count = 0
    for name, node in CLASSES.items():
        if name in BASES:
            continue
        body = [*node.body, *(member for base in node.bases for member in CLASSES[base.id].body)]
        stub = {name: kind for name, kind in members_of_stub(body).items() if not SILENT.match(name)}
        assert stub == members_of_class(getattr(_core, name)), name
        count += len(stub)
    assert count > 150


def test_the_package_is_typed():
    assert (Path(waywright.__file__).parent / "py.typed").exists()
