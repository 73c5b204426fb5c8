namespace UnityOutside.Threads;

/// <summary>Walks the IL that is reachable from whatever begins on a thread that need not be the main one (<see
/// cref="ThreadRoots"/>) and says where it uses a member of Unity that the table does not have for any thread, or takes
/// Allocator.Temp outside of jobs. Unity throws there; .NET runs it all. Calls through interfaces, base types and delegates are
/// followed to all that may be there (<see cref="ValueOrigins"/>).</summary>
public sealed class ThreadVerifier
{
    private sealed record Visit(MethodDefinition Method, GenericScope Scope, Value? Self, IReadOnlyList<string> Path,
        Instruction? From);

    private readonly CodeIndex m_code;
    private readonly ValueOrigins m_origins;
    private readonly ThreadTable m_table;
    private readonly string m_generation;
    private readonly NestedWork m_nested;
    private readonly SortedSet<string> m_problems = new SortedSet<string>(StringComparer.Ordinal);
    private readonly HashSet<string> m_seen = new HashSet<string>();
    private readonly Queue<Visit> m_visits = new Queue<Visit>();

    /// <param name="modules">What is walked; whatever else is called is looked up in the table, or .NET's.</param>
    public ThreadVerifier(IEnumerable<ModuleDefinition> modules, ThreadTable table, string generation, NestedWork nested)
    {
        m_code = new CodeIndex(modules);
        m_origins = new ValueOrigins(m_code);
        m_table = table;
        m_generation = generation;
        m_nested = nested;
    }

    public int WalkedCount { get; private set; }

    /// <summary>Where other threads begin, in words.</summary>
    public IEnumerable<string> Roots => ThreadRoots.Of(m_code, m_origins).Select(r => r.Name);

    public IReadOnlyCollection<string> Verify(Func<TypeDefinition, bool> isAsked)
    {
        m_problems.Clear();
        WalkedCount = 0;
        foreach (ThreadRoot root in ThreadRoots.Of(m_code, m_origins).Where(r => isAsked(r.Within)).ToList())
            Walk(root);
        return m_problems.ToList();
    }

    private void Walk(ThreadRoot root)
    {
        m_seen.Clear();
        if (root.Method == null)
        {
            m_problems.Add($"{root.Name}: what it runs is not to be seen");
            return;
        }
        var start = new Walker(this, root, null);
        if (root.From == null)
            start.Run(root.Method, GenericScope.None, root.Self);
        else
            start.Follow(root.Method, GenericScope.None, root.Self, root.From);
        while (m_visits.TryDequeue(out Visit? visit))
        {
            WalkedCount++;
            new Walker(this, root, visit).Run();
        }
    }

    private sealed class Walker(ThreadVerifier verifier, ThreadRoot root, Visit? visit)
    {
        private readonly ThreadVerifier m_verifier = verifier;
        private readonly ThreadRoot m_root = root;
        private readonly Visit? m_visit = visit;
        private Instruction? m_at;

        private MethodDefinition Method => m_visit!.Method;
        private GenericScope Scope => m_visit!.Scope;

        internal void Run()
        {
            foreach (Instruction at in m_visit!.From == null ? Method.Body.Instructions : ReachableFrom(m_visit.From))
            {
                m_at = at;
                switch (at.OpCode.Code)
                {
                    case Code.Call or Code.Callvirt or Code.Newobj:
                        Call(at, (MethodReference)at.Operand);
                        break;
                    case Code.Ldsfld or Code.Ldsflda or Code.Stsfld:
                        StaticField((FieldReference)at.Operand);
                        break;
                }
            }
        }

