namespace FastPoints.HostTests.StandIns;

public sealed class SerializationTests
{
    static readonly Assembly[] s_assemblies =
    {
        typeof(PointCloud).Assembly, typeof(PointCloudResources).Assembly, typeof(CloudImporter).Assembly,
        Assembly.Load("FastPoints.Samples"), Assembly.Load("FastPoints.Samples.Editor"),
    };

    static IEnumerable<Type> Kept() => s_assemblies.SelectMany(a => a.GetTypes()).Where(t => t.IsSubclassOf(typeof(Object)));

    [TestCaseSource(nameof(Kept))]
    public void Fields_Serialized_HaveTypesThatUnitySerializes(Type type) => Assert.That(
        SerializedFields.Of(type).Where(f => !SerializedFields.IsKept(f.FieldType)).Select(f => f.Name), Is.Empty);

    /// <summary>Unity knows the script of a component or an asset by its file, which has the class's name.</summary>
    [TestCaseSource(nameof(Kept))]
    public void Script_OfAClass_IsInAFileOfItsName(Type type)
    {
        string name = type.Name.Split('`')[0];
        var files = Directory.GetFiles(Checkout.Repository.PackageRoot, name + ".cs", SearchOption.AllDirectories);
        Assert.That(files.Select(File.ReadAllText), Has.Some.Matches("class " + name + @"\b"));
    }

    [TestCase(typeof(int[]), true)]
    [TestCase(typeof(List<string>), true)]
    [TestCase(typeof(double3), true)]
    [TestCase(typeof(GameObject), true)]
    [TestCase(typeof(Vector3), true)]
    [TestCase(typeof(int[][]), false)]
    [TestCase(typeof(int[,]), false)]
    [TestCase(typeof(Dictionary<string, int>), false)]
    [TestCase(typeof(int?), false)]
    [TestCase(typeof(decimal), false)]
    [TestCase(typeof(Large), false)]
    [TestCase(typeof(Unmarked), false)]
    public void IsSerialized_FieldType_FollowsUnitysManual(Type type, bool isKept) =>
        Assert.That(SerializedFields.IsKept(type), Is.EqualTo(isKept));

    [Test]
    public void Of_Fields_AreThePublicOnesAndThoseThatSaySo() =>
        Assert.That(SerializedFields.Of(typeof(Fields)).Select(f => f.Name), Is.EqualTo(new[] { "Public", "m_marked" }));

    enum Large : long { One }

    struct Unmarked
    {
        public int Value { get; set; }
    }

    sealed class Fields : ScriptableObject
    {
        public int Public;
        public readonly int Fixed = 1;
        public static int Shared;
        [SerializeField] int m_marked;
        [NonSerialized] public int Left;
        int m_private;

        public int Property { get; set; }

        public int Set() => Public = m_marked = m_private = Left = Shared = Fixed;
    }
}
