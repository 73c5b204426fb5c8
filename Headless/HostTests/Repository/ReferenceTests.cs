using FastPoints.HostTests.Repository.PlantedApi;

namespace FastPoints.HostTests.Repository;

public sealed class ReferenceTests
{
    const string Page = "Words.\n<!-- RepoTools reference writes what follows -->\nold\n<!-- and this is its end -->\nMore.\n";
    const string Sum = "static int Sum(in Record a, out List<int?> b, ref byte c, params string[] d)";

    static readonly Lazy<ModuleDefinition> s_module = new(() => ModuleDefinition.ReadModule(typeof(Opened).Assembly.Location));

    [TestCase(typeof(Opened), "", "new Opened(string path, long limitBytes = 3)", "static Opened Open(string path)")]
    [TestCase(typeof(Record), "", Sum, "int X")]
    [TestCase(typeof(Record), "Record Y", "double[] Y", Sum)]
    [TestCase(typeof(Record), "Other Y", Sum, "int X")]
    [TestCase(typeof(Many), "", "A", "B", "C", "D", "E", "...")]
    [TestCase(typeof(Generic<>), "", "abstract T[] Take<TOther>(Dictionary<TOther, Record> other, bool isWhole = true)")]
    public void Beginning_PlantedType_ShowsItsSourceThenUsedMembers(Type type, string example, params string[] members)
    {
        var names = ReferenceBlock.NamesInExamples("```csharp\n" + example + "\n```\n");

        Assert.That(Beginning.Of(Definition(type), names), Is.EqualTo(members));
    }

    [Test]
    public void Summary_OfPlantedSource_IsItsFirstSentence()
    {
        var summaries = new Summaries();
        summaries.Add(File.ReadAllText(Path.Combine(Checkout.Repository.Headless, "HostTests/Repository/PlantedApi.cs")));

        Assert.That(summaries.Of(Definition(typeof(Opened))), Is.EqualTo("Says `what` it is, of a `Record` \\| more"));
        Assert.That(summaries.Of(Definition(typeof(Record))), Is.Null);
    }

    [Test]
    public void PublicTypes_OfThisAssembly_AreSortedAndNotNested() => Assert.That(
        ReferenceCommand.PublicTypes(s_module.Value).FindAll(t => t.Namespace == typeof(Opened).Namespace)
            .ConvertAll(Signature.Name), Is.EqualTo(new[] { "Generic<T>", "Many", "Opened", "Record" }));

    [Test]
    public void Block_OfAPage_IsReplacedAndRemoved()
    {
        Assert.That(ReferenceBlock.Replace(Page, "new\n"), Is.EqualTo(Page.Replace("old", "new")));
        Assert.That(ReferenceBlock.Remove(Page), Is.EqualTo(Page.Replace("old\n", "")));
        Assert.That(ReferenceBlock.Remove("Words."), Is.EqualTo("Words."));
        Assert.That(() => ReferenceBlock.Replace("Words.", "new\n"), Throws.TypeOf<ToolException>());
    }

    static TypeDefinition Definition(Type type) => s_module.Value.GetType(type.FullName);
}