        /// <summary>A method that a delegate or Unity calls: a virtual one is whatever the object has.</summary>
        internal void Run(MethodReference target, GenericScope scope, Value? self)
        {
            MethodDefinition? definition = Resolution.Of(target);
            bool isVirtual = definition is { IsVirtual: true, IsFinal: false };
            if (isVirtual)
                Dispatch(target, self ?? new Value(TypeRelations.Self(definition!.DeclaringType), definition, false), scope);
            if (!isVirtual || !m_verifier.m_code.IsInside(definition!))
                Follow(target, scope, self);
        }

        /// <summary>A method that is called for sure: it is walked, or looked up if it is Unity's.</summary>
        internal void Follow(MethodReference called, GenericScope scope, Value? self, Instruction? from = null)
        {
            MethodDefinition? definition = Resolution.Of(called);
            if (definition == null || !m_verifier.m_code.IsInside(definition))
            {
                LookUp(called.DeclaringType, called);
                return;
            }
            if (definition.HasBody)
                Enqueue(definition, scope.Of(called), self, from);
            if (definition.IsStatic || definition.IsConstructor)
                Initialize(definition.DeclaringType, scope.Of(called), false);
        }

        private IEnumerable<Instruction> ReachableFrom(Instruction start)
        {
            var reached = new HashSet<Instruction> { start };
            var open = new Stack<Instruction>(reached);
            while (open.TryPop(out Instruction? at))
            {
                IEnumerable<Instruction> handlers = Method.Body.ExceptionHandlers
                    .Where(h => h.TryStart.Offset <= at.Offset && at.Offset < h.TryEnd.Offset).Select(h => h.HandlerStart);
                foreach (Instruction next in StackFlow.Next(at).Concat(handlers).Where(reached.Add))
                    open.Push(next);
            }
            return reached;
        }

        private void Call(Instruction at, MethodReference called)
        {
            if (!m_root.IsJob && TempMemory.IsTaken(m_verifier.m_code, Method, at))
                Add("takes Allocator.Temp outside of jobs");
            if (at.Previous?.OpCode.Code == Code.Constrained)
            {
                Constrained(called, Scope.Concrete((TypeReference)at.Previous.Operand));
                return;
            }
            if (TypeRelations.IsDelegate(called.DeclaringType))
            {
                if (called.Name == "Invoke")
                    Invoke(at, 0, called.DeclaringType);
                return;
            }
            MethodDefinition? definition = Resolution.Of(called);
            bool isInside = definition != null && m_verifier.m_code.IsInside(definition);
            bool isVirtual = at.OpCode.Code == Code.Callvirt && definition is { IsVirtual: true, IsFinal: false };
            if (m_verifier.m_nested.IsDone(Method, called))
            {
                Give(Argument(at, StackFlow.ArgumentCount(at) - called.Parameters.Count),
                    Resolution.Of(called.Parameters[0].ParameterType)!);
            }
            if (isVirtual && !m_verifier.m_nested.IsStepped(Method, called))
            {
                foreach (Value receiver in Argument(at, 0))
                    Dispatch(called, receiver, Scope);
            }
            if (!isInside)
                Follow(called, Scope, null);
            else if (!isVirtual)
                FollowOn(at, called);
            if (!isInside)
                HandOver(at, called);
        }

        private IReadOnlyCollection<Value> Argument(Instruction at, int index) =>
            m_verifier.m_origins.Argument(Method, m_visit!.Self, at, index);

        private void FollowOn(Instruction at, MethodReference called)
        {
            IReadOnlyCollection<Value> objects = at.OpCode.Code == Code.Newobj
                ? new[] { Value.Made(Scope.Concrete(called.DeclaringType), Method, m_visit!.Self) }
                : called.HasThis ? Argument(at, 0) : Array.Empty<Value>();
            if (objects.Count == 0 || objects.Any(o => !o.IsExact))
                Follow(called, Scope, null);
            foreach (Value self in objects.Where(o => o.IsExact))
                Follow(called, Scope, self);
        }

