namespace UnityOutside.Threads;

/// <summary>Goes back from where a value is used to where it was made: through variables, fields, parameters (to all callers) and
/// results (to all that may be called). Where the way is lost, in a collection or in other people's code, the type of the
/// variable is all that is known.</summary>
internal sealed class ValueOrigins(CodeIndex code)
{
    private const string OuterThis = "<>4__this";

    private readonly CodeIndex m_code = code;
    private readonly Dictionary<(Instruction, int, string?), IReadOnlyCollection<Value>> m_known =
        new Dictionary<(Instruction, int, string?), IReadOnlyCollection<Value>>();

    private readonly Dictionary<(Instruction, string?), IReadOnlyList<Value>> m_sub =
        new Dictionary<(Instruction, string?), IReadOnlyList<Value>>();

    /// <summary>What may be an argument of a call; 0 is the object, where it has one.</summary>
    internal IReadOnlyCollection<Value> Argument(MethodDefinition method, Value? self, Instruction call, int index)
    {
        if (m_known.TryGetValue((call, index, self?.Key), out IReadOnlyCollection<Value>? known))
            return known;
        var search = new Search(this);
        search.All(method, self, m_code.Flow(method).Argument(call, index));
        m_known.Add((call, index, self?.Key), search.Found);
        return search.Found;
    }

    internal IEnumerable<(MethodDefinition Method, TypeReference Type)> Targets(MethodReference called, Value receiver,
        GenericScope scope)
    {
        if (receiver.IsExact)
        {
            return Implementation(receiver.Type, called, scope) is { } one ? new[] { one }
                : Array.Empty<(MethodDefinition, TypeReference)>();
        }
        TypeReference declaring = scope.Of(called).Concrete(TypeRelations.Self(Resolution.Of(called.DeclaringType)!));
        return m_code.Types.Where(t => !t.IsInterface && !t.IsAbstract).Select(TypeRelations.Self)
            .Where(t => TypeRelations.IsAssignable(t, declaring) && TypeRelations.IsAssignable(t, receiver.Type))
            .Select(t => Implementation(t, called, scope)).Where(t => t != null).Select(t => t!.Value).Distinct();
    }

    internal static (MethodDefinition Method, TypeReference Type)? Implementation(TypeReference type, MethodReference called,
        GenericScope scope)
    {
        for (TypeReference? at = type; at != null; at = TypeRelations.Base(at))
        {
            if (Implementations.Find(at, called, scope) is { } method)
                return (method, at);
        }
        return null;
    }

    private sealed class Search(ValueOrigins origins, Search? outer = null, Instruction? at = null)
    {
        private readonly ValueOrigins m_origins = origins;
        private readonly Search? m_outer = outer;
        private readonly Instruction? m_for = at;
        private readonly HashSet<(Instruction, string?)> m_seen = new HashSet<(Instruction, string?)>();
        private readonly HashSet<string> m_keys = new HashSet<string>();

        internal List<Value> Found { get; } = new List<Value>();
        private CodeIndex Il => m_origins.m_code;

        internal void All(MethodDefinition method, Value? self, IEnumerable<Instruction> producers)
        {
            foreach (Instruction producer in producers.Where(p => m_seen.Add((p, self?.Key))))
                Trace(method, self, producer);
        }

        private void Trace(MethodDefinition method, Value? self, Instruction at)
        {
            switch (at.OpCode.Code)
            {
                case Code.Newobj:
                    New(method, self, at, (MethodReference)at.Operand);
                    break;
                case Code.Box:
                    Add(new Value((TypeReference)at.Operand, method, ((TypeReference)at.Operand).IsValueType));
                    break;
                case Code.Ldnull:
                    break;
                case Code.Ldfld or Code.Ldsfld:
                    Field(method, self, at, (FieldReference)at.Operand);
                    break;
                case Code.Call or Code.Callvirt:
                    Result(method, self, at, (MethodReference)at.Operand);
                    break;
                case Code.Castclass or Code.Isinst:
                    Cast(method, self, at, (TypeReference)at.Operand);
                    break;
                default:
                    if (MethodVariables.Local(method, at) is { } variable)
                        Local(method, self, variable);
                    else if (MethodVariables.Parameter(method, at) is { } index)
                        Parameter(method, self, index);
                    else
                        Any(at.Operand as TypeReference ?? method.Module.TypeSystem.Object, method);
                    break;
            }
        }

        private IReadOnlyList<Value>? Sub(MethodDefinition method, Value? self, Instruction at,
            IEnumerable<Instruction> producers)
        {
            if (m_origins.m_sub.TryGetValue((at, self?.Key), out IReadOnlyList<Value>? known))
                return known;
            for (Search? search = this; search != null; search = search.m_outer)
            {
                if (search.m_for == at)
                    return null;
            }
            var sub = new Search(m_origins, this, at);
            sub.All(method, self, producers);
            m_origins.m_sub.Add((at, self?.Key), sub.Found);
            return sub.Found;
        }

