#!/usr/bin/env python3
"""Generates from bindings/structs.toml the structs that cross languages: see there.

usage: make_structs.py [--check]

With --check, prints the files that differ from what the table says, and exits 1 if there are any.
"""

import re
import sys
import textwrap
import tomllib
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NOTE = "Made by scripts/make_structs.py from bindings/structs.toml. Do not edit."
WIDTH = 120


@dataclass(frozen=True)
class Type:
    """How each language writes a type. In the texts, {} is the value; {at} is an address in the memory of the module."""

    c: str
    to_cpp: str  # from C
    to_c: str
    ts: str
    copy: str  # of a value of the caller, in TypeScript
    put: str
    get: str
    python: str  # the type of an argument of the Python package
    stub: str
    default_c: str = "{}"


TYPES = {
    "bool": Type("ww_bool", "is_set({})", "to_c({})", "boolean", "toFlag({}, '{name}')", "put.flag({at}, {})",
                 "get.flag({at})", "bool", "bool"),
    "double": Type("double", "{}", "{}", "number", "toNumber({}, '{name}')", "put.float({at}, {})", "get.float({at})",
                   "double", "float"),
    "uint32": Type("uint32_t", "{}", "{}", "number", "toSize({})", "put.size({at}, {})", "get.size({at})",
                   "std::uint32_t", "int"),
    "size": Type("size_t", "{}", "{}", "number", "toSize({})", "put.size({at}, {})", "get.size({at})", "std::size_t", "int"),
    "count": Type("uint64_t", "{}", "{}", "number", "toLong({}, '{name}')", "put.long({at}, {})", "get.long({at})",
                  "std::uint64_t", "int"),
    # A number of things that may be unlimited: SIZE_MAX in C, Infinity in JavaScript, None in Python.
    "limit": Type("size_t", "{}", "{}", "number", "toLimit({})", "put.size({at}, {})", "getLimit({at})",
                  "std::optional<std::size_t>", "int | None"),
    "expansions": Type("uint64_t", "to_expansions({})", "{}", "number", "toExpansions({})", "put.long({at}, {})",
                       "get.long({at})", "std::optional<std::size_t>", "int | None"),
    "nanoseconds": Type("int64_t", "std::chrono::nanoseconds({})", "{}.count()", "number", "toNanoseconds({})",
                        "put.long({at}, {})", "get.long({at})", "std::optional<double>", "float | None"),
    "Point": Type("ww_point", "to_cpp({})", "to_c({})", "Point", "copyPoint({})", "writePoint({at}, {})",
                  "readPoint({at})", "Point", "PointLike"),
    "Box": Type("ww_box", "to_cpp({})", "to_c({})", "Box", "copyBox({})", "writeBox({at}, {})", "readBox({at})",
                "Box", "BoxLike"),
    "points": Type("const ww_point*", "", "", "Points", "flatten({})", "putPoints({at}, {count_at}, {})", "",
                   "PointsArg", "ArrayLike"),
    "id": Type("ww_id", "to_id({})", "to_c({})", "ItemId", "toId({})", "put.long({at}, {})", "idAt({at})", "ItemId", "int"),
    "text": Type("const char*", "std::string(text_or_empty({}))", "", "string", "encode({})", "putText({at}, {})", "",
                 "const std::string&", "str"),
    # Lists of ids and texts in answers are parameters of their own in C.
    "list": Type("", "", "", "string", "", "", "", "", "str"),
    "ids": Type("", "", "", "readonly ItemId[]", "", "", "", "", "list[int]"),
}


def enum(c, cpp, last, ts, names):
    return Type(c, f"to_enum({{}}, {cpp}::{last})", f"static_cast<{c}>({{}})", ts, f"toEnum({names}, {{}})",
                "put.int({at}, {})", f"fromEnum({names}, get.int({{at}}))", cpp, ts)