        private void Constrained(MethodReference called, TypeReference type)
        {
            if (type is GenericParameter || !type.IsValueType)
            {
                Dispatch(called, new Value(type, Method, false), Scope);
                return;
            }
            if (ValueOrigins.Implementation(type, called, Scope) is not { } found)
                return;
            if (m_verifier.m_code.IsInside(found.Method))
                Enqueue(found.Method, GenericScope.OfMember(found.Type, ArgumentsOf(called, Scope)), null, null);
            else
                LookUp(found.Type, called);
        }

        private void Dispatch(MethodReference called, Value receiver, GenericScope scope)
        {
            if (m_visit != null && receiver.Place == Method)
                receiver = receiver with { Type = scope.Concrete(receiver.Type) };
            IEnumerable<Value> receivers = receiver.Type is GenericParameter parameter
                ? m_verifier.m_code.Instances(parameter).Select(t => receiver with { Type = t })
                : new[] { receiver };
            foreach ((MethodDefinition method, TypeReference type) in receivers
                .SelectMany(r => m_verifier.m_origins.Targets(called, r, scope)))
            {
                if (m_verifier.m_code.IsInside(method) && method.HasBody)
                {
                    Enqueue(method, GenericScope.OfMember(type, ArgumentsOf(called, scope)),
                        receiver.IsExact ? receiver : null, null);
                }
            }
        }

        private void Invoke(Instruction at, int argument, TypeReference type)
        {
            foreach (Value made in ThreadRoots.Delegates(m_verifier.m_code, m_verifier.m_origins, new Site(Method, at),
                m_visit!.Self, argument, type))
                Run(made.Target!, made.Place == Method ? Scope : GenericScope.None, made.Inner);
        }

        private void HandOver(Instruction at, MethodReference called)
        {
            if (ThreadStarts.StateMachine(called) is { } machine)
                Begin(Scope.Concrete(machine));
            if (called is GenericInstanceMethod generic)
                TypeArguments(generic);
            if (Origins.IsUnity(Origins.AssemblyOf(called.DeclaringType)) || ThreadStarts.IsStart(called)
                || called.DeclaringType.FullName == "System.Threading.SynchronizationContext")
                return;
            int first = StackFlow.ArgumentCount(at) - called.Parameters.Count;
            for (int i = 0; i < called.Parameters.Count; i++)
            {
                TypeReference type = called.Parameters[i].ParameterType;
                if (TypeRelations.IsDelegate(type))
                    Invoke(at, first + i, type);
                else if (Resolution.Of(type) is { IsValueType: false, IsSealed: false } wanted &&
                    type is not (GenericParameter or ArrayType))
                    Give(Argument(at, first + i), wanted);
            }
        }

        private void Begin(TypeReference machine)
        {
            if (Resolution.Of(machine)?.Methods.FirstOrDefault(m => m.Name == "MoveNext") is { } method)
            {
                Enqueue(method, GenericScope.OfMember(machine, Array.Empty<TypeReference>()),
                    Value.Made(machine, Method, m_visit!.Self), null);
            }
        }

        private void Give(IEnumerable<Value> values, TypeDefinition wanted)
        {
            foreach (Value value in values.Where(v => Resolution.Of(v.Type) is { } type && m_verifier.m_code.IsInside(type)))
            {
                foreach (MethodDefinition slot in TypeRelations.AllOf(TypeRelations.Self(wanted)).Select(Resolution.Of)
                    .SelectMany(t => t!.Methods.Where(m => m.IsVirtual && m.Name != "Finalize")))
                    Dispatch(slot, value, Scope);
            }
        }

        private void TypeArguments(GenericInstanceMethod called)
        {
            MethodDefinition? definition = Resolution.Of(called);
            for (int i = 0; definition != null && i < called.GenericArguments.Count; i++)
            {
                TypeReference argument = Scope.Concrete(called.GenericArguments[i]);
                TypeDefinition? type = Resolution.Of(argument);
                if (type == null || !m_verifier.m_code.IsInside(type)
                    || (HpcEntries.IsJob(type) && !called.Name.StartsWith("Run", StringComparison.Ordinal)))
                    continue;
                foreach (MethodDefinition slot in definition.GenericParameters[i].Constraints
                    .Select(c => Resolution.Of(c.ConstraintType)).Where(c => c is { IsInterface: true })
                    .SelectMany(c => c!.Methods))
                    Constrained(slot, argument);
            }
        }

