"""The scalars of the instance tree as variables of the flat model."""

from __future__ import annotations

from acausal.errors import AcausalError, Span, TypeProblem
from acausal.lang.arithmetic import as_scalar, as_value, type_error
from acausal.lang.flat import Causality, Equation, Origin, ScalarType, StateSelect, Variability, Variable
from acausal.lang.instance import Array, Connection, Instance, Leaf, Member, Outer
from acausal.lang.light import light_object
from acausal.lang.modifiers import Binding
from acausal.lang.naming import with_names
from acausal.lang.translation import Translation
from acausal.lang.values import assignable, describe
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import EnumValue, Expr

_ATTRIBUTE_TYPE = {
    "unit": "String",
    "displayUnit": "String",
    "quantity": "String",
    "fixed": "Boolean",
    "unbounded": "Boolean",
    "stateSelect": "StateSelect",
    "nominal": "Real",
}


@light_object
class _Attributes:
    """Translated attributes, shared by all variables that have the same."""

    start: Expr | None
    fixed: bool | None
    nominal: Expr | None
    min: Expr | None
    max: Expr | None
    unit: str
    display_unit: str
    quantity: str
    state_select: StateSelect


class Variables:
    """Makes the variables; `bindings` are the equations that declarations of variables come to."""

    def __init__(self, translation: Translation) -> None:
        self._translation = translation
        self._attributes: dict[tuple[int, str], _Attributes] = {}
        self.bindings: list[Equation] = []
        self.inputs: list[str] = []
        """Inputs of components without a value of their own."""

    def of(self, root: Instance) -> list[Variable]:
        """All scalars in order of declaration, depth first."""
        found: list[Variable] = []
        stack: list[tuple[Member | Outer, bool]] = [(m, True) for m in reversed(root.members.values())]
        while stack:
            member, top = stack.pop()
            if isinstance(member, Leaf):
                self._translation.note(member)
                if member.type.external:
                    self._translation.externals.object(member)
                    continue
                found.append(self._variable(member, top))
            elif isinstance(member, Array):
                stack.extend([(item, top) for item in reversed(member.items)])
            elif isinstance(member, Instance):
                own = top and member.is_connector
                stack.extend([(part, own) for part in reversed(member.members.values())])
            elif isinstance(member, Outer) and member.own is not None:
                stack.append((member.own, top))
        return found

    def _variable(self, leaf: Leaf, top: bool) -> Variable:
        try:
            return self._translated_variable(leaf, top)
        except TypeProblem as problem:
            raise with_names(problem, (leaf.path,)) from None

    def _translated_variable(self, leaf: Leaf, top: bool) -> Variable:
        prefixes = leaf.prefixes
        binding = None if leaf.binding is None else self._binding(leaf, leaf.binding)
        causality = prefixes.causality if top else Causality.LOCAL
        if prefixes.causality is Causality.INPUT and binding is None and not top:
            self.inputs.append(leaf.path)
        if binding is None:
            if prefixes.variability is Variability.CONSTANT:
                raise _constant_without_value(leaf)
        elif prefixes.variability > Variability.PARAMETER and leaf.binding is not None:
            component = leaf.path.rpartition(".")[0]
            span = leaf.binding.span
            self.bindings.append(Equation(ex.sym(leaf.path), binding, span, component, Origin.BINDING))
            binding = None
            if causality is Causality.INPUT:
                causality = Causality.LOCAL
        attributes = self._attributes_of(leaf)
        return Variable(
            leaf.path,
            leaf.type,
            prefixes.variability,
            leaf.span,
            Causality.LOCAL if prefixes.protected else causality,
            binding,
            attributes.start,
            attributes.fixed,
            attributes.nominal,
            attributes.min,
            attributes.max,
            attributes.unit,
            attributes.display_unit,
            attributes.quantity,
            attributes.state_select,
            prefixes.connection is Connection.FLOW,
            prefixes.protected,
            prefixes.final,
            prefixes.evaluate
            and prefixes.variability is Variability.PARAMETER
            and attributes.fixed is not False,
            top,
            leaf.description,
            _modification(leaf, leaf.attributes.get("fixed") or leaf.attributes.get("start")),
            _modification(leaf, leaf.binding),
        )

    def _binding(self, leaf: Leaf, binding: Binding) -> Expr:
        value = as_value(self._translation.binding_value(binding), binding.span)
        if value.shape:
            message = f"`{leaf.path}` is a scalar, but its value is {describe(value)}"
            raise type_error("type.array-size", message, binding.span, "", (leaf.path,))
        if not assignable(value.type, leaf.type):
            message = f"`{leaf.path}` is {leaf.type}, but its value is {describe(value)}"
            raise type_error("type.mismatch", message, binding.span, "", (leaf.path,))
        return value.item

    # ------------------------------------------------------------------ attributes

    def _attributes_of(self, leaf: Leaf) -> _Attributes:
        key = (id(leaf.attributes), leaf.type.name)
        found = self._attributes.get(key)
        if found is None:
            found = self._attributes[key] = self._translated(leaf)
        return found

    def _translated(self, leaf: Leaf) -> _Attributes:
        items = {name: self._attribute(leaf, name, binding) for name, binding in leaf.attributes.items()}
        fixed = self._constant(leaf, "fixed", items)
        select = self._constant(leaf, "stateSelect", items)
        return _Attributes(
            items.get("start"),
            None if fixed is None else bool(fixed),
            items.get("nominal"),
            items.get("min"),
            items.get("max"),
            str(self._constant(leaf, "unit", items) or ""),
            str(self._constant(leaf, "displayUnit", items) or ""),
            str(self._constant(leaf, "quantity", items) or ""),
            StateSelect(select.index) if isinstance(select, EnumValue) else StateSelect.DEFAULT,
        )

    def _attribute(self, leaf: Leaf, name: str, binding: Binding) -> Expr:
        value = as_scalar(self._translation.binding_value(binding), binding.span)
        wanted = _ATTRIBUTE_TYPE.get(name, leaf.type.name)
        if not _fits(value.type, wanted):
            message = (
                f"the attribute `{name}` of `{leaf.path}` is {wanted}, but its value is {describe(value)}"
            )
            raise type_error("type.mismatch", message, binding.span, "", (leaf.path,))
        return value.item

    def _constant(self, leaf: Leaf, name: str, items: dict[str, Expr]) -> object:
        item = items.get(name)
        if item is None:
            return None
        span = leaf.attributes[name].span
        return self._translation.evaluate_expr(item, span, f"the attribute `{name}` of `{leaf.path}`")


def _modification(leaf: Leaf, given: Binding | None) -> Span | None:
    """Where a value comes from, if it is not in the variable's own declaration."""
    if given is None:
        return None
    own, span = leaf.span, given.span
    within = span.source is own.source and own.start <= span.start and span.end <= own.end
    return None if within else span


def _fits(found: ScalarType, wanted: str) -> bool:
    return found.name == wanted or (wanted == "Real" and found.name == "Integer")


def _constant_without_value(leaf: Leaf) -> AcausalError:
    return type_error(
        "constant.no-value",
        f"the constant `{leaf.path}` has no value",
        leaf.span,
        f"give it one: `constant {leaf.type} {leaf.path.rpartition('.')[2]} = ...`",
        (leaf.path,),
    )
