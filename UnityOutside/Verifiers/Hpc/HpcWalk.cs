namespace UnityOutside.Hpc;

internal sealed record HpcVisit(MethodDefinition Method, GenericScope Scope, string Path, bool IsStaticConstructor);

/// <summary>One method of a walk, for one instance of generic code: what Burst would reject in it.</summary>
internal sealed class HpcWalk
{
    private readonly HpcVerifier m_verifier;
    private readonly HpcVisit m_visit;
    private readonly MethodDefinition m_method;
    private readonly GenericScope m_scope;
    private readonly HashSet<Instruction> m_throwing;

    internal HpcWalk(HpcVerifier verifier, HpcVisit visit)
    {
        m_verifier = verifier;
        m_visit = visit;
        m_method = visit.Method;
        m_scope = visit.Scope;
        m_throwing = visit.Method.HasBody ? ThrowingCode.Of(visit.Method.Body) : new HashSet<Instruction>();
    }

    internal void Run()
    {
        if (!m_method.HasBody)
        {
            Add(null, "has no IL to compile");
            return;
        }
        if (m_method.HasThis && !m_method.DeclaringType.IsValueType)
            Add(null, $"is a method of the class {m_method.DeclaringType.Name}");
        foreach (ParameterDefinition parameter in m_method.Parameters)
        {
            TypeReference type = m_scope.Concrete(parameter.ParameterType);
            if ((HpcTypes.Objection(type) ?? HpcSignature.Marshalling(parameter, type)) is { } objection)
                Add(null, $"parameter {parameter.Name} is {objection}");
        }
        TypeReference returned = m_scope.Concrete(m_method.ReturnType);
        if ((HpcTypes.Objection(returned) ?? HpcSignature.Marshalling(m_method.MethodReturnType, returned)) is { } inReturn)
            Add(null, $"its return value is {inReturn}");
        foreach (ExceptionHandler handler in m_method.Body.ExceptionHandlers)
        {
            if (handler.HandlerType != ExceptionHandlerType.Finally)
                Add(handler.HandlerStart, "catches an exception");
        }
        foreach ((Instruction at, string reason) in IntrinsicCode.Objections(m_method.Body))
            Add(at, reason);
        foreach (Instruction instruction in m_method.Body.Instructions)
        {
            if (m_throwing.Contains(instruction))
                CheckThrowing(instruction);
            else
                Check(instruction);
        }
    }

    private void CheckThrowing(Instruction instruction)
    {
        switch (instruction.OpCode.Code)
        {
            case Code.Newobj when HpcTypes.IsException(((MethodReference)instruction.Operand).DeclaringType):
            case Code.Call or Code.Callvirt
                when ((MethodReference)instruction.Operand).DeclaringType.FullName == "System.String":
            case Code.Ldstr or Code.Box or Code.Newarr or Code.Stelem_Ref or Code.Throw:
            case Code.Ldloc or Code.Ldloc_S or Code.Ldloc_0 or Code.Ldloc_1 or Code.Ldloc_2 or Code.Ldloc_3:
            case Code.Stloc or Code.Stloc_S or Code.Stloc_0 or Code.Stloc_1 or Code.Stloc_2 or Code.Stloc_3:
                return;
            default:
                Check(instruction);
                return;
        }
    }