        private void StaticField(FieldReference field)
        {
            FieldDefinition? definition = Resolution.Of(field);
            if (definition != null && m_verifier.m_code.IsInside(definition))
            {
                Initialize(definition.DeclaringType, GenericScope.OfMember(Scope.Concrete(field.DeclaringType),
                    Array.Empty<TypeReference>()), true);
                return;
            }
            if (!Origins.IsUnity(Origins.AssemblyOf(field.DeclaringType)))
                return;
            if (!m_root.IsJob && DocId.OfField(field) == "F:Unity.Collections.AllocatorManager.Temp")
                Add("takes Allocator.Temp outside of jobs");
            Judge(DocId.OfField(field), m_verifier.m_table.Find(field), "");
        }

        private void Initialize(TypeDefinition type, GenericScope scope, bool isField)
        {
            MethodDefinition? constructor = type.Methods.FirstOrDefault(m => m.Name == ".cctor");
            if (constructor != null && (isField || !type.IsBeforeFieldInit))
                Enqueue(constructor, scope, null, null);
        }

        private void LookUp(TypeReference type, MethodReference called)
        {
            bool isBase = m_visit is { Method: { IsConstructor: true } } && called.Name == ".ctor" &&
                m_at?.OpCode.Code == Code.Call;
            if (!Origins.IsUnity(Origins.AssemblyOf(type)) || TypeRelations.IsDelegate(type) || isBase)
                return;
            int underscore = called.Name.IndexOf('_');
            Judge($"{DocId.DefinitionName(type)}.{called.Name}", m_verifier.m_table.Find(type, called),
                underscore < 0 ? "" : called.Name[..underscore]);
        }

        private void Judge(string shown, ThreadRow? row, string accessor)
        {
            if (row == null)
            {
                Add($"uses {shown}, which the table of threads does not have");
                return;
            }
            string threads = row.In(m_verifier.m_generation, accessor);
            string users = threads == "main" ? "the main thread" : "nobody knows which threads";
            if (threads != "any")
                Add($"uses {shown}, which is for {users} ({row.Reason})");
            else if (row.IsAskedForMain)
                Add($"uses {shown}, for which the manual asks for the main thread");
        }

        private static TypeReference[] ArgumentsOf(MethodReference called, GenericScope scope) =>
            called is GenericInstanceMethod generic
                ? generic.GenericArguments.Select(scope.Concrete).ToArray()
                : Array.Empty<TypeReference>();

        private void Enqueue(MethodDefinition method, GenericScope scope, Value? self, Instruction? from)
        {
            if (!m_verifier.m_seen.Add($"{method.FullName}|{scope.Key}|{self?.Key}"))
                return;
            IReadOnlyList<string> path = m_visit?.Path ?? Array.Empty<string>();
            m_verifier.m_visits.Enqueue(new Visit(method, scope, self, path.Append(MethodNames.Of(method)).ToList(), from));
        }

        private void Add(string what)
        {
            IReadOnlyList<string> path = m_visit?.Path ?? Array.Empty<string>();
            IEnumerable<string> steps = path.Count <= MaxSteps ? path
                : path.Take(2).Append("...").Concat(path.Skip(path.Count - MaxSteps + 2));
            string place = m_at == null ? "" : $" ({CodeLocation.Of(Method, m_at)})";
            m_verifier.m_problems.Add($"{m_root.Name}: {string.Join(" > ", steps)}{place}: {what}");
        }

        private const int MaxSteps = 8;
    }
}
