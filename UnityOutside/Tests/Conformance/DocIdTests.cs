namespace UnityOutside.Tests.Conformance;

public sealed class DocIdTests
{
#pragma warning disable CA1822, CA1823, CA1801, CS0067, CS0169, CS0649
    internal unsafe class Sample<T> where T : unmanaged
    {
        public int[,] Grid;

        public event Action Changed;

        public T this[int index, T* at]
        {
            get => default;
            set { }
        }

        public static implicit operator int(Sample<T> sample) => 0;
        public static Sample<T> operator +(Sample<T> a, in int b) => a;

        public ref readonly T Take<U>(ref T[] a, out U* b, in Dictionary<T, List<U>>.Enumerator c) where U : unmanaged
        {
            b = null;
            return ref a[0];
        }

        public struct Nested<V>
        {
            public Nested<string> Other(Sample<int>.Nested<V>[] all) => default;
        }
    }
#pragma warning restore

    private const string Prefix = "UnityOutside.Tests.Conformance.DocIdTests.Sample`1";
    private ModuleDefinition m_module;
    private TypeDefinition m_sample;

    [OneTimeSetUp]
    public void ReadOwnIl()
    {
        m_module = ModuleDefinition.ReadModule(typeof(DocIdTests).Assembly.Location);
        m_sample = m_module.GetTypes().Single(t => t.Name == "Sample`1");
    }

    [OneTimeTearDown]
    public void Close() => m_module.Dispose();

    [Test]
    public void OfType_NestedGeneric_HasTheArityOfEachLevel() =>
        Assert.That(DocId.OfType(m_sample.NestedTypes.Single(t => t.Name == "Nested`1")), Is.EqualTo($"T:{Prefix}.Nested`1"));

    [Test]
    public void OfMethod_RefsPointersArraysAndNestedGenerics_MatchTheList() => Assert.That(
        DocId.OfMethod(Method("Take")),
        Is.EqualTo($"M:{Prefix}.Take``1(`0[]@,``0*@," +
            $"System.Collections.Generic.Dictionary{{`0,System.Collections.Generic.List{{``0}}}}.Enumerator@)"));

    [Test]
    public void InSignature_RefReadonlyReturn_IsByReferenceOfTheParameter() =>
        Assert.That(DocId.InSignature(Method("Take").ReturnType), Is.EqualTo("`0@"));

    [Test]
    public void OfMethod_Conversion_NamesItsReturn() => Assert.That(
        DocId.OfMethod(Method("op_Implicit")),
        Is.EqualTo($"M:{Prefix}.op_Implicit({Prefix[..^2]}{{`0}})~System.Int32"));

    [Test]
    public void OfMethod_Operator_IsAMethod() => Assert.That(
        DocId.OfMethod(Method("op_Addition")), Is.EqualTo($"M:{Prefix}.op_Addition({Prefix[..^2]}{{`0}},System.Int32@)"));

    [Test]
    public void OfMethod_Constructor_HasAHash() => Assert.That(DocId.OfMethod(Method(".ctor")), Is.EqualTo($"M:{Prefix}.#ctor"));

    [TestCase("get_Item", "P:OWNER.Item(System.Int32,`0*)")]
    [TestCase("set_Item", "P:OWNER.Item(System.Int32,`0*)")]
    [TestCase("add_Changed", "E:OWNER.Changed")]
    public void OfAccessor_PropertyOrEvent_IsIts(string method, string id) =>
        Assert.That(DocId.OfAccessor(Prefix, Method(method)), Is.EqualTo(id.Replace("OWNER", Prefix)));

    [Test]
    public void OfAccessor_OtherMethod_IsNull() => Assert.That(DocId.OfAccessor(Prefix, Method("op_Addition")), Is.Null);

    [Test]
    public void InSignature_MultiDimensionalArray_HasItsBounds() => Assert.That(
        DocId.InSignature(m_sample.Fields.Single(f => f.Name == "Grid").FieldType), Is.EqualTo("System.Int32[0:,0:]"));

    [Test]
    public void InSignature_NestedInstance_GivesEachLevelItsArguments()
    {
        MethodDefinition method = m_sample.NestedTypes.Single(t => t.Name == "Nested`1").Methods.Single(m => m.Name == "Other");

        Assert.That(DocId.InSignature(method.Parameters[0].ParameterType),
            Is.EqualTo($"{Prefix[..^2]}{{System.Int32}}.Nested{{`1}}[]"));
        Assert.That(DocId.InSignature(method.ReturnType), Is.EqualTo($"{Prefix[..^2]}{{`0}}.Nested{{System.String}}"));
    }

    [TestCase("M:A.B`1.C.D``1(X.Y{`0}.Z,System.Int32)", "A.B`1.C")]
    [TestCase("P:A.B.Item(System.Int32)", "A.B")]
    [TestCase("M:A.B.op_Implicit(A.C)~A.D", "A.B")]
    [TestCase("F:A.B.C", "A.B")]
    public void DeclaringTypeOf_MemberId_IsThePartBeforeTheName(string id, string type) =>
        Assert.That(DocId.DeclaringTypeOf(id), Is.EqualTo(type));

    [Test]
    public void Substitute_TypeAndMethodParameters_TakeTheirArguments() => Assert.That(
        DocId.Substitute("A{`1,``0}[]`0", new[] { "X", "Y" }, new[] { "Z" }), Is.EqualTo("A{Y,Z}[]X"));

    private MethodDefinition Method(string name) => m_sample.Methods.Single(m => m.Name == name);
}