TYPES["PathAlgorithm"] = enum("ww_path_algorithm", "PathAlgorithm", "optimal", "PathAlgorithm", "PATH_ALGORITHMS")
TYPES["PathStatus"] = enum("ww_path_status", "PathStatus", "no_path", "PathStatus", "PATH_STATUSES")
TYPES["SvgTheme"] = enum("ww_svg_theme", "SvgTheme", "dark", "SvgTheme", "SVG_THEMES")
TYPES["PieceKind"] = enum("ww_piece_kind", "PathPiece::Kind", "arc", "PieceKind", "PIECE_KINDS")

# The defaults of queries: in C, TypeScript and the arguments and stubs of Python.
DEFAULTS = {
    "true": ("1", "true", "true", "True"),
    "false": ("0", "false", "false", "False"),
    "0.0": ("0.0", "0", "0.0", "0.0"),
    "0": ("0", "0", "py::none()", "None"),
    "{}": ("{}", "{}", "{}", "..."),
    "infinity": ("std::numeric_limits<double>::infinity()", "Infinity", "std::numeric_limits<double>::infinity()", "..."),
    "no_limit": ("std::numeric_limits<std::int64_t>::max()", "Infinity", "py::none()", "None"),
    "1200.0": ("1200.0", "1200", "1200.0", "1200.0"),
    "automatic": ("WW_SVG_AUTOMATIC", "'automatic'", "SvgTheme::automatic", '"automatic"'),
    "no_text": ("nullptr", "''", '""', '""'),
    "optimal": ("WW_ALGORITHM_OPTIMAL", "'optimal'", "PathAlgorithm::optimal", '"optimal"'),
    "kNoVertexLimit": ("kNoVertexLimit", "Infinity", "py::none()", "None"),
}


