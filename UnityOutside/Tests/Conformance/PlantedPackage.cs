namespace UnityOutside.Tests.Conformance;

/// <summary>An assembly FastPoints.Planted whose IL names whatever a test wants of an assembly Unity.Things, and a list of what
/// Unity.Things really has.</summary>
internal sealed class PlantedPackage : IDisposable
{
    private const string List = """
        T:Unity.Things.Box`1	Unity.Things	struct		unmanaged		T:unmanaged		*
        F:Unity.Things.Box`1.Limit	Unity.Things	field	System.Int32	static,readonly				*
        F:Unity.Things.Box`1.Value	Unity.Things	field	`0					*
        M:Unity.Things.Box`1.#ctor(System.Int32)	Unity.Things	ctor			length			*
        M:Unity.Things.Box`1.Get(System.Int32)	Unity.Things	method	`0		index			*
        M:Unity.Things.Box`1.New	Unity.Things	method	System.Void					6000.5
        M:Unity.Things.Box`1.Old	Unity.Things	method	System.Void				warn@6000.3,error@6000.5	*
        M:Unity.Things.Box`1.Make(System.Int32)	Unity.Things	method	Unity.Things.Box{`0}	static	length			*
        M:Unity.Things.Box`1.Try(`0@)	Unity.Things	method	System.Boolean		out value			*
        P:Unity.Things.Box`1.Length	Unity.Things	property	System.Int32	get				*
        P:Unity.Things.Box`1.Item(System.Int32)	Unity.Things	indexer	`0	get,set,ref-return	index			*
        T:Unity.Things.IRun	Unity.Things	interface						*
        M:Unity.Things.IRun.Run(System.Int32)	Unity.Things	method	System.Void		index			*
        T:Unity.Things.Runner	Unity.Things	class		abstract				*
        M:Unity.Things.Runner.#ctor	Unity.Things	ctor		protected				*
        M:Unity.Things.Runner.Start	Unity.Things	method	System.Void	abstract,protected				*
        M:Unity.Things.Runner.Stop	Unity.Things	method	System.Void					*
        T:Unity.Things.Extensions	Unity.Things	class		static				*
        M:Unity.Things.Extensions.Schedule``1(``0)	Unity.Things	method	System.Void	static,extension	this job	T:struct&Unity.Things.IRun		*
        T:Unity.Things.MarkAttribute	Unity.Things	class	System.Attribute					*
        M:Unity.Things.MarkAttribute.#ctor	Unity.Things	ctor		implicit				*
        P:Unity.Things.MarkAttribute.Level	Unity.Things	property	System.Int32	get,set				*
        T:UnityEditor.Tool	UnityEditor:Core	class		static				*
        T:Unity.Other.Late	Unity.Other	struct		unmanaged				*
        """;

    private readonly AssemblyDefinition m_assembly;
    private readonly MethodDefinition m_method;
    private readonly OneAssembly m_resolver = new OneAssembly();

    internal PlantedPackage()
    {
        m_assembly = AssemblyDefinition.CreateAssembly(new AssemblyNameDefinition("FastPoints.Planted", new Version(1, 0)),
            "FastPoints.Planted", new ModuleParameters { Kind = ModuleKind.Dll, AssemblyResolver = m_resolver });
        Module = m_assembly.MainModule;
        Things = new AssemblyNameReference("Unity.Things", new Version(1, 0));
        Module.AssemblyReferences.Add(Things);
        User = new TypeDefinition("FastPoints.Planted", "User", TypeAttributes.Public, Module.TypeSystem.Object);
        m_method = new MethodDefinition("Use", MethodAttributes.Public | MethodAttributes.Static, Module.TypeSystem.Void);
        User.Methods.Add(m_method);
        Module.Types.Add(User);
    }

    internal ModuleDefinition Module { get; }
    internal AssemblyNameReference Things { get; }
    internal TypeDefinition User { get; }

    public void Dispose() => m_assembly.Dispose();

    internal TypeReference Type(string name, bool isValue, int arity = 0)
    {
        var type = new TypeReference("Unity.Things", name, Module, Things) { IsValueType = isValue };
        for (int i = 0; i < arity; i++)
            type.GenericParameters.Add(new GenericParameter(type));
        return type;
    }

    internal GenericInstanceType Box(TypeReference argument)
    {
        var box = new GenericInstanceType(Type("Box`1", true, 1));
        box.GenericArguments.Add(argument);
        return box;
    }

    internal MethodReference Method(TypeReference type, string name, TypeReference returns, bool isStatic,
        params TypeReference[] parameters)
    {
        var method = new MethodReference(name, returns, type) { HasThis = !isStatic };
        foreach (TypeReference parameter in parameters)
            method.Parameters.Add(new ParameterDefinition(parameter));
        return method;
    }

    internal void Emit(OpCode code, MethodReference method) => m_method.Body.GetILProcessor().Emit(code, method);
    internal void Emit(OpCode code, FieldReference field) => m_method.Body.GetILProcessor().Emit(code, field);

    internal TypeDefinition Add(string name, bool isValue, TypeReference baseType = null, TypeReference implements = null)
    {
        TypeReference parent = baseType ?? (isValue
            ? new TypeReference("System", "ValueType", Module, Module.TypeSystem.CoreLibrary)
            : Module.TypeSystem.Object);
        var type = new TypeDefinition("FastPoints.Planted", name, TypeAttributes.Public | TypeAttributes.Sealed, parent);
        if (implements != null)
            type.Interfaces.Add(new InterfaceImplementation(implements));
        Module.Types.Add(type);
        return type;
    }

    internal static MethodDefinition Define(TypeDefinition type, string name, MethodAttributes attributes,
        params TypeReference[] parameters)
    {
        var method = new MethodDefinition(name, MethodAttributes.Public | attributes, type.Module.TypeSystem.Void);
        foreach (TypeReference parameter in parameters)
            method.Parameters.Add(new ParameterDefinition(parameter));
        type.Methods.Add(method);
        return method;
    }

    internal void ProvideStandIn(Action<ModuleDefinition> fill)
    {
        m_resolver.Assembly = AssemblyDefinition.CreateAssembly(new AssemblyNameDefinition("Unity.Things", new Version(1, 0)),
            "Unity.Things", ModuleKind.Dll);
        fill(m_resolver.Assembly.MainModule);
    }

    internal IReadOnlyCollection<string> Check(string generation = "6000.0", string reference = "Unity.Things")
    {
        UnityApi api = UnityApi.Read("the list", new StringReader(List));
        var assemblies =
            new AssemblyTable(new[] { new Asmdef("FastPoints.Planted", "", new[] { reference, "Unity.Other" }, false) });
        return new Api.Conformance(api, generation, assemblies).Check(Module);
    }

    private sealed class OneAssembly : IAssemblyResolver
    {
        internal AssemblyDefinition Assembly { get; set; }

        public AssemblyDefinition Resolve(AssemblyNameReference name) =>
            name.Name == "Unity.Things" && Assembly != null ? Assembly : throw new AssemblyResolutionException(name);

        public AssemblyDefinition Resolve(AssemblyNameReference name, ReaderParameters parameters) => Resolve(name);
        public void Dispose() => Assembly?.Dispose();
    }
}