    private void Check(Instruction instruction)
    {
        switch (instruction.OpCode.Code)
        {
            case Code.Ldstr:
                if (NextCall(instruction) is not { } taker || !HpcBoundary.TakesLiterals(taker))
                    Add(instruction, "uses a string");
                break;
            case Code.Newarr:
                if (!m_visit.IsStaticConstructor)
                    Add(instruction, "makes a managed array");
                break;
            case Code.Box:
                TypeReference boxed = m_scope.Concrete((TypeReference)instruction.Operand);
                if (!boxed.IsValueType || !IsComparedWithNull(instruction))
                    Add(instruction, $"boxes {boxed.FullName}");
                break;
            case Code.Unbox or Code.Unbox_Any or Code.Isinst or Code.Castclass:
                Add(instruction, $"casts ({instruction.OpCode.Name})");
                break;
            case Code.Ldftn or Code.Ldvirtftn:
                Add(instruction, "makes a delegate or takes a method's address");
                break;
            case Code.Mkrefany or Code.Refanyval or Code.Refanytype or Code.Arglist:
                Add(instruction, $"uses {instruction.OpCode.Name}");
                break;
            case Code.Ldtoken:
                CheckToken(instruction);
                break;
            case Code.Sizeof:
                if (HpcLayout.OfAll(m_scope.Concrete((TypeReference)instruction.Operand)) is { } inLayout)
                    Add(instruction, $"takes the size of {inLayout}");
                break;
            case Code.Calli:
                if (((CallSite)instruction.Operand).CallingConvention != MethodCallingConvention.C)
                    Add(instruction, "calls a function pointer that is not unmanaged, Cdecl");
                break;
            case Code.Ldelem_Ref:
                if (!m_visit.IsStaticConstructor && !IsConstant(instruction.Previous))
                    Add(instruction, "reads a table of a table by an index that is not constant");
                break;
            case Code.Stelem_Any or Code.Stelem_I or Code.Stelem_I1 or Code.Stelem_I2 or Code.Stelem_I4 or Code.Stelem_I8
                or Code.Stelem_R4 or Code.Stelem_R8 or Code.Stelem_Ref:
                if (!m_visit.IsStaticConstructor)
                    Add(instruction, "writes to a managed array");
                break;
            case Code.Ldsfld or Code.Ldsflda or Code.Stsfld:
                CheckStatic(instruction, (FieldReference)instruction.Operand);
                break;
            case Code.Ldfld or Code.Ldflda or Code.Stfld:
                CheckField(instruction, (FieldReference)instruction.Operand);
                break;
            case Code.Ldloc or Code.Ldloc_S or Code.Ldloca or Code.Ldloca_S or Code.Stloc or Code.Stloc_S
                or Code.Ldloc_0 or Code.Ldloc_1 or Code.Ldloc_2 or Code.Ldloc_3
                or Code.Stloc_0 or Code.Stloc_1 or Code.Stloc_2 or Code.Stloc_3:
                CheckLocal(instruction);
                break;
            case Code.Newobj:
                CheckNew(instruction, (MethodReference)instruction.Operand);
                break;
            case Code.Call or Code.Callvirt:
                CheckCall(instruction, (MethodReference)instruction.Operand);
                break;
        }
    }

    /// <summary>typeof only to name a SharedStatic; to compare with another only since 1.8.26.</summary>
    private void CheckToken(Instruction instruction)
    {
        if (m_visit.IsStaticConstructor)
            return;
        MethodReference? user = null;
        for (Instruction? at = instruction.Next; at != null && user == null; at = at.Next)
        {
            if (at.OpCode.Code == Code.Ldtoken)
                continue;
            if (at.Operand is not MethodReference method)
                break;
            if (method.Name != "GetTypeFromHandle")
                user = method;
        }
        if (user == null || !user.DeclaringType.FullName.StartsWith("Unity.Burst.", StringComparison.Ordinal))
            Add(instruction, "uses typeof");
    }

    private void CheckStatic(Instruction instruction, FieldReference field)
    {
        string name = $"{field.DeclaringType.Name}.{field.Name}";
        FieldDefinition? definition = field.Resolve();
        bool isOurs = definition != null && m_verifier.IsWalked(definition.Module);
        if (instruction.OpCode.Code == Code.Stsfld)
        {
            if (!m_visit.IsStaticConstructor)
                Add(instruction, $"writes the static {name}");
            return;
        }
        if (definition != null && !definition.IsInitOnly)
        {
            Add(instruction, $"reads the static {name}, which is not readonly");
            return;
        }
        TypeReference type = m_scope.Concrete(field.FieldType);
        if (!HpcTypes.IsTable(type) && HpcTypes.Objection(type) is { } objection)
            Add(instruction, $"reads the static {name}, {objection}");
        MethodDefinition? constructor = definition?.DeclaringType.Methods.FirstOrDefault(m => m.Name == ".cctor");
        if (isOurs && constructor != null && !m_visit.IsStaticConstructor)
            m_verifier.Enqueue(constructor, m_scope, m_visit.Path, true);
    }

