"""From the instance tree to the FlatModel: every variable and equation as scalars, connections resolved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from acausal.errors import AcausalError, Span, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean, as_scalar, as_value, type_error
from acausal.lang.connections import ConnectionSets, connect, connection_equations
from acausal.lang.flat import (
    REAL,
    Assertion,
    Causality,
    Equation,
    Experiment,
    FlatModel,
    Origin,
    StateSelect,
    Variability,
    Variable,
)
from acausal.lang.instance import Absent, Array, Connection, Instance, Leaf, Member, leaves
from acausal.lang.modifiers import Binding, Context
from acausal.lang.printer import print_expression
from acausal.lang.references import EnumerationLiteralFound, Selection, resolve
from acausal.lang.scope import Scope
from acausal.lang.translate import Env, Translator
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value, assignable, describe, unify
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import EnumValue, Expr

MAX_EQUATIONS = 5_000_000


class _Flattener:
    """Collects equations while walking the instance tree; one per compilation."""

    def __init__(self, translator: Translator, root: Instance) -> None:
        self.translator = translator
        self.root = root
        self.equations: list[Equation] = []
        self.initial: list[Equation] = []
        self.assertions: list[Assertion] = []
        self.sets = ConnectionSets()

    # ------------------------------------------------------------------ components

    def run(self) -> None:
        """Equations of all components, depth first, a component's own before its parts'."""
        stack: list[Member] = [self.root]
        while stack:
            member = stack.pop()
            if isinstance(member, Array):
                stack.extend(reversed(member.items))
            elif isinstance(member, Instance):
                self._component(member)
                stack.extend(m for m in reversed(member.members.values()) if not isinstance(m, Leaf))
            if len(self.equations) > MAX_EQUATIONS:
                raise type_error(
                    "flat.too-large", f"the model has more than {MAX_EQUATIONS} equations", self.root.scope.span
                )

    def _component(self, instance: Instance) -> None:
        for section, scope in instance.scope.table.sections:
            env = Env(Context(scope, instance))
            if isinstance(section, ast.AlgorithmSection):
                raise fail(
                    UnsupportedProblem,
                    "unsupported.algorithm",
                    f"an algorithm section in `{scope.path}` is not supported yet (functions have theirs)",
                    section.span,
                    hint="write equations, or put the algorithm into a function",
                )
            target = self.initial if section.initial else self.equations
            for equation in section.equations:
                self._equation(equation, env, target)

    # ------------------------------------------------------------------ equations

    def _equation(self, node: ast.Equation, env: Env, target: list[Equation]) -> None:
        if isinstance(node, ast.EqualEquation):
            self._equal(node, env, target)
        elif isinstance(node, ast.ConnectEquation):
            self._connect(node, env)
        elif isinstance(node, ast.ForEquation):
            for inner in self.translator.iterate(node.iterators, env):
                for equation in node.body:
                    self._equation(equation, inner, target)
        elif isinstance(node, ast.IfEquation):
            self._if(node, env, target)
        elif isinstance(node, ast.CallEquation):
            self._call(node, env)
        else:
            raise fail(
                UnsupportedProblem,
                "unsupported.when",
                "`when` equations are not supported yet",
                node.span,
                hint="use `if` for what switches continuously; discrete events come in a later version",
            )

    def _equal(self, node: ast.EqualEquation, env: Env, target: list[Equation]) -> None:
        if isinstance(node.left, ast.Tuple):
            self._multiple_results(node, node.left, env, target)
            return
        left = self.translator.value(node.left, env)
        right = self.translator.value(node.right, env)
        target += self._scalars(left, right, node.span, env, Origin.EQUATION)

    def _multiple_results(
        self, node: ast.EqualEquation, left: ast.Tuple, env: Env, target: list[Equation]
    ) -> None:
        from acausal.lang.functions import call_function

        if not isinstance(node.right, ast.Call):
            raise type_error("type.tuple", "only a function call has several results", node.span)
        scope = env.context.scope.find_class(node.right.function)
        results = call_function(self.translator, scope, node.right, env)
        if len(left.items) > len(results):
            raise type_error("call.results", f"`{scope.path}` has only {len(results)} result(s)", node.span)
        for item, result in zip(left.items, results, strict=False):
            if item is not None:
                target += self._scalars(self.translator.value(item, env), result, node.span, env, Origin.EQUATION)

    def _scalars(self, left: AnyValue, right: AnyValue, span: Span, env: Env, origin: Origin) -> list[Equation]:
        component = env.context.instance.path if env.context.instance is not None else ""
        pairs = match_values(left, right, span)
        return [Equation(a, b, span, component, origin) for a, b in pairs]

    # ------------------------------------------------------------------ if

    def _if(self, node: ast.IfEquation, env: Env, target: list[Equation]) -> None:
        branches: list[tuple[Expr, tuple[ast.Equation, ...]]] = []
        otherwise = node.otherwise
        for condition, body in node.branches:
            test = as_boolean(self.translator.value(condition, env), condition.span)
            known = self._decide(test, condition.span)
            if known is None:
                branches.append((test, body))
            elif known:
                otherwise = body
                break
        if not branches:
            for equation in otherwise:
                self._equation(equation, env, target)
            return
        self._conditional(branches, otherwise, env, target, node.span)

    def _decide(self, test: Expr, span: Span) -> bool | None:
        """The value of a condition on parameters, which makes them structural; None for any other."""
        try:
            evaluate(test, self.translator.parameter_value)
        except NotConstant:
            return None
        except EvaluationFailed:
            pass
        return bool(self.translator.evaluate_expr(test, span, "the condition of this if-equation"))

    def _conditional(
        self,
        branches: Sequence[tuple[Expr, tuple[ast.Equation, ...]]],
        otherwise: tuple[ast.Equation, ...],
        env: Env,
        target: list[Equation],
        span: Span,
    ) -> None:
        bodies: list[list[Equation]] = []
        for k, (_, body) in enumerate(branches):
            guard = ex.logical_and(*[ex.logical_not(t) for t, _ in branches[:k]], branches[k][0])
            bodies.append(self._branch(body, env, guard))
        guard = ex.logical_and(*[ex.logical_not(t) for t, _ in branches])
        bodies.append(self._branch(otherwise, env, guard))
        if len({len(b): None for b in bodies}) > 1:
            counts = ", ".join(str(len(b)) for b in bodies)
            raise type_error(
                "if.unbalanced",
                f"the branches of this if-equation have {counts} equations; they must have the same number",
                span,
                "add the missing equations (also an else branch), or make the condition depend on parameters only",
            )
        for row in zip(*bodies, strict=True):
            target.append(_merge_branches([t for t, _ in branches], row, span))

    def _branch(self, body: Sequence[ast.Equation], env: Env, guard: Expr) -> list[Equation]:
        found: list[Equation] = []
        before = len(self.assertions)
        for equation in body:
            if isinstance(equation, ast.ConnectEquation):
                raise type_error(
                    "if.connect",
                    "`connect` in an if-equation needs a condition known at compile time",
                    equation.span,
                    "make the condition depend on parameters only",
                )
            self._equation(equation, env, found)
        for k in range(before, len(self.assertions)):
            assertion = self.assertions[k]
            self.assertions[k] = replace(
                assertion, condition=ex.logical_or(ex.logical_not(guard), assertion.condition)
            )
        return found

    # ------------------------------------------------------------------ connect and assert

    def _connect(self, node: ast.ConnectEquation, env: Env) -> None:
        instance = env.context.instance
        assert instance is not None
        left = self._connector(node.left, env, instance)
        right = self._connector(node.right, env, instance)
        a, b = left[0], right[0]
        if len(a) != len(b) or left[2] != right[2]:
            raise type_error(
                "connect.mismatch",
                f"`{print_expression(node.left)}` and `{print_expression(node.right)}` have different sizes",
                node.span,
                "",
                (node.left.text, node.right.text),
            )
        for x, y in zip(a, b, strict=True):
            connect(self.sets, (x, left[1]), (y, right[1]), node.span, instance.path)

    def _connector(
        self, node: ast.ComponentReference, env: Env, instance: Instance
    ) -> tuple[tuple[Member, ...], bool, tuple[int, ...]]:
        found = resolve(self.translator, node, env)
        if isinstance(found, (Scope, EnumerationLiteralFound)) or not isinstance(found, Selection):
            raise type_error(
                "connect.not-a-connector", f"`{node.text}` is not a connector", node.span, "", (node.text,)
            )
        first = instance.members[node.parts[0].name]
        kind = first.items[0] if isinstance(first, Array) and first.items else first
        own = isinstance(kind, Leaf) or (isinstance(kind, Instance) and kind.is_connector)
        members = found.members
        if not found.shape and isinstance(members[0], Array):
            return members[0].items, not own, members[0].shape
        return members, not own, found.shape

    def _call(self, node: ast.CallEquation, env: Env) -> None:
        name = node.call.function.text
        if name != "assert":
            raise fail(
                UnsupportedProblem,
                "unsupported.call-equation",
                f"`{name}(...)` as an equation is not supported yet",
                node.span,
                names=[name],
            )
        arguments = dict(zip(("condition", "message", "level"), node.call.arguments, strict=False))
        arguments |= {named.name: named.value for named in node.call.named}
        if "condition" not in arguments or "message" not in arguments:
            raise type_error("call.arguments", "`assert` needs a condition and a message", node.span)
        condition = as_boolean(self.translator.value(arguments["condition"], env), node.span)
        level = "error"
        if "level" in arguments:
            found = self.translator.evaluate_in(arguments["level"], env, "the level of an assertion")
            level = found.literal if isinstance(found, EnumValue) else "error"
        component = env.context.instance.path if env.context.instance is not None else ""
        message = self._message(arguments["message"], env)
        self.assertions.append(Assertion(condition, ex.const(message), level, node.span, component))

    def _message(self, node: ast.Expression, env: Env) -> str:
        """The text of an assertion; one that is computed at run time is shown as it is written."""
        try:
            value = as_scalar(self.translator.value(node, env), node.span).item.value
        except AcausalError:
            return print_expression(node)
        return value if isinstance(value, str) else print_expression(node)

    # ------------------------------------------------------------------ variables

    def variables(self) -> list[Variable]:
        """All scalars in order of declaration; bindings of variables become equations."""
        found: list[Variable] = []
        for leaf in leaves(self.root):
            self.translator.leaves.setdefault(leaf.path, leaf)
            found.append(self._variable(leaf))
        return found

    def _variable(self, leaf: Leaf) -> Variable:
        prefixes = leaf.prefixes
        binding = None if leaf.binding is None else self._binding(leaf, leaf.binding)
        if binding is not None and leaf.binding is not None and prefixes.variability > Variability.PARAMETER:
            component = leaf.path.rpartition(".")[0]
            self.equations.append(Equation(ex.sym(leaf.path), binding, leaf.binding.span, component, Origin.BINDING))
            binding = None
        attributes = {name: self._attribute(leaf, name, b) for name, b in leaf.attributes.items()}
        text = {n: str(self._constant(leaf, n, attributes.get(n)) or "") for n in ("unit", "displayUnit", "quantity")}
        fixed = self._constant(leaf, "fixed", attributes.get("fixed"))
        select = self._constant(leaf, "stateSelect", attributes.get("stateSelect"))
        top = "." not in _without_subscripts(leaf.path)
        return Variable(
            name=leaf.path,
            type=leaf.type,
            variability=prefixes.variability,
            span=leaf.span,
            causality=prefixes.causality if top else Causality.LOCAL,
            binding=binding,
            start=attributes.get("start"),
            fixed=None if fixed is None else bool(fixed),
            nominal=attributes.get("nominal"),
            min=attributes.get("min"),
            max=attributes.get("max"),
            unit=text["unit"],
            display_unit=text["displayUnit"],
            quantity=text["quantity"],
            state_select=StateSelect(select.index) if isinstance(select, EnumValue) else StateSelect.DEFAULT,
            flow=prefixes.connection is Connection.FLOW,
            protected=prefixes.protected,
            final=prefixes.final,
            structural=False,
            top_level=top,
            description=leaf.description,
        )

    def _binding(self, leaf: Leaf, binding: Binding) -> Expr:
        value = as_value(self.translator.binding_value(binding), binding.span)
        if value.shape:
            raise type_error(
                "type.array-size", f"`{leaf.path}` is a scalar, but its value is {describe(value)}", binding.span, "", (leaf.path,)
            )
        if not assignable(value.type, leaf.type):
            raise type_error(
                "type.mismatch",
                f"`{leaf.path}` is {leaf.type}, but its value is {describe(value)}",
                binding.span,
                "",
                (leaf.path,),
            )
        return value.item

    def _attribute(self, leaf: Leaf, name: str, binding: Binding) -> Expr:
        value = as_scalar(self.translator.binding_value(binding), binding.span)
        wanted = _ATTRIBUTE_TYPE.get(name, leaf.type.name)
        fits = value.type.name == wanted or (wanted == "Real" and value.type.name == "Integer")
        if not fits:
            raise type_error(
                "type.mismatch",
                f"the attribute `{name}` of `{leaf.path}` is {wanted}, but its value is {describe(value)}",
                binding.span,
                "",
                (leaf.path,),
            )
        return value.item

    def _constant(self, leaf: Leaf, name: str, item: Expr | None) -> object:
        if item is None:
            return None
        return self.translator.evaluate_expr(item, leaf.span, f"the attribute `{name}` of `{leaf.path}`")


_ATTRIBUTE_TYPE = {
    "unit": "String",
    "displayUnit": "String",
    "quantity": "String",
    "fixed": "Boolean",
    "unbounded": "Boolean",
    "stateSelect": "StateSelect",
    "nominal": "Real",
}


def _without_subscripts(path: str) -> str:
    head, bracket, _ = path.partition("[")
    return head if bracket and path.endswith("]") and "." not in path.partition("]")[2] else path


def _merge_branches(tests: Sequence[Expr], row: Sequence[Equation], span: Span) -> Equation:
    """One equation out of the corresponding ones of all branches."""
    first = row[0]
    if all(e.left is first.left for e in row):
        left, sides = first.left, [e.right for e in row]
    else:
        left, sides = ex.ZERO, [ex.sub(e.left, e.right) for e in row]
    right = sides[-1]
    for test, side in zip(reversed(tests), reversed(sides[:-1]), strict=True):
        right = ex.if_then_else(test, side, right)
    return Equation(left, right, span, first.component, first.origin)


def match_values(left: AnyValue, right: AnyValue, span: Span) -> list[tuple[Expr, Expr]]:
    """The scalar pairs of `left = right`. Raises `TypeProblem` when types or sizes differ."""
    if isinstance(left, RecordValue) and isinstance(right, RecordValue):
        if list(left.fields) != list(right.fields):
            raise type_error("type.mismatch", f"{describe(left)} is not compatible with {describe(right)}", span)
        return [p for n in left.fields for p in match_values(left.fields[n], right.fields[n], span)]
    if isinstance(left, RecordArray) and isinstance(right, RecordArray) and left.shape == right.shape:
        return [p for a, b in zip(left.items, right.items, strict=True) for p in match_values(a, b, span)]
    if not isinstance(left, Value) or not isinstance(right, Value) or unify(left.type, right.type) is None:
        raise type_error(
            "type.mismatch", f"the two sides are {describe(left)} and {describe(right)}", span, "both sides need one type"
        )
    if left.shape != right.shape:
        raise type_error(
            "type.array-size", f"the two sides have different sizes: {describe(left)} and {describe(right)}", span
        )
    return list(zip(left.items, right.items, strict=True))


def flatten(translator: Translator, root: Instance) -> FlatModel:
    """The FlatModel of a complete instance tree. Raises `TypeProblem`, `LookupProblem`, `UnsupportedProblem`."""
    work = _Flattener(translator, root)
    variables = work.variables()
    work.run()
    work.equations += connection_equations(work.sets, root)
    experiment = experiment_of(translator, root.scope)
    structural = translator.structural
    marked = tuple([replace(v, structural=True) if v.name in structural else v for v in variables])
    return FlatModel(
        name=root.scope.path,
        description=root.description,
        variables=marked,
        equations=tuple(work.equations),
        initial_equations=tuple(work.initial),
        assertions=tuple(work.assertions),
        experiment=experiment,
        span=root.scope.span,
        warnings=tuple(translator.warnings),
    )


def experiment_of(translator: Translator, scope: Scope) -> Experiment:
    """The `experiment` annotation of the class, or of the nearest base that has one."""
    annotation = annotation_of(scope)
    for argument in annotation.arguments if annotation is not None else ():
        if isinstance(argument, ast.ElementModification) and argument.name == ("experiment",):
            return _experiment(translator, scope, argument)
    return Experiment()


def annotation_of(scope: Scope) -> ast.Annotation | None:
    """The annotation of a class as written."""
    definition = scope.definition
    if isinstance(definition, ast.LongClass):
        return definition.body.annotation
    return definition.comment.annotation


def _experiment(translator: Translator, scope: Scope, argument: ast.ElementModification) -> Experiment:
    values: dict[str, float] = {}
    modification = argument.modification
    for item in () if modification is None else modification.arguments:
        if not isinstance(item, ast.ElementModification) or item.modification is None:
            continue
        expression = item.modification.value
        if item.name[0] not in ("StartTime", "StopTime", "Tolerance", "Interval") or expression is None:
            continue
        assert not isinstance(expression, ast.Break)
        number = translator.evaluate(expression, Context(scope, None), f"`{item.name[0]}` of the experiment")
        if isinstance(number, (int, float)):
            values[item.name[0]] = float(number)
    return Experiment(values.get("StartTime"), values.get("StopTime"), values.get("Tolerance"), values.get("Interval"))