def snake(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def camel(name):
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def sentence(text):
    return text[0].upper() + text[1:].rstrip(".") + "."


class Field:
    def __init__(self, struct, given):
        self.struct, self.name, self.doc = struct, given["name"], given["doc"]
        self.is_list = given["type"] in ("ids", "list")
        self.is_optional = given["type"].endswith("?")
        self.type_name = given["type"].removesuffix("?")
        self.type = TYPES[self.type_name]
        self.default = given.get("default")
        self.cpp = given.get("cpp", self.name)
        self.is_own = given.get("own", False)
        self.is_single = given.get("single", False)
        self.python_name = given.get("names", {}).get("py", self.name)
        self.is_in_python = "py" not in given.get("hidden", [])
        self.is_required_in_python = "py" in given.get("required", [])
        self.camel = camel(self.name)

    def fill(self, text, value, at=""):
        layout = f"layout.{self.camel}"
        count_at = f"struct + layout.{camel(self.name.removesuffix('s'))}Count"
        return text.format(value, at=at or f"struct + {layout}", name=self.camel, count_at=count_at)

    @property
    def default_in_python(self):
        if self.is_own or self.is_required_in_python:
            return None
        if self.is_optional:
            return "py::none()", "None"
        cpp, stub = DEFAULTS[self.default][2:]
        return (f"{self.type.python}{{}}" if cpp == "{}" else cpp), stub


class Struct:
    def __init__(self, name, given):
        self.name, self.kind, self.doc = name, given["kind"], given["doc"]
        self.cpp = given.get("cpp", name)
        self.c = f"ww_{snake(name)}"
        self.hidden = given.get("hidden", [])
        self.fields = [Field(self, each) for each in given["fields"]]
        named = [re.match(r"\w+(?!\w*\(\))", field.cpp) for field in self.fields]  # not a function: `total()`
        self.members = list(dict.fromkeys([match[0] for match in named if match] + given.get("also", [])))
        self.has_size = self.kind in ("query", "answer")

    def is_in(self, language):
        return language not in self.hidden

    @property
    def options(self):
        return [field for field in self.fields if not field.is_own]


def load(table):
    structs = []
    for name, given in tomllib.loads(table).items():
        if given["kind"] in ("value", "element"):
            c = f"ww_{snake(name)}"
            TYPES[name] = Type(c, "to_cpp({})", "to_c({})", name, f"copy{name}({{}})", f"put{name}({{at}}, {{}})",
                               f"read{name}({{at}})", name, name)
        structs.append(Struct(name, given))
    return structs


def comment(text, indent, opening="/* ", closing=" */", further="   "):
    lines = textwrap.wrap(text, WIDTH - len(indent) - len(opening) - len(closing))
    return [indent + (opening if i == 0 else further) + line + (closing if i == len(lines) - 1 else "")
            for i, line in enumerate(lines)]


# ----------------------------------------------------------------------------------------------------------------------
# C


def members_in_c(field):
    """Yields the members of a struct in C for a field: declarations and defaults. Lists of ids are parameters in C."""
    if field.is_list:
        return
    if field.is_optional:
        yield f"ww_bool has_{field.name}", f"has_{field.name}", "0", f"whether `{field.name}` is set"
    default = "{}" if field.is_optional or field.default is None else DEFAULTS[field.default][0]
    default = {"points": "nullptr"}.get(field.type_name, default)
    yield f"{field.type.c} {field.name}", field.name, default, field.doc
    if field.type_name == "points":
        singular = field.name.removesuffix("s")
        yield f"size_t {singular}_count", f"{singular}_count", "0", f"the number of {field.name}"


def struct_in_c(struct):
    lines = comment(sentence(struct.doc), "") + [f"typedef struct {struct.c} {{"]
    if struct.has_size:
        lines.append("  uint32_t struct_size;")
    members = [(f"  {declaration};", doc) for field in struct.fields for declaration, _, _, doc in members_in_c(field)]
    column = max((len(declaration) for declaration, _ in members), default=0)
    if all(column + len(f" /* {doc} */") <= WIDTH for _, doc in members):
        lines += [f"{declaration:{column}} /* {doc} */" for declaration, doc in members]
    else:
        for declaration, doc in members:
            lines += [*comment(doc, "  "), declaration]
    return "\n".join([*lines, f"}} {struct.c};"])


def make_c_header(structs, text):
    for struct in structs:
        if not struct.is_in("c"):
            continue
        pattern = rf"(?:^/\*(?:(?!\*/).)*?\*/\n)?^typedef struct {struct.c} {{$.*?^}} {struct.c};"
        text, count = re.subn(pattern, lambda _, made=struct_in_c(struct): made, text, flags=re.MULTILINE | re.DOTALL)
        if count != 1:
            sys.exit(f"make_structs.py: bindings/c/waywright.h has {count} structs {struct.c}; write an empty one first")
    return text


def to_cpp_in_c(struct):
    lines = [f"inline {struct.cpp} to_cpp(const {struct.c}& given) {{", f"  {struct.cpp} result{{}};"]
    for field in struct.fields:
        if field.type_name == "points":
            lines.append(f"  result.{field.cpp} = to_points(given.{field.name}, given.{field.name.removesuffix('s')}_count);")
            continue
        line = f"result.{field.cpp} = {field.type.to_cpp.format('given.' + field.name)};"
        lines.append(f"  if (is_set(given.has_{field.name})) {line}" if field.is_optional else f"  {line}")
    return [*lines, "  return result;", "}"]


def to_c_in_c(struct):
    lines = [f"inline {struct.c} to_c(const {struct.cpp}& given) {{", f"  {struct.c} result{{}};"]
    for field in struct.fields:
        if field.is_list:
            continue
        if field.is_optional:
            lines.append(f"  result.has_{field.name} = to_c(given.{field.cpp}.has_value());")
            lines.append(f"  if (given.{field.cpp}) result.{field.name} = {field.type.to_c.format('*given.' + field.cpp)};")
        else:
            lines.append(f"  result.{field.name} = {field.type.to_c.format('given.' + field.cpp)};")
    return [*lines, "  return result;", "}"]


def make_c_conversions(structs):
    lines = ["#pragma once", "", "// " + NOTE, "", "#include <chrono>", "#include <cstdint>", "#include <limits>", "",
             '#include "internal.hpp"', "", "// clang-format off", "", "namespace waywright::c {"]
    for struct in structs:
        if not struct.is_in("c"):
            continue
        names = ", ".join(f"m{i}" for i in range(len(struct.members)))
        lines += ["", f"// {struct.name}. If it has members that the table lacks, this function does not compile."]
        lines.append(f"inline void check_members(const {struct.cpp}& given) {{")
        lines.append(f"  [[maybe_unused]] const auto& [{names}] = given;")
        lines += [*(f"  static_cast<void>(given.{member});" for member in struct.members), "}"]
        if struct.kind == "query":
            lines.append(f"inline constexpr {struct.c} kDefault{struct.name}{{")
            members = [(name, default) for field in struct.fields for _, name, default, _ in members_in_c(field)]
            lines += [f"    .{name} = {default}," for name, default in [("struct_size", f"sizeof({struct.c})"), *members]]
            lines.append("};")
        if struct.kind in ("value", "query") or struct.name == "PathPosition":
            lines += to_cpp_in_c(struct)
        if struct.name == "Agent":
            lines.append("/// Reads an agent that may be null: then it is a point.")
            lines.append("inline Agent to_cpp(const ww_agent* given) { return given != nullptr ? to_cpp(*given) : Agent{}; }")
        if struct.kind != "query" or struct.name == "WorldOptions":
            lines += to_c_in_c(struct)
    return "\n".join([*lines, "", "}  // namespace waywright::c", ""])


# ----------------------------------------------------------------------------------------------------------------------
# Python


def is_by_name(field):
    """Whether an argument can only be given by its name: all but the agent and the algorithm."""
    return field.name not in ("agent", "algorithm")


def arguments_of(struct, fields, type_of):
    """The parameters, names and pybind11 arguments of a function of Python with the fields of a query."""
    fields = [field for field in fields if not is_by_name(field)] + [field for field in fields if is_by_name(field)]
    parameters, arguments, has_star = [], [], False
    for field in fields:
        if is_by_name(field) and not has_star:
            arguments.append("py::kw_only()")
            has_star = True
        parameters.append(f"{type_of(field)} {field.python_name}")
        default = field.default_in_python
        arguments.append(f'py::arg("{field.python_name}")' + (f" = {default[0]}" if default else ""))
    return ", ".join(parameters), ", ".join(field.python_name for field in fields), ", ".join(arguments)


def python_type(field):
    if field.is_optional:
        return f"std::optional<{field.type.python}>"
    return f"const {field.type.python}&" if field.type_name in ("Agent", "points") else field.type.python


def set_in_python(struct):
    budgets = [field for field in struct.fields if field.cpp.startswith("budget.")]
    lines = []
    for field in struct.options:
        if field in budgets:
            continue
        value = field.python_name
        if field.type_name == "limit":
            value = f"{value}.value_or({field.default})"
        lines.append(f"  result.{field.cpp} = {value};")
    if budgets:
        lines.append(f"  set_budget(result.budget, {', '.join(field.python_name for field in budgets)});")
    return lines


def properties_in_python(struct):
    lines = [f"/// Adds the members of {struct.name} and their pickle to its class.",
             f"inline void bind_members(py::class_<{struct.cpp}>& cls) {{", "  cls"]
    for field in struct.fields:
        if field.is_in_python:
            lines += [f'      .def_property_readonly("{field.python_name}", [](const {struct.cpp}& self) {{ return self.{field.cpp}; }},',
                      f'                             R"({sentence(field.doc.replace("`", "``"))})")']
    state = ", ".join(f"bytes_of(self.{f.cpp})" if f.type_name == "ids" else f"self.{f.cpp}" for f in struct.fields)
    lines.append(f"      .def(py::pickle([](const {struct.cpp}& self) {{ return py::make_tuple({state}); }},")
    lines.append("                      [](const py::tuple& state) {")
    lines.append(f'                        if (state.size() != {len(struct.fields)}) throw py::value_error("the pickle is damaged");')
    lines.append(f"                        {struct.cpp} result;")
    for i, field in enumerate(struct.fields):
        value = (f"from_bytes<ItemId>(state[{i}].cast<py::bytes>())" if field.type_name == "ids"
                 else f"state[{i}].cast<decltype(result.{field.cpp})>()")
        lines.append(f"                        result.{field.cpp} = {value};")
    return [*lines, "                        return result;", "                      }));", "}"]


def dict_in_python(struct):
    lines = [f"/// Returns the members of {struct.name} by name.", f"inline py::dict to_dict(const {struct.cpp}& given) {{", "  py::dict result;"]
    for field in struct.fields:
        value = f"given.{field.cpp}"
        if field.type_name == "limit":
            value = f"{value} == {field.default} ? py::object(py::none()) : py::object(py::int_({value}))"
        lines.append(f'  result["{field.python_name}"] = {value};')
    return [*lines, "  return result;", "}"]


def make_python(structs):
    lines = ["#pragma once", "", "// " + NOTE, "", "#include <limits>", "#include <optional>", "",
             '#include "convert.hpp"', '#include "path.hpp"', "", "// clang-format off", "", "namespace waywright::python {"]
    for struct in structs:
        if not struct.is_in("py") or struct.kind == "element":
            continue
        lines.append("")
        if struct.name in ("WorldOptions", "MemoryUse"):
            lines += dict_in_python(struct)
        elif struct.kind != "query":
            lines += properties_in_python(struct)
        if struct.kind == "answer":
            continue
        prefix = f"WAYWRIGHT_{snake(struct.name).upper()}"
        own = [field for field in struct.fields if field.is_own]
        parameters, names, arguments = arguments_of(struct, struct.options, python_type)
        lines += [f"// The options of {struct.name} as parameters, as names, and as arguments of pybind11.",
                  f"#define {prefix}_PARAMETERS {parameters}", f"#define {prefix}_NAMES {names}",
                  f"#define {prefix}_ARGUMENTS {arguments}"]
        if struct.name == "PathQuery":  # a batch has one agent for each query
            each = [field for field in struct.options if not field.is_single]
            parameters, _, arguments = arguments_of(
                struct, each, lambda field: "const AgentsArg&" if field.name == "agent" else python_type(field))
            others = {field.python_name: field.default_in_python[0] for field in struct.options if field not in each}
            names = ", ".join({"agent": "Agent{}", **others}.get(name, name) for name in names.split(", "))
            lines += ["// The same for a batch: it has one agent for all queries or one for each.",
                      f"#define {prefix}_BATCH_PARAMETERS {parameters}", f"#define {prefix}_BATCH_NAMES {names}",
                      f"#define {prefix}_BATCH_ARGUMENTS {arguments}"]
        mine = ", ".join(f"{python_type(field)} {field.name}" for field in own)
        lines.append(f"inline {struct.cpp} to_{snake(struct.name)}({mine}{', ' if own else ''}{prefix}_PARAMETERS) {{")
        lines.append(f"  {struct.cpp} result{{}};")
        lines += [f"  result.{field.cpp} = {field.name}{'.span()' if field.type_name == 'points' else ''};" for field in own]
        lines += [*set_in_python(struct), "  return result;", "}"]
    return "\n".join([*lines, "", "}  // namespace waywright::python", ""])


def stub_arguments(struct, indent, is_batch=False):
    fields = [field for field in struct.options if not (is_batch and field.is_single)]
    fields = [field for field in fields if not is_by_name(field)] + [field for field in fields if is_by_name(field)]
    lines, has_star = [], False
    for field in fields:
        if is_by_name(field) and not has_star:
            lines.append(f"{indent}*,")
            has_star = True
        stub = "Agents" if is_batch and field.name == "agent" else field.type.stub
        stub += " | None" if field.is_optional else ""
        default = field.default_in_python
        lines.append(f"{indent}{field.python_name}: {stub}" + (f" = {default[1]}," if default else ","))
    return lines


STUBS_OF_ANSWERS = {"Point": "Pair", "Box": "Bounds"}


def stub_members(struct, indent):
    for field in struct.fields:
        if field.is_in_python:
            stub = STUBS_OF_ANSWERS.get(field.type_name, field.type.stub)
            yield f"{indent}@property"
            yield f"{indent}def {field.python_name}(self) -> {stub}: ..."


MARKER = re.compile(r"^( *)# begin (\w+)( batch| arguments)?$.*?^\1# end$", re.MULTILINE | re.DOTALL)


def make_stubs(structs, text):
    by_name = {struct.name: struct for struct in structs}

    def made(match):
        indent, name, form = match.groups()
        struct = by_name[name]
        has_arguments = struct.kind == "query" or form
        lines = stub_arguments(struct, indent, form == " batch") if has_arguments else stub_members(struct, indent)
        return "\n".join([f"{indent}# begin {name}{form or ''}", *lines, f"{indent}# end"])

    return MARKER.sub(made, text)


# ----------------------------------------------------------------------------------------------------------------------
# TypeScript


def interface(name, fields, doc, is_query, base=""):
    lines = comment(sentence(doc), "", "/** ", " */", " * ") if doc else []
    if len(lines) > 1:
        lines = ["/**", *(" * " + line for line in textwrap.wrap(sentence(doc), WIDTH - 3)), " */"]
    lines.append(f"export interface {name}{base} {{")
    for field in fields:
        text = sentence(re.sub(r"`([a-z_]+)`", lambda match: f"`{camel(match[1])}`", field.doc))
        one = f"  /** {text} */"
        lines += [one] if len(one) <= 128 else ["  /**", *("   * " + line for line in textwrap.wrap(text, WIDTH - 5)), "   */"]
        if is_query:
            mark = "?" if field.is_optional or field.default is not None else ""
            lines.append(f"  readonly {field.camel}{mark}: {field.type.ts};")
        else:
            lines.append(f"  readonly {field.camel}: {required(field)}{' | null' if field.is_optional else ''};")
    return [*lines, "}"]


def required(field):
    return f"Required<{field.type.ts}>" if field.type_name == "Agent" else field.type.ts


def copy_in_ts(name, fields, what):
    """The function that copies an object of the caller: it reads each member once, and checks it."""
    lines = ["", f"/** Returns a copy of {what} that a caller has given. */", f"export function copy{name}(given: {name}) {{"]
    defaults = [f"{f.camel} = {DEFAULTS[f.default][1]}" if f.default is not None else f.camel for f in fields]
    lines.append(f"  const {{ {', '.join(defaults)} }} = toObject(given, '{what}');")
    lines.append("  return {")
    for field in fields:
        value = field.fill(field.type.copy, field.camel)
        lines.append(f"    {field.camel}: " + (f"{field.camel} === undefined ? null : {value}," if field.is_optional else f"{value},"))
    return [*lines, "  };", "}"]


def put_in_ts(fields, value):
    lines = []
    for field in fields:
        given = f"{value}.{field.camel}"
        put = field.fill(field.type.put, given)
        if field.is_optional:
            has = f"put.flag(struct + layout.{camel('has_' + field.name)}, true);"
            lines += [f"  if ({given} !== null) {{", f"    {has}", f"    {put};", "  }"]
        else:
            lines.append(f"  {put};")
    return lines


def query_in_ts(struct):
    own = [field for field in struct.fields if field.is_own]
    lines, name = [], struct.name
    if struct.name == "PathQuery":
        lines += interface("PathOptions", struct.options, "The options of a path query: everything except its start and goal.", True)
        lines += interface(name, own, struct.doc, True, " extends PathOptions")
        lines += copy_in_ts("PathOptions", struct.options, "a query")
        lines += copy_in_ts(name, struct.fields, "a query")
    else:
        lines += interface(name, struct.fields, struct.doc, True)
        lines += copy_in_ts(name, struct.fields, "the options" if name.endswith("Options") else "a query")
    lines += ["", "/** Writes a copy to a struct of the module. */"]
    kind = "PathOptions" if struct.name == "PathQuery" else name
    lines.append(f"export function pack{kind}(copy: ReturnType<typeof copy{kind}>): number {{")
    lines += [f"  const {{ {struct.c}: layout }} = abi;", "  const struct = scratch.struct2;",
              f"  check(lib.{struct.c}_init(struct, layout.size_));"]
    lines += put_in_ts(struct.options if struct.name == "PathQuery" else struct.fields, "copy") + ["  return struct;", "}"]
    if struct.name == "PathQuery":
        lines += ["", "export function packPathQuery(copy: ReturnType<typeof copyPathQuery>): number {",
                  f"  const {{ {struct.c}: layout }} = abi;", "  const struct = packPathOptions(copy);",
                  *put_in_ts(own, "copy"), "  return struct;", "}"]
    return lines + (read_in_ts(struct, f"Required<{name}>") if name == "WorldOptions" else [])


def answer_in_ts(struct):
    lines = interface(struct.name, struct.fields, struct.doc, struct.name == "Agent")
    if struct.name == "Agent":
        lines += copy_in_ts("Agent", struct.fields, "an agent")
        lines += ["", "export function putAgent(struct: number, copy: Required<Agent>): number {",
                  f"  const {{ {struct.c}: layout }} = abi;", *put_in_ts(struct.fields, "copy"), "  return struct;", "}"]
    return lines + read_in_ts(struct, "Required<Agent>" if struct.name == "Agent" else struct.name)


def read_in_ts(struct, result):
    lists = [field for field in struct.fields if field.is_list]
    more = "".join(f", {field.camel}: {field.type.ts}" for field in lists)
    lines = ["", f"export function read{struct.name}(struct: number{more}): {result} {{",
              f"  const {{ {struct.c}: layout }} = abi;", "  return {"]
    for field in struct.fields:
        if field in lists:
            lines.append(f"    {field.camel},")
        elif field.is_optional:
            has = f"get.flag(struct + layout.{camel('has_' + field.name)})"
            lines.append(f"    {field.camel}: {has} ? {field.fill(field.type.get, '')} : null,")
        else:
            lines.append(f"    {field.camel}: {field.fill(field.type.get, '')},")
    return [*lines, "  };", "}"]


def make_ts(structs):
    body = []
    for struct in structs:
        if struct.is_in("js"):
            body += ["", *(query_in_ts(struct) if struct.kind == "query" else answer_in_ts(struct))]
    text = "\n".join(body) + "\n"
    lines = ["// " + NOTE, ""]
    for module, names in (
        ("buffers", ["copyPoint", "flatten", "Point", "Points", "toSize"]),
        ("enums", ["PATH_ALGORITHMS", "PATH_STATUSES", "PathAlgorithm", "PathStatus", "PIECE_KINDS", "PieceKind", "SVG_THEMES", "SvgTheme"]),
        ("errors", ["toFlag", "toNumber", "toObject"]),
        ("limits", ["getLimit", "toExpansions", "toLimit", "toNanoseconds"]),
        ("runtime", ["check", "encode", "idAt", "lib", "scratch"]),
        ("values", ["Box", "copyBox", "fromEnum", "get", "ItemId", "put", "putPoints", "putText", "readBox", "readPoint", "toEnum", "toLong",
                    "writeBox", "writePoint"]),
    ):
        used = [name for name in names if re.search(rf"\b{name}\b", text)]
        types = {"Point", "Points", "Box", "ItemId", "PathAlgorithm", "PathStatus", "PieceKind", "SvgTheme"}
        names = ", ".join(("type " if name in types else "") + name for name in used)
        if names:
            lines.append(f"import {{ {names} }} from './{module}.js';")
        if module == "errors":
            lines.append("import * as abi from './generated/abi.js';")
    return "\n".join(lines) + "\n" + text


# ----------------------------------------------------------------------------------------------------------------------


def make(structs):
    """Yields (file, text) for each generated file."""
    for name, edit in (("bindings/c/waywright.h", make_c_header), ("bindings/python/waywright/_core.pyi", make_stubs)):
        yield name, edit(structs, (ROOT / name).read_text(encoding="utf-8"))
    yield "bindings/c/structs.hpp", make_c_conversions(structs)
    yield "bindings/python/src/structs.hpp", make_python(structs)
    yield "bindings/wasm/src/structs.ts", make_ts(structs)


def main(arguments):
    differ = []
    for name, text in make(load((ROOT / "bindings/structs.toml").read_text(encoding="utf-8"))):
        path = ROOT / name
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        differ.append(name)
        if arguments != ["--check"]:
            path.write_text(text, encoding="utf-8")
    for name in differ if arguments == ["--check"] else ():
        print(f"{name}: bindings/structs.toml says something else; run scripts/make_structs.py")
    return 1 if differ and arguments == ["--check"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