    private void CheckField(Instruction instruction, FieldReference field)
    {
        if (!field.DeclaringType.IsValueType)
            Add(instruction, $"uses {field.Name} of the class {field.DeclaringType.FullName}");
        else if (HpcTypes.Objection(m_scope.Concrete(field.FieldType)) is { } objection)
            Add(instruction, $"uses the field {field.Name}, {objection}");
    }

    private void CheckLocal(Instruction instruction)
    {
        VariableDefinition? variable = instruction.Operand as VariableDefinition ?? Short(instruction.OpCode.Code);
        if (variable == null)
            return;
        // One of a class can only be null: whatever would make, load or return another is reported where it does.
        TypeReference type = m_scope.Concrete(variable.VariableType);
        bool isObject = !type.IsValueType && type is not (ByReferenceType or PointerType);
        if (!isObject && HpcTypes.Objection(type) is { } objection)
            Add(instruction, $"has a variable that is {objection}");
    }

    private VariableDefinition? Short(Code code)
    {
        int index = code is >= Code.Ldloc_0 and <= Code.Ldloc_3 ? code - Code.Ldloc_0
            : code is >= Code.Stloc_0 and <= Code.Stloc_3 ? code - Code.Stloc_0 : -1;
        return index < 0 ? null : m_method.Body.Variables[index];
    }

    private void CheckNew(Instruction instruction, MethodReference constructor)
    {
        TypeReference type = m_scope.Concrete(constructor.DeclaringType);
        if (!type.IsValueType)
            Add(instruction, $"makes a {type.FullName}");
        else
            Follow(instruction, constructor);
    }

    private void CheckCall(Instruction instruction, MethodReference called)
    {
        if (called.Name == "InitializeArray" && m_visit.IsStaticConstructor)
            return;
        // What typeof comes to is said where its token is.
        if (called.DeclaringType.FullName == "System.Type"
            && (called.Name == "GetTypeFromHandle" || called.Name.StartsWith("op_", StringComparison.Ordinal)))
            return;
        if (called.DeclaringType.FullName == "Unity.Burst.CompilerServices.Loop")
        {
            CheckLoop(instruction, called);
            return;
        }
        if (called is GenericInstanceMethod { DeclaringType.FullName: "System.Activator", Name: "CreateInstance" } ofGeneric)
        {
            // What the compiler makes of new T().
            TypeReference made = m_scope.Concrete(ofGeneric.GenericArguments[0]);
            if (!made.IsValueType)
                Add(instruction, $"makes a {made.FullName}");
            return;
        }
        if (instruction.Previous?.OpCode.Code == Code.Constrained)
        {
            CheckConstrained(instruction, called, m_scope.Concrete((TypeReference)instruction.Previous.Operand));
            return;
        }
        if (instruction.OpCode.Code == Code.Callvirt && !called.DeclaringType.IsValueType)
        {
            Add(instruction, $"calls {called.DeclaringType.Name}.{called.Name} through an object");
            return;
        }
        Follow(instruction, called);
    }

    /// <summary>Burst holds loops to what these calls say of them; they are nothing by themselves.</summary>
    private void CheckLoop(Instruction instruction, MethodReference called)
    {
        if (!LoopCode.Has(instruction))
            Add(instruction, $"calls Loop.{called.Name} outside of a loop");
        else if (called.Name == "ExpectVectorized" && m_method.NoOptimization)
            Add(instruction, $"expects vectors of {m_method.Name}, which is not optimised");
    }