        private void New(MethodDefinition method, Value? self, Instruction at, MethodReference constructor)
        {
            TypeReference type = constructor.DeclaringType;
            if (!TypeRelations.IsDelegate(type))
            {
                Add(Value.Made(type, method, self));
                return;
            }
            StackFlow flow = Il.Flow(method);
            var address = flow.Producers(at, 0).FirstOrDefault()?.Operand as MethodReference;
            IReadOnlyList<Value>? bound = Sub(method, self, at, flow.Producers(at, 1));
            if (bound == null || bound.Count == 0 || bound.Any(v => !v.IsExact))
                Add(new Value(type, method, true, address));
            foreach (Value each in bound?.Where(v => v.IsExact) ?? Array.Empty<Value>())
                Add(new Value(type, method, true, address, each));
        }

        private void Field(MethodDefinition method, Value? self, Instruction at, FieldReference field)
        {
            if (field.Name == OuterThis && self is { IsOfMethod: true, Inner: { } outer })
            {
                Add(outer);
                return;
            }
            FieldDefinition? definition = Resolution.Of(field);
            IReadOnlyList<Site> writes = definition == null ? Array.Empty<Site>() : Il.Writes(definition);
            foreach (Site write in writes)
                All(write.Method, null, Il.Flow(write.Method).Producers(write.At, 0));
            if (writes.Count == 0 || Il.IsLent(definition!))
                Any(GenericScope.OfMember(field.DeclaringType, Array.Empty<TypeReference>()).Concrete(field.FieldType), method);
        }

        private void Result(MethodDefinition method, Value? self, Instruction at, MethodReference called)
        {
            MethodDefinition? definition = Resolution.Of(called);
            bool isWhole = false;
            if (definition is { HasThis: true })
            {
                IReadOnlyList<Value> receivers = Sub(method, self, at, Il.Flow(method).Argument(at, 0)) ?? Array.Empty<Value>();
                bool isVirtual = at.OpCode.Code == Code.Callvirt && definition.IsVirtual;
                isWhole = receivers.Count > 0;
                foreach (Value receiver in receivers)
                {
                    List<MethodDefinition> targets = isVirtual
                        ? m_origins.Targets(called, receiver, GenericScope.None).Select(t => t.Method).ToList()
                        : new List<MethodDefinition> { definition };
                    isWhole &= (receiver.IsExact || Il.IsInside(definition)) && targets.Count > 0;
                    foreach (MethodDefinition target in targets)
                        isWhole &= Returned(target, receiver.IsExact ? receiver : null);
                }
            }
            else if (definition != null)
                isWhole = Returned(definition, null);
            if (!isWhole)
                Any(GenericScope.None.Of(called).Concrete(called.ReturnType), method);
        }

        private bool Returned(MethodDefinition target, Value? self)
        {
            if (!target.HasBody || !Il.IsInside(target))
                return false;
            foreach (Instruction end in target.Body.Instructions.Where(i => i.OpCode.Code == Code.Ret))
                All(target, self, Il.Flow(target).Producers(end, 0));
            return true;
        }

        private void Cast(MethodDefinition method, Value? self, Instruction at, TypeReference type)
        {
            IReadOnlyList<Value>? inner = Sub(method, self, at, Il.Flow(method).Producers(at, 0));
            if (inner == null)
            {
                Any(type, method);
                return;
            }
            foreach (Value value in inner.Where(v => v.IsExact && TypeRelations.IsAssignable(v.Type, type)))
                Add(value);
            foreach (Value value in inner.Where(v => !v.IsExact))
            {
                // A type parameter says more than what it is tried for.
                bool isNarrower = value.Type is GenericParameter || TypeRelations.IsAssignable(value.Type, type);
                Add(isNarrower ? value : new Value(type, method, false));
            }
        }

        private void Local(MethodDefinition method, Value? self, VariableDefinition variable)
        {
            List<Instruction> writes = MethodVariables.Writes(method, variable).ToList();
            foreach (Instruction write in writes)
                All(method, self, Il.Flow(method).Producers(write, 0));
            if (writes.Count == 0 || MethodVariables.IsLent(method, variable))
                Any(variable.VariableType, method);
        }

        private void Parameter(MethodDefinition method, Value? self, int index)
        {
            if (method.HasThis && index == 0)
            {
                Add(self ?? new Value(TypeRelations.Self(method.DeclaringType), method, false));
                return;
            }
            IReadOnlyList<Site> calls = Il.Calls(method, out bool isComplete);
            foreach (Site call in calls)
            {
                // A constructor is given its object, too, but not by newobj.
                bool skipsObject = method.HasThis && call.At.OpCode.Code == Code.Newobj;
                All(call.Method, null, Il.Flow(call.Method).Argument(call.At, skipsObject ? index - 1 : index));
            }
            if (calls.Count == 0 || !isComplete)
                Any(method.Parameters[method.HasThis ? index - 1 : index].ParameterType, method);
        }

        private void Any(TypeReference type, MethodDefinition place) => Add(new Value(type, place, false));

        private void Add(Value value)
        {
            if (m_keys.Add(value.Key))
                Found.Add(value);
        }
    }
}