    private void CheckConstrained(Instruction instruction, MethodReference called, TypeReference type)
    {
        if (type is GenericParameter)
            return;
        if (!type.IsValueType)
        {
            Add(instruction, $"calls {called.Name} of the class {type.FullName}");
            return;
        }
        TypeDefinition? definition = Resolution.Of(type);
        if (definition == null || type.IsPrimitive)
            return;
        MethodDefinition? target = Implementations.Find(type, called, m_scope);
        if (target == null)
        {
            Add(instruction, $"boxes {type.FullName} to call {called.Name}");
            return;
        }
        if (!m_verifier.IsWalked(definition.Module))
            return;
        TypeReference[] ofMethod = called is GenericInstanceMethod generic
            ? generic.GenericArguments.Select(m_scope.Concrete).ToArray()
            : Array.Empty<TypeReference>();
        m_verifier.Enqueue(target, GenericScope.OfMember(type, ofMethod), m_visit.Path, false);
    }

    private void Follow(Instruction instruction, MethodReference called)
    {
        MethodDefinition? definition = Resolution.Of(called);
        if (definition != null && HpcEntries.IsDiscarded(definition))
        {
            if (definition.ReturnType.MetadataType != MetadataType.Void)
                Add(instruction, $"uses the value of {called.DeclaringType.Name}.{called.Name}, which is [BurstDiscard]");
            return;
        }
        CheckArguments(instruction, called);
        if (definition is { IsPInvokeImpl: true } && m_verifier.IsWalked(definition.Module))
        {
            string name = $"{called.DeclaringType.Name}.{called.Name}";
            if (m_visit.IsStaticConstructor)
                Add(instruction, $"calls the extern {name} in a static constructor");
            if (HpcSignature.OfExtern(definition) is { } inExtern)
                Add(instruction, $"calls {name} with {inExtern}");
            return;
        }
        if (definition != null && m_verifier.IsWalked(definition.Module))
            m_verifier.Enqueue(definition, m_scope.Of(called), m_visit.Path, false);
        else if (HpcBoundary.Objection(called, m_scope.Of(called)) is { } objection)
            Add(instruction, objection);
    }

    /// <summary>Types may only name something there (a size, a key), so no more is asked of them than a layout.</summary>
    private void CheckArguments(Instruction instruction, MethodReference called)
    {
        if (called is not GenericInstanceMethod generic)
            return;
        foreach (TypeReference argument in generic.GenericArguments)
        {
            if (HpcLayout.OfAll(m_scope.Concrete(argument)) is { } objection)
                Add(instruction, $"calls {called.Name} for {objection}");
        }
    }

    /// <summary>"default(T) is null", which Burst settles itself.</summary>
    private static bool IsComparedWithNull(Instruction box) => box.Next?.OpCode.Code switch
    {
        Code.Brtrue or Code.Brtrue_S or Code.Brfalse or Code.Brfalse_S => true,
        Code.Ldnull => box.Next.Next?.OpCode.Code is Code.Ceq or Code.Cgt_Un,
        _ => false,
    };

    private static bool IsConstant(Instruction? instruction) => instruction?.OpCode.Code is >= Code.Ldc_I4_M1 and <= Code.Ldc_I4;

    private static MethodReference? NextCall(Instruction instruction)
    {
        for (Instruction? at = instruction.Next; at != null; at = at.Next)
        {
            if (at.OpCode.Code is Code.Call or Code.Callvirt or Code.Newobj)
                return (MethodReference)at.Operand;
            if (at.OpCode.FlowControl is not FlowControl.Next)
                return null;
        }
        return null;
    }

    private void Add(Instruction? at, string reason)
    {
        string place = at == null ? "" : CodeLocation.Of(m_method, at);
        m_verifier.Report(m_visit.Path + (place.Length == 0 ? "" : $" ({place})") + $": {reason}");
    }
}
